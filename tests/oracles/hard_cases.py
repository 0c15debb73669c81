#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Computes the values of reference/hard-cases.toml with mpmath, without Edgeproof: a table as tests/scene/values.txt.

    tests/oracles/hard_cases.py > tests/oracles/hard-cases.txt
    tests/oracles/hard_cases.py --only 'edge-*'

--check only compares the questions of the table with those of reference/hard-cases.toml.

Plane contacts -b < x < a of a slope g'. With t = sqrt((a - s)/(s + b)) and w = sqrt((a - s)(s + b)),
    integral of ds/((s - x) w) = log((t - t_x)/(t + t_x))/w(x),    integral of ds/w = -2 atan(t),
so that a slope of linear pieces has logarithmic sums for p (eqn:SIEPressure) and for the integral of
p(s)/(zeta - s), from which the stresses follow (muskhelishvili1977). Power laws: hypergeometric
functions. Coefficients: Cauchy's integral of p/sqrt(u) over a circle. Extents: bisection. Bodies of
revolution: axisymmetric.py.
"""
import argparse
import ast
import fnmatch
import importlib.util
import pathlib
import re
import sys
import tomllib

if importlib.util.find_spec("mpmath") is None:
    print("skipped: Python has no package mpmath (python3-mpmath)")
    sys.exit(77)
import axisymmetric
import mpmath
from mpmath import mp, mpf, mpc, pi, sqrt, log, atan

ROOT = pathlib.Path(__file__).resolve().parents[2]
DIGITS = 50


def exact(text, **names):
    """The number that a text such as `pi/8 + 1e-25` is, to the working precision."""
    python = re.sub(r"\d+\.?\d*(?:e[+-]?\d+)?", lambda m: f"mpf('{m[0]}')", str(text)).replace("^", "**")
    ast.parse(python, mode="eval")
    known = {"mpf": mpf, "pi": +pi, "sqrt": sqrt, "atan": atan}
    return mpf(eval(python, {"__builtins__": {}}, known | names))  # pylint: disable=eval-used


def bisected(f, lo, hi):
    """The zero of an increasing f to the working precision."""
    while f(hi) < 0:
        lo, hi = hi, 2 * hi
    while f(lo) > 0:
        lo, hi = lo / 2, lo
    for _ in range(120):
        middle = (lo + hi) / 2
        lo, hi = (middle, hi) if f(middle) < 0 else (lo, middle)
    # The Illinois method
    f_lo, f_hi, last, side, size = f(lo), f(hi), hi, 0, abs(f(2 * hi))
    for _ in range(300):
        if f_lo == 0 or f_hi == f_lo:
            return lo
        now = (lo * f_hi - hi * f_lo) / (f_hi - f_lo)
        value = f(now)
        if abs(value) <= size * mpf(10) ** (20 - mp.dps) or abs(now - last) <= abs(now) * mpf(10) ** (40 - mp.dps):
            return now
        last = now
        if value < 0:
            lo, f_lo = now, value
            f_hi = f_hi / 2 if side < 0 else f_hi
        else:
            hi, f_hi = now, value
            f_lo = f_lo / 2 if side > 0 else f_lo
        side = -1 if value < 0 else 1
    raise ArithmeticError("no zero")


def polynomial(slope):
    """The coefficients of a slope of at most the third degree."""
    d = [exact(slope, x=mpf(k)) for k in range(4)]
    differences = []
    while d:
        differences.append(d[0])
        d = [y - x for x, y in zip(d, d[1:])]
    f0, f1, f2, f3 = differences
    found = [f0, f1 - f2 / 2 + f3 / 3, f2 / 2 - f3 / 2, f3 / 6]
    return [x if abs(x) > mpf(10) ** (20 - mp.dps) else mpf(0) for x in found]


def wallis(n):
    """The integral of sin^n over a right angle."""
    return sqrt(pi) / 2 * mpmath.gamma((n + 1) / 2) / mpmath.gamma((n + 2) / 2)


def knots_and_pieces(profile, upright=False):
    """g' as polynomials between knots."""
    kind = profile["kind"]
    number = {k: exact(v) for k, v in profile.items() if k in ("t", "R", "phi", "alpha")}
    alpha = mpf(0) if upright else number.get("alpha")
    zero = [mpf(0)] * 2
    if kind == "flat-and-rounded":
        t, R = number["t"], number["R"]
        return [-t, t], [[t / R, 1 / R] + zero, [mpf(0)] + zero + [mpf(0)], [-t / R, 1 / R] + zero]
    if kind == "tilted-wedge":
        return [mpf(0)], [[-number["phi"] - alpha, mpf(0)] + zero, [number["phi"] - alpha, mpf(0)] + zero]
    if kind == "tilted-flat-and-rounded":
        t, R = number["t"], number["R"]
        return [-alpha * R - 2 * t, -alpha * R], [[2 * t / R, 1 / R] + zero, [-alpha, mpf(0)] + zero, [mpf(0), 1 / R] + zero]
    knots = [exact(k) for k in profile["knots"]]
    pieces = [polynomial(s) for s in profile["slopes"]]
    if profile.get("symmetric"):
        mirrored = [[-c if k % 2 == 0 else c for k, c in enumerate(p)] for p in pieces]
        middle = pieces[:1] if pieces[0] == mirrored[0] else [mirrored[0], pieces[0]]
        knots = [-k for k in reversed(knots)] + [mpf(0)] * (len(middle) - 1) + knots
        pieces = mirrored[:0:-1] + middle + pieces[1:]
    return knots, pieces


