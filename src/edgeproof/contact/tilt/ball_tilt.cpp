// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/tilt/ball_tilt.hpp"

#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/precision/error.hpp"

#include <string>
#include <utility>

namespace edgeproof::contact {
namespace {

constexpr unsigned lost_digits = 12;
constexpr int fewest_tilt_digits = 6;

} // namespace

EnclosedTilt enclose_tilt(const TiltedPunch& punch, const formula::Exact& contact_modulus,
                          const formula::Exact& P, const formula::Exact& M, long bits) {
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
    const auto too_small =
        [&](const formula::Exact& alpha) { // positive if the tilt is greater than alpha
            return moment - BallContact(punch.at(alpha), contact_modulus, load, bits).moment();
        };
    const int step = static_cast<int>(digits) / 8 + 1;
    for (int k = static_cast<int>(digits); k >= fewest_tilt_digits; k -= step) {
        formula::Exact lo = found.neighbour(static_cast<unsigned>(k), -1);
        formula::Exact hi = found.neighbour(static_cast<unsigned>(k), 1);
        if (formula::Exact(hi.expr() - lo.expr()).sign() < 0) {
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
