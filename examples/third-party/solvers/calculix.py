#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""CalculiX (ccx, Debian's calculix-ccx): writes the mesh, runs it, and takes the contact stresses (CSTR)
at the nodes from its .dat file. One layer of bricks (C3D8) between two planes that keep it in plane
strain; contact node to surface, with linear pressure-overclosure. With --quadratic the bricks are
C3D20R, the contact is surface to surface, and the stresses are those at the nodes of the .frd file.

    python3 calculix.py hertz.toml --elements 30 60 120 --edge-zone 2e

The half-plane's upper side has the pad's shape, and a flat rigid block is pressed on it: the gaps are
the scene's, and no node meets a facet."""
import pathlib
import shutil
import subprocess
import sys
import tempfile

import numpy as np

import children
import scenes


def cards(name, rows):
    return [name, *(", ".join(f"{value:.12g}" for value in row) for row in rows)]


def brick(quad, layer):
    return [*quad, *(node + layer for node in quad)]


def deck(scene, arguments, x, y):
    """The input of ccx, and its numbers of the nodes under the pad, for a body with nodes x by y."""
    if arguments.quadratic:
        return quadratic_deck(scene, arguments, x, y)
    xx, yy = np.meshgrid(x, y)
    number = np.arange(xx.size).reshape(xx.shape) + 1
    block = xx.size + np.arange(1, 5)
    layer = block[-1]  # the nodes at z = 1 are numbered on from there
    under_pad = number[-1, abs(x - scene.centre) < 1.001 * scenes.FINE]
    # The gap is in the body's shape: all of it at the top, none at the bottom.
    shape = scene.gap(np.clip(x, *scene.centre + scenes.FINE * np.array([-1, 1])))
    places = np.column_stack([np.append(xx, scene.centre + 2 * scenes.FINE * np.array([-1, 1, 1, -1])),
                              np.append(yy - shape * (1 + yy / arguments.size), [0, 0, 1, 1])])
    quads = np.stack([number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]], axis=-1)
    quads = quads.reshape(-1, 4)
    outside = np.unique(np.concatenate([number[0], number[:, 0], number[:, -1]]))
    moved = scene.half_plane(xx.flat[outside - 1], yy.flat[outside - 1])
    outside_rows = [[node + z, axis + 1, axis + 1, 0 if arguments.clamped else u]
                    for axis in (0, 1) for node, u in zip(outside, moved[axis]) for z in (0, layer)]
    of_pad = brick(block, layer)
    return "\n".join([
        *cards("*NODE, NSET=ALL", [[n + 1 + z * layer, *place, z]
                                   for z in (0, 1) for n, place in enumerate(places)]),
        *cards("*ELEMENT, TYPE=C3D8, ELSET=BODY", [[n + 1, *brick(q, layer)] for n, q in enumerate(quads)]),
        *cards("*ELEMENT, TYPE=C3D8, ELSET=PAD", [[len(quads) + 1, *of_pad]]),
        *slave(arguments.slave, quads, under_pad, layer),
        *definitions(scene, arguments, "NODE TO SURFACE", of_pad, outside_rows),
        "*CONTACT PRINT, SLAVE=SLAVE, MASTER=MASTER", "CSTR", "*END STEP", ""]), under_pad