class PowerLaw:
    """g' = C sgn(x) |x|^m."""

    def __init__(self, m, C, modulus, a=None, P=None):
        self.m, self.C, self.modulus = m, C, modulus
        self.a = self.b = a if a is not None else (P / (modulus * C * wallis(m + 1))) ** (1 / (m + 1))
        self.radius = self.a

    def force(self):
        return self.modulus * self.C * self.a ** (self.m + 1) * wallis(self.m + 1)

    def over_root(self, u):
        """p/sqrt(u), analytic at the edge."""
        a, m = self.a, self.m
        z = u * (2 * a - u) / a**2
        rate = self.modulus * self.C * (m + 1) * wallis(m + 1) / pi
        return rate * sqrt(2 * a - u) * a ** (m - 1) * mpmath.hyp2f1((1 - m) / 2, 1, mpf(3) / 2, z)


class Pieces:
    """g' as polynomials between knots; the right edge is given, or the force of a symmetric contact."""

    def __init__(self, knots, pieces, modulus, a=None, P=None, symmetric=False):
        self.knots, self.pieces, self.modulus = knots, pieces, modulus
        if a is None:
            a = bisected(lambda a: self.force(a, a) - P, mpf(1), mpf(2))
        self.a = a
        self.b = a if symmetric else bisected(lambda b: -self.turning(a, b, 0), a / 2, a)
        inside = [k for k in knots if -self.b < k < a]
        self.radius = min([a + self.b] + [a - k for k in inside])

    def mirrored(self):
        other = object.__new__(Pieces)
        other.knots = [-k for k in reversed(self.knots)]
        other.pieces = [[-c if k % 2 == 0 else c for k, c in enumerate(p)] for p in reversed(self.pieces)]
        other.modulus, other.a, other.b = self.modulus, self.b, self.a
        other.radius = min([self.a + self.b] + [other.a - k for k in other.knots if -other.b < k < other.a])
        return other

    def spans(self, a, b):
        ends = [-b] + [min(max(k, -b), a) for k in self.knots] + [a]
        return [(lo, hi, p) for lo, hi, p in zip(ends, ends[1:], self.pieces) if lo < hi]

    def turning(self, a, b, power):
        """The integral of g'(s) (s - c)^power/w for linear pieces, power 0 or 1; s = c + d cos(h)."""
        c, d, total = (a - b) / 2, (a + b) / 2, mpf(0)
        for lo, hi, (A, B, *_) in self.spans(a, b):
            def primitive(s):
                h = mpmath.acos((s - c) / d) if abs(s - c) < d else mpf(0) if s > c else +pi
                if power == 0:
                    return (A + B * c) * h + B * d * mpmath.sin(h)
                return (A + B * c) * d * mpmath.sin(h) + B * d**2 * (h / 2 + mpmath.sin(2 * h) / 4)
            total += primitive(lo) - primitive(hi)
        return total

    def force(self, a=None, b=None):
        return self.modulus / 2 * self.turning(a or self.a, b or self.b, 1)

    def t(self, s):
        return sqrt((self.a - s) / (s + self.b)) if s > -self.b else mpf("inf")

    def rest(self, quotient, lo, hi):
        """The integral of a polynomial over w."""
        if not any(quotient[1:]):
            angles = [pi if t == mpf("inf") else 2 * atan(t) for t in (self.t(lo), self.t(hi))]
            return quotient[0] * (angles[0] - angles[1])
        c, d = (self.a - self.b) / 2, (self.a + self.b) / 2
        return mpmath.quad(lambda h: mpmath.polyval(quotient[::-1], c + d * mpmath.cos(h)),
                           [mpmath.acos((hi - c) / d), mpmath.acos((lo - c) / d)], method="gauss-legendre")

    def sums(self, x, logarithm):
        """The integral of g'(s)/((s - x) w), and the same times w(x): (logarithms, rest)."""
        logs = rest = mpf(0)
        for lo, hi, piece in self.spans(self.a, self.b):
            quotient, value = [], mpf(0)
            for coefficient in reversed(piece):
                quotient.insert(0, value)
                value = value * x + coefficient
            quotient.pop()
            logs += value * (logarithm(self.t(hi)) - logarithm(self.t(lo)))
            rest += self.rest(quotient, lo, hi) if any(quotient) else 0
        return logs, rest

    def over_root(self, u):
        length = self.a + self.b
        t_x = sqrt(u / (length - u))

        def logarithm(t):
            if t == 0 or t == mpf("inf"):
                return mpf(0)
            if isinstance(u, mpc):
                return log((t - t_x) / (t + t_x))
            return log(abs((t - t_x) / (t + t_x)))

        logs, rest = self.sums(self.a - u, logarithm)
        return self.modulus / (2 * pi) * (logs / sqrt(u) + sqrt(length - u) * rest)

    def potential(self, zeta):
        """The integral of p(s)/(zeta - s)."""
        W = sqrt(zeta - self.a) * sqrt(zeta + self.b)
        t_z = sqrt((self.a - zeta) / (zeta + self.b))
        w = t_z * (zeta + self.b)  # the root with the branch of t_z

        def logarithm(t):
            return mpf(0) if t == mpf("inf") else log((t - t_z) / (t + t_z))

        logs, rest = self.sums(zeta, logarithm)
        return -self.modulus / 2 * W * (logs / w + rest)


