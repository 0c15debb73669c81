# SPDX-License-Identifier: BSD-3-Clause
"""Scenes and recipes drawn from a random generator. Most of them are valid."""

NUMBERS = ["1", "3/2", "0.7", "2", "sqrt(2)", "pi/3", "37/40"]
TILTS = ["0", "0.01", "1/50", "pi/400", "0.003"]
SLOPES = [{"symmetric": s, "knots": k, "slopes": g} for s, k, g in (
    ("true", ["1/2"], ["0", "x - 1/2"]), ("true", ["1/4", "1"], ["x/8", "x/2 - 3/32", "x - 19/32"]),
    ("false", ["-1/3", "1/5"], ["x + 1/3", "0", "x/2 - 1/10"]), ("false", ["0"], ["x", "3*x"]),
    ("true", ["1/2"], ["x/10", "x/10 + (x - 1/2)^3"]), ("false", ["0"], ["sinh(x)", "x + x^2"]))]
LINEAR = 4  # the first slopes, all pieces linear
ASKED = ["a", "b", "P", "M", "p", "c_0", "c_1", "c_2", "extent_1", "measure_2"]


def drawn_profile(rng, slopes):
    number, tilt = rng.choice(NUMBERS), rng.choice(TILTS)
    return rng.choice([
        {"kind": "power-law", "m": rng.choice(["0", "1/2", "5/8", "1", "2", "7/3", "3", "10"]), "C": number},
        {"kind": "hertz", "R1": "100", "R2": rng.choice(["300", "-200"])}, {"kind": "hertz", "R": number},
        {"kind": "cylinder-on-flat", "R": number}, {"kind": "flat-and-rounded", "t": "0.4", "R": number},
        {"kind": "flat-and-rounded", "flat_width": "1/3", "R": number},
        {"kind": "tilted-wedge", "phi": rng.choice(["pi/16", "0.1", "1/5"]), "alpha": tilt},
        {"kind": "tilted-flat-and-rounded", "alpha": tilt, "t": "0.4", "R": number},
        {"kind": "piecewise", **rng.choice(slopes)}, {"kind": "piecewise", **rng.choice(slopes)}])


def drawn_contact(rng, slopes):
    """The sections of a contact."""
    profile, force = drawn_profile(rng, slopes), rng.choice(["1/10", "1", "0.02", "120"])
    load = rng.choice([{"a": rng.choice(NUMBERS)}, {"P": force}])
    if "alpha" in profile and rng.random() < 0.3:
        del profile["alpha"]
        load = {"P": force, "M": rng.choice(["0", "1/1000", "-1/200"])}
    elif "alpha" not in profile and profile.get("symmetric") != "false" and rng.random() < 0.2:
        load = {"width": "2"}
    sheared = rng.random() < 0.5
    load |= {"contact_modulus": rng.choice(["1", "64500", "7/3"])} if rng.random() < 0.7 else {
        "E1": "115e3", "nu1": "0.3", "E2": "115e3" if sheared else "2.1e5", "nu2": "0.3"}
    sections = {"profile": profile, "load": load}
    if sheared:
        share = rng.choice(["0.1", "-0.3", "1/2", "1e-6"])
        sections["shear"] = {"Q": f"{share}*{load.get('P', '1/100')}"} | rng.choice([
            {}, {"path": "together"}, {"friction": "0.6"}, {"friction": "0.85", "path": "normal-first"}])
        if rng.random() < 0.3:
            sections["shear"]["bulk_tension"] = rng.choice(["0", "1e-9", "-1e-4"])
    return sections


def drawn_ask(rng, quantities):
    points = rng.randrange(5)
    ask = {"edges": rng.choice([["right"], ["left"], ["right", "left"], ["left", "right"]]),
           "digits": rng.choice([15, 16, 17, 20, 25, 30, 34, 40, 50, 60]),
           "terms": rng.choice(["3", "1", "[1, 2, 3]", "[2, 5]", "[1, 12]"]), "tolerance": rng.choice(["1%", "1/20", "0.3"])}
    if points < 3:
        ask["u"] = [["1e-12", "1e-3", "0.1"], '{ from = "1e-6", to = "0.1", per_decade = 1 }', ["a/2", "10%"]][points]
    if points >= 2:
        ask["x"] = rng.choice([["0", "a/2", "-b/3"], '{ from = "-0.01", to = "0.02", points = 4 }', ["a - a/100"]])
    if rng.random() < 0.4:
        ask |= rng.choice([{"process_zone": "0.01"}, {"process_zone": "1e-6", "part": ["0", "1/2"]},
                           {"part": ["0.1", "0.2"]}])
    if rng.random() < 0.2:
        ask["quantities"] = rng.sample(quantities, rng.choice([1, 2, 3]))
    if rng.random() < 0.1:
        ask["route"] = rng.choice(["closed-form", "singular-integral", "barber-mossakovskii"])
    return ask


def text_of(sections, prefix=""):
    """The sections in TOML; values that begin with a bracket and the words of TOML stay as they are."""
    lines = []
    for name, keys in sections.items():
        lines.append(f"[{prefix}{name}]".replace(".]", "]"))
        for key, value in keys.items():
            if isinstance(value, list):
                value = "[" + ", ".join(f'"{v}"' for v in value) + "]"
            elif isinstance(value, str) and value[0] not in "[{" and value not in ("true", "false"):
                value = f'"{value}"'
            lines.append(f"{key} = {value}")
    return "\n".join(lines) + "\n"


def drawn_scene(rng):
    sections = drawn_contact(rng, SLOPES)
    if rng.random() < 0.3:
        sections["units"] = {"length": "mm", "force": "N", "pressure": "MPa"}
    shear = sections.get("shear", {})
    sections["ask"] = drawn_ask(rng, ["pressure", "coefficients", "extent", "contact", "peak", *(["shear"] if shear else []),
                                      *(["slip"] if "friction" in shear else [])])
    if sections["profile"].get("slopes") in [curved["slopes"] for curved in SLOPES[LINEAR:]]:
        sections["ask"] |= {"digits": 20, "terms": "[1, 2]"}  # more would take seconds
    return 'title = "Drawn scene"\n' + text_of(sections)


def drawn_recipe(rng):
    sections = drawn_contact(rng, SLOPES[:LINEAR])
    shear = sections.get("shear", {})
    for keys in sections.values():
        for key in [k for k in ("a", "P", "C") if k in keys and not shear]:
            keys[key] = [keys[key], f"2*({keys[key]})"]
    names = ASKED + (["q", "slip", "stick_a"] if "friction" in shear else ["q", "s_0", "s_1"] if shear else [])
    asked = {"edges": ["right", "left"], "u": ["1e-9", "1/1000", "0.2"], "quantities": sorted(rng.sample(names, 5))}
    if {"extent_1", "measure_2"} & set(asked["quantities"]):
        asked["tolerance"] = ["5%"]
    head = f'title = "Drawn recipe"\ndigits = {rng.choice([15, 20, 34, 50])}\nrounding = "nearest"\n'
    return head + text_of({"": asked, **sections}, "scenes.drawn.")
