# SPDX-License-Identifier: GPL-3.0-or-later
"""The results of a scene as plain objects. All have to_dict()."""

from __future__ import annotations

import dataclasses
import itertools
import json
from collections.abc import Iterable, Iterator, Mapping
from typing import Any, NamedTuple, TypeVar

from ._arguments import checked
from ._columns import columns
from ._edgeproof import Value, value_of_state
from ._value import shortened
from .errors import InputError

__all__ = ["Approximation", "Contact", "Coefficients", "Displacement", "Extent", "Greatest",
           "Point", "Result", "Rows", "Slip", "SlipTerms", "StickZone", "Stress", "StressTerm"]


def plain(value: Any) -> Any:
    """Converts values and results to dicts and lists, to any depth."""
    if isinstance(value, Value):
        return value.to_dict()
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        return {f.name: plain(getattr(value, f.name)) for f in dataclasses.fields(value)}
    if isinstance(value, (list, tuple)):
        return [plain(item) for item in value]
    if isinstance(value, Mapping):
        return {key: plain(item) for key, item in value.items()}
    return value


def _shown(value: Any) -> str:
    if isinstance(value, Value):
        return shortened(value.text) + ("" if value.bound == "0" else f" +- {value.bound}")
    if isinstance(value, tuple):
        return "[" + "; ".join(map(_shown, value)) + "]"
    if isinstance(value, Mapping):
        return ", ".join(f"{key} = {_shown(item)}" for key, item in value.items()
                         if item is not None and item != ())
    return str(value)


class _Plain:
    def __str__(self) -> str:
        """The fields with their values and bounds in one line; what is not there is left out."""
        return _shown(vars(self))

    def to_dict(self) -> dict[str, Any]:
        """The same as a dict of str, int, bool, list, dict and None, to any depth."""
        result = plain(self)
        assert isinstance(result, dict)
        return result


_Kind = TypeVar("_Kind", covariant=True)


class Rows(tuple[_Kind, ...]):
    """Results of one kind, a tuple. columns() makes a data frame of them."""

    __slots__ = ()

    def __str__(self) -> str:
        return "\n".join(map(str, self))

    def columns(self) -> dict[str, Any]:
        """The rows as a dict of numpy arrays of the same length: pandas.DataFrame(rows.columns()).

        A value is the binary64 nearest to it, in a column of its name, and |that number - exact| is
        at most the number in the column NAME_bound. A missing value is NaN. Coefficients are c_0,
        c_1, ..., the sums of n terms local_n, their relative errors rel_n (of q: q_local_n,
        q_rel_n), as in the tables of the program. Raises ImportError if numpy is missing.
        """
        return columns(self)


@dataclasses.dataclass(frozen=True)
class Approximation(_Plain):
    """The sum of the first `terms` terms of an expansion at a point.

    value           the sum
    relative_error  |1 - sum/exact|
    """

    terms: int
    value: Value
    relative_error: Value


@dataclasses.dataclass(frozen=True)
class Contact(_Plain):
    """The contact -b < x < a, its force and moment per unit length, and the tilt if it was found.

    a, b   lengths
    P      normal force per unit length
    M      moment about the origin per unit length
    alpha  radians; None if the tilt is given, or there is none

    Of an axisymmetric contact, P is the total force, M is None, delta is the approach of the
    bodies (a length), and stiffness is dP/d delta.
    """

    a: Value
    b: Value
    P: Value
    M: Value
    alpha: Value | None
    delta: Value | None = None
    stiffness: Value | None = None


@dataclasses.dataclass(frozen=True)
class Point(_Plain):
    """A place and its tractions: u inwards from an edge; p and q in units of the contact modulus.

    p_local and q_local have an Approximation for each number of terms asked for. Quantities that
    were not asked for are None, or empty. With friction, state is "slip" (|q| = friction p), "stick", or "undecided" if the
    place is too near the end of the stick zone to decide.
    """

    edge: str
    u: str
    x: Value
    p: Value | None
    p_local: tuple[Approximation, ...]
    q: Value | None
    q_local: tuple[Approximation, ...]
    state: str | None = None


