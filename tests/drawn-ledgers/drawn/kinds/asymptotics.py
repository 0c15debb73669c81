# SPDX-License-Identifier: GPL-3.0-or-later
"""Claims of the kinds series, order, uniformity and split: the remainders of expansions."""
from .. import scenes
from ..ledger import Claim, family
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


# (quantity, its order in u), for exponents m other than 5/8 and 1 +- sqrt(...).
def _orders(n):
    return ((f"1 - right_local({n}, x)/p(x)", f"{n}"), (f"abs(1 - right_local({n}, x)/p(x))", f"{n}"),
            (f"p(x) - right_local({n}, x)", f"{2 * n + 1}/2"),
            ("p(x)", "1/2"), ("p(x)^2", "1"), ("1/p(x)", "-1/2"), ("p(x)/u", "-1/2"), ("1 - cos(u/a)", "2"),
            ("sin(u/a) - u/a", "3"), ("u/a", "1"),
            ("sqrt(u/a + u^2/a^2)", "1/2"), ("exp(u/a) - 1", "1"), ("exp(u/a) - 1 - u/a", "2"), ("log(1 + u/a)", "1"),
            ("1 + u/a", "0"),
            ("right.c0", "0"), ("(a-x)/a", "1"), ("sqrt(u)*(1 + u/a)", "1/2"), ("(u/a)^(1/3)", "1/3"),
            ("Pof(a) - Pof(x)", "1"), ("P1of(x)", "0"))


def draw_order(rng, digits):
    of, order = rng.choice(_orders(rng.randint(1, 3)))
    at = rng.choice((lambda: scenes.power_law(rng, rng.choice(("1", "2", "3", "0"))),
                     lambda: scenes.flat(rng, t="a/3")))()
    if rng.random() < 0.08:
        says, truth = rng.choice((("u/a", "true"), ("(u/a)^2", "false")))
        m = rng.choice(("5/8+1e-20", "5/8-1e-60", "5/8+1e-30"))
        return Claim("order", {"says": says, "of": "1 - right_local(1, x)/p(x)"}, scenes.power_law(rng, m), truth,
                     "hidden")
    if rng.random() < 0.12:
        # These terms show only closer to the edge than any computed place.
        of, order, claimed = rng.choice((("sqrt(u/a) + 1e-40*(u/a)^(1/4)", "1/4", "1/2"),
                                         ("u/a + 1e-60*sqrt(u/a)", "1/2", "1"),
                                         ("1e-50 + u/a", "0", "1"), ("(u/a)^2 + 1e-90*u/a", "1", "2")))
        if rng.random() < 0.5:
            return Claim("order", {"says": f"(u/a)^({order})", "of": of}, at, "true", "hidden")
        return Claim("order", {"says": f"(u/a)^({claimed})", "of": of}, at, "false", "hidden")
    kind = rng.choice(("true", "true", "higher", "lower"))
    shift = {"true": "", "higher": rng.choice((" + 1/2", " + 1", " + 1e-3")),
             "lower": rng.choice((" - 1/2", " - 1", " - 1e-3"))}[kind]
    factor = rng.choice(("", "3*", "1e-20*", "1e30*", "(1 + sqrt(u/a))*" if digits < 60 and kind == "true"
                         and order != "0" else ""))
    if "sqrt(u/a)" in factor:
        factor = "(1 + u^2/a^2)*"
    says = f"{factor}(u/a)^({order}{shift})"
    truth = {"true": "true", "higher": "false", "lower": "imprecise"}[kind]
    return Claim("order", {"says": says, "of": of, "edge": "right"}, at, truth, "order", f"of order {order}")


