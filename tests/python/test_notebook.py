# SPDX-License-Identifier: BSD-3-Clause
"""examples/python.ipynb, run again, prints its stored results."""
import json
import os
import pathlib
import shutil
import subprocess

import pytest

pytestmark = pytest.mark.slow


def printed(notebook):
    """The output of each cell, without pictures, whose bytes depend on the machine."""
    return [[("".join(o["text"]) if "text" in o else sorted(o.get("data", {})))
             for o in cell["outputs"] if o.get("name") != "stderr"]
            for cell in notebook["cells"] if cell["cell_type"] == "code"]


def test_the_notebook(source, tmp_path):
    program = shutil.which("jupyter-nbconvert", path="/usr/bin")
    if program is None or not pathlib.Path("/usr/share/jupyter/kernels/python3").exists():
        pytest.skip("jupyter-nbconvert or python3-ipykernel is not installed")
    pytest.importorskip("matplotlib", reason="python3-matplotlib is not installed")
    file = source / "examples" / "python.ipynb"
    done = subprocess.run(
        [program, "--to", "notebook", "--execute", "--output-dir", tmp_path, "--output", "run.ipynb",
         file], cwd=source / "examples", stderr=subprocess.PIPE, text=True,
        env={**os.environ, "PATH": "/usr/bin:/bin", "HOME": str(tmp_path)})
    assert done.returncode == 0, done.stderr
    kept = printed(json.loads(file.read_text(encoding="utf-8")))
    again = printed(json.loads((tmp_path / "run.ipynb").read_text(encoding="utf-8")))
    assert again == kept
    assert any("proved: True" in text for cell in kept for text in cell if isinstance(text, str))
