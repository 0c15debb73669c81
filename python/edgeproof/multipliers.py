# SPDX-License-Identifier: BSD-3-Clause
"""Finds polynomial relations between the multipliers of both edges that hold for every profile."""

from __future__ import annotations

import copy
import dataclasses
import json
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from . import _apart, _edgeproof
from ._arguments import checked
from .errors import InputError
from .results import Row, row_of

__all__ = ["Relations", "relations"]


@dataclasses.dataclass(frozen=True)
class Relations:
    """Relations between quantities. len(), iteration, relations[0].

    relations  Rows of degree and relation, an equation such as "b1*left.c0 - right.c0 = 0", proved
               symbolically; sorted by degree; none follows from those before it by division by leading terms
    complete   True: every relation up to `degree` is a sum of multiples of these (without any,
               there is no relation), proved by the rank of exact samples; False: a candidate was
               not proved
    monomials  the number of monomials up to that degree
    notes      what is proved, in sentences
    """

    quantities: tuple[str, ...]
    degree: int
    relations: tuple[Row, ...]
    complete: bool
    monomials: int
    notes: tuple[str, ...] = dataclasses.field(repr=False)
    _data: dict[str, Any] = dataclasses.field(repr=False, compare=False)

    def __len__(self) -> int:
        return len(self.relations)

    def __iter__(self) -> Iterator[Row]:
        return iter(self.relations)

    def __getitem__(self, index: int) -> Row:
        return self.relations[index]

    def __str__(self) -> str:
        return "\n".join([*map(str, self.relations), *self.notes])

    def to_dict(self) -> dict[str, Any]:
        """The content of `edgeproof relations --format json`."""
        return copy.deepcopy(self._data)


@checked
def relations(quantities: Sequence[str], degree: int = 4, *, symmetric: bool = False,
              given: Mapping[str, str] | None = None, free: Sequence[str] = ()) -> Relations:
    """Finds all polynomial relations with rational coefficients between quantities.

    quantities  formulas in a, b, L (a + b), P1, P2, ..., b1, b2, ... (derivatives by a), the
                multipliers "right.c0", "left.c0", ... of p and "right.s0", ... of q under full
                stick, Q and sig0; powers of the first quantity are eliminated first
    degree      the total degree up to which all are found, 1 to 12
    symmetric   True: b = a
    given       {"P2": "m*P1/a"}: names that are not free, as formulas in free names
    free        further free names, such as ["m"]

    They are exact: nothing is rounded, and they do not depend on units (docs/relations.md). The GIL
    is released, and Ctrl-C ends the call with KeyboardInterrupt. Raises InputError for malformed
    formulas, unknown names, and more monomials than can be tried.
    """
    if not quantities:
        raise InputError("there is no quantity", 'give some, such as ["left.c0", "right.c0", "b1"]')
    arguments = (quantities, degree, symmetric, list((given or {}).items()), free)
    found = (_apart.run("relations", *arguments) if _apart.can_start()
             else _edgeproof.relations(*arguments))
    data = json.loads(found)
    return Relations(quantities=tuple(quantities), degree=int(data["degree"]),
                     relations=row_of(data["rows"]),
                     complete=data["complete"] == "yes", monomials=int(data["monomials"]),
                     notes=tuple(data["notes"]), _data=data)
