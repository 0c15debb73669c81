# SPDX-License-Identifier: GPL-3.0-or-later
import copy
import operator
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


OPERATIONS = {"+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv}


@pytest.mark.parametrize("sign", OPERATIONS)
def test_arithmetic_encloses_the_exact_result(hertz, root, sign):
    """Compares with interval arithmetic in exact fractions: the result contains that of every pair
    of ends, and is at most a little wider."""
    op = OPERATIONS[sign]
    values = [root, -root, hertz.pressure("1/7"), hertz.pressure("1e-20", digits=20), hertz.a]
    numbers = [3, -2, Fraction(22, 7), Decimal("0.1"), 0.25, mpmath.mpf("0.125"), hertz.P]

    def ends_of(x):
        return x.interval() if isinstance(x, edgeproof.Value) else (Fraction(str(x)),) * 2

    pairs = [(x, y) for x in values for y in values + numbers]
    for x, y in pairs + [(y, x) for x, y in pairs if not isinstance(y, mpmath.mpf)]:
        result = op(x, y)
        corners = [op(p, q) for p in ends_of(x) for q in ends_of(y)]
        low, high = result.interval()
        assert low <= min(corners) and max(corners) <= high, (x, sign, y)
        width = max(corners) - min(corners)
        assert high - low <= width * Fraction(1001, 1000) + abs(high) / 2**150, (x, sign, y)
        assert result.proved and result.route == "arithmetic"
        assert result.digits <= max(v.digits for v in (x, y) if isinstance(v, edgeproof.Value))


def test_arithmetic_rounds_correctly(hertz, root):
    with mpmath.workdps(80):
        r = mpmath.sqrt(mpmath.mpf(19) / 100) / 2
        for value, exact in ((2 * root + 1, 2 * r + 1), (1 / root, 1 / r), (-root, -r),
                             (abs(-root / 3), r / 3), (root * root - 1, r * r - 1),
                             (sum([root, root, root]), 3 * r)):
            assert value.text == mpmath.nstr(exact, value.digits, strip_zeros=False)
            assert value.digits == 50
    # p = 3/10 in one factor: 0.3/0.21794..., to the digits of the less precise one
    assert (hertz.pressure("1/5", digits=20) / root).digits == 20


def test_exact_arithmetic_stays_exact(hertz):
    third = hertz.a / 3
    assert third.exact == Fraction(1, 3) and third * 3 == 1 and third + third == Fraction(2, 3)
    assert (hertz.a - hertz.b).exact == 0 and repr(hertz.a + 1) == \
        "<edgeproof.Value 2.000000000000000000000000... (50 digits), exact, arithmetic>"


def test_a_difference_has_only_its_certain_digits(hertz):
    """p(u) = sqrt(u (2 - u))/2 at u = 1 and 1 - 1e-18: the difference is 5e-37/(1 + ...)/2."""
    near = Fraction(1) - Fraction(1, 10**18)
    difference = hertz.pressure("1", digits=40) - hertz.pressure(near, digits=40)
    assert 2 <= difference.digits < 40 and difference.complete
    with mpmath.workdps(120):
        u = mpmath.mpf(10)**18
        exact = mpmath.mpf(1) / 2 - mpmath.sqrt(1 - 1 / u**2) / 2
        assert difference.text == mpmath.nstr(exact, difference.digits, strip_zeros=False,
                                              min_fixed=-4)
    zero = hertz.pressure("0.1") - hertz.pressure("1/10")
    low, high = zero.interval()
    assert low <= 0 <= high and zero.text == "0"
    with pytest.raises(edgeproof.UndecidedError):
        bool(zero)
    with pytest.raises(edgeproof.UndecidedError, match="divisor may be zero"):
        1 / zero


def test_arithmetic_that_is_refused(hertz, root):
    for divisor in (0, hertz.M):
        with pytest.raises(ZeroDivisionError):
            root / divisor
    for other in ("1", b"1", None, True, [1]):
        with pytest.raises(TypeError):
            root + other
        with pytest.raises(TypeError):
            other * root
    with pytest.raises(edgeproof.InputError, match="not a finite number"):
        root * float("inf")
    with pytest.raises(edgeproof.InputError, match="beyond the range"):
        power = root
        for _ in range(40):
            power = power * power


def test_numpy_applies_arithmetic_to_each_element(root):
    np = pytest.importorskip("numpy")
    for result in (root * np.array([1.0, 2.0]), np.array([1.0, 2.0]) * root):
        assert result.shape == (2,) and result[1].interval() == (2 * root).interval()
    assert (np.float64(2) * root).interval() == (2 * root).interval()
    one = root * np.array([2])
    assert one.shape == (1,)


def test_an_estimate_stays_an_estimate(hertz):
    scene = edgeproof.Scene.from_text(hertz.text + "[ask]\nroute = \"barber-mossakovskii\"\n")
    p = scene.pressure("1/4", digits=12)
    assert not p.proved
    for value in (p + 1, 1 - p, p * hertz.pressure("0.1"), hertz.pressure("0.1") / p, -p):
        assert not value.proved and "estimated bound" in repr(value)


def test_repr_is_one_line(hertz, root):
    assert repr(root) == ("<edgeproof.Value 0.217944947177033677611849... (50 digits), "
                          f"bound {root.bound}, closed-form>")
    assert repr(hertz.pressure("0.1", digits=10)).startswith("<edgeproof.Value 0.2179449472, ")
    many = hertz.pressure("1e-40", digits=3000)
    assert len(repr(many)) < 100 and "\n" not in repr(many) and "e-21 (3000 digits)" in repr(many)


def test_notebooks_show_the_value(hertz, root):
    page = root._repr_html_()
    assert root.text in page and root.bound in page and "closed-form" in page
    assert "\n" not in page and page.startswith("<span") and page.endswith("</span>")
    zero = hertz.pressure("0.1") - hertz.pressure("1/10")
    assert zero.text in zero._repr_html_()


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
        pickled = [pickle.loads(pickle.dumps(v, protocol))
                   for protocol in range(pickle.HIGHEST_PROTOCOL + 1)]
        for other in (*pickled, copy.copy(v), copy.deepcopy(v)):
            assert (other.text, other.bound, other.proved, other.route, other.digits) == (
                v.text, v.bound, v.proved, v.route, v.digits)
            assert other.interval() == v.interval() and other.exact == v.exact


def test_zero(hertz):
    assert hertz.M.text == "0" and float(hertz.M) == 0.0 and not hertz.M
    assert repr(float(hertz.M)) == "0.0"


def test_to_dict(root):
    assert root.to_dict() == {"text": root.text, "bound": root.bound, "proved": True,
                              "route": "closed-form"}
