# SPDX-License-Identifier: GPL-3.0-or-later
import math
import sys

import pytest

import edgeproof

RECIPE = """
title = "A cylinder"
digits = 20
[scenes.hertz]
edges = ["right"]
u = ["1e-3", "0.1", "1/2", "0.9"]
quantities = ["P", "p"]
[scenes.hertz.profile]
kind = "power-law"
m = "1"
C = ["1", "1/3"]
[scenes.hertz.load]
a = "1"
contact_modulus = "1"
"""


@pytest.fixture
def recipe(tmp_path):
    file = tmp_path / "hertz.toml"
    file.write_text(RECIPE)
    return file


def hertz(question):
    """Johnson, Contact Mechanics, 4.2."""
    C = float(question["C"])
    if question["quantity"] == "P":
        return math.pi * C / 4
    u = float(question["u"])
    return C / 2 * math.sqrt(u * (2 - u))


def test_questions(recipe):
    asked = edgeproof.questions(recipe)
    assert len(asked) == 10 and len({q["id"] for q in asked}) == 10
    assert asked[0]["kind"] == "power-law" and asked[0]["quantity"] == "P"
    from decimal import Decimal

    assert asked[1]["u"] == str(Decimal(1e-3))


def test_a_function_that_is_right(recipe):
    calls = []
    agreement = edgeproof.check(hertz, recipe=recipe, digits=14,
                                progress=lambda done, of: calls.append(of))
    assert agreement.passed and len(agreement) == 10 and agreement.failures == ()
    assert all(case.digits > 14 and case.state == "number" for case in agreement)
    assert agreement.faults == () and agreement.conventions == () and agreement.estimates == 0
    assert "pass: 10 answers" in str(agreement) and calls


def test_a_function_that_is_wrong(recipe):
    agreement = edgeproof.check(lambda q: 2 * hertz(q), recipe=recipe)
    assert not agreement.passed and len(agreement.failures) == 10
    assert {(c.relation) for c in agreement.conventions} == {"2 times ours"}
    assert agreement.to_dict()["conventions"][0]["relation"] == "2 times ours"


def test_answers_of_every_type(recipe):
    import numpy as np

    answers = iter([None, float("nan"), float("-inf"), "0.1", "many", np.float64(0.25), 3])
    agreement = edgeproof.check(lambda q: next(answers, 0), recipe=recipe)
    assert [c.state for c in agreement][:7] == ["missing", "nan", "infinite", "number", "garbage",
                                                "number", "number"]
    assert not agreement.passed
    with pytest.raises(TypeError):
        edgeproof.check(lambda q: [1], recipe=recipe)
    with pytest.raises(ZeroDivisionError):
        edgeproof.check(lambda q: 1 / 0, recipe=recipe)


def test_a_command_and_a_file(recipe, tmp_path):
    rows = "\n".join(f"{q['id']},{hertz(q)!r}" for q in edgeproof.questions(recipe))
    answers = tmp_path / "answers.csv"
    answers.write_text("id,value\n" + rows + "\n")
    assert edgeproof.check(answers, recipe=recipe, digits=14).passed
    command = f"{sys.executable} -c \"print(open('{answers}').read())\""
    assert edgeproof.check(recipe=recipe, command=command, digits=14).passed
    assert not edgeproof.check(recipe=recipe, command="false").passed


def test_malformed_arguments(recipe, tmp_path):
    for call in (lambda: edgeproof.check(), lambda: edgeproof.check(recipe=recipe),
                 lambda: edgeproof.check(hertz), lambda: edgeproof.check(command="true"),
                 lambda: edgeproof.check(hertz, recipe=recipe, digits=-1),
                 lambda: edgeproof.check(hertz, recipe=recipe, threads=-1),
                 lambda: edgeproof.check(hertz, recipe=tmp_path / "none.toml")):
        with pytest.raises(edgeproof.InputError):
            call()
