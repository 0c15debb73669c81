# SPDX-License-Identifier: GPL-3.0-or-later
import copy
import json
import math
import pickle

import pytest

import edgeproof

np = pytest.importorskip("numpy")


def nodes(count, stretch=1.0):
    """Hertz's pressure at nodes with a step of 2.4/count, the middle one at 0."""
    x = np.linspace(-1.2, 1.2, count + 1)
    return x, stretch * np.sqrt(np.maximum(1 - x * x, 0)) / 2


def test_right_data(hertz):
    calls = []
    c = edgeproof.compare(hertz, nodes(240), progress=lambda done, of: calls.append((done, of)))
    assert c.passed and len(c) == 1 and calls[-1] == (1, 1)
    r = c[0]
    assert r.passed and r.nodes == 241 and r.inside + r.outside == 241
    assert r.inside == int((np.abs(nodes(240)[0]) < 1).sum())
    assert r.errors.peak < 1e-12 and r.errors.digits > 10 and r.causes == () and r.failures == ()
    assert r.sign == 1 and r.origin == 0 and r.p_max.data == r.p_max.exact == 0.5
    # P = pi/4; p^2 is a parabola, so that the rule for edges is exact except for rounding
    assert r.P.exact == math.pi / 4 and abs(r.P.data - r.P.of_exact_pressure) < 1e-12
    assert abs(r.a.data - 1) < 1e-9 and r.a.exact == 1
    # p = (u/2)^(1/2) (1 - u/4 - ...): c_0 = 1/sqrt(2), c_1 = -c_0/4
    assert abs(r.c0.exact - math.sqrt(0.5)) < 1e-15 and abs(r.c0.data / r.c0.exact - 1) < 1e-3
    assert abs(r.c1_left.exact + math.sqrt(0.5) / 4) < 1e-15
    assert "pass: 1 file" in str(c) and list(c) == [r] and c.orders == {}


def test_wrong_data(hertz):
    c = edgeproof.compare(hertz, nodes(96, stretch=2.0), tolerance="5%")
    assert not c.passed and c[0].failures and abs(c[0].errors.local - 1) < 1e-12
    assert c[0].causes[0].name == "factor-2" and abs(c[0].causes[0].factor - 2) < 1e-12
    assert edgeproof.compare(hertz, nodes(96, stretch=2.0), tolerance=2).passed
    assert not edgeproof.compare(hertz, nodes(96, stretch=1.02), of="local", tolerance="1%").passed
    assert not edgeproof.compare(hertz, nodes(96, stretch=1.02), tolerance_P="1%").passed


def test_meshes_whose_order_is_known(hertz):
    """The largest pressure is (1 + h^2) p_0 on meshes of width h."""
    meshes = [nodes(n, 1 + (2.4 / n)**2) for n in (12, 24, 48, 96)]
    assert abs(edgeproof.compare(hertz, meshes).orders["p_max"] - 2) < 1e-9


def test_files_are_read_as_the_program_reads_them(source, tmp_path):
    folder = source / "examples/compare"
    results = [folder / "mesh-96.csv", folder / "young-for-contact-modulus.csv"]
    c = edgeproof.compare(folder / "cylinder.toml", results, tolerance="1%", edge_zone="2e")
    assert [r.passed for r in c] == [True, False] and c.units
    assert c[1].causes[0].name == "e-for-e-star"
    assert json.loads(json.dumps(c.to_dict()))["files"][1]["passes"] is False
    by_name = edgeproof.compare(edgeproof.read_scene(folder / "cylinder.toml"), str(results[0]),
                                columns={"x": 1, "p": 2}, origin=0, edge_zone=0.01)
    assert by_name[0].origin == 0


def test_scales_and_columns(hertz, tmp_path):
    file = tmp_path / "other.csv"
    x, p = nodes(100)  # none on an edge, where p depends on the rounding of x
    file.write_text("n,place,press\n" + "".join(
        f"{i},{1000 * float(a)!r},{-float(b) * 1e6!r}\n" for i, (a, b) in enumerate(zip(x, p))))
    c = edgeproof.compare(hertz, file, columns={"x": "place", "p": "press"},
                          scale={"x": "1e-3", "p": 1e-6})
    assert c.passed and c[0].sign == -1 and c[0].errors.peak < 1e-9


def test_malformed_arguments(hertz, tmp_path):
    bad = tmp_path / "bad.csv"
    bad.write_text("x,p\n0,1\n0.5,nan\n")
    with pytest.raises(edgeproof.InputError) as raised:
        edgeproof.compare(hertz, bad)
    assert raised.value.file == str(bad) and raised.value.line == 3
    x, p = nodes(24)
    for call in (lambda: edgeproof.compare(hertz, []), lambda: edgeproof.compare(hertz, (x, p[:-1])),
                 lambda: edgeproof.compare(hertz, (x, p * math.nan)),
                 lambda: edgeproof.compare(hertz, (x, p), of="peek"),
                 lambda: edgeproof.compare(hertz, (x, p), edge_zone="wide"),
                 lambda: edgeproof.compare(hertz, (x, p), tolerance=-1),
                 lambda: edgeproof.compare(hertz, (x, p), columns="p"),
                 lambda: edgeproof.compare(hertz, tmp_path / "none.csv"),
                 lambda: edgeproof.compare(tmp_path / "none.toml", (x, p))):
        with pytest.raises(edgeproof.InputError):
            call()
    for wrong in ([3], {"x": x, "p": p}, [x, p]):
        with pytest.raises(TypeError, match="give a file, or a tuple"):
            edgeproof.compare(hertz, wrong)


def test_copies(hertz):
    c = edgeproof.compare(hertz, nodes(24))
    for other in (pickle.loads(pickle.dumps(c)), copy.deepcopy(c)):
        assert other == c and other.to_dict() == c.to_dict() and str(other) == str(c)
