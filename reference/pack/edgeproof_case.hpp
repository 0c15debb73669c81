// SPDX-License-Identifier: BSD-3-Clause
// A question of the conformance pack, and the function that answers it. README.md explains both.
#pragma once
#include <optional>
#include <string>

struct EdgeproofCase {
    std::string id;
    std::string kind;     // power-law, flat-and-rounded, tilted-wedge, tilted-flat-and-rounded
    std::string edge;     // right, left, none
    std::string quantity; // p, q, c_0, s_0, ..., a, b, P, M, alpha
    double m, C, phi, alpha, t, R; // profile; NaN where it has none of that name
    double a, P, M, E;             // load: a, or P (and M); contact modulus
    double Q, S;                   // shear force and bulk tension; NaN where there is no shear
    double u;                      // distance inwards from the edge; NaN where there is none
};

// Yours: nothing where your code does not have this.
std::optional<double> edgeproof_answer(const EdgeproofCase& question);
