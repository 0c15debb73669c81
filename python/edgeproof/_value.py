# SPDX-License-Identifier: BSD-3-Clause
"""Completes the compiled class Value: its numbers as Python's, its texts, and pickle."""

from __future__ import annotations

import decimal
import fractions
from typing import Any

from ._arguments import checked
from ._edgeproof import Value, value_of_state
from ._lazy import imported
from .errors import UndecidedError

_MOST_CHARACTERS = 30


def _fraction(quotient: str) -> fractions.Fraction:
    """Reads hexadecimal digits: Python refuses decimal numbers of more than 4300 digits."""
    numerator, _, denominator = quotient.partition("/")
    return fractions.Fraction(int(numerator, 16), int(denominator or "1", 16))


def _one_number(value: Value) -> decimal.Decimal:
    if value.text[:1] in ("", "["):
        raise UndecidedError(f"the rounding of the value is undecided: {value.text}",
                             "take .interval(), or ask for more digits")
    return decimal.Decimal(value.text)


def shortened(text: str) -> str:
    """Returns the text with its first digits only, followed by "...", if it is long."""
    mantissa, e, power = text.partition("e")
    if len(text) <= _MOST_CHARACTERS or text[0] == "[" or not 0 <= mantissa.find(".") <= \
            _MOST_CHARACTERS:
        return text
    return mantissa[:_MOST_CHARACTERS - 4] + "..." + e + power


def _accuracy(value: Value) -> str:
    """Returns "bound 1e-50, closed-form", or "exact, given"."""
    if value.exact is not None and value.bound == "0":
        return f"exact, {value._how}"
    return f"{'' if value.proved else 'estimated '}bound {value.bound}, {value._how}"


def restored(state: str) -> Value:
    """Makes a pickled Value again. pickle finds functions of Python only."""
    return value_of_state(state)


class _Completed:
    __doc__ = Value.__doc__

    @property
    def route(self: Value) -> str:  # type: ignore[misc]
        """How it was computed."""
        return self._how.replace(" (rounding undecided)", "").removesuffix(" (estimate)")

    @property
    def exact(self: Value) -> fractions.Fraction | None:  # type: ignore[misc]
        """The value as a Fraction where it is known to be rational, else None."""
        return _fraction(self._interval()[0]) if self._is_exact else None

    def interval(self: Value) -> tuple[fractions.Fraction, fractions.Fraction]:  # type: ignore[misc]
        """(lower, upper): Fractions with the exact value between them (proved, or estimated)."""
        low, high = self._interval()
        return _fraction(low), _fraction(high)

    @checked
    def rounded(self: Value, digits: int) -> str:  # type: ignore[misc]
        """The text at another number of digits, rounded from the value itself."""
        return self._rounded(digits)

    def fraction(self: Value) -> fractions.Fraction:  # type: ignore[misc]
        """The number that .text states, as fractions.Fraction."""
        return fractions.Fraction(_one_number(self))

    def decimal(self: Value) -> decimal.Decimal:  # type: ignore[misc]
        """The number that .text states, as decimal.Decimal."""
        return _one_number(self)

    def mpmath(self: Value) -> Any:  # type: ignore[misc]
        """The number that .text states, as mpmath.mpf with a few digits to spare."""
        number = fractions.Fraction(_one_number(self))
        mpmath = imported("mpmath")
        with mpmath.workdps(self.digits + 5):
            return mpmath.fdiv(number.numerator, number.denominator)

    def _mpmath_(self: Value, *args: Any) -> Any:  # type: ignore[misc]
        return self.mpmath()

    def to_dict(self: Value) -> dict[str, Any]:  # type: ignore[misc]
        """{"text", "bound", "proved", "route"}."""
        return {name: getattr(self, name) for name in ("text", "bound", "proved", "route")}

    def __str__(self: Value) -> str:  # type: ignore[misc]
        return self.text

    def __repr__(self: Value) -> str:  # type: ignore[misc]
        text = shortened(self.text)
        digits = "" if text == self.text else f" ({self.digits} digits)"
        return f"<edgeproof.Value {text}{digits}, {_accuracy(self)}>"

    def _repr_html_(self: Value) -> str:  # type: ignore[misc]
        """Returns the value for a notebook: the text, and the whole of it where it is shortened."""
        whole, text, accuracy = map(imported("html").escape, (
            self.text, shortened(self.text), _accuracy(self)))
        return f'<span title="{whole}"><code>{text}</code> ({accuracy})</span>'

    def __format__(self: Value, spec: str) -> str:  # type: ignore[misc]
        return format(_one_number(self), spec) if spec else self.text

    def __reduce__(self: Value) -> tuple[Any, ...]:  # type: ignore[misc,override]
        return restored, (self._state(),)


for _name, _member in vars(_Completed).items():
    if _name not in ("__doc__", "__module__", "__dict__", "__weakref__"):
        setattr(Value, _name, _member)
Value.__doc__ = """A computed number with how far it is to be trusted.

    text     the value, rounded correctly to the requested digits (or to those that are certain;
             one of two neighbours where the rounding of a proved value is undecided)
    bound    text: |text - exact| is at most this
    proved   True: the bound is proved. False: it is what the route estimates of itself
    route    how the value was computed: "closed-form", "series", "given", ...
    digits   the requested digits
    exact    fractions.Fraction where the value is known to be that rational number, else None

float(v) is the binary64 nearest to the exact value. v.fraction(), v.decimal() and v.mpmath() are
the number that .text states, exactly; v.interval() is what encloses the exact value. Comparisons
(with values and with int, float, Fraction, Decimal, mpmath.mpf, exactly) raise UndecidedError where
the bounds overlap, so that an answer is certain as far as the bounds are.

x + y, x - y, x*y, x/y, -x and abs(x) are Values with bounds, computed in ball arithmetic from the
enclosures of x and y; x or y may be a number, which is exact. The result is proved if both are. It
has the digits of the less precise of the two, or fewer if only these are certain. The operands are
treated as independent: x - x is an enclosure of 0, not 0. Raises ZeroDivisionError for the divisor
0, UndecidedError for one that may be 0."""
