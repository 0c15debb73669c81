// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/axisymmetric/axisymmetric_contact.hpp"

#include "edgeproof/contact/axisymmetric/abel_integral.hpp"
#include "edgeproof/contact/enclosure/ball_marks.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/isolate_zero.hpp"
#include "edgeproof/contact/law/edge_expansion.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace edgeproof::contact {
namespace {

constexpr long bits_of_searches = 48;

} // namespace

/// The radius by its distances from the edge, r = a - u, and from the opposite edge.
struct AxisymmetricContact::Place {
    Ball u;                    ///< from the nearer edge
    Ball other;                ///< 2a - u
    Ball r;                    ///< not negative
    std::vector<bool> on_knot; ///< r is known to be exactly on the bend
    [[nodiscard]] Ball W() const { return Field<Ball>::root(clamped(u) * clamped(other)); }
};

AxisymmetricContact::AxisymmetricContact(const Profile& profile,
                                         const formula::Exact& contact_modulus, const Load& load,
                                         long bits)
    : ProvedContact(profile, enclosed_constant(contact_modulus, bits), bits) {
    const std::size_t origin = slope_.origin;
    for (std::size_t i = origin; i < slope_.knots.size(); ++i) {
        const bool first = i == origin;
        Ball jump = first ? slope_.pieces[i + 1].at_origin : slope_.jump(i);
        Ball rate = first ? slope_.rate(i + 1) : -slope_.rate_drop(i);
        const bool none = arb_is_zero(jump.data()) != 0 && arb_is_zero(rate.data()) != 0;
        if (!none) { // a flat begins at the origin without a bend
            bends_.push_back({slope_.knots[i], std::move(jump), std::move(rate), first, i});
        }
    }
    const Ball given = enclosed_constant(load.value, bits);
    if (load.kind == Load::Kind::right_edge) {
        known_a_ = load.value;
        a_ = given;
        find_knots_on_edges();
    } else if (load.kind == Load::Kind::force) {
        a_ = radius_for(given);
    } else {
        const Ball start = max(bends_.back().v * 2, given);
        a_ = isolate_zero([&](const Ball& s) { return given - approach_at(s); },
                          [&](const Ball& s) { return -approach_rate(s); }, start,
                          "the radius of the contact", {});
    }
    b_ = a_;
}

Ball AxisymmetricContact::radius_for(const Ball& P) const {
    const Ball start = bends_.back().at_origin ? Ball(1, bits_) : bends_.back().v * 2;
    return isolate_zero([&](const Ball& s) { return P - force_at(s); },
                        [&](const Ball& s) { return -(modulus_ * s * approach_rate(s) * 2); },
                        start, "the radius of the contact", {});
}

AxisymmetricContact AxisymmetricContact::with_radius(const Ball& a) const {
    AxisymmetricContact c(*this);
    c.move_edges(a, a);
    return c;
}

/// The sum of f(bend, y, A) over the bends inside the radius s: y = sqrt(s^2 - v^2),
/// A = arccos(v/s).
template <class F> Ball AxisymmetricContact::over_bends(const Ball& s, const F& f) const {
    Ball sum(0, bits_);
    for (const Bend& bend : bends_) {
        if (bend.at_origin) {
            sum += f(bend, s, Ball::pi(bits_) / 2);
        } else if (on_edge_[bend.knot] != Edge::right && !certainly_less(s, bend.v)) {
            const Ball y = Field<Ball>::root(clamped(s - bend.v) * (s + bend.v));
            sum += f(bend, y, atan2(y, bend.v));
        }
    }
    return sum;
}

// docs/axisymmetric.md, "Piecewise linear slopes"
Ball AxisymmetricContact::approach_at(const Ball& s) const {
    return s * over_bends(s, [](const Bend& bend, const Ball& y, const Ball& A) {
               return bend.jump * A + bend.rate * (y - bend.v * A);
           });
}

Ball AxisymmetricContact::approach_rate(const Ball& s) const {
    return over_bends(s, [](const Bend& bend, const Ball& y, const Ball& A) {
        Ball rate = bend.rate * (y * 2 - bend.v * A);
        if (!contains_zero(bend.jump)) {
            rate += bend.jump * (A + bend.v / y);
        }
        return rate;
    });
}

