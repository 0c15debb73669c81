# SPDX-License-Identifier: BSD-3-Clause
"""Formulas with rounded constants. A printed decimal means the interval of half a unit in its last
digit: a formula is true if some choice of constants in their intervals is right at all samples,
else it is false.

The constants of a formula are factors (`powers`: the power of each), or coefficients of a sum
(`basis`: the function of each). At one sample the constants of a sum can compensate each other; at
more samples, with a linearly independent basis, only the exact constants fit."""
import dataclasses

from mpmath import mp, mpf
import mpmath

from .. import scenes
from ..ledger import Claim, family
from ..oracle import Plain, scene_of, value

DPS = 60
SIZES = ("1e-6", "0.02", "3/2", "1/7", "7e5", "1e6", "13", "2e-4")


@dataclasses.dataclass
class Formula:
    of: str
    says: str             # with {0}, {1}, {2} for the constants
    constants: tuple      # exact texts
    powers: tuple = ()    # of the constants in a product; empty: they are coefficients of a sum
    basis: tuple = ()
    label: str = "product"


def _one(of, says, constant, power=1, label="product"):
    return Formula(of, says, (constant,), (power,), (), label)


HERTZ = (
    _one("a", "{0}*sqrt(P/(Es*C))", "2/sqrt(Pi)"), _one("b", "{0}*sqrt(P/(Es*C))", "2/sqrt(Pi)"),
         _one("a", "{0}*P/p(0)", "2/Pi"),
    _one("a^2", "{0}*P/(Es*C)", "4/Pi"), _one("P", "{0}*Es*C*a^2", "Pi/4"), _one("P1", "{0}*Es*C*a", "Pi/2"),
         _one("p(0)", "{0}*sqrt(P*Es*C)", "1/sqrt(Pi)"),
    _one("p(x)", "{0}*P/a^2*sqrt(a^2-x^2)", "2/Pi"), _one("right.c0", "{0}*Es*C*sqrt(a)", "1/sqrt(2)"),
         _one("right.c1", "-{0}*Es*C/sqrt(a)", "sqrt(2)/8"),
    _one("P/3", "{0}*P", "1/3"), _one("x/3", "{0}*x", "1/3"), _one("a*sqrt(1/3)", "a*sqrt({0})", "1/3", 0.5),
         _one("a/7", "a/{0}", "7", -1),
    _one("a*exp(1/3)", "a*exp({0})", "1/3", 0, "exponential"), _one("Es*cos(1/3)", "Es*cos({0})", "1/3", 0, "cosine"),
    _one("P", "integral({0}*Es*C*sqrt(a^2-s^2), s, -a, a)", "1/2", 1, "integral"),
    _one("P/3", "integral({0}*p(s), s, -a, a)", "1/3", 1, "integral"),
         _one("a/3", "integral(1, s, 0, {0}*a)", "1/3", 1, "integral"),
    _one("10/7*a", "sum({0}*a, k, 1, 10)", "1/7", 1, "sum"), _one("a*Pi*1e-6", "{0}*a", "Pi*1e-6"),
         _one("a*Pi*1e6", "{0}*a", "Pi*1e6"),
    _one("a*Pi/8e5", "a*{0}", "Pi/8e5"), _one("a*exp(12)", "{0}*a", "exp(12)"),
         _one("p(a/2)", "{0}*p(0)", "sqrt(3)/2"),
    _one("integral(s^2*p(s), s, -a, a)", "{0}*P*a^2/3", "3/4"),
    Formula("2*a", "{0}*{1}*a", ("sqrt(2)", "sqrt(2)"), (1, 1)),
         Formula("P", "{0}/{1}*Es*C*a^2", ("Pi", "4"), (1, -1)),
    Formula("P", "{0}*{1}*p(0)*a", ("sqrt(Pi)", "sqrt(Pi)/2"), (1, 1)),
         Formula("a", "{0}*{1}/{2}*sqrt(P/(Es*C))", ("sqrt(3)", "2/sqrt(Pi)", "sqrt(3)"), (1, 1, -1)),
    Formula("p(x)", "{0}*Es*C*sqrt({1}*(a^2-x^2))", ("1/(2*sqrt(3))", "3"), (1, 0.5)),
    Formula("a/3 + x/7", "{0}*a + {1}*x", ("1/3", "1/7"), (), ("a", "x"), "terms"),
    Formula("right_local(2, x)", "{0}*Es*C*sqrt(a*u) - {1}*Es*C*u^(3/2)/sqrt(a)", ("1/sqrt(2)", "sqrt(2)/8"), (),
            ("Es*C*sqrt(a*u)", "-Es*C*u^(3/2)/sqrt(a)"), "terms"),
    Formula("p(x)^2", "(Es*C)^2*({0}*a^2 - {1}*x^2)", ("1/4", "1/4"), (), ("(Es*C)^2*a^2", "-(Es*C)^2*x^2"), "terms"),
    Formula("a/3 + x/7 + u^2/(11*a)", "{0}*a + {1}*x + {2}*u^2/a", ("1/3", "1/7", "1/11"), (), ("a", "x", "u^2/a"),
            "terms"),
    Formula("x*sqrt(2)", "{0}*a - {1}*u", ("sqrt(2)", "sqrt(2)"), (), ("a", "-u"), "terms"))
