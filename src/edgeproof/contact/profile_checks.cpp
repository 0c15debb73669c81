// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/profile_checks.hpp"

#include "edgeproof/contact/slope.hpp"
#include "edgeproof/precision/error.hpp"

#include <string>

namespace edgeproof {
namespace {

constexpr unsigned check_digits = 60;
constexpr int samples = 64;

/// A user reads the place in a few digits.
std::string short_text(const Real& x) { return x.str(8); }

/// The sign of an exact constant; what 4096 bits cannot tell from zero counts as zero.
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

std::vector<bool> checked_corners(const Profile& profile) {
    const PrecisionScope scope(check_digits);
    const auto& knots = profile.knots();
    // Of a symmetric profile the right half alone: messages show what was given, not its mirror
    // image. The origin is its middle knot.
    const std::size_t first = profile.symmetric() ? knots.size() / 2 : 0;
    for (std::size_t i = first; i + 1 < knots.size(); ++i) {
        if (Exact(knots[i + 1].expr() - knots[i].expr()).sign() <= 0) {
            throw InputError("knots do not ascend: " + knots[i].text() + " is followed by " +
                                 knots[i + 1].text(),
                             "list knots from left to right, each once");
        }
    }
    const SlopeIn<Real> slope(profile);
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
        // An unbounded piece is looked at over 2^-30 ... 2^30 from its end.
        Real previous = 0;
        bool any = false;
        for (int k = 0; k <= samples; ++k) {
            Real x;
            if (i > 0 && i < knots.size()) {
                const Real lo = slope.knots()[i - 1];
                const Real hi = slope.knots()[i];
                x = lo + (hi - lo) * (Real(k) + Real(1) / 2) / Real(samples + 1);
            } else {
                const Real away = ldexp(Real(1), (i > 0 ? k : samples - k) * 60 / samples - 30);
                x = i > 0 ? Real(slope.knots()[i - 1] + away) : Real(slope.knots()[i] - away);
            }
            Real g;
            try {
                g = slope.value(i, x);
            } catch (const DomainError&) {
                if (i > 0 && i < knots.size()) {
                    throw InputError("g' = " + to_text(piece.slope) +
                                         " has no value at x = " + short_text(x),
                                     "give an expression that holds on its whole piece");
                }
                continue; // an outer piece need not extend for ever
            }
            if (any && g < previous) {
                not_convex("near x = " + short_text(x) + " (" + to_text(piece.slope) + ")");
            }
            previous = g;
            any = true;
        }
    }
    return corner;
}

} // namespace edgeproof
