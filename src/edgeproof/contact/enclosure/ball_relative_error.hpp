// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/enclosure/proved_pressure.hpp"
#include "edgeproof/formula/exact/exact.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace edgeproof::contact {

/// Where f = p_local/p - 1 lies: below minus the tolerance, ..., or not told.
enum class Side { below, within, above, unknown };

/// The number that x is.
[[nodiscard]] Rational exact_value(const Real& x);
/// A short number in the interval, near its middle.
[[nodiscard]] Rational middle(const Rational& lo, const Rational& hi);

/// f = p_local/p - 1 of n terms at an edge, in balls. Keeps a reference to the contact.
class RelativeError {
public:
    /// Throws BudgetError where the contact's bits do not enclose the expansion.
    RelativeError(const ProvedPressure& contact, Edge edge, std::size_t n,
                  const formula::Exact& tolerance);

    [[nodiscard]] long bits() const { return bits_; }
    [[nodiscard]] std::size_t cost() const { return contact_.cost(); }
    [[nodiscard]] const Ball& tolerance() const { return tolerance_; }
    [[nodiscard]] Ball length() const { return contact_.a() + contact_.b(); }
    [[nodiscard]] Side side(const Ball& f) const;
    [[nodiscard]] Ball at(const Rational& u) const;
    /// f and f' at a point.
    [[nodiscard]] std::pair<Ball, Ball> tangent(const Rational& u) const;

    struct Over {
        Side side = Side::unknown;
        bool monotone = false;
    };
    /// Of every u of an interval.
    [[nodiscard]] Over over(const Rational& lo, const Rational& hi) const;
    /// A corner certainly lies between, where f = -1, and that is beyond the tolerance.
    [[nodiscard]] bool corner_between(const Rational& lo, const Rational& hi) const;
    /// Within the tolerance from the edge up to here, by the majorant of the expansion. Throws
    /// BudgetError where the edge is not told from a knot.
    [[nodiscard]] Rational safe_distance() const;

private:
    [[nodiscard]] Ball local(const Ball& u) const;
    [[nodiscard]] BallSeries series(const Ball& u, std::size_t order) const;
    /// By p over the whole interval, be it infinite (a corner) or zero (the far edge) in it.
    [[nodiscard]] Side side_of_whole(const Ball& u) const;

    const ProvedPressure& contact_;
    Edge edge_;
    std::vector<Ball> c_;
    long bits_;
    Ball tolerance_;
    std::size_t taylor_terms_;
};

} // namespace edgeproof::contact
