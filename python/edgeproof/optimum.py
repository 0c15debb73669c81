# SPDX-License-Identifier: BSD-3-Clause
"""Finds the parameter of a scene for which an approximation reaches farthest."""

from __future__ import annotations

import copy
import dataclasses
import json
import os
from collections.abc import Callable, Mapping
from typing import Any

from . import _edgeproof
from ._arguments import checked
from ._edgeproof import Value, value_of_state
from ._shipped import file_or_shipped
from .profiles import Number
from .results import Row

__all__ = ["Design", "design"]


@dataclasses.dataclass(frozen=True)
class Design:
    """The best value of a scene's range. The names are those of `edgeproof design --format json`.

    values            for each parameter, a Value in the scene's units
    reach             the reach there, or its limit (attained is False): a fraction of a + b, unless
                      the scene has unit = "distance"
    gap               no other value of the range reaches farther by more than this, as proved by
                      branch and bound; None if nothing is proved
    proved            if False, values and reach are estimates, and `missing` gives the reason
    best              the kind of optimum, in words
    touches_at        the distance (in the unit of reach) at which the error touches the tolerance;
                      None if it does not
    reach_shown_at    for each parameter, the exact value near the best one at which the reach is
                      proved to within the gap; empty if nothing is proved
    printed           for each parameter, the value in the scene for comparison (or empty)
    reach_at_printed  the reach of the printed values, or None
    falls_short_by    1 - reach_at_printed/reach, or None
    """

    title: str
    tolerance: str
    terms: int
    values: Mapping[str, Value]
    reach: Value
    gap: str | None
    proved: bool
    missing: str
    best: str
    attained: bool
    touches_at: Value | None
    reach_shown_at: Mapping[str, Value]
    printed: Mapping[str, Value]
    reach_at_printed: Value | None
    falls_short_by: Value | None
    notes: tuple[str, ...] = dataclasses.field(repr=False)
    _data: dict[str, Any] = dataclasses.field(repr=False, compare=False)

    @property
    def parameter(self) -> str:
        """The name of the parameter."""
        return next(iter(self.values))

    @property
    def value(self) -> Value:
        """The best value of the parameter."""
        return self.values[self.parameter]

    def __str__(self) -> str:
        return str(Row(**{self.parameter: self.value}, reach=self.reach, gap=self.gap,
                       best=self.best))

    def to_dict(self) -> dict[str, Any]:
        """The content of `edgeproof design --format json`."""
        return copy.deepcopy(self._data)


@checked
def design(file: str | os.PathLike[str] | None = None, *, text: str | None = None,
           maximise: str | None = None, terms: int | None = None,
           tolerance: Number | None = None, edge: str | None = None, gap: Number = "1e-6",
           digits: int = 30, progress: Callable[[int, int], object] | None = None) -> Design:
    """Finds the parameter of a scene with a range for which n terms reach farthest.

    file       a scene (TOML) with one range, such as m = { from = "0", to = "2" }
               (docs/design.md), or the name of one that came with the program: "exponent"
    text       the text of such a file, in place of `file`; errors call it "(text)"
    maximise   "first_exit", the first distance from the edge at which the error of `terms` terms
               reaches the tolerance; "measure", the length of all places at which it is smaller (an
               estimate)
    terms      1 to 12
    tolerance  relative: "1%", "1/100"
    edge       "right", "left", or "both": the lesser reach counts
    gap        > 0, in the unit of the reach: it is proved that no other value is better by more
    digits     of the value and of the reach, 2 to 1000
    progress   is called with (thousandths of the range done, 1000), from any thread

    maximise, terms, tolerance and edge replace the values in [design]; None keeps the scene's. A
    scene without [design] needs tolerance and maximise.

    The GIL is released, and Ctrl-C ends the call with KeyboardInterrupt. Raises InputError, with
    file and line, for a malformed scene and for a value of the range that gives no scene;
    InputError for a question that makes no sense; BudgetError if no reach is found.
    """
    if (file is None) == (text is None):
        raise TypeError("give the file of a scene, or its text: one of them")
    name = "(text)" if file is None else file_or_shipped(file, "examples/design")
    if text is None:
        text = _edgeproof.read_text(name, "scene (TOML)")
    options = {"gap": gap, "digits": digits, "maximise": maximise, "tolerance": tolerance,
               "edge": edge, "terms": terms}
    found = json.loads(_edgeproof.design(
        progress, text, name, {k: str(v) for k, v in options.items() if v is not None}))
    data = found.pop("table")
    for key in ("values", "reach_shown_at", "printed"):
        found[key] = {name: value_of_state(state) for name, state in found[key].items()}
    for key in ("reach", "touches_at", "reach_at_printed", "falls_short_by"):
        found[key] = None if found[key] is None else value_of_state(found[key])
    return Design(title=data["title"], tolerance=data["tolerance"], terms=int(data["terms"]),
                  gap=data["rows"][0]["gap"], best=data["best"], notes=tuple(data["notes"]),
                  _data=data, **found)
