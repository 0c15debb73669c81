#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""closed_forms.py with six faults, each of which `edgeproof check` must find and name."""
import csv
import struct
import sys

import closed_forms


def spoilt(row):
    value = closed_forms.answer(row)
    name = row["quantity"]
    if name == "P":
        return repr(2 * value)  # 1: another contact modulus
    if name == "c_1":
        return repr(-value)  # 2: a sign
    if row["id"].startswith("flat:") and row["edge"] == "left" and name == "p":
        return repr(struct.unpack("f", struct.pack("f", value))[0])  # 3: single precision
    if row["id"] == "wedge:C=0.1:contact_modulus=1:right:u=0.999:p":
        return "nan"  # 4
    return repr(value)


def main():
    questions = csv.DictReader(line for line in sys.stdin if not line.startswith("#"))
    answers = csv.DictWriter(sys.stdout, ["id", "value"], lineterminator="\n")
    answers.writeheader()
    for number, row in enumerate(questions):
        written = {"id": row["id"], "value": spoilt(row)}
        if number != 7:  # 5: one is left out
            answers.writerow(written)
        if number == 9:  # 6: one is given twice
            answers.writerow(written)


if __name__ == "__main__":
    main()
