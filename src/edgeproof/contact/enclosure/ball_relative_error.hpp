// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/enclosure/proved_contact.hpp"
#include "edgeproof/formula/exact/exact.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace edgeproof::contact {

/// The side of the tolerance on which f = p_local/p - 1 lies.
enum class Side { below, within, above, unknown };
/// The side on which an enclosure f lies.
[[nodiscard]] Side side_of(const Ball& f, const Ball& tolerance);
[[nodiscard]] inline bool is_beyond(Side side) {
    return side == Side::above || side == Side::below;
}

/// The rational number that is equal to x.
[[nodiscard]] Rational exact_value(const Real& x);
/// A rational number with few digits in the interval, near its middle.
[[nodiscard]] Rational middle(const Rational& lo, const Rational& hi);

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
    /// The side on which an enclosure f lies.
    [[nodiscard]] Side side(const Ball& f) const { return side_of(f, tolerance_); }
    [[nodiscard]] Ball at(const Rational& u) const;
    /// f and f' at the distance u from the edge.
    [[nodiscard]] std::pair<Ball, Ball> tangent(const Rational& u) const;

    struct Over {
        Side side = Side::unknown;
        bool monotone = false;
    };
    /// The side of f, and whether f is monotone, for all u of an interval.
    [[nodiscard]] Over over(const Rational& lo, const Rational& hi) const;
    /// True if a corner certainly lies in the interval and f = -1 there is beyond the tolerance.
    [[nodiscard]] bool corner_between(const Rational& lo, const Rational& hi) const;
    /// The distance from the edge up to which f is within the tolerance, by the majorant of the
    /// expansion. Throws BudgetError if the edge may lie on a knot.
    [[nodiscard]] Rational safe_distance() const;

private:
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

/// Returns an enclosure of the greatest pressure of a contact (docs/pressure.md, "The greatest
/// pressure"), in the unit of the contact modulus. The pressure is bounded over intervals of the
/// contact. They are halved, and dropped where the pressure is certainly less than at another
/// place, or certainly monotone. Where p is certainly concave over all remaining intervals, the
/// interval form of Newton's method encloses the one place where p' = 0. Otherwise (for example two
/// equal maxima) the bounds of the remaining intervals are the result, an enclosure that is wider
/// than the bits allow.
///
/// `symmetric`: p is even about the middle of the contact. The pressure must have no corner inside.
/// Throws BudgetError if the pressure is not bounded over some interval.
[[nodiscard]] Ball enclosed_peak(const ProvedContact& contact, bool symmetric);

} // namespace edgeproof::contact
