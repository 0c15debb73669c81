# SPDX-License-Identifier: GPL-3.0-or-later
"""Completes the compiled class Value: a TypeError of one sentence, and pickle."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any

from ._edgeproof import Value, value_of_state


def restored(*state: Any) -> Value:
    """Makes a pickled Value again. pickle finds functions of Python only."""
    return value_of_state(state)


def _with_one_sentence(method: Callable[..., Any]) -> Callable[..., Any]:
    @functools.wraps(method)
    def called(*args: Any, **named: Any) -> Any:
        try:
            return method(*args, **named)
        except TypeError as error:
            if "incompatible function arguments" not in str(error):
                raise
            signature = (method.__doc__ or "").splitlines()[0]
            raise TypeError(f"the arguments are not those of {signature}") from None

    return called


for _name in ("interval", "rounded", "fraction", "decimal", "mpmath", "to_dict", "__format__"):
    setattr(Value, _name, _with_one_sentence(getattr(Value, _name)))
