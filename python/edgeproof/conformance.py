# SPDX-License-Identifier: BSD-3-Clause
"""Compares other programs' numbers with the exact values."""

from __future__ import annotations

import csv
import dataclasses
import io
import json
import math
import os
from collections.abc import Callable, Iterator
from typing import Any, Union

from . import _edgeproof
from ._arguments import checked, read_as, READERS
from ._numbers import exact_text
from ._shipped import file_or_shipped
from .errors import InputError
from .results import Row, plain, row_of

__all__ = ["Agreement", "check", "questions"]


@dataclasses.dataclass(frozen=True)
class Agreement:
    """Answers compared with the exact values.

    len() and iteration apply to the cases; print() shows the report.

    passed       True if there is no fault, nothing is missing, and every answer meets the target
    cases        for each answer id, quantity, regime, value (its text), state ("number", "missing",
                 "nan", "infinite", "garbage", "died"), reference (the exact value, rounded), digits
                 (right ones, -log10|value/exact - 1|), ulps (of binary64), relative, passed,
                 explained (the rounding of the inputs explains the error), no_reference
    faults       errors of the answers as a whole, in sentences
    conventions  other conventions that would explain answers: of (quantities), relation, digits,
                 rows, failing, hint, also (relations that explain as much)
    text         the report that `edgeproof check` prints
    """

    passed: bool
    cases: tuple[Row, ...]
    faults: tuple[str, ...]
    conventions: tuple[Row, ...]
    estimates: int
    text: str

    def __len__(self) -> int:
        return len(self.cases)

    def __iter__(self) -> Iterator[Row]:
        return iter(self.cases)

    def __str__(self) -> str:
        return self.text

    @property
    def failures(self) -> tuple[Row, ...]:
        """The answers that are not within the target."""
        return tuple(case for case in self.cases if not case.passed)

    def to_dict(self) -> dict[str, Any]:
        """The same as str, int, float, bool, list, dict and None."""
        result: dict[str, Any] = plain(vars(self))
        return result


@checked
def questions(recipe: str | os.PathLike[str]) -> list[dict[str, str]]:
    """The questions of a recipe (TOML; reference/README.md), a dict each; values are exact text.

    Keys: id, the parameters of the contact, quantity, and edge, u, x, tolerance where they apply.
    Numbers are binary64, so that a program that computes in binary64 can read them exactly.
    """
    found: list[dict[str, str]] = json.loads(_edgeproof.questions(
        file_or_shipped(recipe, "reference")))
    return found


def _written(value: Any) -> str:
    if value is None:
        return ""
    if isinstance(value, str):
        return value
    try:
        if math.isnan(value):
            return "nan"
        if math.isinf(value):
            return "inf" if value > 0 else "-inf"
    except (TypeError, OverflowError):
        pass
    return exact_text(value, "the answer")


Answers = Union[str, "os.PathLike[str]", Callable[[dict[str, str]], Any]]
read_as("Answers", lambda value, name: (
    value if callable(value) else READERS["str | os.PathLike[str]"](value, name)))


def _answers_of(function: Callable[[dict[str, str]], Any], recipe: str) -> str:
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(["id", "value"])
    for question in questions(recipe):
        writer.writerow([question["id"], _written(function(question))])
    return out.getvalue()


@checked
def check(answers: Answers | None = None, *,
          recipe: str | os.PathLike[str] | None = None, command: str | None = None,
          digits: float | None = None, ulps: float | None = None, conditioned: bool = False,
          timeout: float = 600.0, threads: int = 0,
          progress: Callable[[int, int], object] | None = None) -> Agreement:
    """Compares another program's answers with the exact values.

    answers      a CSV file of the questions with a column `value`; or, with a recipe, a file with
                 only id and value, or a function that answers one question (a dict of questions())
    recipe       the questions: a file (TOML), or the name of one that came with the program
    command      with a recipe: a shell command that reads the questions and writes id and value
    timeout      seconds for one run of the command
    digits, ulps the target; neither: 12 digits, or an error that the rounding of inputs explains
    conditioned  True: errors that the rounding of the inputs explains pass
    threads      0: as many as the machine has

    Raises InputError for malformed files; a wrong answer never raises an exception.
    """
    for name, target in (("digits", digits), ("ulps", ulps), ("timeout", timeout)):
        if target is not None and not 0 < target < 1e9:
            raise InputError(f"{name} = {target} is out of range", "give a number > 0")
    if not 0 <= threads <= 1024:
        raise InputError(f"threads = {threads} is out of range", "give a number from 0 to 1024")
    asked = None if recipe is None else file_or_shipped(recipe, "reference")
    if (answers is None) == (command is None):
        raise InputError("both answers and a command are given" if command is not None else
                         "there is nothing to check",
                         "give a file or a function as answers, or a command")
    text = None
    name = "answers"
    if command is not None or callable(answers):
        if asked is None:
            raise InputError("there is no recipe", "give recipe=..., the questions to answer")
        if command is None:
            assert callable(answers)
            text = _answers_of(answers, asked)
    else:
        assert isinstance(answers, str)
        name = answers
        text = _edgeproof.read_text(name, "file of answers (CSV)")
    options = {"answers": text, "name": name, "recipe": asked, "command": command,
               "seconds": timeout, "digits": digits, "ulps": ulps,
               "conditioned": "yes" if conditioned else None, "threads": threads}
    found = json.loads(_edgeproof.check(
        progress, {key: str(value) for key, value in options.items() if value is not None}))
    for row in (*found["cases"], *found["conventions"]):
        row.update((key, float(row[key])) for key in ("digits", "ulps", "relative") if key in row)
    return Agreement(**vars(row_of(found)))
