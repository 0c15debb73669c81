# SPDX-License-Identifier: BSD-3-Clause
"""Claims of the kind expansion: a series in a small distance, power by power."""
from .. import scenes
from ..ledger import Claim
from ..rewriting import equivalent

# (quantity, its terms with their powers, the last power), for any contact. c: coefficients.
GENERAL = (
    ("P1of(a-eps)", (("P1", "0"), ("-P2", "1"), ("P3/2", "2")), 2),
    ("Pof(a-eps)", (("P", "0"), ("-P1", "1"), ("P2/2", "2")), 2),
    ("bof(a-eps)", (("b", "0"), ("-b1", "1"), ("b2/2", "2")), 2),
    ("binv(b-eps)", (("a", "0"), ("-1/b1", "1"), ("-b2/(2*b1^3)", "2")), 2),
    ("sqrt(a-eps)", (("sqrt(a)", "0"), ("-1/(2*sqrt(a))", "1"), ("-1/(8*a^(3/2))", "2")), 2),
    ("1/(a+b-eps)", (("1/L", "0"), ("1/L^2", "1"), ("1/L^3", "2")), 2),
    ("exp(-eps/a)", (("1", "0"), ("-1/a", "1"), ("1/(2*a^2)", "2")), 2),
    ("log(1+eps/a)", (("1/a", "1"), ("-1/(2*a^2)", "2"), ("1/(3*a^3)", "3")), 3),
    ("sin(eps/a)", (("1/a", "1"), ("-1/(6*a^3)", "3")), 3),
    ("P1of(a-eps)/sqrt(1-eps/(2*a))", (("P1", "0"), ("P1/(4*a) - P2", "1")), 1),
    ("sqrt(eps)*P1of(a-eps)", (("P1", "1/2"), ("-P2", "3/2")), "3/2"),
    ("p(a-eps)", (("right.c0", "1/2"), ("right.c1", "3/2"), ("right.c2", "5/2")), "5/2"),
    ("p(a-eps)", (("2*P1/(Pi*sqrt(a+b))", "1/2"), ("((3+2*b1)*P1 - 4*(a+b)*P2)/(3*Pi*(a+b)^(3/2))", "3/2")), "3/2"),
    ("p(a-eps)^2", (("right.c0^2", "1"), ("2*right.c0*right.c1", "2")), 2),
    ("1/sqrt(eps)*p(a-eps)", (("right.c0", "0"), ("right.c1", "1")), 1),
    ("Pof(a-eps)*bof(a-eps)", (("P*b", "0"), ("-P1*b - P*b1", "1")), 1))
# In the tilted wedge P and b are linear in a.
LINEAR = (("P1of(a-eps)", (("P1", "0"),), 2), ("Pof(a-eps)", (("P", "0"), ("-P1", "1")), 2),
          ("bof(a-eps)", (("b", "0"), ("-b1", "1")), 3),
          ("binv(b-eps)", (("a", "0"), ("-1/b1", "1")), 2),
          ("P1of(a-eps)/sqrt(1-eps/(2*a))", (("P1", "0"), ("P1/(4*a)", "1")), 1),
          ("p(a-eps)", (("right.c0", "1/2"), ("right.c0*(3+2*gam)/(6*(1+gam)*a)", "3/2")), "3/2"))
# In a Hertz contact P''' = 0, and P = a P'/2.
HERTZ = (("P1of(a-eps)", (("P1", "0"), ("-P2", "1")), 2), ("P1of(a-eps)", (("P1", "0"), ("-P1/a", "1")), 1),
         ("Pof(a-eps)", (("P", "0"), ("-2*P/a", "1"), ("P/a^2", "2")), 3),
         ("p(a-eps)", (("right.c0", "1/2"), ("-right.c0/(4*a)", "3/2")), "3/2"),
         ("p(a-eps)", (("Es*C/2*sqrt(2*a)", "1/2"), ("-Es*C/2*sqrt(2*a)/(4*a)", "3/2"),
                       ("-Es*C/2*sqrt(2*a)/(32*a^2)", "5/2")), "5/2"))
SMALL = (("a*1e-14", "a*3e-15"), ("a*1e-8", "a*3e-9"), ("a/1000", "a/3000"), ("a*1e-20", "a*1e-25"))


def _power(exponent):
    return {"0": "", "1": "eps*", "1/2": "sqrt(eps)*"}.get(exponent, f"eps^({exponent})*")


def draw_expansion(rng, digits):
    which = rng.choice(("general", "general", "linear", "hertz", "given", "partial"))
    keys = {}
    if which == "linear":
        at, (of, terms, through) = scenes.wedge(rng), rng.choice(LINEAR)
    elif which in ("hertz", "given"):
        at, (of, terms, through) = scenes.power_law(rng, "1"), rng.choice(HERTZ)
        if which == "given":
            keys = {"given": {"P": "Pi/4*Es*C*a^2"}}
    else:
        at = rng.choice((scenes.wedge, scenes.tilted_flat, scenes.flat, scenes.power_law))(rng)
        of, terms, through = rng.choice(GENERAL)
    truth, why = "true", ""
    terms = list(terms)
    if which == "partial":  # fewer terms, and their order
        keep = rng.randint(1, len(terms))
        terms = terms[:keep]
        through = terms[-1][1]
    if rng.random() < 0.4:
        # An edit that shows in every contact: of a coefficient that is never zero, or a new term.
        k = 0 if which != "hertz" and rng.random() < 0.6 else rng.randrange(len(terms))
        coefficient, exponent = terms[k]
        if coefficient in ("-P2", "-b1") or k > 0 and which in ("general", "partial"):
            k, (coefficient, exponent) = 0, terms[0]
        error = rng.choice(("1/2", "1/9", "1e-3", "1e-9", "1e-13"))
        terms[k] = (f"({coefficient})*(1+{error})", exponent)
        truth, why = "false", f"a coefficient is off by {error} of itself"
    text = " + ".join(f"{_power(e)}({equivalent(rng, c, rng.choice((0, 0, 1)), ('a', 'b', 'P1'))})" for c, e in terms)
    keys = {"says": text, "of": of, "variable": "eps", "through": str(through), **keys,
            "vary": {"eps": rng.choice(SMALL)}}
    return Claim("expansion", keys, at, truth, which, why)


# Coefficients of p in half powers of u, the distance from an edge, by the exponent of a power law.
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


KINDS = {"expansion": draw_expansion, "series": draw_series}
