# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes with very many digits, and relations, found in a process of their own.

A single operation on numbers of many thousand digits (a hypergeometric function, say) may take
minutes, and so may one expansion of a formula. No library that does it looks up meanwhile. A process
can be ended at any time: so Ctrl-C ends it at once, and nothing goes on computing unseen.
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

# Below, no single operation was seen to take as long as a second.
MOST_DIGITS_HERE = 5000
# The same of curved slopes, which are integrated: the nodes of a rule are made in one operation.
MOST_DIGITS_HERE_INTEGRATED = 600

_CHILD = """
import pickle, sys
sys.path[:] = pickle.load(sys.stdin.buffer)
from edgeproof import _apart
_apart.serve()
"""


def can_start() -> bool:
    """Whether this program is a Python that can be started again (it may be embedded in another)."""
    return os.path.basename(sys.executable or "").startswith("python")


def _end(child: subprocess.Popen[bytes]) -> None:
    child.kill()
    # What it did not read any more is no error of its own.
    with contextlib.suppress(OSError):
        if child.stdin is not None:
            child.stdin.close()


def _values(text: str, file: str, asked: dict[str, Any]) -> dict[str, Any]:
    return NativeScene(text, file).run(**asked)


_WORK: dict[str, Callable[..., Any]] = {"values": _values, "relations": relations}


def run(work: str, *arguments: Any) -> Any:
    """What _WORK[work](*arguments) returns. What ends the wait ends the work."""
    # Not in our session: a terminal sends its Ctrl-C to us alone, who may want to go on.
    with subprocess.Popen([sys.executable, "-c", _CHILD], stdin=subprocess.PIPE,
                          stdout=subprocess.PIPE, start_new_session=True) as child:
        assert child.stdin is not None and child.stdout is not None
        try:
            pickle.dump(sys.path, child.stdin)
            pickle.dump((work, arguments), child.stdin)
            child.stdin.flush()  # and left open: where we end, it reads the end
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
    """The child: reads what is asked, writes the values or the error."""
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
