# SPDX-License-Identifier: BSD-3-Clause
"""Finds files that came with the program by their names: "moore-hills" is a ledger."""

from __future__ import annotations

import os
import pathlib


def file_or_shipped(given: str | os.PathLike[str], folder: str) -> str:
    """Returns the path; for a bare name that is not a file here, the shipped file of that name."""
    name = os.fspath(given)
    if not name or "." in name or "/" in name or os.path.exists(name):
        return name
    for parent in pathlib.Path(__file__).resolve().parents:
        file = parent / "share" / "edgeproof" / folder / f"{name}.toml"
        if file.exists():
            return str(file)
    return name
