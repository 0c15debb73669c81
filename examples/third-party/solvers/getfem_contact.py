#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""GetFEM (Debian's python3-getfem): quadratic displacements, the contact pressure as a linear multiplier
on the upper side, the contact condition by Alart and Curnier's augmented Lagrangian. The load is P
itself, by the pad's approach as an unknown of its own.

    python3 getfem_contact.py hertz.toml --elements 30 60 120 --edge-zone 2e"""
import sys

import numpy as np

import scenes

try:
    import getfem
except ImportError:
    getfem = None

OUTSIDE, UNDER_PAD = 1, 2


def solve(scene, elements, arguments):
    if getfem is None:
        scenes.skip("Python has no package getfem (python3-getfem)")
    getfem.util_trace_level(0)
    x, y = scene.grid(elements, arguments.size, growth=8)
    mesh = getfem.Mesh("cartesian", x, y)
    mesh.set_region(OUTSIDE, np.hstack([mesh.outer_faces_with_direction(normal, 0.01)
                                        for normal in ([0, -1], [1, 0], [-1, 0])]))
    middle, half = [scene.centre, 0], [scenes.FINE * 1.001, 1e-6]
    mesh.set_region(UNDER_PAD, mesh.outer_faces_in_box(np.subtract(middle, half), np.add(middle, half)))

    displacement, everywhere = getfem.MeshFem(mesh, 2), getfem.MeshFem(mesh, 1)
    displacement.set_classical_fem(2)
    everywhere.set_classical_fem(1)
    nodes = everywhere.basic_dof_on_region(UNDER_PAD)
    pressure = getfem.MeshFem("partial", everywhere, nodes)
    places = everywhere.basic_dof_nodes()[0, nodes]
    rule = getfem.MeshIm(mesh, getfem.Integ("IM_GAUSS_PARALLELEPIPED(2,6)"))

    model = getfem.Model("real")
    model.add_fem_variable("u", displacement)
    model.add_fem_variable("p", pressure)
    model.add_variable("approach", 1)
    model.set_variable("approach", [scene.gap(places).max()])  # begins with all of the pad in contact
    for name, value in scene.lame().items():
        model.add_initialized_data(name, [value])
    model.add_isotropic_linearized_elasticity_brick(rule, "u", "lambda", "mu")
    outside = np.zeros(displacement.nbdof())
    if not arguments.clamped:
        dofs = displacement.basic_dof_on_region(OUTSIDE)
        both = scene.half_plane(*displacement.basic_dof_nodes()[:, dofs])
        outside[dofs] = np.where(dofs % 2 == 0, *both)
    model.add_initialized_fem_data("outside", displacement, outside)
    model.add_Dirichlet_condition_with_simplification("u", OUTSIDE, "outside")
    s = f"(X(1)-({scene.centre!r}))"
    gap = f"sqr(pos_part(abs({s})-{scene.t!r}))/{2 * scene.R!r}-{scene.alpha!r}*{s}+{scene.lowest!r}"
    # p presses the body down; where it presses, the gap is closed; all of it is P. r = mu per mm.
    model.add_nonlinear_term(rule, f"p*Test_u(2)+(p-pos_part(p+mu*(u(2)+approach-({gap}))))*Test_p"
                             "+p*Test_approach", UNDER_PAD)
    model.add_explicit_rhs("approach", [scene.P])
    _, converged = model.solve("max_res", 1e-7 * scene.P, "max_iter", 30, "lsolver", "mumps")
    if not converged:
        sys.exit("getfem_contact.py: Newton's iteration did not converge")
    order = np.argsort(places)
    return places[order], model.variable("p")[order]


if __name__ == "__main__":
    scenes.main("getfem", solve, "x [mm],pressure [MPa]", scenes.BODY)
