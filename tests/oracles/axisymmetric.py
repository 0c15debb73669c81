#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes axisymmetric.txt, a table as tests/scene/values.txt: drawn contacts of revolution, then some with curved slopes.

Sneddon's relations (1965): with r = s sin(t), the approach of the contact of radius s is h(s) = integral of s g'(r) dt;
delta = h(a), P = 2 E* a^2 times the integral of g'(r) sin(t)^2 dt, p = E*/pi times the integral of h'(s)/sqrt(s^2 - r^2) ds,
and c_k is a derivative of p/sqrt(u). h' of linear pieces and of power laws is written down, and compared with the integral
of g' + r g'' that gives it for curved slopes. Needs mpmath.
"""
import random
import re

import mpmath as mp

mp.mp.dps = 70
NAMES = {name: getattr(mp, name) for name in ("sqrt", "sinh", "exp", "log", "tanh", "asinh")} | {"mpf": mp.mpf}


def function(text):
    """g'(x) as a scene writes it."""
    text = re.sub(r"\d+(\.\d+)?(e-?\d+)?", r"mpf('\g<0>')", text).replace("^", "**")
    return eval("lambda x: " + text, NAMES)


def number(text):
    return function(text)(None)


def gauss(f, lo, hi):
    return mp.quad(f, [lo, hi], method="gauss-legendre")


class Body:
    def __init__(self, words):
        keys = dict(word.split("=", 1) for word in words.split() if "=" in word)
        self.E, self.power = number(keys["E"]), None
        if "m" in keys:
            self.power, C = number(keys["m"]), number(keys["C"])
            keys["slopes"] = f"({keys['C']})*x^({keys['m']})"
            self.kappa = C * mp.sqrt(mp.pi) / 2 * mp.gamma((self.power + 1) / 2) / mp.gamma(self.power / 2 + 1)
        if "t" in keys:
            keys |= {"knots": keys["t"], "slopes": f"0*x;(x-({keys['t']}))/({keys['R']})"}
        self.knots = [mp.mpf(0)] + [number(v) for v in keys.get("knots", "").split(";") if v]
        self.slopes = [function(g) for g in keys["slopes"].split(";")]
        self.jumps = [mp.mpf(0)] + [g(v) - f(v) for f, g, v in zip(self.slopes, self.slopes[1:], self.knots[1:])]
        self.linear = self.power is None and not re.search(r"x\^|[a-z]\(|exp|/sqrt", keys["slopes"])
        for s in (self.knots[-1] + 1, self.knots[-1] + mp.mpf(1) / 7):
            if self.power is not None or self.linear:
                assert abs(self.smooth(s) / self.by_angle(s) - 1) < mp.mpf(10) ** -40, words
        for key, f in (("a", None), ("P", self.force), ("delta", self.approach)):
            if key in keys:
                self.a = number(keys[key]) if f is None else self.size(f, number(keys[key]))

    def size(self, f, value):
        lo, hi = self.knots[-1] * 0, self.knots[-1] + 1
        while f(hi) < value:
            hi *= 2
        for _ in range(40):
            lo, hi = (lo, (lo + hi) / 2) if f((lo + hi) / 2) >= value else ((lo + hi) / 2, hi)
        return mp.findroot(lambda s: f(s) - value, (lo, hi), tol=mp.mpf(10) ** (6 - 2 * mp.mp.dps))

    def over_angle(self, s, f):
        """The integral of f(g', r, sin t) dt."""
        ends = [mp.asin(v / s) for v in self.knots if v < s] + [mp.pi / 2]
        method = gauss if self.power is None or self.power == int(self.power) else lambda g, lo, hi: mp.quad(g, [lo, hi])
        return sum(method(lambda t: f(self.slopes[i], s * mp.sin(t), mp.sin(t)), lo, hi)
                   for i, (lo, hi) in enumerate(zip(ends, ends[1:])))

    def approach(self, s):
        return s * self.over_angle(s, lambda g, r, sine: g(r))

    def force(self, s):
        return 2 * self.E * s * s * self.over_angle(s, lambda g, r, sine: g(r) * sine**2)

    def by_angle(self, s):
        if self.power is not None:
            return (self.power + 1) * self.over_angle(s, lambda g, r, sine: g(r))
        return self.over_angle(s, lambda g, r, sine: g(r) + r * mp.diff(g, r))

    def smooth(self, s):
        """h'(s) without J v/sqrt(s^2 - v^2) of the jumps J."""
        if self.power is not None:
            return self.kappa * (self.power + 1) * s**self.power
        if not self.linear:
            return self.by_angle(s)
        total, rate = self.slopes[0](mp.mpf(0)) * mp.pi / 2, mp.mpf(0)
        for v, g, J in zip(self.knots, self.slopes, self.jumps):
            if v < s:
                bend, rate = g(v + 1) - g(v) - rate, g(v + 1) - g(v)
                total += bend * (2 * mp.sqrt(s * s - v * v) - v * mp.acos(v / s)) + J * mp.acos(v / s)
        return total

    def pressure(self, u):
        a, r, total = self.a, abs(self.a - u), mp.mpf(0)
        ends = [r] + [v for v in self.knots if r < v < a] + [a]
        for A, B in zip(ends, ends[1:]):
            width = mp.sqrt(u * (2 * a - u) if (A, B) == (r, a) else (B - A) * (B + A))
            apart = [(A - v) * (A + v) for v in [*self.knots, r] if v < A]
            nearest = mp.sqrt(min([x for x in [*apart, A * A, width**2] if x > 0]))
            jumps = [(J * v, (A - v) * (A + v)) for J, v in zip(self.jumps, self.knots) if v <= A and J != 0]

            def integrand(w):
                s = mp.sqrt(A * A + w * w)
                root = mp.sqrt(w * w + (A - r) * (A + r))
                rate = self.smooth(s) * w + sum(j if v2 == 0 else j * w / mp.sqrt(w * w + v2) for j, v2 in jumps)
                return rate / (s * root)

            while width > nearest:
                total += gauss(integrand, width / 2, width)
                width /= 2
            total += gauss(integrand, mp.mpf(0), width)
        return self.E / mp.pi * total

    def coefficient(self, k):
        def rate(s):
            return self.smooth(s) + sum(J * v / mp.sqrt(s * s - v * v) for J, v in zip(self.jumps, self.knots) if v < s)

        def root_free(u):  # p/sqrt(u), s = a - u (1 - y^2)
            return self.E / mp.pi * gauss(lambda y: 2 * rate(self.a - u * (1 - y * y)) / mp.sqrt(2 * self.a - u * (2 - y * y)),
                                          mp.mpf(0), mp.mpf(1))
        return mp.taylor(root_free, 0, k)[k]


