// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/quadrature/gauss_legendre.hpp"

#include "edgeproof/precision/ball/ball.hpp"

#include <map>
#include <mutex>
#include <utility>

namespace edgeproof::quadrature {
namespace {

Real rounded(const Ball& x, long bits) {
    Real r;
    mpfr_set_prec(r.backend().data(), bits);
    arf_get_mpfr(r.backend().data(), arb_midref(x.data()), MPFR_RNDN);
    return r;
}

std::shared_ptr<const GaussLegendreRule> build(std::size_t n, long bits) {
    auto rule = std::make_shared<GaussLegendreRule>();
    rule->n = n;
    // 1 - x is about 1.4/n^2 at the outermost node.
    long guard = 16;
    for (std::size_t k = n; k > 1; k /= 2) {
        guard += 2;
    }
    Ball x(0, bits + guard);
    Ball w(0, bits + guard);
    for (std::size_t k = 0; 2 * k < n; ++k) {
        arb_hypgeom_legendre_p_ui_root(x.data(), w.data(), n, k, bits + guard);
        rule->x.push_back(rounded(x, bits));
        rule->from_end.push_back(rounded(1 - x, bits));
        rule->weight.push_back(rounded(w, bits));
    }
    return rule;
}

/// One slot a table, so that a long table being built keeps nobody else waiting.
struct Slot {
    std::once_flag once;
    std::shared_ptr<const GaussLegendreRule> rule;
};

} // namespace

std::shared_ptr<const GaussLegendreRule> gauss_legendre_rule(std::size_t n, long bits) {
    static std::mutex guard;
    static std::map<std::pair<std::size_t, long>, std::shared_ptr<Slot>> slots;
    std::shared_ptr<Slot> slot;
    {
        const std::lock_guard lock(guard);
        auto& found = slots[{n, bits}];
        if (!found) {
            found = std::make_shared<Slot>();
        }
        slot = found;
    }
    std::call_once(slot->once, [&] { slot->rule = build(n, bits); });
    return slot->rule;
}

} // namespace edgeproof::quadrature
