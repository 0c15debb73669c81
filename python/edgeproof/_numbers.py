# SPDX-License-Identifier: GPL-3.0-or-later
"""Converts Python's numbers to exact text, which the library reads."""

from __future__ import annotations

import decimal
import fractions
import numbers
import operator
from typing import Any

from .errors import InputError

# The largest |exponent| of 2: larger ones have no use here, and the digits would fill the memory.
_MOST_EXPONENT = 400_000


def _integer_text(n: int) -> str:
    # str() refuses integers of more than 4300 digits; Decimal has them all.
    return str(n) if n.bit_length() < 10_000 else str(decimal.Decimal(n))


def _fraction_text(numerator: int, denominator: int) -> str:
    """Returns the decimal expansion if it is short enough to read, else a quotient."""
    if denominator == 1:
        return _integer_text(numerator)
    twos = (denominator & -denominator).bit_length() - 1
    if denominator == 1 << twos and twos <= 64:
        digits = _integer_text(abs(numerator) * 5**twos).rjust(twos + 1, "0")
        return ("-" if numerator < 0 else "") + f"{digits[:-twos]}.{digits[-twos:]}".rstrip("0")
    return f"{_integer_text(numerator)}/{_integer_text(denominator)}"


def _not_finite(name: str, value: Any) -> InputError:
    return InputError(f"{name} = {value} is not a finite number", "give a number")


def exact_text(value: Any, name: str) -> str:
    """Returns the exact text of a number: a str unchanged, a float as its binary64 number.

    Raises TypeError if it is not a number, InputError for NaN and infinities.
    """
    if isinstance(value, str):
        return str(value)
    if isinstance(value, bool) or type(value).__name__ in ("bool_", "bool"):
        raise TypeError(f"{name} = {value} is a truth value, not a number")
    if isinstance(value, numbers.Rational):
        return _fraction_text(int(value.numerator), int(value.denominator))
    if isinstance(value, decimal.Decimal):
        if not value.is_finite():
            raise _not_finite(name, value)
        return str(value).lower()
    if hasattr(value, "_mpf_"):  # mpmath.mpf: sign, mantissa, exponent, bits
        sign, mantissa, exponent, _ = value._mpf_
        if not mantissa and exponent:
            raise _not_finite(name, value)
        if abs(exponent) > _MOST_EXPONENT:
            raise InputError(f"{name} = {value} is beyond the range of numbers",
                             f"give one within 2^(+-{_MOST_EXPONENT})")
        q = fractions.Fraction(int(mantissa)) * fractions.Fraction(2) ** int(exponent)
        return _fraction_text(-q.numerator if sign else q.numerator, q.denominator)
    exact = getattr(value, "exact", None)
    if isinstance(exact, fractions.Fraction):  # a Value that is known exactly
        return _fraction_text(exact.numerator, exact.denominator)
    if hasattr(value, "as_integer_ratio"):  # float, numpy.float32, numpy.longdouble
        try:
            numerator, denominator = value.as_integer_ratio()
        except (ValueError, OverflowError):
            raise _not_finite(name, value) from None
        return _fraction_text(int(numerator), int(denominator))
    try:
        return _integer_text(operator.index(value))
    except TypeError:
        pass
    shape = getattr(value, "shape", None)
    if shape == () and getattr(value, "mask", False):
        raise InputError(f"{name} is masked", "leave it out, or give a number")
    if shape == () and hasattr(value, "item"):  # a numpy array of one number
        return exact_text(value[()], name)
    raise TypeError(f"{name} is {type(value).__name__}, not a number: give str, int, float, "
                    "Fraction, Decimal or mpmath.mpf")


def text_or_none(value: Any, name: str) -> str | None:
    """The same as exact_text, but None for None."""
    return None if value is None else exact_text(value, name)


def whole(value: Any, name: str) -> int:
    """Returns a whole number. Raises TypeError for anything else, including 50.0 and "50"."""
    try:
        if isinstance(value, bool):
            raise TypeError
        return operator.index(value)
    except TypeError:
        raise TypeError(f"{name} = {value!r} is no whole number") from None


def wholes(value: Any, name: str) -> list[int]:
    """Returns a list of whole numbers, from several or one alone."""
    if hasattr(value, "__iter__") and not isinstance(value, str):
        return [whole(v, name) for v in value]
    return [whole(value, name)]
