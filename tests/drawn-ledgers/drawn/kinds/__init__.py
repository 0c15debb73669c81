# SPDX-License-Identifier: BSD-3-Clause
"""One module for each group of kinds of claim. KINDS: the functions that draw one claim, of all modules."""
import importlib
import pathlib

KINDS = {}
for _file in sorted(pathlib.Path(__file__).parent.glob("*.py")):
    if _file.stem != "__init__":
        KINDS.update(importlib.import_module(f"{__name__}.{_file.stem}").KINDS)
