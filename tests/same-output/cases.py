# SPDX-License-Identifier: BSD-3-Clause
"""The cases of scripts/same-output: command lines with the files that they read."""
import dataclasses
import importlib.util
import pathlib
import random
import re
import runpy
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/fuzz"), str(ROOT / "tests/drawn-ledgers")]

import drawn_commands  # noqa: E402
import drawn_inputs  # noqa: E402
import drawn_scenes  # noqa: E402

ONE = ["--threads", "1"]
FORMATS = ["csv", "json", "md", "tex"]
# Programs for `check --exec` whose output depends on the time at which they are stopped.
UNSTEADY = {"yes", "sleep 30", "setsid sleep 30 &"}


@dataclasses.dataclass
class Case:
    """Steps that run one after another in one folder. A step is a list of arguments of the program, or the tuple
    (name of a table, seed): that table is changed in one place."""
    name: str
    steps: list
    files: dict = dataclasses.field(default_factory=dict)  # name: bytes
    stdin: bytes = b""
    seconds: float = 1  # the limit of processor time of a step, in units of the option --seconds


def read(*names):
    return {pathlib.Path(name).name: (ROOT / name).read_bytes() for name in names}


def in_formats(*words):
    return [[*words, "--format", form] for form in FORMATS]


def shipped_scenes():
    for path in [*sorted((ROOT / "examples/scenes").glob("*.toml")), ROOT / "examples/compare/cylinder.toml"]:
        scene = path.name
        steps = [s for c in ("pressure", "expand", "extent", "slip") for s in in_formats(c, scene)]
        steps += [["plot", scene, *o] for o in (
            [], ["--out", "plot.svg"], ["--out", "plot.png"], ["--out", "plot.pdf"])]
        steps += [["pressure", scene, "--round", r, "--digits", "17", "--binary64", "--out", f"{r}.csv"]
                  for r in ("nearest", "down", "up")]
        steps += [["expand", scene, "--edge", "both", "--terms", "5"],
                  ["extent", scene, "--tolerance", "2%", "--figure", "figure.csv"]]
        yield Case(f"scene {path.stem}", steps, read(path), seconds=4)
    for name in ("fig3b-hertz", "fig5a-flat-and-rounded"):
        words = ["cost", name + ".toml", "--digits", "16,34", "--points", "1"]
        yield Case(f"cost {name}", [words + o for o in ([], ["--out", "cost"])],
                   read(f"examples/scenes/{name}.toml"), seconds=4)


def shipped_examples():
    """The examples of design, compare and check, and the recipes of the reference tables."""
    for path in sorted((ROOT / "examples/design").glob("*.toml")):
        words = ["design", path.name, "--digits", "8", "--gap", "1e-1"]
        yield Case(f"design {path.stem}", in_formats(*words), read(path), seconds=4)
    meshes = sorted((ROOT / "examples/compare").glob("*.csv"))
    for some in [*([m] for m in meshes), [m for m in meshes if m.stem.startswith("mesh")]]:
        options = ["", "--json", "--of local", "--of L2",
                   "--origin auto", "--edge-zone 2e", "--tolerance 0.1% --tolerance-c0 1%"]
        words = ["compare", "cylinder.toml", *(m.name for m in some)]
        yield Case("compare " + " ".join(m.stem for m in some), [words + o.split() for o in options],
                   read("examples/compare/cylinder.toml", *some), seconds=4)
    asked = ["check", "questions.toml", *ONE, "--exec"]
    programs = ("closed_forms.py", "wrong_on_purpose.py")
    yield Case("check third-party", [
        ["points", "questions.toml"], ["points", "questions.toml", "--exact", "--out", "points.csv"],
        *([*asked, "python3 closed_forms.py", *o] for o in (["--digits", "13"], ["--ulps", "1"])),
        [*asked, "python3 closed_forms.py", "--conditioned", "--ulps", "2"],
        [*asked, "python3 wrong_on_purpose.py", "--digits", "12", "--junit", "junit.xml"],
        ["check", "--ledger", "formulas.toml", *ONE]],
        read(*("examples/third-party/" + n for n in ("questions.toml", "formulas.toml", *programs))), seconds=4)
    for path in sorted((ROOT / "reference").glob("*.toml")):
        if path.stem != "hard-cases":
            yield Case(f"recipe {path.stem}", [
                ["points", path.name], ["table", path.name, "--check", "--every", "5", *ONE],
                ["check", path.stem + ".csv", *ONE]], read(path, path.with_suffix(".csv")), seconds=6)


