# SPDX-License-Identifier: GPL-3.0-or-later
"""Places by x, arrays of every quantity, stresses, displacements, data frames."""
import copy
import pickle
from fractions import Fraction

import pytest

import edgeproof

mpmath = pytest.importorskip("mpmath")
np = pytest.importorskip("numpy")

Q, FRICTION = "1/10", "1/2"


@pytest.fixture(scope="module")
def sticking():
    return edgeproof.Scene(edgeproof.hertz(R=1), a=1, contact_modulus=1, Q=Q)


@pytest.fixture(scope="module")
def slipping():
    return edgeproof.Scene(edgeproof.hertz(R=1), a=1, contact_modulus=1, Q=Q, friction=FRICTION)


def exact(x):
    q = Fraction(x)
    return mpmath.mpf(q.numerator) / q.denominator


def p_of(x):
    """johnson1985, 4.2, with E* = R = a = 1."""
    return mpmath.sqrt(1 - x * x) / 2


def test_places_by_x(hertz, sticking, slipping):
    with mpmath.workdps(70):
        for x in ("3/10", "-0.7", "1e-20", Fraction(-1, 3), 0.1, 0):
            assert hertz.pressure(x=x).text == mpmath.nstr(p_of(exact(x)), 50, strip_zeros=False)
    for scene in (sticking, slipping):
        assert scene.shear(x="-0.7").text == scene.shear("0.3", edge="left").text
    one = hertz.approximation(x="4/5", terms=2, edge="right")
    assert one.p_local[0].value.text == hertz.approximation("1/5", terms=2).p_local[0].value.text
    assert hertz.pressure(x="a/2").interval() == hertz.pressure(x="1/2").interval()
    assert slipping.slip_state(x=["0.99", 0]) == ["slip", "stick"]
    assert slipping.slip_state("0.01") == "slip" and slipping.slip_state(1, "left") == "stick"
    assert hertz.pressure([]) == [] and slipping.slip_state([]) == []
    by_force = edgeproof.Scene(edgeproof.hertz(R=1), P="pi/4", contact_modulus=1)
    assert by_force.pressure(x="0.6").text == "0.4" + "0" * 49
    for wrong in (dict(), dict(u=1, x=0)):
        with pytest.raises(TypeError, match="one of the two"):
            hertz.pressure(**wrong)
    for outside in ("2", "-1.5"):
        assert hertz.pressure(x=outside).text == "0"
    with pytest.raises(edgeproof.InputError, match="x = "):
        hertz.pressure(x="c")


def test_the_form_of_the_places_is_that_of_the_values(hertz, slipping):
    u = np.array([[0.25, 0.5], [1.0, 1.75]])
    for scene, method in ((hertz, "pressure"), (slipping, "shear"), (slipping, "slip_state")):
        ask = getattr(scene, method)
        found = ask(u)
        assert isinstance(found, np.ndarray) and found.shape == (2, 2)
        assert str(found[1, 0]) == str(ask(1)) and \
            str(ask([0.25, 0.5])[1]) == str(found[0, 1])
        assert str(ask(x=np.array(0.5))) == str(ask(0.5))
        assert ask(np.empty((0, 3))).shape == (0, 3)
    assert (hertz.pressure(x=u[0]).astype(float) == hertz.pressures(x=u[0])).all()
    rows = hertz.approximation(u, terms=[1, 3])
    assert isinstance(rows, edgeproof.Rows) and len(rows) == 4 and len(rows[2].p_local) == 2


def test_arrays_of_shear(sticking, slipping):
    x = np.linspace(-0.8, 0.8, 6)
    for scene in (sticking, slipping):
        assert scene.shears(x=x).tolist() == [float(q) for q in scene.shear(x=list(x))]
        assert scene.shears(x=x.reshape(2, 3)).shape == (2, 3)
    assert slipping.shears([0.125], edge="left").tolist() == [float(slipping.shear(x=-0.875))]
    with pytest.raises(edgeproof.InputError):
        sticking.shears(x=[0.5, 1.0])  # infinite


def test_arrays_of_sums_and_their_errors(hertz):
    """p_1 = sqrt(u/2), p = sqrt(u (2 - u))/2: the error is u/4 at 2^-500."""
    assert hertz.local_pressures([0.5, 2e-100], terms=1).tolist() == [0.5, 1e-50]
    assert hertz.local_pressures(x=[-0.5], terms=1, edge="left").tolist() == [0.5]
    assert hertz.relative_errors([2.0**-500], terms=1, edge="left").tolist() == [2.0**-502]
    for place in (0.0, -1.0, 2.0, 3.0, np.inf):
        for work in (hertz.local_pressures, hertz.relative_errors):
            with pytest.raises(edgeproof.InputError):
                work([0.1, place], terms=2)


