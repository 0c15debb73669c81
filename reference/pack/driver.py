#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Holds a contact code against the conformance pack.

    python3 driver.py A level-a.csv
    python3 driver.py B cases.csv hard-cases.csv --answers example      (your module for example)

The module has answer(question): a float, at levels C and D a decimal.Decimal where it has more
digits, or None where your code does not have this. `question` is a dict of the columns: numbers are
floats, None where the contact has none of that name. Levels A, B, C and D; README.md says what they
ask. Exit status 0: every answer is within the level; 1: one is not; 2: there was nothing to hold."""
import csv
import decimal
import importlib
import math
import os
import sys

COLUMNS = ("id,kind,m,C,phi,alpha,t,R,a,P,M,E,Q,S,edge,u,quantity,scale,value,bound,binary64,hex,"
           "condition,ulps").split(",")
WORDS = {"id", "kind", "edge", "quantity"}
ANSWER = {"scale", "value", "bound", "binary64", "hex", "condition", "ulps"}
MOST_SHOWN = 10
LEAST_ROWS = 3     # for a cause
SAME_RATIO = 0.01  # wrong answers have a common factor if their ratios agree to this


def within(level, value, row):
    """Whether an answer is within the level: a NaN is not."""
    exact = float.fromhex(row["hex"])
    if level == "D":
        correct = decimal.Decimal(row["value"])
        digits = decimal.Context(prec=50, rounding=decimal.ROUND_HALF_EVEN)
        return digits.plus(decimal.Decimal(value)) == correct
    value = float(value)
    if level == "A":
        return abs(value - exact) <= 0.01 * float(row["scale"])
    if level == "B":
        return abs(value - exact) <= float(row["ulps"]) * math.ulp(exact)
    return value == exact


def causes(ratios):
    """Lines about quantities of which all wrong answers are the same factor times the exact ones."""
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "factors.txt"), encoding="utf-8") as file:
        factors = [line.split() for line in file if not line.startswith("#")]
    for quantity, found in sorted(ratios.items()):
        low, high = min(found), max(found)
        middle = (low + high) / 2
        if len(found) >= LEAST_ROWS and high - low <= SAME_RATIO * abs(middle) and abs(middle - 1) > SAME_RATIO:
            names = [name for name, value in factors if abs(middle / float(value) - 1) <= SAME_RATIO]
            yield (f"likely cause: the {len(found)} wrong answers for {quantity} are {middle:.6g} times the exact "
                   f"ones: {' or '.join(names) or 'factor'}")


def main(arguments):
    module = "example"
    if "--answers" in arguments:
        at = arguments.index("--answers")
        module = arguments[at + 1]
        del arguments[at:at + 2]
    if len(arguments) < 2 or arguments[0] not in ("A", "B", "C", "D"):
        print("usage: driver.py A|B|C|D FILE... [--answers MODULE]", file=sys.stderr)
        return 2
    sys.path.insert(0, os.getcwd())
    answer = importlib.import_module(module).answer
    level = arguments[0]
    answered = wrong = missing = 0
    ratios = {}
    for name in arguments[1:]:
        with open(name, encoding="utf-8", newline="") as file:
            lines = list(file)
            rows = csv.DictReader(line for line in lines if not line.startswith("#"))
            if rows.fieldnames != COLUMNS:
                print(name + ": the columns are those of another pack", file=sys.stderr)
                return 2
            rows = list(rows)
            if f"# rows: {len(rows)}" not in map(str.rstrip, lines):
                print(f"{name}: the file is not whole: its line '# rows' has another number than {len(rows)}",
                      file=sys.stderr)
                return 2
            for row in rows:
                question = {key: row[key] if key in WORDS else
                            None if row[key] == "nan" else float(row[key])
                            for key in COLUMNS if key not in ANSWER}
                value = answer(question)
                if value is None:
                    missing += 1
                    continue
                answered += 1
                if not within(level, value, row):
                    wrong += 1
                    ratios.setdefault(row["quantity"].split("_")[0], []).append(float(value) / float.fromhex(row["hex"]))
                    if wrong <= MOST_SHOWN:
                        print(f"{row['id']}: {value}, exact {row['value']}")
    print(f"level {level}: {answered} answered, {wrong} wrong, {missing} not answered")
    for line in causes(ratios):
        print(line)
    return 1 if wrong else 0 if answered else 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
