# SPDX-License-Identifier: BSD-3-Clause
"""Command lines for command_line.py: every subcommand with random files and options, mostly cheap
ones."""
import dataclasses
import functools

from drawn_inputs import HOSTILE, WORDS, hostile, near


@dataclasses.dataclass
class Command:
    """A command line to run in a folder of its own, and its output if it succeeds."""
    arguments: list
    files: dict = dataclasses.field(default_factory=dict)  # name: bytes, made before the run
    stdin: bytes = b""
    printed: str = "text"  # the form of standard output: csv, json, md, tex, text, or none
    written: dict = dataclasses.field(default_factory=dict)  # name: csv, json, svg, ... or folder
    kept: tuple = ()  # prefixes of files that a command may leave to continue later


FORMATS = ["csv", "json", "md", "tex"]
DIGITS = ["2", "3", "5", "8", "10", "15", "16", "17", "20", "30", "34"]
# Keys of a scene: a word key=value, or in the old spelling --key value.
SCENE_VALUES = {
    "m": ["0", "1/2", "5/8", "1", "3", "10", "7/3"], "C": ["1", "0.3", "1e-6"], "R": ["1", "100", "1e-3"],
    "R1": ["100"], "R2": ["300", "-200"], "t": ["0", "0.4", "1/3"], "flat_width": ["1", "0.2"],
    "phi": ["pi/16", "0.1", "pi/3"], "alpha": ["0.01", "pi/64", "-0.01"], "a": ["1", "3/2", "1e-3"],
    "width": ["2", "1e-2"], "P": ["1", "120", "1e-6"], "M": ["0", "0.1", "-1e-3"], "delta": ["0.1", "1e-4"],
    "contact_modulus": ["1", "64500"], "E": ["115e3"], "nu": ["0.32"], "E1": ["115e3"], "nu1": ["0.33"], "E2": ["2.1e5"],
    "nu2": ["0.3"], "Q": ["0.1", "0.1", "-0.3", "1e-3", "0"], "q_ratio": ["0.5", "-0.9"], "bulk_tension": ["0", "0.1", "0.01", "-1e-3"],
    "friction": ["0.3", "0.85"], "path": ["normal-first", "together"],
}
KINDS = {"power-law": ["m", "C"], "hertz": ["R"], "cylinder-on-flat": ["R"], "sphere": ["R"], "wedge": ["phi"], "cone": ["phi"],
         "flat-and-rounded": ["t", "R"], "tilted-wedge": ["phi", "alpha"], "tilted-flat-and-rounded": ["alpha", "t", "R"]}
ASKED = {"u": ["0.1", "1e-3,a/2", "1e-30", "a", "1e-12,1e-6,0.3"], "x": ["0,a/2", "0.3", "-a/3"],
         "process_zone": ["0.01", "1e-6"]}
QUANTITIES = ["pressure", "shear", "coefficients", "extent", "slip", "contact", "pressure,peak", "pressure,shear"]
TERMS = ["1", "1,2,3", "2", "3", "5", "12", "1,1"]
TOLERANCES = ["1%", "5%", "0.01", "1/100", "50%"]
NAMES = ["left.c1", "left.c0", "right.c0", "right.c1", "right.c2", "right.s0", "left.s1", "b1", "b2", "L", "P1", "P2", "P3",
         "P", "a", "b", "Q", "sig0", "m"]


def value(rng, usual):
    """A usual value, or one near it, or a hostile one."""
    draw = rng.random()
    if draw < 0.94:
        return rng.choice(usual)
    return near(rng.choice(usual), rng) if draw < 0.965 else hostile(rng)


def bad_count(rng):
    return rng.choice(["0", "-1", "1e3", "", "x", "99999999999999999999", "1.5", "+1", "1,,2", " 1", "é"])


def count(rng, usual):
    return rng.choice(usual) if rng.random() < 0.98 else bad_count(rng)


def maybe(rng, chance, *words):
    return list(words) if rng.random() < chance else []


