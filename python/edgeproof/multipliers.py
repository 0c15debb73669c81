# SPDX-License-Identifier: GPL-3.0-or-later
"""Polynomial relations between the multipliers of both edges that hold along every profile."""

from __future__ import annotations

import copy
import dataclasses
import json
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from . import _apart, _edgeproof
from ._numbers import whole
from .errors import InputError

__all__ = ["Relation", "Relations", "relations"]


@dataclasses.dataclass(frozen=True)
class Relation:
    """A polynomial in the quantities that vanishes along every profile: proved by symbols.

    degree    its total degree
    relation  "b1*left.c0 - right.c0 = 0"
    """

    degree: int
    relation: str


@dataclasses.dataclass(frozen=True)
class Relations:
    """Relations between quantities. len(), iteration, relations[0].

    relations  by degree; none follows from those before it by division by leading terms
    complete   every relation up to `degree` is a sum of multiples of these (none: there is none),
               proved by the rank of exact samples; False where a candidate was not proved
    monomials  how many there are up to that degree
    notes      what is proved, sentences
    """

    quantities: tuple[str, ...]
    degree: int
    relations: tuple[Relation, ...]
    complete: bool
    monomials: int
    notes: tuple[str, ...] = dataclasses.field(repr=False)
    _told: dict[str, Any] = dataclasses.field(repr=False, compare=False)

    def __len__(self) -> int:
        return len(self.relations)

    def __iter__(self) -> Iterator[Relation]:
        return iter(self.relations)

    def __getitem__(self, index: int) -> Relation:
        return self.relations[index]

    def to_dict(self) -> dict[str, Any]:
        """As `edgeproof relations --format json` has it."""
        return copy.deepcopy(self._told)


def relations(quantities: Sequence[str], degree: int = 4, *, symmetric: bool = False,
              given: Mapping[str, str] | None = None, free: Sequence[str] = ()) -> Relations:
    """All polynomial relations with rational coefficients between quantities: Relations.

    quantities  formulas in a, b, L (a + b), P1, P2, ..., b1, b2, ... (derivatives by a), the
                multipliers "right.c0", "left.c0", ... of p and "right.s0", ... of q under full
                stick, Q and sig0; powers of the first are eliminated first
    degree      total degree up to which all are found, 1 to 12
    symmetric   b = a
    given       {"P2": "m*P1/a"}: names that are not free, as formulas in those that are
    free        further free names, such as ["m"]

    They are exact: nothing is rounded, and no unit comes in (docs/relations.md). The GIL is
    released, and Ctrl-C ends it with KeyboardInterrupt. Raises InputError for formulas that are
    malformed, names that are not known, and more monomials than can be tried.
    """
    asked = [quantities] if isinstance(quantities, str) else list(quantities)
    if not asked:
        raise InputError("there is no quantity", 'give some, such as ["left.c0", "right.c0", "b1"]')
    named = [free] if isinstance(free, str) else list(free)
    arguments = (asked, whole(degree, "degree"), symmetric, list((given or {}).items()), named)
    found = (_apart.run("relations", *arguments) if _apart.can_start()
             else _edgeproof.relations(*arguments))
    told = json.loads(found)
    return Relations(quantities=tuple(asked), degree=int(told["degree"]),
                     relations=tuple(Relation(**row) for row in told["rows"]),
                     complete=told["complete"] == "yes", monomials=int(told["monomials"]),
                     notes=tuple(told["notes"]), _told=told)
