# SPDX-License-Identifier: BSD-3-Clause
"""Explains why the compiled module cannot be imported. Python 3.6 and later can read this file."""

import glob
import os
import sys

BUILD = "run scripts/build release edgeproof_python_package, or pip install ."


def explanation(error):
    # type: (ImportError) -> str
    """Returns one line: what is wrong; what to run."""
    folder = os.path.dirname(os.path.abspath(__file__))
    here = "%d.%d" % sys.version_info[:2]
    found = sorted(os.path.basename(file) for file in glob.glob(
        os.path.join(folder, "_edgeproof.*.so")))
    versions = []
    for name in found:
        number = name.split("cpython-")[-1].split("-")[0]  # "311"
        if number[:1] == "3" and number[1:].isdigit():
            versions.append("3." + number[1:])
    if not found:
        if sys.version_info < (3, 11):
            return ("the compiled module of edgeproof is not built, and this is Python %s; use "
                    "Python 3.11 or later, and %s" % (here, BUILD))
        return "the compiled module of edgeproof is not built; " + BUILD
    if here not in versions:
        return ("the compiled module of edgeproof is for Python %s, and this is Python %s (%s); run "
                "python%s (Debian's is /usr/bin/python3), or build it for this Python: %s -m pip "
                "install ." % (" and ".join(versions), here, sys.executable, versions[0] if versions
                               else "3", sys.executable))
    return "the compiled module of edgeproof cannot be loaded: %s; %s" % (error, BUILD)
