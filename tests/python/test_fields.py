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


def q_of(x):
    """Cattaneo's and Mindlin's traction (johnson1985, 7.2)."""
    f, force = exact(FRICTION), mpmath.pi / 4
    c = mpmath.sqrt(1 - exact(Q) / (f * force))
    return f * (p_of(x) - (mpmath.sqrt(c * c - x * x) / 2 if abs(x) < c else 0))


def terms_of(n):
    """sqrt(u (2 - u))/2 as a series: c_0 ... c_{n-1}."""
    return mpmath.taylor(lambda u: mpmath.sqrt(2 - u) / 2, 0, n - 1)


def local(u, n):
    return mpmath.sqrt(u) * sum(c * u**k for k, c in enumerate(terms_of(n)))


def test_places_by_x(hertz, sticking, slipping):
    with mpmath.workdps(70):
        for x in ("3/10", "-0.7", "1e-20", Fraction(-1, 3), 0.1, 0):
            assert hertz.pressure(x=x).text == mpmath.nstr(p_of(exact(x)), 50, strip_zeros=False)
            full = exact(Q) / (mpmath.pi * mpmath.sqrt(1 - exact(x)**2))
            assert mpmath.almosteq(sticking.shear(x=x).mpmath(), full, 1e-48)
            assert mpmath.almosteq(slipping.shear(x=x).mpmath(), q_of(exact(x)), 1e-47)
        one = hertz.approximation(x="4/5", terms=2, edge="right")
        assert mpmath.almosteq(one.p_local[0].value.mpmath(), local(exact("1/5"), 2), 1e-48)
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


def test_arrays_by_x_are_correctly_rounded(hertz):
    """Decided by squares of exact numbers: p^2 = (1 - x^2)/4."""
    x = np.random.default_rng(2).uniform(-1, 1, 300)
    for place, p in zip(x.tolist(), hertz.pressures(x=x).tolist()):
        square = (1 - Fraction(place)**2) / 4
        low = (Fraction(np.nextafter(p, 0)) + Fraction(p)) / 2
        high = (Fraction(np.nextafter(p, 1)) + Fraction(p)) / 2
        assert low**2 <= square <= high**2
    assert hertz.pressures(x=[-2, -1, 1, np.inf, -np.inf]).tolist() == [0] * 5
    wedge = edgeproof.Scene(edgeproof.wedge("0.1"), a=1, contact_modulus=1)
    assert wedge.pressures(x=[0.0])[0] == np.inf and 0 < wedge.pressures(x=[1e-300])[0] < np.inf


def test_arrays_of_shear(sticking, slipping):
    x = np.concatenate([np.linspace(-0.99, 0.99, 23), [1e-30, 0.8, -0.6]])
    with mpmath.workdps(60):
        full = [float(exact(Q) / (mpmath.pi * mpmath.sqrt(1 - exact(v)**2))) for v in x.tolist()]
        partial = [float(q_of(exact(v))) for v in x.tolist()]
        by_u = [float(q_of(1 - exact(v))) for v in (1 - x).tolist()]
    assert sticking.shears(x=x).tolist() == full
    assert slipping.shears(x=x).tolist() == partial
    assert slipping.shears(1 - x).tolist() == by_u
    assert slipping.shears(x=[-1, 1, 3]).tolist() == [0, 0, 0]
    assert slipping.shears(x=x.reshape(2, 13)).shape == (2, 13)
    with pytest.raises(edgeproof.InputError):
        sticking.shears(x=[0.5, 1.0])  # infinite
    together = edgeproof.Scene(edgeproof.hertz(R=1), a=1, contact_modulus=1, Q=Q, path="together")
    with mpmath.workdps(60):  # q = (Q/P) p, P = pi/4
        assert together.shears(x=x).tolist() == [
            float(4 * exact(Q) / mpmath.pi * p_of(exact(v))) for v in x.tolist()]


