// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/quadrature/gauss_legendre.hpp"
#include "edgeproof/precision/bounded_cache.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <mutex>
#include <utility>

namespace edgeproof::quadrature {
namespace {

GaussLegendreBalls build(std::size_t n, long bits) {
    GaussLegendreBalls rule;
    for (std::size_t k = 0; 2 * k < n; ++k) {
        check_interruption();
        Ball x(0, bits);
        Ball w(0, bits);
        // `johansson-mezzarobba2018`
        arb_hypgeom_legendre_p_ui_root(x.data(), w.data(), n, k, bits);
        rule.x.push_back(std::move(x));
        rule.weight.push_back(std::move(w));
    }
    return rule;
}

/// One slot for each table, so that threads that need another table do not wait while one is built.
struct Slot {
    std::once_flag once;
    GaussLegendreBalls rule;
};

struct Tables {
    static constexpr std::size_t most = 64;
    std::mutex guard;
    BoundedCache<std::pair<std::size_t, long>, Slot> slots{most};
};
Tables& tables() {
    static Tables all;
    return all;
}

} // namespace

std::shared_ptr<const GaussLegendreBalls> gauss_legendre_balls(std::size_t n, long bits) {
    std::shared_ptr<Slot> slot;
    {
        const std::lock_guard lock(tables().guard);
        slot = tables().slots.get({n, bits}, [] { return std::make_shared<Slot>(); });
    }
    std::call_once(slot->once, [&] { slot->rule = build(n, bits); });
    return {slot, &slot->rule};
}

} // namespace edgeproof::quadrature
