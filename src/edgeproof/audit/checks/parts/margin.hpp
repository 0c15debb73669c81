// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/enclosure/sample_in_balls.hpp"
#include "edgeproof/audit/ledger/printed_formula.hpp"
#include "edgeproof/audit/sample/audit_context.hpp"

#include <optional>
#include <vector>

namespace edgeproof::audit {

/// The margin by which a condition holds at a place: the least of (rhs - lhs)/max(|lhs|, |rhs|)
/// over its relations, with the sign chosen so that positive means that the relation holds.
struct Margin {
    Real fraction; ///< the place: its distance from the edge, as a fraction of the contact's length
    Real value;
    /// The least of rhs - lhs itself. It has the same sign, but does not become constant where one
    /// side dominates, and therefore shows where the sides come close.
    Real difference;
    /// True if the difference is enclosed well enough to be compared with its neighbours, or if the
    /// sides of an equality agree to all digits.
    bool clear = true;
};

/// A condition in one scene, at any place, by enclosures with as many bits as necessary.
class ConditionInScene {
public:
    ConditionInScene(const ConditionInScene&) = delete;
    ConditionInScene& operator=(const ConditionInScene&) = delete;
    ~ConditionInScene() = default;

    ConditionInScene(const Sample& sample, PrintedCondition condition,
                     std::optional<Condition> where, unsigned digits);

    /// Distances from the edge to the knots inside the contact, as fractions of its length.
    [[nodiscard]] std::vector<Real> knots() const;
    /// Returns the margin, from the middles of enclosures, at a place or (nullptr) at the place of
    /// the sample; nullopt if `where` does not certainly hold there. Throws
    /// BudgetError if a side is not enclosed.
    [[nodiscard]] std::optional<Margin> margin(const Real* fraction) const;
    /// Decides by enclosures, at a place or (nullptr) at that of the sample; returns nullopt if
    /// `where` does not certainly hold. Decimals represent their intervals: the condition fails if
    /// it fails for all numbers in them, and holds if it holds as printed.
    [[nodiscard]] std::optional<Decision> decide_at(const Real* fraction) const;
    /// Sides whose difference is smaller than this, relative to its size nearby, satisfy the
    /// condition: 0 unless all its relations allow equality.
    [[nodiscard]] Real counts_as_equal() const;

private:
    /// Moves to a place; false if `where` does not certainly hold there.
    [[nodiscard]] bool moves_to(const Real* fraction) const;
    [[nodiscard]] unsigned needed() const { return AuditContext::digits_needed(digits_); }
    [[nodiscard]] Margin margin_at(const EnclosedSample& at) const;

    Sample sample_;
    PrintedCondition printed_;
    const Condition& condition_; ///< as printed
    std::optional<Condition> where_;
    unsigned digits_;
    mutable SampleInBalls in_balls_;
};

/// Evaluates a condition all over a contact: at places spaced geometrically towards both edges and
/// both sides of every knot, evenly between them, and at extrema of the margin between these places
/// where its sign might change. The completeness of this search is *sampled*, not proved.
class MarginScan {
public:
    /// `nearest`: the least distance from the edge, as a fraction of the length.
    MarginScan(const ConditionInScene& condition, const Real& nearest);

    /// The places in the order of their distance from the edge.
    [[nodiscard]] const std::vector<Margin>& places() const noexcept { return places_; }
    /// For a condition that holds (or fails) at all places of the scan: whether the difference of
    /// its sides is so small at one place, compared with its neighbours, that the condition may
    /// fail (or hold) at a point between them.
    [[nodiscard]] bool nearly_changes(bool holding) const;

private:
    void look(const Real& fraction, bool at_knot);
    void seek_extrema();

    const ConditionInScene& condition_;
    std::vector<Margin> places_;
};

} // namespace edgeproof::audit
