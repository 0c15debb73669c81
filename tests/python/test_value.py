# SPDX-License-Identifier: GPL-3.0-or-later
import copy
import pickle
from decimal import Decimal
from fractions import Fraction

import pytest

import edgeproof

mpmath = pytest.importorskip("mpmath")


@pytest.fixture(scope="module")
def root(hertz):
    """p = sqrt(0.19)/2 at x = 0.9."""
    return hertz.pressure("0.1")


def test_text_is_rounded_and_within_the_bound(root):
    with mpmath.workdps(80):
        exact = mpmath.sqrt(mpmath.mpf(19) / 100) / 2
        assert root.text == mpmath.nstr(exact, 50, strip_zeros=False)
        assert abs(mpmath.mpf(root.text) - exact) <= mpmath.mpf(root.bound) < mpmath.mpf(10)**-49
    assert root.proved and root.route == "closed-form"
    assert root.digits == 50 and root.complete and root.exact is None


def test_interval_encloses(root):
    low, high = root.interval()
    exact = Fraction(19, 400)  # of p^2
    assert low**2 < exact < high**2
    assert high - low < Fraction(1, 10**50)


def test_float_is_the_nearest(root):
    import math

    f = float(root)
    exact = Fraction(19, 400)
    below, above = math.nextafter(f, 0), math.nextafter(f, 1)
    assert ((Fraction(below) + Fraction(f)) / 2)**2 < exact < ((Fraction(f) + Fraction(above)) / 2)**2


@pytest.mark.parametrize("digits", [2, 3, 17, 100])
def test_digits(hertz, digits):
    v = hertz.pressure("0.1", digits=digits)
    with mpmath.workdps(digits + 20):
        assert v.text == mpmath.nstr(mpmath.sqrt(mpmath.mpf(19) / 100) / 2, digits,
                                     strip_zeros=False)
    assert float(v) == float(hertz.pressure("0.1"))


def test_conversions_state_the_text(root):
    assert root.fraction() == Fraction(root.text)
    assert root.decimal() == Decimal(root.text)
    assert str(root) == root.text == f"{root}"
    assert f"{root:.3f}" == f"{Decimal(root.text):.3f}"
    with mpmath.workdps(55):
        assert root.mpmath() == mpmath.mpf(root.text)
        assert mpmath.almosteq(mpmath.mpf(root), root.mpmath(), 1e-50)
        assert mpmath.almosteq(mpmath.sqrt(root)**2, root.mpmath(), 1e-50)


def test_rounded_from_the_value_itself(root):
    with mpmath.workdps(60):
        exact = mpmath.sqrt(mpmath.mpf(19) / 100) / 2
        for n in (2, 10, 40):
            assert root.rounded(n) == mpmath.nstr(exact, n, strip_zeros=False)


def test_comparisons(hertz, root):
    p = hertz.pressure("0.2")
    assert p > root and root < p and p >= root and not p <= root and p != root and not p == root
    assert root > 0 and root < 1 and 0 < root and root != 0.25 and bool(root)
    assert root > Fraction(217, 1000) and root < Decimal("0.218") and root < mpmath.mpf("0.218")
    assert root == root


def test_comparison_is_refused_where_bounds_overlap(hertz, root):
    again = hertz.pressure("1/10")
    for compare in (lambda: root == again, lambda: root < again, lambda: root != again,
                    lambda: root <= again):
        with pytest.raises(edgeproof.UndecidedError, match="overlap.*more digits"):
            compare()
    with pytest.raises(ArithmeticError):
        _ = root < root.interval()[1]


def test_exact_values_compare_exactly(hertz):
    assert hertz.a == 1 and hertz.a == hertz.b and not hertz.a < 1
    assert hertz.a.exact == 1
    # x = 4/5: p = 3/10, which no enclosure distinguishes from its neighbours
    assert hertz.pressure("1/5").text == "0.3" + "0" * 49
    assert float(hertz.pressure("1/5")) == 0.3


def test_no_order_with_other_types(root):
    assert root != "0.2" and not root == None  # noqa: E711
    with pytest.raises(TypeError):
        _ = root < "1"
    with pytest.raises(edgeproof.InputError):
        _ = root < float("nan")
    with pytest.raises(TypeError):
        hash(root)


def test_copies(root, hertz):
    for v in (root, hertz.a, hertz.M):
        for other in (pickle.loads(pickle.dumps(v)), copy.copy(v), copy.deepcopy(v)):
            assert (other.text, other.bound, other.proved, other.route, other.digits) == (
                v.text, v.bound, v.proved, v.route, v.digits)
            assert other.interval() == v.interval() and other.exact == v.exact


def test_zero(hertz):
    assert hertz.M.text == "0" and float(hertz.M) == 0.0 and not hertz.M
    assert repr(float(hertz.M)) == "0.0"


def test_an_estimate_is_called_so():
    # the rigorous integration does not support erf in g'
    scene = edgeproof.Scene(edgeproof.piecewise([], ["x + x^3"], symmetric=True), a="1/2",
                            contact_modulus=1)
    p = scene.pressure("1/4", digits=12)
    assert p.proved is True  # polynomials are integrated rigorously
    assert repr(p).startswith("<edgeproof.Value 0.")


def test_to_dict(root):
    assert root.to_dict() == {"text": root.text, "bound": root.bound, "proved": True,
                              "route": "closed-form"}
