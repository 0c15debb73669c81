// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/slip/cycle_energy.hpp"

#include "edgeproof/contact/enclosure/isolate_zero.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace edgeproof::contact {
namespace {

constexpr std::size_t most_energy_panels = 20'000;

/// Returns 8 f^2/(pi E*) (docs/partial-slip.md, "The energy of a cycle").
Ball energy_factor(const BallSlip& slip) {
    const ZoneSolver& zones = slip.zones();
    return slip.friction() * slip.friction() * 8 / (Ball::pi(zones.bits()) * zones.modulus());
}

/// The contact of the profile with the half-length a, and its force.
struct Inner {
    Ball a;
    Ball force;
};

/// The integral of (P - L)(L - L_s) d ln D (docs/partial-slip.md, "The energy of a cycle").
class CycleIntegral {
public:
    CycleIntegral(const BallContact& contact, const BallSlip& slip)
        : contact_(contact), bits_(contact.bits()), most_(slip.force()),
          least_(slip.force() * (1 - slip.load_ratio())), inner_{slip.stick().a, least_},
          outer_{slip.whole().a, most_}, terms_(2 * (static_cast<std::size_t>(bits_) / 8) + 1) {
        const Ball range = most_ - least_;
        const Ball part(
            Rational(Integer(1), Integer(Integer(1) << static_cast<unsigned>(bits_ - bits_ / 8))),
            bits_);
        enough_ = middle(range * range * stretch(inner_, outer_) * part);
    }

    [[nodiscard]] Ball total() const {
        const Inner lo = at(Ball(inner_.a.upper(), bits_));
        const Inner hi = at(Ball(outer_.a.lower(), bits_));
        if (!certainly_less(lo.a, hi.a)) {
            throw BudgetError("too few bits to distinguish the stick zone from the contact");
        }
        Ball sum = between_ends(inner_, lo) + between_ends(hi, outer_);
        std::vector<std::pair<Inner, Inner>> panels{{lo, hi}};
        for (std::size_t count = 0; !panels.empty(); ++count) {
            check_interruption();
            if (count > most_energy_panels) {
                throw BudgetError("the energy of a cycle takes too many panels");
            }
            const auto [from, to] = std::move(panels.back());
            panels.pop_back();
            const Ball centre = middle((from.a + to.a) / 2);
            const bool divisible = certainly_less(from.a, centre) && certainly_less(centre, to.a);
            const Ball crude = between_ends(from, to);
            if (!divisible || certainly_less(Ball(crude.radius(), bits_), enough_)) {
                sum += crude;
            } else if (const auto fine = by_taylor(from, centre, to)) {
                sum += *fine;
            } else {
                const Inner between = at(centre);
                panels.emplace_back(between, to);
                panels.emplace_back(from, between);
            }
        }
        return sum;
    }

private:
    [[nodiscard]] Inner at(const Ball& a) const { return {a, contact_.between(a, a).force()}; }
    /// Returns ln(a_to/a_from).
    [[nodiscard]] static Ball stretch(const Inner& from, const Inner& to) {
        return log1p((to.a - from.a) / from.a);
    }
    /// Bounds the integral over a panel; L increases with the edge.
    [[nodiscard]] Ball between_ends(const Inner& from, const Inner& to) const {
        const Ball L = Ball::hull(from.force, to.force);
        return clamped(most_ - L) * clamped(L - least_) * clamped(stretch(from, to));
    }
    /// The integral over a panel; nothing if the remainder is not small enough.
    [[nodiscard]] std::optional<Ball> by_taylor(const Inner& from, const Ball& centre,
                                                const Inner& to) const {
        const Ball lo = from.a - centre;
        const Ball hi = to.a - centre;
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
        const Ball remainder = integrand(Ball::hull(from.a, to.a))[terms_ - 1] * moments.back();
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
    /// Returns the Taylor series of (P - L)(L - L_s)/a in a.
    [[nodiscard]] BallSeries integrand(const Ball& a) const {
        const BallContact c = contact_.between(a, a);
        const BallSeries rate = c.total_rate_series(terms_);
        BallSeries L(c.force(), terms_);
        for (std::size_t k = 1; k < terms_; ++k) {
            L.set(k, rate[k - 1] / static_cast<long>(k));
        }
        return (-L + most_) * (L + (-least_)) / BallSeries::variable(a, terms_);
    }

    const BallContact& contact_;
    long bits_;
    Ball most_;  ///< P
    Ball least_; ///< P - |Q|/f
    Inner inner_;
    Inner outer_;
    std::size_t terms_; ///< odd
    Ball enough_;
};

} // namespace

Ball cycle_energy(const BallContact& contact, const BallSlip& slip) {
    return energy_factor(slip) * CycleIntegral(contact, slip).total();
}

// The integral of (P - L)(L - L_s) dL/L, divided by P^2: tau - tau^2/2 + (1 - tau) ln(1 - tau)
// (docs/partial-slip.md, "The energy of a cycle").
Ball similar_cycle_energy(const BallSlip& slip, const Ball& power) {
    const Ball& tau = slip.load_ratio();
    const Ball part = tau - tau * tau / 2 + (1 - tau) * log1p(-tau);
    return energy_factor(slip) * slip.force() * slip.force() * part / power;
}

} // namespace edgeproof::contact
