# SPDX-License-Identifier: BSD-3-Clause
import pytest

import edgeproof

pytestmark = pytest.mark.slow


@pytest.fixture
def matplotlib():
    return pytest.importorskip("matplotlib", reason="python3-matplotlib is not installed")


def curve(axes, label):
    return next(line for line in axes.lines if line.get_label() == label).get_data()


def test_curves_are_the_values(matplotlib, tmp_path):
    scene = edgeproof.Scene(edgeproof.hertz(R=1), a=1, contact_modulus=1, title="Hertz")
    figure = scene.plot(terms=[1, 2], edge="left", file=tmp_path / "p.png")
    assert (tmp_path / "p.png").stat().st_size > 10_000
    whole, near = figure.axes
    import numpy as np

    x, p = curve(whole, "p, exact")
    assert np.allclose(p, np.sqrt(np.maximum(1 - x**2, 0)) / 2, rtol=1e-12, atol=1e-9)
    x, one = curve(whole, "1 term, within 1 % up to u = 0.0394")  # sqrt(2 u)/2, up to the middle
    assert np.allclose(one, np.sqrt(2 * (1 + x)) / 2, rtol=1e-9, atol=1e-7)
    assert x.min() == -1 and -0.05 < x.max() <= 0
    # The error of the first term is 1/sqrt(1 - u/2) - 1: in percent, down to 2.5e-5.
    u, error = curve(near, "1 term, within 1 % up to u = 0.0394")
    assert np.allclose(error, 100 * np.expm1(-0.5 * np.log1p(-u / 2)), rtol=1e-9)
    assert min(u) < 1e-5 and max(u) < 2
    assert near.get_xlim() == pytest.approx((2e-6, 2))  # the contact is 2 wide
    # It is 1 % at u = 2 - 2/1.0201.
    u, error = near.lines[2].get_data()
    assert u[0] == pytest.approx(2 - 2 / 1.0201, rel=1e-12) and error[0] == 1
    assert "left edge" in near.get_title() and "[%]" in near.get_ylabel()
    names = [t.get_text() for t in whole.get_legend().get_texts()]
    assert names == ["p, exact", "1 term, within 1 % up to u = 0.0394",
                     "2 terms, within 1 % up to u = 0.492"]


def test_axes_have_the_units_of_the_scene(matplotlib, source):
    text = (source / "examples/scenes/fretting-pad.toml").read_text()
    units = '[units]\nlength = "mm"\npressure = "MPa"\n[profile]'
    whole, near = edgeproof.Scene.from_text(text.replace("[profile]", units)).plot().axes
    assert (whole.get_xlabel(), whole.get_ylabel()) == ("x [mm]", "p, q [MPa]")
    assert near.get_xlabel().endswith("u [mm]")


def test_axes_of_ones_own_tolerance_and_contours(matplotlib):
    from matplotlib.figure import Figure

    scene = edgeproof.Scene(edgeproof.hertz(R=1), a=1, contact_modulus=1, nu="0.3")
    axes = Figure().subplots()
    assert scene.plot(terms=1, tolerance="5%", ax=axes) is axes.figure
    assert curve(axes, "1 term, within 5 % up to u = 0.186") is not None
    stress, bar = scene.plot(field="mises").axes
    assert stress.get_ylim() == pytest.approx((2, 0), abs=0.01) and "mises" in bar.get_ylabel()
    drawn = float(stress.get_title().split("drawn: ")[1].split()[0])
    assert drawn == pytest.approx(float(scene.greatest("mises").value), rel=2e-3)


def test_every_profile_has_a_plot(matplotlib, source):
    for file in ("fig6a-tilted-wedge", "fig8a-tilted-flat-and-rounded", "fretting-pad"):
        scene = edgeproof.read_scene(source / f"examples/scenes/{file}.toml")
        assert len(scene.plot().axes) == 2
