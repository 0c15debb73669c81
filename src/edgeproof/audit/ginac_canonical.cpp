// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/ginac_bridge.hpp"
#include "edgeproof/audit/ginac_roots.hpp"
#include "edgeproof/precision/error.hpp"

#include <ginac/ginac.h>

#include <vector>

namespace edgeproof::ginac {

using GiNaC::ex;

bool is_zero(const ex& e) {
    if (e.is_zero() || e.expand().is_zero()) {
        return true;
    }
    Roots roots;
    const ex fraction = roots.rational(e).normal();
    return roots.reduced(fraction.numer()).normal().is_zero();
}

std::vector<ex> polynomial_over_root(const ex& e, const ex& s, const ex& hi) {
    Roots roots;
    const ex whole = roots.fraction(e * GiNaC::sqrt(hi - s));
    if (whole.denom().has(s) || roots.involves(whole, s)) {
        throw DomainError("an integrand is no polynomial over the square root of the distance "
                          "from its upper end");
    }
    const ex under = whole.denom();
    const ex over = whole.numer().expand();
    std::vector<ex> q;
    for (int k = 0; k <= over.degree(s); ++k) {
        q.push_back(roots.restored(over.coeff(s, k) / under));
    }
    return q;
}

} // namespace edgeproof::ginac
