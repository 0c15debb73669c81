#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures the error that a correct mesh has by itself, away from the edges, in runs of CalculiX, from
which `edgeproof compare` learns what to allow for a mesh (mesh_error.hpp).

    python3 mesh_errors.py [--contacts hertz ...] [--write]

For each contact and mesh: the root mean square error of p over nodes two elements, and a fiftieth of
the contact, or more from the edges, relative to the largest pressure; the number of elements in the
contact; and their product. --write stores the rows in mesh-errors.csv. The last line is the greatest
product."""
import argparse
import csv
import io
import os
import pathlib
import shutil
import subprocess
import sys

import numpy as np

import calculix
import scenes

HERE = pathlib.Path(__file__).resolve().parent
FILE = HERE / "mesh-errors.csv"
CONTACTS = ["hertz", "flat-and-rounded", "tilted"]
ELEMENTS = [24, 30, 60]


def rows_of(edgeproof, scene, *options):
    """The rows that `edgeproof pressure` prints, and its facts."""
    run = subprocess.run([edgeproof, "pressure", scene, "--digits", "12", *options], check=True,
                         stdout=subprocess.PIPE, text=True)
    lines = run.stdout.splitlines()
    facts = {key[2:]: float(value.split()[0]) for key, _, value in (line.partition(": ") for line in lines)
             if key in ("# a", "# b")}
    return list(csv.DictReader(io.StringIO("\n".join(line for line in lines if line[:1] != "#")))), facts


def measured(edgeproof, contact, elements, options):
    """Elements in the contact, and the error away from the edges."""
    scene = scenes.Scene(HERE / f"{contact}.toml")
    for _ in range(2 if scene.alpha else 1):  # the second run knows the line of action of P
        x, p = calculix.solve(scene, elements, options)
        scene.line_of_action = np.sum(x * p) / np.sum(p)
    _, facts = rows_of(edgeproof, scene.file, "--quantity", "contact")
    a, b = facts["a"], facts["b"]
    width = x[1] - x[0]
    inner = np.minimum(a - x, x + b) >= max(2 * width, 0.02 * (a + b))
    rows, _ = rows_of(edgeproof, scene.file, "--x", *(f"{place:.12g}" for place in x[inner]))
    exact = np.array([float(row["p"]) for row in rows])
    return (a + b) / width, np.sqrt(np.mean((p[inner] - exact) ** 2)) / exact.max()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--contacts", nargs="+", default=CONTACTS)
    parser.add_argument("--elements", type=int, nargs="+", default=ELEMENTS)
    parser.add_argument("--write", action="store_true")
    chosen = parser.parse_args()
    chosen.size, chosen.clamped, chosen.stiffness, chosen.slave, chosen.quadratic = 20.0, False, 1e4, "faces", False
    edgeproof = shutil.which(os.environ.get("EDGEPROOF", "edgeproof"))
    if edgeproof is None:
        scenes.give_up("there is no edgeproof; put it on the PATH, or say where it is by EDGEPROOF")
    rows, left_out = [], []
    for contact in chosen.contacts:
        for count in chosen.elements:
            try:
                inside, error = measured(edgeproof, contact, count, chosen)
            except SystemExit as failure:  # CalculiX does not converge on every mesh
                print(f"{contact}, {count} elements, is left out: {str(failure)[:80]}", file=sys.stderr)
                left_out.append(f"{contact} {count}")
                continue
            rows.append([contact, count, f"{inside:.1f}", f"{error:.3g}", f"{inside * error:.3g}"])
            print(*rows[-1], sep=",", flush=True)
    if chosen.write:
        with FILE.open("w") as file:
            print("# Errors of CalculiX away from the edges, by mesh_errors.py --write. error: root mean square,",
                  "# relative to the largest pressure. product: error times the elements in the contact.", sep="\n",
                  file=file)
            if left_out:
                print(f"# CalculiX does not converge: {', '.join(left_out)}.", file=file)
            table = csv.writer(file, lineterminator="\n")
            table.writerow(["contact", "elements_of_mesh", "elements_in_contact", "error", "product"])
            table.writerows(rows)
    print(f"greatest product: {max(float(row[-1]) for row in rows)}")


if __name__ == "__main__":
    main()