def drawn(n):
    """The words of the n-th drawn contact, and its knots."""
    def fraction(most):
        below = random.randint(5, 97)
        return f"{random.randint(1, below * most)}/{below}"
    slope, v, beyond, turn = fraction(1), fraction(2), fraction(1), n // 6
    w = f"({v}+{beyond})"
    words, knots = [
        (f"power-law C={fraction(2)} m={fraction(6)}", []),
        (f"power-law C={slope} m={turn % 2}", []),
        (f"flat-and-rounded t={v} R={fraction(20)}", [v]),
        (f"piecewise symmetric knots={v} slopes={slope}*x;{slope}*({v})", [v]),
        (f"piecewise symmetric knots={v} slopes=0*x;{slope}+0*x", [v]),
        (f"piecewise symmetric knots={v};{w} slopes={slope}+0*x;2*({slope})+x/5;2*({slope})+{w}/5+(x-{w})/3", [v, w]),
    ][n % 6]
    key = ("a", "P", "delta")[turn % 3]
    load = f"{knots[-1]}+1e-12" if turn % 4 == 3 and knots else f"{knots[-1]}+{fraction(1)}" if key == "a" and knots \
        else fraction(3)
    key = "a" if turn % 4 == 3 and knots else key
    return f"axisymmetric {words} {key}={load} E={fraction(9)}", knots


def row(words, places, orders):
    body = Body(words)
    asked = [("a", body.a), ("P", body.force(body.a)), ("delta", body.approach(body.a))]
    for place in places(body):
        key, x = place.split("=")
        asked.append((f"p {place}", body.pressure(number(x) if key == "u" else body.a - number(x))))
    asked += [(f"c_{k}", body.coefficient(k)) for k in orders]
    cells = [f"{name} ~ {mp.nstr(x, 50, min_fixed=-6, max_fixed=9, strip_zeros=False)}" for name, x in asked]
    print(f"{words} | digits=50 {' | '.join(cells)}", flush=True)


def places_near(knots):
    def places(body):
        near = [mp.nstr(body.a - number(v) + d * mp.mpf(10) ** -10, 40) for v in knots for d in (1, -1)]
        rest = [mp.nstr(body.a * x, 30) for x in (mp.mpf(random.random()), 1 - mp.mpf(10) ** -random.randint(1, 8))]
        return [f"u={u}" for u in ["1e-30"] + [u for u in near + rest if 0 < mp.mpf(u) < body.a][:4]]
    return places


def curved(knots, slopes, load):
    row(f"axisymmetric piecewise symmetric knots={knots} slopes={slopes} {load}",
        lambda body: ["u=1e-30", "u=1/7", "x=0", "x=1e-3"], [0, 1])


def main():
    random.seed(350)
    print("# mpmath 1.2.1, tests/oracles/axisymmetric.py > axisymmetric.txt; see tests/scene/values.txt")
    curved("1/2", "0*x;sinh(x-1/2)", "P=1 E=7/3")
    for n in range(48):
        if n == 12:
            print("slow")
        words, knots_drawn = drawn(n)
        row(words, places_near(knots_drawn), [(n // 6 + n) % 3])
    flank = "x;1/2+(x-1/2)*exp(x)"
    for each in [("", "sinh(x)", "P=1 E=7/3"), ("1/2", flank, "delta=1 E=7/3"), ("1/2", flank, "a=1 E=7/3"),
                 ("1/3", "x^2;1/4+log(1+x)", "a=1/3+1e-12 E=7/3"), ("", "x/sqrt(4-x^2)", "a=3/2 E=7/3"),
                 # the curved scenes of reference/axisymmetric.toml
                 ("", "x/sqrt(4-x^2)", "a=5/4 E=1"), ("", "x/2+x^3", "a=5/4 E=1"), ("1/2", flank, "P=1 E=1"),
                 ("1/2", flank, "a=1/2+1e-12 E=1")]:
        curved(*each)


if __name__ == "__main__":
    main()