@dataclasses.dataclass(frozen=True)
class Stress(_Plain):
    """The stresses at the depth z into a body, in the unit of the contact modulus; tension positive.

    x, z           exact lengths, as texts: x from the origin along the surface
    body           "A", on which Q acts, or "B"
    sxx, szz, sxz  the components in the plane
    tau_max        the greatest shear stress in the plane
    mises          the equivalent stress of von Mises in plane strain
    syy            the stress across the plane, in plane strain
    s1, s2, s3     the principal stresses in plane strain, s1 >= s2 >= s3
    tresca         the equivalent stress of Tresca, s1 - s3

    mises and what follows it here are None without a Poisson's ratio.
    """

    body: str
    x: str
    z: str
    sxx: Value
    szz: Value
    sxz: Value
    mises: Value | None
    tau_max: Value
    syy: Value | None
    s1: Value | None
    s2: Value | None
    s3: Value | None
    tresca: Value | None


@dataclasses.dataclass(frozen=True)
class Greatest(_Plain):
    """The greatest value of a stress in a body, at the place x and the depth z; all are proved.

    notes  sentences about the place
    """

    stress: str
    value: Value
    x: Value
    z: Value
    notes: tuple[str, ...]


@dataclasses.dataclass(frozen=True)
class StressTerm(_Plain):
    """The coefficients of r^(halves/2) in the stresses at the distance r from an edge."""

    edge: str
    halves: int
    sxx: Value
    szz: Value
    sxz: Value


@dataclasses.dataclass(frozen=True)
class Displacement(_Plain):
    """The gap between the surfaces outside the contact, or the slip u_A - u_B inside; lengths.

    x     the place, from the origin: a text; a Value if the place was given by its distance u
    gap   None inside the contact
    slip  None outside the contact, and for a scene without shear
    ux, uz, slope  with a reference: the displacement of the surface of a body along x and into
          the body, less that of the reference, and duz/dx
    dissipation    with a reference: the energy that friction takes, per area, in a cycle from -Q to
          Q and back; None outside the contact, and without friction
    """

    x: str | Value
    gap: Value | None
    slip: Value | None
    ux: Value | None = None
    uz: Value | None = None
    slope: Value | None = None
    dissipation: Value | None = None


@dataclasses.dataclass(frozen=True)
class Coefficients(_Plain):
    """Coefficients of the expansions at an edge.

    c              p = sum of c[k] u^(k + 1/2)
    s              q = sum of s[k] u^(k + s_half_powers/2); empty without shear
    s_half_powers  -1 under full stick, 1 if q is similar to p
    """

    edge: str
    c: tuple[Value, ...]
    s: tuple[Value, ...]
    s_half_powers: int


@dataclasses.dataclass(frozen=True)
class Extent(_Plain):
    """The extent from an edge over which the first `terms` terms of p stay within a tolerance.

    first_exit           the distance at which the relative error first reaches the tolerance; the
                         end of the examined part if it does not (leaves is False)
    measure              the total length of the places within the tolerance
    first_exit_fraction  first_exit as a fraction of a + b
    measure_fraction     measure as a fraction of a + b
    crossings            every distance at which the error passes through the tolerance
    covers_zone          True if the first exit lies beyond the process zone; None without a zone
    """

    edge: str
    terms: int
    leaves: bool
    first_exit: Value
    measure: Value
    first_exit_fraction: Value
    measure_fraction: Value
    crossings: tuple[Value, ...]
    covers_zone: bool | None


