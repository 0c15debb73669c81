# SPDX-License-Identifier: BSD-3-Clause
"""Results as columns of numbers, for data frames."""

from __future__ import annotations

import math
from collections.abc import Iterable
from fractions import Fraction
from typing import Any

from ._edgeproof import Value, given
from ._lazy import imported
from .errors import UndecidedError

# Fields whose texts are exact numbers.
_NUMBERS = ("u", "x", "z")


def _rounded_up(q: Fraction) -> float:
    nearest = float(q)
    return nearest if Fraction(nearest) >= q else math.nextafter(nearest, math.inf)


def _number(value: Value) -> tuple[float, float]:
    """Returns a binary64 near the exact value, the nearest where that is decided, and its error."""
    low, high = value.interval()
    try:
        number = float(value)
    except UndecidedError:
        number = float((low + high) / 2)
    if not math.isfinite(number):
        return number, math.inf
    exactly = Fraction(number)
    return number, _rounded_up(max(high - exactly, exactly - low))


def _cells(row: Any) -> Iterable[tuple[str, Any]]:
    """Yields the names and contents of a row's cells."""
    for name, content in vars(row).items():
        if name in _NUMBERS and isinstance(content, str):
            yield name, float(given(content, 20))
        elif isinstance(content, Value):
            number, bound = _number(content)
            yield name, number
            if name not in _NUMBERS:
                yield name + "_bound", bound
        elif name in ("c", "s"):
            for k, value in enumerate(content):
                number, bound = _number(value)
                yield f"{name}_{k}", number
                yield f"{name}_{k}_bound", bound
        elif name in ("p_local", "q_local"):
            q = "q_" if name == "q_local" else ""
            for approximation in content:
                yield f"{q}local_{approximation.terms}", _number(approximation.value)[0]
                yield f"{q}rel_{approximation.terms}", _number(approximation.relative_error)[0]
        elif name == "terms" and not isinstance(content, int):  # of a slip zone
            for term in content:
                yield f"size_{term.terms}", _number(term.size)[0]
                yield f"rel_{term.terms}", _number(term.relative_error)[0]
        elif content is None or isinstance(content, (str, bool, int)):
            yield name, content


def columns(rows: Iterable[Any]) -> dict[str, Any]:
    """Returns a dict of arrays; a column without any content is left out."""
    numpy = imported("numpy")
    cells = [dict(_cells(row)) for row in rows]
    names = list(dict.fromkeys(name for row in cells for name, content in row.items()
                               if content is not None))
    found = {}
    for name in names:
        column = [row.get(name) for row in cells]
        numbers = all(c is None or isinstance(c, float) for c in column)
        found[name] = numpy.array([math.nan if c is None else c for c in column] if numbers else
                                  column)
    return found
