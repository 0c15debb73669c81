// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/scene/route/scene_values.hpp"

#include "edgeproof/contact/profile/slope.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <utility>

namespace edgeproof::scene {

namespace {

/// The fewest bits of a ball around a known place. Such a value is printed from its exact form, so
/// that a ball of any width suffices.
constexpr long least_bits_of_a_place = 128;

/// A value within 1e-400 of zero on the contact's own scale, not known to cancel, is left
/// undecided.
constexpr long zero_bits = 1330;
constexpr long most_lost_bits = 1L << 17;
/// A value that is still infinite at this number of bits is refused.
constexpr long least_last_bits = 1L << 14;

} // namespace

SceneValues::SceneValues(const Scene& scene, const std::vector<AskedValue>& values,
                         const Digits& digits)
    : SceneValues(asking(scene, values, digits)) {}

SceneValues::SceneValues(Scene scene) : scene_(std::move(scene)), plan_(make_plan(scene_)) {
    if (scene_.ask.route && scene_.profile && scene_.profile->axisymmetric()) {
        throw InputError("an axisymmetric contact has no route " + route_name(*scene_.ask.route),
                         "write route = \"automatic\"")
            .at(scene_.file, scene_.ask_line);
    }
    try {
        solve();
        check_slope();
    } catch (const InputError& error) {
        throw error.file().empty() ? error.at(scene_.file, scene_.load_line) : error;
    }
}

void SceneValues::solve() {
    if (auto length =
            refine([](BallLevel& level) { return level.length(); },
                   [](ExactValues& exact) { return exact.length(); },
                   {scene_.ask.digits.count, Rounding::nearest, false}, plan_.narrow_bits)) {
        length_ = std::move(length->value);
        first_ = at_level(length_.bits());
    } else {
        refuse_contact();
    }
    const auto a = known(Edge::right);
    const auto b = known(Edge::left);
    known_length_ = a && b ? std::optional(Rational(*a + *b)) : std::nullopt;
}

BoundedValue SceneValues::value(const AskedValue& asked) {
    const QuantityRow& row = row_of(asked.quantity);
    if (row.searched) {
        const Row& found = searched(asked);
        if (asked.quantity == Quantity::extent && !found.reached) {
            throw DomainError("there is no first exit: the terms stay within the tolerance");
        }
        return RowsAt({&found, 1}).at(asked.quantity, asked.k);
    }
    if (asked.quantity == Quantity::cycle_energy && !scene_.profile) {
        throw DomainError(
            "the energy of a cycle is not computed for a tilt that P and M determine");
    }
    if (row.of_friction() || (scene_.slips() && (row.quantity == Quantity::q || row.of_bodies()))) {
        check_slip();
    }
    if (asked.quantity == Quantity::p && scene_.ask.route) {
        return by_witness(asked);
    }
    // Inside a body of revolution also a power law is integrated.
    const bool integrated =
        scene_.round && asked.in_body && !asked.in_body->x.is_zero() && !asked.in_body->z.is_zero();
    const auto proved = [&](Ball x, std::optional<Rational> exactly) {
        return BoundedValue{std::move(x), true,
                            integrated ? "rigorous integration" : row.route_in(scene_),
                            std::move(exactly)};
    };
    const Exact* given = row.given != nullptr ? row.given(scene_) : nullptr;
    if (const auto q = given != nullptr ? rational_of(*given) : std::nullopt) {
        return proved(Ball(*q, plan_.bits), q); // an enclosure would never round down or up
    }
    if (exactly_zero(asked)) {
        return proved(Ball(0, plan_.bits), Rational(0));
    }
    if (asked.quantity == Quantity::x || asked.quantity == Quantity::u) {
        const Distance u = asked.distance();
        refuse_outside(asked.edge, u);
        if (const auto x =
                asked.quantity == Quantity::x ? first_->known_x(asked.edge, u) : std::nullopt;
            x && rational_of(*x)) {
            const Rational at = *rational_of(*x);
            return proved(Ball(at, std::max(length_.bits(), least_bits_of_a_place)), at);
        }
    }
    Exactly exactly;
    if (row.exact != nullptr) {
        exactly = [&](ExactValues& exact) { return row.exact(exact, asked); };
    }
    auto found = refine([&](BallLevel& level) { return row.ball(level, asked); }, exactly,
                        digits_of(asked.quantity, scene_.ask.digits),
                        row.cancels_little ? plan_.narrow_bits : plan_.bits);
    if (!found) {
        refuse_unknown(row, asked);
    }
    if (const auto q = row.distance_of ? known(*row.distance_of) : std::nullopt) {
        found->exactly = q;
    }
    return proved(std::move(found->value), std::move(found->exactly));
}

BoundedValue SceneValues::x(const AskedValue& asked) {
    if (asked.u->sign() <= 0) {
        throw DomainError("the point lies outside the contact");
    }
    AskedValue place = asked;
    place.quantity = Quantity::x;
    return value(place);
}

BoundedValue SceneValues::by_witness(const AskedValue& asked) {
    BallLevel& level = *at_level(std::max(length_.bits(), plan_.bits));
    if (!witness_) {
        witness_.emplace(scene_.punch ? level.tilt().near : *scene_.profile, scene_.contact_modulus,
                         scene_.load, scene_.ask.digits.count);
    }
    const Distance u = asked.distance();
    refuse_outside(asked.edge, u);
    const auto at = [&](const Exact& from) {
        const auto p = witness_->pressure(asked.edge, from, *scene_.ask.route);
        const PrecisionScope scope(p.working_digits);
        return estimated(p.value, Real(abs(p.value) * p.estimate), route_name(*scene_.ask.route));
    };
    if (u.number()) {
        return at(*u.number());
    }
    // A place that depends on the edges: at both ends of its enclosure.
    const Ball from = level.distance(u);
    const BoundedValue one = at(Exact::of(contact::exact_value(from.lower())));
    const BoundedValue other = at(Exact::of(contact::exact_value(from.upper())));
    return {Ball::hull(one.value, other.value), false, one.route};
}

const Row& SceneValues::searched(const AskedValue& asked) {
    if (const Row* row = RowsAt(search(asked)).find(asked.quantity, asked.k, asked.j)) {
        return *row;
    }
    throw Error("a " + std::string(row_of(asked.quantity).name) + " was not found");
}

const std::vector<Row>& SceneValues::search(const AskedValue& asked) {
    const QuantityGroup group = row_of(asked.quantity).group;
    std::vector<Row>& rows = searched_[{group, asked.edge, asked.k}];
    if (rows.empty()) {
        const AskedValue of{asked.quantity, asked.k, asked.edge, {}, scene_.ask.tolerance};
        rows = group == QuantityGroup::slip ? slip_terms(of) : extent(of);
    }
    return rows;
}

std::optional<Rational> SceneValues::known(Edge edge) const {
    const auto exact = first_->contact().known(edge);
    return exact ? rational_of(*exact) : std::nullopt;
}

bool SceneValues::exactly_zero(const AskedValue& asked) {
    switch (asked.quantity) {
    case Quantity::gap:
        return on_edge(asked.distance());
    case Quantity::ux:
    case Quantity::uz:
        return asked.reference && asked.distance() == *asked.reference;
    case Quantity::szz:
    case Quantity::sxz: { // on the free surface
        if (!asked.in_body->z.is_zero()) {
            return false;
        }
        const Ball x = asked.in_body->x.enclosure(first_->a(), first_->b(), first_->bits());
        return certainly_less(first_->a(), x) || certainly_less(first_->b(), -x);
    }
    default:
        return false;
    }
}

bool SceneValues::on_edge(const Distance& from_right) {
    if (from_right.number() && from_right.number()->sign() == 0) {
        return true;
    }
    const auto is_zero = [&](Edge edge) {
        const auto at = first_->contact().known(edge);
        const Expr x = edge == Edge::right ? from_right.x()->expr() : -from_right.x()->expr();
        return at && contact::certainly_zero(at->expr() - x);
    };
    return from_right.x() && (is_zero(Edge::right) || is_zero(Edge::left));
}

long SceneValues::last_bits() const {
    const long curved = 8 * plan_.bits; // integrals cost more
    return scene_.closed() ? std::max(least_last_bits, curved) : curved;
}

std::optional<SceneValues::Found> SceneValues::refine(const InBalls& f, const Exactly& exactly,
                                                      const Digits& digits, long first, long lost) {
    std::optional<Found> best;
    bool looked = exactly == nullptr;
    const long zero_from =
        plan_.bits + zero_bits + std::min(std::max(lost, lost_bits_), most_lost_bits);
    const long last = scene_.closed() ? std::max(last_bits(), 2 * zero_from) : last_bits();
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

std::optional<Rational> SceneValues::exact_value(const Exactly& exactly, const BallLevel& level,
                                                 const Ball& near) {
    try {
        ExactValues* exact = exact_values(level);
        auto q = exact != nullptr ? exactly(*exact).rational() : std::nullopt;
        return q && contains(near, *q) ? q : std::nullopt;
    } catch (const Error&) { // no exact form
        return {};
    }
}

ExactValues* SceneValues::exact_values(const BallLevel& level) {
    const bool of_revolution = scene_.profile && scene_.profile->axisymmetric();
    if (!exact_ && !of_revolution && (!scene_.punch || level.tilt().exactly_zero)) {
        exact_.emplace(scene_, scene_.punch ? level.tilt().near : *scene_.profile, level.a(),
                       level.b(), plan_.terms);
    }
    return exact_ ? &*exact_ : nullptr;
}

BallLevel* SceneValues::at_level(long bits) {
    if (const auto made = levels_.find(bits); made != levels_.end()) {
        return made->second.get();
    }
    auto& slot = levels_[bits];
    try {
        slot = std::make_unique<BallLevel>(scene_, bits, plan_.terms, edges_);
        const auto a = slot->contact().known(Edge::right);
        const auto b = slot->contact().known(Edge::left);
        if (a && b && !scene_.symmetric()) {
            edges_ = contact::ExactEdges{*a, *b};
        }
    } catch (const BudgetError&) {
    } catch (const DomainError& error) {
        no_contact_ = error.what();
    }
    return slot.get();
}

} // namespace edgeproof::scene
