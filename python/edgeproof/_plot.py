# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the panels of the command `edgeproof plot` with matplotlib, for Scene.plot()."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

from ._lazy import imported

if TYPE_CHECKING:
    import matplotlib.figure

# The colours of Okabe and Ito in the order of the program's, and line styles that differ without
# colour; 0 is no line.
_COLOURS = ("black", "#E69F00", "#56B4E9", "#009E73", "#F0E442", "#0072B2", "#D55E00", "#CC79A7")
_DASHES: Any = ("", "-", "--", ":", "-.", (0, (5, 1, 1, 1)), (0, (5, 1, 1, 1, 1, 1)))
_MARKS = {5: "s", 7: "o", 9: "^", 11: "v", 13: "D", 15: "*"}


def plot(scene: Any, terms: Any, edge: str) -> matplotlib.figure.Figure:
    panels = json.loads(scene._native.pictures([("terms", list(map(str, terms))), ("edges", [edge])]))
    figure: matplotlib.figure.Figure = imported("matplotlib.figure").Figure(
        figsize=(5.5 * len(panels), 4.8), layout="constrained")
    for axes, panel in zip(figure.subplots(1, len(panels)), panels):
        for title, colour, dash, mark, width, x, y in panel["curves"]:
            axes.plot(x, y, label=title, color=_COLOURS[colour], linestyle=_DASHES[dash],
                      linewidth=0.8 * width, marker=_MARKS.get(mark, ""))
        if panel["level"]:
            at, name = panel["level"]
            axes.axhline(float(at), color="black", linewidth=0.8, linestyle=":", label=name)
        for name in "xy":
            label, logarithmic, ends = panel[name]
            axes.set(**{name + "label": label, name + "scale": "log" if logarithmic else "linear",
                        name + "lim": tuple(map(float, ends)) if ends else None})
        axes.set_title(panel["title"])
        axes.grid(linewidth=0.5, linestyle=":", color="#999999")
        axes.legend(frameon=False, loc="upper center", bbox_to_anchor=(0.5, -0.15), ncols=2)
    return figure
