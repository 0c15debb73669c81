// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/profile/profile.hpp"

#include "edgeproof/contact/profile/slope.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/real.hpp"

#include <string>

namespace edgeproof::contact {
namespace {

constexpr unsigned check_digits = 60;
constexpr int samples = 64;

/// Messages show the place with 8 digits.
std::string short_text(const Real& x) { return x.str(8); }

/// The sign of an exact constant; a constant that 4096 bits do not separate from zero counts as
/// zero.
int sign_or_zero(const Expr& e) {
    try {
        return Exact(e).sign();
    } catch (const Error&) {
        return 0;
    }
}

[[noreturn]] void not_convex(const std::string& where) {
    throw InputError("g' decreases " + where, "give a convex profile: g' must not decrease");
}

} // namespace

/// The conditions on g' are those of docs/mechanics.md.
std::vector<bool> checked_corners(const Profile& profile) {
    const PrecisionScope scope(check_digits);
    const auto& knots = profile.knots();
    // For a symmetric profile only the right half is checked, so that messages show the given half
    // and not its mirror image. The origin is the middle knot.
    const std::size_t first = profile.symmetric() ? knots.size() / 2 : 0;
    for (std::size_t i = first; i + 1 < knots.size(); ++i) {
        if (Exact(knots[i + 1].expr() - knots[i].expr()).sign() <= 0) {
            throw InputError("knots do not ascend: " + knots[i].text() + " is followed by " +
                                 knots[i + 1].text(),
                             "list knots from left to right, each once");
        }
    }
    const RealSlope slope(profile);
    std::vector<bool> corner(knots.size(), false);
    for (std::size_t i = first; i < knots.size(); ++i) {
        const Expr at = knots[i].expr();
        const int jump = sign_or_zero(substitute(profile.pieces()[i + 1].slope, "x", at) -
                                      substitute(profile.pieces()[i].slope, "x", at));
        if (jump < 0) {
            not_convex("across the knot x = " + knots[i].text());
        }
        corner[i] = jump > 0;
        if (first > 0) {
            corner[knots.size() - 1 - i] = corner[i];
        }
    }
    const Expr zero = Expr::number(0);
    const std::size_t o = profile.origin();
    if (sign_or_zero(substitute(profile.pieces()[o].slope, "x", zero)) > 0 ||
        sign_or_zero(substitute(profile.pieces()[o + 1].slope, "x", zero)) < 0) {
        throw InputError("the minimum of the profile is not at the origin: g' has the same sign on "
                         "both sides of x = 0",
                         "move the origin to the minimum of the profile");
    }
    for (std::size_t i = first > 0 ? first + 1 : 0; i <= knots.size(); ++i) {
        const SlopePiece& piece = profile.pieces()[i];
        if (piece.linear) {
            if (sign_or_zero(piece.linear->rate) < 0) {
                not_convex("along the piece " + to_text(piece.slope));
            }
            continue;
        }
        if (i == 0 || i == knots.size()) {
            continue; // outer pieces: rising_limit
        }
        Real previous = 0;
        for (int k = 0; k <= samples; ++k) {
            const Real lo = slope.knots()[i - 1];
            const Real hi = slope.knots()[i];
            const Real x = lo + (hi - lo) * (Real(k) + Real(1) / 2) / Real(samples + 1);
            Real g;
            try {
                g = slope.value(i, x);
            } catch (const DomainError&) {
                throw InputError("g' = " + to_text(piece.slope) +
                                     " has no value at x = " + short_text(x),
                                 "give an expression that has values on its whole piece");
            }
            if (k > 0 && g < previous) {
                not_convex("near x = " + short_text(x) + " (" + to_text(piece.slope) + ")");
            }
            previous = g;
        }
    }
    return corner;
}

namespace {

Rational dyadic(int k) {
    const Rational q(Integer(1) << static_cast<unsigned>(k < 0 ? -k : k));
    return k < 0 ? Rational(1 / q) : q;
}

} // namespace

std::optional<RisingLimit> rising_limit(const Profile& profile, Edge edge) {
    constexpr int decades_of_two = 30;
    constexpr int halvings = 24;
    const PrecisionScope scope(check_digits);
    const bool right = edge == Edge::right;
    const SlopePiece& piece = right ? profile.pieces().back() : profile.pieces().front();
    if (piece.linear) {
        return std::nullopt;
    }
    const RealSlope g(profile);
    const std::size_t outer = right ? profile.knots().size() : 0;
    const Real last = right ? g.knots().back() : g.knots().front();
    const auto place = [&](const Rational& away) {
        const Real d = from_rational<Real>(away);
        return right ? Real(last + d) : Real(last - d);
    };
    // g', positive outwards; nothing where g' has no finite value
    const auto value = [&](const Rational& away) -> std::optional<Real> {
        try {
            const Real there = g.value(outer, place(away));
            return isfinite(there) ? std::optional(right ? there : Real(-there)) : std::nullopt;
        } catch (const DomainError&) {
            return std::nullopt;
        }
    };
    const auto falls = [&](const Rational& away) {
        try {
            return g.rate(outer, place(away)) < 0;
        } catch (const DomainError&) {
            return false; // g'' is not finite
        }
    };
    Rational good(0);
    Real previous(0);
    const auto still_rises = [&](const Rational& away) {
        const auto there = value(away);
        return there && (good == 0 || !(*there < previous)) && !falls(away);
    };
    const auto advance = [&](const Rational& away) {
        good = away;
        previous = *value(away);
    };
    std::optional<Rational> bad;
    for (int k = -decades_of_two; k <= decades_of_two && !bad; ++k) {
        const Rational away = dyadic(k);
        if (still_rises(away)) {
            advance(away);
        } else {
            bad = away;
        }
    }
    if (!bad) {
        return std::nullopt;
    }
    if (good == 0) {
        const Real x = place(*bad);
        if (!value(*bad)) {
            throw InputError("g' = " + to_text(piece.slope) +
                                 " has no value at x = " + short_text(x),
                             "give an expression that has values near the knot of its piece");
        }
        not_convex("near x = " + short_text(x) + " (" + to_text(piece.slope) + ")");
    }
    for (int k = 0; k < halvings; ++k) {
        const Rational middle = (good + *bad) / 2;
        if (still_rises(middle)) {
            advance(middle);
        } else {
            bad = middle;
        }
    }
    // The limit is moved back by about a millionth, so that a pole, such as one of tan(x), lies
    // outside.
    const Rational away = good * (1 - dyadic(-20));
    const Real steep = value(away).value_or(previous) / from_rational<Real>(away);
    if (steep > Real(1e300)) {
        return std::nullopt; // beyond the range of binary64 (an exponential): it still rises
    }
    const double rate = steep.convert_to<double>();
    const Expr knot = right ? profile.knots().back().expr() : profile.knots().front().expr();
    const Rational* q = knot.rational();
    const Rational moved = right ? away : Rational(-away);
    return RisingLimit{q != nullptr ? Exact::of(Rational(*q + moved))
                                    : Exact(knot + Expr::number(moved)),
                       exact_rational(rate > 0 ? rate : 1), piece.slope};
}

void check_reach(const Profile& profile, const Ball& a, const Ball& b) {
    for (const Edge edge : {Edge::right, Edge::left}) {
        const auto& limit = profile.rises_to(edge);
        if (!limit) {
            continue;
        }
        const bool right = edge == Edge::right;
        const Ball left_over = right ? enclosed_constant(*limit, a.bits()) - a
                                     : -b - enclosed_constant(*limit, b.bits());
        if (!certainly_positive(left_over)) {
            const Expr& slope = right ? profile.pieces()[profile.pieces().size() - 2].slope
                                      : profile.pieces()[1].slope;
            const PrecisionScope scope(check_digits);
            throw InputError(
                "the contact would reach x = " +
                    short_text(right ? a.midpoint() : Real(-b.midpoint())) +
                    ", and g' = " + to_text(slope) +
                    " could not be shown to rise beyond x = " + short_text(limit->to<Real>()),
                "give a smaller load, or the slope further out");
        }
    }
}

} // namespace edgeproof::contact
