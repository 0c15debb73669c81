// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/tilt/tilt_solver.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/isolate_zero.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace edgeproof::contact {
namespace {

constexpr long fewest_bits = 80; ///< of the search from which the last steps start
constexpr long bits_of_search = 24;

Expr number(long k) { return Expr::number(Rational(k)); }

EnclosedTilt upright(const TiltedPunch& punch, long bits) {
    return {Ball(0, bits), punch.at(Exact::of(Rational(0))), true};
}

/// The tilt with the sign `sense` whose size is the distance v from 0 (`near`), or from `end`:
/// small distances keep their digits.
EnclosedTilt tilt_at(const TiltedPunch& punch, const Ball& v, bool near, const Exact& end,
                     int sense) {
    const Expr middle = Expr::number(exact_value(v.midpoint()));
    const Exact tilt(number(sense) * (near ? middle : end.expr() - middle));
    return {(near ? v : enclosed_constant(end, v.bits()) - v) * sense, punch.at(tilt)};
}

// With b/a = (1 - sin(theta))/(1 + sin(theta)), theta = pi alpha/(2 phi), P = E* phi sqrt(a b) and
// M = P (a - b)/4 (docs/mechanics.md, "Profiles"): tan(theta) = 2 E* phi M/P^2.
EnclosedTilt tilt_of_wedge(const TiltedPunch& punch, const Ball& modulus, const Ball& P,
                           const Exact& M) {
    const long bits = P.bits();
    if (M.sign() == 0) {
        return upright(punch, bits);
    }
    const Ball phi = enclosed_constant(punch.phi, bits);
    const Ball of_moment = modulus * phi * abs(enclosed_constant(M, bits)) * 2;
    const Ball of_force = P * P;
    const bool near = !certainly_less(of_force, of_moment);
    const Ball theta = near ? atan2(of_moment, of_force) : atan2(of_force, of_moment);
    return tilt_at(punch, theta * phi * 2 / Ball::pi(bits), near, punch.phi, M.sign());
}

EnclosedTilt tilt_of_flat(const TiltedPunch& punch, const Exact& modulus, const Exact& P,
                          const Exact& M, long bits) {
    if (punch.t.sign() == 0) {
        throw InputError("with t = 0 every tilt has the same moment, 0",
                         "give alpha, or P alone with kind = \"power-law\", m = \"1\"");
    }
    const int above = Exact(M.expr() + punch.t.expr() * P.expr()).sign();
    if (above == 0) {
        return upright(punch, bits);
    }
    if (above < 0) {
        throw InputError("no tilt alpha >= 0 has the moment M = " + M.text() +
                             ": upright, M is -t P already, and it rises with alpha",
                         "mirror the scene for a punch that leans the other way");
    }
    if (M.sign() >= 0) {
        throw InputError("no tilt has the moment M = " + M.text() +
                             " alone: about the minimum of the punch M lies between -t P and 0, "
                             "and is 0 for every tilt that lifts the flat off",
                         "give M about that minimum (M_c - P (t + alpha R) from the middle of the "
                         "flat), or alpha itself");
    }
    // The tilt from which on the contact lies within one arc: there P = pi E* c^2/(4 R) (Hertz,
    // docs/mechanics.md) with c = alpha R.
    const Exact lift(Expr::call(
        "sqrt", {number(4) * P.expr() / (Expr::pi() * modulus.expr() * punch.R.expr())}));
    const Profile like = punch.at(Exact(lift.expr() / number(2)));
    const auto contact_at = [&](const Ball& alpha) {
        return BallContact(like, alpha, modulus, Load::force(P), alpha.bits());
    };
    const bool near = certainly_less(enclosed_constant(M, bits),
                                     contact_at(enclosed_constant(lift, bits) / 2).moment());
    // y(v), the moment less that at v = 0, or its negative, rises with v to t P at the other end;
    // |dM/dalpha| = pi E* c^2/4 - P R (docs/mechanics.md, "Profiles").
    const Exact of_end(near ? M.expr() + punch.t.expr() * P.expr() : -M.expr());
    struct Values {
        Ball y;
        Ball rate;
    };
    const auto values = [&](const Ball& v) -> Values {
        const long b = v.bits();
        const BallContact contact = contact_at(near ? v : enclosed_constant(lift, b) - v);
        const Ball from_upright =
            contact.moment() + enclosed_constant(punch.t, b) * enclosed_constant(P, b);
        const Ball c = contact.length() / 2;
        return {near ? from_upright : -contact.moment(),
                Ball::pi(b) * contact.modulus() * c * c / 4 -
                    enclosed_constant(P, b) * enclosed_constant(punch.R, b)};
    };
    Ball last_place(0, bits);
    std::optional<Values> last;
    const auto values_at = [&](const Ball& v) -> const Values& {
        if (!last || v.bits() != last_place.bits() || arb_equal(v.data(), last_place.data()) == 0) {
            last.emplace(values(v));
            last_place = v;
        }
        return *last;
    };
    const auto missing = [&](const Ball& at) {
        check_interruption();
        return enclosed_constant(of_end, at.bits()) - values_at(at).y;
    };
    const auto rate = [&](const Ball& at) { return -values_at(at).rate; };
    // The tilt lies between the nearer end and the middle.
    const long coarse = std::max(fewest_bits, bits / 2);
    const Ball found = approximate_zero(missing, rate, enclosed_constant(lift, coarse) / 2,
                                        "the tilt", bits_of_search);
    const Ball v = isolate_zero(missing, rate, found.with_bits(bits), "the tilt", true);
    return tilt_at(punch, v, near, lift, 1);
}

} // namespace

TiltedPunch TiltedPunch::wedge(Exact phi) {
    return {Profile::Kind::tilted_wedge, std::move(phi), {}, {}};
}
TiltedPunch TiltedPunch::flat_and_rounded(Exact t, Exact R) {
    return {Profile::Kind::tilted_flat_and_rounded, {}, std::move(t), std::move(R)};
}
Profile TiltedPunch::at(const Exact& alpha) const {
    return kind == Profile::Kind::tilted_wedge ? Profile::tilted_wedge(phi, alpha)
                                               : Profile::tilted_flat_and_rounded(alpha, t, R);
}

EnclosedTilt enclose_tilt(const TiltedPunch& punch, const Exact& contact_modulus, const Exact& P,
                          const Exact& M, long bits) {
    if (P.sign() <= 0) {
        throw InputError("the normal force P = " + P.text() + " is not positive", "give P > 0");
    }
    if (contact_modulus.sign() <= 0) {
        throw InputError("the contact modulus " + contact_modulus.text() + " is not positive",
                         "give E* > 0");
    }
    (void)punch.at(Exact::of(Rational(0))); // the parameters themselves
    return punch.kind == Profile::Kind::tilted_wedge
               ? tilt_of_wedge(punch, enclosed_constant(contact_modulus, bits),
                               enclosed_constant(P, bits), M)
               : tilt_of_flat(punch, contact_modulus, P, M, bits);
}

} // namespace edgeproof::contact
