// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/slip/dissipation.hpp"

#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/precision/ball/ball_series.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

namespace edgeproof::contact {
namespace {

constexpr std::size_t most_energy_panels = 20'000;

using Cut = SlipPhase::Cut;

/// c0 + c1 x + c2 x^2 with x = L - at.
struct Quadratic {
    Ball at;
    std::array<Ball, 3> c;

    template <class L> [[nodiscard]] L operator()(const L& force) const {
        const L x = force + (-at);
        return (x * c[2] + c[1]) * x + c[0];
    }
};

/// The integral over the time of a phase, 0 to 1, of P - L as long as L_s < L < P: a function of L
/// that is quadratic between two cuts. Throws BudgetError if the bits do not distinguish the cuts.
Quadratic weight_between(const SlipPhase& s, const Ball& from, const Ball& to) {
    const Ball centre = (from + to) / 2;
    const auto beyond = [&](const Ball& force) { // centre > force
        if (!certainly_less(force, centre) && !certainly_less(centre, force)) {
            throw BudgetError("too few bits to distinguish the forces of a step");
        }
        return certainly_less(force, centre);
    };
    const Ball growth = s.force_to - s.force_from;
    const bool before_slip = !beyond(s.inner_from); // L_s has to decrease to L first
    const bool late = beyond(s.force_from);         // P has to increase to L first
    const bool ends = beyond(s.force_to);           // P decreases below L
    const auto at = [&](const Ball& L) {
        Ball begin(0, L.bits());
        Ball end(1, L.bits());
        if (before_slip) {
            begin = (s.inner_from - L) / (s.inner_from - s.inner_to);
        } else if (late) {
            begin = (L - s.force_from) / growth;
        }
        if (ends) {
            end = (L - s.force_from) / growth;
        }
        return (end - begin) * (s.force_from - L + growth * (begin + end) / 2);
    };
    const Ball half = (to - from) / 2;
    const Ball lower = at(from);
    const Ball mean = at(centre);
    const Ball upper = at(to);
    return {centre,
            {mean, (upper - lower) / (half * 2), (upper - mean * 2 + lower) / (half * half * 2)}};
}

/// 2 f/(pi E*) times the sum of the integrals of the weights d ln D, which `integral` returns for a
/// weight and two cuts.
template <class Integral>
Ball energy_of(const Ball& modulus, const Ball& friction, const std::vector<SlipPhase>& phases,
               const Integral& integral) {
    Ball sum(0, modulus.bits());
    for (const SlipPhase& phase : phases) {
        Ball part(0, modulus.bits());
        for (std::size_t i = 0; i + 1 < phase.cuts.size(); ++i) {
            const Cut& from = phase.cuts[i];
            const Cut& to = phase.cuts[i + 1];
            part += integral(weight_between(phase, from.force, to.force), from, to);
        }
        sum += phase.change * part;
    }
    return sum * friction * 2 / (Ball::pi(modulus.bits()) * modulus);
}

/// The integral of a weight d ln D between two cuts, over panels of the right edge.
class GrowthIntegral {
public:
    GrowthIntegral(const BallContact& contact, Quadratic weight, const Cut& from, const Cut& to)
        : contact_(contact), weight_(std::move(weight)), bits_(contact.bits()), from_(from),
          to_(to), terms_(2 * (static_cast<std::size_t>(bits_) / 8) + 1) {
        const Ball most =
            max(max(abs(weight_(from.force)), abs(weight_(to.force))), abs(weight_.c[0]));
        enough_ = middle(most * stretch(from, to) * power_of_two(bits_ / 8 - bits_, bits_));
    }

