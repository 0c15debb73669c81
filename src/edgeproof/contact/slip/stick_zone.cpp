// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/slip/stick_zone.hpp"

#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/isolate_zero.hpp"
#include "edgeproof/precision/error.hpp"

#include <optional>
#include <string>

namespace edgeproof::contact {
namespace {

constexpr int most_zone_steps = 400;
constexpr int most_growing_steps = 60;
constexpr long bits_of_a_zone_step = 12; ///< bits lost when Newton's steps have converged

/// Returns (E*/4) times the integral of (g' + tilt)/w (docs/partial-slip.md, "Enclosed").
Ball turn_of(const ZoneSolver& zones, const ZoneValues& v, const Ball& tilt) {
    return zones.modulus() * Ball::pi(zones.bits()) / 4 * (v.mean_slope + tilt);
}

/// Finds a start for ZoneSolver::search in a zone that is small compared with `near`. The mean
/// slope increases with the right edge and decreases with the left one; F increases with both.
BallZone from_afar(const ZoneSolver& zones, const Ball& force, const Ball& tilt,
                   const BallZone& near) {
    const ZeroSearch unproved{.prove = false, .nested = true};
    const auto balanced = [&](const Ball& a) { // turn_of has the rate -left_rate/(2 D) by b
        const Ball length = isolate_zero(
            [&](const Ball& D) {
                return turn_of(zones, zones.values({a, D - a}), tilt);
            },
            [&](const Ball& D) {
                return -zones.values({a, D - a}).left_rate / (D * 2);
            },
            a + near.b, "the left edge", unproved);
        return BallZone{a, middle(length - a)};
    };
    const auto beyond_left = [&](const Ball& x) { return balanced(middle(x - near.b)); };
    return beyond_left(
        isolate_zero([&](const Ball& x) { return force - zones.values(beyond_left(x)).force; },
                     [&](const Ball& x) { return -zones.values(beyond_left(x)).right_rate; },
                     near.length(), "the right edge", unproved));
}

class LinearZones : public ZoneSolver {
public:
    explicit LinearZones(const BallContact& contact) : ZoneSolver(contact), contact_(contact) {}
    [[nodiscard]] ZoneValues values(const BallZone& zone) const override {
        const BallContact c = contact_.between(zone.a, zone.b);
        return {c.zone_force(), c.zone_mean_slope(), c.zone_rate(Edge::right),
                c.zone_rate(Edge::left)};
    }
    [[nodiscard]] Ball pressure(const BallZone& zone, Edge edge, const Ball& u) const override {
        return contact_.between(zone.a, zone.b).pressure(edge, u);
    }
    [[nodiscard]] BallZone core() const override {
        return {contact_.minimum_end(Edge::right), contact_.minimum_end(Edge::left)};
    }

private:
    BallContact contact_;
};

/// P = K a^(m + 1) (docs/mechanics.md, "Closed forms of the law"); the total force of the body of
/// revolution with the same pressure grows as a^(m + 2) (docs/axisymmetric.md, "Power laws").
class PowerLawZones : public ZoneSolver {
public:
    PowerLawZones(const BallContact& contact, const std::optional<Ball>& total_force)
        : ZoneSolver(contact), contact_(contact), of_revolution_(total_force.has_value()),
          force_(total_force ? *total_force : contact.force()),
          power_(contact.force_rate() * contact.a() / contact.force() + (total_force ? 1 : 0)),
          rate_(force_ * power_ / contact.a()) {}
    [[nodiscard]] ZoneValues values(const BallZone& zone) const override {
        const Ball part = zone.a / contact_.a();
        const Ball rate = rate_ * pow(part, power_ - 1);
        return {force_ * pow(part, power_), Ball(0, bits()), rate, rate};
    }
    [[nodiscard]] Ball pressure(const BallZone& zone, Edge edge, const Ball& u) const override {
        return contact_.between(zone.a, zone.b).pressure(edge, u);
    }
    [[nodiscard]] BallZone zone(const Ball& force, const Ball&, const BallZone&) const override {
        const Ball a = contact_.a() * pow(force / force_, 1 / power_);
        return {a, a};
    }
    [[nodiscard]] std::vector<Ball> force_rates(const Ball& a, std::size_t terms) const override {
        const Ball one(1, bits());
        const BallSeries inwards = BallSeries::variable(one * 0, terms) * (1 / a);
        return of_revolution_
                   ? (pow(-inwards + one, power_ - 1) * values({a, a}).right_rate).coefficients()
                   : std::vector<Ball>();
    }

private:
    BallContact contact_;
    bool of_revolution_;
    Ball force_;
    Ball power_; ///< of the half width in the force
    Ball rate_;
};

} // namespace

BallZone ZoneSolver::search(const Ball& force, const Ball& tilt, const BallZone& near) const {
    BallZone at{middle(near.a), middle(near.b)};
    const Ball P = middle(force);
    const Ball turned = middle(tilt);
    const Ball tiny = power_of_two(bits_of_a_zone_step - bits(), bits());
    const Ball half_the_bits = power_of_two(-(bits() / 2), bits());
    std::optional<Ball> before;
    std::optional<BallZone> last; // where the values were finite
    Ball last_da(0, bits());
    Ball last_db(0, bits());
    int growing = 0;
    for (int k = 0; k < most_zone_steps; ++k) {
        const Ball D = at.length();
        const ZoneValues v = values(at);
        // Newton's step: G_+- = F - P +- D turn have the rates right_rate by a and left_rate by b
        // alone (docs/partial-slip.md, "The corrective contact").
        const Ball missing = v.force - P;
        const Ball turn = D * turn_of(*this, v, turned);
        Ball da = middle((missing + turn) / v.right_rate);
        Ball db = middle((missing - turn) / v.left_rate);
        if (!da.is_finite() || !db.is_finite()) {
            if (!last && k > 0) {
                break;
            }
            if (!last) { // a start with an edge on a corner
                const Ball inwards = D * power_of_two(-10, bits());
                at = {middle(at.a - inwards), middle(at.b - inwards)};
                continue;
            }
            // The step went beyond the knots that carry the zone, such as the one corner of a
            // wedge.
            at = {middle((at.a + last->a) / 2), middle((at.b + last->b) / 2)};
            continue;
        }
        last = at;
        // Across a corner, where the rates are infinite, the steps may go back and forth for ever.
        const auto damped = [](Ball& step, Ball& previous) {
            if (certainly_negative(step * previous) &&
                certainly_less(abs(previous), abs(step) * 2)) {
                step = middle(step / 2);
            }
            previous = step;
        };
        damped(da, last_da);
        damped(db, last_db);
        // A step removes less than the whole zone.
        const Ball limit = D * Ball(Rational(7, 16), bits());
        const Ball most = max(abs(da), abs(db));
        if (certainly_less(limit, most)) {
            da *= limit / most;
            db *= limit / most;
        }
        at = {middle(at.a - da), middle(at.b - db)};
        const Ball size = abs(da) + abs(db);
        if (!certainly_less(tiny * (abs(at.a) + abs(at.b)), size)) {
            return at;
        }
        const bool shrinks = !before || certainly_less(size * 2, *before);
        if (!shrinks && certainly_less(size, half_the_bits * D)) {
            return at; // roundoff
        }
        growing += before && certainly_less(*before, size) ? 1 : 0;
        if (growing > most_growing_steps) {
            break;
        }
        before = size;
    }
    throw BudgetError("no stick zone was found at " + std::to_string(bits()) + " bits");
}

// Interval Newton, edge by edge: where the image of a box lies inside it, the box contains exactly
// one zone (moore-kearfott-cloud2009). The sum and the difference of F - P and D turn_of have the
// derivatives (dP/da + turn, turn) and (-turn, dP/db - turn), where turn is 0 at the zone: no
// matrix is inverted (docs/partial-slip.md, "The corrective contact").
BallZone ZoneSolver::proved(const Ball& force, const Ball& tilt, const BallZone& m) const {
    const ZoneValues at = values(m);
    const Ball missing = at.force - force;
    const Ball turn = m.length() * turn_of(*this, at, tilt);
    const Ball least = power_of_two(4 - bits(), bits()) * m.length();
    Ball radius_a = abs((missing + turn) / at.right_rate) * 2 + least;
    Ball radius_b = abs((missing - turn) / at.left_rate) * 2 + least;
    for (long k = 0; 5 * k < bits() && radius_a.is_finite() && radius_b.is_finite(); ++k) {
        const BallZone box{Ball::around(m.a.midpoint(), radius_a.upper(), bits()),
                           Ball::around(m.b.midpoint(), radius_b.upper(), bits())};
        const ZoneValues v = values(box);
        const Ball off = turn_of(*this, v, tilt);
        const BallZone image{m.a - (missing + turn + off * (box.b - m.b)) / (v.right_rate + off),
                             m.b - (missing - turn - off * (box.a - m.a)) / (v.left_rate - off)};
        if (image.a.is_finite() && image.b.is_finite() && contains(box.a, image.a) &&
            contains(box.b, image.b)) {
            return image;
        }
        radius_a = middle(radius_a * 32);
        radius_b = middle(radius_b * 32);
    }
    throw BudgetError("ball arithmetic at " + std::to_string(bits()) +
                      " bits does not isolate the stick zone");
}

BallZone ZoneSolver::zone(const Ball& force, const Ball& tilt, const BallZone& near) const {
    const BallZone found = [&] {
        try {
            return search(force, tilt, near);
        } catch (const BudgetError&) {
            return search(force, tilt, from_afar(*this, force, tilt, near));
        }
    }();
    return proved(force, tilt, found);
}

std::unique_ptr<ZoneSolver> closed_form_zones(const BallContact& contact,
                                              const std::optional<Ball>& total_force) {
    if (contact.piecewise_linear() && !total_force) {
        return std::make_unique<LinearZones>(contact);
    }
    return std::make_unique<PowerLawZones>(contact, total_force);
}

} // namespace edgeproof::contact
