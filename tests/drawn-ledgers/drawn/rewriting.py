# SPDX-License-Identifier: BSD-3-Clause
"""Equivalent texts of a formula, and edits whose effect is known."""

# Names that every scene has, none of them zero.
NAMES = ("a", "Es", "L", "P", "b")


def equivalent(rng, text, times=1, names=NAMES):
    """A text with the same value, in whose evaluation digits are lost, sometimes nearly all."""
    for _ in range(times):
        z, w = rng.sample(names, 2)
        k, large = rng.randint(2, 9), rng.choice(("1e6", "1e12", "1e30"))
        text = rng.choice((
            f"({text})*(cos({z}/({z}+{w}))^2 + sin({z}/({z}+{w}))^2)",
            f"{k}*({text})/{k}",
            f"({text})*{z}/{z}",
            f"({text})*{z}*{w}/({w}*{z})",
            f"({text})*exp({z}/{w}/({z}/{w}+1))*exp(-({z}/({z}+{w})))",
            f"({text})*(1+{z}/{w}) - ({text})*{z}/{w}",
            f"({text})*((1+{z}/{w})^2 - 2*{z}/{w} - {z}^2/{w}^2)",
            f"({text})*(1+{large}) - ({text})*{large}",
            f"({text})*sqrt({z}^2/({w}^2))*{w}/{z}",
            f"({text})*(sqrt({k*k + 1})-{k})*(sqrt({k*k + 1})+{k})",
            f"({text})*tan(Pi/4)",
            f"({text})*log(exp({k}))/{k}",
            f"({text})*4*atan(1)/Pi",
        ))
    return text


def spoiled(rng, text, digits):
    """A text whose relative error is at least 10^(7 - digits) and at most 1, and that error."""
    decades = rng.randint(0, max(0, digits - 7))
    error = f"{rng.randint(1, 9)}e-{decades}" if decades else f"1/{rng.randint(2, 9)}"
    sign = rng.choice("+-")
    factor = f"(1{sign}{error})"
    return rng.choice((f"({text})*{factor}", f"({text}){sign}({text})*{error}", f"({text})/{factor}")), error
