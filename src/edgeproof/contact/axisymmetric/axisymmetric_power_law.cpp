// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/axisymmetric/axisymmetric_contact.hpp"
#include "edgeproof/precision/error.hpp"

namespace edgeproof::contact {
namespace {

Expr number(long k) { return Expr::number(Rational(k)); }

/// Gamma((m + 1)/2)/Gamma(m/2 + 1); for whole m up to 100 without the gamma function, from
/// sqrt(pi) and 2/sqrt(pi) by Gamma(x + 1) = x Gamma(x) (DLMF 5.5.1).
Expr gamma_ratio(const Expr& m) {
    const Rational* q = m.rational();
    if (q == nullptr || denominator(*q) != 1 || *q > 100) {
        return Expr::call("gamma", {(m + number(1)) / number(2)}) /
               Expr::call("gamma", {m / number(2) + number(1)});
    }
    const long n = q->convert_to<long>();
    const Expr root = Expr::call("sqrt", {Expr::pi()});
    Expr ratio = n % 2 == 0 ? root : number(2) / root;
    for (long k = n % 2 + 2; k <= n; k += 2) {
        ratio = ratio * number(k - 1) / number(k);
    }
    return ratio;
}

} // namespace

AxisymmetricPowerLaw AxisymmetricPowerLaw::of(const Profile& profile) {
    if (profile.kind() != Profile::Kind::power_law) {
        throw InputError("a " + profile.kind_name() + " profile is not an axisymmetric power law",
                         "write power-law (sphere: m = 1, C = 1/R; cone: m = 0)");
    }
    const Expr m = profile.parameters().at("m").expr();
    const Expr C = profile.parameters().at("C").expr();
    return {C, m, C * Expr::call("sqrt", {Expr::pi()}) * gamma_ratio(m) / number(2)};
}

// With h(s) = s integral_0^s g'(r)/sqrt(s^2 - r^2) dr = kappa s^(m+1), the pressure is that of a
// plane contact whose P'(s) is E* h'(s).
Profile AxisymmetricPowerLaw::plane() const {
    const Expr ratio = gamma_ratio(m);
    return Profile::power_law(Exact(C * (m + number(1)) * ratio * ratio / number(2)), Exact(m));
}

Exact AxisymmetricPowerLaw::approach(const Exact& a) const {
    return Exact(kappa * pow(a.expr(), m + number(1)));
}

Expr AxisymmetricPowerLaw::force_factor(const Exact& modulus) const {
    return number(2) * modulus.expr() * (m + number(1)) * kappa / (m + number(2));
}

Exact AxisymmetricPowerLaw::force(const Exact& modulus, const Exact& a) const {
    return Exact(force_factor(modulus) * pow(a.expr(), m + number(2)));
}

Exact AxisymmetricPowerLaw::radius(const Exact& modulus, const Exact& P) const {
    return Exact(pow(P.expr() / force_factor(modulus), number(1) / (m + number(2))));
}

Exact AxisymmetricPowerLaw::radius_at(const Exact& delta) const {
    return Exact(pow(delta.expr() / kappa, number(1) / (m + number(1))));
}

} // namespace edgeproof::contact
