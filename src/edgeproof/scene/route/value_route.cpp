// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/route/value_route.hpp"

#include "edgeproof/contact/profile/slope.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
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

ValueRoute::ValueRoute(const Scene& scene, const Plan& plan, Work& work)
    : scene_(scene), plan_(plan), work_(work) {
    if (auto length = refine([](BallLevel& level) { return level.length(); },
                             [](ExactValues& exact) { return exact.length(); },
                             {plan.digits.count, Rounding::nearest, false}, plan.narrow_bits)) {
        length_ = std::move(length->value);
    }
    const bool by_force = scene.load.kind != Load::Kind::right_edge;
    if (const auto given = by_force ? std::nullopt : rational_of(scene.load.value)) {
        known_[Edge::right] = *given;
        if (scene.symmetric()) {
            known_[Edge::left] = *given;
        }
    }
    if (length_) {
        if (by_force) {
            know(Edge::right);
        }
        know(Edge::left);
    }
    if (known_.size() == 2) {
        known_length_ = known_.at(Edge::right) + known_.at(Edge::left);
    }
    work.counts.consistency += scene.symmetric() ? 0 : 1;
    work.counts.tilts += scene.punch ? 1 : 0;
    work.counts.load_inversions += by_force ? 1 : 0;
    if (!length_) {
        refuse_contact();
    }
}

