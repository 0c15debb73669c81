// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/quadrature/gauss_legendre.hpp"

#include "edgeproof/precision/bounded_cache.hpp"
#include "edgeproof/precision/interruption.hpp"

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

} // namespace

std::shared_ptr<const GaussLegendreBalls> gauss_legendre_balls(std::size_t n, long bits) {
    constexpr std::size_t most_rules = 64;
    thread_local BoundedCache<std::pair<std::size_t, long>, const GaussLegendreBalls> rules(
        most_rules);
    return rules.get({n, bits},
                     [&] { return std::make_shared<const GaussLegendreBalls>(build(n, bits)); });
}

} // namespace edgeproof::quadrature
