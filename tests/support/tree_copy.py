# SPDX-License-Identifier: BSD-3-Clause
"""A copy of the source tree with a build of its own, for tests that change the source."""
import fcntl
import os
import re
import signal
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent


def files_of(tree):
    """The files below tree, relative to it, without built files."""
    return {path.relative_to(tree) for top in tree.iterdir()
            if not re.fullmatch(r"\.git|build.*|out", top.name)
            for path in ([top] if top.is_file() else top.rglob("*")) if path.is_file()}


def synchronise(tree):
    """Makes tree a copy of the working tree. Files that are equal keep their time stamp, so that
    little is built again."""
    tree.mkdir(parents=True, exist_ok=True)
    wanted = files_of(ROOT)
    for name in files_of(tree) - wanted:
        (tree / name).unlink()
    for name in wanted:
        target, data = tree / name, (ROOT / name).read_bytes()
        if not target.exists() or target.read_bytes() != data:
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(data)
            target.chmod((ROOT / name).stat().st_mode)


class Copy:
    """The copy in `folder`, which is kept so that the next run builds less."""

    def __init__(self, folder, jobs, options=()):
        self.tree = folder / "tree"
        self.build = folder / "build"
        self.jobs = jobs
        folder.mkdir(parents=True, exist_ok=True)
        self.lock = open(folder / "lock", "w")
        try:
            fcntl.flock(self.lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            sys.exit(f"another run is at work in {folder}")
        synchronise(self.tree)
        self.must(["cmake", "-G", "Ninja", "-S", str(self.tree), "-B", str(self.build),
                   "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O1",
                   "-DEDGEPROOF_PCH=ON", "-DEDGEPROOF_UNITY=32", "-DEDGEPROOF_WERROR=OFF",
                   *options])

    def run(self, command, limit=None):
        with subprocess.Popen(command, cwd=self.tree, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, errors="replace",
                              start_new_session=True) as process:
            try:
                output, _ = process.communicate(timeout=limit)
            except BaseException:  # too long, or interrupted: end all its processes
                os.killpg(process.pid, signal.SIGKILL)
                raise
        return subprocess.CompletedProcess(command, process.returncode, output)

    def must(self, command):
        done = self.run(command)
        if done.returncode != 0:
            sys.exit(f"{' '.join(command)} failed:\n{done.stdout}")
        return done.stdout

    def make(self, target):
        return self.run(["cmake", "--build", str(self.build), "--target", target,
                         "--parallel", str(self.jobs)])
