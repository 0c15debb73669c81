// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/curved/proved_slip.hpp"

#include "edgeproof/contact/axisymmetric/axisymmetric_contact.hpp"
#include "edgeproof/formula/exact/exact.hpp"

#include <utility>

namespace edgeproof::contact {

ProvedSlip::ProvedSlip(const Profile& profile, const Exact& contact_modulus, const Load& load,
                       const ShearLoad<Ball>& shear, const Ball& friction, long bits,
                       const std::optional<Ball>& total_force)
    : contact_(proved_contact(profile, contact_modulus, load, bits)),
      zones_(zone_solver(*contact_, profile, contact_modulus,
                         !shear.bulk_tension.is_exact() || !contains_zero(shear.bulk_tension),
                         total_force)) {
    slip_.emplace(*contact_, *zones_, total_force ? *total_force : contact_->force(), shear,
                  friction);
}

std::unique_ptr<ProvedContact> proved_contact(const Profile& profile, const Exact& contact_modulus,
                                              const Load& load, long bits) {
    if (profile.has_closed_form()) {
        return std::make_unique<BallContact>(profile, contact_modulus, load, bits);
    }
    if (profile.axisymmetric()) {
        return std::make_unique<AxisymmetricContact>(profile, contact_modulus, load, bits);
    }
    return std::make_unique<IntegratedContact>(profile, contact_modulus, load, bits);
}

IntegratedContact::IntegratedContact(const Profile& profile, const Exact& contact_modulus,
                                     const Ball& a, const Ball& b, long bits)
    : PlaneContact(profile, enclosed_constant(contact_modulus, bits), bits), zone_(true) {
    move_edges(a, b);
}

IntegratedContact IntegratedContact::between(const Ball& a, const Ball& b, long bits) const {
    IntegratedContact zone(*this);
    zone.zone_ = true;
    zone.bits_ = bits;
    zone.modulus_ = modulus_.with_bits(bits);
    for (Ball& knot : zone.slope_.knots) {
        knot = knot.with_bits(bits);
    }
    zone.move_edges(a, b);
    zone.forget();
    return zone;
}

ZoneValues IntegratedContact::zone_values() const {
    return {force_of(a_, b_), slope_integral(a_, b_, 0) / Ball::pi(bits_)};
}

// c_0 = 2 P'/(pi sqrt(D)) (docs/expansions.md) along the contacts of one tilt, and P' is E*/2 times
// the integral of the kernel (docs/mechanics.md).
Ball IntegratedContact::zone_rate(Edge edge) const {
    return Ball::pi(bits_) * sqrt(a_ + b_) / 2 * expansion(edge, 1)[0];
}

Ball IntegratedContact::zone_pressure(Edge edge, const Ball& u,
                                      const std::optional<Exact>& known_x) const {
    if (const auto knot = knot_at(known_x)) {
        return pressure_at_knot(u, *knot);
    }
    const Ball x = place(edge, u);
    const auto piece = piece_of(x);
    return with_root(u, piece ? coefficient(0, *piece, x) : over_knot(x, false));
}

namespace {

constexpr long coarse_zone_bits = 96;

class IntegratedZones : public ZoneSolver {
public:
    explicit IntegratedZones(IntegratedContact contact)
        : ZoneSolver(contact), contact_(std::move(contact)) {}
    [[nodiscard]] ZoneValues values(const BallZone& zone) const override {
        return contact_.between(zone.a, zone.b, bits()).zone_values();
    }
    [[nodiscard]] ZoneRates rates(const BallZone& zone) const override {
        const IntegratedContact c = contact_.between(zone.a, zone.b, bits());
        return {c.zone_rate(Edge::right), c.zone_rate(Edge::left)};
    }
    [[nodiscard]] Ball pressure(const BallZone& zone, Edge edge, const Ball& u,
                                const std::optional<Exact>& x) const override {
        return contact_.between(zone.a, zone.b, bits()).zone_pressure(edge, u, x);
    }
    /// Most steps of the search are taken with few bits.
    [[nodiscard]] BallZone zone(const Ball& force, const Ball& tilt,
                                const BallZone& near) const override {
        if (bits() < 2 * coarse_zone_bits) {
            return ZoneSolver::zone(force, tilt, near);
        }
        const auto few = [](const Ball& x) { return Ball(x.midpoint(), coarse_zone_bits); };
        const IntegratedZones coarse(contact_.between(near.a, near.b, coarse_zone_bits));
        BallZone start = coarse.equations(few(force), few(tilt)).search({few(near.a), few(near.b)});
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

namespace {

/// The zones of a power law under a tilt. The integrals are Gauss's 2F1 where the zone contains the
/// origin; elsewhere they, and all pressures, follow from rigorous integration.
/// For g' = C sgn(x) |x|^m, with s = a t (DLMF 15.6.1, 5.12.1),
///   integral of s^p (a - s)^(q - 1) (b + s)^(-r) over 0 < s < a
///     = a^(p + q) b^(-r) B(p + 1, q) 2F1(r, p + 1; p + 1 + q; -a/b).
class TiltedPowerLawZones : public ZoneSolver {
public:
    TiltedPowerLawZones(const Profile& profile, const Exact& modulus, const BallContact& contact)
        : ZoneSolver(contact), integrals_(integrated_zones(IntegratedContact(
                                   profile, modulus, contact.a(), contact.b(), contact.bits()))),
          exponent_(formula::enclosed_constant(profile.parameters().at("m"), contact.bits())),
          factor_(formula::enclosed_constant(profile.parameters().at("C"), contact.bits())) {}
    [[nodiscard]] ZoneValues values(const BallZone& zone) const override {
        const Ball& a = zone.a;
        const Ball& b = zone.b;
        if (!certainly_positive(a) || !certainly_positive(b)) {
            return integrals_->values(zone);
        }
        const Ball half(Rational(1, 2), bits());
        const Ball& m = exponent_;
        // The integrals of g'/w and s g'/w on each side of the origin.
        const Ball right = half_integral(a, b, m, half, half);
        const Ball left = half_integral(b, a, m, half, half);
        const Ball moments =
            half_integral(a, b, m + 1, half, half) + half_integral(b, a, m + 1, half, half);
        // The force and the mean slope (docs/partial-slip.md, "The corrective contact")
        return {modulus() * factor_ / 2 * (moments - (a - b) / 2 * (right - left)),
                factor_ * (right - left) / Ball::pi(bits())};
    }
    [[nodiscard]] ZoneRates rates(const BallZone& zone) const override {
        const Ball& a = zone.a;
        const Ball& b = zone.b;
        if (!certainly_positive(a) || !certainly_positive(b)) {
            return integrals_->rates(zone);
        }
        const Ball half(Rational(1, 2), bits());
        const Ball& m = exponent_;
        const Ball scale = modulus() * factor_ / 2;
        // A and B (docs/mechanics.md, "One measure, six kernels") with dg' = C m |v|^(m - 1) dv
        const auto rate = [&](const Ball& to, const Ball& from) {
            return scale * m *
                   (half_integral(to, from, m - 1, half, -half) +
                    half_integral(from, to, m - 1, half + 1, half));
        };
        return {rate(a, b), rate(b, a)};
    }
    [[nodiscard]] Ball pressure(const BallZone& zone, Edge edge, const Ball& u,
                                const std::optional<Exact>& x) const override {
        return integrals_->pressure(zone, edge, u, x);
    }

private:
    /// Returns the integral above (DLMF 15.6.1).
    [[nodiscard]] static Ball half_integral(const Ball& a, const Ball& b, const Ball& p,
                                            const Ball& q, const Ball& r) {
        return pow(a, p + q) / pow(b, r) * gamma(p + 1) * gamma(q) / gamma(p + 1 + q) *
               hypergeometric_2f1(r, p + 1, p + 1 + q, -(a / b));
    }

    std::unique_ptr<ZoneSolver> integrals_;
    Ball exponent_;
    Ball factor_;
};

} // namespace

std::unique_ptr<ZoneSolver> zone_solver(const ProvedContact& contact, const Profile& profile,
                                        const Exact& contact_modulus, bool tilted,
                                        const std::optional<Ball>& total_force) {
    const BallContact* closed = contact.closed_form();
    if (profile.axisymmetric()) {
        return axisymmetric_zones(dynamic_cast<const AxisymmetricContact&>(contact));
    }
    if (closed == nullptr) {
        return integrated_zones(dynamic_cast<const IntegratedContact&>(contact));
    }
    if (tilted && !closed->piecewise_linear()) {
        constexpr double most_m = 90; // Arb's 2F1 takes minutes for greater exponents
        if (profile.parameters().at("m").to<double>() <= most_m) {
            return std::make_unique<TiltedPowerLawZones>(profile, contact_modulus, *closed);
        }
        return integrated_zones(
            IntegratedContact(profile, contact_modulus, closed->a(), closed->b(), closed->bits()));
    }
    return closed_form_zones(*closed, total_force);
}

TractionParts::TractionParts(const BallSlip& slip, const PlaneContact& contact,
                             const Profile& profile, const Exact& contact_modulus, bool tilted)
    : whole_ratio(slip.whole_ratio()) {
    const BallContact* const closed = contact.closed_form();
    const bool integrated = tilted && closed != nullptr && !closed->piecewise_linear();
    for (const ShearPart& part : slip.parts()) {
        const auto& [a, b] = part.zone;
        parts.push_back({integrated ? std::make_shared<IntegratedContact>(profile, contact_modulus,
                                                                          a, b, contact.bits())
                                    : contact.zone(a, b),
                         part.ratio});
    }
}

// docs/stress.md, "The Cauchy integrals of q": in partial slip q = f (p - p*) in the direction of
// Q; after a load history q is a sum of such parts (docs/histories.md).
CauchyIntegral TractionParts::integral(const CauchyIntegral& p, const Box& zeta,
                                       const std::optional<Exact>& x) const {
    CauchyIntegral q = p * whole_ratio;
    for (const auto& [zone, ratio] : parts) {
        q = q + zone->cauchy_integral(zeta, x) * ratio;
    }
    return q;
}

SurfacePotential TractionParts::potential(const SurfacePotential& p, const Ball& x,
                                          const std::optional<Exact>& known) const {
    SurfacePotential q = p * whole_ratio;
    for (const auto& [zone, ratio] : parts) {
        q = q + zone->surface_potential(x, known) * ratio;
    }
    return q;
}

} // namespace edgeproof::contact
