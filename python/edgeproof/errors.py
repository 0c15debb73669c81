# SPDX-License-Identifier: BSD-3-Clause
"""The exceptions that edgeproof raises on purpose. All of them derive from Error."""

from __future__ import annotations

__all__ = ["Error", "InputError", "DomainError", "BudgetError", "UndecidedError"]


class Error(Exception):
    """Base of all exceptions of edgeproof.

    problem  a description of the error
    advice   what to write, or do, instead; or None
    file     the file that contains the error, or None
    line     the line in the file, or None

    str(error) is one line: "FILE:LINE: problem; advice".
    """

    def __init__(self, problem: str, advice: str | None = None, file: str | None = None,
                 line: int | None = None) -> None:
        self.problem = problem
        self.advice = advice
        self.file = file
        self.line = line
        super().__init__(problem, advice, file, line)

    def __str__(self) -> str:
        place = "" if self.file is None else str(self.file)
        if place and self.line is not None:
            place += f":{self.line}"
        return (f"{place}: " if place else "") + str(self.problem) + (
            f"; {self.advice}" if self.advice else "")


class InputError(Error, ValueError):
    """The input is malformed or makes no sense. A ValueError."""


class DomainError(Error, ValueError):
    """The mechanics defines no value for the question. A ValueError."""


class BudgetError(Error, RuntimeError):
    """A counted budget (bits, evaluations) ended before the digits were reached."""


class UndecidedError(Error, ArithmeticError):
    """The bounds of the values do not answer the question. An ArithmeticError."""
