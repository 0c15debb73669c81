# SPDX-License-Identifier: BSD-3-Clause
"""Claims of the kind condition: inequalities, many of which become equalities at
a point."""
from .. import scenes
from ..ledger import Claim, family

# Conditions at a place of a Hertz contact, and where each is true (everywhere, somewhere, nowhere).
PLACED = (
    ("p(x) > 0", "everywhere"), ("right_local(1, x) >= p(x)", "everywhere"),
    ("right_local(1, x) > p(x)", "everywhere"), ("p(x) <= p(0)", "everywhere"),
    ("x < a", "everywhere"), ("x + u = a", "everywhere"), ("p(x) = p(-x)", "everywhere"),
    ("g1(x)*x >= 0", "everywhere"),
    ("p(x)^2 + (Es*C/2*x)^2 = p(0)^2", "everywhere"), ("u*(L-u) <= a^2", "everywhere"),
    ("(x-a/3)^2 >= 0", "everywhere"),
    ("p(x)/p(0) <= 1 - x^2/(2*a^2)", "everywhere"), ("max(x - a/3, 0) >= 0", "everywhere"),
    ("step(x) >= 0 and step(x) <= 1", "everywhere"),
    ("right_local(1, x)^2 - p(x)^2 = (Es*C/2)^2*u^2", "everywhere"), ("abs(x) <= a", "everywhere"),
    ("cos(x/a)^2 + sin(x/a)^2 = 1", "everywhere"),
    ("u*(L-u) < a^2", "but a point"), ("p(x) < p(0)", "but a point"), ("(x-a/3)^2 > 0", "but a point"),
    ("abs(x - a/7) > 1e-12*a", "but a point"),
    ("(x-a/3)^2 > 1e-9*a^2", "but a point"), ("abs(x + a/5) > 1e-5*a", "but a point"),
    ("x^2 > 1e-20*a^2", "but a point"),
    ("right_local(1, x) < p(x)", "nowhere"), ("p(x) > p(0)", "nowhere"), ("p(x) < 0", "nowhere"),
    ("x > a", "nowhere"), ("u*(L-u) > a^2", "nowhere"),
    ("p(x) > p(0)/2", "somewhere"), ("x > 0", "somewhere"), ("abs(x - a/3) < a/1000", "somewhere"),
    ("abs(x - a/7) < 1e-12*a", "a point"),
    ("(x-a/3)^2 < 1e-9*a^2", "a point"), ("(x-a/3)^2 <= 0", "a point"), ("p(x) >= p(0)", "a point"),
    ("u*(L-u) >= a^2", "a point"), ("x = 0", "a point"),
    ("g1(x) > 0", "somewhere"), ("right_local(1, x) < 2*p(x)", "somewhere"))
HOLDS = {true: {"everywhere": true == "everywhere", "somewhere": true != "nowhere", "nowhere": true == "nowhere"}
         for true in ("everywhere", "but a point", "nowhere", "somewhere", "a point")}
NEAR = {"1": (("right_local(1, x) > p(x)", True), ("right_local(1, x) < p(x)", False),
              ("right_local(2, x) > p(x)", True), ("right_local(3, x) > p(x)", True),
              ("right_local(3, x) < right_local(2, x)", True), ("p(x) = right_local(1, x)", False),
              ("p(x) < right.c0*sqrt(u)", True), ("p(x) > p(0)", False)),
        "0": (("right_local(1, x) < p(x)", True), ("right_local(1, x) > p(x)", False),
              ("right_local(2, x) < p(x)", True), ("right_local(2, x) > p(x)", False)),
        "3": (("right_local(1, x) > p(x)", True), ("right_local(1, x) < p(x)", False)),
        "2": (("right_local(1, x) > p(x)", True),)}
SCENE = (("symmetric", "a = b", True), ("symmetric", "b < a", False), ("symmetric", "a <= b", True),
         ("symmetric", "right.c0 > left.c0", False),
         ("symmetric", "right.c0 = left.c0", True), ("symmetric", "right.c1 < 0", True),
         ("symmetric", "right.c0 + 4*a*right.c1 >= 0", True),
         ("symmetric", "right.c0 + 4*a*right.c1 = 0", True), ("symmetric", "right.c0 + 4*a*right.c1 > 0", False),
         ("symmetric", "right.c0 + 4*a*right.c1 < 0", False),
         ("symmetric", "M = 0", True), ("symmetric", "M > 0", False), ("symmetric", "P = a*P1/2", True),
         ("symmetric", "P > a*P1/2", False),
         ("symmetric", "right.c1 = -right.c0/(4*a) and b = a", True), ("symmetric", "P3 = 0", True),
         ("symmetric", "P3 < 0", False),
         ("wedge", "b < a", True), ("wedge", "b > a", False), ("wedge", "b/a < 1", True),
         ("wedge", "b1*left.c0 = right.c0", True), ("wedge", "P2 = 0", True),
         ("wedge", "P1*a = P", True), ("wedge", "P1*a > P", False), ("wedge", "b > 0 and b <= a", True),
         ("wedge", "left.c0 > right.c0", True),
         ("wedge", "left.c0 < right.c0", False), ("wedge", "1 - b/a > 0", True), ("wedge", "b2 = 0 and b3 = 0", True))


