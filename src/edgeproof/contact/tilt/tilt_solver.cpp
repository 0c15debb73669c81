// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/tilt/tilt_solver.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/roots/bracketed_root.hpp"

#include <functional>
#include <string>
#include <utility>

namespace edgeproof::contact {
namespace {

constexpr unsigned rough_digits = 14;
constexpr int most_decades = 1000;
constexpr unsigned spare_digits = 30;
constexpr long spare_bits = 64;
constexpr long most_bits = 1L << 20;

Expr number(long k) { return Expr::number(Rational(k)); }

/// A decimal within the relative distance 10^-digits of v, as an exact number.
Exact decimal(const Real& v, unsigned digits) {
    return Exact::of(
        parse_decimal(v.str(static_cast<std::streamsize>(digits), std::ios_base::scientific)));
}

int sign_or_zero(const Exact& x, bool& certain) {
    try {
        return x.sign();
    } catch (const BudgetError&) {
        certain = false;
        return 0; // not known to differ from 0
    }
}

/// A monotone function y(v) > 0 of one unknown v > 0: v is the distance of the tilt from one end of
/// its range, and y the difference of the moment from its value there. Neither loses digits when
/// both are small.
struct Branch {
    Exact v_end;                               ///< v lies between 0 and v_end
    std::function<Exact(const Exact& v)> tilt; ///< alpha(v)
    Exact moment_at_zero;                      ///< y = sense (M - this)
    int sense;
};

class Solver {
public:
    Solver(const TiltedPunch& punch, const Exact& modulus, const Exact& P)
        : punch_(punch), modulus_(modulus), P_(P) {}

    /// y at v to `wanted` digits, with more bits for those that cancel.
    [[nodiscard]] Real y(const Branch& branch, const Real& v, unsigned wanted) {
        const Profile profile = punch_.at(branch.tilt(decimal(v, wanted + spare_digits)));
        const long enough = formula::bits_for(wanted);
        for (long bits = enough + spare_bits; bits < most_bits; bits *= 2) {
            try {
                ++contacts_;
                const Ball moment = BallContact(profile, modulus_, Load::force(P_), bits).moment();
                const Ball found =
                    (moment - enclosed_constant(branch.moment_at_zero, bits)) * branch.sense;
                if (certainly_positive(found) && found.relative_accuracy_bits() >= enough) {
                    return at_working_precision(found.midpoint());
                }
            } catch (const BudgetError&) {
                // More bits may isolate the edges.
            }
        }
        throw BudgetError("the moment of a tilted punch is lost in roundoff");
    }

    /// The v (a slope) at which y is `target` (a moment per unit length), to `digits` digits.
    [[nodiscard]] Real solve(const Branch& branch, const Exact& target, unsigned digits) {
        const Real rough = [&] {
            const PrecisionScope scope(rough_digits + 30);
            const Real end = log(branch.v_end.to<Real>());
            const auto f = gap(branch, target, rough_digits);
            Real hi = end;
            Real f_hi = f(hi);
            for (int decades = 1; decades <= most_decades * 2; decades *= 2) {
                const Real lo = end - log(Real(10)) * decades;
                const Real f_lo = f(lo);
                if (brackets(f_lo, f_hi)) {
                    return root(f, lo, f_lo, hi, f_hi, pow(Real(10), -13));
                }
                hi = lo;
                f_hi = f_lo;
            }
            throw BudgetError("the moment lies within 1e-1000 of the end of its range");
        }();
        const PrecisionScope scope(digits + 20);
        const auto f = gap(branch, target, digits + 10);
        const Real middle = log(rough);
        for (int width = 8; width > 0; width -= 4) {
            const Real slack = pow(Real(10), -width);
            const Real lo = middle - slack;
            const Real hi = middle + slack;
            const Real f_lo = f(lo);
            const Real f_hi = f(hi);
            if (brackets(f_lo, f_hi)) {
                const Real relative = pow(Real(10), -static_cast<int>(digits)) / (1 + abs(middle));
                return root(f, lo, f_lo, hi, f_hi, relative);
            }
        }
        throw BudgetError("the search for the tilt did not converge");
    }
    [[nodiscard]] std::size_t contacts() const { return contacts_; }

private:
    using RealFunction = std::function<Real(const Real& log_v)>;
    /// ln(y/target) as a function of ln(v), to `digits` digits.
    [[nodiscard]] RealFunction gap(const Branch& branch, const Exact& target, unsigned digits) {
        return [this, &branch, digits, log_target = Real(log(target.to<Real>()))](const Real& x) {
            return Real(log(y(branch, Real(exp(x)), digits)) - log_target);
        };
    }
    [[nodiscard]] static bool brackets(const Real& f_lo, const Real& f_hi) {
        return (f_lo > 0) != (f_hi > 0) || f_lo == 0 || f_hi == 0;
    }
    [[nodiscard]] static Real root(const RealFunction& f, const Real& lo, const Real& f_lo,
                                   const Real& hi, const Real& f_hi, const Real& relative) {
        return exp(roots::bracketed_root<Real>(f, lo, f_lo, hi, f_hi, relative).x);
    }

