# SPDX-License-Identifier: GPL-3.0-or-later
import json
import threading
from fractions import Fraction

import pytest

import edgeproof

POWER_LAW = """title = "own"
[profile]
kind = "power-law"
m = { from = "1", to = "2" }
C = "1"
[load]
a = "1"
contact_modulus = "1"
"""
# For m = 1 ... 2 and a tolerance of 2 %, Hertz reaches farthest, with p_1/p = 1/sqrt(1 - u/2a).
HERTZ_REACH = 1 - 1 / Fraction(102, 100)**2


def test_the_best_exponent_is_where_an_extremum_touches(source):
    """tests/contact/design/design_test.cpp has the values of mpmath."""
    found = edgeproof.design(source / "examples/design/exponent.toml", digits=12)
    assert found.proved and found.missing == "" and not found.attained and found.terms == 1
    assert found.parameter == "m" and set(found.values) == {"m"} and "touches" in found.best
    assert found.printed["m"].exact == Fraction(5, 8) and found.gap == "0.000001"
    assert found.reach_shown_at["m"] < found.value and 0 < found.touches_at < found.reach
    short = 1 - found.reach_at_printed.fraction() / found.reach.fraction()
    assert abs(found.falls_short_by.fraction() - short) < Fraction(1, 10**10)


def test_a_scene_as_text_with_options():
    calls = []
    found = edgeproof.design(text=POWER_LAW, maximise="first_exit", tolerance="2%", edge="both",
                             gap="1/1000", digits=20,
                             progress=lambda done, of: calls.append((done, of)))
    low, high = found.reach.interval()
    assert low <= HERTZ_REACH <= high and high - low < Fraction(1, 10**20)
    assert found.value == 1 and found.proved and found.best == "an end of the range"
    assert found.touches_at is None and found.printed == {} and found.reach_at_printed is None
    assert calls and calls[-1][1] == 1000
    as_json = json.loads(json.dumps(found.to_dict()))
    assert Fraction(as_json["tolerance"]) == Fraction(found.tolerance) == Fraction(1, 50)
    assert as_json["proof"] == "yes"
    assert as_json["rows"] == [{"parameter": "m", "value": found.value.text,
                                "value_bound": found.value.bound, "reach": found.reach.text,
                                "reach_bound": found.reach.bound, "gap": "0.001"}]


def test_an_estimate_is_called_one():
    found = edgeproof.design(text=POWER_LAW, maximise="measure", tolerance="2%", digits=8)
    assert not found.proved and not found.reach.proved and "(estimate)" in repr(found.reach)
    assert found.gap is None and found.reach_shown_at == {} and "samples" in found.missing
    # The relative error of Hertz is increasing: the measure ends at the first exit.
    assert abs(found.reach.fraction() - HERTZ_REACH) < 1e-6


def test_arguments_override_the_scene():
    text = POWER_LAW + '[design]\nmaximise = "measure"\ntolerance = "50%"\nterms = 3\nedge = "left"\n'
    found = edgeproof.design(text=text, maximise="first_exit", tolerance="2%", terms=1, digits=10)
    assert found.terms == 1 and found.proved
    assert abs(found.reach.fraction() - HERTZ_REACH) < Fraction(1, 10**10)


def test_other_threads_run_meanwhile():
    ran = threading.Event()

    def wait(done, of):
        # The GIL is held only during this call, so that the other thread can run.
        assert ran.wait(60)

    threading.Timer(0.1, ran.set).start()
    edgeproof.design(text=POWER_LAW, maximise="first_exit", tolerance="2%", digits=5, gap="0.1",
                     progress=wait)
    assert ran.is_set()


@pytest.mark.parametrize("asked, problem", [
    ({}, r"there is no \[design\]"),
    ({"maximise": "first_exit"}, "there is no tolerance"),
    ({"maximise": "firstexit", "tolerance": "1%"}, "firstexit"),
    ({"maximise": "measure", "tolerance": "1%", "edge": "top"}, "no edge 'top'"),
    ({"maximise": "measure", "tolerance": 1}, "below 1"),
    ({"maximise": "measure", "tolerance": "1%", "terms": 13}, "terms = 13 is out of range"),
    ({"maximise": "measure", "tolerance": "1%", "gap": 0}, "gap = 0 is not positive"),
    ({"maximise": "measure", "tolerance": "1%", "digits": 1001}, "digits = 1001"),
    ({"maximise": "slip_load", "tolerance": "1%"}, "unknown objective"),
])
def test_malformed_questions(asked, problem):
    with pytest.raises(edgeproof.InputError, match=problem) as raised:
        edgeproof.design(text=POWER_LAW, **asked)
    assert raised.value.advice and "\n" not in str(raised.value)


def test_errors_have_a_place(tmp_path):
    text = POWER_LAW + '[design]\nmaximise = "first_exit"\ntolerance = "1%"\nedge = "top"\n'
    file = tmp_path / "own.toml"
    file.write_text(text)
    for asked, name in (({"file": file}, str(file)), ({"text": text}, "(text)")):
        with pytest.raises(edgeproof.InputError, match="no edge 'top'") as raised:
            edgeproof.design(**asked)
        error = raised.value
        assert (error.file, error.line) == (name, 12) and "right, left or both" in error.advice
    with pytest.raises(edgeproof.InputError, match="nothing.toml"):
        edgeproof.design(tmp_path / "nothing.toml")
    for neither in ({}, {"file": file, "text": text}):
        with pytest.raises(TypeError):
            edgeproof.design(**neither)
