// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/enclosure/ball_contact.hpp"

#include "edgeproof/contact/enclosure/exact_contact.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/enclosure/isolate_zero.hpp"
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
    a_ = load.kind == Load::Kind::right_edge ? given : solve_right_edge_for_force(given);
    b_ = solve_left_edge(a_);
    fix();
}

void BallContact::solve(const Exact& contact_modulus, const Load& load) {
    const Ball given = constant(load.value.expr());
    // Newton's method doubles the digits: the searches begin with the edges of half as many bits.
    constexpr long fewest_bits = 128;
    if (!power_ && !profile_.symmetric() && bits_ >= 2 * fewest_bits) {
        try {
            const BallContact coarse(profile_, contact_modulus, load, bits_ / 2);
            if (coarse.known_b_) {
                lie_at({*coarse.known_a_, *coarse.known_b_});
                fix();
                return;
            }
            a_ = coarse.a_.with_bits(bits_);
            b_ = coarse.b_.with_bits(bits_);
        } catch (const BudgetError&) {
            // More bits may isolate the edges.
        }
    }
    const auto isolate = [&] {
        try {
            a_ = known_a_ ? given : solve_right_edge_for_force(given);
            b_ = solve_left_edge(a_);
            return true;
        } catch (const BudgetError&) {
            // Too few bits, or an edge on a corner, which no number of bits can isolate.
            return false;
        }
    };
    bool isolated = isolate();
    if (!isolated && certainly_positive(b_)) {
        a_ = b_ = Ball(0, bits_);
        isolated = isolate();
    }
    if (!isolated || edge_may_be_on_knot()) {
        if (!isolated) {
            a_ = known_a_ ? given : solve_right_edge_for_force(given, false);
            b_ = solve_left_edge(a_, false);
        }
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
    : ProvedContact(profile, modulus, bits) {
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
    other.move_edges(a, Ball(0, bits_));
    other.b_ = other.solve_left_edge(a);
    other.fix();
    return other;
}

BallContact BallContact::between(const Ball& a, const Ball& b) const {
    BallContact zone(*this);
    zone.move_edges(a, b);
    zone.fix();
    return zone;
}

Ball BallContact::zone_force() const {
    return modulus_ / 2 * over_linear_measure<ForceKernel>(slope_, {a_, b_}, fixed_.marks);
}

Ball BallContact::zone_rate(Edge edge) const {
    const Extent<Ball> e{a_, b_};
    return modulus_ / 2 *
           (edge == Edge::right ? over_linear_measure<RightRateKernel>(slope_, e, fixed_.marks)
                                : over_linear_measure<LeftRateKernel>(slope_, e, fixed_.marks));
}

Ball BallContact::zone_mean_slope() const {
    // The integral of (k + r s)/w between two marks, with s = c + y, h' = -1/w and w' = -y/w
    // (docs/mechanics.md); the mean slope of docs/partial-slip.md.
    const Ball c = (a_ - b_) / 2;
    const Extent<Ball> e{a_, b_};
    const std::vector<Mark<Ball>>& list = fixed_.marks;
    Ball sum(0, bits_);
    Mark<Ball> previous = end_mark(e, Edge::left);
    for (std::size_t i = 0; i <= list.size(); ++i) {
        Mark<Ball> next = i < list.size() ? list[i] : end_mark(e, Edge::right);
        const auto& piece = slope_.pieces[i];
        sum += (piece.at_origin + piece.rate * c) * (previous.h - next.h) +
               piece.rate * (previous.w - next.w);
        previous = std::move(next);
    }
    return sum / Ball::pi(bits_);
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

Ball BallContact::force_rate_of(const Extent<Ball>& e, Edge edge) const {
    return modulus_ / 2 *
           (edge == Edge::right ? over_measure<RightRateKernel>(e)
                                : over_measure<LeftRateKernel>(e));
}

Ball BallContact::solve_left_edge(const Ball& a, bool prove) const {
    if (profile_.symmetric()) {
        return a;
    }
    const Ball origin(0, bits_);
    const auto left_end = profile_.flat_end(Edge::left);
    if (left_end && known_a_ && prove) {
        try {
            return left_edge_from(origin, a, a, prove);
        } catch (const BudgetError&) {
            // The unknown is then the distance from the end of the flat, below.
        }
    }
    const auto right_end = profile_.flat_end(Edge::right);
    const Ball inset = right_end ? a - slope_.knots[*right_end] : a;
    return left_edge_from(left_end ? -slope_.knots[*left_end] : origin,
                          certainly_positive(inset) ? inset : a, a, prove);
}

// Where the minimum is a flat, the unknown is the distance of the edge from the end of the flat: on
// the flat itself the edge is not determined.
Ball BallContact::left_edge_from(const Ball& end, const Ball& start, const Ball& a,
                                 bool prove) const {
    const bool near = certainly_positive(b_ - end); // b_ is a start from a search with fewer bits
    return end + isolate_zero(
                     [&](const Ball& y) {
                         return imbalance({a, end + y});
                     },
                     // docs/mechanics.md: the derivative of the imbalance with respect to b is -B/D
                     [&](const Ball& y) {
                         const Ball b = end + y;
                         return -(over_measure<LeftRateKernel>({a, b}) / (a + b));
                     },
                     near ? b_ - end : start, "the left edge",
                     {.prove = prove, .near = near, .most_stalls = known_a_ ? 400 : 40});
}

Ball BallContact::solve_right_edge_for_force(const Ball& P, bool prove) const {
    if (power_) {
        return power_->half_width(P);
    }
    const auto end = profile_.flat_end(Edge::right);
    const Ball L = end ? slope_.knots[*end] : Ball(0, bits_);
    const bool near = certainly_positive(b_) && certainly_positive(a_ - L); // as for the left edge
    // The start P/E* is the length that the force would indent; any positive start is possible.
    return L + isolate_zero(
                   [&](const Ball& z) {
                       const Ball a = L + z;
                       return P - force_of({a, solve_left_edge(a, prove)});
                   },
                   [&](const Ball& z) {
                       const Ball a = L + z;
                       return -force_rate_of({a, solve_left_edge(a, prove)}, Edge::right);
                   },
                   near ? a_ - L : P / modulus_, "the right edge",
                   {.prove = prove, .nested = true, .near = near, .most_stalls = 40});
}

Ball BallContact::force() const { return power_ ? power_->force(a_) : force_of({a_, b_}); }

Ball BallContact::force_rate() const {
    return power_ ? power_->force_rate(a_) : force_rate_of({a_, b_}, Edge::right);
}

Ball BallContact::moment() const {
    if (profile_.symmetric()) {
        return {0, bits_};
    }
    return modulus_ / 4 * over_measure<MomentKernel>({a_, b_});
}

} // namespace edgeproof::contact
