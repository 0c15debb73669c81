# SPDX-License-Identifier: GPL-3.0-or-later
"""Partial slip; Cattaneo's and Mindlin's solution (Johnson, Contact Mechanics, 7.2)."""
import copy
import json
import pickle

import pytest

import edgeproof

mpmath = pytest.importorskip("mpmath")
Q, F, P = "0.2", "0.6", "pi/4"  # for E* = R = a = 1


@pytest.fixture(scope="module")
def slipping():
    return edgeproof.Scene(edgeproof.hertz(R=1), a=1, contact_modulus=1, Q=Q, friction=F)


def load_ratio():
    return mpmath.mpf(Q) / (mpmath.mpf(F) * mpmath.pi / 4)


def test_zones_of_hertz(slipping):
    assert slipping.has_friction and slipping.has_shear
    with mpmath.workdps(70):
        c = mpmath.sqrt(1 - load_ratio())
        for edge in ("right", "left"):
            slip = slipping.slip(edge, terms=[1, 2], digits=50)
            assert slip.edge == edge and slip.size.proved
            for found, by_hand in ((slip.size, 1 - c), (slip.stick.a, c), (slip.stick.b, c),
                                   (slip.stick.load_ratio, load_ratio()),
                                   (slip.terms[0].size, load_ratio() / 2)):
                assert mpmath.almosteq(found.mpmath(), by_hand, 1e-48)
            assert [(t.terms, t.load_limit) for t in slip.terms] == [(1, None), (2, None)]
            assert 0 < slip.terms[1].relative_error < slip.terms[0].relative_error


def test_a_bulk_tension_and_a_tolerance(slipping):
    scene = edgeproof.Scene(edgeproof.hertz(R=1), a=1, contact_modulus=1, Q="0.3", friction="0.6",
                            bulk_tension="0.05")
    stick = scene.slip(digits=40).stick
    assert stick.a < stick.b and stick.in_proportion is True
    assert stick.most_bulk_tension.text == stick.least_bulk_tension.text.lstrip("-")
    term, = slipping.slip(terms=1, tolerance="1%").terms
    assert term.leaves and term.load_limit.proved
    with pytest.raises(edgeproof.InputError, match="tolerance"):
        slipping.slip(tolerance=0)


def test_plain_objects(slipping, source):
    data = slipping.slip(terms=1, tolerance="1%", digits=10).to_dict()
    assert json.loads(json.dumps(data)) == data
    assert data["terms"][0]["terms"] == 1 and data["stick"]["in_proportion"] is True
    assert data["terms"][0]["load_limit"]["text"] == "0.03960000000"
    scene = edgeproof.read_scene(source / "examples/scenes/partial-slip.toml")
    result = scene.run()
    assert [s.edge for s in result.slips] == scene.asked["edges"]
    assert result.slips[0].size.text == scene.slip(scene.asked["edges"][0], terms=1).size.text
    assert {p.state for p in result.points if p.q is not None} <= {"slip", "stick"}
    assert edgeproof.Scene.from_text(slipping.text).slip(terms=1).size.text == \
        slipping.slip(terms=1).size.text


def test_copies(slipping):
    slip = slipping.slip(terms=1, digits=10)
    assert pickle.loads(pickle.dumps(slip)).to_dict() == slip.to_dict()
    assert copy.deepcopy(slip).to_dict() == slip.to_dict()
    assert pickle.loads(pickle.dumps(slipping)).slip(terms=1, digits=10).to_dict() == slip.to_dict()


def test_scenes_that_do_not_slip(hertz):
    for call in (hertz.slip, lambda: hertz.slip_state("0.1")):
        with pytest.raises(edgeproof.InputError, match="no friction"):
            call()
    full = edgeproof.Scene(edgeproof.hertz(R=1), a=1, contact_modulus=1, Q="0.1")
    assert full.has_shear and not full.has_friction
    with pytest.raises(edgeproof.InputError, match="no friction"):
        full.slip()
    with pytest.raises(edgeproof.InputError):  # |Q| > f P
        edgeproof.Scene(edgeproof.hertz(R=1), a=1, contact_modulus=1, Q=1, friction="0.6").slip()
    with pytest.raises(edgeproof.InputError, match="friction"):
        edgeproof.Scene(edgeproof.hertz(R=1), a=1, contact_modulus=1, Q=1, friction=-1)
