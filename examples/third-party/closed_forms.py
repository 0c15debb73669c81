#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Answers the questions of `edgeproof points` in double precision (Python's standard library).

    edgeproof points questions.toml | python3 closed_forms.py | edgeproof check - --digits 13

Contacts: wedge and cylinder (power-law, m = 0 and 1), flat-and-rounded punch.
"""
import csv
import math
import sys


def wedge(n, name):
    a, slope = n["a"], n["C"]
    scale = n["contact_modulus"] * slope
    if name == "P":
        return scale * a
    if name == "c_0":
        return scale / math.pi * math.sqrt(2 / a)
    u = n["u"]
    # arccosh(a/|x|), without the cancellation near the edge
    return scale / math.pi * math.asinh(math.sqrt(u * (2 * a - u)) / abs(a - u))


def cylinder(n, name):
    a = n["a"]
    scale = n["contact_modulus"] * n["C"] / 2
    if name == "P":
        return scale * math.pi * a * a / 2
    if name == "c_0":
        return scale * math.sqrt(2 * a)
    if name == "c_1":
        return -scale * math.sqrt(2 * a) / (4 * a)
    return scale * math.sqrt(n["u"] * (2 * a - n["u"]))


def real_atanh(z):
    """The real part, on either side of 1."""
    return math.atanh(z) if abs(z) < 1 else math.atanh(1 / z)


def flat_and_rounded(n, name):
    a, t = n["a"], n["t"]
    scale = n["contact_modulus"] * a / (2 * math.pi * n["R"])
    flat = math.asin(t / a)
    if name == "P":
        return scale * math.pi * a / 2 * (math.pi - 2 * flat - math.sin(2 * flat))
    if name == "c_0":
        return scale * (math.pi - 2 * flat) * math.sqrt(2 / a)
    u = n["u"]
    sin, cos = abs(a - u) / a, math.sqrt(u * (2 * a - u)) / a
    return scale * (
        (math.pi - 2 * flat) * cos
        + 2 * sin * real_atanh(math.tan(flat) * cos / sin)
        - 2 * math.sin(flat) * real_atanh(cos / math.cos(flat))
    )


def answer(row):
    n = {key: float(row[key]) for key in ("m", "C", "t", "R", "a", "contact_modulus", "u")
         if row.get(key)}
    if row["kind"] == "flat-and-rounded":
        return flat_and_rounded(n, row["quantity"])
    return (wedge if n["m"] == 0 else cylinder)(n, row["quantity"])


def main():
    questions = csv.DictReader(line for line in sys.stdin if not line.startswith("#"))
    answers = csv.DictWriter(sys.stdout, [*questions.fieldnames, "value"], lineterminator="\n")
    answers.writeheader()
    for row in questions:
        answers.writerow({**row, "value": repr(answer(row))})


if __name__ == "__main__":
    main()