    const TiltedPunch& punch_;
    const Exact& modulus_;
    const Exact& P_;
    std::size_t contacts_ = 0;
};

/// Decides which of two branches that meet in the middle of the range contains the solution, and
/// solves for the tilt.
SolvedTilt solve_on(Solver& solver, const TiltedPunch& punch, const Branch& near, const Branch& far,
                    const Exact& M, unsigned digits) {
    const auto target = [&](const Branch& b) {
        return Exact(number(b.sense) * (M.expr() - b.moment_at_zero.expr()));
    };
    const bool is_near = [&] {
        const PrecisionScope scope(rough_digits + 30);
        const Real at_middle = solver.y(near, near.v_end.to<Real>(), rough_digits);
        return target(near).to<Real>() <= at_middle;
    }();
    const Branch& branch = is_near ? near : far;
    const unsigned full = digits + 15;
    const Real v = solver.solve(branch, target(branch), full);
    const Exact found = decimal(v, full + 5);
    const Exact alpha = branch.tilt(found);
    const auto neighbour = [found, tilt = branch.tilt](unsigned k, int sense) {
        const Rational part(sense, pow(Integer(10), k));
        return tilt(Exact::of(Rational(found.rational() * (1 + part))));
    };
    return {alpha, punch.at(alpha), solver.contacts(), neighbour};
}

SolvedTilt tilt_of_wedge(const TiltedPunch& punch, const Exact& modulus, const Exact& P,
                         const Exact& M, unsigned digits) {
    const int sense = M.sign();
    if (sense == 0) {
        const Exact upright = Exact::of(Rational(0));
        return {upright, punch.at(upright), 0, {}, true};
    }
    const Exact zero;
    const Exact half(punch.phi.expr() / number(2));
    const Branch near{half, [sense](const Exact& v) { return sense > 0 ? v : Exact(-v.expr()); },
                      zero, sense};
    const Branch far{half,
                     [sense, phi = punch.phi](const Exact& v) {
                         return sense > 0 ? Exact(phi.expr() - v.expr())
                                          : Exact(v.expr() - phi.expr());
                     },
                     zero, sense};
    Solver solver(punch, modulus, P);
    return solve_on(solver, punch, near, far, M, digits);
}

SolvedTilt tilt_of_punch(const TiltedPunch& punch, const Exact& modulus, const Exact& P,
                         const Exact& M, unsigned digits) {
    if (punch.t.sign() == 0) {
        throw InputError("with t = 0 every tilt has the same moment, 0",
                         "give alpha, or P alone with kind = \"power-law\", m = \"1\"");
    }
    const Exact upright(-(punch.t.expr() * P.expr()));
    bool certain = true;
    const int above = sign_or_zero(Exact(M.expr() - upright.expr()), certain);
    if (above == 0) {
        const Exact alpha = Exact::of(Rational(0));
        return {alpha, punch.at(alpha), 0, {}, certain};
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
    const Expr lift =
        Expr::call("sqrt", {number(4) * P.expr() / (Expr::pi() * modulus.expr() * punch.R.expr())});
    const Exact half(lift / number(2));
    const Branch near{half, [](const Exact& v) { return v; }, upright, 1};
    const Branch far{half, [lift](const Exact& v) { return Exact(lift - v.expr()); }, Exact(), -1};
    Solver solver(punch, modulus, P);
    return solve_on(solver, punch, near, far, M, digits);
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

SolvedTilt solve_tilt(const TiltedPunch& punch, const Exact& contact_modulus, const Exact& P,
                      const Exact& M, unsigned digits) {
    if (P.sign() <= 0) {
        throw InputError("the normal force P = " + P.text() + " is not positive", "give P > 0");
    }
    if (contact_modulus.sign() <= 0) {
        throw InputError("the contact modulus " + contact_modulus.text() + " is not positive",
                         "give E* > 0");
    }
    (void)punch.at(Exact::of(Rational(0))); // the parameters themselves
    return punch.kind == Profile::Kind::tilted_wedge
               ? tilt_of_wedge(punch, contact_modulus, P, M, digits)
               : tilt_of_punch(punch, contact_modulus, P, M, digits);
}

namespace {

constexpr unsigned lost_digits = 12;
constexpr int fewest_tilt_digits = 6;

} // namespace

EnclosedTilt enclose_tilt(const TiltedPunch& punch, const Exact& contact_modulus, const Exact& P,
                          const Exact& M, long bits) {
    const auto digits = static_cast<unsigned>(bits * 3 / 10) - lost_digits;
    SolvedTilt found = solve_tilt(punch, contact_modulus, P, M, digits);
    if (!found.neighbour) {
        if (!found.certain) {
            throw BudgetError("the tilt cannot be distinguished from zero");
        }
        return {Ball(0, bits), std::move(found.profile), true};
    }
    const Load load = Load::force(P);
    const Ball moment = enclosed_constant(M, bits);
    // M(alpha) increases with alpha (docs/mechanics.md, "Profiles").
    const auto too_small = [&](const Exact& alpha) { // positive if the tilt is greater than alpha
        return moment - BallContact(punch.at(alpha), contact_modulus, load, bits).moment();
    };
    const int step = static_cast<int>(digits) / 8 + 1;
    for (int k = static_cast<int>(digits); k >= fewest_tilt_digits; k -= step) {
        Exact lo = found.neighbour(static_cast<unsigned>(k), -1);
        Exact hi = found.neighbour(static_cast<unsigned>(k), 1);
        if (Exact(hi.expr() - lo.expr()).sign() < 0) {
            std::swap(lo, hi);
        }
        if (certainly_positive(too_small(lo)) && certainly_negative(too_small(hi))) {
            return {Ball::hull(enclosed_constant(lo, bits), enclosed_constant(hi, bits)),
                    std::move(found.profile)};
        }
    }
    throw BudgetError("ball arithmetic at " + std::to_string(bits) +
                      " bits does not enclose the tilt");
}

} // namespace edgeproof::contact
