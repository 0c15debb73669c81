// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/route/ball_route.hpp"

#include <algorithm>
#include <utility>

namespace edgeproof::scene {
namespace {

/// A value within 1e-400 of zero on the contact's own scale, not known to cancel, is left
/// undecided.
constexpr long zero_bits = 1330;
constexpr long most_lost_bits = 1L << 17;
/// A value that is still infinite at this number of bits is left to the routes in Real, which
/// refuse it.
constexpr long least_last_bits = 1L << 14;

} // namespace

long BallRoute::last_bits() const {
    const long curved = 8 * plan_.bits; // integrals cost more
    return closed() ? std::max(least_last_bits, curved) : curved;
}

std::optional<BallRoute::Found> BallRoute::refine(const InBalls& f, const Exactly& exactly,
                                                  const Digits& digits, long first, long lost) {
    std::optional<Found> best;
    bool looked = exactly == nullptr;
    const long zero_from =
        plan_.bits + zero_bits + std::min(std::max(lost, lost_bits_), most_lost_bits);
    const long last = closed() ? std::max(last_bits(), 2 * zero_from) : last_bits();
    for (long bits = first; bits <= last; bits = bits < plan_.bits ? plan_.bits : 2 * bits) {
        BallLevel* level = at_level(bits);
        if (level == nullptr) {
            continue;
        }
        Ball x = f(*level);
        if (!x.is_finite()) {
            if (level->contact().edge_may_be_on_knot() && bits >= plan_.bits + zero_bits) {
                break; // no number of bits separates the edge from the knot
            }
            continue;
        }
        best = Found{std::move(x)};
        const bool all_digits = has_digits(best->value, digits);
        if (!looked && may_be_a_limit(best->value, digits, all_digits)) {
            looked = true;
            best->exactly = exact_value(exactly, *level, best->value);
        }
        if (best->exactly || all_digits || (contains_zero(best->value) && bits >= zero_from)) {
            break;
        }
    }
    return best;
}

std::optional<Rational> BallRoute::exact_value(const Exactly& exactly, const BallLevel& level,
                                               const Ball& near) {
    ExactValues* exact = exact_values(level);
    if (exact == nullptr) {
        return {};
    }
    try {
        auto q = exactly(*exact).rational();
        return q && contains(near, *q) ? q : std::nullopt;
    } catch (const DomainError&) { // the exact form does not have this series
        return {};
    }
}

ExactValues* BallRoute::exact_values(const BallLevel& level) {
    const bool of_revolution = scene_.profile && scene_.profile->axisymmetric();
    if (!exact_ && !of_revolution && (!scene_.punch || level.tilt().exactly_zero)) {
        exact_.emplace(scene_, scene_.punch ? level.tilt().near : *scene_.profile, level.a(),
                       level.b(), plan_.terms);
    }
    return exact_ ? &*exact_ : nullptr;
}

BallLevel* BallRoute::at_level(long bits) {
    if (const auto made = levels_.find(bits); made != levels_.end()) {
        return made->second.get();
    }
    work_.raised += bits > plan_.bits ? 1 : 0;
    auto& slot = levels_[bits];
    try {
        slot = std::make_unique<BallLevel>(scene_, plan_, edges_, bits);
        const auto a = slot->contact().known(contact::Edge::right);
        const auto b = slot->contact().known(contact::Edge::left);
        if (a && b && !scene_.symmetric()) {
            edges_ = contact::ExactEdges{*a, *b};
        }
    } catch (const BudgetError&) {
    } catch (const DomainError&) {
    }
    return slot.get();
}

} // namespace edgeproof::scene