BoundedValue ValueRoute::value(const AskedValue& asked) {
    const QuantityRow& row = evaluated_row(asked.quantity);
    if (row.searched) {
        return RowsAt({&searched(asked), 1}).at(asked.quantity, asked.k);
    }
    if (asked.quantity == Quantity::cycle_energy && !encloses_cycle_energy(scene_)) {
        throw DomainError(
            "the energy of a cycle is not computed for a tilt that P and M determine");
    }
    if (row.of_friction() || (scene_.slips() && (row.quantity == Quantity::q || row.of_bodies()))) {
        check_slip();
    }
    count(asked);
    if (asked.quantity == Quantity::p && scene_.ask.route) {
        return by_witness(asked);
    }
    // Inside a body of revolution also a power law is integrated.
    const bool integrated = scene_.round && asked.in_body && asked.in_body->x.sign() != 0 &&
                            asked.in_body->z.sign() != 0;
    const auto proved = [&](Ball x, std::optional<Rational> exactly) {
        return BoundedValue{std::move(x), true,
                            integrated ? "rigorous integration" : row.route_in(scene_, plan_),
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
        if (const auto x = asked.quantity == Quantity::x ? known_x(asked.edge, u) : std::nullopt) {
            const long bits = length_ ? length_->bits() : plan_.bits;
            return proved(Ball(*x, std::max(bits, least_bits_of_a_place)), x);
        }
    }
    Exactly exactly;
    if (row.exact != nullptr) {
        exactly = [&](ExactValues& exact) { return row.exact(exact, asked); };
    }
    auto found = refine([&](BallLevel& level) { return row.ball(level, asked); }, exactly,
                        row.short_error ? plan_.error_digits() : plan_.digits,
                        row.cancels_little ? plan_.narrow_bits : plan_.bits);
    if (!found) {
        refuse_unknown(row, asked);
    }
    if (row.distance_of && known(*row.distance_of)) {
        found->exactly = known(*row.distance_of);
    }
    return proved(std::move(found->value), std::move(found->exactly));
}

BoundedValue ValueRoute::by_witness(const AskedValue& asked) {
    BallLevel& level = *at_level(std::max(length_->bits(), plan_.bits));
    if (!witness_) {
        witness_.emplace(scene_.punch ? level.tilt().near : *scene_.profile, scene_.contact_modulus,
                         scene_.load, plan_.digits.count);
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

const Row& ValueRoute::searched(const AskedValue& asked) {
    auto& rows = searched_[{row_of(asked.quantity).group, asked.edge, asked.k}];
    if (rows.empty()) {
        rows = search(asked);
    }
    if (const Row* row = RowsAt(rows).find(asked.quantity, asked.k, asked.j)) {
        return *row;
    }
    throw Error("a " + std::string(row_of(asked.quantity).name) + " was not found");
}

std::vector<Row> ValueRoute::search(const AskedValue& asked) {
    const AskedValue of{asked.quantity, asked.k, asked.edge, {}, scene_.ask.tolerance};
    if (row_of(asked.quantity).group == QuantityGroup::slip) {
        check_slip();
        return slip_terms(of);
    }
    ++work_.counts.extents;
    return extent(of);
}

std::optional<Rational> ValueRoute::known(Edge edge) const {
    const auto found = known_.find(edge);
    return found == known_.end() ? std::nullopt : std::optional(found->second);
}

void ValueRoute::know(Edge edge) {
    if (const auto exact = at_level(length_->bits())->contact().known(edge)) {
        if (const auto rational = rational_of(*exact)) {
            known_[edge] = *rational;
        }
    }
}

bool ValueRoute::exactly_zero(const AskedValue& asked) {
    const BallLevel* const level = length_ ? at_level(length_->bits()) : nullptr;
    switch (asked.quantity) {
    case Quantity::gap:
        return on_edge(asked.distance());
    case Quantity::ux:
    case Quantity::uz:
        return asked.reference && asked.distance() == *asked.reference;
    case Quantity::szz:
    case Quantity::sxz: { // on the free surface
        if (level == nullptr || asked.in_body->z.sign() != 0) {
            return false;
        }
        const Ball x = formula::ball_of(asked.in_body->x, level->bits());
        return certainly_less(level->a(), x) || certainly_less(level->b(), -x);
    }
    default:
        return false;
    }
}

bool ValueRoute::on_edge(const Distance& from_right) {
    if (from_right.number() && from_right.number()->sign() == 0) {
        return true;
    }
    const BallLevel* const level = length_ ? at_level(length_->bits()) : nullptr;
    const auto is_zero = [&](Edge edge) {
        const auto at = level->contact().known(edge);
        const Expr x = edge == Edge::right ? from_right.x()->expr() : -from_right.x()->expr();
        return at && contact::certainly_zero(at->expr() - x);
    };
    return level != nullptr && from_right.x() && (is_zero(Edge::right) || is_zero(Edge::left));
}

std::optional<Rational> ValueRoute::known_x(Edge edge, const Distance& u) const {
    if (const auto given = u.x() ? rational_of(*u.x()) : std::nullopt) {
        return given;
    }
    const auto from = known(edge);
    const Rational* distance = u.number() ? u.number()->expr().rational() : nullptr;
    if (!from || distance == nullptr) {
        return {};
    }
    return edge == Edge::right ? Rational(*from - *distance) : Rational(*distance - *from);
}

void ValueRoute::count(const AskedValue& asked) {
    Counts& counts = work_.counts;
    const bool similar = scene_.together();
    const auto expand = [&](bool shear) {
        counts.expansions += expanded_.insert({asked.edge, shear}).second ? 1 : 0;
    };
    switch (asked.quantity) {
    case Quantity::p:
        count_pressure();
        if (similar) {
            pressed_.emplace(asked.edge, asked.distance());
        }
        break;
    case Quantity::q:
        // A traction similar to p uses the pressure that was computed just before.
        if (similar && pressed_ != std::pair(asked.edge, asked.distance())) {
            count_pressure();
        }
        pressed_.reset();
        break;
    case Quantity::s:
    case Quantity::q_local:
    case Quantity::q_rel:
        expand(true);
        if (!similar) {
            break;
        }
        [[fallthrough]];
    case Quantity::c:
    case Quantity::local:
    case Quantity::rel:
        expand(false);
        break;
    case Quantity::stick_a:
        ++counts.stick_zones;
        break;
    default:
        break;
    }
}

std::unique_ptr<ValueRoute> make_route(const Scene& scene, const Plan& plan, Work& work) {
    if (scene.ask.route && scene.profile && scene.profile->axisymmetric()) {
        throw InputError("an axisymmetric contact has no route " + route_name(*scene.ask.route),
                         "write route = \"automatic\"")
            .at(scene.file, scene.ask_line);
    }
    try {
        auto route = std::make_unique<ValueRoute>(scene, plan, work);
        route->check_slope();
        return route;
    } catch (const InputError& error) {
        throw error.file().empty() ? error.at(scene.file, scene.load_line) : error;
    }
}

long ValueRoute::last_bits() const {
    const long curved = 8 * plan_.bits; // integrals cost more
    return closed() ? std::max(least_last_bits, curved) : curved;
}

std::optional<ValueRoute::Found> ValueRoute::refine(const InBalls& f, const Exactly& exactly,
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

std::optional<Rational> ValueRoute::exact_value(const Exactly& exactly, const BallLevel& level,
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

ExactValues* ValueRoute::exact_values(const BallLevel& level) {
    const bool of_revolution = scene_.profile && scene_.profile->axisymmetric();
    if (!exact_ && !of_revolution && (!scene_.punch || level.tilt().exactly_zero)) {
        exact_.emplace(scene_, scene_.punch ? level.tilt().near : *scene_.profile, level.a(),
                       level.b(), plan_.terms);
    }
    return exact_ ? &*exact_ : nullptr;
}

BallLevel* ValueRoute::at_level(long bits) {
    if (const auto made = levels_.find(bits); made != levels_.end()) {
        return made->second.get();
    }
    work_.raised += bits > plan_.bits ? 1 : 0;
    auto& slot = levels_[bits];
    try {
        slot = std::make_unique<BallLevel>(scene_, plan_, edges_, bits);
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
