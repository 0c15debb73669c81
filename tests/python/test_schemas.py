# SPDX-License-Identifier: BSD-3-Clause
"""The JSON schemas agree with the files that the program writes and reads, and refuse the files
that the readers refuse because of their form."""
import datetime
import functools
import json
import os
import pathlib
import subprocess
import sys
import tomllib

import pytest

import edgeproof

jsonschema = pytest.importorskip("jsonschema")
ROOT = pathlib.Path(__file__).resolve().parents[2]
SCHEMAS = ROOT / "share" / "edgeproof" / "schemas"


@functools.cache
def validator(name):
    return jsonschema.Draft7Validator(json.loads((SCHEMAS / f"{name}.schema.json").read_text()))


def faults(name, document):
    return [f"{'.'.join(map(str, e.absolute_path))}: {e.message[:300]}"
            for e in validator(name).iter_errors(document)]


def toml(value):
    """Writes a value of tomllib as inline TOML."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{json.dumps(k)} = {toml(v)}" for k, v in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(toml, value)) + "]"
    if isinstance(value, (datetime.date, datetime.time)):
        return value.isoformat()
    return json.dumps(value, ensure_ascii=False)


def written(document):
    return "".join(f"{json.dumps(k)} = {toml(v)}\n" for k, v in document.items())


def files_of(kind):
    """Finds the files of a kind by the section that only this kind has."""
    section = {"scene": "profile", "design": "design", "ledger": "ledger", "recipe": "scenes"}[kind]
    found = []
    for folder in ("examples", "verify", "reference"):
        for file in (ROOT / folder).rglob("*.toml"):
            document = tomllib.loads(file.read_text(encoding="utf-8"))
            if section in document and not (kind == "scene" and "design" in document):
                found.append((file, document))
    return found


@pytest.mark.parametrize("file", sorted(SCHEMAS.glob("*.json")), ids=lambda f: f.name)
def test_schemas_are_schemas(file):
    schema = json.loads(file.read_text())
    jsonschema.Draft7Validator.check_schema(schema)
    assert schema["title"]


@pytest.mark.parametrize("kind, least", [("scene", 26), ("design", 3), ("ledger", 2), ("recipe", 6)])
def test_every_file_that_ships_is_valid(kind, least):
    files = files_of(kind)
    assert len(files) >= least
    for file, document in files:
        assert faults(kind, document) == [], file


def test_editors_find_them():
    for rule in tomllib.loads((ROOT / ".taplo.toml").read_text())["rule"]:
        kind = pathlib.Path(rule["schema"]["path"]).name.split(".")[0]
        files = {f for p in rule["include"] for f in ROOT.glob(p)}
        files -= {f for p in rule.get("exclude", []) for f in ROOT.glob(p)}
        assert (ROOT / rule["schema"]["path"]).exists()
        assert files == {file for file, _ in files_of(kind)}


SMALL_LEDGER = """
[ledger]
name = "own"
source = "a test"
[define]
half = "a/2"
[[family]]
name = "hertz"
profile = "power-law"
count = 2
points = 1
u = ["1/20"]
[family.parameters]
m = ["1"]
C = ["3/7"]
a = ["3/2"]
Es = ["7/3"]
[[claim]]
id = "right"
kind = "compare"
lines = [1, 2]
printed = "p"
over = "hertz"
of = "p(x)"
says = "Es*C/2*sqrt(a^2-x^2)"
[[claim]]
id = "read"
kind = "compare"
over = "hertz"
of = "p(x)"
[[claim.reading]]
text = "so"
says = "Es*C/3*sqrt(a^2-x^2)"
"""


def read_scene(text, folder):
    edgeproof.Scene.from_text(text)


def read_ledger(text, folder):
    file = folder / "ledger.toml"
    file.write_text(text, encoding="utf-8")
    edgeproof.verify(file, digits=10, only="r*")


def read_recipe(text, folder):
    file = folder / "recipe.toml"
    file.write_text(text, encoding="utf-8")
    edgeproof.questions(file)


def places(value, path=()):
    """Yields the path of every table and every key."""
    yield path
    if isinstance(value, dict):
        for key, item in value.items():
            yield from places(item, (*path, key))
    elif isinstance(value, list) and value and isinstance(value[0], dict):
        for i, item in enumerate(value):
            yield from places(item, (*path, i))


def changed(document, path, change):
    if not path:
        return change(document)
    copy = document.copy()
    copy[path[0]] = changed(document[path[0]], path[1:], change)
    return copy


MISTAKES = {
    "true": lambda v: True,
    "a date": lambda v: datetime.date(2026, 1, 1),
    "a list of lists": lambda v: [[1]],
    "a table": lambda v: {"k": {"j": "1"}},
    "an unknown key": lambda v: {**v, "unknown_key": "1"},
}


def refused(reader, text, folder):
    try:
        reader(text, folder)
    except edgeproof.InputError:
        return True
    return False


@pytest.mark.parametrize("kind, reader, sources", [
    ("scene", read_scene, ["examples/scenes/partial-slip.toml", "examples/scenes/piecewise.toml",
                           "examples/scenes/fretting-pad.toml", "examples/compare/cylinder.toml",
                           "examples/scenes/force-and-moment.toml"]),
    ("recipe", read_recipe, ["reference/shear.toml"]),
    ("ledger", read_ledger, [None]),
])
def test_mistakes_of_form_are_refused_by_both(kind, reader, sources, tmp_path):
    """Adds an unknown key to each table, and gives each value a wrong type: the schema and the
    reader must refuse the same files."""
    tried = refusals = 0
    differ = []
    for source in sources:
        text = SMALL_LEDGER if source is None else (ROOT / source).read_text(encoding="utf-8")
        document = tomllib.loads(text)
        assert not refused(reader, written(document), tmp_path)
        for path in places(document):
            for name, change in MISTAKES.items():
                value = document
                for step in path:
                    value = value[step]
                if (name == "an unknown key") != isinstance(value, dict):
                    continue
                if kind == "ledger" and path[-1:] == ("parameters",):
                    continue  # a schema cannot check that a formula uses a parameter
                wrong = changed(document, path, change)
                by_reader = refused(reader, written(wrong), tmp_path)
                by_schema = bool(faults(kind, json.loads(json.dumps(wrong, default=lambda d: {}))))
                tried += 1
                refusals += by_reader
                if by_schema != by_reader:
                    differ.append((source, path, name, by_reader))
    assert differ == []
    assert tried > 40 and refusals > tried / 2


def run(*arguments, code=0, **options):
    program = pathlib.Path(os.environ.get("EDGEPROOF_BUILD", "")) / "bin" / "edgeproof"
    if not program.exists():
        pytest.skip("no program: run by ctest")
    done = subprocess.run([program, *map(str, arguments)], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True, cwd=ROOT, **options)
    assert done.returncode == code, done.stderr
    return done.stdout


SCENE = "examples/scenes/partial-slip.toml"


MESHES = [f"examples/compare/mesh-{n}.csv" for n in (24, 48, 96, 192)]


@pytest.mark.parametrize("schema, command, key", [
    ("table", ["pressure", SCENE], "rows"),
    ("table", ["expand", SCENE], "rows"),
    ("table", ["slip", SCENE, "--tolerance", "5%"], "rows"),
    ("table", ["extent", "examples/scenes/fretting-pad.toml", "--binary64"], "rows"),
    ("table", ["relations", "left.c0", "right.c0", "--symmetric"], "rows"),
    pytest.param("table", ["design", "examples/design/pad.toml", "--digits", "10", "--gap", "1e-2"],
                 "rows", marks=pytest.mark.slow),
    ("comparison", ["compare", "examples/compare/cylinder.toml", *MESHES], "files"),
], ids=lambda c: " ".join(c[:2]) if isinstance(c, list) else None)
def test_documents_that_are_written(schema, command, key):
    form = ["--format", "json"] if schema == "table" else ["--json"]
    data = json.loads(run(*command, *form))
    assert faults(schema, data) == [] and data[key]


def test_a_reference_table(tmp_path):
    recipe = tmp_path / "own.toml"
    recipe.write_text('title = "own"\n[scenes.one]\nu = "1/2"\nquantities = ["p"]\n'
                      'profile = {kind = "power-law", m = "1", C = ["1", "2"]}\n'
                      'load = {a = "1", contact_modulus = "1"}\n')
    assert faults("recipe", tomllib.loads(recipe.read_text())) == []
    data = json.loads(run("table", recipe, "--format", "json"))
    assert faults("table", data) == [] and len(data["rows"]) == 2


def test_verdicts(tmp_path):
    ledger = tmp_path / "own.toml"
    ledger.write_text(SMALL_LEDGER + '[[claim]]\nid = "odd"\nkind = "compare"\nover = "hertz"\n'
                      'of = "p(x)"\nsays = "nonsense("\n')
    run("verify", ledger, "--digits", "20", "--out", tmp_path / "out", code=2)
    file = tmp_path / "out" / "verdicts.json"
    if file.exists():
        assert faults("verdicts", json.loads(file.read_text())) == []
    ledger.write_text(SMALL_LEDGER)
    run("verify", ledger, "--digits", "20", "--out", tmp_path / "two")
    data = json.loads((tmp_path / "two" / "verdicts.json").read_text())
    assert faults("verdicts", data) == [] and len(data["claims"]) == 2
    data["claims"][0]["verdict"] = "likely"
    assert faults("verdicts", data)


def test_agreement(tmp_path):
    rows = "".join(f"{u},power-law,1,1,1,1,p,right,{u},{(u * (2 - u)) ** 0.5}\n"
                   for u in (0.25, 0.5, 1))
    answers = tmp_path / "a.csv"
    answers.write_text("id,kind,m,C,a,contact_modulus,quantity,edge,u,value\n" + rows)
    data = json.loads(run("check", answers, "--json", code=1))
    assert faults("agreement", data) == []
    assert not data["passes"] and data["causes"][0]["name"] == "factor-2"