WEDGE = (_one("p(x)", "{0}*Es*C*log((a+sqrt(a^2-x^2))/abs(x))", "1/Pi"),
         _one("right.c0", "{0}*Es*C/sqrt(a)", "sqrt(2)/Pi"), _one("p(a/2)", "{0}*P/a", "log(2+sqrt(3))/Pi"))
FLAT = (Formula("P", "Es*a^2/R*({0} - asin(t/a)/2 - t/(2*a^2)*sqrt(a^2-t^2))", ("Pi/4",), (), ("Es*a^2/R",), "terms"),
        Formula("P1", "Es*a/R*({0} - {1}*asin(t/a))", ("Pi/2", "1"), (), ("Es*a/R", "-Es*a/R*asin(t/a)"), "terms"),
        _one("right.c0", "{0}*sqrt(a)*Es/R*acos(t/a)", "sqrt(2)/Pi"), _one("P1", "{0}*Es*a/R*acos(t/a)/7", "7"),
        Formula("P2", "Es/R*({0}*acos(t/a) + {1}*t/sqrt(a^2-t^2))/3", ("3", "3"), (),
                ("Es/R*acos(t/a)/3", "Es/R*t/sqrt(a^2-t^2)/3"), "terms"))
TILTED = (_one("right.c0", "{0}*P1/sqrt(a+b)", "2/Pi"), _one("left.c0", "{0}*right.c0/(3*gam)", "3"),
          _one("p(x)", "{0}*Es*phi*log(abs((1+sqrt(gam*(a-x)/(x+b)))/(1-sqrt(gam*(a-x)/(x+b)))))", "1/Pi"))
IDENTITIES = (_one("right.c0", "{0}*P1/sqrt(a+b)", "2/Pi"), _one("left.c0", "{0}*P1/(b1*sqrt(a+b))", "2/Pi"),
              _one("L", "{0}*(a+b)/3", "3"))
ZERO = "-sig0*L/Q*given({0}, sig0 = 0)/given({0}, Q = 0)"
# (kind, of, keys with {0}, the constant)
OTHERS = (
    ("expansion", "P1of(a-eps)/sqrt(1-eps/(2*a))", {"says": "P1 + eps*({0}*P1/a - P2)", "through": "1"}, "1/4"),
    ("expansion", "exp(eps/(3*a))", {"says": "1 + {0}*eps/a", "through": "1"}, "1/3"),
    ("expansion", "p(a-eps)", {"says": "{0}*P1/sqrt(a)*sqrt(eps)", "through": "1/2"}, "sqrt(2)/Pi"),
    ("expansion", "Pof(a-eps)", {"says": "P - P1*eps + {0}*P2*eps^2", "through": "2"}, "1/2"),
    ("expansion", "sqrt(1 + eps/a)", {"says": "1 + {0}*eps/a - eps^2/(8*a^2)", "through": "2"}, "1/2"),
    ("expansion", "log(7 + eps/a)", {"says": "log(7) + {0}*eps/a", "through": "1"}, "1/7"),
    ("expansion", "p(x)", {"says": "{0}*Es*C*sqrt(a*u)", "through": "1/2"}, "1/sqrt(2)"),
    ("expansion", "p(x)", {"says": "{0}*P/a^(3/2)*sqrt(u)", "through": "1/2"}, "2*sqrt(2)/Pi"),
    ("expansion", "p(x)", {"says": "Es*C*sqrt(a*u)/sqrt(2) - {0}*Es*C/sqrt(a)*u^(3/2)", "through": "3/2"}, "sqrt(2)/8"),
    ("compare", ZERO.format("right.s1"), {"says": "{0}"}, "8/(3*Pi)"),
    ("compare", ZERO.format("left.s0"), {"says": "{0}"}, "8/Pi"),
    ("compare", ZERO.format("right.s1") + "/L", {"says": "{0}/L"}, "8/(3*Pi)"),
    ("compare", ZERO.format("right.s0"), {"says": "-{0}"}, "8/Pi"))


