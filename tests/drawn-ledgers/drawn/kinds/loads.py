# SPDX-License-Identifier: GPL-3.0-or-later
"""Claims of the kinds vanishing, superposition, independence and dependence of a quantity."""
from .. import scenes
from ..ledger import Claim, union
from ..rewriting import equivalent, spoiled

# Full stick: s = (A Q/L^k + B sig0 L^(1-k))/sqrt(L); the zero of s as sig0 L/Q; the signs of A and
# B.
SHEAR = (("right.s0", "-8/Pi", 1, 1), ("left.s0", "8/Pi", 1, -1), ("right.s1", "8/(3*Pi)", 1, -1),
         ("left.s1", "-8/(3*Pi)", 1, 1),
         ("right.s2", "24/(5*Pi)", 1, -1), ("left.s2", "-24/(5*Pi)", 1, 1), ("2*right.s0", "-8/Pi", 1, 1),
         ("right.s0 + right.s0*right.s0/right.s0", "-8/Pi", 1, 1), ("right.s1*L", "8/(3*Pi)", 1, -1),
         ("2*right.s0 + left.s0", "-24/Pi", 1, 1), ("right.s0 - 2*left.s0", "8/(3*Pi)", -1, 1))
RATIOS = (("sig0*L/Q", "{v}"), ("sig0*(a+b)/(2*Q)", "({v})/2"), ("Q/(sig0*L)", "1/({v})"), ("sig0/Q", "({v})/L"),
          ("(sig0*L/Q)^2", "({v})^2"), ("exp(sig0*L/Q)", "exp({v})"), ("sig0*L/Q - ({v})", "0"),
          ("sig0*L/Q + 1", "1 + ({v})"),
          ("sig0*L/(Q*({v})) - 1", "0"), ("sig0*L/Q - ({v}) + 1e-30", "1e-30"))


def draw_vanishing(rng, digits):
    at = scenes.sheared(rng)
    of, zero, _, _ = rng.choice(SHEAR)
    if "right.s0*right.s0" in of:
        of = "right.s0"  # the formulas below must be linear in the loads
    ratio, says = (text.format(v=zero) for text in rng.choice(RATIOS))
    keys = {"of": of, "ratio": ratio, "loads": ["Q", "sig0"]}
    if rng.random() < 0.6:
        text = says if says == "0" else equivalent(rng, says, rng.choice((0, 1, 2)), ("a", "Es", "L", "b"))
        return Claim("vanishing", {"says": text, **keys}, at, "true", "zero" if says == "0" else "tiny"
                     if says == "1e-30" else "ratio")
    if says in ("0", "1e-30"):
        return Claim("vanishing", {"says": f"{rng.randint(2, 9)}e-{rng.randint(1, min(25, digits - 7))}", **keys}, at,
                     "false", "zero")
    edit, error = (f"-({says})",
                   "twice") if rng.random() < 0.2 and "^2" not in says and "exp" not in says else spoiled(rng, says,
                                                                                                          digits)
    return Claim("vanishing", {"says": edit, **keys}, at, "false", "ratio", f"off by {error} of itself")