def contact_of(case, upright=False, P=None):
    profile, load = case["profile"], case["load"]
    modulus = exact(load["contact_modulus"])
    given = {"P": P} if P is not None else {k: exact(load[k]) for k in ("a", "P") if k in load}
    if profile["kind"] == "power-law":
        m, C = exact(profile["m"]), exact(profile["C"])
        if case["quantity"] not in ("sxx", "szz", "sxz"):
            return PowerLaw(m, C, modulus, **given)
        zero = [mpf(0)] * 2
        if m == 1:
            return Pieces([], [[mpf(0), C] + zero], modulus, symmetric=True, **given)
        if m == 0:
            return Pieces([mpf(0)], [[-C, mpf(0)] + zero, [C, mpf(0)] + zero], modulus, symmetric=True, **given)
        raise ValueError("stresses of power laws: m is 0 or 1")
    symmetric = profile["kind"] == "flat-and-rounded" or profile.get("symmetric", False)
    if profile["kind"] == "tilted-wedge" and (upright or exact(profile["alpha"]) == 0):
        symmetric = True
    return Pieces(*knots_and_pieces(profile, upright), modulus, symmetric=symmetric, **given)


def at_edge(contact, case):
    return contact if case.get("edge") == "right" or isinstance(contact, PowerLaw) else contact.mirrored()


def pressure(contact, u):
    return sqrt(u) * contact.over_root(u)


def coefficients(contact, count, decades):
    """By Cauchy's integral over a circle of the radius of convergence times 10^-decades."""
    nodes = count + 24
    r = contact.radius * mpf(10) ** -decades
    turns = [mpmath.expjpi(mpf(2 * j) / nodes) for j in range(nodes)]
    values = [contact.over_root(r * turn) for turn in turns]
    return [mpmath.re(sum(v * turns[(-j * k) % nodes] for j, v in enumerate(values))) / nodes / r**k
            for k in range(count)]


