# SPDX-License-Identifier: BSD-3-Clause
"""The cases of cases.txt: statements, a line each, that are true of the package."""
import copy
import csv
import json
import math
import pathlib
import pickle
import re
from decimal import Decimal
from fractions import Fraction

import pytest
from edgeproof._numbers import exact_text

import edgeproof

mpmath = pytest.importorskip("mpmath")
np = pytest.importorskip("numpy")

TABLE = pathlib.Path(__file__).with_name("cases.txt").read_text()
CASES = dict(block.split("\n", 1) for block in re.split(r"^@ ", TABLE, flags=re.MULTILINE)[1:])


def real(x):
    """The number of a text or a Fraction, at the digits of mpmath."""
    q = Fraction(x)
    return mpmath.mpf(q.numerator) / q.denominator


def near(value, exact, error):
    """True if the value is within a relative error of a number."""
    return mpmath.almosteq(value.mpmath() if hasattr(value, "mpmath") else value, exact, error)


def encloses(value, exact, width=math.inf):
    low, high = value.interval()
    return low <= exact <= high and high - low < width


def copies(value):
    return [pickle.loads(pickle.dumps(value)), copy.copy(value), copy.deepcopy(value)]


def written(folder, name, text):
    (folder / name).write_text(text)
    return folder / name


def nodes(count, stretch=1.0):
    """Hertz's pressure at nodes with a step of 2.4/count, the middle one at 0."""
    x = np.linspace(-1.2, 1.2, count + 1)
    return x, stretch * np.sqrt(np.maximum(1 - x * x, 0)) / 2


def hertz_answer(question):
    """johnson1985, 4.2, in double."""
    C = float(question["C"])
    u = float(question.get("u", 0))
    return math.pi * C / 4 if question["quantity"] == "P" else C / 2 * math.sqrt(u * (2 - u))


def vanishes(relation, values):
    """True if the polynomial is exactly zero at the values, which are given by name."""
    left, right = relation.relation.split(" = ")
    left = re.sub(r"[a-z][a-z0-9.]*", lambda name: f"values[{name[0]!r}]", left)
    assert right == "0" and "/" not in left  # a quotient of whole numbers would become a float
    return eval(left.replace("^", "**"), {"values": values}) == 0


@pytest.mark.parametrize("title", CASES)
def test_case(title, hertz, curved, source, tmp_path):
    """A line is a definition, NAME = EXPRESSION, an expression that is true, or CALL -> ERROR: WORDS: the call raises this
    error, and WORDS, a regular expression, are found in it. Lines that begin with a blank continue the one before."""
    names = {**vars(edgeproof), **globals(), "hertz": hertz, "curved": curved, "source": source, "tmp": tmp_path,
             "hertz_profile": edgeproof.hertz, "calls": []}
    for line in re.sub(r"\n +", " ", CASES[title]).splitlines():
        if not line or line.startswith("#"):
            continue
        call, _, refusal = line.partition(" -> ")
        with mpmath.workdps(70):
            if refusal:
                kind, _, words = refusal.partition(": ")
                with pytest.raises(eval(kind, names)) as raised:
                    eval(call, names)
                assert re.search(words, str(raised.value)), (line, str(raised.value))
                assert "\n" not in str(raised.value), line
            elif re.match(r"[\w, ]+ = ", line):
                exec(line, names)
            else:
                assert eval(line, names), line
