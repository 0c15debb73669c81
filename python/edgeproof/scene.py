# SPDX-License-Identifier: BSD-3-Clause
"""Scenes: a profile under a load, and the quantities that can be computed."""

from __future__ import annotations

import copy
import json
import os
import tomllib
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, cast, overload

from . import _apart, _edgeproof
from ._arguments import checked, read_as
from ._edgeproof import Value, value_of_state
from ._lazy import imported
from ._numbers import is_many, texts
from ._shipped import file_or_shipped
from .errors import InputError
from .profiles import Number, Profile
from .results import Result, Row, Rows, result_of

if TYPE_CHECKING:
    import matplotlib.figure
    import numpy
    import numpy.typing

__all__ = ["Scene", "read_scene"]

Places = Any
"""A Number, or a list or array of them."""

Axes = Any
"""matplotlib.axes.Axes, or a list of them."""

_MOST_DIGITS = 100_000
_LOAD = ("a", "P", "M", "delta", "contact_modulus", "E1", "nu1", "E2", "nu2", "nu")


def _given_places(u: Any, x: Any) -> tuple[str, Any]:
    """Returns the name and the places of the one argument that is given."""
    if (u is None) == (x is None):
        raise TypeError("give places by u, the distances from the edge, or by x: one of the two")
    return ("x", x) if u is None else ("u", u)


def _like(places: Any, values: Sequence[Any]) -> Any:
    """Returns the values in the form of the places: one, a list, or a numpy array."""
    if not is_many(places):
        return values[0]
    if not hasattr(places, "ravel") or not hasattr(places, "shape"):
        return list(values)
    found = imported("numpy").empty(len(values), dtype=object)
    found[:] = values
    return found.reshape(places.shape)


def _binary64(places: Any, name: str) -> Any:
    """Returns the places as an array of float64. Raises TypeError if that would change them."""
    np = imported("numpy")
    if np.ma.is_masked(places):
        raise InputError(f"{name} is an array with masked elements", f"give {name}.compressed(), "
                         f"or put numbers in their place by {name}.filled(0.1)")
    array = np.asarray(places)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{name} is an array of {array.dtype}: give float64, or ask pressure(), "
                        "shear() or approximation(), which take exact numbers")
    if array.dtype.itemsize > 8:
        exact = array.astype(np.float64)
        if not (exact == array).all():
            raise TypeError(f"{name} is an array of {array.dtype} with numbers that float64 does "
                            "not hold: give float64")
        array = exact
    elif array.dtype.kind in "iu" and array.size and (abs(array.astype(object)) > 2**53).any():
        raise TypeError(f"{name} has whole numbers that float64 does not hold: give float64")
    return array.astype(np.float64, copy=False)


def _axes(value: Any, name: str) -> list[Any]:
    every = list(value) if is_many(value) else [value]
    if not every or not all(hasattr(one, "axhline") for one in every):
        raise TypeError(f"{name} is {type(value).__name__}: give matplotlib's Axes")
    return every


read_as("numpy.typing.ArrayLike", _binary64)
read_as("Axes", _axes)


def _is_B(body: str) -> bool:
    if body not in ("A", "B"):
        raise InputError(f"there is no body '{body}'", "write A (on which Q acts) or B")
    return body == "B"


