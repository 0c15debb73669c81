# SPDX-License-Identifier: BSD-3-Clause
"""Independent values of every name in a formula: closed forms of contact mechanics, evaluated by
mpmath.

Nothing here is taken from Edgeproof. The pressures are those of the plane problem for an odd slope
g' (symmetric profiles), or of the tilted wedge; multipliers at an edge are found from the integral
of Mossakovskii, whose powers are expanded with beta functions."""
import re

from mpmath import beta, binomial, exp, gamma, log, mp, mpf, pi, sqrt
import mpmath

DPS = 800  # a remainder of six terms at 1e-69 of the contact has 420 zeros


def _power_law(s):
    m, C, Es, a = s["m"], s["C"], s["Es"], s["a"]
    k = Es * C * sqrt(pi) / (2 + m) * gamma(2 + m / 2) / gamma((3 + m) / 2)

    def force(n, at):
        value = k * at ** (m + 1 - n)
        for i in range(n):
            value *= m + 1 - i
        return value

    def pressure(x):
        root, far = sqrt(a * a - x * x), abs(x)
        if m == 0:
            return Es * C / pi * log((a + root) / far)
        if m == 1:
            return Es * C / 2 * root
        if m == 2:
            return Es * C / pi * (a * root + (x * x * log((a + root) / far) if x else 0))
        if m == 3:
            return Es * C / 4 * root * (a * a + 2 * x * x)
        raise KeyError("no closed pressure")
    return force, pressure, lambda x: C * mpmath.sign(x) * abs(x) ** m if x else mpf(0)


def _flat(s):
    t, R, Es, a = s["t"], s["R"], s["Es"], s["a"]

    def force(n, at):
        if n == 0:
            return Es / R * (pi * at**2 / 4 - at**2 * mpmath.asin(t / at) / 2 - t * sqrt(at**2 - t**2) / 2)
        if n == 1:
            return Es * at / R * mpmath.acos(t / at)
        if n == 2:
            return Es / R * (mpmath.acos(t / at) + t / sqrt(at**2 - t**2))
        if n == 3:  # the derivatives of acos(t/a) and of t (a^2 - t^2)^(-1/2)
            return Es / R * (t / (at * sqrt(at**2 - t**2)) - at * t / sqrt(at**2 - t**2) ** 3)
        if n == 4:
            root = sqrt(at**2 - t**2)
            return Es / R * (-t / (at**2 * root) - 2 * t / root**3 + 3 * at**2 * t / root**5)
        raise KeyError("no further derivative")

    def kernel(x, at):  # p for a unit change of slope at `at`
        return log(abs((a * a - x * at + sqrt((a * a - x * x) * (a * a - at * at))) / (a * (x - at))))

    def pressure(x):
        value = 2 * sqrt(a * a - x * x) * mpmath.acos(t / a)
        value -= (t - x) * kernel(x, t) if x != t else 0
        value -= (t + x) * kernel(x, -t) if x != -t else 0
        return Es / (2 * pi * R) * value
    return force, pressure, lambda x: mpmath.sign(x) * max(abs(x) - t, mpf(0)) / R


def _wedge(s):
    phi, gam, Es = s["phi"], s["gam"], s["Es"]

    def force(n, at):
        return Es * phi * sqrt(gam) * (at if n == 0 else mpf(n == 1))
    a, b = s["a"], s["a"] * gam

    def pressure(x):
        w = sqrt(gam * (a - x) / (x + b))
        return Es * phi / pi * log(abs((1 + w) / (1 - w)))
    return force, pressure, None


