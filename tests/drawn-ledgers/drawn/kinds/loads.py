# SPDX-License-Identifier: BSD-3-Clause
"""Claims about quantities under each of two loads, and of the kind relations."""
from .. import scenes
from ..ledger import Claim
from ..rewriting import equivalent, spoiled

# Full stick: s = (A Q/L^k + B sig0 L^(1-k))/sqrt(L); the zero of s as sig0 L/Q; the signs of A and
# B.
SHEAR = (("right.s0", "-8/Pi", 1, 1), ("left.s0", "8/Pi", 1, -1), ("right.s1", "8/(3*Pi)", 1, -1),
         ("left.s1", "-8/(3*Pi)", 1, 1),
         ("right.s2", "24/(5*Pi)", 1, -1), ("left.s2", "-24/(5*Pi)", 1, 1), ("2*right.s0", "-8/Pi", 1, 1),
         ("right.s0 + right.s0*right.s0/right.s0", "-8/Pi", 1, 1), ("right.s1*L", "8/(3*Pi)", 1, -1),
         ("2*right.s0 + left.s0", "-24/Pi", 1, 1), ("right.s0 - 2*left.s0", "8/(3*Pi)", -1, 1))
# The ratio z = sig0*L/Q at which a quantity vanishes, as the value of a formula.
RATIOS = (("{z}", "{v}"), ("({z})/2", "({v})/2"), ("1/({z})", "1/({v})"), ("({z})/L", "({v})/L"),
          ("({z})^2", "({v})^2"), ("exp({z})", "exp({v})"), ("{z} - ({v})", "0"), ("{z} + 1", "1 + ({v})"),
          ("({z})/({v}) - 1", "0"), ("{z} - ({v}) + 1e-30", "1e-30"))


def draw_zero(rng, digits):
    at = scenes.sheared(rng)
    of, zero, _, _ = rng.choice(SHEAR)
    if "right.s0*right.s0" in of:
        of = "right.s0"  # the formulas below must be linear in the loads
    z = f"-sig0*L/Q*given({of}, sig0 = 0)/given({of}, Q = 0)"
    ratio, says = (text.format(v=zero, z=z) for text in rng.choice(RATIOS))
    keys = {"of": ratio}
    if rng.random() < 0.6:
        text = says if says == "0" else equivalent(rng, says, rng.choice((0, 1, 2)), ("a", "Es", "L", "b"))
        return Claim("compare", {"says": text, **keys}, at, "true", "zero" if says == "0" else "tiny"
                     if says == "1e-30" else "ratio", group="zero of a quantity")
    if says in ("0", "1e-30"):
        return Claim("compare", {"says": f"{rng.randint(2, 9)}e-{rng.randint(1, min(25, digits - 7))}", **keys}, at,
                     "false", "zero")
    edit, error = (f"-({says})",
                   "twice") if rng.random() < 0.2 and "^2" not in says and "exp" not in says else spoiled(rng, says,
                                                                                                          digits)
    return Claim("compare", {"says": edit, **keys}, at, "false", "ratio", f"off by {error} of itself")


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


def draw_adding(rng, digits):
    Q = rng.choice(("3/10", "-7e5", "1e-4", "-2/9", "1e-40"))
    sig0 = rng.choice(("1/3", "-5e-3", "8e6", "-11", "1e30"))
    at = scenes.sheared(rng, Q=Q, sig0=sig0)
    linear = [row for row in SHEAR if "right.s0*right.s0" not in row[0]]
    table = [(of, A, B) for of, _, A, B in linear] + list(COMBINED)
    of, A, B = rng.choice(table)
    sign = A * B * (-1 if Q[0] == "-" else 1) * (-1 if sig0[0] == "-" else 1)
    tension = "sig0"
    if rng.random() < 0.4:
        zero, _, A0, B0 = rng.choice(linear)
        tension = f"-sig0*given({zero}, sig0 = 0)/given({zero}, Q = 0)"
        sign = -A * B * A0 * B0
    add = rng.choice((True, False))
    says = f"given({of}, sig0 = 0)*given(given({of}, Q = 0), sig0 = {tension}) {'>' if add else '<'} 0"
    label = "a part that is zero" if sign == 0 else "a part that is tiny" if "e-" in of else "ordinary"
    return Claim("condition", {"says": says}, at, sign == (1 if add else -1), label, group="loads that add")


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
        text = rng.choice((name, f"2*{name}", f"{name}^3", f"1e-30*{name}", f"1e40*{name}",
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
        parts.append(rng.choice((name, f"{name}^2", f"sqrt({name}^2)", f"1/{name}", f"3*{name}",
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
    (False, "2", ("a",), True), (False, "P1 - P1", ("b",), True))


def draw_relations(rng, digits):
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
    degree = {"degree": rng.randint(2, 4)} if rng.random() < 0.5 else {}
    return Claim("relations", {"says": says, "of": of, "from": others, **degree}, at, function == (says == "function"), label)


KINDS = {"zero": draw_zero, "adding": draw_adding, "relations": draw_relations}