@dataclasses.dataclass(frozen=True)
class StickZone(_Plain):
    """The zone -b < x < a that sticks under P, Q and the bulk tension; outside, |q| = friction p.

    load_ratio          |Q|/(friction P)
    a, b                lengths, from the origin
    least_bulk_tension  between this and most_bulk_tension (in the unit of the contact modulus) both
                        edges slip in the direction of Q; other scenes are refused. None if the
                        bound was not found
    cycle_energy        energy per unit length that friction dissipates in a cycle from -Q to Q and
                        back at constant P (the whole energy of an axisymmetric contact with a Poisson's
                        ratio); None with a bulk tension, with curved slopes, or if none was found
    in_proportion       True: Q and the bulk tension may grow in proportion; False: Q must be first
    """

    load_ratio: Value
    a: Value
    b: Value
    least_bulk_tension: Value | None
    most_bulk_tension: Value | None
    cycle_energy: Value | None
    in_proportion: bool


@dataclasses.dataclass(frozen=True)
class SlipTerms(_Plain):
    """The approximation of a slip zone by the first `terms` terms of the series in Q/(friction P).

    size            a length
    relative_error  |1 - size/exact|
    load_limit      the |Q|/(friction P) up to which that error stays within the tolerance, at
                    constant P and bulk_tension/Q; 1 if it does up to full sliding (leaves is
                    False). None without a tolerance, or if it is undecided
    """

    terms: int
    size: Value
    relative_error: Value
    load_limit: Value | None
    leaves: bool


@dataclasses.dataclass(frozen=True)
class Slip(_Plain):
    """The slip zone at an edge.

    size   its length, from the edge inwards
    terms  SlipTerms, one for each number of terms asked for
    stick  the zone that sticks: a StickZone
    """

    edge: str
    size: Value
    terms: tuple[SlipTerms, ...]
    stick: StickZone


@dataclasses.dataclass(frozen=True)
class Result(_Plain):
    """The answers to the questions of a scene file, in their order, edge by edge.

    proved  True if all values are enclosures
    """

    contact: Mapping[str, Value | None]
    points: Rows[Point]
    coefficients: Rows[Coefficients]
    extents: Rows[Extent]
    slips: Rows[Slip]
    proved: bool
    stresses: Rows[Stress] = Rows()
    displacements: Rows[Displacement] = Rows()

    @checked
    def columns(self, of: str = "points") -> dict[str, Any]:
        """The rows of "points", "coefficients", "extents", "slips", "stresses" or "displacements".

        The result is a dict of numpy arrays; see Rows.columns().
        """
        rows = getattr(self, of, None)
        if not isinstance(rows, Rows):
            raise InputError(f"a result has no rows '{of}'",
                             "write points, coefficients, extents, slips, stresses or displacements")
        return rows.columns()


class Row(NamedTuple):
    """One asked value with its result, as the compiled module returns it.

    k, j      the order or the number of terms, and the index of a crossing
    place     "contact", "edge", "point", "body" (a point of a body) or "surface" (a place x)
    point     the index of the place in the request, and u its distance from the edge if that is a
              number; None if the quantity has no place
    reached   of a search for a tolerance: False if the error stays within it
    """

    quantity: str
    k: int
    j: int
    place: str
    edge: str
    point: int | None
    u: str | None
    value: Value | None
    reached: bool
    state: str | None
    covers_zone: bool | None


class _Place:
    """The rows of one edge or point."""

    def __init__(self, rows: Iterable[Row]) -> None:
        self.rows = list(rows)
        self._row: dict[tuple[str, int, int], Row] = {}
        for row in self.rows:
            self._row.setdefault((row.quantity, row.k, row.j), row)

    def value(self, quantity: str, k: int = 0, j: int = 0) -> Any:
        """The value, or None if there is none."""
        row = self._row.get((quantity, k, j))
        return None if row is None else row.value

    def of(self, quantity: str) -> Iterator[Row]:
        return (row for row in self.rows if row.quantity == quantity)

    def values(self, quantity: str) -> tuple[Any, ...]:
        return tuple(row.value for row in self.of(quantity))

    def crossings(self, k: int) -> tuple[Any, ...]:
        return tuple(row.value for key, row in self._row.items() if key[:2] == ("crossing", k))

    def sums(self, quantity: str, error: str) -> tuple[Approximation, ...]:
        return tuple(Approximation(row.k, self.value(quantity, row.k), self.value(error, row.k))
                     for row in self.of(quantity))


