# SPDX-License-Identifier: BSD-3-Clause
"""Compares printed formulas with the mechanics: ledgers of claims and their verdicts."""

from __future__ import annotations

import collections
import dataclasses
import json
import os
from collections.abc import Callable, Iterator
from typing import Any

from . import _edgeproof
from ._arguments import checked
from ._shipped import file_or_shipped
from .results import Row

__all__ = ["Audit", "Claim", "verify"]


class Claim(Row):
    """The result for one claim; to_dict() is its entry in verdicts.json.

    id        of the ledger
    verdict   "proved", "confirmed", "imprecise", "refuted", "underspecified", "undecided" or
              "definition"
    printed   what is printed, TeX
    correct   the corrected formula of a refuted one, where one was found
    quoted, computed  of a quoted figure: as it is printed, and as it is
    note      what was found, a sentence
    rests_on  "theorem", "identity", "enclosures", "text" or "none" (docs/verdicts.md)
    certificate  file of theorems about it for Coq, from the ledger's folder; None where there is none
    fields_sha256  the hash of what the claim states (docs/file-formats.md)
    evidence  what the verdict rests on
    """

    @property
    def holds(self) -> bool:
        """True if the claim is right as printed: proved, confirmed, or a definition."""
        return self.verdict in ("proved", "confirmed", "definition")


@dataclasses.dataclass(frozen=True)
class Audit:
    """The verdicts of a ledger, in its order. len(), iteration, audit["EQ18"].

    summary      counts of verdicts in a line
    differences  the differences from the verdicts recorded next to the ledger, a line each; None
                 if none are recorded
    """

    ledger: str
    source: str
    digits: int
    claims: tuple[Claim, ...]
    summary: str
    differences: tuple[str, ...] | None

    def __str__(self) -> str:
        lines = [f"{c.id}: {c.verdict}" + (f"; {c.note}" if c.note else "") for c in self.claims]
        return "\n".join([*lines, self.summary])

    def __len__(self) -> int:
        return len(self.claims)

    def __iter__(self) -> Iterator[Claim]:
        return iter(self.claims)

    def __getitem__(self, id: str) -> Claim:
        for claim in self.claims:
            if claim.id == id:
                return claim
        raise KeyError(id)

    @property
    def counts(self) -> dict[str, int]:
        """The number of claims for each verdict that occurs."""
        return dict(collections.Counter(claim.verdict for claim in self.claims))

    @property
    def refuted(self) -> tuple[Claim, ...]:
        """The claims that are refuted."""
        return tuple(claim for claim in self.claims if claim.verdict == "refuted")

    def to_dict(self) -> dict[str, Any]:
        """The content of verdicts.json."""
        return {"ledger": self.ledger, "digits": self.digits,
                "claims": [claim.to_dict() for claim in self.claims]}


@checked
def verify(ledger: str | os.PathLike[str], digits: int = 50, only: str = "*", threads: int = 0,
           progress: Callable[[int, int], object] | None = None) -> Audit:
    """Compares a ledger of printed claims (TOML; verify/README.md) with the mechanics.

    ledger    a file, or the name of one that came with the program: "moore-hills"
    digits    the precision of the comparison, 10 to 10000
    only      claims whose id matches this pattern, such as "EQ2*"
    threads   0: as many as the machine has; verdicts do not depend on it
    progress  is called with (claims done, claims in all), from any thread

    Raises InputError, with file and line, for a ledger or a claim that is malformed.
    """
    data = json.loads(_edgeproof.verify(progress, file_or_shipped(ledger, "verify"), digits, only,
                                        threads))
    differences = data["differences"]
    return Audit(
        ledger=data["ledger"],
        source=data["source"],
        digits=data["digits"],
        claims=tuple(Claim(**claim) for claim in data["claims"]),
        summary=data["counts"],
        differences=None if differences is None else tuple(differences),
    )
