// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/enclosure/proved_contact.hpp"
#include "edgeproof/contact/enclosure/side_search.hpp"
#include "edgeproof/formula/exact/exact.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace edgeproof::contact {

/// f = p_local/p - 1 for the sum p_local of n terms at an edge, in balls (docs/expansions.md).
/// Keeps a reference to the contact. `u`, `lo` and `hi` are distances from the edge (lengths).
class RelativeError {
public:
    /// Throws BudgetError if the contact does not enclose the expansion.
    RelativeError(const ProvedContact& contact, Edge edge, std::size_t n, const Exact& tolerance);

    [[nodiscard]] long bits() const { return bits_; }
    [[nodiscard]] std::size_t cost() const { return contact_.cost(); }
    [[nodiscard]] const Ball& tolerance() const { return tolerance_; }
    [[nodiscard]] Ball length() const { return contact_.a() + contact_.b(); }
    [[nodiscard]] Ball at(const Rational& u) const;
    [[nodiscard]] Side side_at(const Rational& u) const { return side(at(u)); }
    /// f and f' at the distance u from the edge.
    [[nodiscard]] std::pair<Ball, Ball> tangent(const Rational& u) const;

    [[nodiscard]] SideOver over(const Rational& lo, const Rational& hi) const;
    /// True if a corner certainly lies in the interval and f = -1 there is beyond the tolerance.
    [[nodiscard]] bool corner_between(const Rational& lo, const Rational& hi) const;
    /// The distance from the edge up to which f is within the tolerance, by the majorant of the
    /// expansion. Throws BudgetError if the edge may lie on a knot.
    [[nodiscard]] Rational safe_distance() const;

private:
    [[nodiscard]] Side side(const Ball& f) const { return side_of(f, tolerance_); }
    [[nodiscard]] Ball local(const Ball& u) const;
    [[nodiscard]] BallSeries series(const Ball& u, std::size_t order) const;
    /// The side by an enclosure of p over the whole interval, where p may be infinite (a corner) or
    /// zero (the far edge).
    [[nodiscard]] Side side_of_whole(const Ball& u) const;

    const ProvedContact& contact_;
    Edge edge_;
    std::vector<Ball> c_;
    long bits_;
    Ball tolerance_;
    std::size_t taylor_terms_;
};

} // namespace edgeproof::contact