def test_arrays_without_a_form_in_double_words():
    """An exponent that is no multiple of 1/2, and a curved slope: compares with single values."""
    scenes = (edgeproof.Scene(edgeproof.power_law("5/8", "2"), P="0.3", contact_modulus=1, Q="0.1"),
              edgeproof.Scene(edgeproof.piecewise([], ["sinh(x)"], symmetric=True), a=1,
                              contact_modulus=1, Q="0.1"))
    for scene in scenes:
        u = np.array([1e-12, 0.01, 0.3])
        x = float(scene.a) - u
        points = scene.approximation(u, terms=2, digits=40)
        assert scene.local_pressures(u, 2).tolist() == [float(p.p_local[0].value) for p in points]
        for mine, point in zip(scene.relative_errors(u, 2).tolist(), points):
            low, high = point.p_local[0].relative_error.interval()
            assert low - high * Fraction(2)**-52 <= Fraction(mine) <= high * (1 + Fraction(2)**-52)
        assert scene.shears(u).tolist() == [float(q) for q in scene.shear(list(u), digits=40)]
        assert scene.pressures(x=x).tolist() == [float(p) for p in
                                                 scene.pressure(x=list(x), digits=40)]


def test_malformed_arrays(hertz, sticking):
    for call in (lambda v: hertz.pressures(x=v), sticking.shears, hertz.local_pressures,
                 lambda v: hertz.relative_errors(x=v)):
        with pytest.raises(edgeproof.InputError, match=r"[ux]\[1\] is not a number"):
            call([0.1, np.nan])
        for wrong in (["0.1"], [True], [2**53 + 1]):
            with pytest.raises(TypeError):
                call(wrong)
    with pytest.raises(edgeproof.InputError, match="there is no shear"):
        hertz.shears([0.1])
    with pytest.raises(edgeproof.InputError, match="terms = 0"):
        hertz.local_pressures([0.1], terms=0)
    with pytest.raises(edgeproof.InputError, match="edge"):
        hertz.local_pressures([0.1], edge="top")
    with pytest.raises(TypeError, match="one of the two"):
        hertz.pressures()


def test_the_greatest_pressure(hertz, curved):
    assert hertz.peak().text == "0.5" + "0" * 49 and hertz.peak(digits=10).digits == 10
    pad = edgeproof.Scene(edgeproof.flat_and_rounded(t="0.4", R="2"), a=1, contact_modulus=3)
    top = pad.peak(digits=20)
    assert all(v <= top for v in pad.pressure(x=["0.1", "0.3", "0.39", "0.41", "0.5"]))
    wedge = edgeproof.Scene(edgeproof.wedge("0.1"), a=1, contact_modulus=1)
    with pytest.raises(edgeproof.Error):
        wedge.peak()


def test_maps_of_stresses():
    scene = edgeproof.Scene(edgeproof.flat_and_rounded(t="0.4", R=1), a=1, contact_modulus=2,
                            nu="0.3", Q="1/10", friction="0.6")
    x, z = np.linspace(-1.5, 1.5, 7)[None, :], np.linspace(0, 2, 5)[:, None]
    for body in ("A", "B"):
        found = scene.stresses(x, z, body)
        assert set(found) == {"sxx", "szz", "sxz", "tau_max", "mises", "bound"}
        assert found["bound"].shape == (5, 7) and found["bound"].max() < 1e-12
        one = scene.stress(float(x[0, 2]), float(z[3, 0]), body, digits=30)
        for name in ("sxx", "szz", "sxz", "tau_max", "mises"):
            assert abs(exact(found[name][3, 2]) - getattr(one, name).mpmath()) < 1e-12
    assert "mises" not in edgeproof.Scene(edgeproof.hertz(R=1), a=1,
                                          contact_modulus=1).stresses([0, 1], [1, 1])
    with pytest.raises(edgeproof.InputError, match="negative"):
        scene.stresses(0.0, -1.0)
    with pytest.raises(edgeproof.InputError, match="no body"):
        scene.stresses(0.0, 1.0, "C")


