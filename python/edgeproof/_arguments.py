# SPDX-License-Identifier: BSD-3-Clause
"""Reads the arguments of public functions by their annotations.

An argument that is annotated as a Number arrives in the function as its exact text, one that is an
int as a Python int, and so on. So every function raises the same TypeError, in one sentence, for an
argument of another type.
"""

from __future__ import annotations

import functools
import inspect
import math
import os
from collections.abc import Callable, Mapping
from typing import Any, TypeVar

from ._numbers import exact_text, is_many, is_truth_value, shown, text, texts, whole, wholes
from .errors import Error, InputError

_Function = TypeVar("_Function", bound=Callable[..., Any])


def _flag(value: Any, name: str) -> bool:
    if not is_truth_value(value):
        raise TypeError(f"{name} = {shown(value)} is neither True nor False")
    return bool(value)


def _real(value: Any, name: str) -> float:
    if isinstance(value, (str, bytes)) or is_truth_value(value):
        raise TypeError(f"{name} = {shown(value)} is no number: give a float")
    number = float(value)
    if not math.isfinite(number):
        raise InputError(f"{name} = {shown(value)} is out of range", "give a finite number")
    return number


def _path(value: Any, name: str) -> str:
    if not isinstance(value, (str, os.PathLike)):
        raise TypeError(f"{name} = {shown(value)} is no file: give a str or a pathlib.Path")
    return text(os.fsdecode(value), name)


def _function(value: Any, name: str) -> Any:
    if not callable(value):
        raise TypeError(f"{name} = {shown(value)} is no function")
    return value


def _names(value: Any, name: str) -> list[str]:
    return [text(value, name)] if isinstance(value, str) else [text(v, name) for v in value]


def mapping(value: Any, name: str) -> dict[str, Any]:
    """Returns a dict whose keys are str."""
    if not isinstance(value, Mapping):
        raise TypeError(f"{name} = {shown(value)} is no mapping: give a dict")
    return {text(k, f"a key of {name}"): v for k, v in value.items()}


def _numbers_by_name(value: Any, name: str) -> dict[str, str]:
    return {k: exact_text(v, k) for k, v in mapping(value, name).items()}


def _steps(value: Any, name: str) -> list[dict[str, str]]:
    if isinstance(value, Mapping):
        raise TypeError(f"{name} is one mapping: give a list of them")
    return [_numbers_by_name(step, f"{name}[{i}]") for i, step in enumerate(value)]


# The functions that read an argument, by its annotation without "| None".
READERS: dict[str, Callable[[Any, str], Any]] = {
    "Number": exact_text,
    "Places": lambda value, name: (
        list(value) if is_many(value) and not hasattr(value, "ravel") else value),
    "Iterable[Number]": texts,
    "tuple[Number, Number]": texts,
    "Mapping[str, Number]": _numbers_by_name,
    "Iterable[Mapping[str, Number]]": _steps,
    "int": whole,
    "int | Sequence[int]": wholes,
    "float": _real,
    "bool": _flag,
    "str": text,
    "Sequence[str]": _names,
    "Mapping[str, str]": lambda value, name: {
        k: text(v, f"{name}[{k!r}]") for k, v in mapping(value, name).items()},
    "str | os.PathLike[str]": _path,
    "Callable[[int, int], object]": _function,
}


def read_as(annotation: str, reader: Callable[[Any, str], Any]) -> None:
    """Adds a kind of argument that only one module has."""
    READERS[annotation] = reader


def checked(function: _Function) -> _Function:
    """Makes a function read its arguments by their annotations before it is called."""
    signature = inspect.signature(function)
    kinds = {name: str(p.annotation) for name, p in signature.parameters.items()}
    readers = {name: READERS[kind.removesuffix(" | None")] for name, kind in kinds.items()
               if kind.removesuffix(" | None") in READERS}

    @functools.wraps(function)
    def called(*args: Any, **named: Any) -> Any:
        try:
            bound = signature.bind(*args, **named)
        except TypeError as error:
            raise TypeError(f"{function.__qualname__}(): {error}") from None
        bound.apply_defaults()
        for name, reader in readers.items():
            value = bound.arguments[name]
            if value is None and kinds[name].endswith(" | None"):
                continue
            try:
                bound.arguments[name] = reader(value, name)
            except (Error, TypeError):
                raise
            except Exception:  # of the methods of a type that does not belong here
                raise TypeError(f"{name} is {type(value).__name__}, which is not supported"
                                ) from None
        return function(*bound.args, **bound.kwargs)

    return called  # type: ignore[return-value]
