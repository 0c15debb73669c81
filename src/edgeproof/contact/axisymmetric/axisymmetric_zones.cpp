// SPDX-License-Identifier: GPL-3.0-or-later
// The stick zones of axisymmetric contacts.
#include "edgeproof/contact/axisymmetric/axisymmetric_contact.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace edgeproof::contact {
namespace {

class AxisymmetricZones : public ZoneSolver {
public:
    explicit AxisymmetricZones(const RoundContact& contact)
        : contact_(contact.resized(contact.a())) {}
    [[nodiscard]] long bits() const override { return contact_->bits(); }
    [[nodiscard]] const Ball& modulus() const override { return contact_->modulus(); }
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

std::unique_ptr<ZoneSolver> axisymmetric_zones(const RoundContact& contact) {
    return std::make_unique<AxisymmetricZones>(contact);
}

std::unique_ptr<ZoneSolver> axisymmetric_zones(const BallContact& plane, const Ball& force) {
    return std::make_unique<AxisymmetricPowerZones>(plane, force);
}

} // namespace edgeproof::contact