def test_stresses_under_hertz():
    """On the axis of symmetry, nu = 0.3: sxz = 0, syy = 0.3 (sxx + szz)."""
    scene = edgeproof.Scene(edgeproof.hertz(R=1), a=1, contact_modulus=1, nu="0.3")
    rows = scene.stress(x=0, z=["1/10", "3"], digits=30)
    for row in rows:
        components = sorted(map(float, (row.sxx, row.szz, row.syy)), reverse=True)
        assert row.sxz == 0 and float(row.syy) == pytest.approx(0.3 * float(row.sxx + row.szz))
        assert [float(v) for v in (row.s1, row.s2, row.s3)] == pytest.approx(components)
        assert float(row.tresca) == pytest.approx(components[0] - components[2])
        assert row.body == "A" and row.x == "0" and row.mises.proved
    assert [row.z for row in rows] == ["1/10", "3"]
    one = scene.stress(x="1/2", z="1/4")
    assert one.to_dict()["x"] == "1/2" and one.sxz.text == scene.stress(u="1/2", z="1/4").sxz.text
    assert scene.stress(u="1/2", z=0, edge="left").sxx.text == scene.stress("-1/2").sxx.text
    assert scene.stress("a/2", "a/4").sxz.text == scene.stress(u="a/2", z="1/4").sxz.text == one.sxz.text
    with pytest.raises(edgeproof.InputError, match='x = "foo": unknown name'):
        scene.stress("foo", 1)


def test_stresses_of_both_bodies_and_their_places(sticking):
    scene = edgeproof.Scene(edgeproof.hertz(R=1), a=1, contact_modulus=1, Q=Q, bulk_A="0.2",
                            bulk_tension="0.1")
    q = scene.shear(x="0.3")
    on_A, on_B = (scene.stress(x="0.3", z=0, body=body) for body in "AB")
    assert float(on_A.sxz) == -float(q) == -float(on_B.sxz) and on_A.mises is None
    # Far away only the bulk stresses remain: 0.2, and 0.3 in B.
    assert abs(scene.stress(x=0, z="1e6").sxx - Fraction(1, 5)) < 1e-5
    assert abs(scene.stress(x=0, z="1e6", body="B").sxx - Fraction(3, 10)) < 1e-5
    grid = scene.stress(x=np.linspace(-0.5, 0.5, 3), z=np.array([0.1, 0.2, 0.3]), digits=10)
    assert len(grid) == 3 and grid[2].sxx.text == scene.stress(0.5, 0.3, digits=10).sxx.text
    assert scene.stress(x=[], z=[]) == ()
    for wrong in (dict(x=0, z=-1), dict(x=0, z=0, body="C"), dict(x=[0, 1], z=[1, 2, 3]),
                  dict(x=1, z=0), dict(u="0.1", edge="top")):
        with pytest.raises(edgeproof.InputError):
            scene.stress(**wrong)
    by_force = edgeproof.Scene(edgeproof.hertz(R=1), P="0.3", contact_modulus=1)
    with pytest.raises(edgeproof.InputError, match="give the places by x"):
        by_force.stress(u="0.1")
    curved = edgeproof.Scene(edgeproof.piecewise([], ["sinh(x)"], symmetric=True), a=1,
                             contact_modulus=1)
    assert float(curved.stress(0).szz) == -float(curved.pressure(x=0))
    with pytest.raises(edgeproof.InputError):
        curved.displacement(0)


def test_arrays_of_a_sphere_are_not_those_of_the_plane_contact_with_the_same_pressure():
    # On the axis szz = -p_0/(1 + z^2/a^2) (johnson1985, eq. 3.45b), p_0 = 2/pi.
    ball = edgeproof.Scene(edgeproof.sphere(R=1), a=1, contact_modulus=1, nu="0.3")
    found = ball.stresses(np.zeros(3), np.array([0.25, 0.5, 2.0]))
    exact = -2 / np.pi / (1 + np.array([0.25, 0.5, 2.0])**2)
    assert np.abs(found["szz"] - exact).max() < 1e-15


def test_displacements(hertz, slipping):
    """The gap of Hertz's contact: g' = x less the integral of p gives h' = sqrt(x^2 - 1)."""
    rows = hertz.displacement(x=["3/2", 2, "-3/2"], digits=30)
    with mpmath.workdps(50):
        for row in rows:
            x = abs(exact(row.x))
            gap = (x * mpmath.sqrt(x * x - 1) - mpmath.acosh(x)) / 2
            assert mpmath.almosteq(row.gap.mpmath(), gap, 1e-28) and row.slip is None
    inside = slipping.displacement(x=["0", "0.95"])
    assert inside[0].gap is None and inside[0].slip == 0
    assert inside[1].slip.text == slipping.displacement(u="0.05").slip.text
    assert hertz.displacement(u="-1/2").gap.text == hertz.displacement(x="3/2").gap.text
    by_force = edgeproof.Scene(edgeproof.hertz(R=1), P="pi/4", contact_modulus=1)
    one = by_force.displacement(u="-1/2", edge="left", digits=20)
    assert one.gap.text == hertz.displacement("3/2", digits=20).gap.text
    low, high = one.x.interval()
    assert low <= Fraction(-3, 2) <= high and high - low < 1e-40
    assert hertz.displacement([]) == ()


