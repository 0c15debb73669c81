# SPDX-License-Identifier: BSD-3-Clause
"""Claims of the kind compare: a formula or a number for a quantity."""
import decimal

from mpmath import mp, mpf
import mpmath

from .. import scenes
from ..ledger import Claim, family
from ..oracle import DPS, scene_of, value
from ..rewriting import equivalent, spoiled


def draw_value(rng, digits):
    nature = rng.choice(("formula", "formula", "formula", "knot", "zero", "zero", "curved", "shear", "given", "no value"))
    if nature == "knot":
        return _on_knot(rng, digits)
    if nature == "curved":
        return _curved(rng, digits)
    if nature == "no value":
        return _no_value(rng)
    if nature == "given":
        return _given(rng, digits)
    if nature == "shear":
        of_family, table = scenes.sheared(rng), scenes.SHEARED
    else:
        of_family, table, zeros = scenes.any_scene(rng)
    if nature == "zero":
        return _zero(rng, digits, of_family, rng.choice(zeros))
    of, says = rng.choice(table)
    return _formula(rng, digits, of_family, of, says, nature)


def _formula(rng, digits, of_family, of, says, label, kind="compare"):
    times = rng.choice((0, 1, 1, 2))
    edge = {"edge": rng.choice(("left", "right"))}
    if rng.random() < 0.6:
        return Claim(kind, {"says": equivalent(rng, says, times), "of": of, **edge}, of_family, "true", label)
    if "g1" in of and of_family.profile == "flat-and-rounded":
        of, says = "g1(a)", "(a-t)/R"  # the slope of the flat part is zero: a factor has no effect
    edit, error = spoiled(rng, says, digits)
    return Claim(kind, {"says": equivalent(rng, edit, times), "of": of, **edge}, of_family, "false", label,
                 f"off by {error} of itself")


def _on_knot(rng, digits):
    t, u = rng.choice(scenes.KNOTS)
    at = scenes.flat(rng, u=(u,), t=t)
    side = "t" if "2/3" not in u and "7/10" not in u else "(-t)"
    x = f"(x - {side})"
    true = (("0", f"step({x}) - 1/2", "1"), ("0", "g1(x)", "a/R"), ("0", x, "a"), ("1/2", f"step({x})", "1"),
            ("0", f"sgn({x})", "1"), ("g1(x)", "sgn(x)*max(abs(x) - t, 0)/R", "a/R"), ("1", f"1 + sgn({x})", "1"),
            ("1", f"2*step({x})", "1"), ("x", side, "a"), ("g1(x)", f"{x}/R*step({x})", "a/R"),
            ("0", f"abs({x})/R", "a/R"), ("p(x)", "Es/(Pi*R)*(sqrt(a^2-t^2)*acos(t/a) - t*log(a/t))", "p(x)"),
            ("0", f"sqrt({x}^2)", "a"), ("0", f"min({x}, 0)", "a"), ("2*t", f"max({x}, 0) + 2*t", "a"))
    of, says, scale = rng.choice(true)
    if rng.random() < 0.7:
        return Claim("compare", {"says": says, "of": of, "scale": scale}, at, "true", "on a knot")
    wrong = rng.choice((f"{says} + ({scale})/7", f"{says} - ({scale})*1e-{digits - 7}",
                        f"({says}) + ({scale})*(step({x}) + 1/2)"))
    return Claim("compare", {"says": wrong, "of": of, "scale": scale}, at, "false", "on a knot")


def _zero(rng, digits, of_family, zero):
    of, says, scale = zero
    if rng.random() < 0.5:
        says, of = of, says
    form = {"scale": scale} if rng.random() < 0.7 or "integral" in scale else {}
    if rng.random() < 0.6:
        return Claim("compare", {"says": says, "of": of, **form}, of_family, "true", "zero"
                     + ("" if form else " without a scale"))
    return Claim("compare",
                 {"says": f"{says} {rng.choice('+-')} {rng.randint(1, 9)}e-{rng.randint(1, digits - 7)}*({scale})",
                           "of": of, "scale": scale}, of_family, "false", "zero")


