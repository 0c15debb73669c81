# SPDX-License-Identifier: GPL-3.0-or-later
import threading
import time

import pytest

import edgeproof

np = pytest.importorskip("numpy")


@pytest.fixture(scope="module")
def scenes():
    one = dict(contact_modulus="7/3")
    return [
        edgeproof.Scene(edgeproof.hertz(R=3), a="1", **one),
        edgeproof.Scene(edgeproof.wedge("0.2"), a="1", **one),
        edgeproof.Scene(edgeproof.power_law("5/8", "2"), P="0.3", **one),
        edgeproof.Scene(edgeproof.flat_and_rounded("0.4", "1"), a="1", **one),
        edgeproof.Scene(edgeproof.tilted_flat_and_rounded("1", "1"), P="1/5", M="-1/50", **one),
        edgeproof.Scene(edgeproof.piecewise([], ["sinh(x)"], symmetric=True), a="1", **one),
    ]


def test_shapes_and_types(hertz):
    u = np.linspace(0.1, 1.9, 24)
    flat = hertz.pressures(u)
    assert flat.dtype == np.float64 and flat.shape == (24,)
    cube = u.reshape(2, 3, 4)
    assert np.array_equal(hertz.pressures(cube), flat.reshape(2, 3, 4))
    assert np.array_equal(hertz.pressures(u[::3]), flat[::3])
    assert np.array_equal(hertz.pressures(u[::-1]), flat[::-1])
    assert np.array_equal(hertz.pressures(cube.T), flat.reshape(2, 3, 4).T)
    assert np.array_equal(hertz.pressures(np.asfortranarray(cube)), flat.reshape(2, 3, 4))
    assert np.array_equal(hertz.pressures(u.astype(">f8")), flat)
    assert np.array_equal(hertz.pressures(list(u)), flat)
    assert hertz.pressures(np.float32([0.5])).tolist() == hertz.pressures([0.5]).tolist()
    assert hertz.pressures([1]).tolist() == [0.5]
    scalar = hertz.pressures(0.5)
    assert scalar.shape == () and float(scalar) == hertz.pressures([0.5])[0]
    for shape in ((0,), (0, 3), (3, 0)):
        assert hertz.pressures(np.empty(shape)).shape == shape
    read_only = u.copy()
    read_only.setflags(write=False)
    assert np.array_equal(hertz.pressures(read_only), flat)
    assert np.array_equal(u, np.linspace(0.1, 1.9, 24))  # u is not changed


def test_nan_is_refused_with_its_index(hertz):
    with pytest.raises(edgeproof.InputError, match=r"u\[3\] is not a number"):
        hertz.pressures([0.1, 0.2, 0.3, np.nan, np.nan])
    with pytest.raises(edgeproof.InputError, match=r"u\[1, 2\] is not a number"):
        hertz.pressures([[0.1, 0.2, 0.3], [0.1, 0.2, np.nan]])


def test_masked_elements_are_refused(hertz):
    masked = np.ma.masked_array([0.1, 0.2], [False, True])
    for work in (hertz.pressures, hertz.pressure):
        with pytest.raises(edgeproof.InputError, match="masked"):
            work(masked)
    with pytest.raises(edgeproof.InputError, match="masked"):
        hertz.pressure(np.ma.masked)
    whole = np.ma.masked_array([0.1, 0.2])
    assert (hertz.pressures(whole) == hertz.pressures([0.1, 0.2])).all()


def test_arrays_that_lose_digits_are_refused(hertz):
    for wrong in (["0.1"], [True], [1j], [None], [2**53 + 1], np.longdouble([1]) / 3):
        with pytest.raises(TypeError):
            hertz.pressures(wrong)
    with pytest.raises(edgeproof.InputError):
        hertz.pressures([0.1], edge="top")


def test_several_threads_use_one_scene(scenes):
    u = np.linspace(0.001, 0.4, 200)
    for scene in scenes:
        alone = scene.pressures(u)
        found = [None] * 4

        def work(i, scene=scene, found=found):
            found[i] = (scene.pressures(u), scene.pressure("0.1", digits=20 + 10 * i).text)

        threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
        for t in threads:
            t.start()
        for t in threads:
            t.join()
        for i, (p, text) in enumerate(found):
            assert np.array_equal(p, alone)
            assert text == scene.pressure("0.1", digits=20 + 10 * i).text


def test_the_gil_is_released():
    """Another thread continues to count during a call."""
    scene = edgeproof.Scene(edgeproof.piecewise([], ["sinh(x)"], symmetric=True), a=1,
                            contact_modulus=1)
    scene.pressures([0.1])
    done = threading.Event()
    counted = [0]
    most = [0]

    def work():
        # The calls become longer until the other thread has counted far enough during one of them:
        # on a busy machine it may have to wait for a processor.
        points = 20000
        deadline = time.monotonic() + 120
        while most[0] <= 10 and time.monotonic() < deadline:
            before = counted[0]
            scene.pressures(np.linspace(0.01, 0.9, points))
            most[0] = max(most[0], counted[0] - before)
            points = min(2 * points, 10**6)
        done.set()

    thread = threading.Thread(target=work)
    thread.start()
    while not done.is_set():
        counted[0] += 1
        done.wait(0.001)
    thread.join()
    # If the GIL were held, the loop would run at most a few times during a call.
    assert most[0] > 10
