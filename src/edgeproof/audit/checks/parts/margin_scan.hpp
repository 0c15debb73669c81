// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/checks/parts/margin.hpp"

namespace edgeproof::audit {

/// A margin at a distance from the edge, as a fraction of the contact's length.
struct MarginAt {
    Real fraction;
    Margin margin;
};

/// Evaluates a condition all over a contact: at places spaced geometrically towards both edges and
/// both sides of every knot, evenly between them, and at extrema of the margin between these places
/// where its sign might change. The completeness of this search is *sampled*, not proved.
class MarginScan {
public:
    /// `nearest`: the least distance from the edge, as a fraction of the length.
    MarginScan(const ConditionInScene& condition, const Real& nearest);

    /// The places in the order of their distance from the edge.
    [[nodiscard]] const std::vector<MarginAt>& places() const noexcept { return places_; }
    /// Returns nullptr if no place is admitted.
    [[nodiscard]] const MarginAt* least() const;
    [[nodiscard]] const MarginAt* most() const;
    [[nodiscard]] std::size_t unclear() const;
    /// For a condition that holds (or fails) at all places of the scan: whether the difference of
    /// its sides is so small at one place, compared with its neighbours, that the condition may
    /// fail (or hold) at a point between them.
    [[nodiscard]] bool nearly_changes(bool holding) const;
    /// Intervals in which the condition holds (or fails), their ends isolated to 12 digits, one
    /// end being a place of the scan where the condition is not asked beyond it.
    [[nodiscard]] std::vector<std::pair<Real, Real>> intervals(bool holding) const;

private:
    void look(const Real& fraction);
    void in_order();
    void seek_extrema();
    [[nodiscard]] Real change_between(Real lo, Real hi, bool holds_at_lo) const;

    const ConditionInScene& condition_;
    std::vector<MarginAt> places_;
};

} // namespace edgeproof::audit