def quadratic_deck(scene, arguments, x, y):
    """The same with bricks of 20 nodes: every second line of nodes, at the middles of the sides."""
    fine = [np.interp(np.arange(2 * len(s) - 1) / 2, np.arange(len(s)), s) for s in (x, y)]
    xx, yy = np.meshgrid(*fine)
    shape = scene.gap(np.clip(fine[0], *scene.centre + scenes.FINE * np.array([-1, 1])))
    places = np.column_stack([xx.flat, (yy - shape * (1 + yy / arguments.size)).flat])
    rows, columns = np.indices(xx.shape)
    number = np.arange(xx.size).reshape(xx.shape) + 1
    layer = xx.size  # the planes z = 0, 1/2, 1 are numbered one after the other
    at = {0: rows % 2 * (columns % 2) == 0, 1: (rows % 2 == 0) & (columns % 2 == 0)}
    at[2] = at[0]
    i, j = (s.ravel() for s in np.meshgrid(2 * np.arange(len(y) - 1), 2 * np.arange(len(x) - 1), indexing="ij"))
    corner = [(0, 0), (0, 2), (2, 2), (2, 0)]
    middle = [(0, 1), (1, 2), (2, 1), (1, 0)]
    order = [*((*c, 0) for c in corner), *((*c, 2) for c in corner), *((*m, 0) for m in middle),
             *((*m, 2) for m in middle), *((*c, 1) for c in corner)]
    elements = np.column_stack([number[i + di, j + dj] + z * layer for di, dj, z in order])
    block = 3 * layer + np.arange(1, 9)
    corners = scene.centre + 2 * scenes.FINE * np.array([-1, 1, 1, -1])
    outside = (rows == 0) | (columns == 0) | (columns == columns.max())
    under_pad = number[-1, abs(fine[0] - scene.centre) < 1.001 * scenes.FINE]
    outside_rows = []
    for z in (0, 1, 2):
        chosen = outside & at[z]
        for axis, moved in enumerate(scene.half_plane(xx[chosen], yy[chosen])):
            outside_rows += [[n + z * layer, axis + 1, axis + 1, 0 if arguments.clamped else u]
                             for n, u in zip(number[chosen], moved)]
    upper = np.flatnonzero(np.isin(elements[:, [2, 3]], under_pad).all(axis=1)) + 1
    return "\n".join([
        *cards("*NODE, NSET=ALL", [[n + z * layer, *places[n - 1], z / 2] for z in (0, 1, 2)
                                   for n in number[at[z]]]),
        *cards("*NODE, NSET=ALL", [[block[4 * z + k], corners[k], k // 2, z] for z in (0, 1) for k in range(4)]),
        "*ELEMENT, TYPE=C3D20R, ELSET=BODY",  # at most 16 numbers in a line
        *(line for n, nodes in enumerate(elements)
          for line in (", ".join(map(str, [n + 1, *nodes[:15]])) + ",", ", ".join(map(str, nodes[15:])))),
        *cards("*ELEMENT, TYPE=C3D8, ELSET=PAD", [[len(elements) + 1, *block]]),
        "*SURFACE, NAME=SLAVE, TYPE=ELEMENT", *(f"{n}, S5" for n in upper),
        *definitions(scene, arguments, "SURFACE TO SURFACE", block, outside_rows),
        "*CONTACT FILE", "CSTR", "*END STEP", ""]), under_pad


def definitions(scene, arguments, kind, of_pad, outside_rows):
    """The material, the contact, and the step without its output. The block `of_pad` only moves up and
    down, as a whole."""
    return [
        "*SURFACE, NAME=MASTER, TYPE=ELEMENT", "PAD, S3",
        "*MATERIAL, NAME=ELASTIC", *cards("*ELASTIC", [[scene.E, scenes.NU]]),
        "*SOLID SECTION, ELSET=BODY, MATERIAL=ELASTIC",
        "*SOLID SECTION, ELSET=PAD, MATERIAL=ELASTIC",
        "*SURFACE INTERACTION, NAME=HARD", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR",
        f"{arguments.stiffness * scene.E:.12g}, {1e-12 * scene.E:.12g}",
        f"*CONTACT PAIR, INTERACTION=HARD, TYPE={kind}", "SLAVE, MASTER",
        *(line for n in of_pad[1:] for line in ("*EQUATION", "2", f"{n}, 2, 1., {of_pad[0]}, 2, -1.")),
        *cards("*BOUNDARY", [[node, 1, 1] for node in of_pad]), "ALL, 3, 3",
        "*STEP", "*STATIC", "1., 1.", *cards("*BOUNDARY", outside_rows),
        *cards("*CLOAD", [[of_pad[0], 2, -scene.P]])]


def slave(kind, quads, under_pad, layer):
    """The half-plane's side of the contact, by its elements' upper faces or by nodes alone."""
    if kind == "nodes":
        return cards("*NSET, NSET=UPPER", [[node + z] for z in (0, layer) for node in under_pad]) + [
            "*SURFACE, NAME=SLAVE, TYPE=NODE", "UPPER"]
    faces = np.flatnonzero(np.isin(quads[:, 2:], under_pad).all(axis=1))
    return ["*SURFACE, NAME=SLAVE, TYPE=ELEMENT", *(f"{n + 1}, S5" for n in faces)]


def contact_stresses(data, column=1):
    """Pressures by node from the last step of a .dat file, or shear tractions (column 2)."""
    *_, last = data.split("contact stress")
    rows = (line.split() for line in last.splitlines()[1:])
    return {int(row[0]): float(row[column]) for row in rows if len(row) == 4}


def contact_stresses_of_frd(data, name="CPRESS"):
    """Pressures by node from the last CONTACT block of an .frd file, or other values of it."""
    *_, last = data.split(" -4  CONTACT")
    names, rows = [], {}
    for line in last.splitlines()[1:]:
        if line.startswith(" -5"):
            names.append(line[5:13].strip())
        elif line.startswith(" -1"):
            at = 13 + 12 * names.index(name)
            rows[int(line[3:13])] = float(line[at:at + 12])
        else:
            break
    return rows


def solve(scene, elements, arguments):
    if shutil.which("ccx") is None:
        scenes.skip("ccx (calculix-ccx) is not there")
    x, y = scene.grid(elements, arguments.size, growth=4)
    text, nodes = deck(scene, arguments, x, y)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "pad.inp").write_text(text)
        run = children.run(["ccx", "pad"], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        result = folder / ("pad.frd" if arguments.quadratic else "pad.dat")
        if run.returncode != 0 or not result.exists() or result.stat().st_size == 0:
            sys.exit(f"calculix.py: ccx ended with {run.returncode}: {run.stdout[-500:]}")
        found = (contact_stresses_of_frd if arguments.quadratic else contact_stresses)(result.read_text())
    return (scene.fine(2 * elements if arguments.quadratic else elements),
            np.array([found.get(node, 0.0) for node in nodes]))


if __name__ == "__main__":
    scenes.main("calculix", solve, "COORD1 [mm],CPRESS [MPa]", [
        *scenes.BODY,
        ("--quadratic", {"action": "store_true", "help": "bricks of 20 nodes"}),
        ("--stiffness", {"type": float, "default": 1e4, "help": "of the contact, in E per mm"}),
        ("--slave", {"choices": ["faces", "nodes"], "default": "faces", "help": "how the surface is given"})])
