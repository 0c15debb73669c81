# SPDX-License-Identifier: BSD-3-Clause
import operator
from decimal import Decimal
from fractions import Fraction

import pytest

import edgeproof

mpmath = pytest.importorskip("mpmath")


@pytest.fixture(scope="module")
def root(hertz):
    """p = sqrt(0.19)/2 at x = 0.9."""
    return hertz.pressure("0.1")


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