def output(rng, command, form, chance=0.25):
    """--out with a file of that form, or with a place that cannot be written."""
    if rng.random() > chance:
        return []
    name = rng.choice(["out.txt", "out.txt", "out.txt", "new/out.txt", "a b.txt", "é.txt", "-", "/dev/full", ".", "/proc/x/y",
                       "/dev/null"])
    if name in ("out.txt", "new/out.txt", "a b.txt", "é.txt"):
        command.written[name] = form
        command.printed = "none"
    elif name != "-":
        command.printed = "any"
    return ["--out", name]


def format_of(rng, command, default="csv"):
    command.printed = default
    if rng.random() < 0.4:
        name = rng.choice(FORMATS) if rng.random() < 0.95 else rng.choice(["xml", "", "CSV"])
        command.printed = name
        return ["--format", name]
    return []


def key(rng, name, usual):
    """A key of a scene with its value."""
    if rng.random() < 0.1:
        return ["--" + name.replace("_", "-"), value(rng, usual)]
    return [f"{name}={value(rng, usual)}"]


def stated_scene(rng, slips):
    kind = rng.choice(list(KINDS))
    axisymmetric = kind in ("sphere", "cone")
    names = KINDS[kind] + rng.choice([["a"], ["P"], ["P"], ["delta"] if axisymmetric else ["a"] if "tilted" in kind else ["width"]])
    if "tilted" in kind and rng.random() < 0.3:
        names = [name for name in names if name not in ("alpha", "a", "P")] + ["P", "M"]
    names += rng.choice([["contact_modulus"]] * 8 + [["E1", "nu1", "E2", "nu2"], ["E", "nu"], []])
    names += rng.choice([["Q", "friction"], ["Q", "bulk_tension", "friction"], ["q_ratio", "friction"]] if slips else [
        [], [], [], ["Q"], ["Q", "bulk_tension"], ["Q", "friction"], ["Q", "path"]])
    if axisymmetric:
        names = [name for name in names if name != "bulk_tension"]
    if rng.random() < 0.08:
        names.append(rng.choice(list(SCENE_VALUES)))
    words = ["--" + kind] if rng.random() < 0.1 else ["kind=" + kind]
    for name in names:
        if rng.random() > 0.01:
            words += key(rng, name, SCENE_VALUES[name])
    return words


def given_scene(rng, library, command, slips=False):
    """A scene: a file, standard input or words, and words that replace keys of a file."""
    draw = rng.random()
    kind = "slip" if slips else "scene"
    if draw < 0.5:
        words = stated_scene(rng, slips)
    elif draw < 0.6:
        command.stdin = library.drawn(kind, rng)
        words = ["-"]
    else:
        command.files["in.toml"] = library.drawn(kind if rng.random() < 0.97 else "ledger", rng)
        words = ["in.toml"]
    for name, usual in ASKED.items():
        if rng.random() < (0.08 if draw >= 0.5 else 0.9 if name == "u" else 0.15):
            words += key(rng, name, usual)
    if draw >= 0.5 and rng.random() < 0.15:
        name = rng.choice(["P", "a", "contact_modulus", "Q", "C", "R"])
        words += key(rng, name, SCENE_VALUES[name])
    words += [f"edges={value(rng, ['right', 'left', 'both'])}"] if rng.random() < 0.2 else []
    words += [f"terms={value(rng, TERMS)}"] if rng.random() < 0.3 else []
    words += [f"quantities={value(rng, QUANTITIES)}"] if rng.random() < 0.06 else []
    return words


def tabled_scene(rng, library, command, digits=DIGITS, default="csv", slips=False):
    words = given_scene(rng, library, command, slips)
    words += ["--digits", count(rng, digits)]
    words += maybe(rng, 0.15, "--round", value(rng, ["nearest", "down", "up"]))
    words += maybe(rng, 0.15, "--binary64")
    words += format_of(rng, command, default)
    return words + output(rng, command, command.printed)


def extent(rng, library, command):
    words = tabled_scene(rng, library, command, DIGITS[:7]) + (key(rng, "tolerance", TOLERANCES) if rng.random() < 0.9 else [])
    return words + figure(rng, command, "--figure", 0.04)


