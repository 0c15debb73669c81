#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A boundary-element program for a contact with a half-plane, as a user writes one: elements of even
width and constant pressure, places in contact by an active set. numpy alone.

    python3 boundary_elements.py hertz.toml --elements 250 500 1000 --edge-zone 2e"""
import numpy as np

import scenes


def solve(scene, elements, _):
    ends = scene.fine(elements)
    x, h = (ends[1:] + ends[:-1]) / 2, ends[1] - ends[0]
    # The displacement at the middle of one element by a unit pressure on another, distance apart:
    # -2/(pi E*) times the integral of ln|distance - s| over it.
    z = h * (np.arange(elements)[:, None] + [-0.5, 0.5])
    by_distance = -2 / (np.pi * scene.e_star) * np.diff(z * np.log(abs(z)) - z)[:, 0]
    influence = by_distance[abs(np.subtract.outer(np.arange(elements), np.arange(elements)))]
    gap, contact = scene.gap(x), np.full(elements, True)
    while True:
        n = np.count_nonzero(contact)
        # In contact displacement + gap = approach; the pressures carry P.
        matrix = np.block([[influence[np.ix_(contact, contact)], -np.ones((n, 1))],
                           [np.full((1, n), h), np.zeros((1, 1))]])
        *pressures, approach = np.linalg.solve(matrix, np.append(-gap[contact], scene.P))
        p = np.zeros(elements)
        p[contact] = pressures
        # Those that pull leave, those that the pad would pass through come in.
        new = np.where(contact, p > 0, influence @ p + gap < approach)
        if np.array_equal(new, contact):
            return x, p
        contact = new


if __name__ == "__main__":
    scenes.main("boundary-elements", solve, "x [mm],p [MPa]")