def _point(at: _Place) -> Point:
    u: Any = at.value("u")
    if u is None:
        u = at.rows[0].u
    return Point(
        edge=at.rows[0].edge, u=u, x=at.value("x"), p=at.value("p"),
        p_local=at.sums("local", "rel"), q=at.value("q"),
        q_local=at.sums("q_local", "q_rel"),
        state=next((row.state for row in at.of("q")), None))


def _extent(at: _Place, row: Row) -> Extent:
    def value(quantity: str) -> Any:
        return at.value(quantity, row.k)

    return Extent(row.edge, row.k, row.reached, value("extent"), value("measure"),
                  value("extent_fraction"), value("measure_fraction"), at.crossings(row.k),
                  row.covers_zone)


def _slip(at: _Place, stick: StickZone) -> Slip:
    terms = tuple(SlipTerms(row.k, at.value("slip_terms", row.k),
                            at.value("slip_rel", row.k), row.value, row.reached)
                  for row in at.of("slip_load"))
    return Slip(at.rows[0].edge, at.value("slip"), terms, stick)


def _row(cells: list[Any]) -> Row:
    row = Row(*cells)
    return row if cells[7] is None else row._replace(value=value_of_state(cells[7]))


def result_of(answers: str) -> Result:
    """Makes the objects of a result from the answers of the compiled module (JSON)."""
    found = json.loads(answers)
    every = [_row(cells) for cells in found["rows"]]
    rows = [row for row in every if row.place not in ("body", "surface")]
    whole = _Place(rows)

    def at_places(place: str) -> Iterator[tuple[int, _Place]]:
        asked = (row for row in every if row.place == place)
        for point, group in itertools.groupby(asked, lambda row: row.point):
            assert point is not None
            yield point, _Place(group)

    def edges(*quantities: str) -> list[_Place]:
        asked = [row for row in rows if row.quantity in quantities]
        return [_Place(group) for _, group in itertools.groupby(asked, lambda row: row.edge)]

    points = itertools.groupby((row for row in rows if row.point is not None),
                               lambda row: (row.edge, row.point))
    stick = StickZone(
        whole.value("load_ratio"), whole.value("stick_a"), whole.value("stick_b"),
        whole.value("least_tension"), whole.value("most_tension"),
        whole.value("cycle_energy"), found["in_proportion"])
    contact = {name: whole.value(name) for name in ("a", "b", "P", "M", "alpha")}
    contact |= {name: whole.value(name) for name in ("delta", "stiffness", "p_max")
                if whole.value(name) is not None}
    in_bodies = found["points"]
    return Result(
        contact=contact,
        points=Rows(_point(_Place(group)) for _, group in points),
        coefficients=Rows(
            Coefficients(at.rows[0].edge, at.values("c"), at.values("s"), found["s_half_powers"])
            for at in edges("c", "s")),
        extents=Rows(
            _extent(at, row) for at in edges("extent", "measure", "extent_fraction",
                                             "measure_fraction", "crossing")
            for row in at.of("extent")),
        slips=Rows(_slip(at, stick) for at in edges(
            "slip", "slip_terms", "slip_rel", "slip_load")),
        proved=found["proved"],
        stresses=Rows(
            Stress(*in_bodies[i], *(at.value(name) for name in (
                "sxx", "szz", "sxz", "mises", "tau_max", "syy", "s1", "s2", "s3", "tresca")))
            for i, at in at_places("body")),
        displacements=Rows(
            Displacement(found["places"][i], *(at.value(name) for name in (
                "gap", "slip_displacement", "ux", "uz", "slope", "dissipation")))
            for i, at in at_places("surface")),
    )
