#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The formulas of closed_forms.py to 30 digits, with mpmath (package python3-mpmath).

    edgeproof check questions.toml --exec 'python3 thirty_digits.py' --digits 30
"""
import csv
import sys

from mpmath import acosh, acoth, asin, atanh, mp, mpf, nstr, pi, sin, sqrt, tan

mp.dps = 60  # the edge takes some of them


def real_atanh(z):
    return atanh(z) if abs(z) < 1 else acoth(z)


def answer(row):
    n = {key: mpf(row[key]) for key in ("m", "C", "t", "R", "a", "contact_modulus", "u")
         if row.get(key)}
    name, a = row["quantity"], n["a"]
    if row["kind"] == "flat-and-rounded":
        flat = asin(n["t"] / a)
        scale = n["contact_modulus"] * a / (2 * pi * n["R"])
        if name == "P":
            return scale * pi * a / 2 * (pi - 2 * flat - sin(2 * flat))
        if name == "c_0":
            return scale * (pi - 2 * flat) * sqrt(2 / a)
        x = abs(a - n["u"]) / a
        y = sqrt(1 - x * x)
        return scale * ((pi - 2 * flat) * y + 2 * x * real_atanh(tan(flat) * y / x)
                        - 2 * sin(flat) * real_atanh(y / sqrt(1 - (n["t"] / a) ** 2)))
    scale = n["contact_modulus"] * n["C"]
    if n["m"] == 0:
        return {"P": lambda: scale * a, "c_0": lambda: scale / pi * sqrt(2 / a),
                "p": lambda: scale / pi * acosh(a / abs(a - n["u"]))}[name]()
    return {"P": lambda: scale * pi * a ** 2 / 4, "c_0": lambda: scale * sqrt(2 * a) / 2,
            "c_1": lambda: -scale * sqrt(2 * a) / (8 * a),
            "p": lambda: scale / 2 * sqrt(n["u"] * (2 * a - n["u"]))}[name]()


def main():
    questions = csv.DictReader(line for line in sys.stdin if not line.startswith("#"))
    print("id,value")
    for row in questions:
        print(f"{row['id']},{nstr(answer(row), 35)}")


if __name__ == "__main__":
    main()
