#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes stress_of_revolution.txt, a table as tests/scene/values.txt: stresses inside bodies of revolution.

A body is a sum of flat punches of the radius s, each under the pressure of the approach h'(s) ds,
h(s) = s times the integral of g'(r)/sqrt(s^2 - r^2). The stresses of one punch are Sneddon's real
formulas (Proc. Cambridge Phil. Soc. 42 (1946), 29-39), integrated by Gauss-Legendre rules. E* = 1, a = 1, nu = 3/10. Needs mpmath.
"""
import random
import re
from fractions import Fraction
import axisymmetric
import mpmath as mp
from mpmath.calculus.quadrature import GaussLegendre

BODIES = [(words, axisymmetric.Body(words + " a=1 E=1")) for words in [
    "flat-and-rounded t=3/10 R=1", "piecewise symmetric knots=1/8;1/2 slopes=x;3/4*x+1/32;3/4*x+1/32",
    "piecewise symmetric knots=1/2 slopes=x;3*x-1", "piecewise symmetric knots=1/3;4/5 slopes=x/2;2*x-1/2;x+3/10",
    "flat-and-rounded t=9/10 R=1", "power-law m=1/3 C=1/2", "power-law m=0 C=1/2", "power-law m=4 C=1"]]
mp.mp.dps = 25  # the bodies compare h' with its integral at more digits
NU = mp.mpf(3) / 10
PANELS = 8
RULE = GaussLegendre(mp.mp).calc_nodes(5, mp.mp.prec)


def punch(s, r, z):
    """sxx, szz, sxz and syy for the pressure 1 at the center."""
    rho, zeta = r / s, z / s
    big = mp.sqrt((rho**2 + zeta**2 - 1) ** 2 + 4 * zeta**2)
    phi = mp.atan2(2 * zeta, rho**2 + zeta**2 - 1)
    theta = mp.atan2(1, zeta)
    root = mp.sqrt(1 + zeta**2)
    j10 = mp.sin(phi / 2) / mp.sqrt(big)
    j20 = root * mp.sin(3 * phi / 2 - theta) / big**1.5
    szz = -(j10 + zeta * j20)
    if r == 0:
        return -(1 + NU) * j10 - szz / 2, szz, mp.mpf(0), -(1 + NU) * j10 - szz / 2
    j01 = (1 - mp.sqrt(big) * mp.sin(phi / 2)) / rho
    j11 = root / rho * mp.sin(theta - phi / 2) / mp.sqrt(big)
    j21 = rho * mp.sin(3 * phi / 2) / big**1.5
    hoop = -(2 * NU * j10 + ((1 - 2 * NU) * j01 - zeta * j11) / rho)
    radial = -2 * (1 + NU) * j10 - hoop - szz
    return radial, szz, -zeta * j21, hoop


def stresses(body, r, z):
    r, z = mp.mpf(r.numerator) / r.denominator, mp.mpf(z.numerator) / z.denominator
    ends = sorted({mp.mpf(x) for x in (0, 1, *body.knots, *([r] if r < 1 else [])) if x <= 1})

    total = [mp.mpf(0)] * 4
    for lo, hi in zip(ends, ends[1:]):
        for panel in range(PANELS):
            for node, weight in RULE:
                # s = lo + (hi - lo) t^2 removes the root of h' at a knot
                t = (panel + (1 + node) / 2) / PANELS
                s = lo + (hi - lo) * t * t
                share = body.smooth(s) / s * weight / PANELS * (hi - lo) * t
                if share != 0:
                    total = [x + share * y for x, y in zip(total, punch(s, r, z))]
    return [x / mp.pi for x in total]


random.seed(18)
with open("stress_of_revolution.txt", "w") as out:
    out.write("# mpmath 1.2.1, tests/oracles/stress_of_revolution.py; see tests/scene/values.txt\n")
    for place in range(136):
        words, body = BODIES[place % len(BODIES)]
        r = Fraction(random.randint(20, 1500), 1000) if place % 5 != 4 else Fraction(0)
        z = Fraction(random.randint(20, 1000), 1000) if place % 7 != 6 or r == 0 else Fraction(0)
        values = zip(["sxx", "szz", "sxz", "syy"], stresses(body, r, z))
        cells = [f"{name} ~ {mp.nstr(mp.mpf(x), 30, min_fixed=-99, max_fixed=99)}" for name, x in values]
        cells = [re.sub(r"(\.\d{12})\d*", r"\1", cell) for cell in cells]
        slow = "slow\n" if place == 16 else ""
        out.write(f"{slow}axisymmetric {words} a=1 nu=3/10 | at={r},{z} {' | '.join(cells)}\n")
        out.flush()
