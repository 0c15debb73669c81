# SPDX-License-Identifier: BSD-3-Clause
import csv
import math
import sys

answers = csv.writer(sys.stdout)
answers.writerow(["id", "value"])
for row in csv.DictReader(sys.stdin):
    if row["kind"] == "power-law" and row["m"] == "1" and row["quantity"] == "p":
        modulus, C, a, u = (float(row[k]) for k in ("contact_modulus", "C", "a", "u"))
        answers.writerow([row["id"], modulus * C / 2 * math.sqrt(u * (2 * a - u))])
