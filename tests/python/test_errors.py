# SPDX-License-Identifier: BSD-3-Clause
import inspect
import operator
import pathlib
import pickle
import subprocess
import sys

import pytest

import edgeproof

PACKAGES = str(pathlib.Path(edgeproof.__file__).resolve().parents[1])


def test_a_file_and_its_line(tmp_path):
    file = tmp_path / "scene.toml"
    file.write_text('[profile]\nkind = "power-law"\nm = "1"\nC = "1"\n[load]\na = "-1"\n'
                    'contact_modulus = "1"\n')
    with pytest.raises(edgeproof.InputError) as raised:
        edgeproof.read_scene(file)
    error = raised.value
    assert error.file == str(file) and error.line == 6
    assert error.problem == "a = -1 is not positive" and error.advice == "give a > 0"
    assert str(error) == f"{file}:6: a = -1 is not positive; give a > 0"
    again = pickle.loads(pickle.dumps(error))
    assert (type(again), str(again), again.line) == (type(error), str(error), 6)


# Calls that are right; each argument in turn gets another type.
HERTZ = edgeproof.hertz(R=1)
SCENE = edgeproof.Scene(HERTZ, a=1, contact_modulus=1, nu="0.3", Q="0.1", friction="0.5")
CALLS = [
    (edgeproof.hertz, dict(R=1)),
    (edgeproof.wedge, dict(phi=1)),
    (edgeproof.sphere, dict(R=1)),
    (edgeproof.cone, dict(phi=1)),
    (edgeproof.power_law, dict(m=1, C=1)),
    (edgeproof.flat_and_rounded, dict(t=1, R=1)),
    (edgeproof.tilted_wedge, dict(phi="0.1", alpha="0.01")),
    (edgeproof.tilted_flat_and_rounded, dict(t=1, R=1, alpha="0.01")),
    (edgeproof.piecewise, dict(knots=[1], slopes=["x", "x"], symmetric=True)),
    (edgeproof.Profile, dict(kind="hertz", parameters={"R": 1})),
    (edgeproof.Scene, dict(profile=HERTZ, a=1, contact_modulus=1, title="")),
    (edgeproof.Scene, dict(profile=HERTZ, P=1, E=1, nu="0.3", Q=0, bulk_tension=0, bulk_A=0,
                           friction=1, path="together")),
    (edgeproof.Scene, dict(profile=HERTZ, contact_modulus=1, friction=1,
                           steps=[{"P": 1}, {"Q": "0.1"}])),
    (edgeproof.Scene.from_text, dict(text=SCENE.text, file="")),
    (edgeproof.read_scene, dict(file="fretting-pad")),
    (edgeproof.verify, dict(ledger="nothing", digits=20, only="*", threads=1, progress=print)),
    (edgeproof.questions, dict(recipe="nothing")),
    (edgeproof.check, dict(answers="nothing", recipe="nothing", digits=12.0, ulps=1.0,
                           conditioned=True, timeout=1.0, threads=1, progress=print)),
    (edgeproof.compare, dict(scene=SCENE, results="nothing", columns="x=1,p=2", scale="x=1",
                             origin=0, tolerance="1%", of="peak", edge_zone=0, tolerance_a=1,
                             tolerance_P=1, tolerance_c0=1, partial=True, progress=print)),
    (edgeproof.design, dict(text="", maximise="measure", terms=1, tolerance="1%", edge="right",
                            gap="1e-6", digits=10, progress=print)),
    (edgeproof.relations, dict(quantities=["a"], degree=1, symmetric=True, given={"P1": "a"},
                               free=["m"])),
    (SCENE.contact, dict(digits=5)),
    (SCENE.pressure, dict(u="0.1", edge="right", digits=5)),
    (SCENE.pressure, dict(x="0.1")),
    (SCENE.shear, dict(u="0.1", edge="right", digits=5)),
    (SCENE.slip_state, dict(u="0.1", edge="right", digits=5)),
    (SCENE.approximation, dict(u="0.1", terms=1, edge="right", digits=5)),
    (SCENE.peak, dict(digits=5)),
    (SCENE.stress, dict(x=0, z="0.1", body="A", digits=5)),
    (SCENE.displacement, dict(x=2, digits=5, reference=3, body="A")),
    (SCENE.displacement, dict(u="0.1", edge="right", digits=5)),
    (SCENE.pressures, dict(u=[0.1], edge="right")),
    (SCENE.shears, dict(x=[0.1], edge="right")),
    (SCENE.stresses, dict(x=[0.1], z=[0.1], body="A")),
    (SCENE.local_pressures, dict(u=[0.1], terms=1, edge="right")),
    (SCENE.relative_errors, dict(u=[0.1], terms=1, edge="right")),
    (SCENE.coefficients, dict(terms=1, edge="right", digits=5)),
    (SCENE.shear_coefficients, dict(terms=1, edge="right", digits=5)),
    (SCENE.extent, dict(terms=1, tolerance="1%", edge="right", part=(0, 1), process_zone="0.1",
                        digits=5)),
    (SCENE.slip, dict(edge="right", terms=1, tolerance="1%", digits=5)),
    (SCENE.run, dict(digits=5)),
    (SCENE.greatest, dict(stress="tau_max", body="A", digits=5)),
    (SCENE.stress_coefficients, dict(angle=90, terms=1, edge="right", body="A", digits=5)),
    (SCENE.plot, dict(terms=1, edge="right", tolerance="1%")),
    (SCENE.plot, dict(field="sxx", body="A", ax=[])),
    (SCENE.run(5).columns, dict(of="points")),
    (SCENE.a.rounded, dict(digits=5)),
]


