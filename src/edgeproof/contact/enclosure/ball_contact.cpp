// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/enclosure/ball_contact.hpp"

#include "edgeproof/contact/enclosure/exact_contact.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/precision/error.hpp"

#include <optional>

namespace edgeproof::contact {
BallContact::BallContact(const Profile& profile, const Exact& contact_modulus, const Load& load,
                         long bits)
    : BallContact(profile, enclosed_constant(contact_modulus, bits), bits) {
    if (load.kind == Load::Kind::right_edge) {
        known_a_ = load.value;
        find_knots_on_edges();
    }
    solve(contact_modulus, load);
}

BallContact::BallContact(const Profile& profile, const Exact& contact_modulus,
                         const ExactEdges& edges, long bits)
    : BallContact(profile, enclosed_constant(contact_modulus, bits), bits) {
    lie_at(edges);
    fix();
}

void BallContact::lie_at(const ExactEdges& edges) {
    known_a_ = edges.a;
    known_b_ = edges.b;
    a_ = constant(edges.a.expr());
    b_ = constant(edges.b.expr());
    find_knots_on_edges();
}

BallContact::BallContact(const Profile& near, const Ball& alpha, const Exact& contact_modulus,
                         const Load& load, long bits)
    : BallContact(near, enclosed_constant(contact_modulus, bits), bits) {
    tilt_by(alpha);
    const Ball given = constant(load.value.expr());
    const bool by_force = load.kind == Load::Kind::force;
    isolate(by_force ? equations(given, {}) : equations({}, given));
    fix();
}

void BallContact::solve(const Exact& contact_modulus, const Load& load) {
    const Ball given = constant(load.value.expr());
    if (power_ || (known_a_ && profile_.symmetric())) {
        a_ = known_a_ ? given : power_->half_width(given);
        b_ = a_;
        fix();
        return;
    }
    const ZoneEquations wanted = known_a_ ? equations({}, given) : equations(given, {});
    std::optional<BallZone> zone;
    // Newton's method doubles the digits: the search begins with the edges of half as many bits.
    constexpr long fewest_bits = 128;
    if (bits_ >= 2 * fewest_bits) {
        try {
            const BallContact coarse(profile_, contact_modulus, load, bits_ / 2);
            if (coarse.known_b_) {
                lie_at({*coarse.known_a_, *coarse.known_b_});
                fix();
                return;
            }
            zone = {coarse.a_.with_bits(bits_), coarse.b_.with_bits(bits_)};
        } catch (const BudgetError&) {
            // More bits may isolate the edges.
        }
    }
    const auto isolate = [&] {
        try {
            zone = wanted.search(*zone);
            zone = wanted.proved(*zone);
            return true;
        } catch (const BudgetError&) {
            // Too few bits, or an edge on a corner, which no number of bits can isolate.
            return false;
        }
    };
    bool isolated = zone && isolate();
    if (!isolated) {
        zone = from_afar(wanted);
        isolated = isolate();
    }
    a_ = known_a_ ? given : zone->a;
    b_ = zone->b;
    if (!isolated || edge_may_be_on_knot()) {
        if (const auto exact = exact_edges(profile_, contact_modulus, load, a_, b_)) {
            lie_at(*exact);
        } else if (!isolated) {
            throw BudgetError("ball arithmetic at " + std::to_string(bits_) +
                              " bits does not isolate the edges");
        }
    }
    fix();
}

Ball BallContact::minimum_end(Edge edge) const {
    const auto end = power_ ? std::nullopt : profile_.flat_end(edge);
    if (!end) {
        return {0, bits_};
    }
    return edge == Edge::right ? slope_.knots[*end] : -slope_.knots[*end];
}

/// g' of Profile::tilted_wedge (moore-hills EQ26) and Profile::tilted_flat_and_rounded (moore-hills
/// EQ33), with alpha > 0 in the latter.
void BallContact::tilt_by(const Ball& alpha) {
    const auto given = [&](const char* name) {
        return constant(profile_.parameters().at(name).expr());
    };
    if (profile_.kind() == Profile::Kind::tilted_wedge) {
        slope_.pieces[0].at_origin = -(given("phi") + alpha);
        slope_.pieces[1].at_origin = given("phi") - alpha;
    } else if (profile_.kind() == Profile::Kind::tilted_flat_and_rounded &&
               slope_.knots.size() == 3) {
        const Ball flat_end = -(alpha * given("R"));
        slope_.knots[0] = flat_end - given("t") * 2;
        slope_.knots[1] = flat_end;
        slope_.pieces[1].at_origin = -alpha;
    } else {
        throw DomainError("only a tilted wedge or a tilted flat has a tilt");
    }
    slope_.find_jumps();
}

BallContact::BallContact(const Profile& profile, const Ball& modulus, long bits)
    : PlaneContact(profile, modulus, bits) {
    if (!profile.has_closed_form()) {
        throw DomainError("only a piecewise linear slope or a power law has a closed form");
    }
    if (!profile.piecewise_linear()) {
        const Exact& exponent = profile.parameters().at("m");
        const Ball m = constant(exponent.expr());
        power_law_integral_.emplace(exponent, m);
        const Ball C = constant(profile.parameters().at("C").expr());
        // moore-hills EQ11
        power_ = PowerLaw<Ball>{m, modulus_ * C * sqrt(Ball::pi(bits_)) / 2 * gamma(m / 2 + 1) /
                                       gamma((m + 3) / 2)};
    }
}

bool BallContact::bends(std::size_t knot) const {
    const auto& before = profile_.pieces()[knot].linear;
    const auto& after = profile_.pieces()[knot + 1].linear;
    return !power_ && !(before->rate == after->rate && before->at_origin == after->at_origin);
}

std::vector<Mark<Ball>> BallContact::marks(const Extent<Ball>& e) const {
    std::vector<Mark<Ball>> list;
    list.reserve(slope_.knots.size());
    for (std::size_t i = 0; i < slope_.knots.size(); ++i) {
        list.push_back(on_edge_[i] ? end_mark(e, *on_edge_[i]) : clamped_mark(e, slope_.knots[i]));
    }
    return list;
}

BallContact BallContact::with_right_edge(const Ball& a) const {
    BallContact other(*this);
    other.move_edges(a, a);
    other.isolate(other.equations({}, a));
    other.fix();
    return other;
}

BallContact BallContact::between(const Ball& a, const Ball& b) const {
    BallContact zone(*this);
    zone.zone_ = true;
    zone.move_edges(a, b);
    zone.fix();
    return zone;
}

ZoneValues BallContact::values_of(const BallZone& zone) const {
    const Extent<Ball> e{zone.a, zone.b};
    const std::vector<Mark<Ball>> list = marks(e);
    return {modulus_ / 2 * over_linear_measure<ForceKernel>(slope_, e, list),
            slope_over_angle(slope_, e, list) / Ball::pi(bits_)}; // the mean slope
}

ZoneRates BallContact::rates_of(const BallZone& zone) const {
    const Extent<Ball> e{zone.a, zone.b};
    const std::vector<Mark<Ball>> list = marks(e);
    return {modulus_ / 2 * over_linear_measure<RightRateKernel>(slope_, e, list),
            modulus_ / 2 * over_linear_measure<LeftRateKernel>(slope_, e, list)};
}

BallContact BallContact::mirrored() const {
    BallContact m(*this);
    m.mirror();
    m.fix();
    return m;
}

template <class Kernel> Ball BallContact::over_measure(const Extent<Ball>& e) const {
    return over_linear_measure<Kernel>(slope_, e, marks(e));
}

Ball BallContact::imbalance(const Extent<Ball>& e) const {
    return linear_imbalance(slope_, e, marks(e));
}

Ball BallContact::force_of(const Extent<Ball>& e) const {
    // moore-hills EQ22, by docs/mechanics.md, "One measure, six kernels"
    return modulus_ / 2 * over_measure<ForceKernel>(e);
}

// The mean slope of a zone about the origin by the consistency condition, which cancels less.
ZoneEquations BallContact::equations(const std::optional<Ball>& force,
                                     const std::optional<Ball>& right_edge) const {
    const bool by_force = force.has_value();
    return {.values =
                [this, by_force](const BallZone& zone) {
                    const Extent<Ball> e{zone.a, zone.b};
                    return ZoneValues{by_force ? force_of(e) : Ball(0, bits_),
                                      imbalance(e) / Ball::pi(bits_)};
                },
            .rates = [this](const BallZone& zone) { return rates_of(zone); },
            .modulus = modulus_,
            .tilt = Ball(0, bits_),
            .force = force,
            .right_edge = right_edge,
            .symmetric = profile_.symmetric()};
}

// Where the minimum is a flat, the unknowns are the distances of the edges from its ends: on the
// flat itself the edges are not determined. P/E* is the length that the force would indent; any
// positive start is possible.
BallZone BallContact::from_afar(const ZoneEquations& wanted) const {
    const Ball a_from = minimum_end(Edge::right);
    Ball first = wanted.force ? *wanted.force / modulus_ : *wanted.right_edge - a_from;
    if (!certainly_positive(first)) {
        first = *wanted.right_edge;
    }
    return wanted.from_afar({a_from, minimum_end(Edge::left), first}, bits_ / 2);
}

void BallContact::isolate(const ZoneEquations& wanted) {
    if (wanted.right_edge && wanted.symmetric) {
        a_ = b_ = *wanted.right_edge;
        return;
    }
    const BallZone zone = wanted.proved(wanted.search(from_afar(wanted)));
    a_ = zone.a;
    b_ = zone.b;
}

Ball BallContact::force() const { return power_ ? power_->force(a_) : force_of({a_, b_}); }

Ball BallContact::force_rate() const {
    return power_ ? power_->force_rate(a_) : rates_of({a_, b_}).right;
}

Ball BallContact::moment() const {
    if (about_origin()) {
        return {0, bits_};
    }
    return modulus_ / 4 * over_measure<MomentKernel>({a_, b_});
}

} // namespace edgeproof::contact