# Sums of s0 at one edge and k times s0 at the other: (text, signs of the parts by Q and by sig0).
COMBINED = (("right.s0 + left.s0", 1, 0), ("right.s0 - left.s0", 0, 1), ("right.s0 + (1+1e-40)*left.s0", 1, -1),
            ("right.s0 + (1-1e-40)*left.s0", 1, 1), ("right.s0 - (1+1e-40)*left.s0", -1, 1),
            ("right.s0 + 2*left.s0", 1, -1),
            ("2*L*right.s1 - 2*left.s0 + right.s0", 0, 0), ("3*right.s0 + left.s0", 1, 1),
            ("right.s0 - right.s0", 0, 0),
            ("left.s0 + right.s0 - 1e-60*right.s0", 1, -1), ("sqrt(2)*right.s0 + sqrt(8)/2*left.s0", 1, 0),
            ("4*L*right.s1 + right.s0 - 8*L^2*right.s2", 0, 0), ("right.s1 + left.s1", 1, 0),
            ("right.s2 - left.s2", 0, -1),
            ("sqrt(3)*right.s0 + sqrt(27)/3*left.s0", 1, 0), ("log(8)/log(2)*right.s0 + 3*left.s0", 1, 0),
            ("right.s0/3 - left.s0*(1/3)", 0, 1),
            ("(1/7)*right.s1*7 + left.s1", 1, 0), ("sqrt(2)*(right.s0 - sqrt(2)*left.s0/sqrt(2))", 0, 1),
            ("Pi*right.s0/Pi - right.s0", 0, 0),
            ("exp(1/3)*right.s2 + exp(2/3)/exp(1/3)*left.s2", 1, 0),
            ("sin(1)^2*right.s0 + left.s0 - cos(1)^2*(-right.s0)", 1, 0),
            ("8*L^2*left.s2 - (4*L*left.s1 + left.s0)", 0, 0),
            ("2*sqrt(L)*sqrt(L)*right.s1 - 2*left.s0 + right.s0", 0, 0))


def draw_superposition(rng, digits):
    Q = rng.choice(("3/10", "-7e5", "1e-4", "-2/9", "1e-40"))
    sig0 = rng.choice(("1/3", "-5e-3", "8e6", "-11", "1e30"))
    at = scenes.sheared(rng, Q=Q, sig0=sig0)
    linear = [row for row in SHEAR if "right.s0*right.s0" not in row[0]]
    table = [(of, A, B) for of, _, A, B in linear] + list(COMBINED)
    of, A, B = rng.choice(table)
    sign = A * B * (-1 if Q[0] == "-" else 1) * (-1 if sig0[0] == "-" else 1)
    keys = {"of": of, "loads": ["Q", "sig0"]}
    if rng.random() < 0.4:
        zero, _, A0, B0 = rng.choice(linear)
        keys["when_zero"] = zero
        sign = -A * B * A0 * B0
    says = rng.choice(("add", "subtract"))
    truth = "true" if sign == (1 if says == "add" else -1) else "false"
    label = "a part that is zero" if sign == 0 else "a part that is tiny" if "e-" in of else "ordinary"
    return Claim("superposition", {"says": says, **keys}, at, truth, label)


HERTZ_RATIOS = ("p(x)*a/P", "p(x)/p(0)", "g1(x)/g1(a)", "right_local(2, x)/p(x)", "x/a", "u/L", "a*P1/P",
                "right.c1/right.c0*a",
                "p(x)*a/P + 1e30", "(p(x)*a/P + 1e12) - 1e12", "p(x) - Es*C/2*sqrt(a^2-x^2)", "x + u - a",
                "right.c0 + 4*a*right.c1",
                "p(x)^2/p(0)^2 + x^2/a^2", "g1(x)/(C*x)", "P/(Es*C*a^2)", "b/a", "M/(P*a)", "g1(x) + g1(-x)",
                "(p(x) - Es*C/2*sqrt(a^2-x^2))*a/P", "1 - right_local(1, x)/p(x)", "step(x-a) + step(u)",
                "p(x) - p(-x)", "sgn(p(x) - p(-x))",
                "step(x+u-a)", "sgn(a-b)", "sqrt(x+u-a)/sqrt(a)", "acos(b/a)", "sgn(right.c0 + 4*a*right.c1)")


