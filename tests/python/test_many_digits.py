# SPDX-License-Identifier: BSD-3-Clause
"""The separate process that computes values with more digits than Python's limit for integers; cases.txt has the values."""
import sys

import pytest

import edgeproof
from edgeproof import _apart

DIGITS = 6000


def test_errors_of_the_process_are_raised_unchanged(hertz, tmp_path):
    for u in ("-1", "3", "what"):
        with pytest.raises(edgeproof.InputError) as apart:
            hertz.pressure(u, digits=DIGITS)
        with pytest.raises(edgeproof.InputError) as here:
            hertz.pressure(u, digits=50)
        assert str(apart.value) == str(here.value)
    file = tmp_path / "slides.toml"
    file.write_text(edgeproof.Scene(edgeproof.hertz(R=1), a=1, contact_modulus=1, Q="0.9",
                                    friction="0.5").text)
    with pytest.raises(edgeproof.InputError) as raised:
        edgeproof.read_scene(file).slip(digits=DIGITS)
    assert raised.value.file == str(file) and raised.value.line is not None


def test_a_process_that_dies_is_an_error(hertz, monkeypatch):
    monkeypatch.setattr(_apart, "_CHILD", "import os; os._exit(9)")
    with pytest.raises(edgeproof.Error, match="ended with status 9"):
        hertz.pressure("0.1", digits=DIGITS)


def test_where_no_python_can_be_started(hertz, monkeypatch):
    monkeypatch.setattr(sys, "executable", "/opt/other/program")
    assert hertz.pressure("1/5", digits=DIGITS).text == "0.3" + "0" * (DIGITS - 1)
