# SPDX-License-Identifier: BSD-3-Clause
"""Programs that are started, and that end with this one."""
import signal
import subprocess
import sys


def run(command, **options):
    """A program that ends when this one is stopped by SIGTERM, together with all processes that it has started."""
    before = signal.signal(signal.SIGTERM, lambda *_: sys.exit(128 + signal.SIGTERM))
    try:
        with subprocess.Popen(command, **options) as child:
            try:
                output, errors = child.communicate()
            except BaseException:
                child.terminate()
                raise
    finally:
        signal.signal(signal.SIGTERM, before)
    return subprocess.CompletedProcess(command, child.returncode, output, errors)