def extent(contact, n, tolerance):
    """The first place where |1 - (n terms)/p| exceeds the tolerance, between maxima found by thirds."""
    c = coefficients(contact, n, 10)

    def error(u):
        return abs(1 - mpmath.polyval(c[::-1], u) / contact.over_root(u))

    length = (contact.a + contact.b) * (1 - mpf(2) ** mpf("-15.25"))
    grid = sorted([length * mpf(10) ** (mpf(i) / 40) for i in range(-400, 0)] + [length * i / 400 for i in range(1, 400)]
                  + [length * (1 - mpf(10) ** (mpf(i) / 40)) for i in range(-160, -40)])
    errors = []
    for i, u in enumerate(grid):
        errors.append(error(u))
        inside, outside = (grid[i - 1], u) if errors[i] >= tolerance else (None, None)
        if i > 1 and inside is None and errors[i - 2] < errors[i - 1] >= errors[i] and errors[i - 1] > tolerance / 2:
            lo, hi = grid[i - 2], u
            for _ in range(int(60 * 2.3 * 2.5)):  # by thirds to half of the working digits
                third = (hi - lo) / 3
                lo, hi = (lo + third, hi) if error(lo + third) < error(hi - third) else (lo, hi - third)
            if error((lo + hi) / 2) >= tolerance:
                inside, outside = grid[i - 2], (lo + hi) / 2
        if outside is not None:
            while outside - inside > outside * mpf(10) ** -72:
                middle = (inside + outside) / 2
                inside, outside = (middle, outside) if error(middle) < tolerance else (inside, middle)
            return outside
    raise ValueError("the approximation stays within the tolerance")


