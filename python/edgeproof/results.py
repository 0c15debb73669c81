# SPDX-License-Identifier: BSD-3-Clause
"""The results of a scene as plain objects. All have to_dict()."""

from __future__ import annotations

import itertools
import json
from collections.abc import Iterable, Iterator, Mapping
from typing import Any, NamedTuple, TypeVar

from ._arguments import checked
from ._columns import columns
from ._edgeproof import Value, value_of_state
from ._value import shortened
from .errors import InputError

__all__ = ["Result", "Row", "Rows"]


def plain(value: Any) -> Any:
    """Converts values and results to dicts and lists, to any depth."""
    if isinstance(value, Value):
        return value.to_dict()
    if isinstance(value, Row):
        return plain(vars(value))
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


class Row:
    """A result: contents by name, as attributes. str() shows them with their bounds.

    Most contents are Values: lengths, forces per unit length, stresses in the unit of the contact
    modulus. What was not asked for, or does not exist, is None or empty.

    contact()   a, b, P, M, alpha (the tilt that was found, radians). Of an axisymmetric contact P
                is the total force, M is None, and there are delta, the approach of the bodies,
                and stiffness, dP/d delta
    points      edge, u (a text), x, p, q; p_local and q_local, a row for each number of terms, with
                terms, value (the sum) and relative_error, |1 - sum/exact|; with friction state,
                "slip" (|q| = friction p), "stick" or "undecided"
    stress()    body ("A", on which Q acts, or "B"), the place x and the depth z (texts); sxx, szz,
                sxz, tau_max (the greatest shear stress in the plane); with a Poisson's ratio, in
                plane strain: mises, syy, the principal stresses s1 >= s2 >= s3, tresca (s1 - s3)
    greatest()  stress, value, its place x and z, notes about it
    stress_coefficients()  edge, halves, and the coefficients of r^(halves/2) in sxx, szz and sxz at
                the distance r from the edge
    displacement()  x (a text; a Value if u was given); gap, outside the contact; slip, u_A - u_B,
                inside. With a reference ux, uz and slope: the displacement of the surface of a body
                along x and into the body, less that of the reference, and duz/dx; dissipation: the
                energy that friction takes, per area, in a cycle from -Q to Q and back
    coefficients  edge; c, of p = sum of c[k] u^(k + 1/2); s, of q = sum of
                s[k] u^(k + s_half_powers/2); s_half_powers: -1 under full stick, 1 if q is similar
                to p
    extent()    edge, terms; first_exit, the distance at which the relative error first reaches the
                tolerance, or the end of the examined part if it does not (leaves is False); measure,
                the length of all places within the tolerance; both as fractions of a + b
                (first_exit_fraction, measure_fraction); crossings, every distance at which the error
                passes through the tolerance; covers_zone: whether first_exit lies beyond the process
                zone
    slip()      edge; size of the slip zone; terms, a row for each number of terms of the series in
                Q/(friction P), with terms, size, relative_error and load_limit, the |Q|/(friction P)
                up to which that error stays within the tolerance at constant P and bulk_tension/Q (1
                if it does up to full sliding, leaves is False); stick, a row of the zone -b < x < a
                that sticks: load_ratio, |Q|/(friction P); a, b; least_bulk_tension and
                most_bulk_tension, between which both edges slip in the direction of Q (None: not
                found); cycle_energy, the energy per unit length that friction dissipates in a cycle
                from -Q to Q and back at constant P; in_proportion: whether Q and the bulk tension may
                grow in proportion (False: Q must be first)
    """

    def __init__(self, **contents: Any) -> None:
        vars(self).update(contents)

    def __getattr__(self, name: str) -> Any:
        raise AttributeError(f"this row has no {name}; it has {', '.join(vars(self))}")

    def __getitem__(self, name: str) -> Any:
        return vars(self)[name]

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError("a result is not changed")

    def __eq__(self, other: object) -> bool:
        return vars(self) == vars(other) if isinstance(other, Row) else NotImplemented

    def __str__(self) -> str:
        return _shown(vars(self))

    def __repr__(self) -> str:
        return f"<edgeproof.{type(self).__name__} {self}>"

    def to_dict(self) -> dict[str, Any]:
        """The same as a dict of str, int, bool, list, dict and None, to any depth."""
        return {name: plain(content) for name, content in vars(self).items()}


def row_of(data: Any) -> Any:
    """Makes rows of the objects of JSON, and tuples of its lists, to any depth."""
    if isinstance(data, dict):
        return Row(**{key: row_of(item) for key, item in data.items()})
    return tuple(map(row_of, data)) if isinstance(data, list) else data


class Rows(tuple[Row, ...]):
    """Results of one kind, a tuple. columns() makes a data frame of them."""

    __slots__ = ()

    def __str__(self) -> str:
        return "\n".join(map(str, self))

    def columns(self) -> dict[str, Any]:
        """The rows as a dict of numpy arrays of the same length: pandas.DataFrame(rows.columns()).

        A value is the binary64 nearest to it, in a column of its name, and |that number - exact| is
        at most the number in the column NAME_bound. A missing value is NaN. Coefficients are c_0,
        c_1, ..., the sums of n terms local_n, their relative errors rel_n (of q: q_local_n,
        q_rel_n), as in the tables of the program.
        """
        return columns(self)


