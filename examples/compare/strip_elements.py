#!/usr/bin/env python3
"""A boundary-element program as a user would write it: cylinders in contact, elements of even width
with constant pressure, an active set. Writes x and p of the elements' middles.

    python3 strip_elements.py N [E_STAR] > mesh-N.csv

Each body is a half-plane, so that the only error is the mesh's. Pure Python: no packages."""
import math
import sys

R = 1 / (1 / 100 + 1 / 300)  # mm
P = 500.0                    # N/mm
E_STAR = 115e3 / (2 * (1 - 0.33**2))  # MPa
HALF_WIDTH = 1.2             # mm, of the mesh


def solve(matrix, right):
    """Gauss's elimination with pivots."""
    n = len(right)
    rows = [matrix[i] + [right[i]] for i in range(n)]
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        for i in range(k + 1, n):
            factor = rows[i][k] / rows[k][k]
            if factor != 0:
                rows[i] = [0.0] * (k + 1) + [rows[i][j] - factor * rows[k][j] for j in range(k + 1, n + 1)]
    x = [0.0] * n
    for k in range(n - 1, -1, -1):
        x[k] = (rows[k][n] - sum(rows[k][j] * x[j] for j in range(k + 1, n))) / rows[k][k]
    return x


def pressures(elements, e_star):
    h = 2 * HALF_WIDTH / elements
    places = [-HALF_WIDTH + (i + 0.5) * h for i in range(elements)]

    def influence(distance):
        """-(2/(pi E*)) times the integral of ln|distance - s| over an element."""
        def integral(z):
            return z * math.log(abs(z)) - z
        return -2 / (math.pi * e_star) * (integral(distance + h / 2) - integral(distance - h / 2))

    table = [influence(k * h) for k in range(elements)]
    active = list(range(elements))
    while True:
        # p of the active elements and the approach: displacement + approach = x^2/(2R), sum p h = P.
        matrix = [[table[abs(i - j)] for j in active] + [-1.0] for i in active]
        matrix.append([h] * len(active) + [0.0])
        right = [-places[i] ** 2 / (2 * R) for i in active] + [P]
        solution = solve(matrix, right)
        if all(p >= 0 for p in solution[:-1]):
            break
        active = [i for i, p in zip(active, solution) if p > 0]
    p = [0.0] * elements
    for i, value in zip(active, solution):
        p[i] = value
    return places, p


if __name__ == "__main__":
    count = int(sys.argv[1])
    modulus = float(sys.argv[2]) if len(sys.argv) > 2 else E_STAR
    print("COORD1 [mm],CPRESS [MPa]")
    for place, pressure in zip(*pressures(count, modulus)):
        print(f"{place:.6f},{pressure:.6E}")