def draw_independence(rng, digits):
    u = ["1e-30", "1e-6", "1/1000", "1/5", "3/7", "9/10"]
    places = rng.sample(u, rng.randint(1, 3))
    many = {"C": ("3/7", "1e-6", "2e4"), "a": ("3/2", "0.02", "7e5"), "Es": ("7/3", "2.1e11", "64500")}
    from ..ledger import family
    which = rng.choice(("hertz", "hertz", "shear", "wedge"))
    if which == "hertz":
        at, of = family("power-law", count=3, m="1", **many), rng.choice(HERTZ_RATIOS)
    elif which == "shear":
        q = {"Q": ("3/10", "-7e5"), "sig0": "0"} if rng.random() < 0.5 else {"Q": "0", "sig0": ("1/3", "-5e-3")}
        members = [family("power-law", count=2, m=("1", "0"), **many, **q),
                   family("tilted-wedge", count=2, gam=("1/40", "1/2"), phi=("pi/16", "1/50"),
                          alpha="2*phi/pi*asin((1-gam)/(1+gam))",
                          a=("3/2", "0.02"), Es="7/3", **q)]
        at = union(*members)
        of = rng.choice(("q(x)*L/Q", "q(x)*sqrt(u*(L-u))/Q", "right.s0*sqrt(L)/Q", "right.s0 - left.s0",
                         "2*L*right.s1 - right.s0") if q["sig0"] == "0"
                        else ("q(x)/sig0", "q(x)*sqrt(u*(L-u))/(sig0*L)", "right.s0 + left.s0",
                              "right.s0/(sig0*sqrt(L))"))
    else:
        at = family("tilted-wedge", count=3, gam="1/3", phi=("pi/16", "1/50", "pi/3"),
                    alpha="2*phi/pi*asin((1-gam)/(1+gam))",
                    a=("3/2", "0.02", "7e5"), Es=("7/3", "2.1e11"))
        of = rng.choice(("p(x)/(Es*phi)", "p(x)*a/P", "b/a", "a*P1/P", "left.c0/right.c0", "bof(x*x/a)/b",
                         "binv(b/3)/a", "P2*a/P1", "b1", "b2*a"))
    keys = {"at": places}
    if rng.random() < 0.55:
        return Claim("independence", {"of": of, **keys}, at, "true", f"{which}")
    other = {"hertz": ("C", "Es", "a/(a+1)"), "shear": ("a/(a+1)", "L"), "wedge": ("phi", "a/(a+1)", "1/Es")}[which]
    name = rng.choice(other)
    k = rng.randint(0, max(0, digits - 12))
    # The relative differences of a/(a+1) and the others between scenes are at least a hundredth.
    size = "1" if "1e30" in of else f"1e-{k}" if k else "1"
    wrong = "p(x)*a/P" if of.startswith(("sgn", "step(x+u", "sqrt", "acos")) else of
    wrong = wrong if "1e30" not in of and "1e12" not in of else "p(x)*a/P"
    zero = wrong in ("p(x) - Es*C/2*sqrt(a^2-x^2)", "x + u - a", "right.c0 + 4*a*right.c1", "M/(P*a)",
                     "g1(x) + g1(-x)", "p(x) - p(-x)", "b2*a",
                     "P2*a/P1", "(p(x) - Es*C/2*sqrt(a^2-x^2))*a/P", "right.s0 - left.s0", "right.s0 + left.s0",
                     "2*L*right.s1 - right.s0")
    if zero:
        return Claim("independence", {"of": f"{wrong} + {size}*({name})", **keys}, at, "false",
                     f"{which}, zero and a small part")
    return Claim("independence", {"of": f"({wrong})*(1 + {size}*({name})/(1+{name}))", **keys}, at, "false", which)


def _variables(rng, symmetric):
    return rng.sample(["a", "P1", "P2", "P3"] if symmetric else ["a", "b", "P1", "P2", "b1", "b2", "P3"],
                      rng.randint(1, 3))


def _mixed(rng, names):
    """Functions of names that can be solved for the names."""
    texts = list(names)
    rng.shuffle(texts)
    found = []
    for i, name in enumerate(texts):
        others = texts[:i]
        text = rng.choice((name, f"2*{name}", f"{name}^3", f"exp({name}/10)", f"1e-30*{name}", f"1e40*{name}",
                           f"1/{name}", f"{name} + 1e30"))
        if others:
            other = rng.choice(others)
            text = rng.choice((text, f"{text} + {other}", f"{text}*1e-20 + {other}", f"{other} + 1e-13*{name}",
                               f"{text} + 1e-40*{other}",
                               f"{name}*{other}", f"{name} - {other}"))
        found.append(text)
    return found