def draw_relation(rng, digits):
    which = rng.choice(("placed", "placed", "near", "scene"))
    if which == "placed":
        says, true = rng.choice(PLACED)
        holds = rng.choice(("everywhere", "somewhere", "nowhere"))
        if holds == "nowhere" and (" and " in says or " = " in says):
            holds = "everywhere"
        return Claim("condition", {"says": says, "holds": holds}, scenes.power_law(rng, "1"), HOLDS[true][holds],
                     f"{true}, claimed {holds}")
    if which == "near":
        m = rng.choice(tuple(NEAR))
        says, right = rng.choice(NEAR[m])
        return Claim("condition", {"says": says, "holds": "near-edge"}, scenes.power_law(rng, m), right, "near the edge")
    shape, says, right = rng.choice(SCENE)
    if shape == "symmetric":
        at = scenes.power_law(rng, "1")
    else:
        at = scenes.wedge(rng, gam=rng.choice(scenes.GAM + ("1-1e-20", "1-1e-60", "1e-20")))
    return Claim("condition", {"says": says}, at, right, f"of a scene, {shape}")


# Conditions that hold for all sizes of a contact, for some, or for none.
SIZED = (
    ("hertz", "right.c1 < 0", "all"), ("hertz", "a = b", "all"), ("hertz", "right.c0 = left.c0", "all"),
    ("hertz", "right.c1*4*a = -right.c0", "all"),
    ("hertz", "right.c1*4*a + right.c0 >= 0", "all"), ("hertz", "right.c1*4*a + right.c0 <= 0", "all"),
    ("hertz", "right.c1*4*a + right.c0 > 0", "none"),
    ("hertz", "right.c1*4*a + right.c0 < 0", "none"), ("hertz", "L = 2*a", "all"), ("hertz", "b < a", "none"),
    ("hertz", "right.c0 > left.c0", "none"),
    ("hertz", "a > 1", "some"), ("hertz", "abs(a - 2) > 1e-12", "but a point"), ("hertz", "abs(a - 2) < 1e-12", "some"),
    ("hertz", "right.c1 > 0", "none"),
    ("hertz", "right.c0^2 >= 16*a^2*right.c1^2", "all"), ("hertz", "sqrt(a)*sqrt(a) = a", "all"),
    ("hertz", "(a - 3)^2 > 0", "but a point"), ("hertz", "(a-3)^2 >= 0", "all"),
    ("wedge", "b < a", "all"), ("wedge", "b > a", "none"), ("wedge", "3*b = a", "all"),
    ("wedge", "3*left.c0 = 9*right.c0", "all"), ("wedge", "3*left.c0 > 9*right.c0", "none"),
    ("wedge", "left.c0 > right.c0", "all"), ("wedge", "right.c0 > 0 and left.c0 > 0", "all"),
    ("wedge", "left.c0 <= 3*right.c0", "all"), ("wedge", "L = 4*b", "all"),
    ("flat", "right.c1 < 0", "all"), ("flat", "right.c0 > 0", "all"), ("flat", "right.c0 = left.c0", "all"),
    ("flat", "right.c2 < 0", "all"), ("flat", "a < 1", "none"),
    ("flat", "a > 2", "some"), ("flat", "right.c1 = left.c1", "all"), ("flat", "right.c1 > left.c1", "none"),
    ("flat", "a - b >= 0", "all"), ("flat", "a - b > 0", "none"))


def sized_family(rng, shape):
    Es = rng.choice(("7/3", "1", "2.1e11"))
    if shape == "hertz":
        return family("piecewise-symmetric", slopes=(f"x*{rng.choice(('3/7', '1/70', '2'))}",), a="1", Es=Es)
    if shape == "wedge":
        return family("tilted-wedge", gam="1/3", phi=rng.choice(("pi/16", "1/50")),
                      alpha="2*phi/pi*asin((1-gam)/(1+gam))", a="1", Es=Es)
    return family("flat-and-rounded", t="1", R=rng.choice(("3", "40")), a="3/2", Es=Es)


def draw_size_condition(rng, digits):
    shape, says, where = rng.choice(SIZED)
    sizes = ("1/2", "2", "3", "4") if shape != "flat" else ("11/10", "2", "3", "4")
    truth = {"all": "true", "some": "some", "but a point": "some", "none": "false"}[where]
    return Claim("condition", {"says": says, "sizes": list(sizes), "decimals": "exact"}, sized_family(rng, shape),
                 truth, f"{shape}, for {where}", group="condition at sizes")


KINDS = {"condition": draw_relation, "condition at sizes": draw_size_condition}
