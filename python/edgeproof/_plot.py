# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws a scene for Scene.plot(). The module of Scene imports this one, not the reverse."""

from __future__ import annotations

import itertools
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import matplotlib.figure

_POINTS = 600
_DECADES = 6
# Line styles that differ without colour.
_STYLES = ("--", "-.", ":", (0, (5, 1, 1, 1, 1, 1)))


def _sum(coefficients: Any, u: Any) -> Any:
    import numpy

    total = numpy.zeros_like(u)
    for c in reversed(coefficients):
        total = total * u + float(c)
    return total * numpy.sqrt(u)


def plot(scene: Any, terms: list[int], edge: str) -> matplotlib.figure.Figure:
    import numpy
    from matplotlib.figure import Figure

    figure = Figure(figsize=(10, 4.2), layout="constrained")
    whole, near = figure.subplots(1, 2)
    a, b = float(scene.contact(20).a), float(scene.contact(20).b)
    length = a + b
    c = scene.coefficients(max(terms), edge, digits=20)

    # Denser at both edges, where p is a square root.
    u = length * (1 - numpy.cos(numpy.linspace(0, numpy.pi, _POINTS))) / 2
    x = a - u if edge == "right" else u - b
    p = scene.pressures(u, edge)
    shown = numpy.isfinite(p)
    whole.plot(x[shown], p[shown], color="black", label="p")
    for n, style in zip(terms, itertools.cycle(_STYLES)):
        label = f"{n} term" + ("" if n == 1 else "s")
        whole.plot(x, _sum(c[:n], u), linestyle=style, color="0.35", label=label)
    if scene.has_shear:
        some = slice(1, -1, 5)
        q = [float(v) for v in scene.shear(u[some], edge, digits=10)]
        whole.plot(x[some], q, color="black", linewidth=0.8, marker=".", markersize=2, label="q")
    top = p[shown].max() if shown.any() else 1.0
    whole.set_ylim(0, 1.15 * top)
    whole.set_xlabel("x (unit of length of the scene)")
    whole.set_ylabel(("p, q" if scene.has_shear else "p") + " (unit of the contact modulus)")
    whole.legend(frameon=False)

    u = numpy.geomspace(length * 10.0**-_DECADES, length / 2, _POINTS // 3)
    exact = scene.pressures(u, edge)
    near.loglog(u, exact, color="black", label="p")
    for n, style in zip(terms, itertools.cycle(_STYLES)):
        label = f"{n} term" + ("" if n == 1 else "s")
        near.loglog(u, numpy.abs(_sum(c[:n], u)), linestyle=style, color="0.35", label=label)
    near.set_xlabel(f"u, from the {edge} edge (unit of length of the scene)")
    near.set_ylabel("p (unit of the contact modulus)")
    if scene.title:
        figure.suptitle(scene.title)
    return figure
