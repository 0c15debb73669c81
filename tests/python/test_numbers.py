# SPDX-License-Identifier: GPL-3.0-or-later
from decimal import Decimal
from fractions import Fraction

import pytest
from edgeproof._numbers import exact_text

import edgeproof

np = pytest.importorskip("numpy")
mpmath = pytest.importorskip("mpmath")


@pytest.mark.parametrize("given, exact", [
    (3, Fraction(3)),
    (-(10**40), Fraction(-(10**40))),
    (0.1, Fraction(0.1)),
    (-0.5, Fraction(-1, 2)),
    (5e-324, Fraction(5e-324)),
    (1.7976931348623157e308, Fraction(1.7976931348623157e308)),
    (Fraction(1, 3), Fraction(1, 3)),
    (Decimal("1E-30"), Fraction(1, 10**30)),
    (Decimal("-2.50"), Fraction(-5, 2)),
    (np.float64(0.1), Fraction(0.1)),
    (np.float32(0.1), Fraction(float(np.float32(0.1)))),
    (np.longdouble(1) / 3, Fraction(*(np.longdouble(1) / 3).as_integer_ratio())),
    (np.int64(-7), Fraction(-7)),
    (np.uint8(7), Fraction(7)),
    (np.array(0.25), Fraction(1, 4)),
    (mpmath.mpf("0.5"), Fraction(1, 2)),
    (mpmath.mpf(-3), Fraction(-3)),
    (mpmath.mpf(0), Fraction(0)),
])
def test_numbers_are_exact(given, exact):
    text = exact_text(given, "x")
    assert Fraction(text) == exact
    # the library reads the same number
    value = edgeproof.Scene(edgeproof.hertz(R=1), a=abs(exact) + 1, contact_modulus=1).a
    assert value.exact == abs(exact) + 1


def test_a_long_mpf_keeps_every_digit():
    with mpmath.workdps(60):
        third = mpmath.mpf(1) / 3
    assert Fraction(exact_text(third, "x")) == Fraction(int(third.man)) * Fraction(2)**third.exp


@pytest.mark.parametrize("given", [float("nan"), float("inf"), Decimal("NaN"), np.float64("nan"),
                                   np.float32("inf"), np.longdouble("nan"), mpmath.mpf("nan"),
                                   mpmath.mpf("-inf")])
def test_numbers_that_are_not_finite_are_refused(given):
    with pytest.raises(edgeproof.InputError, match="R = .*not a finite number"):
        edgeproof.hertz(R=given)


@pytest.mark.parametrize("given", [None, True, np.bool_(False), 1j, [1], object(), b"1"])
def test_other_types_are_a_type_error(given):
    with pytest.raises(TypeError, match="m "):
        edgeproof.power_law(m=given, C=1)


def test_a_float_is_the_binary64_that_it_is():
    tenth = edgeproof.Scene(edgeproof.hertz(R=1), a="0.1", contact_modulus=1)
    float_tenth = edgeproof.Scene(edgeproof.hertz(R=1), a=0.1, contact_modulus=1)
    assert tenth.a.exact == Fraction(1, 10)
    assert float_tenth.a.exact == Fraction(0.1)
    assert float_tenth.a > tenth.a


def test_expressions_are_exact():
    scene = edgeproof.Scene(edgeproof.wedge("pi/16"), a="sqrt(2)", contact_modulus=1)
    with mpmath.workdps(45):
        assert mpmath.almosteq(scene.a.mpmath(), mpmath.sqrt(2), 1e-44)
        # P = E* phi a (Johnson, 5.1)
        assert mpmath.almosteq(scene.P.mpmath(), mpmath.pi / 16 * mpmath.sqrt(2), 1e-44)


def test_whole_numbers_and_lists_of_them(hertz):
    np = pytest.importorskip("numpy")
    assert hertz.pressure("0.1", digits=np.int64(20)).digits == 20
    assert [a.terms for a in hertz.approximation("0.1", terms=np.int64(2)).p_local] == [2]
    assert [a.terms for a in hertz.approximation("0.1", terms=np.array([1, 3])).p_local] == [1, 3]
    assert len(hertz.coefficients(np.int64(2), digits=np.array(9))) == 2
    assert hertz.peak().rounded(np.int64(2)) == "0.50"
    assert len(edgeproof.relations(["left.c0", "right.c0"], degree=np.int32(1),
                                   symmetric=np.bool_(1))) == 1
    for call in (lambda: hertz.pressure("0.1", digits="50"), lambda: hertz.pressure(b"0.1"),
                 lambda: hertz.pressure("0.1", digits=50.0), lambda: hertz.extent(terms="1"),
                 lambda: hertz.pressure("0.1", digits=True), lambda: hertz.coefficients(2.0),
                 lambda: hertz.approximation("0.1", terms=[1.5])):
        with pytest.raises(TypeError):
            call()
    for digits in (1, -5, 100_001, 10**30):
        with pytest.raises(edgeproof.InputError, match="digits = .* is out of range; give a number"):
            hertz.pressure("0.1", digits=digits)
