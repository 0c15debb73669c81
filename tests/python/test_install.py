# SPDX-License-Identifier: GPL-3.0-or-later
"""The command of README and docs/python.md installs into ~/.local, where Python finds the
package."""
import os
import subprocess
import sys

import pytest

import edgeproof


def installed(prefix, home):
    build = os.environ.get("EDGEPROOF_BUILD")
    if not build:
        pytest.skip("no build folder: run by ctest")
    environment = {"HOME": str(home), "PATH": "/usr/bin:/bin"}
    subprocess.run(["cmake", "--install", build, "--prefix", prefix, "--component", "python"],
                   check=True, stdout=subprocess.DEVNULL, env=environment)
    return environment


def test_without_environment_variables(tmp_path):
    environment = installed(tmp_path / ".local", tmp_path)
    done = subprocess.run(
        [sys.executable, "-c",
         "import edgeproof as e; print(e.__file__); "
         "print(e.Scene(e.hertz(R=1), a=1, contact_modulus=1).pressure('0.2', digits=5))"],
        cwd=tmp_path, env=environment, stdout=subprocess.PIPE, text=True, check=True)
    where, p = done.stdout.split()
    assert where.startswith(str(tmp_path / ".local" / "lib"))
    assert p == "0.30000"


def test_elsewhere_by_pythonpath(tmp_path):
    environment = installed(tmp_path / "there", tmp_path)
    folder = tmp_path / "there" / "lib" / "python3" / "dist-packages"
    done = subprocess.run([sys.executable, "-c", "import edgeproof; print(edgeproof.__version__)"],
                          cwd=tmp_path, env={**environment, "PYTHONPATH": str(folder)},
                          stdout=subprocess.PIPE, text=True, check=True)
    assert done.stdout.strip() == edgeproof.__version__
    assert (folder / "edgeproof" / "py.typed").exists()
    assert (folder / "edgeproof" / "_edgeproof.pyi").exists()