Ball AxisymmetricContact::force_at(const Ball& a) const {
    return modulus_ * over_bends(a, [&](const Bend& bend, const Ball& y, const Ball& A) {
               const Ball& v = bend.v;
               return bend.jump * (a * a * A + v * y) +
                      bend.rate * (y * y * y * 4 / 3 - v * (a * a * A - v * y));
           });
}

Ball AxisymmetricContact::approach() const { return approach_at(a_); }

Ball AxisymmetricContact::force_rate() const { return modulus_ * a_ * approach_rate(a_) * 2; }

Ball AxisymmetricContact::minimum_end() const {
    for (const Bend& bend : bends_) {
        if (!contains_zero(bend.jump) || !contains_zero(bend.rate)) {
            return bend.v;
        }
    }
    return {0, bits_};
}

bool AxisymmetricContact::inside(std::size_t knot) const {
    return !on_edge_[knot] && !certainly_less(a_, abs(slope_.knots[knot]));
}

Ball AxisymmetricContact::pressure(Edge edge, const formula::Exact& u) const {
    const Ball from = enclosed_constant(u, bits_);
    const Ball other = a_ * 2 - from;
    Place at{from, other, abs(a_ - from), std::vector<bool>(bends_.size())};
    if (const auto a = known(edge)) {
        for (std::size_t i = 0; i < bends_.size(); ++i) {
            const formula::Expr v = profile_.knots()[bends_[i].knot].expr();
            const formula::Expr x = a->expr() - u.expr();
            at.on_knot[i] =
                overlaps(at.r, bends_[i].v) && (certainly_zero(x - v) || certainly_zero(x + v));
        }
    }
    return pressure(at, false);
}

AxisymmetricContact::Place AxisymmetricContact::place_at(const formula::Exact& r) const {
    const Ball x = enclosed_constant(r, bits_);
    Place at{a_ - x, a_ + x, x, std::vector<bool>(bends_.size())};
    for (std::size_t i = 0; i < bends_.size(); ++i) {
        at.on_knot[i] = overlaps(x, bends_[i].v) &&
                        certainly_zero(profile_.knots()[bends_[i].knot].expr() - r.expr());
    }
    return at;
}

Ball AxisymmetricContact::pressure_at(const formula::Exact& r) const {
    return pressure(place_at(r), false);
}

Ball AxisymmetricContact::outer_moment(const formula::Exact& r) const {
    const Place at = place_at(r);
    const Ball W = at.W();
    const Ball W3 = W * W * W;
    const auto series = [](const Ball& x) { return BallSeries(x, 1); };
    Ball sum(0, bits_);
    for (std::size_t i = 0; i < bends_.size(); ++i) {
        const Bend& bend = bends_[i];
        const Ball& v = bend.v;
        const bool corner = !contains_zero(bend.jump);
        if (bend.at_origin) {
            sum += bend.rate * W3 * 2 / 3;
            if (corner) {
                sum += bend.jump * Ball::pi(bits_) / 4 * (a_ * W - at.r * at.r * asinh(W / at.r));
            }
            continue;
        }
        if (!inside(bend.knot)) {
            continue;
        }
        const Ball beyond = at.r - v;
        const bool on = at.on_knot[i];
        const long known =
            std::min(on ? bits_ : beyond.relative_accuracy_bits(), W.relative_accuracy_bits());
        const long accuracy = useful_accuracy(known, bits_);
        const IntegralGoal goal{std::min(bits_, accuracy + 64), accuracy, Ball(0, bits_),
                                abs(beyond)};
        const RingBend of{v, bend.jump, bend.rate};
        if ((on && !corner) || certainly_positive(beyond)) {
            const Ball d2 = on ? Ball(0, bits_) : beyond * (at.r + v);
            sum += outside_bend(of, series(at.r * at.r), series(d2), series(W), goal, true)[0] * W3;
        } else if (certainly_negative(beyond)) {
            const Ball Y = Field<Ball>::root(clamped(a_ - v) * (a_ + v));
            sum += inside_bend(of, series(-beyond * (at.r + v)), Y, goal, true)[0] * Y;
        } else {
            return unknown_ball(bits_);
        }
    }
    return sum;
}

