#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""CalculiX (ccx, Debian's calculix-ccx) on a ball: one sector of the half-space, of wedges (C3D6) at the
axis and bricks (C3D8) between two planes through it in which the nodes stay; otherwise as calculix.py.

    python3 calculix_sphere.py sphere.toml --elements 15 30 60 120 --edge-zone 2e

The half-space's upper side has the ball's shape, and a flat rigid block is pressed on it."""
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile

import numpy as np

import calculix
import children
import scenes

HALF_ANGLE = math.radians(1)  # of the sector


def half_space(scene, r, z):
    """Displacements u_r and u_z (upwards) of the half-space z < 0 under P at one point (`johnson1985`,
    eq. 3.18)."""
    depth, rho = -z, np.hypot(r, z)
    k = scene.P * (1 + scenes.NU) / (2 * math.pi * scene.E)
    radial = k * (r * depth / rho**3 - (1 - 2 * scenes.NU) * r / (rho * (rho + depth)))
    return radial, -k * (depth**2 / rho**3 + 2 * (1 - scenes.NU) / rho)


def deck(scene, arguments, r, z):
    """The input of ccx, and its numbers of the nodes under the ball, for nodes r by z of the sector."""
    rr, zz = np.meshgrid(r, z)
    number = np.arange(rr.size).reshape(rr.shape) + 1
    other = np.where(rr > 0, number + rr.size, number)  # on the other plane; the axis lies on both
    shape = np.minimum(rr, scenes.FINE) ** 2 / (2 * scene.R)
    height = zz - shape * (1 + zz / arguments.size)
    across, along = rr * math.sin(HALF_ANGLE), rr * math.cos(HALF_ANGLE)
    nodes = [[n, x, y, -w] for n, x, y, w in zip(number.flat, along.flat, height.flat, across.flat)]
    nodes += [[n, x, y, w] for n, x, y, w in zip(other.flat, along.flat, height.flat, across.flat) if w > 0]
    block = 2 * rr.size + np.arange(1, 9)
    reach = 2 * scenes.FINE
    nodes += [[n, x, y, w] for n, (x, y, w) in zip(block, [
        (x, y, w) for w in (-1, 1) for x, y in ((-1, 0), (reach, 0), (reach, 1), (-1, 1))])]
    wedges = [[number[i, 0], other[i, 1], number[i, 1], number[i + 1, 0], other[i + 1, 1], number[i + 1, 1]]
              for i in range(len(z) - 1)]
    bricks = [[table[i, j], table[i, j + 1], table[i + 1, j + 1], table[i + 1, j]]
              for table in (number, other) for i in range(len(z) - 1) for j in range(1, len(r) - 1)]
    half = len(bricks) // 2
    bricks = [[*front, *back] for front, back in zip(bricks[:half], bricks[half:])]
    fine = np.count_nonzero(r < 1.001 * scenes.FINE)
    top = len(wedges) + half - (len(r) - 2)  # bricks below the upper row
    upper = [f"{len(wedges)}, S2", *(f"{top + j}, S5" for j in range(1, fine - 1))]
    planes = [(n, sign * math.tan(HALF_ANGLE)) for table, sign in ((number, -1), (other, 1))
              for n in table[:, 1:].flat]
    outside = [(n, *half_space(scene, rr.flat[k], zz.flat[k])) for table in (number, other)
               for k, n in enumerate(table.flat)
               if zz.flat[k] == z[0] or rr.flat[k] == r[-1]]
    moved = [[n, axis, axis, u] for n, radial, up in outside
             for axis, u in ((1, radial * math.cos(HALF_ANGLE)), (2, up)) if n not in number[:, 0] or axis == 2]
    cards = calculix.cards
    return "\n".join([
        *cards("*NODE, NSET=ALL", nodes),
        *cards("*ELEMENT, TYPE=C3D6, ELSET=AXIS", [[n + 1, *e] for n, e in enumerate(wedges)]),
        *cards("*ELEMENT, TYPE=C3D8, ELSET=BODY", [[n + 1 + len(wedges), *e] for n, e in enumerate(bricks)]),
        *cards("*ELEMENT, TYPE=C3D8, ELSET=PAD", [[len(wedges) + half + 1, *block]]),
        "*SURFACE, NAME=SLAVE, TYPE=ELEMENT", *upper, "*SURFACE, NAME=MASTER, TYPE=ELEMENT", "PAD, S3",
        "*MATERIAL, NAME=ELASTIC", *cards("*ELASTIC", [[scene.E, scenes.NU]]),
        *(f"*SOLID SECTION, ELSET={name}, MATERIAL=ELASTIC" for name in ("AXIS", "BODY", "PAD")),
        "*SURFACE INTERACTION, NAME=HARD", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR",
        f"{arguments.stiffness * scene.E:.12g}, {1e-12 * scene.E:.12g}",
        "*CONTACT PAIR, INTERACTION=HARD, TYPE=NODE TO SURFACE", "SLAVE, MASTER",
        *(line for n in block[1:] for line in ("*EQUATION", "2", f"{n}, 2, 1., {block[0]}, 2, -1.")),
        # The nodes stay in the two planes.
        *(line for n, slope in planes for line in ("*EQUATION", "2", f"{n}, 3, 1., {n}, 1, {-slope:.15g}")),
        *cards("*BOUNDARY", [[n, axis, axis] for n in (*number[:, 0], *block) for axis in (1, 3)]),
        "*STEP", "*STATIC", "1., 1.", *cards("*BOUNDARY", moved),
        *cards("*CLOAD", [[block[0], 2, -scene.P * HALF_ANGLE / math.pi]]),
        "*CONTACT PRINT, SLAVE=SLAVE, MASTER=MASTER", "CSTR", "*END STEP", ""]), number[-1, :fine]


def solve(scene, elements, arguments):
    if shutil.which("ccx") is None:
        scenes.skip("ccx (calculix-ccx) is not there")
    fine = np.linspace(0, scenes.FINE, elements + 1)
    ratio = 1 + min(0.3, 4 * fine[1])
    r = np.append(fine, scenes.FINE + scenes.graded(fine[1], ratio, arguments.size - scenes.FINE))
    z = -np.append(0, scenes.graded(fine[1], ratio, arguments.size))[::-1]
    text, nodes = deck(scene, arguments, r, z)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "ball.inp").write_text(text)
        run = children.run(["ccx", "ball"], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        result = folder / "ball.dat"
        if run.returncode != 0 or not result.exists() or result.stat().st_size == 0:
            sys.exit(f"calculix_sphere.py: ccx ended with {run.returncode}: {run.stdout[-500:]}")
        found = calculix.contact_stresses(result.read_text())
    return fine, np.array([found.get(node, 0.0) for node in nodes])


if __name__ == "__main__":
    scenes.main("calculix", solve, "r [mm],CPRESS [MPa]", [
        scenes.BODY[0], ("--stiffness", {"type": float, "default": 1e4, "help": "of the contact, in E per mm"})])
