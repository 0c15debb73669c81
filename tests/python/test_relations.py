# SPDX-License-Identifier: GPL-3.0-or-later
import json
import re
from fractions import Fraction

import pytest

import edgeproof


def vanishes(relation, values):
    """True if the polynomial is exactly zero at the values, which are given by name."""
    left, right = relation.relation.split(" = ")
    left = re.sub(r"[a-z][a-z0-9.]*", lambda name: f"values[{name[0]!r}]", left)
    assert right == "0" and "/" not in left  # a quotient of whole numbers would become a float
    return eval(left.replace("^", "**")) == 0


def test_relations_of_the_paper():
    """The relation L_{I,a} = b' L_{I,b} of Moore and Hills."""
    found = edgeproof.relations(["right.c0", "left.c0", "b1"], 2)
    assert len(found) == 1 and found.complete and found.degree == 2 and found[0].degree == 2
    (relation,) = found
    for b, left in ((Fraction(1, 3), Fraction(7, 5)), (Fraction(4, 5), Fraction(2, 3))):
        assert vanishes(relation, {"b1": b, "left.c0": left, "right.c0": b * left})
        assert not vanishes(relation, {"b1": b, "left.c0": left, "right.c0": left / b})
    assert edgeproof.relations("b1").relations == ()


def test_along_the_power_laws():
    """tests/audit/relations checks such relations; p ~ sqrt(1 - x^2) and its c_k/c_0 here."""
    found = edgeproof.relations(["right.c2", "right.c1", "right.c0", "a"], symmetric=True,
                                given={"P2": "m*P1/a", "P3": "m*(m-1)*P1/a^2"}, free=["m"])
    assert found.complete and len(found) == 1 and found.monomials == 70
    hertz = {"right.c0": Fraction(1), "right.c1": Fraction(-1, 4), "right.c2": Fraction(-1, 32),
             "a": Fraction(1)}
    assert vanishes(found[0], hertz) and not vanishes(found[0], {**hertz, "a": Fraction(2)})
    data = json.loads(json.dumps(found.to_dict()))
    assert data["contact"] == "symmetric" and data["complete"] == "yes"
    assert data["given"] == "P2=m*P1/a, P3=m*(m-1)*P1/a^2"
    assert data["rows"] == [{"degree": found[0].degree, "relation": found[0].relation}]


@pytest.mark.parametrize("quantities, asked, problem", [
    (["left.c0", "oops"], {}, "unknown name 'oops'"),
    ([], {}, "no quantity"),
    (["left.c0"], {"degree": 13}, "degree = 13"),
    (["left.c0"], {"degree": -1}, "degree = -1"),
    (["left.c0"], {"given": {"m": "a"}}, "there is no 'm'"),
    (["left.c0"], {"given": {"P2": "a*"}}, "given P2=a*"),
    (["sin(a)"], {}, "a function other than sqrt"),
])
def test_malformed_questions(quantities, asked, problem):
    with pytest.raises(edgeproof.InputError, match=problem) as raised:
        edgeproof.relations(quantities, **asked)
    assert raised.value.advice and "\n" not in str(raised.value)
    with pytest.raises(TypeError):
        edgeproof.relations(["left.c0"], degree=2.5)
