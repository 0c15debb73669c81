// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/slip/stick_zone.hpp"

#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/precision/error.hpp"

#include <optional>
#include <string>

namespace edgeproof::contact {
namespace {

class LinearZones : public ZoneSolver {
public:
    explicit LinearZones(const BallContact& contact)
        : ZoneSolver(contact), contact_(contact.between(contact.a(), contact.b())) {}
    [[nodiscard]] ZoneValues values(const BallZone& zone) const override {
        return contact_.values_of(zone);
    }
    [[nodiscard]] ZoneRates rates(const BallZone& zone) const override {
        return contact_.rates_of(zone);
    }
    [[nodiscard]] Ball pressure(const BallZone& zone, Edge edge, const Ball& u,
                                const std::optional<Exact>& /*x*/) const override {
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
        return {force_ * pow(zone.a / contact_.a(), power_), Ball(0, bits())};
    }
    [[nodiscard]] ZoneRates rates(const BallZone& zone) const override {
        const Ball rate = rate_ * pow(zone.a / contact_.a(), power_ - 1);
        return {rate, rate};
    }
    [[nodiscard]] Ball pressure(const BallZone& zone, Edge edge, const Ball& u,
                                const std::optional<Exact>& /*x*/) const override {
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
                   ? (pow(-inwards + one, power_ - 1) * rates({a, a}).right).coefficients()
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

ZoneEquations ZoneSolver::equations(const Ball& force, const Ball& tilt) const {
    return {.values = [this](const BallZone& zone) { return values(zone); },
            .rates = [this](const BallZone& zone) { return rates(zone); },
            .modulus = modulus_,
            .tilt = tilt,
            .force = force,
            .right_edge = {}};
}

BallZone ZoneSolver::zone(const Ball& force, const Ball& tilt, const BallZone& near) const {
    const ZoneEquations wanted = equations(force, tilt);
    const BallZone found = [&] {
        try {
            return wanted.search(near);
        } catch (const BudgetError&) { // the zone is small compared with `near`
            return wanted.search(
                wanted.from_afar({-middle(near.b), {}, middle(near.length())}, bits() / 2));
        }
    }();
    return wanted.proved(found);
}

std::unique_ptr<ZoneSolver> closed_form_zones(const BallContact& contact,
                                              const std::optional<Ball>& total_force) {
    if (contact.piecewise_linear() && !total_force) {
        return std::make_unique<LinearZones>(contact);
    }
    return std::make_unique<PowerLawZones>(contact, total_force);
}

} // namespace edgeproof::contact
