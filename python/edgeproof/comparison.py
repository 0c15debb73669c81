# SPDX-License-Identifier: BSD-3-Clause
"""Compares results of meshes, x and p, with the exact contact."""

from __future__ import annotations

import copy
import dataclasses
import decimal
import fractions
import json
import math
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Union, cast

from . import _edgeproof
from ._arguments import checked, mapping, read_as, READERS
from ._numbers import exact_text, text
from .errors import InputError
from .profiles import Number
from .results import Row, row_of
from .scene import Scene, read_scene

if TYPE_CHECKING:
    import numpy.typing

__all__ = ["Comparison", "compare"]

OneResult = Union[str, "os.PathLike[str]", "tuple[numpy.typing.ArrayLike, numpy.typing.ArrayLike]"]


@dataclasses.dataclass(frozen=True)
class Comparison:
    """Results compared with a scene. len(), iteration over the files; print() shows the report.

    passed  True if every file is within the tolerances
    orders  for several meshes: for each quantity, the slope of log |error| over log width; None if
            there is no slope
    routes  for each quantity, how the exact value was computed
    text    the report that `edgeproof compare` prints
    files   a Row for each result, in binary64 and the scene's units:

    inside, outside  the number of nodes inside and outside the exact contact
    sign, origin     how the data were read: -1 if compression is negative; the x of the data at
                     the scene's origin
    findings         how the file was read, in sentences
    a, b, P, p_max, c0, c1, c0_left, c1_left  edges, force, the largest pressure, coefficients of
                     u^(1/2) and u^(3/2): .data, an estimate (None if the data do not determine it),
                     .exact, .of_exact_pressure, the result of the same rule for the exact pressure
                     at the same nodes, and .spread, an estimate of the error of a fit
    element          widths of the elements at the "right" and "left" edge, and the "mean" one
    errors           of p at nodes outside the edge zones; all_errors: at all nodes. .peak, the
                     largest |error|, relative to the exact peak (or the mean p, with a corner),
                     .local, the largest |error/p|, .l2, the L2 norm relative to that of p,
                     .median_local, .digits, the right digits, .nodes
    distances, knots errors by decades of u/(a + b) (.edge, .from_, .to), and near knots (.x, .corner)
    causes           mistakes that would explain the difference, the likeliest first; none is
                     proved: .name ("e-for-e-star"), .what, .factor, the median of data over exact
                     pressure, .scatter, what remains, relative to the largest pressure,
                     .equally_likely, names of others after which as little remains
    failures         the reasons why it does not pass, in sentences
    """

    passed: bool
    tolerance: str
    units: str | None
    routes: dict[str, str]
    files: tuple[Row, ...]
    orders: dict[str, float | None]
    text: str = dataclasses.field(repr=False)
    _data: dict[str, Any] = dataclasses.field(repr=False, compare=False)

    def __len__(self) -> int:
        return len(self.files)

    def __iter__(self) -> Any:
        return iter(self.files)

    def __getitem__(self, index: int) -> Row:
        return self.files[index]

    def __str__(self) -> str:
        return self.text

    def to_dict(self) -> dict[str, Any]:
        """The content of `edgeproof compare --json`."""
        return copy.deepcopy(self._data)


def _result_of(d: dict[str, Any]) -> Row:
    renamed = {"passes": "passed", "errors_of_all_nodes": "all_errors", "from": "from_"}

    def with_names(data: Any) -> Any:
        if isinstance(data, dict):
            return {renamed.get(key, key): with_names(item) for key, item in data.items()}
        return list(map(with_names, data)) if isinstance(data, list) else data

    return row_of(with_names(d))  # type: ignore[no-any-return]


def _is_file(result: Any) -> bool:
    return isinstance(result, (str, os.PathLike))


def _is_pair(result: Any) -> bool:
    return isinstance(result, tuple) and len(result) == 2 and not any(map(_is_file, result))


def _written(x: Iterable[Any], p: Iterable[Any], name: str) -> str:
    rows = [[float(v) for v in x], [float(v) for v in p]]
    if len(rows[0]) != len(rows[1]):
        raise InputError(f"{name}: {len(rows[0])} places and {len(rows[1])} pressures",
                         "give a pressure for each place")
    for column, what in zip(rows, "xp"):
        for i, value in enumerate(column):
            if not math.isfinite(value):
                raise InputError(f"{name}: {what}[{i}] = {value} is not a finite number",
                                 "give numbers, and leave out nodes that have none")
    lines = [f"{decimal.Decimal(a)},{decimal.Decimal(b)}\n" for a, b in zip(*rows)]
    return "x,p\n" + "".join(lines)


