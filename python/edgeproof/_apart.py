# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes with very many digits, computed in a process of their own.

A single operation on numbers of many thousand digits (such as a hypergeometric function) may take
minutes, and the libraries do not check for an interruption meanwhile. A process can be ended at
any time: so Ctrl-C ends the computation at once, and nothing continues in the background.
"""

from __future__ import annotations

import contextlib
import os
import pickle
import subprocess
import sys
import threading
from typing import Any

from ._edgeproof import NativeScene
from .errors import Error

# Up to this number of digits, no single operation was seen to take a second.
MOST_DIGITS_HERE = 5000
# The same for curved slopes, which are integrated: the nodes of a rule are made in one operation.
MOST_DIGITS_HERE_INTEGRATED = 600

_CHILD = """
import pickle, sys
sys.path[:] = pickle.load(sys.stdin.buffer)
from edgeproof import _apart
_apart.serve()
"""


def can_start() -> bool:
    """True if this program is a Python that can be started again, not a program that embeds one."""
    return os.path.basename(sys.executable or "").startswith("python")


def _end(child: subprocess.Popen[bytes]) -> None:
    child.kill()
    # Closing fails if the child did not read all input; that is not an error.
    with contextlib.suppress(OSError):
        if child.stdin is not None:
            child.stdin.close()


def run(text: str, file: str, asked: dict[str, Any]) -> dict[str, Any]:
    """NativeScene(text, file).run(**asked). An exception that ends the wait ends the child, too."""
    # In a session of its own: a terminal sends Ctrl-C only to this process, which may continue.
    with subprocess.Popen([sys.executable, "-c", _CHILD], stdin=subprocess.PIPE,
                          stdout=subprocess.PIPE, start_new_session=True) as child:
        assert child.stdin is not None and child.stdout is not None
        try:
            pickle.dump(sys.path, child.stdin)
            pickle.dump((text, file, asked), child.stdin)
            child.stdin.flush()  # left open: if this process ends, the child reads the end
            found = pickle.load(child.stdout)
        except (EOFError, BrokenPipeError):
            _end(child)
            raise Error(f"the process that computed it ended with status {child.wait()}",
                        "it may have been out of memory; ask for fewer digits") from None
        except BaseException:
            _end(child)
            raise
    if isinstance(found, Exception):
        raise found
    assert isinstance(found, dict)
    return found


def _end_with_the_parent() -> None:
    sys.stdin.buffer.read(1)
    os._exit(1)


def serve() -> None:
    """The child's work: reads the questions, writes the values or the error."""
    text, file, asked = pickle.load(sys.stdin.buffer)
    threading.Thread(target=_end_with_the_parent, daemon=True).start()
    found: Any
    try:
        found = NativeScene(text, file).run(**asked)
    except Exception as error:
        found = error
    pickle.dump(found, sys.stdout.buffer)
    sys.stdout.buffer.flush()
    os._exit(0)  # the thread above holds the input
