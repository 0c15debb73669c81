# SPDX-License-Identifier: GPL-3.0-or-later
import copy
import csv
import pickle
from fractions import Fraction

import pytest

import edgeproof

mpmath = pytest.importorskip("mpmath")


@pytest.mark.parametrize("name", ["power-law", "tilted-wedge", "flat-and-rounded"])
def test_reference_tables(source, name):
    """Compares rows of the reference tables digit by digit."""
    with open(source / "reference" / f"{name}.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    rows = [r for r in rows if r["quantity"] == "p"]
    made = {}
    for row in rows[::7]:
        profile = {
            "power-law": lambda r: edgeproof.power_law(r["m"], r["C"]),
            "tilted-wedge": lambda r: edgeproof.tilted_wedge(r["phi"], r["alpha"] or None),
            "flat-and-rounded": lambda r: edgeproof.flat_and_rounded(r["t"], r["R"]),
        }[row["kind"]](row)
        load = {k: row.get(k) or None for k in ("a", "P", "M", "contact_modulus")}
        scene = made.setdefault((profile, str(load)), edgeproof.Scene(profile, **load))
        value = scene.pressure(row["u"], edge=row["edge"])
        assert (value.text, value.bound) == (row["value"], row["bound"]), row["id"]
        assert float(value) == float(row["binary64"]), row["id"]
    assert len(made) > 3


def test_every_load():
    E = dict(contact_modulus=1)
    by_force = edgeproof.Scene(edgeproof.hertz(R=2), P="pi/8", **E)
    assert by_force.a.text == "1." + "0" * 49  # P = pi E* a^2/(4 R)
    bodies = edgeproof.Scene(edgeproof.hertz(R=2), a=1, E1=4, nu1="1/2", E2=4, nu2="1/2")
    # 1/E* = 2 (1 - 1/4)/4, E* = 8/3; p = E*/(2R) sqrt(1 - x^2) at x = 4/5
    assert bodies.pressure("1/5").text == "0.4" + "0" * 49
    assert edgeproof.Scene(edgeproof.hertz(R=2), a=1, E=4, nu="1/2") == bodies
    for others in (dict(), dict(nu="1/2", E2=3), dict(nu="1/2", contact_modulus=1)):
        with pytest.raises(edgeproof.InputError, match="E is given"):
            edgeproof.Scene(edgeproof.hertz(R=2), a=1, E=4, **others)
    upright = edgeproof.Scene(edgeproof.tilted_wedge(phi="0.1"), P=1, M=0, **E)
    assert upright.alpha is not None and upright.alpha == 0
    tilted = edgeproof.Scene(edgeproof.tilted_wedge(phi="0.1"), P=1, M="0.5", **E)
    given = edgeproof.Scene(edgeproof.tilted_wedge(phi="0.1", alpha=tilted.alpha.text), a=tilted.a.text,
                            **E)
    with mpmath.workdps(50):
        assert mpmath.almosteq(given.M.mpmath(), 0.5, 1e-45)
        assert mpmath.almosteq(given.P.mpmath(), 1, 1e-45)
    assert given.alpha is None


def test_shear(hertz):
    # moore-hills: full stick, q = Q/(pi sqrt(a^2 - x^2)) for Q alone at constant P
    scene = edgeproof.Scene(edgeproof.hertz(R=1), a=1, contact_modulus=1, Q="1/10")
    q = scene.shear("1/5")
    with mpmath.workdps(60):
        assert mpmath.almosteq(q.mpmath(), mpmath.mpf(1) / 10 / (mpmath.pi * mpmath.mpf(3) / 5),
                               1e-48)
        s = scene.shear_coefficients(2)
        assert s.s_half_powers == -1
        assert mpmath.almosteq(s.s[0].mpmath(), 1 / (10 * mpmath.pi * mpmath.sqrt(2)), 1e-48)
    with pytest.raises(edgeproof.InputError, match="no .shear"):
        hertz.shear("0.1")
    with pytest.raises(edgeproof.InputError, match="no shear"):
        hertz.shear_coefficients()


def test_extent(hertz):
    """One term of Hertz: p/local = sqrt(1 - u/2); the error is 1 % where 1/sqrt(1 - u/2) = 1.01."""
    e = hertz.extent(terms=1, tolerance="1%")
    exact = 2 * (1 - 1 / Fraction(101, 100)**2)
    low, high = e.first_exit.interval()
    assert low <= exact <= high and high - low < Fraction(1, 10**50)
    assert e.first_exit.proved
    assert e.leaves and e.terms == 1 and e.edge == "right" and e.covers_zone is None
    low, high = e.first_exit_fraction.interval()
    assert low <= exact / 2 <= high
    assert hertz.extent(tolerance=Fraction(1, 100), process_zone="0.01").covers_zone is True
    assert hertz.extent(tolerance="0.01", part=(0, "1/1000")).leaves is False


def test_approximation(hertz):
    point = hertz.approximation("1/5", terms=[1, 2])
    assert point.p.text == "0.3" + "0" * 49 and [a.terms for a in point.p_local] == [1, 2]
    first = point.p_local[0]  # sqrt(2 u)/2 = 1/sqrt(10)
    assert float(first.value) == float(mpmath.sqrt(mpmath.mpf("0.1"))) and 0 < first.relative_error < 1


def test_scene_files(source):
    scene = edgeproof.read_scene(source / "examples/scenes/fretting-pad.toml")
    assert scene.title.startswith("Fretting pad") and scene.digits == 20 and scene.has_shear
    assert scene.file and scene.file.endswith("fretting-pad.toml") and scene.symmetric
    result = scene.run()
    assert [p.u for p in result.points] == ["0.001", "0.01", "0.1", "0.5"] * 2
    assert result.points[0].p == result.points[0].p
    assert result.points[0].p.text == scene.pressure("0.001").text
    assert len(result.points[0].p_local) == 2 and len(result.extents) == 4
    data = result.to_dict()
    assert data["points"][1]["p"]["text"] == result.points[1].p.text
    assert data["contact"]["P"]["text"] == "500.00000000000000000"
    import json

    assert json.loads(json.dumps(data)) == data
    # The text gives the same scene again.
    assert edgeproof.Scene.from_text(scene.text).pressure("0.01").text == scene.pressure("0.01").text


def test_made_and_read_scenes_agree(source):
    made = edgeproof.Scene(edgeproof.flat_and_rounded("0.4", "1"), a="1", contact_modulus="1")
    again = edgeproof.Scene.from_text(made.text)
    assert again == made and hash(again) == hash(made)
    for other in (pickle.loads(pickle.dumps(made)), copy.copy(made), copy.deepcopy(made)):
        assert other == made and other.pressure("0.1").text == made.pressure("0.1").text
    assert pickle.loads(pickle.dumps(edgeproof.hertz("pi"))) == edgeproof.hertz("pi")


def test_bodies_of_revolution():
    # Hertz: a^3 = 3 P R/(4 E*). Sneddon's cone: a^2 = 2 P/(pi E* phi).
    ball = edgeproof.Scene(edgeproof.sphere(R=10), P="4/10", contact_modulus=3)
    assert ball.a.text == "1." + "0" * 49
    cone = edgeproof.Scene(edgeproof.cone("2/pi"), P=3, contact_modulus=3)
    assert cone.a.text == "1." + "0" * 49
    contact = ball.contact()
    assert contact.delta is not None and contact.stiffness is not None and contact.M is None
    revolved = edgeproof.Scene(edgeproof.hertz(10).revolved(), P="4/10", contact_modulus=3)
    assert revolved.a.text == ball.a.text
    by_approach = edgeproof.Scene(edgeproof.sphere(10), delta="1/10", contact_modulus=3)
    assert by_approach.a.text == "1" + "." + 49 * "0"  # a^2 = R delta
    with pytest.raises(edgeproof.InputError, match="plane contact"):
        edgeproof.Scene(edgeproof.hertz(10), delta="1/10", contact_modulus=3)


def test_load_histories(source):
    read = edgeproof.read_scene(source / "examples" / "scenes" / "history.toml")
    steps = [{"P": 600}, {"Q": 200}, {"Q": "-100"}, {"P": 500}]
    pad = dict(profile=edgeproof.flat_and_rounded(2, 100), E="115e3", nu="0.32", friction="0.6")
    made = edgeproof.Scene(steps=steps, **pad)
    for x in ("-a/2", 0):
        assert made.shear(x=x, digits=12).text == read.shear(x=x).text
    reversed_once = edgeproof.Scene(steps=iter(steps[:2]), **pad)
    once = edgeproof.Scene(P=600, Q=200, **pad)
    assert reversed_once.shear(x="a/3").text == once.shear(x="a/3").text
    cycles = edgeproof.Scene(steps=[{"P": 600}, {"Q": 100, "cycles": 3}, {"Q": -100}], **pad)
    assert edgeproof.Scene.from_text(cycles.text) == cycles
    with pytest.raises(edgeproof.InputError, match="weight"):
        edgeproof.Scene(steps=[{"weight": 3}], **pad)


def test_profiles_do_not_change():
    profile = edgeproof.hertz(R=2)
    assert profile.kind == "hertz" and profile.parameters == {"R": "2"}
    with pytest.raises(AttributeError):
        profile.kind = "wedge"
