# SPDX-License-Identifier: GPL-3.0-or-later
"""Claims of the kind series: the remainders of the expansion at an edge."""
from .. import scenes
from ..ledger import Claim
from ..rewriting import equivalent

COEFFICIENTS = {
    "1": ("Es*C/2*sqrt(2*a)", "-Es*C/2*sqrt(2*a)/(4*a)", "-Es*C/2*sqrt(2*a)/(32*a^2)"),
    "0": ("Es*C/Pi*sqrt(2/a)", "5*Es*C/(12*a*Pi)*sqrt(2/a)"),
    "5/8": ("sqrt(2/a)/Pi*P1", "0"),
    "any": ("2*P1/(Pi*sqrt(a+b))", "((3+2*b1)*P1 - 4*(a+b)*P2)/(3*Pi*(a+b)^(3/2))")}
ORDERS = ["1/2", "3/2", "5/2", "7/2"]


def _nearly_vanishing(rng):
    """m = 5/8 has no second term; for an m near it, the second term shows only very close to the
    edge."""
    if rng.random() < 0.4:
        orders, truth = rng.choice(((["1/2", "5/2"], "true"), (["1/2", "2"], "false"), (["1/2", "7/2"], "false")))
        return Claim("series", {"orders": orders}, scenes.power_law(rng, "5/8"), truth, "a coefficient that vanishes")
    orders, truth = rng.choice(((["1/2", "3/2"], "true"), (["1/2", "3/2", "5/2"], "true"), (["1/2", "5/2"], "false")))
    at = scenes.power_law(rng, rng.choice(("5/8+1e-20", "5/8-1e-30", "5/8+1e-60", "5/8-1e-6")))
    return Claim("series", {"orders": orders}, at, truth, "a coefficient that nearly vanishes")


def draw_series(rng, digits):
    if rng.random() < 0.15:
        return _nearly_vanishing(rng)
    m = rng.choice(("1", "0", "5/8", "any", "any"))
    if m == "any":
        at = rng.choice((scenes.wedge, scenes.flat, scenes.power_law, scenes.tilted_flat))(rng)
    else:
        at = scenes.power_law(rng, m)
    terms = list(COEFFICIENTS[m])[:rng.randint(1, 3)]
    orders = ORDERS[:len(terms) + rng.choice((0, 1))]
    keys = {"edge": rng.choice(("right", "left")) if m != "any" else "right"}
    if rng.random() < 0.2:  # the pressure without coefficients
        if rng.random() < 0.5:
            return Claim("series", {"orders": ORDERS[:rng.randint(1, 3)], **keys}, at, "true", "orders alone")
        order = rng.choice(("3/2", "1", "1/4", "1/2+1e-6"))
        return Claim("series", {"orders": [order], **keys}, at, "false", "orders alone")
    if rng.random() < 0.5:
        texts = [t if t == "0" else equivalent(rng, t, rng.choice((0, 1)), ("a", "Es", "P")) for t in terms]
        return Claim("series", {"terms": texts, "orders": orders, **keys}, at, "true", f"m = {m}")
    k = rng.randrange(len(terms))
    error = rng.choice(("1/2", "1e-3", "1e-6", f"1e-{max(1, min(digits, 40) - 8)}"))
    terms[k] = f"right.c0/a^{k}*{error}" if terms[k] == "0" else f"({terms[k]})*(1 + {error})"
    if k > 0 and m == "any":
        terms[k] = f"{COEFFICIENTS[m][k]} + right.c0/a^{k}*{error}"
    return Claim("series", {"terms": terms, "orders": orders, **keys}, at, "false", f"m = {m}",
                 f"coefficient {k} is off by {error}")


KINDS = {"series": draw_series}