def figure(rng, command, option, chance):
    if rng.random() > chance:
        return []
    name = rng.choice(["figure.svg", "figure.svg", "figure.csv", "figure.html", "figure.png", "figure.pdf", "figure",
                       "/dev/full"])
    if name != "/dev/full":
        command.written[name] = name.rpartition(".")[2]
    return [option, name]


def plot(rng, library, command):
    words = given_scene(rng, library, command) + (key(rng, "tolerance", TOLERANCES) if rng.random() < 0.4 else [])
    if rng.random() < 0.95:
        words += figure(rng, command, "--out", 1)
        command.printed = "any"
    return words


def relations(rng, _library, command):
    def formula():
        return rng.choice(["m*P1/a", "P1/a", "0", "2", "a^2", "b", "P2", "P3", "sqrt(a)", "L", "right.c0", "a+b", "P1^2"]) \
            if rng.random() < 0.85 else hostile(rng)
    words = rng.sample(NAMES, rng.choice([1, 1, 2, 2, 3, 4]))
    words += maybe(rng, 0.1, hostile(rng)) + maybe(rng, 0.1, "a^" + hostile(rng))
    words += ["--degree", count(rng, ["1", "2", "2", "3"])] + maybe(rng, 0.3, "--symmetric")
    for _ in range(rng.choice([0, 1, 1, 2, 3])):
        words += ["--given", (rng.choice(NAMES[8:]) if rng.random() < 0.95 else hostile(rng)) + "=" + formula()]
    words += maybe(rng, 0.4, "--free", "m") + format_of(rng, command)
    return words + output(rng, command, command.printed)


def design(rng, library, command):
    command.files["in.toml"] = library.drawn("design" if rng.random() < 0.95 else "scene", rng)
    words = ["in.toml", "--digits", count(rng, ["3", "5"]), "--gap", value(rng, ["1e-2", "1e-3", "1e-1"])]
    words += format_of(rng, command)
    return words + output(rng, command, command.printed)


def recipe(rng, library, command):
    command.files["in.toml"] = library.drawn("recipe" if rng.random() < 0.97 else "scene", rng)
    return ["in.toml"]


def table(rng, library, command):
    words = recipe(rng, library, command) + ["--threads", count(rng, ["1", "2"])] + format_of(rng, command)
    if rng.random() < 0.2:
        command.files["table.csv"] = library.drawn("answers", rng)
        command.printed = "any"  # differences are messages
        return words + ["--check", "--out", "table.csv"] + maybe(rng, 0.5, "--every", count(rng, ["2", "7"]))
    command.kept = ("out.txt", "a b.txt", "é.txt")
    return words + output(rng, command, command.printed, 0.5)


def points(rng, library, command):
    command.printed = "csv"
    return recipe(rng, library, command) + maybe(rng, 0.3, "--exact") + output(rng, command, "csv")


def check(rng, library, command):
    words = maybe(rng, 0.4, "--digits", count(rng, ["3", "12", "15"])) + maybe(rng, 0.2, "--ulps", count(rng, ["1", "10"]))
    words += maybe(rng, 0.2, "--conditioned") + maybe(rng, 0.2, "--errors", count(rng, ["0", "3"])) + ["--threads", "1"]
    if rng.random() < 0.15:
        command.written["junit.xml"] = "xml"
        words += ["--junit", "junit.xml"]
    draw = rng.random()
    if draw < 0.55:
        command.files["answers.csv"] = library.drawn("answers", rng)
        return ["answers.csv"] + words
    if draw < 0.65:
        command.files["answers.csv"] = library.drawn("answers", rng)
        command.files["in.toml"] = library.drawn("recipe", rng)
        return ["answers.csv", "--recipe", "in.toml"] + words
    if draw < 0.75:
        command.files["in.toml"] = library.drawn("ledger", rng)
        command.written = {}
        return ["--ledger", "in.toml", "--threads", "1"]
    program = rng.choice(["cat", "true", "false", "exit 3", "echo id,value", "kill -9 $$", "head -c 300", "printf 'a\\0b'",
                          "awk -F, 'NR>1 {print $1 \",1\"}'", "yes", "setsid sleep 30 &", "/no/such/program", "sleep 30"])
    command.files["in.toml"] = library.drawn("recipe", rng)
    return ["in.toml", "--exec", program, "--timeout", rng.choice(["1", "1", "1", "1", "1", "0", "x"]), "--batch",
            count(rng, ["500", "40"]), "--runs", count(rng, ["1", "3"])] + words