class Result(Row):
    """The answers to the questions of a scene file, in their order, edge by edge.

    contact  a mapping of Values
    points, coefficients, extents, slips, stresses, displacements  Rows
    proved   True if all values are enclosures
    """

    @checked
    def columns(self, of: str = "points") -> dict[str, Any]:
        """The rows of "points", "coefficients", "extents", "slips", "stresses" or "displacements".

        The result is a dict of numpy arrays; see Rows.columns().
        """
        rows = vars(self).get(of)
        if not isinstance(rows, Rows):
            raise InputError(f"a result has no rows '{of}'",
                             "write points, coefficients, extents, slips, stresses or displacements")
        return rows.columns()


class _Answer(NamedTuple):
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

    def __init__(self, rows: Iterable[_Answer]) -> None:
        self.rows = list(rows)
        self._row: dict[tuple[str, int, int], _Answer] = {}
        for row in self.rows:
            self._row.setdefault((row.quantity, row.k, row.j), row)

    def value(self, quantity: str, k: int = 0, j: int = 0) -> Any:
        """The value, or None if there is none."""
        row = self._row.get((quantity, k, j))
        return None if row is None else row.value

    def of(self, quantity: str) -> Iterator[_Answer]:
        return (row for row in self.rows if row.quantity == quantity)

    def values(self, quantity: str) -> tuple[Any, ...]:
        return tuple(row.value for row in self.of(quantity))

    def crossings(self, k: int) -> tuple[Any, ...]:
        return tuple(row.value for key, row in self._row.items() if key[:2] == ("crossing", k))

    def sums(self, quantity: str, error: str) -> tuple[Row, ...]:
        return tuple(Row(terms=row.k, value=self.value(quantity, row.k),
                         relative_error=self.value(error, row.k)) for row in self.of(quantity))

    def row(self, quantities: str, **contents: Any) -> Row:
        """Returns a row of these quantities, behind other contents."""
        return Row(**contents, **{name: self.value(name) for name in quantities.split()})


def _point(at: _Place) -> Row:
    u: Any = at.value("u")
    if u is None:
        u = at.rows[0].u
    return Row(
        edge=at.rows[0].edge, u=u, x=at.value("x"), p=at.value("p"),
        p_local=at.sums("local", "rel"), q=at.value("q"),
        q_local=at.sums("q_local", "q_rel"),
        state=next((row.state for row in at.of("q")), None))


def _extent(at: _Place, row: _Answer) -> Row:
    def value(quantity: str) -> Any:
        return at.value(quantity, row.k)

    return Row(edge=row.edge, terms=row.k, leaves=row.reached, first_exit=value("extent"),
               measure=value("measure"), first_exit_fraction=value("extent_fraction"),
               measure_fraction=value("measure_fraction"), crossings=at.crossings(row.k),
               covers_zone=row.covers_zone)


def _slip(at: _Place, stick: Row) -> Row:
    terms = tuple(Row(terms=row.k, size=at.value("slip_terms", row.k),
                      relative_error=at.value("slip_rel", row.k), load_limit=row.value,
                      leaves=row.reached) for row in at.of("slip_load"))
    return Row(edge=at.rows[0].edge, size=at.value("slip"), terms=terms, stick=stick)


def _row(cells: list[Any]) -> _Answer:
    row = _Answer(*cells)
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
    stick = Row(
        load_ratio=whole.value("load_ratio"), a=whole.value("stick_a"), b=whole.value("stick_b"),
        least_bulk_tension=whole.value("least_tension"),
        most_bulk_tension=whole.value("most_tension"), cycle_energy=whole.value("cycle_energy"),
        in_proportion=found["in_proportion"])
    contact = {name: whole.value(name) for name in ("a", "b", "P", "M", "alpha")}
    contact |= {name: whole.value(name) for name in ("delta", "stiffness", "p_max")
                if whole.value(name) is not None}
    in_bodies = found["points"]
    return Result(
        contact=contact,
        points=Rows(_point(_Place(group)) for _, group in points),
        coefficients=Rows(
            Row(edge=at.rows[0].edge, c=at.values("c"), s=at.values("s"),
                s_half_powers=found["s_half_powers"]) for at in edges("c", "s")),
        extents=Rows(
            _extent(at, row) for at in edges("extent", "measure", "extent_fraction",
                                             "measure_fraction", "crossing")
            for row in at.of("extent")),
        slips=Rows(_slip(at, stick) for at in edges(
            "slip", "slip_terms", "slip_rel", "slip_load")),
        proved=found["proved"],
        stresses=Rows(
            at.row("sxx szz sxz mises tau_max syy s1 s2 s3 tresca",
                   **dict(zip(("body", "x", "z"), in_bodies[i]))) for i, at in at_places("body")),
        displacements=Rows(
            at.row("ux uz slope dissipation", x=found["places"][i], gap=at.value("gap"),
                   slip=at.value("slip_displacement")) for i, at in at_places("surface")),
    )