Ball AxisymmetricContact::pressure(Edge /*edge*/, const Ball& u) const {
    return pressure(Place{u, a_ * 2 - u, abs(a_ - u), std::vector<bool>(bends_.size())}, false);
}

Ball AxisymmetricContact::least_pressure(Edge /*edge*/, const Ball& u) const {
    return pressure(Place{u, a_ * 2 - u, abs(a_ - u), std::vector<bool>(bends_.size())}, true);
}

// docs/axisymmetric.md, "What is integrated"
Ball AxisymmetricContact::pressure(const Place& at, bool least) const {
    if (certainly_negative(at.u) || certainly_negative(at.other)) {
        throw DomainError("a point lies outside the contact");
    }
    const Ball W = at.W();
    Ball sum(0, bits_);
    const auto series = [](const Ball& x) { return BallSeries(x, 1); };
    for (std::size_t i = 0; i < bends_.size(); ++i) {
        const Bend& bend = bends_[i];
        if (bend.at_origin) { // h' = (pi/2) jump + 2 rate s
            sum += bend.rate * W * 2;
            if (!contains_zero(bend.jump)) {
                // p is infinite at the apex; the least one in the ball is that of its far end
                const Ball r = least && contains_zero(at.r) ? upper_end(at.r) : at.r;
                sum += bend.jump * Ball::pi(bits_) / 2 * asinh(W / r);
            }
            continue;
        }
        if (!inside(bend.knot)) {
            continue;
        }
        const Ball& v = bend.v;
        const Ball beyond = at.r - v;
        const long known = std::min(at.on_knot[i] ? bits_ : beyond.relative_accuracy_bits(),
                                    W.relative_accuracy_bits());
        const long accuracy = useful_accuracy(known, bits_);
        const IntegralGoal goal{std::min(bits_, accuracy + 64), accuracy,
                                abs(bend.jump) / v + abs(bend.rate), abs(beyond)};
        const auto outside = [&](const RingBend& of, const Ball& r, const Ball& width, bool on) {
            const Ball d2 = on ? Ball(0, bits_) : (r - v) * (r + v);
            return outside_bend(of, series(r * r), series(d2), series(width), goal)[0] * width;
        };
        const Ball Y = Field<Ball>::root(clamped(a_ - v) * (a_ + v));
        const auto within = [&](const RingBend& of, const Ball& r) {
            return inside_bend(of, series((v - r) * (v + r)), Y, goal)[0] * Y;
        };
        const RingBend whole{v, bend.jump, bend.rate};
        const bool corner = !contains_zero(bend.jump);
        if (at.on_knot[i] && corner) {
            return unknown_ball(bits_);
        }
        if (at.on_knot[i] || certainly_positive(beyond)) {
            sum += outside(whole, at.on_knot[i] ? v : at.r, W, at.on_knot[i]);
        } else if (certainly_negative(beyond)) {
            sum += within(whole, at.r);
        } else if (corner && !least) {
            return unknown_ball(bits_);
        } else {
            // The ball of r contains the bend. Its part increases up to it, and beyond it h'/s
            // increases with s for a change of the rate, and decreases for a jump
            // (docs/axisymmetric.md, "Near a bend").
            const Ball lo(max(at.r, Ball(0, bits_)).lower(), bits_);
            const Ball hi(at.r.upper(), bits_);
            const Ball W_hi = Field<Ball>::root(clamped(a_ - hi) * (a_ + hi));
            const Ball zero(0, bits_);
            const Ball one(1, bits_);
            const auto before = [&](const RingBend& of, const Ball& otherwise) {
                return certainly_less(lo, v) ? within(of, lo) : otherwise;
            };
            const RingBend bent{v, zero, one};
            const Ball after = outside(bent, v, W_hi, true);
            const Ball highest =
                certainly_less(v, hi) ? outside(bent, hi, Y, false) : outside(bent, v, Y, true);
            sum += bend.rate *
                   Ball::hull(min(lower_end(before(bent, after)), lower_end(after)), highest);
            if (corner) {
                const RingBend jump{v, one, zero};
                const Ball beyond_it =
                    certainly_less(v, hi) ? outside(jump, hi, W_hi, false) : unknown_ball(bits_);
                sum += bend.jump * min(before(jump, beyond_it), beyond_it);
            }
        }
    }
    return modulus_ / Ball::pi(bits_) * sum;
}