def _curved(rng, digits):
    at, n, k = scenes.curved(rng)
    true = (("p(x)", f"Es/2*sqrt(a^2-x^2)*(1/{n} + (a^2+2*x^2)/({2 * k}))"),
            ("P", f"Pi*Es*a^2*(1/({4 * n}) + 3*a^2/({16 * k}))"),
            ("P1", f"Pi*Es*a*(1/({2 * n}) + 3*a^2/({4 * k}))"), ("g1(x)", f"x/{n} + x^3/{k}"), ("p(-x)", "p(x)"),
            ("right.c0", f"sqrt(2*a)*Es*(1/({2 * n}) + 3*a^2/({4 * k}))"),
            ("p(0)", f"Es/2*a*(1/{n} + a^2/({2 * k}))"),
            ("integral(p(s), s, -a, a)", "P"))
    if rng.random() < 0.5:
        of, says = rng.choice(true)
        claim = _formula(rng, min(digits, 30), at, of, says, "curved")
    else:
        zero = rng.choice((("0", "integral(g1(s)/sqrt(a^2-s^2), s, -a, a)",
                            "integral(abs(g1(s))/sqrt(a^2-s^2), s, -a, a)"),
                           ("0", "integral(g1(s)/sqrt((a-s)*(s+b)), s, -b, a)", "g1(a)"), ("0", "M", "P*a"),
                           ("0", "g1(0)", "g1(a)"), ("0", "a - b", "a"), ("0", "integral(s*p(s), s, -a, a)", "P*a")))
        claim = _zero(rng, min(digits, 30), at, zero)
        claim.label = "curved " + claim.label
    claim.most_digits = 40
    return claim


def _no_value(rng):
    says = rng.choice(("1/(a-a)*P", "log(a-a)", "P/(L-2*a)", "sqrt(a-2*a)", "0/(a-b)", "(a-b)/(b-a)", "1/log(1)",
                       "log(-P)",
                       "acos(2)", "p(2*a)", "1/sin(0)", "P*log(b-a)", "P/(right.c0-left.c0)",
                       "P/g1(0)", "P*log(M)", "P/(p(x)-p(-x))", "P/step(b-a-1)"))
    return Claim("compare", {"says": says, "of": "P"}, scenes.power_law(rng, "1"), "no value", "no value in print")


# Formulas under a printed law of P: the law, the exponent, formulas, and zeros with a scale.
GIVEN = (("Pi/4*Es*C*a^2", "1", (("P1", "Pi/2*Es*C*a"), ("right.c0", "Es*C/2*sqrt(2*a)"),
                                 ("right.c1", "-Es*C/8*sqrt(2/a)"), ("0", "P3", "P1/a^2"), ("0", "P - a*P1/2", "P"),
                                 ("right.c2", "-Es*C/2*sqrt(2*a)/(32*a^2)"))),
         ("Es*C*a", "0", (("P1", "Es*C"), ("right.c0", "Es*C/Pi*sqrt(2/a)"), ("0", "P2", "P1/a"),
                          ("right.c1", "5*Es*C/(12*a*Pi)*sqrt(2/a)"))))


def _given(rng, digits):
    law, m, table = rng.choice(GIVEN)
    at, row = scenes.power_law(rng, m), rng.choice(table)
    claim = _zero(rng, digits, at, row) if row[0] == "0" else _formula(rng, digits, at, *row, "given")
    claim.keys["given"] = {"P": law}
    return claim


# ---- figures: a quoted decimal for a quantity of one scene

def _plain(number, places, up=True):
    """A number in units of the last of `places` decimals, with a half rounded up; None if it is
    undecided."""
    steps = number * mpf(10) ** places
    whole = mpmath.floor(steps + mpf(1) / 2)
    distance = abs(steps - mpmath.floor(steps) - mpf(1) / 2)
    if 0 < distance < mpf(10) ** (places - DPS + 60):
        return None
    return int(whole)


