# SPDX-License-Identifier: BSD-3-Clause
"""Profiles of the gap between the bodies: the slope g'(x), convex, with its minimum at x = 0."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from decimal import Decimal
from fractions import Fraction
from typing import Any, Protocol, SupportsIndex, Union

from ._arguments import checked, mapping, read_as
from ._numbers import exact_text, is_many, texts

__all__ = ["Number", "Profile", "hertz", "wedge", "sphere", "cone", "power_law", "flat_and_rounded",
           "tilted_wedge", "tilted_flat_and_rounded", "piecewise"]


class _Ratio(Protocol):
    def as_integer_ratio(self) -> tuple[int, int]: ...


class _Mpf(Protocol):
    _mpf_: Any


Number = Union[str, int, float, Fraction, Decimal, SupportsIndex, _Ratio, _Mpf]
"""An exact number: str ("0.4", "pi/16", "3/2"), int, Fraction, Decimal, mpmath.mpf, numpy scalars;
a float is exactly its binary64 number: 0.1 is not one tenth, "0.1" is."""

Parameter = Union[Number, bool, Iterable[Number]]


def _parameter(value: Any, name: str) -> str | bool | list[str]:
    return (value if isinstance(value, bool) else texts(value, name) if is_many(value) else
            exact_text(value, name))


read_as("Mapping[str, Parameter]", lambda value, name: {
    key: _parameter(v, key) for key, v in mapping(value, name).items()})


class Profile:
    """The slope g'(x) of the gap; made by hertz(), power_law() and the other functions here.

    kind        the kind of profile, as in a scene file
    parameters  its numbers as exact text, by name
    """

    __slots__ = ("kind", "parameters")
    kind: str
    parameters: Mapping[str, Any]

    @checked
    def __init__(self, kind: str, parameters: Mapping[str, Parameter]) -> None:
        object.__setattr__(self, "kind", kind)
        object.__setattr__(self, "parameters", parameters)

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError("a Profile is not changed; make another")

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Profile):
            return NotImplemented
        return self.kind == other.kind and self.parameters == other.parameters

    def __hash__(self) -> int:
        return hash((self.kind, repr(sorted(self.parameters.items()))))

    def __repr__(self) -> str:
        given = ", ".join(f"{k}={v!r}" for k, v in self.parameters.items())
        return f"<edgeproof.Profile {self.kind}: {given}>"

    def __reduce__(self) -> tuple[Any, ...]:
        return Profile, (self.kind, self.parameters)

    def revolved(self) -> Profile:
        """The body of revolution with this profile: g'(r), r the radius (docs/axisymmetric.md).

        For symmetric profiles. The load is then P, the total force, or a, or delta.
        """
        return Profile(self.kind, {"geometry": "axisymmetric", **self.parameters})

    def _entries(self) -> list[tuple[str, Any]]:
        return [("kind", self.kind), *self.parameters.items()]


@checked
def hertz(R: Number) -> Profile:
    """A parabola: g' = x/R (two cylinders; R is the relative radius of curvature, a length)."""
    return Profile("hertz", {"R": R})


@checked
def wedge(phi: Number) -> Profile:
    """An upright wedge: g' = phi sgn(x). phi: the slope of its faces."""
    return Profile("wedge", {"phi": phi})


@checked
def sphere(R: Number) -> Profile:
    """Two spheres, or one on a flat: g' = r/R (R is the relative radius of curvature, a length)."""
    return Profile("sphere", {"R": R})


@checked
def cone(phi: Number) -> Profile:
    """A cone: g' = phi, the slope of its face."""
    return Profile("cone", {"phi": phi})


@checked
def power_law(m: Number, C: Number) -> Profile:
    """g' = C sgn(x) |x|^m, m >= 0, C > 0 (1/length^m)."""
    return Profile("power-law", {"m": m, "C": C})


@checked
def flat_and_rounded(t: Number, R: Number) -> Profile:
    """A flat of length 2t between arcs of radius R: t >= 0, R > 0, lengths."""
    return Profile("flat-and-rounded", {"t": t, "R": R})


@checked
def tilted_wedge(phi: Number, alpha: Number | None = None) -> Profile:
    """A wedge whose faces make the angle phi with the surface, turned clockwise by alpha.

    Angles in radians, |alpha| < phi. Without alpha the tilt is found from P and M.
    """
    given = {"phi": phi}
    if alpha is not None:
        given["alpha"] = alpha
    return Profile("tilted-wedge", given)


@checked
def tilted_flat_and_rounded(t: Number, R: Number, alpha: Number | None = None) -> Profile:
    """A flat of length 2t between arcs of radius R, turned clockwise by alpha >= 0 (radians).

    The origin is at its lowest point. Without alpha the tilt is found from P and M.
    """
    given = {"t": t, "R": R}
    if alpha is not None:
        given = {"alpha": alpha, **given}
    return Profile("tilted-flat-and-rounded", given)


@checked
def piecewise(knots: Iterable[Number], slopes: Iterable[Number],
              symmetric: bool = False) -> Profile:
    """A slope g'(x) in pieces: slopes[i], a formula in x, holds between knots[i-1] and knots[i].

    With symmetric=True both lists are for x > 0, and g'(-x) = -g'(x). g' must not decrease, and
    must change sign at x = 0. Example: piecewise([], ["x + x^3"], symmetric=True).
    """
    given: dict[str, Any] = {"knots": knots, "slopes": slopes}
    if symmetric:
        given["symmetric"] = True
    return Profile("piecewise", given)
