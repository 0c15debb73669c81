# SPDX-License-Identifier: BSD-3-Clause
"""Ordinary readers of CSV read what the commands write."""
import csv
import io
import math
import os
import pathlib
import subprocess

import pytest

PROGRAM = pathlib.Path(os.environ.get("EDGEPROOF_BUILD", "build/release")) / "bin" / "edgeproof"
ASKED = ["pressure", "--hertz", "--R", "1", "--a", "1", "--contact-modulus", "1", "--u", "0.2",
         "0.4", "--terms", "1"]
# p = sqrt(u (2 - u))/2 (Johnson, Contact Mechanics, 4.2)
EXACT = [math.sqrt(u * (2 - u)) / 2 for u in (0.2, 0.4)]


def printed(*options):
    run = subprocess.run([PROGRAM, *ASKED, *options], capture_output=True, text=True, check=True)
    assert run.stderr == ""
    return run.stdout


def test_dict_reader():
    rows = list(csv.DictReader(io.StringIO(printed("--no-notes"))))
    assert [float(row["p"]) for row in rows] == pytest.approx(EXACT, rel=1e-15)
    # By default the notes are behind the rows, and their first cell begins with #.
    every = list(csv.DictReader(io.StringIO(printed())))
    assert every[:2] == rows
    assert len(every) > 2
    assert all(row["edge"].startswith("# ") for row in every[2:])


def test_numpy():
    numpy = pytest.importorskip("numpy")
    table = numpy.genfromtxt(io.StringIO(printed()), delimiter=",", names=True, dtype=None,
                             encoding=None)
    assert table.dtype.names == ("edge", "u", "x", "p", "p_bound", "route", "local_1", "rel_1")
    assert list(table["p"]) == pytest.approx(EXACT, rel=1e-15)


def test_pandas():
    pandas = pytest.importorskip("pandas")
    table = pandas.read_csv(io.StringIO(printed()), comment="#")
    assert list(table["p"]) == pytest.approx(EXACT, rel=1e-15)
