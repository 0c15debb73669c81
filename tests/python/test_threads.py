# SPDX-License-Identifier: BSD-3-Clause
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


POWER_LAW = """title = "own"
[profile]
kind = "power-law"
m = { from = "1", to = "2" }
C = "1"
[load]
a = "1"
contact_modulus = "1"
"""


def test_other_threads_run_meanwhile():
    ran = threading.Event()

    def wait(done, of):
        # The GIL is held only during this call, so that the other thread can run.
        assert ran.wait(60)

    threading.Timer(0.1, ran.set).start()
    edgeproof.design(text=POWER_LAW, maximise="first_exit", tolerance="2%", digits=5, gap="0.1",
                     progress=wait)
    assert ran.is_set()
