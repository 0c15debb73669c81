// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/curved/integrated_zones.hpp"
#include "edgeproof/formula/exact/enclosed_constant.hpp"

namespace edgeproof::contact {
namespace {

/// For g' = C sgn(x) |x|^m, with s = a t (DLMF 15.6.1, 5.12.1),
///   integral of s^p (a - s)^(q - 1) (b + s)^(-r) over 0 < s < a
///     = a^(p + q) b^(-r) B(p + 1, q) 2F1(r, p + 1; p + 1 + q; -a/b).
class TiltedPowerLawZones : public ZoneSolver {
public:
    TiltedPowerLawZones(const Profile& profile, const formula::Exact& modulus, const Ball& a,
                        const Ball& b, long bits)
        : integrals_(integrated_zones(IntegratedContact(profile, modulus, a, b, bits))),
          exponent_(formula::enclosed_constant(profile.parameters().at("m"), bits)),
          factor_(formula::enclosed_constant(profile.parameters().at("C"), bits)) {}
    [[nodiscard]] long bits() const override { return integrals_->bits(); }
    [[nodiscard]] const Ball& modulus() const override { return integrals_->modulus(); }
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
        const Ball scale = modulus() * factor_ / 2;
        // A and B (docs/mechanics.md, "One measure, six kernels") with dg' = C m |v|^(m - 1) dv
        const auto rate = [&](const Ball& to, const Ball& from) {
            return scale * m *
                   (half_integral(to, from, m - 1, half, -half) +
                    half_integral(from, to, m - 1, half + 1, half));
        };
        // The force and the mean slope (docs/partial-slip.md, "The corrective contact")
        return {scale * (moments - (a - b) / 2 * (right - left)),
                factor_ * (right - left) / Ball::pi(bits()), rate(a, b), rate(b, a)};
    }
    [[nodiscard]] Ball pressure(const BallZone& zone, Edge edge, const Ball& u) const override {
        return integrals_->pressure(zone, edge, u);
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

std::unique_ptr<ZoneSolver> power_law_zones(const Profile& profile,
                                            const formula::Exact& contact_modulus, const Ball& a,
                                            const Ball& b, long bits) {
    return std::make_unique<TiltedPowerLawZones>(profile, contact_modulus, a, b, bits);
}

} // namespace edgeproof::contact
