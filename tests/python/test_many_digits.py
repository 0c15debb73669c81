# SPDX-License-Identifier: BSD-3-Clause
"""Values with more digits than Python's limit for integers, computed in a separate process."""
import math
import pickle
import sys
from decimal import Decimal
from fractions import Fraction

import pytest

import edgeproof
from edgeproof import _apart

DIGITS = 6000


@pytest.fixture(scope="module")
def values(hertz):
    """sqrt(0.19)/2, and sqrt(1 - x^2)/2 at x = 4/5."""
    return hertz.pressure(["0.1", "1/5"], digits=DIGITS)


def nines():
    """The floor of 10^6010 sqrt(0.19)/2."""
    return math.isqrt(19 * 10**(2 * 6010 - 2) // 4)


def test_the_digits_are_right(values):
    p, rational = values
    assert p.digits == DIGITS and p.proved and len(p.text) == DIGITS + 2
    low, high = p.interval()
    unit = Fraction(1, 10**6010)
    assert low <= (nines() + 1) * unit and nines() * unit <= high and high - low < 10**10 * unit
    assert abs(p.fraction() - nines() * unit) <= 10**10 * unit
    assert rational.text == "0.3" + "0" * (DIGITS - 1)


def test_conversions(values):
    mpmath = pytest.importorskip("mpmath")
    p = values[0]
    assert p.decimal() == Decimal(p.text) and float(p) == math.sqrt(0.19) / 2
    with mpmath.workdps(DIGITS + 20):
        assert abs(p.mpmath() - mpmath.sqrt(mpmath.mpf(19) / 100) / 2) < mpmath.mpf(10)**-DIGITS
    other = pickle.loads(pickle.dumps(p))
    assert other.text == p.text and other.interval() == p.interval()


def test_comparisons(values):
    p, tiny = values[0], Fraction(1, 10**5000)
    assert p > p.fraction() - tiny and p < p.fraction() + tiny
    with pytest.raises(edgeproof.UndecidedError):
        _ = p < p.interval()[1]


def test_numbers_given(values):
    mpmath = pytest.importorskip("mpmath")
    q = values[0].fraction()
    for number in (q, values[0].decimal(), 10**6000 + 1):
        made = edgeproof.Scene(edgeproof.hertz(R=1), a=number, contact_modulus=1)
        assert made.a.exact == number
    with mpmath.workdps(DIGITS):
        number = mpmath.sqrt(2)
        made = edgeproof.Scene(edgeproof.hertz(R=1), a=number, contact_modulus=1)
        sign, mantissa, exponent, _ = number._mpf_
        assert made.a.exact == Fraction(int(mantissa)) * Fraction(2)**int(exponent)


def test_errors_of_the_process_are_raised_unchanged(hertz, tmp_path):
    for u in ("-1", "3", "what"):
        with pytest.raises(edgeproof.InputError) as apart:
            hertz.pressure(u, digits=DIGITS)
        with pytest.raises(edgeproof.InputError) as here:
            hertz.pressure(u, digits=50)
        assert str(apart.value) == str(here.value)
    file = tmp_path / "slides.toml"
    file.write_text(edgeproof.Scene(edgeproof.hertz(R=1), a=1, contact_modulus=1, Q="0.9",
                                    friction="0.5").text)
    with pytest.raises(edgeproof.InputError) as raised:
        edgeproof.read_scene(file).slip(digits=DIGITS)
    assert raised.value.file == str(file) and raised.value.line is not None


def test_a_process_that_dies_is_an_error(hertz, monkeypatch):
    monkeypatch.setattr(_apart, "_CHILD", "import os; os._exit(9)")
    with pytest.raises(edgeproof.Error, match="ended with status 9"):
        hertz.pressure("0.1", digits=DIGITS)


def test_where_no_python_can_be_started(hertz, monkeypatch):
    monkeypatch.setattr(sys, "executable", "/opt/other/program")
    assert hertz.pressure("1/5", digits=DIGITS).text == "0.3" + "0" * (DIGITS - 1)
