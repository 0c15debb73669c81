# SPDX-License-Identifier: GPL-3.0-or-later
"""Claims of the kind expansion about p(x) in half powers of u, the distance from an edge."""
from .. import scenes
from ..ledger import Claim
from ..rewriting import equivalent

COEFFICIENTS = {
    "1": ("Es*C/2*sqrt(2*a)", "-Es*C/2*sqrt(2*a)/(4*a)", "-Es*C/2*sqrt(2*a)/(32*a^2)"),
    "0": ("Es*C/Pi*sqrt(2/a)", "5*Es*C/(12*a*Pi)*sqrt(2/a)"),
    "5/8": ("sqrt(2/a)/Pi*P1", "0"),
    "any": ("2*P1/(Pi*sqrt(a+b))", "((3+2*b1)*P1 - 4*(a+b)*P2)/(3*Pi*(a+b)^(3/2))")}


def _claim(terms, edge, at, truth, label, why=""):
    says = " + ".join(f"({term})*u^({2*k + 1}/2)" for k, term in enumerate(terms))
    keys = {"says": says, "of": "p(x)", "variable": "u", "through": f"{2*len(terms) - 1}/2", "edge": edge}
    return Claim("expansion", keys, at, truth, label, why)


def draw_series(rng, digits):
    if rng.random() < 0.15:  # near m = 5/8, where the second term vanishes
        m = rng.choice(("5/8+1e-3", "5/8-1e-6"))  # at 15 digits a smaller term agrees to all digits needed
        return _claim(COEFFICIENTS["5/8"], "right", scenes.power_law(rng, m), "false",
                      "a coefficient that nearly vanishes")
    m = rng.choice(("1", "0", "5/8", "any", "any"))
    if m == "any":
        at = rng.choice((scenes.wedge, scenes.flat, scenes.power_law, scenes.tilted_flat))(rng)
    else:
        at = scenes.power_law(rng, m)
    terms = list(COEFFICIENTS[m])[:rng.randint(1, 3)]
    edge = rng.choice(("right", "left")) if m != "any" else "right"
    if rng.random() < 0.5:
        texts = [t if t == "0" else equivalent(rng, t, rng.choice((0, 1)), ("a", "Es", "P")) for t in terms]
        return _claim(texts, edge, at, "true", f"m = {m}")
    k = rng.randrange(len(terms))
    error = rng.choice(("1/2", "1e-3", "1e-6", f"1e-{max(1, min(digits, 40) - 8)}"))
    terms[k] = f"right.c0/a^{k}*{error}" if terms[k] == "0" else f"({terms[k]})*(1 + {error})"
    if k > 0 and m == "any":
        terms[k] = f"{COEFFICIENTS[m][k]} + right.c0/a^{k}*{error}"
    return _claim(terms, edge, at, "false", f"m = {m}", f"coefficient {k} is off by {error}")


KINDS = {"series": draw_series}