namespace {

// |c_k| <= M/rho^k: the omitted terms are bounded by those of M x^n/(1 - x), x = (u + z)/rho, whose
// coefficients are positive and grow with u.
/// The pressure series by the expansion at the edge; nothing if u is not well within its reach.
std::optional<BallSeries> series_near_edge(const AxisymmetricContact& contact, const Ball& u,
                                           std::size_t order) {
    constexpr double most_terms = 500;
    const Ball rho = lower_end(contact.reach(Edge::right)) * 9 / 10;
    if (!certainly_positive(u) || !certainly_less(u * 10, rho * 7)) {
        return {};
    }
    const double bits_of_a_term = -std::log2(approximate(upper_end(u / rho)));
    const double wanted = (static_cast<double>(contact.bits()) + 8) / bits_of_a_term + 2;
    const Ball M = contact.majorant(Edge::right, rho);
    if (!(wanted < most_terms) || !M.is_finite()) {
        return {};
    }
    const auto terms = static_cast<std::size_t>(wanted);
    const std::vector<Ball> c = contact.expansion(Edge::right, terms);
    const BallSeries at = BallSeries::variable(u, order);
    BallSeries sum(c.back(), order);
    for (std::size_t k = terms - 1; k-- > 0;) {
        sum = sum * at + c[k];
    }
    const BallSeries x = BallSeries::variable(upper_end(u), order) * (1 / rho);
    const BallSeries tail =
        pow(x, Ball(static_cast<long>(terms), contact.bits())) / (-x + Ball(1, contact.bits())) * M;
    for (std::size_t k = 0; k < order; ++k) {
        sum.set(k, sum[k] + Ball::hull(-tail[k], tail[k]));
    }
    return sum * sqrt(at);
}

} // namespace

BallSeries AxisymmetricContact::pressure_series(Edge /*edge*/, const Ball& u,
                                                std::size_t order) const {
    if (auto near = series_near_edge(*this, u.with_bits(bits_), order)) {
        return *near;
    }
    if (auto near = series_near_edge(*this, a_ * 2 - u, order)) { // from the opposite edge
        for (std::size_t k = 1; k < order; k += 2) {
            near->set(k, -(*near)[k]);
        }
        return *near;
    }
    const BallSeries from = BallSeries::variable(u.with_bits(bits_), order);
    const BallSeries other = -from + a_ * 2;
    const BallSeries r = -from + a_; // its sign does not matter off the origin
    if (!certainly_positive(u) || !certainly_positive(other[0])) {
        return unknown_series(order, bits_);
    }
    const BallSeries r2 = r * r;
    const BallSeries W = sqrt(from * other);
    BallSeries sum(Ball(0, bits_), order);
    for (const Bend& bend : bends_) {
        if (bend.at_origin) {
            sum = sum + W * (bend.rate * 2);
            if (contains_zero(bend.jump)) {
                continue;
            }
            if (contains_zero(r[0])) {
                return unknown_series(order, bits_);
            }
            // d asinh(W/r)/dr = -a/(r W), dr/du = -1
            const BallSeries rate = BallSeries(a_, order) / (r * W);
            BallSeries angle(asinh(W[0] / abs(r[0])), order);
            for (std::size_t k = 0; k + 1 < order; ++k) {
                angle.set(k + 1, rate[k] / static_cast<long>(k + 1));
            }
            sum = sum + angle * (bend.jump * Ball::pi(bits_) / 2);
            continue;
        }
        if (!inside(bend.knot)) {
            continue;
        }
        const BallSeries d2 = r2 + -(bend.v * bend.v);
        const Ball beyond = abs(r[0]) - bend.v;
        // Long series serve searches, which need few digits.
        const long accuracy =
            useful_accuracy(beyond.relative_accuracy_bits(), order > 3 ? bits_of_searches : bits_);
        const IntegralGoal goal{std::min(bits_, accuracy + 64), accuracy,
                                abs(bend.jump) / bend.v + abs(bend.rate), abs(beyond)};
        const RingBend of{bend.v, bend.jump, bend.rate};
        if (certainly_positive(beyond)) {
            BallSeries apart = d2;
            apart.set(0, beyond * (abs(r[0]) + bend.v));
            sum = sum + outside_bend(of, r2, apart, W, goal) * W;
        } else if (certainly_negative(beyond)) {
            BallSeries apart = -d2;
            apart.set(0, -beyond * (abs(r[0]) + bend.v));
            const Ball Y = Field<Ball>::root(clamped(a_ - bend.v) * (a_ + bend.v));
            sum = sum + inside_bend(of, apart, Y, goal) * Y;
        } else {
            return unknown_series(order, bits_);
        }
    }
    return sum * (modulus_ / Ball::pi(bits_));
}