class Scene:
    """The names of one scene. `parameters`: mpf values, including gam for a tilted wedge."""

    def __init__(self, profile, parameters):
        self.parameters = parameters
        self.tilted = profile == "tilted-wedge"
        make = {"power-law": _power_law, "flat-and-rounded": _flat, "tilted-wedge": _wedge}[profile]
        self.force, self.p, self.g1 = make(parameters)
        self.a = parameters["a"]
        self.rate = parameters["gam"] if self.tilted else mpf(1)  # db/da
        self.b = self.a * self.rate
        self._c = {}

    def c(self, edge, k):
        """The multiplier of u^(k + 1/2) in p at an edge."""
        if (edge, k) not in self._c:
            sign, L = mpf(1), self.a + self.b
            rate, scale = (self.rate, mpf(1)) if edge == "right" else (1 / self.rate, 1 / self.rate)
            total = mpf(0)
            for i in range(k + 1):  # P'(a - w) by powers w^i; (L - u - rate w)^(-1/2) by powers j
                j = k - i
                outer = scale * (self.force(i + 1, self.a) * (-sign) ** i / mpmath.factorial(i))
                outer *= binomial(mpf(-1) / 2, j) * (-1) ** j * L ** (mpf(-1) / 2 - j)
                inner = sum(binomial(j, l) * rate**l * beta(i + l + 1, mpf(1) / 2) for l in range(j + 1))
                total += outer * inner
            self._c[edge, k] = total / pi
        return self._c[edge, k]

    def local(self, edge, n, x):
        u = self.a - x if edge == "right" else self.b + x
        return sum(self.c(edge, k) * u**k for k in range(int(n))) * sqrt(u)

    def names(self):
        L = self.a + self.b
        names = {**self.parameters, "a": self.a, "b": self.b, "L": L, "P": self.force(0, self.a), "Pi": +pi,
                 "pi": +pi,
                 "p": self.p, "g1": self.g1, "Pof": lambda s: self.force(0, s), "P1of": lambda s: self.force(1, s),
                 "bof": lambda s: s * self.rate, "binv": lambda y: y / self.rate,
                 "right_local": lambda n, x: self.local("right", n, x),
                 "left_local": lambda n, x: self.local("left", n, x), "b1": self.rate, "b2": mpf(0), "b3": mpf(0)}
        if "Q" in self.parameters and "sig0" in self.parameters:
            Q, sig0 = self.parameters["Q"], self.parameters["sig0"]
            names["q"] = lambda x: (Q / pi + sig0 * (2 * x + self.b - self.a) / 8) / sqrt((self.a - x) * (x + self.b))
        return _Lazy(names, self)


class _Lazy(dict):
    """Names that are computed when they are used."""

    def __init__(self, names, scene):
        super().__init__(names)
        self.scene = scene

    def __missing__(self, name):
        if match := re.fullmatch(r"P([1-9])", name):
            return self.scene.force(int(match[1]), self.scene.a)
        if match := re.fullmatch(r"(right|left)_c([0-9])", name):
            return self.scene.c(match[1], int(match[2]))
        if name in FUNCTIONS:
            return FUNCTIONS[name]
        raise KeyError(name)

    def copy(self):
        return _Lazy(self, self.scene)


FUNCTIONS = {"sqrt": sqrt, "exp": exp, "log": log, "sin": mpmath.sin, "cos": mpmath.cos, "tan": mpmath.tan,
             "asin": mpmath.asin, "acos": mpmath.acos, "atan": mpmath.atan, "sinh": mpmath.sinh, "cosh": mpmath.cosh,
             "tanh": mpmath.tanh, "gamma": gamma, "abs": abs, "sgn": mpmath.sign, "min": min, "max": max,
             "step": lambda x: (1 + mpmath.sign(x)) / 2, "hypot": mpmath.hypot, "mpf": mpf}


def _python(text):
    text = re.sub(r"\b(right|left)\.([cs]\d)", r"\1_\2", text)
    text = re.sub(r"(?<![\w.])(\d+(?:\.\d*)?(?:[eE][-+]?\d+)?)", r"mpf('\1')", text)
    return text.replace("^", "**")


def value(text, names, **more):
    """The value of a formula at DPS digits."""
    with mp.workdps(DPS):
        scope = names.copy()
        scope.update(more)
        return mpf(eval(_python(text), {"__builtins__": {}}, scope))  # only own texts


class Plain(dict):
    """Names without a contact."""

    def __missing__(self, name):
        if name in FUNCTIONS:
            return FUNCTIONS[name]
        if name in ("Pi", "pi"):
            return +pi
        raise KeyError(name)

    def copy(self):
        return Plain(self)


def parameters_of(family, choice=0):
    """The values in the lists of a family at one index; texts may refer to each other."""
    with mp.workdps(DPS):
        texts = {name: values[choice % len(values)] for name, values in family.parameters}
        known = {}
        while len(known) < len(texts):
            for name, text in texts.items():
                if name not in known:
                    try:
                        known[name] = value(text, Plain(known))
                    except NameError:
                        continue
        return known


def scene_of(family, **overrides):
    """The scene of a family whose lists have one value each; `overrides`: other texts of parameters."""
    lists = tuple((n, (overrides.get(n, v[0]),)) for n, v in family.parameters)
    with mp.workdps(DPS):
        return Scene(family.profile, parameters_of(type(family)(family.profile, lists)))
