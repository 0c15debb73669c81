# SPDX-License-Identifier: BSD-3-Clause
"""The commands of README and docs/guide/python.md install the package where Python finds it, and a
package without its compiled module states what to run."""
import base64
import csv
import hashlib
import importlib.util
import io
import os
import pathlib
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import zipfile

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


def backend(source):
    spec = importlib.util.spec_from_file_location(
        "edgeproof_backend", source / "python" / "backend" / "edgeproof_backend.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def settings():
    build = os.environ.get("EDGEPROOF_BUILD")
    if not build:
        pytest.skip("no build folder: run by ctest")
    return {"build-dir": build}


USE = """import edgeproof as e
print(e.__file__)
print(e.Scene(e.hertz(R=1), a=1, contact_modulus=1).pressure('0.2', digits=5))
print(e.verify('moore-hills', only='EQ18', digits=20)['EQ18'].verdict)
"""


def test_a_wheel(source, tmp_path):
    """The wheel has the files that its list states, with their hashes (PEP 427), and works."""
    name = backend(source).build_wheel(str(tmp_path), settings())
    version = f"cp3{sys.version_info[1]}"
    assert name == (f"edgeproof-{edgeproof.__version__}-{version}-{version}-"
                    f"{sysconfig.get_platform().replace('-', '_').replace('.', '_')}.whl")
    with zipfile.ZipFile(tmp_path / name) as wheel:
        info = f"edgeproof-{edgeproof.__version__}.dist-info"
        listed = {row[0]: row[1:] for row in csv.reader(
            io.StringIO(wheel.read(f"{info}/RECORD").decode()))}
        assert set(listed) == set(wheel.namelist()) and len(listed) > 50
        for file, (digest, size) in listed.items():
            if file != f"{info}/RECORD":
                content = wheel.read(file)
                wanted = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).decode()
                assert digest == "sha256=" + wanted.rstrip("=") and int(size) == len(content)
        metadata = wheel.read(f"{info}/METADATA").decode()
        assert f"Name: edgeproof\nVersion: {edgeproof.__version__}\n" in metadata
        wheel.extractall(tmp_path / "here")
    # pip moves the data next to the package's folder.
    shutil.move(tmp_path / "here" / f"edgeproof-{edgeproof.__version__}.data" / "data" / "share",
                tmp_path / "here" / "share")
    done = subprocess.run([sys.executable, "-c", USE], cwd=tmp_path, text=True, check=True,
                          env={"PYTHONPATH": str(tmp_path / "here"), "PATH": "/usr/bin:/bin"},
                          stdout=subprocess.PIPE)
    where, p, verdict = done.stdout.split()
    assert where.startswith(str(tmp_path)) and (p, verdict) == ("0.30000", "refuted")


def test_an_archive_of_the_sources(source, tmp_path):
    name = backend(source).build_sdist(str(tmp_path))
    with tarfile.open(tmp_path / name) as archive:
        names = archive.getnames()
    top = f"edgeproof-{edgeproof.__version__}"
    assert {f"{top}/PKG-INFO", f"{top}/pyproject.toml", f"{top}/CMakeLists.txt",
            f"{top}/src/edgeproof/python/value.cpp",
            f"{top}/python/edgeproof/__init__.py"} <= set(names)
    assert not [n for n in names if n.startswith((f"{top}/build/", f"{top}/out/")) or
                ".git/" in n or "__pycache__" in n]


def test_the_version_is_that_of_the_program(source):
    assert backend(source)._version() == edgeproof.__version__


@pytest.mark.slow
def test_pip_without_a_network(source, tmp_path):
    try:
        subprocess.run([sys.executable, "-m", "venv", "--system-site-packages",  # numpy is there
                        str(tmp_path / "venv")], check=True,
                       capture_output=True)
    except subprocess.CalledProcessError:
        pytest.skip("python3-venv is not installed")
    python = tmp_path / "venv" / "bin" / "python"
    # A proxy that does not exist: every connection would fail.
    environment = {"HOME": str(tmp_path), "PATH": "/usr/bin:/bin", "https_proxy": "http://0.0.0.0:1",
                   "http_proxy": "http://0.0.0.0:1", "PIP_DISABLE_PIP_VERSION_CHECK": "1"}
    subprocess.run([str(python), "-m", "pip", "install", "--retries", "0", str(source),
                    "--config-settings", "build-dir=" + settings()["build-dir"]],
                   check=True, env=environment, cwd=tmp_path)
    done = subprocess.run([str(python), "-c", USE], cwd=tmp_path, text=True, check=True,
                          env=environment, stdout=subprocess.PIPE)
    where, p, verdict = done.stdout.split()
    assert where.startswith(str(tmp_path / "venv")) and (p, verdict) == ("0.30000", "refuted")


@pytest.mark.parametrize("module, stated", [
    (None, "is not built; run scripts/build release edgeproof_python_package, or pip install ."),
    ("_edgeproof.cpython-399-x86_64-linux-gnu.so",
     "is for Python 3.99, and this is Python 3.{0} ({1}); run python3.99 (Debian's is "
     "/usr/bin/python3), or build it for this Python: {1} -m pip install ."),
    ("_edgeproof" + sysconfig.get_config_var("EXT_SUFFIX"), "cannot be loaded: "),
])
def test_a_package_without_its_module_states_what_to_run(source, tmp_path, module, stated):
    shutil.copytree(source / "python" / "edgeproof", tmp_path / "edgeproof")
    if module:
        (tmp_path / "edgeproof" / module).write_text("no library")
    done = subprocess.run([sys.executable, "-c", "import edgeproof"], cwd=tmp_path, text=True,
                          env={"PATH": "/usr/bin:/bin"}, stderr=subprocess.PIPE)
    last = done.stderr.splitlines()[-1]
    assert done.returncode == 1 and last.startswith("ImportError: the compiled module of edgeproof")
    assert stated.format(sys.version_info[1], sys.executable) in last


def test_the_explanation_is_read_by_old_pythons(source):
    """Its syntax is that of Python 3.6 (feature_version), and it imports nothing newer."""
    import ast

    text = (source / "python" / "edgeproof" / "_missing.py").read_text(encoding="utf-8")
    tree = ast.parse(text, feature_version=(3, 6))
    imported = {alias.name for node in ast.walk(tree) if isinstance(node, ast.Import)
                for alias in node.names}
    assert imported == {"glob", "os", "sys"}
    assert not [node for node in ast.walk(tree) if isinstance(node, ast.JoinedStr)]


def test_the_tree_states_what_to_run_if_only_the_program_is_built(source, tmp_path):
    """The link that scripts/build makes in the tree leads to the sources of the package then."""
    script = (source / "scripts" / "build").read_text(encoding="utf-8")
    start = script.index("# In this folder `import edgeproof`")
    (tmp_path / "python").mkdir()
    shutil.copytree(source / "python" / "edgeproof", tmp_path / "python" / "edgeproof")
    subprocess.run(["bash", "-c", "preset=release\n" + script[start:]], cwd=tmp_path, check=True)
    assert os.readlink(tmp_path / "edgeproof") == "python/edgeproof"
    built = tmp_path / "build" / "release" / "python" / "edgeproof"
    built.mkdir(parents=True)
    pathlib.Path(built / "__init__.py").touch()
    subprocess.run(["bash", "-c", "preset=release\n" + script[start:]], cwd=tmp_path, check=True)
    assert os.readlink(tmp_path / "edgeproof") == "build/release/python/edgeproof"
