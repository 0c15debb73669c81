# SPDX-License-Identifier: BSD-3-Clause
"""What the three programs share: the pad of a scene, the half-plane, meshes, and `edgeproof compare`.

Lengths in mm, forces in N per mm of thickness, pressures in MPa. The half-plane is y < 0; the rigid
pad presses it from above and is kept from turning. Contact pressures are positive."""
import argparse
import math
import os
import pathlib
import shutil
import sys
import tomllib

import numpy as np

import children

NU = 0.3      # of the half-plane: E = contact_modulus (1 - NU^2)
FINE = 1.5    # half the width of the zone with elements of even width
SKIPPED = 77  # exit status where a program or a package is not there (ctest: skipped)
# Options of the programs that need a body of finite size.
BODY = [
    ("--size", {"type": float, "default": 20.0, "help": "mm from the pad's middle to the outside"}),
    ("--clamped", {"action": "store_true", "help": "no displacement outside, in place of the half-plane's"})]


class Scene:
    """The scene of a file: `gap(x)` of the pad before it is pressed, 0 at its minimum; the loads `P` and `Q`;
    `friction`; `e_star`; `centre`, the middle of the flat."""

    def __init__(self, file):
        self.file = pathlib.Path(file)
        scene = tomllib.loads(self.file.read_text())
        profile, load, shear = scene["profile"], scene["load"], scene.get("shear", {})
        self.P, self.e_star = float(load["P"]), float(load["contact_modulus"])
        self.E = self.e_star * (1 - NU**2)
        self.Q, self.friction = (float(shear.get(key, 0)) for key in ("Q", "friction"))
        self.R = float(profile["R"])
        self.t = float(profile.get("t", 0)) or float(profile.get("flat_width", 0)) / 2
        self.alpha = float(profile.get("alpha", 0))
        self.centre = -self.alpha * self.R - self.t if self.alpha else 0.0
        self.lowest = self.alpha * (self.t + self.alpha * self.R / 2)
        self.line_of_action = self.centre  # of P; from the second mesh on that of the one before

    def gap(self, x):
        """Slopes as docs/mechanics.md has them: the flat's is -alpha, the arcs' adds (|s| - t)/R."""
        s = np.asarray(x) - self.centre  # from the middle of the flat
        return np.maximum(abs(s) - self.t, 0) ** 2 / (2 * self.R) - self.alpha * s + self.lowest

    def fine(self, elements):
        """Nodes of `elements` elements of even width about the middle of the flat."""
        return self.centre + np.linspace(-FINE, FINE, elements + 1)

    def grid(self, elements, size, growth):
        """Nodes x and y of a body from -size to size and down to -size: even under the pad, then
        wider by a ratio that goes to 1 with the width of the elements: 1 + growth times it."""
        fine = self.fine(elements)
        width = fine[1] - fine[0]
        ratio = 1 + min(0.3, growth * width)
        right = fine[-1] + graded(width, ratio, size - (fine[-1] - self.centre))
        left = fine[0] - graded(width, ratio, size - (self.centre - fine[0]))
        return np.concatenate([left[::-1], fine, right]), -np.append(0, graded(width, ratio, size))[::-1]

    def lame(self):
        """Lame's constants by name."""
        return {"lambda": self.E * NU / ((1 + NU) * (1 - 2 * NU)), "mu": self.E / (2 * (1 + NU))}

    def half_plane(self, x, y):
        """Displacements u_x, u_y of the half-plane under P at one point of its surface (`johnson1985`,
        section 2.2), with an arbitrary constant in u_y. On P's own line of action those of a contact
        of half-width a differ by (a/r)^2 of themselves at the distance r."""
        x = np.asarray(x) - self.line_of_action
        r, theta = np.hypot(x, y), np.arctan2(x, -np.asarray(y))
        k = (1 + NU) * self.P / (math.pi * self.E)
        shared = (1 - 2 * NU) * k * theta
        radial = -2 * (1 - NU) * k * np.cos(theta) * np.log(r) - shared * np.sin(theta)
        around = 2 * (1 - NU) * k * np.sin(theta) * np.log(r) + k * np.sin(theta) - shared * np.cos(theta)
        inward = radial * np.cos(theta) - around * np.sin(theta)
        return radial * np.sin(theta) + around * np.cos(theta), -inward


def graded(width, ratio, length):
    """Distances at which elements end whose widths grow by `ratio`, the last one at `length`."""
    count = max(1, math.ceil(math.log1p(length / width * (ratio - 1)) / math.log(ratio) - 1e-9))
    ends = np.cumsum(width * ratio ** np.arange(1, count + 1))
    return ends * length / ends[-1]


def skip(what):
    """Ends the program where something that it needs is not there."""
    print(f"skipped: {what}")
    sys.exit(SKIPPED)


def give_up(what):
    """Ends the program where its input was bad."""
    print(f"{pathlib.Path(sys.argv[0]).name}: {what}", file=sys.stderr)
    sys.exit(2)


def main(program, solve, header, options=()):
    """The command line of a program: SCENE --elements N [N ...] [--out FOLDER] and options of its own;
    what is left is for `edgeproof compare`. `solve(scene, elements, arguments)` gives x, p and, with friction, q."""
    parser = argparse.ArgumentParser(description=sys.modules["__main__"].__doc__, allow_abbrev=False,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene")
    parser.add_argument("--elements", type=int, nargs="+", default=[30, 60, 120],
                        help="elements of even width under the pad, 3 mm; several: from coarse to fine")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("."), help="folder of the results")
    for name, settings in options:
        parser.add_argument(name, **settings)
    arguments, of_compare = parser.parse_known_args()
    edgeproof = shutil.which(os.environ.get("EDGEPROOF", "edgeproof"))
    if edgeproof is None:
        give_up("there is no edgeproof; put it on the PATH, or say where it is by EDGEPROOF")
    if min(arguments.elements) < 2:
        give_up("--elements: fewer than 2; ask for 30 or more")
    try:
        scene = Scene(arguments.scene)
    except (OSError, ValueError, KeyError) as error:
        give_up(f"{arguments.scene}: {error!r}; give a scene such as hertz.toml in the folder of this program")
    arguments.out.mkdir(parents=True, exist_ok=True)
    files = []
    for elements in arguments.elements:
        x, p, *others = solve(scene, elements, arguments)
        scene.line_of_action = np.sum(x * p) / np.sum(p)
        files.append(arguments.out / f"{program}-{scene.file.stem}-{elements}.csv")
        rows = [",".join([f"{place:.9g}", *(f"{value:.6E}" for value in values)]) for place, *values in zip(x, p, *others)]
        files[-1].write_text("\n".join([header, *rows]) + "\n")
    command = [edgeproof, "compare", scene.file, *files, *of_compare]
    sys.exit(children.run(command).returncode)