# The remainder divided by eps^2, in s = 1 - sigma; True if it stays bounded as s -> 0.
RESTS = (("log({s})", False), ("1/({s})", False), ("({s})^(-1/10)", False), ("({s})^(-2)", False),
         ("1e-30/({s})", False), ("sqrt({s})", True),
         ("({s})*log({s})", True), ("1", True), ("{sigma}", True), ("sin(1/({s}))", True), ("1e30*({s})", True),
         ("1e-30", True), ("exp({sigma})", True),
         ("1e-30*log({s})", False), ("1/({s})^(1/100)", False), ("log(1 - log({s}))", False), ("1/(1 + {s})", True),
         ("exp(-1/({s}))", True),
         ("1/({s}) - 1/({s})", True), ("({s})/({s})", True), ("1e20 + 1/({s})", False), ("1e20 + {s}", True),
         ("1 + log({s})", False),
         ("(1 + {s})^2 - 1", True), ("1/sqrt({s})", False), ("{sigma}/({s})*1e-12", False),
         ("log({s})^2*({s})", True), ("0", True),
         ("(1/({s}) + 1e6)", False), ("1e6*{sigma} + 1e-9/({s})", False))
BASES = ("1 + {e}", "1 + {e}*{sigma}", "exp({e})", "1/(1 - {e}*{sigma})", "1 + {e}/3 + {e}*log(2)", "0", "1")


def draw_uniformity(rng, digits):
    rest, uniform = rng.choice(RESTS)
    order = rng.choice((1, 2, 2, 3))
    end, s = rng.choice((("1", "1 - sigma"), ("1", "1 - sigma"), ("1/2", "1/2 - sigma")))
    rest = rest.format(s=s, sigma="sigma")
    base = rng.choice(BASES).format(e="eps/a", sigma="sigma")
    of = f"{base} + (eps/a)^{order}*a^{order}*({rest})" if rng.random() < 0.5 else f"({base}) + eps^{order}*({rest})"
    says = rng.choice(("uniform", "breaks down"))
    keys = {"says": says, "of": of, "approximation": base, "small": "eps", "order": order, "variable": "sigma",
            "towards": end,
            "vary": {"eps": rng.choice((("a*1e-6", "a*3e-7"), ("a/100", "a/300"), ("a*1e-12", "a*3e-12"))),
                     "sigma": ["1/3"]}}
    if rng.random() < 0.3:
        keys["term"] = rest
    return Claim("uniformity", keys, scenes.power_law(rng, "1"), "true" if uniform == (says == "uniform")
                 else "false",
                 "slow" if any(t in rest for t in ("log", "1/100", "1/10", "e-")) else "plain")


# Integrands in sigma from 0 to 1 and eps; True if terms of the cut cancel through a power of eps.
# If the integrand has a layer of width eps at sigma = 1, its expansion misses the term of the
# layer.
SPLITS = (("1/(1 + {e}*sigma)", "1", True), ("sqrt(1 + {e}*sigma)", "2", True),
          ("exp({e}*sigma)/sqrt(1 - sigma)", "1", True),
          ("1/sqrt(1 - sigma)*(1 + {e})", "1", True), ("cos({e}*sigma)", "2", True), ("(1 + {e}*sigma)^3", "3", True),
          ("1/sqrt(1 - sigma + {e})", "1", False), ("sqrt(1 - sigma + {e})", "2", False),
          ("1/sqrt(1 - sigma + {e})", "1/4", True),
          ("1/sqrt((1 - sigma)*(1 + {e}*sigma))", "1", True))


def draw_split(rng, digits):
    of, through, cancel = rng.choice(SPLITS)
    keys = {"of": of.format(e="eps/a"), "variable": "sigma", "small": "eps", "through": through,
            "vary": {"eps": ["a*1e-3", "a*3e-4"], "delta": ["1/3", "1/20"], "sigma": ["1/2"]}}
    return Claim("split", keys, scenes.power_law(rng, "1"), "true" if cancel else "false", "regular" if cancel
                 else "a layer", most_digits=40)


KINDS = {"series": draw_series, "order": draw_order, "uniformity": draw_uniformity, "split": draw_split}
