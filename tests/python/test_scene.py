# SPDX-License-Identifier: BSD-3-Clause
import csv

import pytest

import edgeproof


@pytest.mark.parametrize("name", ["power-law", "tilted-wedge", "flat-and-rounded"])
def test_reference_tables(source, name):
    """Compares rows of the reference tables digit by digit."""
    with open(source / "reference" / f"{name}.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    rows = [r for r in rows if r["quantity"] == "p"]
    made = {}
    for row in rows[::7]:
        profile = {
            "power-law": lambda r: edgeproof.power_law(r["m"], r["C"]),
            "tilted-wedge": lambda r: edgeproof.tilted_wedge(r["phi"], r["alpha"] or None),
            "flat-and-rounded": lambda r: edgeproof.flat_and_rounded(r["t"], r["R"]),
        }[row["kind"]](row)
        load = {k: row.get(k) or None for k in ("a", "P", "M", "contact_modulus")}
        scene = made.setdefault((profile, str(load)), edgeproof.Scene(profile, **load))
        value = scene.pressure(row["u"], edge=row["edge"])
        assert (value.text, value.bound) == (row["value"], row["bound"]), row["id"]
        assert float(value) == float(row["binary64"]), row["id"]
    assert len(made) > 3
