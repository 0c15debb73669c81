# SPDX-License-Identifier: BSD-3-Clause
"""Builds the Python package by cmake, for pip and other frontends (PEP 517).

Only Python's standard library is used, so that a build needs no package from the network. Settings
(pip install . --config-settings NAME=VALUE):

    build-dir  folder of the build (default: build/pip-cpython-311-..., one for each Python)
    jobs       processes of the compiler (default: all processors)
    define     further definitions for cmake, NAME=VALUE, separated by blanks
"""

from __future__ import annotations

import base64
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import tomllib
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
# The files that the module finds by name (python/edgeproof/_shipped.py), as cmake installs them.
DATA = {"verify": "verify", "reference": "reference", "examples": "examples",
        "share/edgeproof/schemas": "schemas"}
# The files of a release that a build does not need; a clone's .git and builds are never included.
NOT_IN_ARCHIVE = {".git", "build", "out", "edgeproof", "__pycache__"}


def _version() -> str:
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    found = re.search(r"project\(edgeproof VERSION ([0-9.]+)", text)
    assert found, "CMakeLists.txt states no version"
    return found.group(1)


def _project() -> dict:
    return tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def _metadata() -> str:
    project = _project()
    lines = ["Metadata-Version: 2.1", f"Name: {project['name']}", f"Version: {_version()}",
             f"Summary: {project['description']}", f"License: {project['license']['text']}",
             f"Requires-Python: {project['requires-python']}",
             "Description-Content-Type: text/markdown"]
    lines += [f"Requires-Dist: {package}" for package in project["dependencies"]]
    for extra, packages in project["optional-dependencies"].items():
        lines.append(f"Provides-Extra: {extra}")
        lines += [f'Requires-Dist: {package}; extra == "{extra}"' for package in packages]
    return "\n".join(lines) + "\n\n" + (ROOT / project["readme"]).read_text(encoding="utf-8")


def _tag() -> str:
    version = f"cp{sys.version_info[0]}{sys.version_info[1]}"
    return f"{version}-{version}-" + re.sub(r"[-.]", "_", sysconfig.get_platform())


def _run(*command: str) -> None:
    print("+", *command, flush=True)
    done = subprocess.run(command, cwd=ROOT)
    if done.returncode != 0:
        raise SystemExit(f"edgeproof: {command[0]} ended with status {done.returncode}; the lines "
                         "above state why (packages that are missing: scripts/setup)")


def _built(settings: dict) -> pathlib.Path:
    """Builds the module and returns the folder of the build."""
    for tool, package in (("cmake", "cmake"), ("ninja", "ninja-build")):
        if shutil.which(tool) is None:
            raise SystemExit(f"edgeproof: there is no {tool}; run scripts/setup, or install "
                             f"Debian's package {package} and the others of scripts/packages.txt")
    build = ROOT / (settings.get("build-dir") or
                    f"build/pip-{sysconfig.get_config_var('SOABI')}")
    defined = str(settings.get("define") or "").split()
    if not (build / "build.ninja").exists():
        # A virtual environment may be removed later; the Python with which it was made stays.
        python = getattr(sys, "_base_executable", None) or sys.executable
        defined = ["EDGEPROOF_PYTHON=ON", "EDGEPROOF_PYTHON_REQUIRED=ON",
                   f"EDGEPROOF_PYTHON_EXECUTABLE={python}", "EDGEPROOF_TESTS=OFF",
                   *defined]
    if defined:
        _run("cmake", "--preset", "release", "-B", str(build), *(f"-D{d}" for d in defined))
    _run("cmake", "--build", str(build), "--target", "edgeproof_python_package", "--parallel",
         str(settings.get("jobs") or os.cpu_count() or 1))
    return build


class _Wheel:
    """A wheel that is written file by file, with its list of hashes."""

    def __init__(self, file: pathlib.Path) -> None:
        self._zip = zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED)
        self._record: list[str] = []
        self._info = f"edgeproof-{_version()}.dist-info"

    def add(self, name: str, content: bytes, executable: bool = False) -> None:
        # A fixed time, so that the same build gives the same wheel.
        entry = zipfile.ZipInfo(name, (2026, 1, 1, 0, 0, 0))
        entry.external_attr = (0o100755 if executable else 0o100644) << 16
        entry.compress_type = zipfile.ZIP_DEFLATED
        self._zip.writestr(entry, content)
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).decode().rstrip("=")
        self._record.append(f"{name},sha256={digest},{len(content)}")

    def finish(self) -> None:
        self.add(f"{self._info}/METADATA", _metadata().encode())
        self.add(f"{self._info}/WHEEL", ("Wheel-Version: 1.0\nGenerator: edgeproof_backend\n"
                                         f"Root-Is-Purelib: false\nTag: {_tag()}\n").encode())
        self.add(f"{self._info}/LICENSE", (ROOT / "LICENSE").read_bytes())
        record = f"{self._info}/RECORD"
        self._zip.writestr(record, "\n".join([*self._record, f"{record},,"]) + "\n")
        self._zip.close()


def _files(folder: pathlib.Path) -> list[pathlib.Path]:
    return sorted(f for f in folder.rglob("*") if f.is_file() and "__pycache__" not in f.parts)


def build_wheel(wheel_directory: str, config_settings: dict | None = None,
                metadata_directory: str | None = None) -> str:
    build = _built(config_settings or {})
    name = f"edgeproof-{_version()}-{_tag()}.whl"
    with tempfile.TemporaryDirectory() as scratch:
        _run("cmake", "--install", str(build), "--component", "python", "--strip", "--prefix",
             scratch)
        package = next(pathlib.Path(scratch).rglob("edgeproof/__init__.py")).parent
        suffix = sysconfig.get_config_var("EXT_SUFFIX")
        if not (package / f"_edgeproof{suffix}").exists():
            raise SystemExit(f"edgeproof: {build} has no module for this Python; give another "
                             "build-dir, or remove that folder")
        wheel = _Wheel(pathlib.Path(wheel_directory) / name)
        for file in _files(package):
            wheel.add(f"edgeproof/{file.relative_to(package).as_posix()}", file.read_bytes())
    data = f"edgeproof-{_version()}.data/data/share/edgeproof"
    for source, folder in DATA.items():
        for file in _files(ROOT / source):
            wheel.add(f"{data}/{folder}/{file.relative_to(ROOT / source).as_posix()}",
                      file.read_bytes(), os.access(file, os.X_OK))
    wheel.finish()
    return name


def build_sdist(sdist_directory: str, config_settings: dict | None = None) -> str:
    name = f"edgeproof-{_version()}"
    with tempfile.TemporaryDirectory() as scratch:
        information = pathlib.Path(scratch) / "PKG-INFO"
        information.write_text(_metadata(), encoding="utf-8")
        with tarfile.open(pathlib.Path(sdist_directory) / f"{name}.tar.gz", "w:gz",
                          format=tarfile.PAX_FORMAT) as archive:
            archive.add(information, f"{name}/PKG-INFO")
            for path in sorted(ROOT.iterdir()):
                if path.name not in NOT_IN_ARCHIVE and not path.name.startswith("build-"):
                    archive.add(path, f"{name}/{path.name}", filter=lambda entry: None if
                                pathlib.PurePath(entry.name).name in NOT_IN_ARCHIVE - {"build",
                                "edgeproof", "out"} else entry)
    return f"{name}.tar.gz"
