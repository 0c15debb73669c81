# SPDX-License-Identifier: BSD-3-Clause
"""Draws the panels of the command `edgeproof plot` with matplotlib, for Scene.plot()."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

from ._lazy import imported

if TYPE_CHECKING:
    import matplotlib.figure

# The program's colours, and line styles that differ without colour; 0 is no line.
_COLOURS = ("black", "#E69F00", "#56B4E9", "#009E73", "#F0E442", "#0072B2", "#D55E00", "#CC79A7")
_DASHES: Any = ("", "-", "--", ":", "-.", (0, (5, 1, 1, 1)), (0, (5, 1, 1, 1, 1, 1)))
_MARKS = {5: "s", 7: "o", 9: "^", 11: "v", 13: "D", 15: "*"}


def _draw_curves(axes: Any, panel: dict[str, Any], place: dict[str, Any]) -> None:
    named: list[list[Any]] = []
    for title, colour, dash, mark, width, x, y, marked in panel["curves"]:
        line, = axes.plot(x, y, label=title or "_", color=_COLOURS[colour], linestyle=_DASHES[dash],
                          linewidth=0.8 * width, marker=_MARKS.get(mark, ""))
        named.append([line])
        if marked is not None:  # a point on another curve shares its name
            named[marked].append(named.pop()[0])
            named.append([])
    if panel["level"]:
        at, name = panel["level"]
        named.append([axes.axhline(at, color="black", linewidth=0.8, linestyle=":",
                                   label=name)])
    axes.grid(linewidth=0.5, linestyle=":", color="#999999")
    entries = [(tuple(lines), lines[0].get_label()) for lines in named if lines]
    axes.legend(*zip(*entries), frameon=False, **place)


def _draw_field(axes: Any, panel: dict[str, Any], place: dict[str, Any]) -> None:
    np = imported("numpy")
    field = panel["field"]
    x, z = np.array(field["x"]), np.array(field["z"])
    values = np.array(field["values"], dtype=float).reshape(len(z), len(x))
    size = np.abs(values)
    greatest = np.nanmax(size)
    limit = np.nanquantile(size, 0.995) if field["unbounded"] else greatest
    colours = axes.pcolormesh(x, z, values, shading="nearest", rasterized=True, vmax=limit,
                              cmap="RdBu_r" if field["signed"] else "YlGnBu",
                              vmin=-limit if field["signed"] else 0)
    lines = axes.contour(x, z, values, levels=12, colors="black", linewidths=0.5)
    axes.clabel(lines, fontsize="x-small", fmt="%g")
    axes.figure.colorbar(colours, ax=axes, label=field["title"],
                         extend="both" if limit < greatest else "neither")
    for ends, colour in ((field["contact"], "black"), (field["stick"], _COLOURS[1])):
        if ends:
            axes.plot(ends, (0, 0), color=colour, linewidth=3, marker="|", clip_on=False)
    axes.set_ylim(z[-1], 0)
    j, i = np.unravel_index(np.nanargmax(size), size.shape)
    panel["title"] += f"\ngreatest size drawn: {values[j, i]:.4g} at ({x[i]:.4g}, {z[j]:.4g})"


def plot(scene: Any, terms: Any, edge: str, tolerance: str | None, field: str, body: str,
         ax: Any) -> matplotlib.figure.Figure:
    asked = [("terms", list(map(str, terms))), ("edges", [edge]),
             *([] if tolerance is None else [("tolerance", tolerance)])]
    panels = json.loads(scene._native.pictures(asked, field, body == "B"))
    place: dict[str, Any] = {"fontsize": "small"}
    if ax is None:
        place = {"loc": "upper center", "bbox_to_anchor": (0.5, -0.15)}
        figure = imported("matplotlib.figure").Figure(figsize=(5.5 * len(panels), 4.8),
                                                      layout="constrained")
        ax = figure.subplots(1, len(panels), squeeze=False)[0]
    for axes, panel in zip(ax, panels):
        (_draw_field if field else _draw_curves)(axes, panel, place)
        for name in "xy":
            label, logarithmic, ends = panel[name]
            axes.set(**{name + "label": label, name + "scale": "log" if logarithmic else "linear"},
                     **({name + "lim": tuple(ends)} if ends else {}))
        axes.set_title(panel["title"])
    return ax[0].figure  # type: ignore[no-any-return]
