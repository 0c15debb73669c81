# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes: a profile under a load, and the quantities that can be computed."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any, overload

from . import _apart, _edgeproof
from ._edgeproof import Value
from ._numbers import exact_text, whole, wholes
from ._shipped import file_or_shipped
from .errors import InputError
from .profiles import Number, Profile
from .results import Coefficients, Contact, Extent, Point, Result, Slip, result_of

if TYPE_CHECKING:
    import matplotlib.figure
    import numpy
    import numpy.typing

__all__ = ["Scene", "read_scene"]

_MOST_DIGITS = 100_000
_LOAD = ("a", "P", "M", "contact_modulus", "E1", "nu1", "E2", "nu2")


def _is_many(u: Any) -> bool:
    return not isinstance(u, (str, bytes)) and hasattr(u, "__iter__") and getattr(u, "shape", None) != ()


def _places(u: Any) -> list[str]:
    if hasattr(u, "ravel"):  # an array
        u = u.ravel()
    return [exact_text(x, f"u[{i}]") for i, x in enumerate(u)]


def read_scene(file: str | os.PathLike[str]) -> Scene:
    """Reads a scene file (TOML; docs/file-formats.md), or one that came with the program.

    The name of a scene that came with the program is, for example, "fretting-pad". Raises
    InputError, with file and line, for a malformed scene.
    """
    name = file_or_shipped(file, "examples/scenes")
    return Scene.from_text(_edgeproof.read_text(name, "scene (TOML)"), name)


