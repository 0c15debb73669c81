# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws a scene for Scene.plot(), like the command `edgeproof plot`: the pressure along the contact
with the sums of the first terms, and their relative errors. The module of Scene imports this one,
not the reverse."""

from __future__ import annotations

import itertools
import tomllib
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from ._lazy import imported

if TYPE_CHECKING:
    import matplotlib.figure

_POINTS = 600
_DECADES = 6
_PLACES_A_DECADE = 10
# The colours of Okabe and Ito, with line styles that differ without colour.
_PENS = (("#CC79A7", "--"), ("#0072B2", "-."), ("#009E73", ":"), ("#D55E00", (0, (5, 1, 1, 1))),
         ("#E69F00", (0, (5, 1, 1, 1, 1, 1))), ("#56B4E9", "-"))
_MARKS = "osD^v*"
_STRAIGHT = 500  # a chord may differ from p by this part of the height
_TALLEST = 4  # pressures are drawn up to this multiple of the height that most of the contact has


def _sum(coefficients: Any, u: Any) -> Any:
    numpy = imported("numpy")
    total = numpy.zeros_like(u)
    for c in reversed(coefficients):
        total = total * u + float(c)
    return total * numpy.sqrt(u)


def _unit(scene: Any, kind: str) -> str:
    name = tomllib.loads(scene.text).get("units", {}).get(kind)
    return f" [{name}]" if name else ""


def _percent(tolerance: str) -> float:
    text = tolerance.strip()
    return float(Fraction(text[:-1])) if text.endswith("%") else 100 * float(Fraction(text))


def _terms(n: int) -> str:
    return f"{n} term" + ("" if n == 1 else "s")


def _pressures(scene: Any, length: float, edge: str) -> Any:
    """Distances from the edge and pressures there, denser at both edges and where p is curved."""
    numpy = imported("numpy")
    angles = numpy.linspace(0, numpy.pi, 62)
    p = scene.pressures(length * (1 - numpy.cos(angles)) / 2, edge)
    finite = p[numpy.isfinite(p)]
    usual = float(numpy.quantile(finite, 0.9)) if finite.size else 1.0
    for _ in range(7):
        middles = (angles[:-1] + angles[1:]) / 2
        w0, w, w1 = (1 - numpy.cos(a) for a in (angles[:-1], middles, angles[1:]))
        drawn = numpy.clip(p, 0, _TALLEST * usual)
        added = scene.pressures(length * w / 2, edge)
        chord = drawn[:-1] + (drawn[1:] - drawn[:-1]) * (w - w0) / (w1 - w0)
        bent = abs(numpy.clip(added, 0, _TALLEST * usual) - chord) > drawn.max() / _STRAIGHT
        order = numpy.argsort(numpy.concatenate([angles, middles]), kind="stable")
        angles = numpy.concatenate([angles, middles])[order]
        p = numpy.concatenate([p, added])[order]
        if not bent.any() or len(angles) > _POINTS:
            break
    finite = p[numpy.isfinite(p)]
    top = float(finite.max()) if finite.size else 1.0
    return (length * (1 - numpy.cos(angles)) / 2, p,
            top if top < _TALLEST * usual else 2 * usual)


def plot(scene: Any, terms: Any, edge: str) -> matplotlib.figure.Figure:
    numpy = imported("numpy")
    figure: matplotlib.figure.Figure = imported("matplotlib.figure").Figure(
        figsize=(11, 4.8), layout="constrained")
    whole, near = figure.subplots(1, 2)
    a, b = float(scene.contact(20).a), float(scene.contact(20).b)
    length = a + b
    c = scene.coefficients(max(terms), edge, digits=20)
    tolerance = scene.asked.get("tolerance") or "1%"
    percent = _percent(tolerance)
    extents = [scene.extent(n, tolerance, edge, digits=20) for n in terms]

    def place(u: Any) -> Any:
        return a - u if edge == "right" else u - b

    u, p, top = _pressures(scene, length, edge)
    shown = numpy.isfinite(p)
    whole.plot(place(u[shown]), p[shown], color="black", linewidth=2, label="p, exact")
    if scene.has_shear:
        some = u[1:-1:max(1, len(u) // 120)]
        q = numpy.array([float(v) for v in scene.shear(some, edge, digits=10)])
        whole.plot(place(some), q, color="black", linewidth=1.2, linestyle=":", label="q, exact")
        whole.set_ylim(max(min(q.min(), 0), -1.15 * top), 1.15 * top)
    else:
        whole.set_ylim(0, 1.15 * top)
    half = u[u <= length / 2]
    for n, extent, (colour, style), mark in zip(terms, extents, itertools.cycle(_PENS),
                                                itertools.cycle(_MARKS)):
        whole.plot(place(half), _sum(c[:n], half), color=colour, linestyle=style,
                   label=f"{_terms(n)}, {edge} edge")
        if extent.leaves:
            exit = numpy.array([float(extent.first_exit)])
            whole.plot(place(exit), _sum(c[:n], exit), color=colour, linestyle="", marker=mark,
                       label=f"leaves {percent:g} %")
    whole.set_xlabel("x" + _unit(scene, "length"))
    whole.set_ylabel(("p, q" if scene.has_shear else "p") + _unit(scene, "pressure"))
    whole.set_title(scene.title or "Contact pressure")

    # Exact errors: those of binary64 numbers would end at 1e-16.
    places = [repr(v) for v in length * 0.99999 * 10.0 ** (
        numpy.arange(-_DECADES * _PLACES_A_DECADE, 1) / _PLACES_A_DECADE)]
    _, points = scene._points(places, None, edge, "pressure", terms, 24)
    for k, (n, extent, (colour, style), mark) in enumerate(
            zip(terms, extents, itertools.cycle(_PENS), itertools.cycle(_MARKS))):
        errors = [(float(point.u), 100 * abs(float(point.p_local[k].relative_error)))
                  for point in points if point.p_local]
        near.loglog(*zip(*[(v, e) for v, e in errors if e > 1e-18]), color=colour, linestyle=style,
                    label=_terms(n))
        if extent.leaves:
            near.plot([float(extent.first_exit)], [percent], color=colour, linestyle="",
                      marker=mark, label=f"leaves it at u = {float(extent.first_exit):.3g}")
    near.axhline(percent, color="black", linewidth=0.8, linestyle=":",
                 label=f"tolerance {percent:g} %")
    near.set_xlim(length * 10.0**-_DECADES, length)
    near.set_ylim(top=1000)
    near.set_xlabel(f"distance from the {edge} edge u" + _unit(scene, "length"))
    near.set_ylabel("relative error |1 - local/p| [%]")
    near.set_title(f"Error at the {edge} edge")
    for axes in (whole, near):
        axes.grid(linewidth=0.5, linestyle=":", color="#999999")
        axes.legend(frameon=False, loc="upper center", bbox_to_anchor=(0.5, -0.15), ncols=2)
    return figure