def stress(case):
    x, z = exact(case["x"]), exact(case["z"])
    zeta, shear = mpc(x, z), case.get("shear", {})
    contact = contact_of(case)
    Q, tension = exact(shear.get("Q", "0")), exact(shear.get("bulk_tension", "0"))
    if "friction" in shear:  # slip: q is the difference of two pressures times the friction
        f = exact(shear["friction"])
        inner = contact_of(case, P=exact(case["load"]["P"]) - abs(Q) / f)
        side = f if Q > 0 else -f

        def of_q(zeta):
            return side * (contact.potential(zeta) - inner.potential(zeta))
    else:  # full stick: q = (Q/pi + tension (s - c)/4)/w
        c = (contact.a - contact.b) / 2

        def of_q(zeta):
            W = sqrt(zeta - contact.a) * sqrt(zeta + contact.b)
            return (Q / pi + tension * (zeta - c) / 4) * pi / W - tension * pi / 4

    h = z * mpf(10) ** -(mp.dps // 4)
    P, T = contact.potential(zeta), of_q(zeta)
    P1 = (contact.potential(zeta + h) - contact.potential(zeta - h)) / (2 * h)
    T1 = (of_q(zeta + h) - of_q(zeta - h)) / (2 * h)
    found = {"sxx": P.imag + z * P1.real - 2 * T.real + z * T1.imag,
             "szz": P.imag - z * P1.real - z * T1.imag,
             "sxz": T.imag + z * T1.real - z * P1.imag}[case["quantity"]]
    return found / pi  # of body A, whose bulk stress bulk_A is 0 in all cases


def shear_over_root(contact, case, u):
    """sqrt(u) q in full stick, the edge at u = 0."""
    Q, tension = exact(case["shear"]["Q"]), exact(case["shear"]["bulk_tension"])
    side = 1 if case["edge"] == "right" else -1
    length = contact.a + contact.b
    return (Q / pi + side * tension * (length / 2 - u) / 4) / sqrt(length - u)


def body_of(case):
    """The body of revolution, with h' as the integral that defines it."""
    def words(keys):
        return [f"{k}={';'.join(v) if isinstance(v, list) else v}".replace(" ", "") for k, v in keys.items()]
    load = {k: v for k, v in case["load"].items() if k != "contact_modulus"} | {"E": case["load"]["contact_modulus"]}
    return axisymmetric.Body(" ".join(words(case["profile"]) + words(load)))


def value(case):
    quantity, n = case["quantity"], case.get("n")
    u = exact(case["u"]) if "u" in case else None
    if case["profile"].get("geometry") == "axisymmetric":
        body = body_of(case)
        return {"pressure": lambda: body.pressure(u), "load": lambda: body.force(body.a),
                "approach": lambda: body.approach(body.a)}[quantity]()
    if quantity in ("sxx", "szz", "sxz"):
        return stress(case)
    contact = contact_of(case)
    if quantity == "load":
        return contact.force()
    if quantity == "left-edge":
        return contact.b
    if quantity == "tilt-difference":
        return pressure(at_edge(contact, case), u) - pressure(at_edge(contact_of(case, upright=True), case), u)
    if quantity == "shear":
        return shear_over_root(contact, case, u) / sqrt(u)
    if quantity == "shear-coefficient":
        return mpmath.taylor(lambda u: shear_over_root(contact, case, u), 0, n)[n]
    contact = at_edge(contact, case)
    if quantity == "pressure":
        return pressure(contact, u)
    if quantity == "coefficient":
        return coefficients(contact, n + 1, 10)[n]
    if quantity == "residual":
        return 1 - mpmath.polyval(coefficients(contact, n, 12)[::-1], u) / contact.over_root(u)
    return extent(contact, n, exact(case["tolerance"]))


SYMBOLS = {"pressure": "p", "coefficient": "c_{n}", "extent": "extent_{n}", "load": "P", "left-edge": "b", "approach": "delta",
           "shear": "q", "shear-coefficient": "s_{n}", "residual": "local_{n}", "tilt-difference": "p"}


def scene_words(case, upright=False):
    """The contact in the words of tests/scene/scene_words.hpp."""
    words = ["axisymmetric"] if "geometry" in case["profile"] else []
    for key, value in (case["profile"] | case["load"] | case.get("shear", {}) | ({"alpha": "0"} if upright else {})).items():
        word = ";".join(value) if isinstance(value, list) else str(value)
        name = {"contact_modulus": "E"}.get(key, key)
        if key != "geometry":
            words.append({"kind": word, "symmetric": key}.get(key, f"{name}={word}").replace(" ", ""))
    return " ".join(words)


def row(case, number):
    """A row of the table. Differences are asked for with the digits that cancel, as relations: p by the upright contact, the
    first terms by p."""
    quantity = case["quantity"]
    words = [SYMBOLS.get(quantity, quantity).format(n=case.get("n"))]
    words += [f"at={case['x']},{case['z']}".replace(" ", "")] if "x" in case else []
    words += [case["edge"]] if "edge" in case else []
    words += [f"{key}={case[name]}".replace(" ", "") for key, name in (("u", "u"), ("tol", "tolerance")) if name in case]
    text, digits, bound = mpmath.nstr(number, DIGITS, min_fixed=0, max_fixed=0, strip_zeros=False), DIGITS, ""
    if quantity in ("residual", "tilt-difference"):
        digits += 10 - int(mpmath.log10(abs(number)))
        last = mpmath.nstr(abs(number) * mpf(10) ** (1 - DIGITS), 1)
        text, bound = (f"{{p}}*(1-({text}))", f" +-{{p}}*{last}") if quantity == "residual" else (
            f"{{{scene_words(case, upright=True)} : p}}+({text})", f" +-{last}")
    return f"{scene_words(case)} | {' '.join(words)} digits={digits} ~ {text}{bound}"


# The working digits: more than cancel, as the values at twice as many do not change.
WORKING = {"residual": 700, "extent": 160, "coefficient": 400, "sxx": 400, "szz": 400, "sxz": 400}


def main():
    parser = argparse.ArgumentParser(description="values of the hard cases by mpmath")
    parser.add_argument("--only", default="*", help="names of cases, as a shell pattern")
    parser.add_argument("--more", type=int, default=0, help="additional working digits")
    parser.add_argument("--check", action="store_true", help="compare the questions of the table only")
    arguments = parser.parse_args()
    with open(ROOT / "reference/hard-cases.toml", "rb") as file:
        cases = tomllib.load(file)["cases"]
    if arguments.check:
        table = (ROOT / "tests/oracles/hard-cases.txt").read_text().splitlines()[1:]
        asked = [line.partition(" digits=")[0] for line in table]
        return 0 if asked == [row(case, mpf(1)).partition(" digits=")[0] for case in cases.values()] else 1
    print(f"# mpmath {mpmath.__version__}, tests/oracles/hard_cases.py > hard-cases.txt; see tests/scene/values.txt")
    for name, case in cases.items():
        if fnmatch.fnmatch(name, arguments.only):
            round_body = case["profile"].get("geometry") == "axisymmetric"
            usual = 130 if round_body else 450 if "1e-300" in case.get("u", "") else 260
            mp.dps = WORKING.get(case["quantity"], usual) + arguments.more
            print(row(case, value(case)), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
