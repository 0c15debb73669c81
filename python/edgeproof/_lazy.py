# SPDX-License-Identifier: BSD-3-Clause
"""Imports packages when they are first needed."""

from __future__ import annotations

import importlib
import sys
from typing import Any


def imported(name: str) -> Any:
    """Returns a module, imported as `python -P` does: a prompt's "" in sys.path is left out.

    The current folder may have changed since the program began, to one with files of others.
    """
    if name in sys.modules:
        return importlib.import_module(name)
    path = sys.path[:]
    sys.path[:] = [folder for folder in path if folder]
    try:
        return importlib.import_module(name)
    finally:
        sys.path[:] = path
