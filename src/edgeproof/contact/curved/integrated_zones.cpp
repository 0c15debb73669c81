// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/curved/integrated_zones.hpp"

#include "edgeproof/formula/exact/enclosed_constant.hpp"

#include <algorithm>
#include <utility>

namespace edgeproof::contact {

IntegratedContact::IntegratedContact(const Profile& profile, const formula::Exact& contact_modulus,
                                     const Ball& a, const Ball& b, long bits)
    : profile_(profile), bits_(bits), modulus_(enclosed_constant(contact_modulus, bits)), a_(a),
      b_(b), zone_(true) {
    for (const formula::Exact& knot : profile.knots()) {
        knots_.push_back(enclosed_constant(knot, bits));
    }
    on_edge_.assign(knots_.size(), std::nullopt);
}

IntegratedContact IntegratedContact::between(const Ball& a, const Ball& b, long bits) const {
    IntegratedContact zone(*this);
    zone.zone_ = true;
    zone.bits_ = bits;
    zone.modulus_ = modulus_.with_bits(bits);
    for (Ball& knot : zone.knots_) {
        knot = knot.with_bits(bits);
    }
    zone.odd_ = false;
    zone.load_ = {};
    zone.load_.kind = Load::Kind::force; // no edge is given
    std::fill(zone.on_edge_.begin(), zone.on_edge_.end(), std::nullopt);
    zone.disks_.clear();
    zone.over_theta_.reset();
    zone.a_ = a;
    zone.b_ = b;
    return zone;
}

Ball IntegratedContact::zone_mean_slope() const {
    return slope_integral(a_, b_, 0) / Ball::pi(bits_);
}

// c_0 = 2 P'/(pi sqrt(D)) (docs/expansions.md) along the contacts of one tilt, and P' is E*/2 times
// the integral of the kernel (docs/mechanics.md).
Ball IntegratedContact::zone_rate(Edge edge) const {
    return Ball::pi(bits_) * sqrt(a_ + b_) / 2 * expansion(edge, 1)[0];
}

Ball IntegratedContact::zone_pressure(Edge edge, const Ball& u) const {
    const Ball x = place(edge, u);
    const auto piece = piece_of(x);
    return with_root(u, piece ? coefficient(0, *piece, x, series_of_slope(*piece, x, 1), false)
                              : over_knot(x, false));
}

namespace {

constexpr long coarse_zone_bits = 96;

class IntegratedZones : public ZoneSolver {
public:
    explicit IntegratedZones(IntegratedContact contact) : contact_(std::move(contact)) {}
    [[nodiscard]] long bits() const override { return contact_.bits(); }
    [[nodiscard]] const Ball& modulus() const override { return contact_.modulus(); }
    [[nodiscard]] ZoneValues values(const BallZone& zone) const override {
        const IntegratedContact c = contact_.between(zone.a, zone.b, bits());
        return {c.zone_force(), c.zone_mean_slope(), c.zone_rate(Edge::right),
                c.zone_rate(Edge::left)};
    }
    [[nodiscard]] Ball pressure(const BallZone& zone, Edge edge, const Ball& u) const override {
        return contact_.between(zone.a, zone.b, bits()).zone_pressure(edge, u);
    }
    /// Most steps of the search are taken with few bits.
    [[nodiscard]] BallZone zone(const Ball& force, const Ball& tilt,
                                const BallZone& near) const override {
        if (bits() < 2 * coarse_zone_bits) {
            return ZoneSolver::zone(force, tilt, near);
        }
        const auto few = [](const Ball& x) { return Ball(x.midpoint(), coarse_zone_bits); };
        const IntegratedZones coarse(contact_.between(near.a, near.b, coarse_zone_bits));
        BallZone start = coarse.search(few(force), few(tilt), {few(near.a), few(near.b)});
        start = {start.a.with_bits(bits()), start.b.with_bits(bits())};
        return ZoneSolver::zone(force, tilt, start);
    }
    [[nodiscard]] std::size_t cost() const override { return 40; }

private:
    IntegratedContact contact_;
};

} // namespace

std::unique_ptr<ZoneSolver> integrated_zones(const IntegratedContact& contact) {
    return std::make_unique<IntegratedZones>(contact);
}

} // namespace edgeproof::contact