def printed(number, digits):
    """A number rounded to `digits` significant digits: units of the last one, and its power of ten."""
    exponent = int(mpmath.floor(mpmath.log10(abs(number)))) - digits + 1
    return int(mpmath.nint(number / mpf(10) ** exponent)), exponent


def text_of(units, exponent, rng):
    """The decimal with a point."""
    if exponent >= 0 or rng.random() < 0.1:
        digits = str(units)
        return f"{digits[0]}.{digits[1:]}e{exponent + len(digits) - 1}"
    text = str(units).rjust(-exponent + 1, "0")
    return text[:exponent] + "." + text[exponent:]


def interval(units, exponent):
    """Half a unit on both sides; a tie lies inside, despite the roundoff of the ends."""
    half = mpf(1) / 2 + mpf(10) ** -40
    return (units - half) * mpf(10) ** exponent, (units + half) * mpf(10) ** exponent


def _drawn(rng, exact):
    """The printed constants, perhaps with one of them moved by three units: texts, intervals, True
    if one is moved."""
    moved = rng.randrange(len(exact)) if rng.random() < 0.45 else None
    texts, intervals = [], []
    for k, text in enumerate(exact):
        while True:
            units, exponent = printed(value(text, Plain()), rng.randint(2, 6))
            units += rng.choice((3, -3)) if k == moved else 0
            decimal = text_of(units, exponent, rng)
            if units > 3 and len(str(units)) >= 2:
                break
        texts.append(decimal)
        intervals.append(interval(units, exponent))
    return texts, intervals, moved is not None


def _fits(formula, at, intervals, samples):
    """True if constants in their intervals are right at all samples."""
    exact = [value(c, Plain()) for c in formula.constants]
    inside = all(lo <= k <= hi for k, (lo, hi) in zip(exact, intervals))
    if inside:
        return True
    if formula.powers and formula.label in ("exponential", "cosine"):
        return False
    if formula.powers:
        if formula.of == "x/3" and all(x == 0 for x, _ in samples):
            return True
        goal = low = high = mpf(1)
        for k, (lo, hi), power in zip(exact, intervals, formula.powers):
            ends = sorted((lo**power, hi**power))
            goal, low, high = goal * k**power, low * ends[0], high * ends[1]
        return low <= goal <= high
    if len(samples) > 1:
        return False
    (x, u), = samples
    names = scene_of(at).names()
    rest = mpf(0)
    low = high = mpf(0)
    for k, (lo, hi), text in zip(exact, intervals, formula.basis):
        size = value(text, names, x=x, u=u)
        ends = sorted((lo * size, hi * size))
        rest, low, high = rest + k * size, low + ends[0], high + ends[1]
    return low <= rest <= high


def _shuffled(rng, lists):
    names = list(lists)
    rng.shuffle(names)
    return {n: tuple(rng.sample(lists[n], len(lists[n]))) for n in names}


def _lists(rng, shape, count):
    pick = lambda of: rng.sample(of, min(count, len(of)))
    lists = {"a": pick(SIZES), "Es": pick(("64500", "7/3", "1e-6", "2.1e5", "1e6"))}
    if shape in ("hertz", "wedge"):
        lists |= {"m": ["1" if shape == "hertz" else "0"], "C": pick(("1/70", "3/7", "1e-6", "2e4"))}
    elif shape == "flat":
        lists |= {"t": pick(("a/3", "a*4/5", "a/20", "a*2/5")), "R": pick(("3", "1e-3", "4e6"))}
    else:
        lists |= {"gam": pick(("1/40", "1/3", "9/10")), "phi": pick(("pi/16", "1/50", "pi/3")),
                  "alpha": ["2*phi/pi*asin((1-gam)/(1+gam))"]}
    return _shuffled(rng, lists)


PROFILES = {"hertz": ("power-law", HERTZ), "wedge": ("power-law", WEDGE), "flat": ("flat-and-rounded", FLAT),
            "tilted": ("tilted-wedge", TILTED)}


