// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/enclosure/zone_equations.hpp"

#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/isolate_zero.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <string>

namespace edgeproof::contact {
namespace {

constexpr int most_zone_steps = 400;
constexpr int most_growing_steps = 60;
constexpr long bits_of_a_zone_step = 12; ///< bits lost when Newton's steps have converged
constexpr long bits_of_rates = 24;       ///< after so small a step, relatively, the rates are kept
constexpr long more_of_left_edge = 24;   ///< bits in a search of the right edge

} // namespace

/// Returns (E*/4) times the integral of (g' + tilt)/w (docs/partial-slip.md, "Enclosed").
Ball ZoneEquations::turn(const ZoneValues& v) const {
    return symmetric ? Ball(0, modulus.bits())
                     : modulus * Ball::pi(modulus.bits()) / 4 * (v.mean_slope + tilt);
}

/// G_+- = F - P +- D turn, which at the zone have the rates dP/da by a and dP/db by b alone
/// (docs/partial-slip.md, "The corrective contact"); for a given right edge 0 and -2 D turn.
ZoneRates ZoneEquations::differences(const BallZone& zone) const {
    const ZoneValues v = values(zone);
    const Ball turned = zone.length() * turn(v);
    const Ball missing = force ? v.force - *force : -turned;
    return {missing + turned, missing - turned};
}

BallZone ZoneEquations::search(const BallZone& start) const {
    const long bits = modulus.bits();
    ZoneEquations wanted(*this); // without the radii
    wanted.tilt = middle(tilt);
    wanted.force = force ? std::optional(middle(*force)) : std::nullopt;
    BallZone at{middle(right_edge ? *right_edge : start.a), middle(start.b)};
    const Ball tiny = power_of_two(bits_of_a_zone_step - bits, bits);
    const Ball half_the_bits = power_of_two(-(bits / 2), bits);
    const Ball small = power_of_two(-bits_of_rates, bits);
    std::optional<Ball> before;
    std::optional<BallZone> last; // where the values were finite
    std::optional<ZoneRates> kept;
    ZoneRates last_step{Ball(0, bits), Ball(0, bits)};
    int growing = 0;
    for (int k = 0; k < most_zone_steps; ++k) {
        check_interruption();
        const Ball D = at.length();
        const ZoneRates missing = wanted.differences(at);
        if (!kept) {
            kept = rates(at);
        }
        ZoneRates step{middle(missing.right / kept->right), middle(missing.left / kept->left)};
        if (right_edge) {
            step.right = Ball(0, bits);
        } else if (symmetric) {
            step.left = step.right;
        }
        if (!step.right.is_finite() || !step.left.is_finite()) {
            kept.reset();
            if (!last && k > 0) {
                break;
            }
            if (!last) { // a start with an edge on a corner
                const Ball inwards = D * power_of_two(-10, bits);
                at = {right_edge ? at.a : middle(at.a - inwards), middle(at.b - inwards)};
                continue;
            }
            // The step went beyond the knots that carry the zone, such as the one corner of a
            // wedge.
            at = {middle((at.a + last->a) / 2), middle((at.b + last->b) / 2)};
            continue;
        }
        last = at;
        // Across a corner, where the rates are infinite, the steps may go back and forth for ever.
        const auto damped = [](Ball& now, Ball& previous) {
            if (certainly_negative(now * previous) && certainly_less(abs(previous), abs(now) * 2)) {
                now = middle(now / 2);
            }
            previous = now;
        };
        damped(step.right, last_step.right);
        damped(step.left, last_step.left);
        // A step removes less than the whole zone.
        const Ball limit = D * Ball(Rational(7, 16), bits);
        const Ball most = max(abs(step.right), abs(step.left));
        if (certainly_less(limit, most)) {
            step.right *= limit / most;
            step.left *= limit / most;
        }
        at = {middle(at.a - step.right), middle(at.b - step.left)};
        const Ball size = abs(step.right) + abs(step.left);
        if (!certainly_less(tiny * (abs(at.a) + abs(at.b)), size)) {
            return at;
        }
        if (before && !certainly_less(size, *before) && certainly_less(size, half_the_bits * D)) {
            return at; // roundoff
        }
        if ((before && !certainly_less(size * 2, *before)) || !certainly_less(size, small * D)) {
            kept.reset();
        }
        growing += before && certainly_less(*before, size) ? 1 : 0;
        if (growing > most_growing_steps) {
            break;
        }
        before = size;
    }
    throw BudgetError("no zone of the contact was found at " + std::to_string(bits) + " bits");
}

// Interval Newton, edge by edge: where the image of a box lies inside it, the box contains exactly
// one zone (moore-kearfott-cloud2009). G_+ and G_- have the derivatives (dP/da + turn, turn) and
// (-turn, dP/db - turn), where turn is 0 at the zone: no matrix is inverted (docs/partial-slip.md,
// "The corrective contact"). If a is given, the derivative of -2 D turn by b is dP/db - 2 turn.
BallZone ZoneEquations::proved(const BallZone& found) const {
    const long bits = modulus.bits();
    const BallZone m{right_edge ? *right_edge : middle(found.a), middle(found.b)};
    const ZoneRates missing = differences(m);
    const ZoneRates at = rates(m);
    const Ball least = power_of_two(4 - bits, bits) * m.length();
    Ball radius_a = abs(missing.right / at.right) * 2 + least;
    Ball radius_b = symmetric ? radius_a : abs(missing.left / at.left) * 2 + least;
    for (long k = 0; 5 * k < bits && radius_a.is_finite() && radius_b.is_finite(); ++k) {
        const BallZone box{right_edge ? *right_edge
                                      : Ball::around(m.a.midpoint(), radius_a.upper(), bits),
                           Ball::around(m.b.midpoint(), radius_b.upper(), bits)};
        const ZoneRates v = rates(box);
        const Ball off = symmetric ? Ball(0, bits) : turn(values(box));
        BallZone image = box;
        if (right_edge) {
            image.b = m.b - missing.left / (v.left - off * 2);
        } else {
            image.a = m.a - (missing.right + off * (box.b - m.b)) / (v.right + off);
            image.b =
                symmetric ? image.a : m.b - (missing.left - off * (box.a - m.a)) / (v.left - off);
        }
        if (certainly_positive(box.length()) && image.a.is_finite() && image.b.is_finite() &&
            contains(box.a, image.a) && contains(box.b, image.b)) {
            return image;
        }
        radius_a = middle(radius_a * 32);
        radius_b = middle(radius_b * 32);
    }
    throw BudgetError("ball arithmetic at " + std::to_string(bits) +
                      " bits does not isolate the edges of the zone");
}

// The mean slope increases with the right edge and decreases with the left one; F increases with
// both.
BallZone ZoneEquations::from_afar(const Distances& distances, long accuracy) const {
    const auto balanced = [&](const Ball& a, const Ball& start) {
        if (symmetric) {
            return BallZone{a, a};
        }
        const Ball b_from = distances.b_from ? *distances.b_from : -a;
        const auto zone = [&](const Ball& y) { return BallZone{a, middle(b_from + y)}; };
        const Ball left = approximate_zero([&](const Ball& y) { return turn(values(zone(y))); },
                                           [&](const Ball& y) {
                                               const BallZone at = zone(y);
                                               return -rates(at).left / (at.length() * 2);
                                           },
                                           start, "the left edge", accuracy + more_of_left_edge);
        return zone(left);
    };
    if (right_edge) {
        return balanced(middle(*right_edge), distances.first);
    }
    std::optional<BallZone> zone; // for the rate the one of the value before it
    const auto missing = [&](const Ball& x) {
        zone = balanced(middle(distances.a_from + x), x);
        return *force - values(*zone).force;
    };
    const Ball right = approximate_zero(
        missing, [&](const Ball&) { return -rates(*zone).right; }, distances.first,
        "the right edge", accuracy);
    return balanced(middle(distances.a_from + right), right);
}

} // namespace edgeproof::contact