    [[nodiscard]] Ball total() const {
        const Cut lo = at(upper_end(from_.zone.a));
        const Cut hi = at(lower_end(to_.zone.a));
        if (!certainly_less(lo.zone.a, hi.zone.a)) {
            throw BudgetError("too few bits to distinguish the zones of a step");
        }
        Ball sum = between_ends(from_, lo) + between_ends(hi, to_);
        std::vector<std::pair<Cut, Cut>> panels{{lo, hi}};
        for (std::size_t count = 0; !panels.empty(); ++count) {
            check_interruption();
            if (count > most_energy_panels) {
                throw BudgetError("the energy of a step takes too many panels");
            }
            const auto [from, to] = std::move(panels.back());
            panels.pop_back();
            const Ball centre = middle((from.zone.a + to.zone.a) / 2);
            const bool divisible =
                certainly_less(from.zone.a, centre) && certainly_less(centre, to.zone.a);
            const Ball crude = between_ends(from, to);
            if (!divisible || certainly_less(Ball(crude.radius(), bits_), enough_)) {
                sum += crude;
            } else if (const auto fine = by_taylor(from, centre, to)) {
                sum += *fine;
            } else {
                const Cut between = at(centre);
                panels.emplace_back(between, to);
                panels.emplace_back(from, between);
            }
        }
        return sum;
    }

private:
    [[nodiscard]] Cut at(const Ball& a) const {
        return {contact_.between(a, a).zone_force(), {a, a}};
    }
    /// Returns ln(D_to/D_from).
    [[nodiscard]] static Ball stretch(const Cut& from, const Cut& to) {
        return log1p((to.zone.a - from.zone.a) / from.zone.a);
    }
    /// Bounds the integral over a panel; L increases with the edge.
    [[nodiscard]] Ball between_ends(const Cut& from, const Cut& to) const {
        return weight_(Ball::hull(from.force, to.force)) * clamped(stretch(from, to));
    }
    /// The integral over a panel; nothing if the remainder is not small enough.
    [[nodiscard]] std::optional<Ball> by_taylor(const Cut& from, const Ball& centre,
                                                const Cut& to) const {
        const Ball lo = from.zone.a - centre;
        const Ball hi = to.zone.a - centre;
        // The integrals of z^k. The last power is even, so that the remainder is a value of the
        // last coefficient times its integral (Taylor's theorem and the mean value theorem).
        Ball lo_power = lo;
        Ball hi_power = hi;
        std::vector<Ball> moments;
        for (std::size_t k = 0; k < terms_; ++k) {
            moments.push_back((hi_power - lo_power) / static_cast<long>(k + 1));
            lo_power *= lo;
            hi_power *= hi;
        }
        const Ball remainder =
            integrand(Ball::hull(from.zone.a, to.zone.a))[terms_ - 1] * moments.back();
        if (!remainder.is_finite() || !certainly_less(abs(remainder), enough_)) {
            return {};
        }
        const BallSeries f = integrand(centre);
        Ball sum = remainder;
        for (std::size_t k = 0; k + 1 < terms_; ++k) {
            sum += f[k] * moments[k];
        }
        return sum.is_finite() ? std::optional(sum) : std::nullopt;
    }
    /// Returns the Taylor series of the weight times D'(a)/D(a) = 1/a.
    [[nodiscard]] BallSeries integrand(const Ball& a) const {
        const BallContact c = contact_.between(a, a);
        const BallSeries rate = c.total_rate_series(terms_);
        BallSeries L(c.zone_force(), terms_);
        for (std::size_t k = 1; k < terms_; ++k) {
            L.set(k, rate[k - 1] / static_cast<long>(k));
        }
        return weight_(L) / BallSeries::variable(a, terms_);
    }

    const BallContact& contact_;
    Quadratic weight_;
    long bits_;
    const Cut& from_;
    const Cut& to_;
    std::size_t terms_; ///< odd
    Ball enough_;
};

} // namespace

Ball dissipated_energy(const BallContact& contact, const Ball& friction,
                       const std::vector<SlipPhase>& phases) {
    return energy_of(contact.modulus(), friction, phases,
                     [&](const Quadratic& weight, const Cut& from, const Cut& to) {
                         return GrowthIntegral(contact, weight, from, to).total();
                     });
}

// d ln D = dL/(power L)
Ball similar_dissipated_energy(const Ball& modulus, const Ball& power, const Ball& friction,
                               const std::vector<SlipPhase>& phases) {
    return energy_of(
        modulus, friction, phases, [&](const Quadratic& w, const Cut& from, const Cut& to) {
            const Ball width = to.force - from.force;
            const Ball constant = w(Ball(0, modulus.bits()));
            return (constant * log1p(width / from.force) + (w.c[1] - w.c[2] * w.at * 2) * width +
                    w.c[2] * width * (from.force + to.force) / 2) /
                   power;
        });
}

// Both ways: Q changes by 2 |Q| = 2 f (P - L_s).
Ball cycle_energy(const BallContact& contact, const BallSlip& slip) {
    const Ball inner = slip.force() * (1 - slip.load_ratio());
    return dissipated_energy(contact, slip.friction(),
                             {{slip.force(),
                               inner,
                               slip.force(),
                               slip.force(),
                               slip.friction() * slip.force() * slip.load_ratio() * 4,
                               {{inner, slip.stick()}, {slip.force(), slip.whole()}}}});
}

// The integral of (P - L)(L - L_s) dL/L, divided by P^2: tau - tau^2/2 + (1 - tau) ln(1 - tau)
// (docs/partial-slip.md, "The energy of a cycle").
Ball similar_cycle_energy(const BallSlip& slip, const Ball& power) {
    const Ball& tau = slip.load_ratio();
    const Ball part = tau - tau * tau / 2 + (1 - tau) * log1p(-tau);
    return slip.friction() * slip.friction() * slip.force() * slip.force() * 8 * part /
           (Ball::pi(power.bits()) * slip.zones().modulus() * power);
}

} // namespace edgeproof::contact
