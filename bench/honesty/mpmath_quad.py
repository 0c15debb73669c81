# SPDX-License-Identifier: GPL-3.0-or-later
"""Uses mpmath's quad as in the first example of its manual: reads lines of
id digits kind a u K m t gamma, writes id, p and the absolute error that quad claims."""
import sys

import mpmath
from mpmath import mp, mpf

for line in sys.stdin:
    id_, digits, kind, *numbers = line.split()
    mp.dps = int(digits)
    a, u, K, m, t, gamma = map(mpf, numbers)
    x = a - u

    def f(s):
        rate = K * s * mpmath.acos(t / s) if kind == "flat" else K * s**m
        return rate / mpmath.sqrt((s - x) * (x + gamma * s))

    try:
        value, error = mpmath.quad(f, [t if kind == "flat" and x < t else x, a], error=True)
        print(id_, mpmath.nstr(value / mp.pi, mp.dps), mpmath.nstr(error / mp.pi, 5))
    except (ArithmeticError, ValueError, TypeError):
        pass  # a missing value counts as a reported failure
