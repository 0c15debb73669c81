# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares partial slip with Cattaneo's and Mindlin's solution (Johnson, Contact Mechanics, 7.2)
and with closed forms of the paper's power laws."""
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
            assert mpmath.almosteq(slip.size.mpmath(), 1 - c, 1e-48)
            assert mpmath.almosteq(slip.stick.a.mpmath(), c, 1e-48)
            assert mpmath.almosteq(slip.stick.b.mpmath(), c, 1e-48)
            assert mpmath.almosteq(slip.stick.load_ratio.mpmath(), load_ratio(), 1e-48)
            # 1 - sqrt(1 - t) = t/2 + t^2/8 + ...
            series = [load_ratio() / 2, load_ratio() / 2 + load_ratio()**2 / 8]
            for mine, theirs in zip(slip.terms, series):
                assert mpmath.almosteq(mine.size.mpmath(), theirs, 1e-48)
                assert mpmath.almosteq(mine.relative_error.mpmath(), abs(1 - theirs / (1 - c)),
                                       1e-17)
                assert mine.load_limit is None
            assert [t.terms for t in slip.terms] == [1, 2]


def test_how_far_one_term_is_right(slipping):
    """d_1/d - 1 = -d/(2a), which is 1 % at d = a/50."""
    term, = slipping.slip(terms=1, tolerance="1%").terms
    assert term.leaves and term.load_limit.proved
    with mpmath.workdps(60):
        assert mpmath.almosteq(term.load_limit.mpmath(), 1 - (1 - mpmath.mpf(2) / 100)**2, 1e-48)
    with pytest.raises(edgeproof.InputError, match="tolerance"):
        slipping.slip(tolerance=0)


def test_a_bulk_tension_moves_the_stick_zone():
    """The corrective pressure is Hertz's, moved by -sigma_0 R/(2 f E*) (Hills and Nowell)."""
    scene = edgeproof.Scene(edgeproof.hertz(R=1), a=1, contact_modulus=1, Q="0.3", friction="0.6",
                            bulk_tension="0.05")
    stick = scene.slip(digits=40).stick
    with mpmath.workdps(60):
        tau = mpmath.mpf("0.3") / (mpmath.mpf("0.6") * mpmath.pi / 4)
        c, moved = mpmath.sqrt(1 - tau), mpmath.mpf("0.05") / 2 / mpmath.mpf("0.6")
        assert mpmath.almosteq(stick.a.mpmath(), c - moved, 1e-38)
        assert mpmath.almosteq(stick.b.mpmath(), c + moved, 1e-38)
        most = 4 * mpmath.mpf("0.6") / 2 * (1 - c)
        assert mpmath.almosteq(stick.most_bulk_tension.mpmath(), most, 1e-38)
        assert mpmath.almosteq(stick.least_bulk_tension.mpmath(), -most, 1e-38)
    assert stick.in_proportion is True


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
