# SPDX-License-Identifier: BSD-3-Clause
"""Conditions along a parameter: a quantity that grows or falls, or comes nearer to a number by half at
each step. The truth is that of the listed values, computed by mpmath."""
import re

from mpmath import mp, mpf

from .. import scenes
from ..ledger import Claim, Family
from ..oracle import DPS, Plain, scene_of, value


def _s_list(rng, scale="a*"):
    """A list of distances: ordinary, tiny, or tiny and close together; from small to large."""
    tiny = rng.choice((10, 20, 20, 28, 30, 40, 60))
    return [scale + text for text in rng.choice((
        ("1/1000", "1/100", "1/20", "1/10", "1/5", "2/5"), (f"1e-{tiny}", f"2e-{tiny}", f"3e-{tiny}"),
        (f"1e-{tiny}", f"2e-{tiny}", f"3e-{tiny}"),
        (f"1e-{tiny + 6}", f"1e-{tiny + 3}", f"1e-{tiny}", "1e-3"), (f"1e-{tiny}", f"1e-{tiny // 2}", "1/10"),
        (f"(1e-9+1e-{tiny + 9})", f"(1e-9+2e-{tiny + 9})", f"(1e-9+3e-{tiny + 9})")))]


def _of_distance(rng):
    """A quantity that depends on a distance s from the edge, the scene, the list of s."""
    which = rng.choice(("power", "power", "flat"))
    if which == "power":
        at = scenes.power_law(rng, rng.choice(("1", "1", "2", "3", "0")))
    else:
        at = scenes.flat(rng, t=rng.choice(("a/3", "a*2/5")))
    n = rng.randint(1, 6 if which == "power" else 4)
    if rng.random() < 0.5:  # the remainder of n terms: nearly all digits cancel
        of = rng.choice((f"abs(1 - right_local({n}, a-s)/p(a-s))", f"1 - right_local({n}, a-s)/p(a-s)",
                         f"abs(right_local({n}, a-s) - p(a-s))*a/P", f"abs(p(a-s)/right_local({n}, a-s) - 1)"))
        return of, at, _s_list(rng, rng.choice(("a*", "a*", "a/3*")))
    of = rng.choice((
        f"abs(1 - right_local({n}, a-s)/p(a-s))", f"right_local({n}, a-s)/p(a-s)",
                     f"1 - right_local({n}, a-s)/p(a-s)",
        "p(a-s)", "p(a-s)*a/P", "p(a-s)/sqrt(s)", f"right_local({n}, a-s) - p(a-s)", "g1(a-s)", "s/a", "1 + s/a",
                     "1 - s^2/a^2",
        "(a-s)^2 + 2*a*s - a^2", "p(a-s)^2/s", "sqrt(1 + s/a) - 1", "log(1 + s/a)", "1/(1 + s/a)", "cos(s/a)",
                     "p(-a+s) - p(a-s)",
        "exp(s/a) - 1 - s/a", "exp(-a/s)", "1 + exp(-a/s)", "sin(s/a)/(s/a)", "Pof(a-s)/P", "P1of(a-s)/P1",
                     "s/a + 1e30", "1e30*s/a"))
    return of, at, _s_list(rng)


def _values(of, at, along, texts):
    """The values of a formula at the values of a list, in the one scene of a family."""
    found = []
    with mp.workdps(DPS):
        if along == "s":
            scene = scene_of(at)
            for text in texts:
                found.append(value(of, scene.names(), s=value(text, scene.names())))
        else:
            for text in texts:
                found.append(value(of, scene_of(at, **{along: text}).names()))
    return found


def _sense(values):
    """increasing, decreasing, constant, neither, or None if 800 digits do not show it."""
    steps = [y - x for x, y in zip(values, values[1:])]
    largest = max(abs(v) for v in values)
    if any(0 < abs(d) <= largest * mpf(10) ** (100 - DPS) for d in steps):
        return None
    if all(d == 0 for d in steps):
        return "constant"
    if all(d > 0 for d in steps):
        return "increasing"
    return "decreasing" if all(d < 0 for d in steps) else "neither"


OF_PARAMETER = ("P", "P/Es", "p(0)", "P1", "right.c0", "right.c1", "right.c1/right.c0", "a*P1/P", "p(0)*a/P", "b/a",
                "1 + P/(P + 1e40)",
                "right.c0*sqrt(a)/P*a", "p(a/2)/p(0)", "p(a/2)/p(a/3)", "p(a/2)*a/P", "1/a", "a^2", "exp(-a)",
                "1 + exp(-a)", "a - a")