def _decimal(units, places):
    text = str(units).rjust(places + 1, "0")
    return text[:len(text) - places] + ("." + text[len(text) - places:] if places else "")


def _quote(rng, number, places, label, of, at):
    units = _plain(number, places)
    off = rng.choice((0, 0, 0, 1, -1, rng.randint(2, 60), -rng.randint(2, 60)))
    if units is None or units + off < 0 or number < 0:
        return None
    percent = places >= 2 and rng.random() < 0.3
    text = _decimal(units + off, places - 2) + " %" if percent else _decimal(units + off, places)
    truth = "true" if off == 0 else "imprecise" if abs(off) == 1 else "false"
    return Claim("compare", {"quoted": text, "of": of}, at, truth, label, f"the value is {mpmath.nstr(number, 25)}")


FIGURES = (("rational", ("1/3", "2/3", "1/7", "22/7", "1/8", "1/1000", "5/8", "1/64", "3/2", "0", "a - a", "1/2 + 0",
                         "10/9")),
           ("irrational", ("Pi", "sqrt(2)", "exp(1)", "exp(-20)", "log(2)", "1 - cos(1/10^8)", "sqrt(2)*sqrt(2)",
                           "sqrt(3)^2/8",
                           "exp(-100)*Pi", "tan(Pi/4)/8", "1/8 + 1e-40", "1/8 - 1e-40", "1/2 - 1e-90",
                           "1/2 + exp(-300)",
                           "1/8 + exp(-180)", "1/8 - exp(-180)", "sin(Pi/6)", "sin(Pi/6)/4", "cos(Pi/3)^3",
                           "exp(log(1/8))",
                           "(sqrt(2)-1)*(sqrt(2)+1)/8", "Pi - 355/113 + 1", "exp(Pi*sqrt(163)) - 640320^3 - 743")),
           ("contact", ("P/(Es*C*a^(m+1))", "p(0)*a/P", "p(a/2)*a/P", "a*P1/P", "a*P2/P1", "b/a",
                        "abs(right.c1/right.c0)*a",
                        "abs(right.c2/right.c0)*a^2", "right.c0*sqrt(a)/(P/a)", "left.c0/right.c0", "p(a/2)/p(a/3)")))


def draw_figure(rng, digits):
    for _ in range(50):
        nature = rng.choice(("rational", "irrational", "contact", "cancelling", "cancelling"))
        if nature == "cancelling":
            claim = _cancelling(rng)
        else:
            m = rng.choice(("1", "2", "3"))
            at = scenes.power_law(rng, m)
            of = rng.choice(dict(FIGURES)[nature])
            with mp.workdps(DPS):
                number = value(of, scene_of(at).names())
                size = int(mpmath.floor(mpmath.log10(number))) if number else 0
                if of.startswith("1/8"):
                    places = rng.choice((2, 2, 2, 3))
                elif of.startswith("1/2"):
                    places = rng.choice((0, 0, 1))
                else:
                    places = max(0, rng.choice((1, 2, 3, 5, 10, digits // 2, digits - 2, 60)) - size)
                claim = _quote(rng, number, places, nature, of, at)
        if claim is not None:
            return claim
    raise AssertionError("no figure")


def _cancelling(rng):
    """The error of n terms at a small distance: most digits cancel."""
    m, n = rng.choice(("1", "2", "3", "0")), rng.randint(1, 6)
    u = rng.choice(("1e-12", "1e-6", "1e-9", "1e-3", "3e-12", "1e-20"))
    at = scenes.power_law(rng, m, u=(u,))
    of = f"abs(1 - right_local({n}, x)/p(x))"
    scene = scene_of(at)
    with mp.workdps(DPS):
        x = scene.a * (1 - 2 * mpf(u))
        number = value(of, scene.names(), x=x)
        if number == 0:
            return None
        size = int(mpmath.floor(mpmath.log10(number)))
        return _quote(rng, number, max(0, rng.choice((1, 2, 3, 8)) - size), "cancelling", of, at)


KINDS = {"value": draw_value, "figure": draw_figure}