// docs/axisymmetric.md, "The expansion": p/sqrt(u) is a power series up to the next bend.
Ball AxisymmetricContact::reach(Edge /*edge*/) const {
    Ball least = a_;
    for (const Bend& bend : bends_) {
        if (!bend.at_origin && inside(bend.knot)) {
            least = min(least, a_ - bend.v);
        }
    }
    return least;
}

// p/sqrt(u) = (E*/pi) times the integral of h'(a - u t) (1 - t)^(-1/2) (2a - u (1 + t))^(-1/2) over
// 0 < t < 1: |h'| is bounded over the disk |s - a| <= rho. There v < |s|, so that the angle
// A = arccos(v/s) has |A| <= pi/2 + arcsin(v/|s|) <= pi (the series of arcsin has no negative
// coefficient), and y^2 = (s - v) (s + v).
Ball AxisymmetricContact::majorant(Edge /*edge*/, const Ball& rho) const {
    const Ball pi = Ball::pi(bits_);
    const Ball least = a_ - rho;
    const Ball greatest = a_ + rho;
    Ball most(0, bits_);
    for (const Bend& bend : bends_) {
        const Ball& v = bend.v;
        if (bend.at_origin) {
            most += abs(bend.jump) * pi / 2 + abs(bend.rate) * greatest * 2;
        } else if (inside(bend.knot)) {
            most += abs(bend.rate) * (sqrt((greatest - v) * (greatest + v)) * 2 + v * pi);
            if (!contains_zero(bend.jump)) {
                most += abs(bend.jump) * (pi + v / sqrt((least - v) * (least + v)));
            }
        }
    }
    return modulus_ / pi * most * 2 / sqrt(least * 2);
}

BallSeries AxisymmetricContact::approach_rate_series(std::size_t terms) const {
    const BallSeries s = BallSeries::variable(a_, terms);
    BallSeries rate(Ball(0, bits_), terms);
    for (const Bend& bend : bends_) {
        if (bend.at_origin) {
            rate = rate + s * (bend.rate * 2) + bend.jump * Ball::pi(bits_) / 2;
        } else if (!on_edge_[bend.knot] && !certainly_less(a_, bend.v)) {
            if (!certainly_less(bend.v, a_)) {
                return unknown_series(terms, bits_);
            }
            BallSeries y2 = s * s + -(bend.v * bend.v);
            y2.set(0, (a_ - bend.v) * (a_ + bend.v));
            const BallSeries y = sqrt(y2);
            const BallSeries A = atan(y * (1 / bend.v));
            rate = rate + (y * Ball(2, bits_) - A * bend.v) * bend.rate;
            if (!contains_zero(bend.jump)) {
                rate = rate + (A + BallSeries(bend.v, terms) / y) * bend.jump;
            }
        }
    }
    return rate;
}

std::vector<Ball> AxisymmetricContact::force_rates(std::size_t terms) const {
    const BallSeries rate =
        approach_rate_series(terms) * BallSeries::variable(a_, terms) * (modulus_ * 2);
    std::vector<Ball> rates;
    for (std::size_t k = 0; k < terms; ++k) {
        rates.push_back(k % 2 == 0 ? rate[k] : -rate[k]);
    }
    return rates;
}

