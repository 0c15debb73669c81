#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""CalculiX (ccx, Debian's calculix-ccx) with friction: two like bodies of bricks (C3D8) in plane strain. The
lower one has the pad's shape, the upper one is its mirror image without it. The outside of the lower body is
held; that of the upper body moves as a whole, under P in the first step and under P and Q in the second.

    python3 calculix_friction.py partial-slip.toml --elements 60 120 240 --edge-zone 2e

The stresses (CSTR) are those at the nodes of the lower surface."""
import pathlib
import shutil
import subprocess
import sys
import tempfile

import numpy as np

import calculix
import children
import scenes


def deck(scene, arguments, x, y):
    """The input of ccx, and its numbers of the nodes of the lower surface."""
    cards, brick = calculix.cards, calculix.brick
    E = 2 * scene.E  # of each body: E/(1 - nu^2) is twice the contact modulus
    xx, yy = np.meshgrid(x, y)
    number = np.arange(xx.size).reshape(xx.shape) + 1
    layer = 2 * xx.size  # the nodes at z = 1 are numbered on from there, those of the upper body between
    shape = scene.gap(np.clip(x, *scene.centre + scenes.FINE * np.array([-1, 1])))
    places = np.vstack([np.column_stack([xx.flat, (yy - shape * (1 + yy / arguments.size)).flat]),
                        np.column_stack([xx.flat, -yy.ravel()])])
    lower = np.stack([number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]], axis=-1).reshape(-1, 4)
    upper = (lower + xx.size)[:, ::-1]
    under_pad = number[-1, abs(x - scene.centre) < 1.001 * scenes.FINE]
    slave = np.flatnonzero(np.isin(lower[:, 2:], under_pad).all(axis=1)) + 1
    held = np.unique(np.concatenate([number[0], number[:, 0], number[:, -1]]))
    moved = [n + z for n in held + xx.size for z in (0, layer)]
    return "\n".join([
        *cards("*NODE, NSET=ALL", [[n + 1 + z * layer, *place, z] for z in (0, 1) for n, place in enumerate(places)]),
        *cards("*ELEMENT, TYPE=C3D8, ELSET=BODIES",
               [[n + 1, *brick(quad, layer)] for n, quad in enumerate(np.vstack([lower, upper]))]),
        "*SURFACE, NAME=SLAVE, TYPE=ELEMENT", *(f"{n}, S5" for n in slave),
        "*SURFACE, NAME=MASTER, TYPE=ELEMENT", *(f"{n + len(lower)}, S3" for n in slave),
        "*MATERIAL, NAME=ELASTIC", *cards("*ELASTIC", [[E, scenes.NU]]),
        "*SOLID SECTION, ELSET=BODIES, MATERIAL=ELASTIC",
        "*SURFACE INTERACTION, NAME=ROUGH", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR",
        f"{arguments.stiffness * E:.12g}, {1e-12 * E:.12g}",
        "*FRICTION", f"{scene.friction:.12g}, {arguments.stick * E:.12g}",
        f"*CONTACT PAIR, INTERACTION=ROUGH, TYPE={arguments.contact.upper()} TO SURFACE", "SLAVE, MASTER",
        *(line for n in moved[1:] for axis in (1, 2)
          for line in ("*EQUATION", "2", f"{n}, {axis}, 1., {moved[0]}, {axis}, -1.")),
        "*NSET, NSET=HELD", *(f"{n + z}" for n in held for z in (0, layer)),
        "*BOUNDARY", *HELD, *(line for Q in (0, scene.Q) for line in step(scene, arguments, Q, moved[0]))]), under_pad


HELD = ["HELD, 1, 2", "ALL, 3, 3"]


def step(scene, arguments, Q, node):
    """The first step, in which the upper body does not move sideways, or the second, with Q."""
    part = f"{1 / arguments.increments:.12g}"
    held = ["*BOUNDARY, OP=NEW", *HELD] if Q else [*calculix.cards("*BOUNDARY", [[node, 1, 1]])]
    return ["*STEP, INC=1000", "*STATIC", f"{part}, 1., 1e-6, {part}", *held,
            *calculix.cards("*CLOAD", [[node, 2, -scene.P], [node, 1, Q]]),
            "*CONTACT PRINT, SLAVE=SLAVE, MASTER=MASTER", "CSTR", "*CONTACT FILE", "CSTR", "*END STEP"]


def solve(scene, elements, arguments):
    if shutil.which("ccx") is None:
        scenes.skip("ccx (calculix-ccx) is not there")
    x, y = scene.grid(elements, arguments.size, growth=4)
    text, nodes = deck(scene, arguments, x, y)
    surfaces = arguments.contact == "surface"
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "pad.inp").write_text(text + "\n")
        run = children.run(["ccx", "pad"], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        result = folder / ("pad.frd" if surfaces else "pad.dat")
        if run.returncode != 0 or not result.exists() or result.stat().st_size == 0:
            sys.exit(f"calculix_friction.py: ccx ended with {run.returncode}: {run.stdout[-500:]}")
        data = result.read_text()
    found = ([calculix.contact_stresses_of_frd(data, name) for name in ("CPRESS", "CSHEAR1")] if surfaces
             else [calculix.contact_stresses(data, column) for column in (1, 2)])
    return scene.fine(elements), *(np.array([values.get(node, 0.0) for node in nodes]) for values in found)


if __name__ == "__main__":
    scenes.main("calculix-friction", solve, "COORD1 [mm],CPRESS [MPa],CSHEAR1 [MPa]", [
        scenes.BODY[0],
        ("--contact", {"choices": ["node", "surface"], "default": "node", "help": "node or surface to surface"}),
        ("--stiffness", {"type": float, "default": 1e4, "help": "of the contact, in E per mm"}),
        ("--stick", {"type": float, "default": 1e3, "help": "stiffness of stick, in E per mm"}),
        ("--increments", {"type": int, "default": 10, "help": "of each load"})])
