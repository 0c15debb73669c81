# SPDX-License-Identifier: GPL-3.0-or-later
import pickle

import pytest

import edgeproof


def test_base_classes():
    assert issubclass(edgeproof.InputError, ValueError)
    assert issubclass(edgeproof.DomainError, ValueError)
    assert issubclass(edgeproof.UndecidedError, ArithmeticError)
    for kind in (edgeproof.InputError, edgeproof.DomainError, edgeproof.BudgetError,
                 edgeproof.UndecidedError):
        assert issubclass(kind, edgeproof.Error)


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


def test_no_file(tmp_path):
    with pytest.raises(edgeproof.InputError, match="nothing.toml"):
        edgeproof.read_scene(tmp_path / "nothing.toml")
    with pytest.raises(edgeproof.InputError):
        edgeproof.verify(tmp_path / "nothing.toml")
    with pytest.raises(edgeproof.InputError):
        edgeproof.check(tmp_path / "nothing.csv")


@pytest.mark.parametrize("given, problem", [
    (dict(a=1), "no contact_modulus"),
    (dict(contact_modulus=1), "neither a nor P"),
    (dict(a=1, P=1, contact_modulus=1), "both a and P"),
    (dict(a=0, contact_modulus=1), "a = 0 is not positive"),
    (dict(a="one", contact_modulus=1), "one"),
    (dict(a="1\n[ask]", contact_modulus=1), "control character"),
    (dict(a=1, contact_modulus=1, Q=0), "no load"),
    (dict(a=1, contact_modulus=1, Q=1, path="later"), "unknown path"),
    (dict(P=1, M=1, contact_modulus=1), "no tilt"),
])
def test_malformed_scenes(given, problem):
    with pytest.raises(edgeproof.InputError, match=problem) as raised:
        edgeproof.Scene(edgeproof.hertz(R=1), **given)
    assert raised.value.file is None and raised.value.line is None
    assert "\n" not in str(raised.value)


def test_malformed_questions(hertz):
    for ask in (lambda: hertz.pressure("0"), lambda: hertz.pressure("-1"),
                lambda: hertz.pressure("2"), lambda: hertz.pressure("3"),
                lambda: hertz.pressure("0.1", edge="top"), lambda: hertz.pressure("0.1", digits=1),
                lambda: hertz.pressure("0.1", digits=10**6), lambda: hertz.coefficients(0),
                lambda: hertz.coefficients(401), lambda: hertz.extent(tolerance="0%"),
                lambda: hertz.extent(part=(1, 0)), lambda: hertz.extent(process_zone=-1),
                lambda: edgeproof.Scene(edgeproof.hertz(R=0), a=1, contact_modulus=1)):
        with pytest.raises(edgeproof.InputError) as raised:
            ask()
        assert raised.value.advice and "\n" not in str(raised.value)


def test_a_corner_has_no_pressure():
    wedge = edgeproof.Scene(edgeproof.wedge("0.1"), a=1, contact_modulus=1)
    with pytest.raises(edgeproof.Error, match="infinite at a corner"):
        wedge.pressure(1)


def test_wrong_types(hertz):
    with pytest.raises(TypeError):
        edgeproof.Scene("hertz", a=1, contact_modulus=1)
    with pytest.raises(TypeError):
        hertz.pressure(None)
    with pytest.raises(TypeError):
        hertz.pressure("0.1", digits="many")
