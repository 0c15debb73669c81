#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The pack's drivers accept the example's answers, name the factor where its pressures are doubled, and refuse
a file that lacks a row.
Languages without a compiler are left out."""
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PACK = ROOT / "reference" / "pack"
# Language: its example, the text of its pressure, the same doubled, how to build, how to run.
LANGUAGES = {
    "Python": ("example.py", "return k * (u * (2", "return 2 * k * (u * (2", None, [sys.executable, "driver.py"]),
    "C": ("example.c", "*value = k * sqrt(c->u", "*value = 2 * k * sqrt(c->u",
          ["cc", "-O1", "-Wall", "-Wextra", "-Werror", "-o", "driver", "driver.c", "example.c", "-lm"], ["./driver"]),
    "C++": ("example.cpp", "return k * std::sqrt(c.u", "return 2 * k * std::sqrt(c.u",
            ["c++", "-O1", "-Wall", "-Wextra", "-Werror", "-std=c++17", "-o", "driver", "driver.cpp", "example.cpp"],
            ["./driver"]),
    "Fortran": ("example.f90", "value = k*sqrt(c%u", "value = 2*k*sqrt(c%u",
                ["gfortran", "-O1", "-Wall", "-o", "driver", "edgeproof_case.f90", "example.f90", "driver.f90"],
                ["./driver"]),
}


def run(folder, build, command):
    if build:
        subprocess.run(build, cwd=folder, check=True)
    done = subprocess.run([*command, "B", "cases.csv"], cwd=folder, stdout=subprocess.PIPE, text=True)
    causes = [line for line in done.stdout.splitlines() if line.startswith("likely cause")]
    return done.returncode, causes


failures = 0
for language, (example, right, doubled, build, command) in LANGUAGES.items():
    if build and shutil.which(build[0]) is None:
        print(f"{language}: left out, there is no {build[0]}")
        continue
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for file in PACK.iterdir():
            shutil.copy(file, folder / file.name)
        accepted = run(folder, build, command)
        text = (folder / example).read_text()
        assert right in text, example
        (folder / example).write_text(text.replace(right, doubled))
        status, causes = run(folder, build, command)
        lines = (folder / "cases.csv").read_text().splitlines(keepends=True)
        (folder / "cases.csv").write_text("".join(lines[:-1]))
        cut = run(folder, build, command)[0]
    good = (accepted == (0, []) and status == 1 and len(causes) == 1 and causes[0].endswith(": factor-2")
            and " p are 2" in causes[0] and cut == 2)
    print(f"{language}: {'named' if good else f'FAILS: {accepted}, {status}, {causes}, {cut}'}")
    failures += not good
sys.exit(1 if failures else 0)