class Scene:
    """A contact -b < x < a: a profile, a load, and perhaps shear. It is immutable.

    profile          made by edgeproof.hertz(), power_law(), flat_and_rounded(), ...
    a, or P          the right edge (a length), or the normal force per unit length
    M                moment about the origin per unit length, with P and a tilted profile without
                     alpha: the tilt is then found
    contact_modulus  E*, or E1, nu1, E2, nu2: Young's moduli and Poisson's ratios of both bodies
    Q, bulk_tension  shear force per unit length, and differential bulk tension
    friction         the coefficient of friction: zones at the edges slip; None: full stick
    path             "normal-first" (P, then Q at constant P) or "together" (P and Q in proportion)

    Numbers are exact (see edgeproof.profiles.Number). Any consistent system of units may be used:
    pressures are in the unit of the contact modulus, and forces per unit length in that unit times
    the unit of length. Raises InputError for values that make no sense, TypeError for values that
    are not numbers.

    Distances u run from an edge inwards: u = a - x at the right one, u = b + x at the left one.
    Every method that computes takes `digits` (2 to 100000; None: the scene's, or 50 if it has
    none), releases the GIL, ends with KeyboardInterrupt on Ctrl-C, and may be called from several
    threads. More than 5000 digits are computed in a process of their own, which Ctrl-C ends at
    once. These methods raise InputError for a load that no contact carries and for a u outside
    0 < u < a + b or on a corner of the profile, and BudgetError if a quadrature does not reach its
    digits.
    """

    _native: _edgeproof.NativeScene

    def __init__(self, profile: Profile, *, a: Number | None = None, P: Number | None = None,
                 M: Number | None = None, contact_modulus: Number | None = None,
                 E1: Number | None = None, nu1: Number | None = None, E2: Number | None = None,
                 nu2: Number | None = None, Q: Number | None = None,
                 bulk_tension: Number | None = None, friction: Number | None = None,
                 path: str | None = None, title: str = "") -> None:
        if not isinstance(profile, Profile):
            raise TypeError(f"profile is {type(profile).__name__}, not a Profile: give "
                            "edgeproof.hertz(R=...), edgeproof.power_law(m=..., C=...), ...")
        given = dict(zip(_LOAD, (a, P, M, contact_modulus, E1, nu1, E2, nu2)))
        load = [(k, exact_text(v, k)) for k, v in given.items() if v is not None]
        shear = [(k, exact_text(v, k))
                 for k, v in (("Q", Q), ("bulk_tension", bulk_tension), ("friction", friction))
                 if v is not None]
        if path is not None:
            shear.append(("path", str(path)))
        self._set(_edgeproof.NativeScene.from_entries(title, profile._entries(), load, shear))

    def _set(self, native: _edgeproof.NativeScene) -> None:
        self._native = native
        self._contacts: dict[int, Contact] = {}

    @classmethod
    def from_text(cls, text: str, file: str = "") -> Scene:
        """Makes a scene from the text of a scene file; `file` is its name in errors."""
        scene = cls.__new__(cls)
        scene._set(_edgeproof.NativeScene(text, file))
        return scene

    @property
    def text(self) -> str:
        """The text of an equivalent scene file."""
        return self._native.text

    @property
    def title(self) -> str:
        """The scene's title; may be empty."""
        return self._native.title

    @property
    def file(self) -> str | None:
        """The file from which it was read, or None."""
        return self._native.file or None

    @property
    def digits(self) -> int:
        """The number of digits of values if none is given."""
        return int(self._native.asked["digits"])

    @property
    def asked(self) -> dict[str, Any]:
        """The questions of the scene file, which run() answers: quantities, edges, terms, u, ..."""
        return self._native.asked

    @property
    def symmetric(self) -> bool:
        """True if b = a by construction."""
        return self._native.symmetric

    @property
    def has_shear(self) -> bool:
        """True if Q or a bulk tension is given."""
        return self._native.has_shear

    @property
    def has_friction(self) -> bool:
        """True if a coefficient of friction is given, so that zones at the edges slip."""
        return self._native.slips

    def __repr__(self) -> str:
        return "<edgeproof.Scene " + (self.title or self.file or "of a profile and a load") + ">"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Scene):
            return NotImplemented
        return self.text == other.text

    def __hash__(self) -> int:
        return hash(self.text)

    def __reduce__(self) -> tuple[Any, ...]:
        return Scene.from_text, (self.text, self.file or "")

    def _run(self, digits: int | None, **asked: Any) -> Result:
        count = self.digits if digits is None else whole(digits, "digits")
        if not 2 <= count <= _MOST_DIGITS:
            raise InputError(f"digits = {count} is out of range",
                             f"give a number from 2 to {_MOST_DIGITS}")
        asked["digits"] = count
        most = _apart.MOST_DIGITS_HERE_INTEGRATED if self._native.integrated else \
            _apart.MOST_DIGITS_HERE
        if count > most and _apart.can_start():
            return result_of(_apart.run("values", self.text, self.file or "", asked))
        return result_of(self._native.run(asked))

    # The contact.

    def contact(self, digits: int | None = None) -> Contact:
        """Both edges, force and moment, and the tilt if it is found: a Contact of Values."""
        wanted = self.digits if digits is None else digits
        if wanted not in self._contacts:
            found: Any = self._run(wanted, quantities=["contact"]).contact
            self._contacts[wanted] = Contact(**found)
        return self._contacts[wanted]

    @property
    def a(self) -> Value:
        """The distance of the right edge from the origin, a length."""
        return self.contact().a

    @property
    def b(self) -> Value:
        """The distance of the left edge from the origin, a length."""
        return self.contact().b

    @property
    def P(self) -> Value:
        """The normal force per unit length."""
        return self.contact().P

    @property
    def M(self) -> Value:
        """Moment about the origin per unit length, positive if it presses the right side down."""
        return self.contact().M

    @property
    def alpha(self) -> Value | None:
        """The tilt that was found, radians; None if it is given, or there is none."""
        return self.contact().alpha

    # At points.

    def _points(self, u: Any, edge: str, quantity: str, terms: Sequence[int],
                digits: int | None) -> tuple[Point, ...]:
        places = _places(u) if _is_many(u) else [exact_text(u, "u")]
        if not places:
            return ()
        return self._run(digits, edges=[edge], u=places, quantities=[quantity],
                         terms=list(terms)).points

    @overload
    def pressure(self, u: Number, edge: str = ...,  # type: ignore[misc]
                     digits: int | None = ...) -> Value: ...
    @overload
    def pressure(self, u: Iterable[Number], edge: str = ...,
                     digits: int | None = ...) -> list[Value]: ...

    def pressure(self, u: Any, edge: str = "right", digits: int | None = None) -> Any:
        """The pressure p at the distance u from an edge ("right" or "left"), a Value.

        p is in the unit of the contact modulus. A list of places gives a list of Values, and the
        contact is solved once. For numpy arrays of float see pressures().
        """
        values = [row.p for row in self._points(u, edge, "pressure", (), digits)]
        return values if _is_many(u) else values[0]

    @overload
    def shear(self, u: Number, edge: str = ...,  # type: ignore[misc]
                  digits: int | None = ...) -> Value: ...
    @overload
    def shear(self, u: Iterable[Number], edge: str = ...,
                  digits: int | None = ...) -> list[Value]: ...

    def shear(self, u: Any, edge: str = "right", digits: int | None = None) -> Any:
        """The shear traction q at the distance u from an edge, a Value; a list gives a list.

        q is in the unit of the contact modulus, under full stick or, with friction, partial slip.
        Raises InputError for a scene without shear.
        """
        values = [row.q for row in self._points(u, edge, "shear", (), digits)]
        return values if _is_many(u) else values[0]

    def slip_state(self, u: Any, edge: str = "right", digits: int | None = None) -> Any:
        """The state of the place at the distance u from an edge: "slip", "stick" or "undecided".

        A list of places gives a list. "undecided": the place is too near the end of the stick zone
        to decide. Raises InputError for a scene without friction.
        """
        self._needs_friction()
        states = [row.state for row in self._points(u, edge, "shear", (), digits)]
        return states if _is_many(u) else states[0]

    def approximation(self, u: Number, terms: int | Sequence[int] = 1, edge: str = "right",
                      digits: int | None = None) -> Point:
        """p at one place, and the sums of the first `terms` terms with their errors.

        The result is a Point: .p, and .p_local, an Approximation for each number of terms.
        """
        return self._points(u, edge, "pressure", wholes(terms, "terms"), digits)[0]

    def pressures(self, u: numpy.typing.ArrayLike,
                  edge: str = "right") -> numpy.typing.NDArray[numpy.float64]:
        """Pressures at a whole numpy array of distances from an edge, as an array of its shape.

        Each is the binary64 nearest to the exact pressure at exactly that binary64 u. This is
        proved if the pressure has a closed form (power laws, piecewise linear g'); otherwise it
        relies on the error that the quadrature estimates at 25 digits. The value is 0 at the edges
        and outside the contact (also for infinite u), and inf on a corner of the profile. Raises
        InputError, with the index, for NaN.
        """
        import numpy

        if numpy.ma.is_masked(u):  # type: ignore[no-untyped-call]
            raise InputError("u is an array with masked elements",
                             "give u.compressed(), or put numbers in their place by u.filled(0.1)")
        places = numpy.asarray(u)
        if places.dtype.kind not in "fiu":
            raise TypeError(f"u is an array of {places.dtype}: give float64, or ask pressure(), "
                            "which takes exact numbers")
        if places.dtype.itemsize > 8:
            exact = places.astype(numpy.float64)
            if not (exact == places).all():
                raise TypeError(f"u is an array of {places.dtype} with numbers that float64 does "
                                "not hold: give float64")
            places = exact
        elif places.dtype.kind in "iu" and places.size and (abs(places.astype(object)) >
                                                           2**53).any():
            raise TypeError("u has whole numbers that float64 does not hold: give float64")
        values: numpy.typing.NDArray[numpy.float64] = self._native.pressures(
            edge, places.astype(numpy.float64, copy=False))
        return values

    # At edges.

    def _expansion(self, terms: int, edge: str, digits: int | None) -> Coefficients:
        return self._run(digits, edges=[edge], quantities=["coefficients"],
                         terms=[whole(terms, "terms")]).coefficients[0]

    def coefficients(self, terms: int = 3, edge: str = "right",
                     digits: int | None = None) -> tuple[Value, ...]:
        """c_0 ... c_{terms-1} of p = sum c_k u^(k + 1/2) at an edge (at most 400 terms).

        c_k is in the unit of the contact modulus over length^(k + 1/2).
        """
        return self._expansion(terms, edge, digits).c

    def shear_coefficients(self, terms: int = 3, edge: str = "right",
                           digits: int | None = None) -> Coefficients:
        """The coefficients .s of q at an edge, from the power u^(.s_half_powers/2) on."""
        if not self.has_shear:
            raise InputError("the scene has no shear", "give Q or bulk_tension")
        return self._expansion(terms, edge, digits)

    def extent(self, terms: int = 1, tolerance: Number = "1%", edge: str = "right",
               part: tuple[Number, Number] = (0, 1), process_zone: Number | None = None,
               digits: int | None = None) -> Extent:
        """The extent from an edge over which the first `terms` terms are within a tolerance of p.

        tolerance     relative: "1%", "0.01", Fraction(1, 100)
        part          the examined part of the contact, as fractions of a + b from the edge
        process_zone  a length from the edge; the result states whether the extent covers it
        """
        return self._run(
            digits, edges=[edge], quantities=["extent"], terms=[whole(terms, "terms")],
            tolerance=exact_text(tolerance, "tolerance"),
            part=[exact_text(p, "part") for p in part],
            process_zone="" if process_zone is None else exact_text(process_zone, "process_zone"),
        ).extents[0]

    def _needs_friction(self) -> None:
        if not self.has_friction:
            raise InputError("the scene has no friction, so that nothing slips",
                             "give friction and Q")

    def slip(self, edge: str = "right", terms: int | Sequence[int] = (1, 2, 3),
             tolerance: Number | None = None, digits: int | None = None) -> Slip:
        """The slip zone at an edge, its approximations by n terms, and the stick zone: a Slip.

        terms      numbers of terms of the series in |Q|/(friction P)
        tolerance  relative ("1%"): also find the load ratio up to which n terms are within it

        Q (and the bulk tension) are applied at constant P. Raises InputError for a scene without
        friction, for one that slides (|Q| >= friction P), and for a bulk tension with which an edge
        slips in the other direction.
        """
        self._needs_friction()
        return self._run(
            digits, edges=[edge], quantities=["slip"], terms=wholes(terms, "terms"),
            tolerance="" if tolerance is None else exact_text(tolerance, "tolerance")).slips[0]

    # As a whole.

    def run(self, digits: int | None = None) -> Result:
        """Answers all questions of the scene file ([ask])."""
        return self._run(digits)

    def plot(self, terms: int | Sequence[int] = (1, 2), edge: str = "right",
             file: str | os.PathLike[str] | None = None) -> matplotlib.figure.Figure:
        """Plots the pressure with the sums of the first terms; their relative errors on log axes.

        Returns a matplotlib Figure, and writes it to `file` if one is given (.png, .pdf, .svg).
        Raises ImportError if matplotlib or numpy is missing.
        """
        from ._plot import plot

        figure = plot(self, wholes(terms, "terms"), edge)
        if file is not None:
            figure.savefig(os.fspath(file))
        return figure