def draw_rounded(rng, digits):
    with mp.workdps(DPS):
        nature = rng.random()
        if nature < 0.12:
            return _other(rng)
        if nature < 0.2:
            return _exponent(rng)
        if nature < 0.28:
            return _curved(rng)
        shape = rng.choice(("hertz", "hertz", "hertz", "wedge", "flat", "tilted"))
        profile, table = PROFILES[shape]
        if rng.random() < 0.1:
            table, (profile, _), shape = IDENTITIES, PROFILES["tilted"], "tilted"
        formula = rng.choice(table)
        count = rng.choice((1, 1, 2, 3, 4))
        u = ["1/5", "1/20", "3/7", "1/1000"]
        places = rng.sample(u, len(u))
        if formula.of == "x/3" and rng.random() < 0.5:
            places, count = ["1/2"], rng.choice((1, 2))
        one = count == 1
        points = 1 if one or places == ["1/2"] else 4
        if one:
            places = places[:1]
        at = family(profile, count=count, u=places, points=points, **_lists(rng, shape, count))
        samples = [(None, None)] * 2
        if one and places != ["1/2"]:
            scene = scene_of(at)
            u_value = value(places[0], Plain()) * (scene.a + scene.b)
            samples = [(scene.a - u_value, u_value)]
        elif places == ["1/2"]:
            samples = [(mpf(0), None)] * count  # the middle
        texts, intervals, moved = _drawn(rng, formula.constants)
        true = _fits(formula, at, intervals, samples)
    label = f"{formula.label}, {len(texts)} constants" + (", one sample" if one else "")
    return _claim("compare", {"says": formula.says.format(*texts), "of": formula.of}, at, true, label, moved, formula.constants)


def _claim(kind, keys, at, true, label, moved, constants, most_digits=50):
    return Claim(kind, keys, at, true, label + (", moved" if moved else ""), "exact: " + ", ".join(constants),
                 most_digits=most_digits, group="rounded")


def _exponent(rng):
    a = rng.choice((["1"], ["1", "3/2"], ["2"], ["0.02", "7e5"], ["1e6"]))
    at = family("power-law", count=len(a), **_shuffled(rng, {"m": ["1"], "C": ["3/7"], "a": a, "Es": ["64500"]}))
    of, says, exact = rng.choice((("a^(1/3)", "a^{0}", "1/3"), ("P*a^(2/3)", "P*a^{0}", "2/3"),
                                  ("a^(-1/7)", "a^(-{0})", "1/7"), ("P/a^(3/2)", "P*a^(-{0})", "3/2"),
                                  ("a^Pi", "a^{0}", "Pi")))
    texts, intervals, moved = _drawn(rng, (exact,))
    true = intervals[0][0] <= value(exact, Plain()) <= intervals[0][1] or a == ["1"]
    return _claim("compare", {"says": says.format(*texts), "of": of}, at, true, "exponent", moved, (exact,))


def _curved(rng):
    """A curved slope; two constants need samples at two places."""
    n, k = rng.randint(2, 40), rng.randint(1, 9)
    at = family("piecewise-symmetric", u=rng.sample(("1/20", "1/5", "3/7"), 3), points=3,
                slopes=(f"x/{n} + x^3/{k}",),
                a=rng.choice(("3/4", "1/7", "3/2")), Es=rng.choice(("7/3", "2.1e5")))
    of, says, exact = rng.choice((("p(x)", "Es*sqrt(a^2-x^2)*({0} + {1}*(a^2+2*x^2))", (f"1/{2 * n}", f"1/{4 * k}")),
                                  ("P1/3", "{0}*P1", ("1/3",)), ("p(x)/7", "p(x)*{0}", ("1/7",)),
                                  ("right.c0", "{0}*P1/sqrt(a)", ("sqrt(2)/Pi",)),
                                  ("P", "{0}*integral(p(s), s, 0, a)/3", ("6",)),
                                  ("g1(x)", "{0}*x + {1}*x^3", (f"1/{n}", f"1/{k}"))))
    texts, intervals, moved = _drawn(rng, exact)
    true = all(lo <= value(c, Plain()) <= hi for c, (lo, hi) in zip(exact, intervals))
    return _claim("compare", {"says": says.format(*texts), "of": of}, at, true, "curved", moved, exact, most_digits=30)


def _other(rng):
    kind, of, keys, exact = rng.choice(OTHERS)
    texts, intervals, moved = _drawn(rng, (exact,))
    keys = {"of": of, **{key: v.format(*texts) for key, v in keys.items()}}
    if kind == "compare":
        at = scenes.sheared(rng)
    else:
        at = scenes.power_law(rng, "1")
        if kind == "expansion":
            variable = "u" if of == "p(x)" else "eps"
            keys |= {"variable": variable, "vary": {variable: ["a*1e-14", "a*3e-15"]}}
    true = intervals[0][0] <= value(exact, Plain()) <= intervals[0][1]
    return _claim(kind, keys, at, true, f"in a claim of the kind {kind}", moved, (exact,))


KINDS = {"rounded": draw_rounded}