def _tables(results: Any, name: str) -> list[tuple[str, str]]:
    if _is_file(results) or _is_pair(results):
        results = [results]
    if isinstance(results, Mapping) or not hasattr(results, "__iter__"):
        raise TypeError(f"{name} is {type(results).__name__}: give a file, or a tuple (x, p) of "
                        "two arrays")
    many = list(results)
    if not many:
        raise InputError("there is no result", "give a file, or (x, p)")
    tables = []
    for i, result in enumerate(many):
        if _is_file(result):
            file = READERS["str | os.PathLike[str]"](result, "a result")
            tables.append((_edgeproof.read_text(file, "result (a table of x and p)"), file))
        elif _is_pair(result):
            name = "(x, p)" if len(many) == 1 else f"result {i + 1}"
            x, p = result
            tables.append((_written(x, p, name), name))
        else:
            raise TypeError(f"a result is {type(result).__name__}: give a file, or a tuple (x, p) "
                            "of two arrays; a list of these for finer and finer meshes")
    return tables


def _columns(given: Any, name: str) -> str:
    if isinstance(given, str):
        return text(given, name)
    return ",".join(f"{k}={exact_text(v, k)}" for k, v in mapping(given, name).items())


def _scale(given: Any, name: str) -> str:
    if isinstance(given, str):
        return text(given, name)
    return ",".join(f"{k}={_decimal_text(v, f'{name}[{k!r}]')}"
                    for k, v in mapping(given, name).items())


def _decimal_text(value: Any, name: str) -> str:
    """Returns a number without a quotient, for a table of numbers."""
    number = exact_text(value, name)
    if "/" not in number or isinstance(value, str):
        return number
    ratio = fractions.Fraction(number)
    try:
        with decimal.localcontext() as context:
            context.prec = 1100  # enough for every binary64
            context.traps[decimal.Inexact] = True
            return str(decimal.Decimal(ratio.numerator) / ratio.denominator)
    except decimal.Inexact:
        raise InputError(f"{name} = {number} is no decimal number", "give one that ends") from None


def _scene(given: Any, name: str) -> Scene:
    return given if isinstance(given, Scene) else read_scene(given)


AScene = Union[Scene, str, "os.PathLike[str]"]
Results = Union[OneResult, Sequence[OneResult]]
Columns = Union[str, Mapping[str, Union[str, int]]]
Scale = Union[str, Mapping[str, Number]]
Length = Number
for _kind, _reader in (("AScene", _scene), ("Results", _tables), ("Columns", _columns),
                       ("Scale", _scale), ("Length", _decimal_text)):
    read_as(_kind, _reader)


@checked
def compare(scene: AScene, results: Results, *, columns: Columns | None = None,
            scale: Scale | None = None, origin: Number | None = None,
            tolerance: Number | None = None, of: str = "peak", edge_zone: Length = 0,
            tolerance_a: Number | None = None, tolerance_P: Number | None = None,
            tolerance_c0: Number | None = None, partial: bool = False,
            progress: Callable[[int, int], object] | None = None) -> Comparison:
    """Compares the results of a mesh, x and p at its nodes, with the exact contact.

    scene      a Scene, a scene file, or the name of one that came with the program
    results    a table that a program wrote (docs/compare.md lists the formats), or a tuple (x, p)
               of two arrays of float; a list of these, for finer and finer meshes, gives orders,
               too
    columns    {"x": 1, "p": "CPRESS"}: the columns, by number or name; None: found by their names
    scale      {"x": "1e-3", "p": "1e6"}: factors for the numbers of the files
    origin     the x of the data at the scene's origin; "auto": fitted to the data; None: 0
    tolerance  of p ("1%"; None: 3 %), relative to `of`: the "peak", p itself ("local"), or "L2"
    edge_zone  the zone at each edge that is left out: "2e" (elements), or a length
    tolerance_a, tolerance_P, tolerance_c0  tolerances of a and b, P, c_0
    partial    True: the data cover a part of the contact; p is compared at their nodes, although
               they do not determine a, b, P and the largest p

    x and p are in the units of the scene, unless a file states its own. Edges, fits and orders of
    the data are estimates. Raises InputError, with file and line, for malformed files; wrong data
    never raise an exception.
    """
    asked = cast(Scene, scene)
    options: Any = {
        "columns": columns, "scale": scale, "origin": origin, "tolerance": tolerance, "of": of,
        "edge_zone": edge_zone, "tolerance_a": tolerance_a, "tolerance_P": tolerance_P,
        "tolerance_c0": tolerance_c0, "partial": "yes" if partial else None}
    found = _edgeproof.compare(
        progress, asked._native, asked.file or asked.title or "a scene", cast(Any, results),
        {key: value for key, value in options.items() if value is not None})
    data = json.loads(found.json)
    return Comparison(
        passed=data["passes"], tolerance=data["tolerance"], units=data["units"],
        routes=data["routes"], files=tuple(map(_result_of, data["files"])), orders=data["orders"],
        text=found.text, _data=data)