def compare(rng, library, command):
    command.files["in.toml"] = library.drawn("scene", rng) if rng.random() < 0.4 else next(
        t for t in library.texts["scene"] if "Two cylinders of Ti" in t).encode()
    results = [f"mesh{i}.csv" for i in range(rng.choice([1] * 20 + [2] * 8 + [3] * 4 + [0]))]
    for name in results:
        command.files[name] = library.drawn("mesh", rng)
    words = ["in.toml", *results]
    words += maybe(rng, 0.15, "--columns", value(rng, ["x=1,p=2", "x=COORD1,p=CPRESS", "x=2,p=1", "x=1,p=9"]))
    words += maybe(rng, 0.2, "--scale", value(rng, ["x=1e-3,p=1e6", "p=2", "x=1e309", "p=1e309", "x=1e200", "x=-1"]))
    words += maybe(rng, 0.15, "--origin", value(rng, ["auto", "0", "0.1", "1e300"]))
    words += maybe(rng, 0.15, "--of", value(rng, ["peak", "local", "L2"]))
    words += maybe(rng, 0.15, "--edge-zone", value(rng, ["2e", "0.1", "0", "1e300"]))
    for name in ("--tolerance", "--tolerance-a", "--tolerance-P", "--tolerance-c0", "--tolerance-q"):
        words += maybe(rng, 0.1, name, value(rng, TOLERANCES))
    if rng.random() < 0.3:
        command.printed = "json"
        words.append("--json")
    return words


def cost(rng, library, command):
    command.files["in.toml"] = library.drawn("scene", rng)
    words = ["in.toml", "--digits", value(rng, ["16", "5,10"]), "--points", count(rng, ["1", "2"])]
    if rng.random() < 0.03:
        command.written["cost"] = "folder"
        words += ["--out", "cost"]
    return words


def verify(rng, library, command):
    command.files["in.toml"] = library.drawn("ledger", rng)
    words = ["in.toml", "--digits", count(rng, ["10", "15", "20"]), "--threads", "1"]
    words += maybe(rng, 0.1, "--strict") + maybe(rng, 0.1, "--only", value(rng, ["?*", "x"]))
    if rng.random() < 0.08:
        command.written["verdicts"] = "folder"
        words += ["--out", "verdicts"]
    if rng.random() < 0.05:
        command.written["in.expected.csv"] = "csv"
        words.append("--record")
    return words


# The commands, each with the weight of its probability.
COMMANDS = {"pressure": (tabled_scene, 20), "expand": (tabled_scene, 12), "extent": (extent, 10),
            "slip": (functools.partial(tabled_scene, digits=DIGITS[:7], slips=True), 10), "plot": (plot, 3),
            "relations": (relations, 8), "design": (design, 2), "table": (table, 6), "points": (points, 6),
            "check": (check, 10), "compare": (compare, 10), "cost": (cost, 3), "verify": (verify, 10)}


def drawn_command(rng, library):
    """A command line, with the files that it reads."""
    name = rng.choices(list(COMMANDS), [weight for _, weight in COMMANDS.values()])[0]
    command = Command([])
    words = [name] + COMMANDS[name][0](rng, library, command)
    draw = rng.random()
    if draw < 0.01:
        words.insert(rng.randrange(len(words) + 1), rng.choice(["--help", "--version", "-h", "--", "--no-such", "-x", "--digit"]))
        command.printed = "any"
    elif draw < 0.02:
        del words[rng.randrange(len(words))]
        command.printed = "any"
    elif draw < 0.03:
        words.insert(rng.randrange(len(words) + 1), rng.choice(HOSTILE + WORDS))
        command.printed = "any"
    if draw < 0.03:  # the words may have another meaning, and still be right
        command.kept += tuple(name.split("/")[0] for name in command.written)
        command.written = {}
    command.arguments = [w.replace("\0", "") for w in words]
    return command
