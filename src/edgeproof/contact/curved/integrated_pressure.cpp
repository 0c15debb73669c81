// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/curved/curved_slope.hpp"
#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"

#include <algorithm>

namespace edgeproof::contact {
namespace {

constexpr std::size_t least_terms = 32; ///< number of terms of a disk
constexpr long point_bits = 16;         ///< a ball that has lost no more bits counts as a point
constexpr std::size_t most_disks = 4000;

bool is_point(const Ball& u) {
    return u.is_exact() || u.relative_accuracy_bits() > u.bits() - point_bits;
}

} // namespace

Ball IntegratedContact::place(Edge edge, const Ball& u) const {
    return edge == Edge::right ? a_ - u : u - b_;
}

bool IntegratedContact::inside(std::size_t knot) const {
    return bends(knot) && !on_edge_[knot] && !certainly_less(a_, slope_.knots[knot]) &&
           !certainly_less(slope_.knots[knot], -b_);
}

Ball IntegratedContact::gap_at(const Ball& x) const {
    Ball gap = length();
    for (std::size_t i = 0; i < slope_.knots.size(); ++i) {
        if (inside(i)) {
            gap = min(gap, abs(Ball(x - slope_.knots[i])));
        }
    }
    return gap;
}

std::optional<std::size_t> IntegratedContact::piece_of(const Ball& x) const {
    std::size_t piece = 0;
    for (std::size_t i = 0; i < slope_.knots.size(); ++i) {
        if (!inside(i)) {
            piece =
                certainly_less(a_, slope_.knots[i]) || on_edge_[i] == Edge::right ? piece : i + 1;
        } else if (certainly_less(slope_.knots[i], x)) {
            piece = i + 1;
        } else if (!certainly_less(x, slope_.knots[i])) {
            return {};
        } else {
            break;
        }
    }
    return whole_piece(piece);
}

const SlopeOverTheta& IntegratedContact::over_theta() const {
    if (!over_theta_) {
        SlopeOverTheta all;
        all.formulas = roots().formulas;
        all.spans = spans(a_, b_);
        all.pieces = piece_spans(a_, b_);
        all.centre = (a_ - b_) / 2;
        all.half_length = (a_ + b_) / 2;
        const Ball highest = series_of_slope(all.pieces.front().piece, a_, 1)[0];
        const Ball lowest = series_of_slope(all.pieces.back().piece, -b_, 1)[0];
        all.most_change = Magnitude(Ball(highest - lowest));
        over_theta_ = std::make_shared<const SlopeOverTheta>(std::move(all));
    }
    return *over_theta_;
}

const IntegratedContact::Disk* IntegratedContact::disk_at(Edge edge, const Ball& u,
                                                          std::size_t terms) const {
    auto& disks = disks_[edge];
    const Ball x = place(edge, u);
    const auto piece = piece_of(x);
    if (!piece || disks.size() > most_disks) {
        return nullptr;
    }
    disks.push_back(std::make_shared<const Disk>(
        Disk{u, PressureDisk(over_theta(), *piece, x, gap_at(x), terms, bits_)}));
    return disks.back().get();
}

const IntegratedContact::Disk* IntegratedContact::disk_at_edge(Edge edge) const {
    const Ball none(0, bits_);
    for (const auto& disk : disks_[edge]) {
        if (disk->u.is_exact() && contains_zero(disk->u)) {
            return disk.get();
        }
    }
    return disk_at(edge, none, least_terms);
}

const IntegratedContact::Disk* IntegratedContact::disk_for(Edge edge, const Ball& u,
                                                           std::size_t order) const {
    const std::size_t terms = std::max(least_terms, 2 * order + 8);
    const Ball breadth(u.radius(), bits_);
    const auto serves = [&](const Disk& d) {
        const Ball z = u - d.u;
        return d.disk.found() && d.disk.terms() >= terms &&
               certainly_less(abs(z) * 2, d.disk.radius()) &&
               (d.disk.good_to(z, disk_goal(bits_)) ||
                certainly_less(d.disk.radius(), breadth * 64));
    };
    for (const auto& disk : disks_[edge]) {
        if (serves(*disk)) {
            return disk.get();
        }
    }
    // A new disk is centred at an edge if that is near, so that one disk serves many intervals.
    const Ball centre_of_u = middle(u);
    const Ball length = a_ + b_;
    const Ball near = gap_at(place(edge, centre_of_u));
    if (!certainly_less(breadth * 3, near)) {
        return nullptr;
    }
    for (const Ball& centre : {Ball(0, bits_), length, centre_of_u}) {
        const bool tried = std::any_of(
            disks_[edge].begin(), disks_[edge].end(), [&](const std::shared_ptr<const Disk>& d) {
                return overlaps(d->u, centre) && d->disk.terms() >= terms;
            });
        if (tried || !certainly_less(abs(Ball(centre - u)) * 5, near)) {
            continue;
        }
        const Disk* made = disk_at(edge, centre, terms);
        if (made != nullptr && serves(*made)) {
            return made;
        }
    }
    return nullptr;
}

/// p = E*/(2 pi) sqrt(u (D - u)) I (docs/expansions.md, "Coefficients of curved slopes").
Ball IntegratedContact::with_root(const Ball& u, const Ball& I) const {
    return modulus_ / (Ball::pi(bits_) * 2) * Field<Ball>::root(clamped(u) * clamped(a_ + b_ - u)) *
           I;
}

Ball IntegratedContact::pressure(Edge edge, const Ball& u) const {
    const Ball x = place(edge, u);
    const auto piece = piece_of(x);
    if (!piece) {
        return with_root(u, over_knot(x, false));
    }
    if (is_point(u)) {
        return with_root(u, coefficient(0, *piece, x));
    }
    const Disk* found = disk_for(edge, u, 1);
    return with_root(u,
                     found == nullptr
                         ? unknown_ball(bits_)
                         : found->disk.at(edge == Edge::right ? found->u - u : u - found->u, 1)[0]);
}

Ball IntegratedContact::least_pressure(Edge edge, const Ball& u) const {
    const Ball x = place(edge, u);
    return piece_of(x) ? pressure(edge, u) : with_root(u, over_knot(x, true));
}

BallSeries IntegratedContact::pressure_series(Edge edge, const Ball& u, std::size_t order) const {
    const BallSeries from = BallSeries::variable(u.with_bits(bits_), order);
    const BallSeries other = -from + (a_ + b_);
    const Ball x = place(edge, u);
    const auto piece = piece_of(x);
    if (!piece || !certainly_positive(u) || !certainly_positive(other[0])) {
        return unknown_series(order, bits_);
    }
    std::vector<Ball> I;
    if (is_point(u) && order <= 2) {
        for (std::size_t k = 0; k < order; ++k) {
            I.push_back(coefficient(k, *piece, x));
        }
    } else {
        const Disk* found = disk_for(edge, u, order);
        if (found == nullptr) {
            return unknown_series(order, bits_);
        }
        const BallSeries at =
            found->disk.at(edge == Edge::right ? found->u - u : u - found->u, order);
        for (std::size_t k = 0; k < order; ++k) {
            I.push_back(at[k]);
        }
    }
    for (std::size_t k = 1; k < order && edge == Edge::right; k += 2) {
        I[k] = -I[k]; // x decreases as u grows
    }
    return sqrt(from * other) * BallSeries(I) * (modulus_ / (Ball::pi(bits_) * 2));
}

Ball IntegratedContact::reach(Edge edge) const {
    const Disk* disk = disk_at_edge(edge);
    return disk == nullptr || !disk->disk.found() ? Ball(0, bits_)
                                                  : disk->disk.radius().with_bits(bits_);
}

/// Cauchy's estimate for sqrt(D - u) I on the disk about the edge (docs/expansions.md).
Ball IntegratedContact::majorant(Edge edge, const Ball& rho) const {
    const Disk* disk = disk_at_edge(edge);
    if (disk == nullptr || !disk->disk.found() || certainly_less(disk->disk.radius(), rho)) {
        return unknown_ball(bits_);
    }
    const Ball most(disk->disk.bound().upper(), bits_);
    return modulus_ / (Ball::pi(bits_) * 2) * sqrt(a_ + b_ + rho) * most;
}

/// The quotient in I is a mean of g''. If g'' is infinite on the knot, then |s - v| = w^n, and the
/// derivative of g' by w is at most L. Since |w_s - w_x| <= |s - x|^(1/n), the quotient, which is
/// not negative, is at most the sum over both sides of L |s - x|^(1/n - 1) (docs/curved-slopes.md,
/// "What is integrated").
Ball IntegratedContact::near_knot(std::size_t knot, const Ball& lo, const Ball& hi,
                                  const Ball& width) const {
    const Ball& v = slope_.knots[knot];
    const Ball before = series_of_slope(knot, Ball::hull(lo, v), 2)[1];
    const Ball after = series_of_slope(knot + 1, Ball::hull(v, hi), 2)[1];
    if (before.is_finite() && after.is_finite()) {
        return width * Ball::hull(before, after);
    }
    const Ball r = hi - lo;                                        // not shorter than s - x
    const Ball nearest = Field<Ball>::root((a_ - hi) * (b_ + lo)); // lower bound of |ds/dtheta|
    Ball most(0, bits_);
    for (const std::size_t side : {0U, 1U}) {
        const Roots::Root& root = roots().of_knots[knot].at(side);
        const long n = std::max(root.root, 1L);
        Ball rate = side == 0 ? before : after;
        if (root.root != 0) {
            const Ball all = Ball::hull(Ball(0, bits_), pow(r, Rational(1, n)));
            rate = slope_series(roots().formulas[root.formula], all, 2, bits_)[1];
        }
        most += abs(rate) * 2 * n * pow(r, Rational(1, n));
    }
    return Ball::hull(Ball(0, bits_), upper_end(most / nearest));
}

Ball IntegratedContact::over_knot(const Ball& x, bool least) const {
    std::optional<std::size_t> met;
    for (std::size_t i = 0; i < slope_.knots.size(); ++i) {
        if (inside(i) && overlaps(x, slope_.knots[i])) {
            if (met) {
                return unknown_ball(bits_);
            }
            met = i;
        }
    }
    if (!met || (profile_.has_corner(*met) && !least)) {
        return unknown_ball(bits_);
    }
    // Near the knot, up to twice the radius of the ball, the quotient is a mean of g''.
    const std::size_t i = *met;
    const Ball& v = slope_.knots[i];
    const Ball r = upper_end(abs(x - v)) * 2;
    const Ball lo = v - r;
    const Ball hi = v + r;
    for (std::size_t j = 0; j < slope_.knots.size(); ++j) {
        const bool clear =
            certainly_less(slope_.knots[j], lo) || certainly_less(hi, slope_.knots[j]);
        if (j != i && inside(j) && !clear) {
            return unknown_ball(bits_);
        }
    }
    if (!certainly_less(-b_, lo) || !certainly_less(hi, a_)) {
        return unknown_ball(bits_);
    }
    const SlopeOverTheta& all = over_theta();
    const Ball from = clamped_mark({a_, b_}, hi).h;
    const Ball to = clamped_mark({a_, b_}, lo).h;
    std::vector<quadrature::ThetaSpan> outer(all.pieces);
    for (quadrature::ThetaSpan& span : outer) {
        if (span.piece == whole_piece(i + 1)) {
            span.to = from;
        } else if (span.piece == i) {
            span.from = to;
        }
    }
    Ball inner(0, bits_);
    if (!profile_.has_corner(i)) {
        inner = near_knot(i, lo, hi, to - from);
    }
    // x is on one side of the knot or on the other.
    std::optional<Ball> either;
    for (const std::size_t side : {i, i + 1}) {
        const Ball part = side == i ? Ball::hull(Ball(x.lower(), bits_), v)
                                    : Ball::hull(v, Ball(x.upper(), bits_));
        const Ball sum = inner + outer_integral(all, outer, side, part, bits_);
        either = either ? Ball::hull(*either, sum) : sum;
    }
    return *either;
}

} // namespace edgeproof::contact