def _of_parameter(rng):
    along = rng.choice(("a", "a", "m", "C", "Es"))
    lists = {"a": (("1", "2", "3"), ("1e-9", "1e-6", "1"), ("1", "10", "100", "1000"), ("1", "1+1e-30", "1+2e-30"),
                   ("1/3", "1/2", "5")),
             "m": (("1", "2", "3"), ("0", "1", "2", "3")), "C": (("1", "2", "4"), ("1/7", "1/7+1e-25", "1/5")),
             "Es": (("1", "1e6", "2e11"), ("1", "1+1e-40", "1+1e-39"))}
    at = scenes.power_law(rng, rng.choice(("1", "2", "3")))
    texts = list(rng.choice(lists[along]))
    of = rng.choice(OF_PARAMETER)
    if along == "m" and "0" in texts:
        of = rng.choice(("P", "P1", "right.c0", "right.c1/right.c0", "a*P1/P", "a - a"))
    return of, at, along, texts


def _swept(at, along, texts):
    return Family(at.profile, tuple((n, tuple(texts) if n == along else v) for n, v in at.parameters), at.count, at.u,
                  at.points)


def draw_monotone(rng, digits):
    while True:
        if rng.random() < 0.65:
            of, at, texts = _of_distance(rng)
            along = "s"
        else:
            of, at, along, texts = _of_parameter(rng)
        if rng.random() < 0.3:
            texts = texts[::-1]
        sense = _sense(_values(of, at, along, texts))
        if sense is None:
            continue
        claimed = rng.choice(("increasing", "decreasing"))
        if sense in ("increasing", "decreasing") and rng.random() < 0.3:
            claimed = sense
        keys = {"says": f"next({of}) {'>' if claimed == 'increasing' else '<'} {of}", "along": along}
        if along == "s":
            keys["vary"] = {"s": texts}
        label = "tiny steps" if "e-" in texts[-1] or "e-" in texts[1] else "ordinary steps"
        label += ", constant" if sense == "constant" else ""
        return Claim("condition", keys, at if along == "s" else _swept(at, along, texts), claimed == sense, label,
                     f"it is {sense}", group="monotone")


# Limits: (text in z, the limit, the limit of z). z is replaced by the parameter.
AT_INFINITY = (("1/z", "0"), ("1 + 1/z", "1"), ("z", "infinity"), ("z^2 + 1", "infinity"), ("exp(-z)", "0"),
               ("1 + 1e60*exp(-3*z)", "1"),
               ("log(z)", "infinity"), ("sqrt(z)", "infinity"), ("atan(z)", "Pi/2"), ("(z+1)/(2*z+3)", "1/2"),
               ("sqrt(z^2+z) - z", "1/2"),
               ("z*(exp(1/z) - 1)", "1"), ("(1+1/z)^z", "exp(1)"), ("1e-30*z", "infinity"), ("1e30/z", "0"),
               ("1e30 + 1/z", "1e30"),
               ("1e-30 + 1/z^40", "1e-30"), ("z*exp(-z)", "0"), ("z^50*exp(-z)", "0"), ("z/(z+1e6)", "1"),
               ("tanh(z)", "1"),
               ("cos(1/z)", "1"), ("z - sqrt(z^2 - 1/2)", "0"), ("log(z+1) - log(z)", "0"), ("z^(1/100)", "infinity"),
               ("log(1+log(z+1))", "infinity"), ("3 - 2*exp(-z/7)", "3"), ("z + 1e60*exp(-3*z)", "infinity"),
               ("1e60*exp(-3*z)", "0"),
               ("exp(z)/z", "infinity"), ("z - log(z)", "infinity"), ("2*z/z", "2"), ("z - z", "0"),
               ("z + 1e9", "infinity"),
               ("sin(z)/z", "0"), ("1 + cos(z)/z^2", "1"), ("z + 3*sin(z)", "infinity"),
               ("z^2*(1 - cos(1/z))", "1/2"))
AT_ZERO = (("z", "0"), ("1 + z", "1"), ("1/z", "infinity"), ("sin(z)/z", "1"), ("(exp(z)-1)/z", "1"),
           ("(1-cos(z))/z^2", "1/2"),
           ("exp(-1/z)", "0"), ("1 + exp(-1/z)", "1"), ("sqrt(z)", "0"), ("z*log(z)", "0"), ("z^z", "1"),
           ("1e40*z", "0"), ("1e-40/z", "infinity"),
           ("(sqrt(1+z)-1)/z", "1/2"), ("(exp(z)-1-z)/z^2", "1/2"), ("(sin(z)-z)/z^3", "-1/6"), ("z^(1/50)", "0"),
           ("3 + z^(1/9)", "3"),
           ("(1+z)^(1/z)", "exp(1)"), ("1/(1+z)", "1"), ("1e-20 + z", "1e-20"), ("2*z/z", "2"),
           ("-log(z)", "infinity"))
