# SPDX-License-Identifier: BSD-3-Clause
"""The contact, the load and the pressures by the singular integral equation (moore-hills eqn:ContactPressure), which is
evaluated by tanh-sinh quadrature in numpy's long double."""
import re

import mpmath
import numpy as np

LONG = np.longdouble
TOLERANCE = 1e-10  # relative
ASKED = {"edges": ["right", "left"], "u": ["1e-9*(a + b)", "(a + b)/1000", "(a + b)/7", "3/7*(a + b)"], "digits": 16,
         "quantities": ["pressure", "contact"]}


def number(text):
    names = {"pi": mpmath.pi, "sqrt": mpmath.sqrt}
    return LONG(mpmath.nstr(eval(re.sub(r"[\d.]+(e-?\d+)?", r"mpf('\g<0>')", text), names | {"mpf": mpmath.mpf}), 25))


def slope_of(profile):
    """The knots and the pieces of g', as functions of numpy arrays."""
    value = {k: number(v) for k, v in profile.items() if isinstance(v, str) and k not in ("kind", "symmetric")}
    kind, zero = profile["kind"], LONG(0)
    if kind == "power-law":
        C, m = value["C"], value["m"]
        return [zero], [lambda x: -C * np.abs(x)**m, lambda x: C * np.abs(x)**m]
    if kind in ("hertz", "cylinder-on-flat"):
        k = 1 / value["R"] if "R" in value else 1 / value["R1"] + 1 / value["R2"]
        return [], [lambda x: k * x]
    tilt = value.get("alpha", zero)
    if kind == "tilted-wedge":
        return [zero], [lambda x: -value["phi"] - tilt + 0 * x, lambda x: value["phi"] - tilt + 0 * x]
    if kind.endswith("flat-and-rounded"):
        R, t = value["R"], value["t"] if "t" in value else value["flat_width"] / 2
        begin = -t if kind == "flat-and-rounded" else -tilt * R - 2 * t
        return [begin, begin + 2 * t], [lambda x: (x - begin) / R - tilt, lambda x: -tilt + 0 * x,
                                        lambda x: (x - begin - 2 * t) / R - tilt]
    knots = [number(k) for k in profile["knots"]]
    pieces = [eval("lambda x: 0*x + " + s.replace("^", "**").replace("sinh", "np.sinh"), {"np": np})
              for s in profile["slopes"]]
    pieces = [lambda x, f=f: f(x) for f in pieces]
    if profile["symmetric"] == "true":
        return ([-k for k in reversed(knots)] + knots,
                [lambda x, f=f: -f(-x) for f in reversed(pieces)] + pieces[1:])
    return knots, pieces


class Contact:
    """A contact -b < s < a, with s = -b + (a + b) sin^2(v/2), so that ds/sqrt((a - s)(b + s)) = dv."""

    def __init__(self, profile, a, b):
        self.a, self.b, (self.knots, self.pieces) = a, b, slope_of(profile)
        self.inner = [k for k in self.knots if -b < k < a]

    def slope(self, s, of):
        """g' at s, by the piece that holds at `of`."""
        return self.pieces[sum(k < of for k in self.knots)](s)

    def integral(self, f, at=None):
        """The integral of f(s, piece's place) over v. It is split at the knots and at v = `at`; tanh-sinh on each part."""
        half = np.arange(-300, 301).astype(LONG) * LONG(1) / 75
        share = 1 / (1 + np.exp(-LONG(np.pi) * np.sinh(half)))
        weight = LONG(np.pi) * np.cosh(half) * share * share[::-1] / 75
        ends = sorted({LONG(0), LONG(mpmath.nstr(mpmath.pi, 25)), *(self.angle(k) for k in self.inner),
                       *([at] if at is not None else [])})
        total = LONG(0)
        for low, high in zip(ends, ends[1:]):
            v = np.where(share < 0.5, low + (high - low) * share, high - (high - low) * share[::-1])
            s = -self.b + (self.a + self.b) * np.sin(v / 2)**2
            middle = -self.b + (self.a + self.b) * np.sin((low + high) / 4)**2
            total += (high - low) * np.sum(weight * f(v, s, middle))
        return total

    def angle(self, s):
        return 2 * np.arctan2(np.sqrt(s + self.b), np.sqrt(self.a - s))

    def pressure(self, edge, u):
        """p/E* at the distance u from an edge; s - x is written without cancellation by the angles."""
        far = self.a + self.b - u
        at = 2 * (np.arctan2(np.sqrt(far), np.sqrt(u)) if edge == "right" else np.arctan2(np.sqrt(u), np.sqrt(far)))
        x = self.a - u if edge == "right" else u - self.b

        def quotient(v, s, middle):
            apart = (self.a + self.b) * np.sin((v + at) / 2) * np.sin((v - at) / 2)
            here = self.slope(s, middle) - self.slope(x, x)
            return np.where(np.abs(apart) > 1e-18 * (self.a + self.b), here / np.where(apart == 0, 1, apart), 0)
        return np.sqrt(u * far) / (2 * LONG(np.pi)) * self.integral(quotient, at)


def differences(sections, facts, rows):
    """What differs in the answer to a drawn scene, in words."""
    facts, load = {name: LONG(value) for name, (value, *_) in facts.items()}, sections["load"]
    profile = sections["profile"] | ({"alpha": str(facts["alpha"])} if "alpha" in facts else {})
    contact = Contact(profile, facts["a"], facts["b"])
    modulus = number(load["contact_modulus"]) if "contact_modulus" in load else 1 / sum(
        (1 - number(load[f"nu{k}"])**2) / number(load[f"E{k}"]) for k in "12")

    def value_of(name):
        return facts[name] if name in facts else number(load[name]) if name in load else None
    mean, size, force, moment = (contact.integral(f) for f in (
        lambda v, s, middle: contact.slope(s, middle), lambda v, s, middle: np.abs(contact.slope(s, middle)),
        lambda v, s, middle: modulus / 2 * s * contact.slope(s, middle),
        lambda v, s, middle: modulus / 2 * s * s * contact.slope(s, middle)))
    moment += (contact.b - contact.a) * force / 2  # moore-hills eqn:AppliedNormalForce_NonSym
    found = [f"{name} is {value}; its integral is {integral}" for name, value, integral, scale in (
        ("the mean slope", LONG(0), mean, size), ("P", value_of("P"), force, force),
        ("M", value_of("M"), moment, force * (contact.a + contact.b)))
        if value is not None and not abs(value - integral) <= TOLERANCE * scale]
    for row in rows:
        exact = modulus * contact.pressure(row["edge"], LONG(row["u"]))
        if not abs(LONG(row["p"]) - exact) <= TOLERANCE * abs(exact):
            found.append(f"p at u = {row['u']} from the {row['edge']} edge is {row['p']}; its integral is {exact}")
    return found if len(rows) == 8 else [*found, f"{len(rows)} rows"]