def shipped_checks(seed):
    """The ledger of the paper, and the commands without an input."""
    files = read("verify/moore-hills.toml", "verify/moore-hills.expected.csv")
    ledger = ["moore-hills.toml", *ONE, "--only"]
    for group in sorted({i + "*" for i in re.findall(r'(?m)^id = "(\w{3})', files["moore-hills.toml"].decode())}):
        yield Case(f"verify moore-hills {group}", [["verify", *ledger, group, "--digits", "15", "--out", "verdicts"]], files, seconds=6)
    yield Case("verify record", [["verify", *ledger, "EQ05", "--digits", "20", "--record", "--strict"]], files)
    yield Case("relations", [s for words in (
        "left.c0 right.c0", "left.c1 left.c0 left.s0 --degree 2",
        "right.c1 right.c0 P --symmetric --given P2=m*P1/a --free m")
        for s in in_formats("relations", *words.split())], seconds=4)
    yield Case("help", [["--version"], ["--help"], [], ["none"], *([c, "--help"] for c in drawn_commands.COMMANDS)])


def scene_cases(seed, count, library):
    for number in range(count):
        rng = random.Random(f"{seed} scene {number}")
        text = drawn_scenes.drawn_scene(rng)
        if rng.random() < 0.25:
            text = rng.choice(drawn_inputs.TOML_CHANGES)(text, rng, library, "scene")
        likely = ["pressure", "expand", "extent"] + ["slip"] * 3 * ("friction" in text)
        words = [rng.choice(likely if rng.random() < 0.95 else ["slip"]) for _ in range(3)]
        steps = [[w, "s.toml", "--format", rng.choice(FORMATS)] for w in words]
        steps[0] += rng.choice([[], [], ["--round", rng.choice(["down", "up"])], ["--binary64"]])
        steps[1] += rng.choice([[], ["--edge", "both"], ["--out", "written"], ["--terms", "1,2"]])
        if number % 4 == 0:
            steps.append(["plot", "s.toml", *rng.choice([[], ["--out", "plot.svg"], ["--out", "plot.csv"]])])
        yield Case(f"drawn scene {number}", steps, {"s.toml": text.encode("utf-8", "surrogatepass")})


def recipe_cases(seed, count, library):
    for number in range(count):
        rng = random.Random(f"{seed} recipe {number}")
        text = drawn_scenes.drawn_recipe(rng) if rng.random() < 0.6 else library.plain("recipe", rng)
        if rng.random() < 0.15:
            text = rng.choice(drawn_inputs.TOML_CHANGES)(text, rng, library, "recipe")
        check = ["check", "t.csv", *ONE]
        yield Case(f"drawn recipe {number}", [
            ["points", "r.toml", *rng.choice([[], ["--exact"]])],
            ["table", "r.toml", *ONE, "--format", rng.choice(FORMATS)],
            ["table", "r.toml", *ONE, "--out", "t.csv"], check, ("t.csv", f"{seed} {number}"),
            [*check, *rng.choice([[], ["--digits", "12"], ["--ulps", "2"], ["--recipe", "r.toml", "--junit", "j.xml"]])],
            ["table", "r.toml", *ONE, "--check", "--out", "t.csv"]], {"r.toml": text.encode("utf-8", "surrogatepass")})


def ledger_cases(seed, claims):
    if not claims or importlib.util.find_spec("mpmath") is None:
        print("no drawn ledgers" + (": Python has no package mpmath (python3-mpmath)" if claims else ""))
        return
    drawn_ledgers = runpy.run_path(str(ROOT / "tests/drawn-ledgers/run"))["drawn_ledgers"]
    for ledger, digits in drawn_ledgers(seed, claims, [], (15, 20, 30, 50)):
        steps = [["verify", "l.toml", "--digits", str(digits), *ONE, "--out", "verdicts"]]
        yield Case(f"drawn ledger {ledger.name}", steps, {"l.toml": ledger.text().encode()}, seconds=4)


def command_cases(seed, count, library):
    """Command lines of tests/fuzz."""
    for number in range(count):
        rng = random.Random(f"{seed} command {number}")
        command = drawn_commands.drawn_command(rng, library)
        if not UNSTEADY & set(command.arguments):
            yield Case(f"drawn command {number}", [command.arguments], command.files, command.stdin)


def all_cases(options):
    seed, library = options.seed, drawn_inputs.Library(ROOT)
    return [*shipped_checks(seed), *shipped_scenes(), *shipped_examples(), *ledger_cases(seed, options.claims),
            *scene_cases(seed, options.scenes, library), *recipe_cases(seed, options.recipes, library),
            *command_cases(seed, options.commands, library)]
