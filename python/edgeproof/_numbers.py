# SPDX-License-Identifier: BSD-3-Clause
"""Converts Python's numbers to exact text, which the library reads."""

from __future__ import annotations

import decimal
import fractions
import numbers
import operator
import reprlib
from typing import Any

from .errors import InputError

# The largest |exponent| of 2: larger ones have no use here, and the digits would fill the memory.
_MOST_EXPONENT = 400_000


def shown(value: Any) -> str:
    """Returns a value for a message: short, in one line."""
    return " ".join(reprlib.repr(value).split())


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
    return InputError(f"{name} = {shown(value)} is not a finite number", "give a number")


def is_truth_value(value: Any) -> bool:
    """True for bool, and for numpy's."""
    return isinstance(value, bool) or type(value).__name__ in ("bool_", "bool")


def _text_of(value: Any, name: str) -> str | None:
    """Returns the exact text; None for another type."""
    if isinstance(value, str):
        return text(value, name)
    if is_truth_value(value):
        return None
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
            raise InputError(f"{name} = {shown(value)} is beyond the range of numbers",
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
    if getattr(value, "shape", None) == () and hasattr(value, "item"):
        if getattr(value, "mask", False):
            raise InputError(f"{name} is masked", "leave it out, or give a number")
        return _text_of(value[()], name)  # a numpy array of one number
    return _integer_text(operator.index(value)) if hasattr(value, "__index__") else None


def exact_text(value: Any, name: str) -> str:
    """Returns the exact text of a number: a str unchanged, a float as its binary64 number.

    Raises TypeError if it is not a number, InputError for NaN and infinities.
    """
    try:
        found = _text_of(value, name)
    except InputError:
        raise
    except Exception:  # of the methods of a type that is no number
        found = None
    if found is None:
        raise TypeError(f"{name} is {type(value).__name__}, not a number: give str, int, float, "
                        "Fraction, Decimal or mpmath.mpf")
    return found


def text(value: Any, name: str) -> str:
    """Returns a str. Raises TypeError for anything else."""
    if not isinstance(value, str):
        raise TypeError(f"{name} = {shown(value)} is {type(value).__name__}: give a str")
    if any("\ud800" <= c <= "\udfff" for c in value):
        raise InputError(f"{name} has half of a surrogate pair", "give characters of Unicode")
    return str(value)


def whole(value: Any, name: str) -> int:
    """Returns a whole number. Raises TypeError for anything else, including 50.0 and "50"."""
    try:
        if is_truth_value(value):
            raise TypeError
        n = operator.index(value)
    except Exception:
        raise TypeError(f"{name} = {shown(value)} is no whole number: give an int") from None
    if abs(n) >= 2**63:
        raise InputError(f"{name} = {shown(n)} is out of range", "give a number of usual size")
    return n


def is_many(value: Any) -> bool:
    """True for a list, an array and the like; False for one number or str."""
    return (not isinstance(value, (str, bytes)) and hasattr(value, "__iter__") and
            getattr(value, "shape", None) != ())


def many(value: Any) -> list[Any]:
    """Returns the elements of a list or an array, or one number alone in a list."""
    if not is_many(value):
        return [value]
    return list(value.ravel() if hasattr(value, "ravel") else value)


def texts(value: Any, name: str) -> list[str]:
    """Returns the exact texts of several numbers, or of one alone."""
    if not is_many(value):
        return [exact_text(value, name)]
    return [exact_text(v, f"{name}[{i}]") for i, v in enumerate(many(value))]


def wholes(value: Any, name: str) -> list[int]:
    """Returns a list of whole numbers, from several or one alone."""
    return [whole(v, name) for v in many(value)]
