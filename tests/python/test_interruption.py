# SPDX-License-Identifier: BSD-3-Clause
"""Ctrl-C: tests in a separate process, which receives SIGINT when it reports that it is at work."""
import os
import pathlib
import signal
import subprocess
import sys
import time

import pytest

import edgeproof

ALONE = """
import edgeproof, numpy
scene = edgeproof.Scene(edgeproof.PROFILE, a=1, contact_modulus=1)
print("ready", flush=True)
try:
    WORK
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
scene = edgeproof.Scene(edgeproof.PROFILE, a=1, contact_modulus=1)
print("ready", flush=True)
values = scene.pressure([f"{k}/500" for k in range(1, PLACES)], digits=DIGITS)
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


def wait_for(condition):
    until = time.monotonic() + 60
    while not (found := condition()):
        assert time.monotonic() < until
        time.sleep(0.02)
    return found


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
    (SINH, "scene.coefficients(60, digits=3000)"),  # rules of integration, and integrals
    (SINH, "scene.pressure([f'{k}/10000' for k in range(1, 9000)], digits=100)"),
    (SINH, "scene.extent(tolerance='1e-9', digits=1500)"),
    ("hertz(1)", "scene.pressures(numpy.full(40_000_000, 0.1))"),
    # a single operation that takes minutes
    ('power_law(m="1/3", C=1)', "scene.pressure('0.1', digits=100_000)"),
    ("hertz(1)", "edgeproof.design(DESIGN, digits=1000, gap='1e-300')"),
    ("hertz(1)", "edgeproof.relations("
                 "['right.c3', 'right.c2', 'left.c2', 'left.c1', 'b1', 'b2', 'L'], 10)"),
])
def test_ctrl_c_ends_a_computation(profile, work, source):
    work = work.replace("DESIGN", repr(str(source / "examples/design/exponent.toml")))
    out, err, seconds = run(ALONE.replace("PROFILE", profile).replace("WORK", work))
    assert out.splitlines()[0] == "interrupted", err
    scene = edgeproof.Scene(eval("edgeproof." + profile), a=1, contact_modulus=1)
    assert out.splitlines()[1] == scene.pressure("0.5", digits=5).text
    assert seconds < 20  # not minutes, even on a busy machine


@pytest.mark.parametrize("profile, digits, places", [
    (SINH, 100, 299),
    ('power_law(m="1/3", C=1)', 6000, 3),  # in a process of its own
])
def test_a_handler_may_continue_the_computation(profile, digits, places):
    code = SWALLOWED.replace("DIGITS", str(digits)).replace("PLACES", str(places + 1))
    out, err, _ = run(code.replace("PROFILE", profile), after=0.05)
    assert out == f"[2] {places}\n", err


def test_no_process_continues_in_the_background(tmp_path):
    """The process that computes many digits ends with its parent, however the parent ends."""
    code = ALONE.replace("PROFILE", 'power_law(m="1/3", C=1)').replace(
        "WORK", "scene.pressure('0.1', digits=100_000)")
    for sent in (signal.SIGINT, signal.SIGKILL):
        child = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True,
                                 preexec_fn=lambda: signal.signal(signal.SIGINT,
                                                                  signal.default_int_handler))
        assert child.stdout.readline() == "ready\n"
        children = pathlib.Path(f"/proc/{child.pid}/task/{child.pid}/children")
        apart = wait_for(lambda: children.read_text().split())
        os.kill(child.pid, sent)
        child.communicate(timeout=120)
        wait_for(lambda: not pathlib.Path(f"/proc/{apart[0]}").exists())


@pytest.mark.parametrize("digits", [1000, 2000, 5000])
def test_integrals_of_many_digits_end_soon(digits):
    """The nodes of a rule are made in one operation, which takes many seconds at 5000 digits."""
    code = ALONE.replace("PROFILE", SINH).replace("WORK", f"scene.pressure('0.5', digits={digits})")
    out, err, seconds = run(code, after=1)
    assert out.splitlines()[0] in ("interrupted", "finished"), err
    assert seconds < 2.5


@pytest.mark.parametrize("asked", [
    "['right.c9', 'left.c9'], degree=3",
    "['P2', 'P1'], given={'P2': '((m+1)*P1/a+b)^40*((P1+a+b)^30-(P1-a)^30)'}, free=['m'], degree=12",
])
def test_relations_end_soon(asked):
    """One expansion of a formula takes minutes."""
    code = ALONE.replace("PROFILE", SINH).replace("WORK", f"edgeproof.relations({asked})")
    out, err, seconds = run(code, after=1)
    assert out.splitlines()[0] == "interrupted", err
    assert seconds < 4  # 2, and a margin for a busy machine


def test_an_exception_of_progress_ends_the_work(source):
    code = f"LEDGER = {str(source / 'verify/moore-hills.toml')!r}\n" + RAISED
    done = subprocess.run([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True,
                          timeout=300, check=True)
    assert done.stdout == "enough\n"


def test_the_signal_handler_is_restored(hertz):
    before = signal.getsignal(signal.SIGINT)
    hertz.pressure("0.1")
    assert signal.getsignal(signal.SIGINT) is before
    with pytest.raises(KeyboardInterrupt):
        signal.raise_signal(signal.SIGINT)
        time.sleep(1)