std::vector<Ball> AxisymmetricContact::expansion(Edge /*edge*/, std::size_t terms) const {
    if (terms == 0) {
        return {};
    }
    // The plane contact with P'(s) = E* h'(s) has the same pressure.
    const BallSeries rate = approach_rate_series(terms);
    const BallSeries s = BallSeries::variable(a_, terms);
    const auto list = [&](const BallSeries& f) {
        std::vector<Ball> c;
        for (std::size_t k = 0; k < terms; ++k) {
            c.push_back(f[k]);
        }
        return series::Series<Ball>(std::move(c));
    };
    const LawSeries<Ball> law{list(rate * modulus_), list(s)};
    return coefficients_of(right_edge_brackets(law, a_), Ball(a_ * 2));
}

namespace {

class AxisymmetricZones : public ZoneSolver {
public:
    explicit AxisymmetricZones(const AxisymmetricContact& contact) : contact_(contact) {}
    [[nodiscard]] long bits() const override { return contact_.bits(); }
    [[nodiscard]] const Ball& modulus() const override { return contact_.modulus(); }
    [[nodiscard]] ZoneValues values(const BallZone& zone) const override {
        const AxisymmetricContact c = contact_.with_radius(zone.a);
        return {c.force(), Ball(0, bits()), c.force_rate(), c.force_rate()};
    }
    [[nodiscard]] Ball pressure(const BallZone& zone, Edge edge, const Ball& u) const override {
        return contact_.with_radius(zone.a).pressure(edge, u);
    }
    [[nodiscard]] BallZone zone(const Ball& force, const Ball& /*tilt*/,
                                const BallZone& /*near*/) const override {
        const Ball a = contact_.radius_for(force);
        return {a, a};
    }
    [[nodiscard]] std::vector<Ball> force_rates(const Ball& a, std::size_t terms) const override {
        return contact_.with_radius(a).force_rates(terms);
    }
    [[nodiscard]] BallZone core() const override {
        return {contact_.minimum_end(), contact_.minimum_end()};
    }
    [[nodiscard]] std::size_t cost() const override { return contact_.cost(); }

private:
    AxisymmetricContact contact_;
};

/// P is proportional to a^(m + 2) (docs/axisymmetric.md, "Power laws").
class AxisymmetricPowerZones : public ZoneSolver {
public:
    AxisymmetricPowerZones(const BallContact& plane, const Ball& force)
        : plane_(plane), force_(force), power_(plane.force_rate() * plane.a() / plane.force() + 1) {
    }
    [[nodiscard]] long bits() const override { return plane_.bits(); }
    [[nodiscard]] const Ball& modulus() const override { return plane_.modulus(); }
    [[nodiscard]] ZoneValues values(const BallZone& zone) const override {
        const Ball inner = force_ * pow(zone.a / plane_.a(), power_);
        const Ball rate = inner * power_ / zone.a;
        return {inner, Ball(0, bits()), rate, rate};
    }
    [[nodiscard]] Ball pressure(const BallZone& zone, Edge edge, const Ball& u) const override {
        return plane_.between(zone.a, zone.b).pressure(edge, u);
    }
    [[nodiscard]] BallZone zone(const Ball& force, const Ball& /*tilt*/,
                                const BallZone& /*near*/) const override {
        const Ball a = plane_.a() * pow(force / force_, 1 / power_);
        return {a, a};
    }
    [[nodiscard]] std::vector<Ball> force_rates(const Ball& a, std::size_t terms) const override {
        const Ball rate = values({a, a}).right_rate;
        const BallSeries rates =
            pow(-BallSeries::variable(Ball(0, bits()), terms) * (1 / a) + Ball(1, bits()),
                power_ - 1) *
            rate;
        std::vector<Ball> list;
        for (std::size_t k = 0; k < terms; ++k) {
            list.push_back(rates[k]);
        }
        return list;
    }

private:
    BallContact plane_;
    Ball force_;
    Ball power_; ///< m + 2
};

} // namespace

std::unique_ptr<ZoneSolver> axisymmetric_zones(const AxisymmetricContact& contact) {
    return std::make_unique<AxisymmetricZones>(contact);
}

std::unique_ptr<ZoneSolver> axisymmetric_zones(const BallContact& plane, const Ball& force) {
    return std::make_unique<AxisymmetricPowerZones>(plane, force);
}

} // namespace edgeproof::contact
