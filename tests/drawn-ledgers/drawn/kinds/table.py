# SPDX-License-Identifier: GPL-3.0-or-later
"""All kinds of claims that are drawn."""
import importlib
import pathlib

KINDS = {}
for _file in sorted(pathlib.Path(__file__).parent.glob("*.py")):
    if _file.stem not in ("__init__", "table"):
        KINDS.update(importlib.import_module(f"{__package__}.{_file.stem}").KINDS)