def test_scene_files_with_stresses(source):
    scene = edgeproof.read_scene(source / "examples/scenes/stress.toml")
    result = scene.run()
    assert len(result.stresses) == 4 and len(result.displacements) == 3 and result.slips == ()
    for row in result.stresses:
        assert row.mises is not None and row.sxx.text == scene.stress(row.x, row.z).sxx.text
    assert [d.gap is None for d in result.displacements] == [True, True, False]
    for other in (pickle.loads(pickle.dumps(result)), copy.deepcopy(result)):
        assert other.to_dict() == result.to_dict() and type(other.stresses) is edgeproof.Rows


def test_columns_for_data_frames(hertz, slipping, source):
    rows = slipping.approximation(["1/10", "pi/16", 1], terms=[1, 2])
    table = rows.columns()
    assert list(table)[:5] == ["edge", "u", "x", "p", "p_bound"]
    assert {"local_1", "rel_1", "local_2", "rel_2"} <= set(table) and len(table["p"]) == 3
    for i, row in enumerate(rows):
        assert (table["p"][i], table["u"][i]) == (float(row.p), (0.1, float(np.pi / 16), 1.0)[i])
        assert 0 < table["p_bound"][i] < 1e-16 or table["p"][i] == 0.5
        assert table["local_2"][i] == float(row.p_local[1].value)
    result = edgeproof.read_scene(source / "examples/scenes/stress.toml").run()
    stresses = result.columns("stresses")
    assert stresses["sxx"].dtype == float and stresses["body"].tolist() == ["A"] * 4
    gaps = result.columns("displacements")["gap"]
    assert np.isnan(gaps[:2]).all() and gaps[2] == float(result.displacements[2].gap)
    pad = edgeproof.read_scene(source / "examples/scenes/fretting-pad.toml").run()
    assert pad.columns()["p"].tolist() == [float(point.p) for point in pad.points]
    assert pad.columns("extents")["first_exit"][0] == float(pad.extents[0].first_exit)
    own = edgeproof.Scene.from_text(hertz.text + "[ask]\nterms = 2\nquantities = [\"coefficients\"]\n")
    coefficients = own.run().columns("coefficients")
    assert coefficients["c_0"][0] == float(np.sqrt(2) / 2)  # sqrt(2 - u)/2
    assert 0 <= coefficients["c_1_bound"][0] < 1e-16
    zones = edgeproof.read_scene(source / "examples/scenes/partial-slip.toml").run()
    assert zones.columns("slips")["size"][0] == float(zones.slips[0].size)
    with pytest.raises(edgeproof.InputError, match="no rows 'rows'"):
        pad.columns("rows")
    assert edgeproof.Rows().columns() == {}


def test_repr_shows_the_scene(hertz, slipping, source):
    assert repr(hertz) == "<edgeproof.Scene hertz R=1; a=1 contact_modulus=1>"
    assert repr(slipping) == ("<edgeproof.Scene hertz R=1; a=1 contact_modulus=1; "
                              "Q=1/10 friction=1/2>")
    own = edgeproof.Scene(edgeproof.piecewise(["1/2"], ["x", "2*x"], symmetric=True), a=1,
                          contact_modulus=1, title="own")
    assert repr(own) == ("<edgeproof.Scene 'own': piecewise knots=[1/2] slopes=[x, 2*x] "
                         "symmetric=true; a=1 contact_modulus=1>")
    for file in sorted((source / "examples/scenes").glob("*.toml")):
        text = repr(edgeproof.read_scene(file))
        assert "\n" not in text and ("contact_modulus=" in text or "E1=" in text)


def test_displacements_of_a_surface(hertz):
    """With a reference at the middle, the surfaces move apart by the gap less x^2/2."""
    scene = edgeproof.Scene(edgeproof.hertz(R=1), a=1, contact_modulus=1, nu="0.3")
    on_A, on_B = (scene.displacement(x="2", reference="0", body=b, digits=25) for b in "AB")
    assert float(on_A.uz + on_B.uz) == pytest.approx(float(on_A.gap) - 2)
    assert on_A.ux.text == on_B.ux.text and on_A.dissipation is None
    assert scene.displacement(x="1/2").uz is None
    with pytest.raises(edgeproof.InputError, match="Poisson"):
        hertz.displacement(x="1/2", reference="0")


