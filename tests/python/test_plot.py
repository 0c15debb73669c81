# SPDX-License-Identifier: GPL-3.0-or-later
import pytest

import edgeproof

pytestmark = pytest.mark.slow


@pytest.fixture
def matplotlib():
    return pytest.importorskip("matplotlib", reason="python3-matplotlib is not installed")


def test_curves_are_the_values(matplotlib, tmp_path):
    scene = edgeproof.Scene(edgeproof.hertz(R=1), a=1, contact_modulus=1, title="Hertz")
    figure = scene.plot(terms=[1, 2], edge="left", file=tmp_path / "p.png")
    assert (tmp_path / "p.png").stat().st_size > 10_000
    whole, near = figure.axes
    import numpy as np

    x, p = whole.lines[0].get_data()
    assert np.allclose(p, np.sqrt(np.maximum(1 - x**2, 0)) / 2, rtol=1e-12, atol=1e-9)
    x, one = whole.lines[1].get_data()  # sqrt(2 u)/2 at the left edge
    assert np.allclose(one, np.sqrt(2 * (1 + x)) / 2, rtol=1e-9, atol=1e-7)
    u, p = near.lines[0].get_data()
    assert np.allclose(p, np.sqrt(u * (2 - u)) / 2, rtol=1e-12)
    assert "unit" in whole.get_xlabel() and "left edge" in near.get_xlabel()
    assert [t.get_text() for t in whole.get_legend().get_texts()] == ["p", "1 term", "2 terms"]


def test_every_profile_has_a_plot(matplotlib, source):
    for file in ("fig6a-tilted-wedge", "fig8a-tilted-flat-and-rounded", "fretting-pad"):
        scene = edgeproof.read_scene(source / f"examples/scenes/{file}.toml")
        assert len(scene.plot().axes) == 2