class Hostile:
    """Claims to be every kind of number, and fails as all of them."""

    shape = ()
    _mpf_ = None

    def __getattr__(self, name):
        raise RecursionError("maximum recursion depth exceeded")

    __index__ = __iter__ = __fspath__ = __float__ = lambda self: {}["no"]


class Deep:
    """An array of one number that is such an array again."""

    shape = ()
    item = None

    def __getitem__(self, index):
        return self


OTHERS = [object(), Hostile(), Deep(), [object()], [[1]], {1: 2}, {"a": object()}, b"1", 1j,
          "\ud800", 10**5000, float("nan"), True, print, edgeproof, None, (None, None), 1, "what",
          [Hostile()], SCENE]


@pytest.mark.parametrize("call, arguments", CALLS,
                         ids=[f"{c.__qualname__}-{i}" for i, (c, _) in enumerate(CALLS)])
def test_an_argument_of_another_type_is_an_error_in_one_sentence(call, arguments):
    for name in arguments:
        for other in OTHERS:
            try:
                call(**{**arguments, name: other})
            except ImportError:  # of numpy or matplotlib
                continue
            except (TypeError, ValueError, edgeproof.Error) as error:
                text = str(error)
                assert text and "\n" not in text, (name, other)
                assert "argument types" not in text and "C++" not in text, (name, other)
    for wrong in ({**arguments, "no_such": 1}, None):
        with pytest.raises((TypeError, edgeproof.Error)) as raised:
            call(*range(20)) if wrong is None else call(**wrong)
        assert "\n" not in str(raised.value)


def test_operators_with_another_type():
    for operation in (operator.add, operator.mul, operator.lt, operator.eq, format):
        for other in OTHERS:
            try:
                operation(SCENE.a, other)
            except (TypeError, ValueError, edgeproof.Error) as error:
                assert str(error) and "\n" not in str(error) and "C++" not in str(error)


def test_every_public_call_reads_its_arguments():
    """No function is missing in the table, and no argument is without a reader."""
    from edgeproof._arguments import READERS

    known = {getattr(call, "__func__", call) for call, _ in CALLS}
    functions = [f for f in vars(edgeproof).values() if inspect.isfunction(f)]
    functions += [f for name, f in vars(edgeproof.Scene).items()
                  if not name.startswith("_") and inspect.isfunction(f)]
    for function in functions:
        assert function in known, function
        for parameter in inspect.signature(function).parameters.values():
            kind = str(parameter.annotation).removesuffix(" | None")
            assert parameter.name == "self" or kind in READERS, (function, parameter)


def test_no_code_of_the_current_folder_is_run(tmp_path):
    """The second Python, and the package's late imports, find modules as `python -P` does."""
    for name in ("pickle", "html", "json", "dataclasses", "numpy", "mpmath", "decimal"):
        (tmp_path / f"{name}.py").write_text("print('run')\n")
    for where, change in ((tmp_path, ""), (tmp_path.parent, f"os.chdir({str(tmp_path)!r})")):
        code = (f"import os, sys\nsys.path[:] = [{PACKAGES!r}] + [p for p in sys.path if p]\n"
                f"import edgeproof\nsys.path.insert(0, '')\n{change}\n"
                "scene = edgeproof.Scene(edgeproof.hertz(R=1), a=1, contact_modulus=1)\n"
                "p = scene.pressure('0.1', digits=5001)\n"
                "p._repr_html_(), scene.pressure('0.1').decimal()\n"
                "for late in (lambda: scene.pressures([0.1]), scene.peak().mpmath):\n"
                "    try: late()\n"
                "    except ModuleNotFoundError: pass\n"
                "assert p.digits == 5001\n")
        done = subprocess.run([sys.executable, "-c", code], cwd=where, text=True, check=True,
                              stdout=subprocess.PIPE)
        assert done.stdout == ""
