// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/axisymmetric/axisymmetric_contact.hpp"

#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/enclosure/isolate_zero.hpp"
#include "edgeproof/contact/law/edge_expansion.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace edgeproof::contact {
namespace {

constexpr const char* radius_sought = "the radius of the contact";

class AxisymmetricZones : public ZoneSolver {
public:
    explicit AxisymmetricZones(const RoundContact& contact)
        : ZoneSolver(contact), contact_(contact.resized(contact.a())) {}
    [[nodiscard]] ZoneValues values(const BallZone& zone) const override {
        const auto c = contact_->resized(zone.a);
        const Ball rate = c->force_rate();
        return {c->force(), Ball(0, bits()), rate, rate};
    }
    [[nodiscard]] Ball pressure(const BallZone& zone, Edge edge, const Ball& u) const override {
        return contact_->resized(zone.a)->pressure(edge, u);
    }
    [[nodiscard]] BallZone zone(const Ball& force, const Ball& /*tilt*/,
                                const BallZone& /*near*/) const override {
        const Ball a = contact_->radius_for(force);
        return {a, a};
    }
    [[nodiscard]] std::vector<Ball> force_rates(const Ball& a, std::size_t terms) const override {
        return contact_->resized(a)->force_rates(terms);
    }
    [[nodiscard]] BallZone core() const override {
        return {contact_->minimum_end(), contact_->minimum_end()};
    }
    [[nodiscard]] std::size_t cost() const override { return contact_->cost(); }

private:
    std::unique_ptr<RoundContact> contact_;
};

/// P is proportional to a^(m + 2) (docs/axisymmetric.md, "Power laws").
class AxisymmetricPowerZones : public ZoneSolver {
public:
    AxisymmetricPowerZones(const BallContact& plane, const Ball& force)
        : ZoneSolver(plane), plane_(plane), force_(force),
          power_(plane.force_rate() * plane.a() / plane.force() + 1) {}
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
        return rates.coefficients();
    }

private:
    BallContact plane_;
    Ball force_;
    Ball power_; ///< m + 2
};

} // namespace

void RoundContact::carry(const Load& load) {
    const Ball given = enclosed_constant(load.value, bits_);
    if (load.kind == Load::Kind::right_edge) {
        known_a_ = load.value;
        a_ = given;
        find_knots_on_edges();
    } else if (load.kind == Load::Kind::force) {
        a_ = radius_for(given);
    } else {
        const Start start = start_for(load.kind, given);
        a_ = isolate_zero([&](const Ball& s) { return given - approach_at(s); },
                          [&](const Ball& s) { return -approach_rate_at(s); }, start.radius,
                          radius_sought, {.near = start.near});
    }
    b_ = a_;
}

Ball RoundContact::radius_for(const Ball& P) const {
    const Start start = start_for(Load::Kind::force, P);
    return isolate_zero([&](const Ball& s) { return P - force_at(s); },
                        [&](const Ball& s) { return -(modulus_ * s * approach_rate_at(s) * 2); },
                        start.radius, radius_sought, {.near = start.near});
}

bool RoundContact::inside(std::size_t knot) const {
    return !on_edge_[knot] && !certainly_less(a_, abs(slope_.knots[knot]));
}

std::vector<Ball> RoundContact::expansion(Edge /*edge*/, std::size_t terms) const {
    if (terms == 0) {
        return {};
    }
    std::vector<Ball> rates = approach_rates(terms);
    std::vector<Ball> radii;
    for (std::size_t k = 0; k < terms; ++k) {
        rates[k] *= modulus_;
        radii.push_back(k == 0 ? a_ : Ball(k == 1 ? 1 : 0, bits_));
    }
    // The plane contact with P'(s) = E* h'(s) has the same pressure.
    const LawSeries<Ball> law{series::Series<Ball>(std::move(rates)),
                              series::Series<Ball>(std::move(radii))};
    return coefficients_of(right_edge_brackets(law, a_), Ball(a_ * 2));
}

AxisymmetricContact::AxisymmetricContact(const Profile& profile, const Exact& contact_modulus,
                                         const Load& load, long bits)
    : RoundContact(profile, enclosed_constant(contact_modulus, bits), bits) {
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
    carry(load);
}

AxisymmetricContact::Start AxisymmetricContact::start_for(Load::Kind kind,
                                                          const Ball& given) const {
    const Bend& last = bends_.back();
    return {kind == Load::Kind::approach ? max(last.v * 2, given)
            : last.at_origin             ? Ball(1, bits_)
                                         : last.v * 2,
            false};
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

Ball AxisymmetricContact::approach_rate_at(const Ball& s) const {
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

Ball AxisymmetricContact::minimum_end() const {
    for (const Bend& bend : bends_) {
        if (!contains_zero(bend.jump) || !contains_zero(bend.rate)) {
            return bend.v;
        }
    }
    return {0, bits_};
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

std::unique_ptr<ZoneSolver> axisymmetric_zones(const RoundContact& contact) {
    return std::make_unique<AxisymmetricZones>(contact);
}

std::unique_ptr<ZoneSolver> axisymmetric_zones(const BallContact& plane, const Ball& force) {
    return std::make_unique<AxisymmetricPowerZones>(plane, force);
}

} // namespace edgeproof::contact