def _shown(value: Any) -> str:
    """Returns a value of a scene file as it is written, without quotes."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{k}={_shown(v)}" for k, v in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(_shown, value)) + "]"
    return str(value).lower() if isinstance(value, bool) else str(value)


@checked
def read_scene(file: str | os.PathLike[str]) -> Scene:
    """Reads a scene file (TOML; docs/file-formats.md), or one that came with the program.

    The name of a scene that came with the program is, for example, "fretting-pad". Raises
    InputError, with file and line, for a malformed scene.
    """
    name = file_or_shipped(file, "examples/scenes")
    return Scene.from_text(_edgeproof.read_text(name, "scene (TOML)"), name)


class _Unmade:
    """The native scene of an object that Scene.__new__ made alone."""

    def __getattr__(self, name: str) -> Any:
        # help() asks this object, too, for __name__ and others.
        error = AttributeError if name.startswith("__") else TypeError
        raise error("the Scene has no profile: write Scene(...), Scene.from_text() or "
                    "read_scene()")

    __getitem__ = __getattr__


class Scene:
    """A contact -b < x < a: a profile, a load, and perhaps shear. It is immutable.

    profile          made by edgeproof.hertz(), power_law(), flat_and_rounded(), ...
    a, or P          the right edge (a length), or the normal force per unit length
    M                moment about the origin per unit length, with P and a tilted profile without
                     alpha: the tilt is then found
    contact_modulus  E*, or E1, nu1, E2, nu2: Young's moduli and Poisson's ratios of both bodies
    E, nu            in their place: those of two equal bodies
    nu               with contact_modulus: Poisson's ratio of both bodies, for stresses of von Mises
    Q, bulk_tension  shear force per unit length, and differential bulk tension
    q_ratio          Q/(f P), in place of Q, with P and friction
    bulk_A           the bulk stress of body A; B has bulk_A + bulk_tension
    friction         the coefficient of friction: zones at the edges slip; None: full stick
    path             "normal-first" (P, then Q at constant P) or "together" (P and Q in proportion)
    sliding          "right" or "left", in place of Q: q = friction p, or -friction p, everywhere
    delta            the approach of a body of revolution, in place of a or P
    steps            a load history in place of P, Q and bulk_tension: for each step the loads at its
                     end that change, such as [{"P": 600}, {"Q": 200}, {"Q": -200}], and "cycles" in
                     the first step of those that are repeated. Values are those after the last step;
                     steps[:2] gives those after the second (docs/histories.md)

    units            names for axes and tables, such as {"length": "mm", "pressure": "MPa"}

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

    _native: _edgeproof.NativeScene = cast(Any, _Unmade())
    _facts: dict[str, Any] = cast(Any, _Unmade())

    @checked
    def __init__(self, profile: Profile, *, a: Number | None = None, P: Number | None = None,
                 M: Number | None = None, contact_modulus: Number | None = None,
                 E1: Number | None = None, nu1: Number | None = None, E2: Number | None = None,
                 nu2: Number | None = None, E: Number | None = None,
                 nu: Number | None = None, Q: Number | None = None,
                 bulk_tension: Number | None = None, bulk_A: Number | None = None,
                 friction: Number | None = None, path: str | None = None,
                 sliding: str | None = None, q_ratio: Number | None = None,
                 delta: Number | None = None,
                 steps: Iterable[Mapping[str, Number]] = (),
                 units: Mapping[str, str] | None = None, title: str = "") -> None:
        if not isinstance(profile, Profile):
            raise TypeError(f"profile is {type(profile).__name__}, not a Profile: give "
                            "edgeproof.hertz(R=...), edgeproof.power_law(m=..., C=...), ...")
        if E is not None:
            if nu is None or not contact_modulus is E1 is nu1 is E2 is nu2 is None:
                raise InputError("E is given without nu, or with other moduli",
                                 "give E and nu for two equal bodies, or E1, nu1, E2 and nu2")
            E1, nu1, E2, nu2, nu = E, nu, E, nu, None
        given = dict(zip(_LOAD, (a, P, M, delta, contact_modulus, E1, nu1, E2, nu2, nu)))
        load: list[Any] = [(k, v) for k, v in given.items() if v is not None]
        tractions = {"Q": Q, "q_ratio": q_ratio, "bulk_tension": bulk_tension, "bulk_A": bulk_A,
                     "friction": friction, "path": path, "sliding": sliding}
        shear: list[Any] = [(k, v) for k, v in tractions.items() if v is not None]
        history: list[Any] = [list(step.items()) for step in steps]
        self._set(_edgeproof.NativeScene.from_keys(
            [("profile", profile._entries()), ("load", load), ("shear", shear),
             ("units", list((units or {}).items())), *(("[[step]]", step) for step in history)], title))

    def _set(self, native: _edgeproof.NativeScene) -> None:
        self._native = native
        self._facts = json.loads(native.facts())
        self._contacts: dict[int, Row] = {}

    @classmethod
    @checked
    def from_text(cls, text: str, file: str = "") -> Scene:
        """Makes a scene from the text of a scene file; `file` is its name in errors."""
        scene = cls.__new__(cls)
        scene._set(_edgeproof.NativeScene.from_text(text, file))
        return scene

    @property
    def text(self) -> str:
        """The text of an equivalent scene file."""
        return self._native.text

    @property
    def title(self) -> str:
        """The scene's title; may be empty."""
        return str(self._facts["title"])

    @property
    def file(self) -> str | None:
        """The file from which it was read, or None."""
        return self._facts["file"] or None

    @property
    def digits(self) -> int:
        """The number of digits of values if none is given."""
        return int(self.asked["digits"])

    @property
    def asked(self) -> dict[str, Any]:
        """The questions of the scene file, which run() answers: quantities, edges, terms, u, ..."""
        return copy.deepcopy(self._facts["asked"])  # type: ignore[no-any-return]

    @property
    def symmetric(self) -> bool:
        """True if b = a by construction."""
        return bool(self._facts["symmetric"])

    @property
    def has_shear(self) -> bool:
        """True if Q, a bulk tension or sliding is given."""
        return bool(self._facts["has_shear"])

    @property
    def has_friction(self) -> bool:
        """True if a coefficient of friction is given, so that zones at the edges slip."""
        return bool(self._facts["slips"])

    def __repr__(self) -> str:
        if isinstance(self._native, _Unmade):
            return "<edgeproof.Scene, not made>"
        sections = tomllib.loads(self.text, parse_float=str)
        profile = sections["profile"]
        parts = [" ".join([str(profile["kind"])] +
                          [f"{k}={_shown(v)}" for k, v in profile.items() if k != "kind"])]
        parts += [" ".join(f"{k}={_shown(v)}" for k, v in sections[name].items())
                  for name in ("load", "shear", "units") if sections.get(name)]
        parts += [" ".join(f"{k}={_shown(v)}" for k, v in step.items())
                  for step in sections.get("step", [])]
        name = self.title or self.file
        return "<edgeproof.Scene " + (f"{name!r}: " if name else "") + "; ".join(parts) + ">"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Scene):
            return NotImplemented
        return self.text == other.text

    def __hash__(self) -> int:
        return hash(self.text)

    def __reduce__(self) -> tuple[Any, ...]:
        return Scene.from_text, (self.text, self.file or "")

    def _run(self, digits: int | None, **asked: Any) -> Result:
        count = self.digits if digits is None else digits
        if not 2 <= count <= _MOST_DIGITS:
            raise InputError(f"digits = {count} is out of range",
                             f"give a number from 2 to {_MOST_DIGITS}")
        keys: Any = [(key, list(map(str, v)) if isinstance(v, (list, tuple)) else str(v))
                     for key, v in {**asked, "digits": count}.items()]
        most = _apart.MOST_DIGITS_HERE_INTEGRATED if self._facts["integrated"] else \
            _apart.MOST_DIGITS_HERE
        if count > most and _apart.can_start():
            return result_of(_apart.run("values", self.text, self.file or "", keys))
        return result_of(self._native.run(keys))

    # The contact.

    @checked
    def contact(self, digits: int | None = None) -> Row:
        """Both edges, force and moment, and the tilt if it is found: a Row of Values."""
        wanted = self.digits if digits is None else digits
        if wanted not in self._contacts:
            found: Any = self._run(wanted, quantities=["contact"]).contact
            self._contacts[wanted] = Row(**{name: found.get(name) for name in (
                "a", "b", "P", "M", "alpha", "delta", "stiffness")})
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

    def _points(self, u: Any, x: Any, edge: str, quantity: str, terms: Any,
                digits: int | None) -> tuple[Any, tuple[Row, ...]]:
        """Returns the places that are given, and a Row for each."""
        name, places = _given_places(u, x)
        every = texts(places, name)
        if not every:
            return places, ()
        asked: dict[str, Any] = {name: every}
        return places, self._run(digits, edges=[edge], quantities=[quantity], terms=list(terms),
                                 **asked).points

    @overload
    def pressure(  # type: ignore[misc]
            self, u: numpy.typing.NDArray[Any], edge: str = ..., digits: int | None = ..., *,
            x: None = ...) -> numpy.typing.NDArray[numpy.object_]: ...
    @overload
    def pressure(  # type: ignore[misc]
            self, u: Number, edge: str = ..., digits: int | None = ..., *,
            x: None = ...) -> Value: ...
    @overload
    def pressure(self, u: Iterable[Number], edge: str = ..., digits: int | None = ..., *,
                 x: None = ...) -> list[Value]: ...
    @overload
    def pressure(self, u: None = ..., edge: str = ..., digits: int | None = ..., *,
                 x: Any) -> Any: ...

    @checked
    def pressure(self, u: Places = None, edge: str = "right", digits: int | None = None, *,
                 x: Places = None) -> Any:
        """The pressure p at the distance u from an edge ("right" or "left"), or at the place x.

        p is in the unit of the contact modulus, a Value. A list of places gives a list of Values, a
        numpy array an array of Values, and the contact is solved once. u and x are numbers, or formulas
        in a, b and the parameters of the profile ("a/2"). For arrays of float see pressures().
        """
        places, points = self._points(u, x, edge, "pressure", (), digits)
        return _like(places, [row.p for row in points])

    @overload
    def shear(  # type: ignore[misc]
            self, u: numpy.typing.NDArray[Any], edge: str = ..., digits: int | None = ..., *,
            x: None = ...) -> numpy.typing.NDArray[numpy.object_]: ...
    @overload
    def shear(  # type: ignore[misc]
            self, u: Number, edge: str = ..., digits: int | None = ..., *,
            x: None = ...) -> Value: ...
    @overload
    def shear(self, u: Iterable[Number], edge: str = ..., digits: int | None = ..., *,
              x: None = ...) -> list[Value]: ...
    @overload
    def shear(self, u: None = ..., edge: str = ..., digits: int | None = ..., *,
              x: Any) -> Any: ...

    @checked
    def shear(self, u: Places = None, edge: str = "right", digits: int | None = None, *,
              x: Places = None) -> Any:
        """The shear traction q at the distance u from an edge, or at x, as pressure() does.

        q is in the unit of the contact modulus, under full stick or, with friction, partial slip.
        Raises InputError for a scene without shear. For arrays of float see shears().
        """
        places, points = self._points(u, x, edge, "shear", (), digits)
        return _like(places, [row.q for row in points])

    @checked
    def slip_state(self, u: Places = None, edge: str = "right", digits: int | None = None, *,
                   x: Places = None) -> Any:
        """The state of the place at the distance u from an edge: "slip", "stick" or "undecided".

        A list of places gives a list. "undecided": the place is too near the end of the stick zone
        to decide. Raises InputError for a scene without friction.
        """
        self._needs_friction()
        places, points = self._points(u, x, edge, "shear", (), digits)
        return _like(places, [row.state for row in points])

    @checked
    def approximation(self, u: Places = None, terms: int | Sequence[int] = 1, edge: str = "right",
                      digits: int | None = None, *, x: Places = None) -> Any:
        """p at one place, and the sums of the first `terms` terms with their errors.

        The result is a Row: .p, and .p_local, a Row for each number of terms. Several places
        give Rows; for arrays of float see local_pressures(), relative_errors().
        """
        places, points = self._points(u, x, edge, "pressure", terms, digits)
        return Rows(points) if is_many(places) else points[0]

    @checked
    def peak(self, digits: int | None = None) -> Value:
        """The greatest pressure, in the unit of the contact modulus.

        Raises InputError if it is infinite (at a corner of the profile).
        """
        found = self._run(digits, quantities=["peak"]).contact["p_max"]
        assert found is not None
        return found

    def _coordinates(self, u: Any, edge: str) -> tuple[list[str], Callable[[int], Value] | None]:
        """Returns the places x at these distances: numbers, or formulas if the edge is not exact.

        With formulas, also the function that gives x as a Value.
        """
        if edge not in ("right", "left"):
            raise InputError(f"there is no edge '{edge}'", 'write "right" or "left"')
        contact = self.contact()
        right = edge == "right"
        end = contact.a if right else contact.b
        distances = texts(u, "u")
        if end.exact is not None:
            return [f"{end.exact} - ({d})" if right else f"({d}) - {end.exact}"
                    for d in distances], None
        return ([f"a - ({d})" if right else f"({d}) - b" for d in distances],
                lambda i: end - _edgeproof.given(distances[i], self.digits) if right else
                _edgeproof.given(distances[i], self.digits) - end)

    @checked
    def stress(self, x: Places = None, z: Places = 0, body: str = "A", digits: int | None = None, *,
               u: Places = None, edge: str = "right") -> Any:
        """The stresses at the depth z into a body below the place x: a Row, tension positive.

        x, z  lengths; x from the origin. Lists, or arrays, of the same length (or one of them a
              number) give Rows
        body  "A", on which Q acts, or "B"
        u     in place of x: distances inwards from the edge, if that is an exact number

        Stresses are in the unit of the contact modulus. Raises InputError for z < 0, for points at
        which a stress is infinite (under full stick the edges; corners of the
        profile). Of an axisymmetric contact x is the radius, sxx the radial stress and syy the
        hoop stress; shear raises InputError.
        """
        name, places = _given_places(u, x)
        if name == "x":
            across = texts(x, "x")
        else:
            across, formulas = self._coordinates(u, edge)
            if formulas is not None:
                raise InputError(f"the {edge} edge is not a number that is known exactly",
                                 "give the places by x")
        depths = texts(z, "z")
        count = max(len(across), len(depths))
        for given, argument in ((across, name), (depths, "z")):
            if len(given) not in (1, count):
                raise InputError(f"{argument} has {len(given)} numbers, not {count}",
                                 f"give as many x as z, or one {argument}")
        across, depths = (given * count if len(given) == 1 else given for given in (across, depths))
        many = is_many(places) or is_many(z)
        if many and not count:
            return Rows()
        found = self._run(digits, quantities=["stress"], points_x=across, points_z=depths,
                          body=body).stresses
        return found if many else found[0]

    @checked
    def greatest(self, stress: str = "mises", body: str = "A",
                 digits: int | None = None) -> Row:
        """The greatest "mises" or "tau_max" in a body, or "sxx" on its surface, and its place.

        Of a body of revolution the greatest on its axis; of a sphere nothing is greater off it.

        Raises InputError for a stress that is infinite or has no greatest value.
        """
        found = json.loads(self._native.greatest(stress, _is_B(body), digits or self.digits))
        return Row(stress=stress, **{k: value_of_state(found[k]) for k in ("value", "x", "z")},
                   notes=tuple(found["notes"]))

    @checked
    def stress_coefficients(self, angle: Number, terms: int = 3, edge: str = "right",
                            body: str = "A", digits: int | None = None) -> Rows:
        """The series of the stresses near an edge of a plane contact: Rows.

        angle  degrees, between the ray into the body and the surface of the contact: 0 to 180
        """
        asked: Any = [("edges", [edge]), ("terms", [str(terms)]),
                      ("digits", str(digits or self.digits))]
        terms_of = json.loads(self._native.stress_terms(asked, cast(str, angle), _is_B(body)))
        return Rows(Row(edge=of, halves=halves, **dict(zip(
            ("sxx", "szz", "sxz"), map(value_of_state, states)))) for of, halves, states in terms_of)

    @checked
    def displacement(self, x: Places = None, digits: int | None = None, *, u: Places = None,
                     edge: str = "right", reference: Number | None = None, body: str = "A") -> Any:
        """The gap between the surfaces at x outside the contact, or the slip inside.

        x is a length from the origin, or a formula in a and b ("a + 1/10"); in place of it, u is a
        distance inwards from an edge. The result is a Row; several places give Rows. Of an axisymmetric contact the slip is the mean over a circle (docs/axisymmetric.md).
        With a reference, a place x whose displacement is 0, the rows have the displacements of the
        surface of a body, "A" (on which Q acts) or "B", too. Raises InputError for curved slopes.
        """
        name, places = _given_places(u, x)
        every, x_of = self._coordinates(u, edge) if name == "u" else (texts(x, "x"), None)
        if not every:
            return Rows()
        asked: dict[str, Any] = {"quantities": ["displacement"]}
        if reference is not None:
            asked = {"quantities": ["displacement", "surface"], "body": body,
                     "reference": reference}
        found = self._run(digits, edges=["right"], x=every, **asked).displacements
        if x_of is not None:
            found = Rows(Row(**{**vars(row), "x": x_of(i)}) for i, row in enumerate(found))
        return found if is_many(places) else found[0]

    # At points, in binary64.

    def _many(self, quantity: str, terms: int, u: Any, x: Any,
              edge: str) -> numpy.typing.NDArray[numpy.float64]:
        name, places = _given_places(u, x)
        return self._native.binary64(quantity, terms, edge, name == "x", places)

    @checked
    def pressures(self, u: numpy.typing.ArrayLike | None = None, edge: str = "right", *,
                  x: numpy.typing.ArrayLike | None = None) -> numpy.typing.NDArray[numpy.float64]:
        """Pressures at a whole numpy array of distances from an edge, or of places x.

        The result has the shape of the array. Each is the binary64 nearest to the exact pressure at
        exactly that binary64 u or x. This is proved if the pressure has a closed form (power laws,
        piecewise linear g'); otherwise it relies on the error that the quadrature estimates at 25
        digits (by x: as for pressure()). The value is 0 at the edges and outside the contact (also
        for infinite u), and inf on a corner of the profile. Raises InputError, with the index, for
        NaN.
        """
        return self._many("p", 0, u, x, edge)

    @checked
    def shears(self, u: numpy.typing.ArrayLike | None = None, edge: str = "right", *,
               x: numpy.typing.ArrayLike | None = None) -> numpy.typing.NDArray[numpy.float64]:
        """Shear tractions at a whole numpy array of places, as pressures() does.

        Raises InputError for a scene without shear, and for places at which q is infinite: the
        edges under full stick, and corners of the profile.
        """
        return self._many("q", 0, u, x, edge)

    @checked
    def stresses(self, x: numpy.typing.ArrayLike, z: numpy.typing.ArrayLike,
                 body: str = "A") -> dict[str, numpy.typing.NDArray[numpy.float64]]:
        """The stresses at whole numpy arrays of places x and depths z of a body, in binary64.

        x and z are broadcast: x of shape (1, 1000) and z of shape (500, 1) give maps of 500 x 1000.
        The dict has arrays "sxx", "szz", "sxz", "tau_max", with a Poisson's ratio "mises", and
        "bound": a proved bound of the error of each value at the point, at most 1e-12 of the mean
        pressure P/(a + b), or 2^-52 of the value where it is large. Power laws, curved slopes and
        points on a knot take much longer than other points. Raises InputError as stress() does.
        """
        across, depths = imported("numpy").broadcast_arrays(x, z)
        return self._native.stresses(_is_B(body), across, depths,
                                     self._facts["mises"][_is_B(body)])

    @checked
    def local_pressures(self, u: numpy.typing.ArrayLike | None = None, terms: int = 1,
                        edge: str = "right", *, x: numpy.typing.ArrayLike | None = None
                        ) -> numpy.typing.NDArray[numpy.float64]:
        """Sums of the first `terms` terms of p at an edge, as pressures() does.

        Raises InputError for places that are not inside the contact.
        """
        return self._many("local", terms, u, x, edge)

    @checked
    def relative_errors(self, u: numpy.typing.ArrayLike | None = None, terms: int = 1,
                        edge: str = "right", *, x: numpy.typing.ArrayLike | None = None
                        ) -> numpy.typing.NDArray[numpy.float64]:
        """|1 - p_n/p| of the sums p_n of the first `terms` terms, as pressures() does.

        Raises InputError for places that are not inside the contact.
        """
        return self._many("rel", terms, u, x, edge)

    # At edges.

    def _expansion(self, terms: int, edge: str, digits: int | None) -> Row:
        return self._run(digits, edges=[edge], quantities=["coefficients"],
                         terms=[terms]).coefficients[0]

    @checked
    def coefficients(self, terms: int = 3, edge: str = "right",
                     digits: int | None = None) -> tuple[Value, ...]:
        """c_0 ... c_{terms-1} of p = sum c_k u^(k + 1/2) at an edge (at most 400 terms).

        c_k is in the unit of the contact modulus over length^(k + 1/2).
        """
        return self._expansion(terms, edge, digits).c

    @checked
    def shear_coefficients(self, terms: int = 3, edge: str = "right",
                           digits: int | None = None) -> Row:
        """The coefficients .s of q at an edge, from the power u^(.s_half_powers/2) on."""
        if not self.has_shear:
            raise InputError("the scene has no shear", "give Q or bulk_tension")
        return self._expansion(terms, edge, digits)

    @checked
    def extent(self, terms: int = 1, tolerance: Number = "1%", edge: str = "right",
               part: tuple[Number, Number] = (0, 1), process_zone: Number | None = None,
               digits: int | None = None) -> Row:
        """The extent from an edge over which the first `terms` terms are within a tolerance of p.

        tolerance     relative: "1%", "0.01", Fraction(1, 100)
        part          the examined part of the contact, as fractions of a + b from the edge
        process_zone  a length from the edge; the result states whether the extent covers it
        """
        return self._run(
            digits, edges=[edge], quantities=["extent"], terms=[terms],
            tolerance=tolerance,
            part=part,
            process_zone="" if process_zone is None else process_zone,
        ).extents[0]

    def _needs_friction(self) -> None:
        if not self.has_friction:
            raise InputError("the scene has no zones that slip and stick",
                             "give friction and Q, and no sliding")

    @checked
    def slip(self, edge: str = "right", terms: int | Sequence[int] = (1, 2, 3),
             tolerance: Number | None = None, digits: int | None = None) -> Row:
        """The slip zone at an edge, its approximations by n terms, and the stick zone: a Row.

        terms      numbers of terms of the series in |Q|/(friction P)
        tolerance  relative ("1%"): also find the load ratio up to which n terms are within it

        Q (and the bulk tension) are applied at constant P. Raises InputError for a scene without
        friction, for one that slides (|Q| >= friction P), and for a bulk tension with which an edge
        slips in the other direction.
        """
        self._needs_friction()
        return self._run(
            digits, edges=[edge], quantities=["slip"], terms=terms,
            tolerance="" if tolerance is None else tolerance).slips[0]

    # As a whole.

    @checked
    def run(self, digits: int | None = None) -> Result:
        """Answers all questions of the scene file ([ask])."""
        return self._run(digits)

    @checked
    def plot(self, terms: int | Sequence[int] = (1, 2), edge: str = "right",
             file: str | os.PathLike[str] | None = None, *, tolerance: Number | None = None,
             field: str | None = None, body: str = "A", ax: Axes | None = None) -> matplotlib.figure.Figure:
        """Plots the pressure with the sums of the first terms; their relative errors on log axes.

        tolerance  relative, at which the sums are marked; by default the scene's, or 1 %
        field      draws the contours of a stress of a body in their place: "sxx", "szz", "sxz",
                   "tau_max" or "mises"
        ax         matplotlib Axes for the first panel, or a list of Axes for several

        The pictures are those of `edgeproof plot`. Returns a matplotlib Figure, and writes it to
        `file` if one is given (.png, .pdf, .svg). Raises ImportError if matplotlib is missing.
        """
        from ._plot import plot

        figure = plot(self, terms, edge, tolerance, field or "", body, ax)
        if file is not None:
            figure.savefig(file)
        return figure
