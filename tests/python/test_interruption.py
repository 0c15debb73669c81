# SPDX-License-Identifier: GPL-3.0-or-later
"""Ctrl-C: in a process of its own, which is sent SIGINT once it says that it is at work."""
import os
import signal
import subprocess
import sys
import time

import pytest

import edgeproof

ALONE = """
import edgeproof
scene = edgeproof.Scene(edgeproof.PROFILE, a=1, contact_modulus=1)
print("ready", flush=True)
try:
    scene.WORK
    print("finished")
except KeyboardInterrupt:
    print("interrupted")
# And the next work is not stopped by the same signal.
print(scene.pressure("0.5", digits=5).text, flush=True)
"""

SINH = 'piecewise([], ["sinh(x)"], symmetric=True)'

SWALLOWED = """
import edgeproof, signal
seen = []
signal.signal(signal.SIGINT, lambda number, frame: seen.append(number))
scene = edgeproof.Scene(edgeproof.piecewise([], ["sinh(x)"], symmetric=True), a=1, contact_modulus=1)
print("ready", flush=True)
values = scene.pressure([f"{k}/500" for k in range(1, 300)], digits=100)
print([int(n) for n in seen], len(values), flush=True)
"""

RAISED = """
import edgeproof
def stop(done, total):
    raise RuntimeError("enough")
try:
    edgeproof.verify(LEDGER, digits=20, progress=stop)
except RuntimeError as error:
    print(error, flush=True)
"""


def run(code, after=0.3):
    child = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True,
                             stderr=subprocess.PIPE, preexec_fn=lambda: signal.signal(
                                 signal.SIGINT, signal.default_int_handler))
    try:
        assert child.stdout.readline() == "ready\n", child.stderr.read()
        time.sleep(after)
        begun = time.monotonic()
        os.kill(child.pid, signal.SIGINT)
        out, err = child.communicate(timeout=120)
        return out, err, time.monotonic() - begun
    finally:
        child.kill()


@pytest.mark.parametrize("profile, work", [
    (SINH, "coefficients(60, digits=3000)"),  # rules of integration, and integrals
    (SINH, "pressure([f'{k}/10000' for k in range(1, 9000)], digits=100)"),
    (SINH, "extent(tolerance='1e-9', digits=1500)"),
    ("hertz(1)", "pressures([0.1] * 30_000_000)"),
])
def test_ctrl_c_ends_a_computation(profile, work):
    out, err, seconds = run(ALONE.replace("PROFILE", profile).replace("WORK", work))
    assert out.splitlines()[0] == "interrupted", err
    scene = edgeproof.Scene(eval("edgeproof." + profile), a=1, contact_modulus=1)
    assert out.splitlines()[1] == scene.pressure("0.5", digits=5).text
    assert seconds < 20  # and not after minutes, on a busy machine either


def test_a_handler_that_goes_on_goes_on():
    out, err, _ = run(SWALLOWED, after=0.05)
    assert out == "[2] 299\n", err


def test_what_progress_raises_ends_the_work(source):
    code = f"LEDGER = {str(source / 'verify/moore-hills.toml')!r}\n" + RAISED
    done = subprocess.run([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True,
                          timeout=300, check=True)
    assert done.stdout == "enough\n"


def test_the_handler_is_pythons_again(hertz):
    before = signal.getsignal(signal.SIGINT)
    hertz.pressure("0.1")
    assert signal.getsignal(signal.SIGINT) is before
    with pytest.raises(KeyboardInterrupt):
        signal.raise_signal(signal.SIGINT)
        time.sleep(1)