@pytest.mark.parametrize("n", [1, 2, 5])
def test_arrays_of_sums_and_their_errors(hertz, n):
    u = np.concatenate([[1e-300, 1e-20, 1e-3], np.linspace(0.05, 1.95, 20)])
    with mpmath.workdps(60):
        sums = [float(local(exact(v), n)) for v in u.tolist()]
    with mpmath.workdps(2000):  # the error is near u^n
        errors = [float(abs(1 - local(v, n) / p_of(1 - v))) for v in map(exact, u[1:].tolist())]
    assert hertz.local_pressures(u, terms=n).tolist() == sums
    assert hertz.relative_errors(u[1:], terms=n, edge="left").tolist() == errors
    x = np.linspace(-0.9, 0.9, 7)
    with mpmath.workdps(60):
        assert hertz.local_pressures(x=x, terms=n, edge="left").tolist() == [
            float(local(1 + exact(v), n)) for v in x.tolist()]
    for place in (0.0, -1.0, 2.0, 3.0, np.inf):
        with pytest.raises(edgeproof.InputError):
            hertz.local_pressures([0.1, place], terms=n)
        with pytest.raises(edgeproof.InputError):
            hertz.relative_errors([place], terms=n)


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
    """Arrays against single values, which are proved to 30 digits."""
    scene = edgeproof.Scene(edgeproof.flat_and_rounded(t="0.4", R=1), a=1, contact_modulus=2,
                            nu="0.3", Q="1/10", friction="0.6")
    x, z = np.linspace(-1.5, 1.5, 7)[None, :], np.linspace(0, 2, 5)[:, None]
    for body in ("A", "B"):
        found = scene.stresses(x, z, body)
        assert set(found) == {"sxx", "szz", "sxz", "tau_max", "mises", "bound"}
        assert found["bound"].shape == (5, 7) and found["bound"].max() < 1e-12
        for i in range(5):
            for j in range(7):
                one = scene.stress(float(x[0, j]), float(z[i, 0]), body, digits=30)
                for name in ("sxx", "szz", "sxz", "tau_max", "mises"):
                    error = abs(exact(found[name][i, j]) - getattr(one, name).mpmath())
                    assert error <= found["bound"][i, j] + 1e-25
    assert "mises" not in edgeproof.Scene(edgeproof.hertz(R=1), a=1,
                                          contact_modulus=1).stresses([0, 1], [1, 1])
    with pytest.raises(edgeproof.InputError, match="negative"):
        scene.stresses(0.0, -1.0)
    with pytest.raises(edgeproof.InputError, match="no body"):
        scene.stresses(0.0, 1.0, "C")


def test_stresses_under_hertz():
    """On the axis: johnson1985, eq. 4.46 and 4.47, with p_0 = 1/2 and a = 1."""
    scene = edgeproof.Scene(edgeproof.hertz(R=1), a=1, contact_modulus=1, nu="0.3")
    depths = ["0", "1/10", "0.786", "3"]
    rows = scene.stress(x=0, z=depths, digits=30)
    with mpmath.workdps(50):
        for row, z in zip(rows, map(exact, depths)):
            root = mpmath.sqrt(1 + z * z)
            sxx, szz = -((1 + 2 * z * z) / root - 2 * z) / 2, -1 / root / 2
            syy = exact("0.3") * (sxx + szz)
            mises = mpmath.sqrt(((sxx - syy)**2 + (syy - szz)**2 + (szz - sxx)**2) / 2)
            for value, by_hand in ((row.sxx, sxx), (row.szz, szz), (row.sxz, 0),
                                   (row.mises, mises), (row.tau_max, (z - z * z / root) / 2),
                                   (row.syy, syy), (row.s1, max(sxx, syy)), (row.s3, szz),
                                   (row.s2, min(sxx, syy)), (row.tresca, max(sxx, syy) - szz)):
                low, high = value.interval()
                error = max(abs(exact(low) - by_hand), abs(exact(high) - by_hand))
                assert error < mpmath.mpf(10)**-28 and value.proved
            assert row.body == "A" and row.x == "0"
    assert [row.z for row in rows] == depths
    one = scene.stress(x="1/2", z="1/4")
    assert one.to_dict()["x"] == "1/2" and one.sxz.text == scene.stress(u="1/2", z="1/4").sxz.text
    assert scene.stress(u="1/2", z=0, edge="left").sxx.text == scene.stress("-1/2").sxx.text


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
    for refused in (lambda: curved.stress(0), lambda: curved.displacement(0)):
        with pytest.raises(edgeproof.InputError):
            refused()


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
    with mpmath.workdps(60):
        for i, u in enumerate((exact("1/10"), mpmath.pi / 16, mpmath.mpf(1))):
            p = p_of(1 - u)
            assert table["p"][i] == float(p) and table["u"][i] == float(u)
            error = abs(mpmath.mpf(table["p"][i]) - p)
            assert error <= table["p_bound"][i] <= 2 * error + mpmath.mpf(10)**-40
            assert table["local_2"][i] == float(local(u, 2))
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
    with mpmath.workdps(60):
        assert [coefficients[f"c_{k}"][0] for k in (0, 1)] == [float(c) for c in terms_of(2)]
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


def test_displacements_of_a_surface():
    """With a reference both bodies approach by the gap less the profile, x^2/2 for Hertz."""
    scene = edgeproof.Scene(edgeproof.hertz(R=1), a=1, contact_modulus=1, nu="0.3")
    with mpmath.workdps(40):
        for x in ("1/2", "2"):
            rows = [scene.displacement(x=x, reference="0", body=body, digits=25) for body in "AB"]
            gap = rows[0].gap.mpmath() if rows[0].gap is not None else 0
            total = rows[0].uz.mpmath() + rows[1].uz.mpmath()
            assert mpmath.almosteq(total, gap - exact(x) ** 2 / 2, 1e-22)
            assert rows[0].ux.text == rows[1].ux.text and rows[0].dissipation is None
    assert scene.displacement(x="1/2").uz is None
    with pytest.raises(edgeproof.InputError, match="Poisson"):
        edgeproof.Scene(edgeproof.hertz(R=1), a=1, contact_modulus=1).displacement(
            x="1/2", reference="0")