INFINITE_LISTS = (("1", "10", "100"), ("1", "10", "100", "1000"), ("1", "1000", "1500"), ("1", "2", "4", "8", "16"),
                  ("10", "1e10", "1e100"),
                  ("1", "1e6", "2e6"), ("5", "50", "5000", "5001"), ("1", "2", "3"), ("1/2", "1e3", "1e6", "1e9"),
                  ("20", "30", "1000"))
ZERO_LISTS = (("1/10", "1e-6", "1e-40"), ("1/2", "1/4", "1/8"), ("1/10", "1/100", "1/1000", "1e-4"),
              ("1e-3", "1e-28", "3e-29"), ("1e-10", "1e-20", "1e-40"),
              ("1/7", "1e-40", "9e-41"), ("1/10", "1e-50", "1e-51", "1e-52"), ("1e-6", "1e-12", "1e-60"))
# Limits in a distance s from the edge, s -> 0, in a scene.
EDGE_LIMITS = (("right_local(1, a-s)/p(a-s)", "1"), ("abs(1 - right_local(2, a-s)/p(a-s))", "0"), ("p(a-s)", "0"),
               ("p(a-s)/sqrt(s)", "right.c0"),
               ("(p(a-s) - right.c0*sqrt(s))/s^(3/2)", "right.c1"),
               ("(1 - right_local(1, a-s)/p(a-s))/(s/a)", "right.c1/right.c0*a"),
               ("(Pof(a) - Pof(a-s))/s", "P1"), ("(P1of(a) - P1of(a-s))/s", "P2"), ("p(a-s)/s", "infinity"),
               ("s/p(a-s)", "0"),
               ("(right_local(3, a-s) - p(a-s))*a/P", "0"), ("(p(a-s) - right_local(2, a-s))/s^(5/2)", "right.c2"))


def draw_halving(rng, digits):
    while True:
        claim = _edge_limit(rng) if rng.random() < 0.35 else _plain_limit(rng)
        if claim is not None:
            return claim


def _plain_limit(rng):
    to_zero = rng.random() < 0.45
    text, limit = rng.choice(AT_ZERO if to_zero else AT_INFINITY)
    texts = list(rng.choice(ZERO_LISTS if to_zero else INFINITE_LISTS))
    by_name = rng.random() < 0.5
    along = "s" if by_name else "a"
    at = scenes.power_law(rng, "1") if by_name else _swept(scenes.power_law(rng, "1"), "a", texts)
    vary = {"vary": {"s": texts}} if by_name else {}
    of = _named(text, along)
    with mp.workdps(DPS):
        values = [value(text, Plain(), z=value(t, Plain())) for t in texts]
    if any(mp.im(v) != 0 for v in values):
        return None  # the formula has no real value at this place
    return _limit_claim(rng, of, limit, along, at, vary, values, lambda t: value(t, Plain()), "plain")


def _named(text, name):
    return re.sub(r"\bz\b", name, text)


def _edge_limit(rng):
    of, limit = rng.choice(EDGE_LIMITS)
    at = scenes.power_law(rng, rng.choice(("1", "2", "3"))) if rng.random() < 0.7 else scenes.flat(rng, t="a/3")
    texts = ["a*" + t for t in rng.choice(ZERO_LISTS)]
    names = scene_of(at).names()
    values = _values(of, at, "s", texts)
    return _limit_claim(rng, of, limit, "s", at, {"vary": {"s": texts}}, values, lambda t: value(t, names),
                        "at the edge")


def _limit_claim(rng, of, limit, along, at, vary, values, evaluate, label):
    """A claim about the true limit, or about a number near it."""
    with mp.workdps(DPS):
        if limit == "infinity":
            return None
        number = rng.choice((limit, limit, f"({limit})*(1+1e-6)", f"({limit}) + 1e-20", f"-({limit})", "1"))
        off = [abs(v - evaluate(number)) for v in values]
        if any(abs(y - x / 2) <= mpf(10) ** -200 * (x + y + mpf(10) ** -300) for x, y in zip(off, off[1:])):
            return None  # equality, which no enclosure decides
        truth = all(y < x / 2 for x, y in zip(off, off[1:]))
    says = f"abs(next({of}) - ({number})) < abs({of} - ({number}))/2"
    return Claim("condition", {"says": says, "along": along, **vary}, at, truth, label, group="nearer by half")


KINDS = {"monotone": draw_monotone, "halving": draw_halving}
