// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/theory/theory.hpp"

namespace edgeproof::certificate {

Theory smooth_contact(bool symmetric) {
    Theory theory;
    theory.imports = {"Contact", "Coefficients", "Edges", "Tactics"};
    theory.names = {{"a", "a"}, {"Es", "Es"}, {"P1", "(P1 a)"}, {"P2", "(P2 a)"}, {"P3", "(P3 a)"}};
    if (symmetric) {
        theory.names.insert({{"b", "a"}, {"b1", "1"}, {"b2", "0"}, {"b3", "0"}});
    } else {
        theory.names.insert({{"b", "(b a)"}, {"b1", "(b1 a)"}, {"b2", "(b2 a)"}, {"b3", "(b3 a)"}});
    }
    theory.right = {{"r0", "r1", "r2"},
                    "right_edge_series Es g1 a r0 r1 r2",
                    "exact (right_edge _ _ _ _ _ _ _ _ _ _ contact)"};
    if (!symmetric) {
        theory.left = {{"l0", "l1", "l2"},
                       "left_edge_series Es g1 (b a) l0 l1 l2",
                       "exact (left_edge_of_a _ _ _ _ _ _ _ _ _ _ _ _ contact left)"};
    }
    return theory;
}

} // namespace edgeproof::certificate
