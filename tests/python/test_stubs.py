# SPDX-License-Identifier: BSD-3-Clause
"""The stub file agrees with the compiled module, and every public name is documented."""
import ast
import inspect
import pathlib
import re
import shutil
import subprocess
import sys

import pytest

import edgeproof
from edgeproof import _edgeproof

PACKAGE = pathlib.Path(edgeproof.__file__).parent
# Members that Python adds to every class (two of them since 3.13), and pybind11 to its own.
GIVEN = {"__doc__", "__module__", "__new__", "__init__", "__dict__", "__repr__", "__str__",
         "_pybind11_conduit_v1_", "__hash__", "__static_attributes__", "__firstlineno__"}


def stubs():
    tree = ast.parse((PACKAGE / "_edgeproof.pyi").read_text())
    names = {}
    for node in tree.body:
        if isinstance(node, ast.ClassDef):
            names[node.name] = {n.name: n for n in node.body if isinstance(n, ast.FunctionDef)}
        elif isinstance(node, ast.FunctionDef):
            names[node.name] = node
    return names


def parameters_in(node):
    every = node.args.posonlyargs + node.args.args + node.args.kwonlyargs
    return [a.arg for a in every if a.arg != "self"]


def parameters_of(function):
    """Reads pybind11's first line: name(self: T, arg: U = d, *, kw: V) -> W."""
    line = (function.__doc__ or "").splitlines()[0]
    inside = line[line.index("(") + 1:line.rindex(") ->")]
    inside = re.sub(r"\[[^\[\]]*\]", "", re.sub(r"\[[^\[\]]*\]", "", re.sub(r"\[[^\[\]]*\]", "",
                                                                      inside)))
    names = [part.split(":")[0].strip() for part in inside.split(",")]
    return [n for n in names if n not in ("self", "*") and not n.startswith("arg")]


def test_names_and_parameters():
    declared = stubs()
    public = {n for n in vars(_edgeproof) if not n.startswith("__")}
    assert public == set(declared)
    for name, node in declared.items():
        if isinstance(node, dict):
            members = {n for n in vars(getattr(_edgeproof, name)) if n not in GIVEN}
            assert members == set(node) - GIVEN, name
            for member, stub in node.items():
                actual = inspect.getattr_static(getattr(_edgeproof, name), member, None)
                if isinstance(actual, property):
                    assert any(getattr(d, "id", "") == "property" for d in stub.decorator_list), member
                elif not member.startswith("_") and callable(getattr(_edgeproof, name).__dict__.get(
                        member)) and "(self" in (actual.__doc__ or ""):
                    assert parameters_in(stub) == parameters_of(actual), member
        else:
            assert parameters_in(node) == parameters_of(getattr(_edgeproof, name)), name


def test_typed():
    assert (PACKAGE / "py.typed").exists()


def test_every_name_has_help():
    undocumented = []
    for name in edgeproof.__all__:
        thing = getattr(edgeproof, name)
        if name in ("Number", "__version__"):
            continue
        if not (thing.__doc__ or "").strip():
            undocumented.append(name)
        if inspect.isclass(thing):
            for member, value in vars(thing).items():
                if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                    text = (getattr(thing, member).__doc__ if callable(value) else value.__doc__) or ""
                    if not text.strip():
                        undocumented.append(f"{name}.{member}")
    assert undocumented == []
    assert set(edgeproof.__all__) == {n for n in vars(edgeproof) if not n.startswith("_") and
                                      not inspect.ismodule(getattr(edgeproof, n))} | {"__version__"}
    # The documentation names units and exceptions.
    assert "unit of the contact modulus" in edgeproof.Scene.pressure.__doc__
    assert "InputError" in edgeproof.Scene.__doc__ and "BudgetError" in edgeproof.Scene.__doc__


@pytest.mark.slow
def test_the_types_check(tmp_path):
    if shutil.which("mypy", path="/usr/bin") is None:
        pytest.skip("mypy is not installed")
    (tmp_path / "use.py").write_text(
        "import edgeproof\n"
        "scene = edgeproof.Scene(edgeproof.hertz(R='100'), a=1, contact_modulus=1)\n"
        "v: edgeproof.Value = scene.pressure('0.1')\n"
        "w: list[edgeproof.Value] = scene.pressure(['0.1', 0.2])\n"
        "f: float = float(v)\n"
        "s: str = v.text\n")
    done = subprocess.run(["/usr/bin/mypy", "--strict", "--ignore-missing-imports", "--no-warn-unused-ignores",
                           "--python-executable", sys.executable, "--cache-dir", str(tmp_path / "c"),
                           str(PACKAGE), str(tmp_path / "use.py")], stdout=subprocess.PIPE,
                          text=True, cwd=PACKAGE.parent)
    assert done.returncode == 0, done.stdout
