# SPDX-License-Identifier: BSD-3-Clause
"""Scenes with very many digits, and relations, computed in a process of their own.

A single operation on numbers of many thousand digits (such as a hypergeometric function) may take
minutes, and so may the expansion of one formula. The libraries do not check for an interruption
meanwhile. A process can be ended at any time: so Ctrl-C ends the computation at once, and nothing
continues in the background.
"""

from __future__ import annotations

import contextlib
import os
import pickle
import subprocess
import sys
import threading
from collections.abc import Callable
from typing import Any

from ._edgeproof import NativeScene, relations
from .errors import Error

# Up to this number of digits, no single operation was seen to take a second.
MOST_DIGITS_HERE = 5000
# The same for curved slopes, which are integrated: the nodes of a rule are made in one operation.
MOST_DIGITS_HERE_INTEGRATED = 600

# Started with -I, so that no file of the current folder is run; the package is named by its place.
_CHILD = """
import sys
from importlib import util
spec = util.spec_from_file_location("edgeproof", sys.argv[1])
package = sys.modules["edgeproof"] = util.module_from_spec(spec)
spec.loader.exec_module(package)
sys.modules["edgeproof._apart"].serve()
"""
_PACKAGE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "__init__.py")


def can_start() -> bool:
    """True if this program is a Python that can be started again, not a program that embeds one."""
    return os.path.basename(sys.executable or "").startswith("python")


def _end(child: subprocess.Popen[bytes]) -> None:
    child.kill()
    # Closing fails if the child did not read all input; that is not an error.
    with contextlib.suppress(OSError):
        if child.stdin is not None:
            child.stdin.close()


def _values(text: str, file: str, asked: Any) -> str:
    return NativeScene.from_text(text, file).run(asked)


_WORK: dict[str, Callable[..., Any]] = {"values": _values, "relations": relations}


def run(work: str, *arguments: Any) -> Any:
    """Returns _WORK[work](*arguments). An exception that ends the wait ends the child, too."""
    # In a session of its own: a terminal sends Ctrl-C only to this process, which may continue.
    with subprocess.Popen([sys.executable, "-I", "-c", _CHILD, _PACKAGE],
                          stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                          start_new_session=True) as child:
        assert child.stdin is not None and child.stdout is not None
        try:
            pickle.dump((work, arguments), child.stdin)
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
    return found


def _end_with_the_parent() -> None:
    sys.stdin.buffer.read(1)
    os._exit(1)


def serve() -> None:
    """The child's work: reads the questions, writes the values or the error."""
    work, arguments = pickle.load(sys.stdin.buffer)
    threading.Thread(target=_end_with_the_parent, daemon=True).start()
    found: Any
    try:
        found = _WORK[work](*arguments)
    except Exception as error:
        found = error
    pickle.dump(found, sys.stdout.buffer)
    sys.stdout.buffer.flush()
    os._exit(0)  # the thread above holds the input