def _made_of(rng, names):
    parts = []
    for name in names:
        parts.append(rng.choice((name, f"{name}^2", f"sqrt({name}^2)", f"exp({name}/10)", f"1/{name}", f"3*{name}",
                                 f"1e-13*{name}", f"1e-30*{name}")))
    return rng.choice((" + ", "*", " - ")).join(parts)


# (True for symmetric contacts, quantity, others, True if the quantity is a function of the others).
DEPENDENCES = (
    (True, "right.c0", ("P1", "a"), True), (True, "right.c1", ("right.c0", "P2", "a"), True),
    (True, "P1", ("right.c0", "a"), True),
    (True, "right.c1", ("right.c0", "a"), False), (True, "right.c2", ("right.c0", "right.c1", "a"), False),
    (True, "left.c1", ("right.c1",), True),
    (True, "right.c0 - sqrt(2/a)/Pi*P1", ("a",), True), (True, "right.c0 - sqrt(2/a)/Pi*P1", ("P2",), True),
    (True, "a - b", ("P1",), True),
    (True, "right.c0 - left.c0", ("a",), True), (True, "right.c0 - sqrt(2/a)/Pi*P1 + 1e-30*P2", ("a",), False),
    (True, "b1", ("P1",), True),
    (True, "a + 1e-13*P2", ("a",), False), (True, "a + 1e-60*P2", ("a",), False),
    (True, "a + 1e-13*P2", ("a", "P2"), True),
    (False, "left.c0", ("right.c0", "b1"), True), (False, "left.c0", ("right.c0",), False),
    (False, "left.c0*b1 - right.c0", ("a",), True),
    (False, "left.c1", ("right.c0", "right.c1", "left.c0", "b1", "b2", "L"), True),
    (False, "left.c1", ("right.c0", "right.c1", "left.c0", "b1", "a", "b"), False),
    (False, "L", ("a", "b"), True), (False, "L", ("a",), False), (False, "L - b", ("a",), True),
    (False, "P1", ("right.c0", "L"), True),
    (False, "right.c1", ("P1", "P2", "b1", "L"), True), (False, "right.c1", ("P1", "P2", "L"), False),
    (False, "right.c0", ("P1", "a"), False),
    (False, "2", ("a",), True), (False, "P1 - P1", ("b",), True), (False, "cos(P1)^2 + sin(P1)^2", ("a",), True))


def draw_dependence(rng, digits):
    if rng.random() < 0.5:
        symmetric, of, others, function = rng.choice(DEPENDENCES)
        label = "multipliers"
        others = [rng.choice((o, f"2*{o}", f"1e-20*{o}", f"1e20*{o}")) for o in others]
    else:
        symmetric = rng.random() < 0.5
        names = _variables(rng, symmetric)
        others = _mixed(rng, names)
        of, function, label = _made_of(rng, names), True, "made"
        if rng.random() < 0.5:
            outside = [n for n in ("a", "P1", "P2", "P3") + (() if symmetric else ("b1", "b2")) if n not in names]
            if outside:
                coefficient = rng.choice(("", "1e-5*", "1e-13*", "1e-20*", "1e-40*"))
                of, function = f"{of} + {coefficient}{rng.choice(outside)}", False
                label = "made" + (", a tiny part" if coefficient else "")
    at = rng.choice((scenes.power_law, scenes.flat) if symmetric else (scenes.wedge, scenes.tilted_flat))(rng)
    says = rng.choice(("function", "independent"))
    return Claim("dependence", {"says": says, "of": of, "from": others}, at, "true"
                 if function == (says == "function") else "false", label)


KINDS = {"vanishing": draw_vanishing, "superposition": draw_superposition, "independence": draw_independence,
         "dependence": draw_dependence}
