// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/enclosure/enclosed_condition.hpp"
#include "edgeproof/audit/ledger/printed_formula.hpp"
#include "edgeproof/audit/sample/audit_context.hpp"
#include "edgeproof/audit/sample/evaluated_scene.hpp"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace edgeproof::audit {

/// By how much a condition holds at a place: the least of (rhs - lhs)/max(|lhs|, |rhs|) over its
/// relations, turned so that positive means that it holds.
struct Margin {
    Real value;
    /// The least of rhs - lhs itself: of the same sign, but it does not level off where one side
    /// outweighs the other, and so shows where the sides come close.
    Real difference;
    /// Its sign is beyond doubt: it is larger than what the last digits could be wrong by. A
    /// relation that allows equality is clear when the sides agree to all digits.
    bool clear = true;
};

/// A condition in one scene, at any place of it. Where the sides agree to too many digits to tell
/// which is larger, more digits are computed: D, then 2 D + 40, then 4 D + 160.
class ConditionInScene {
public:
    ConditionInScene(const ConditionInScene&) = delete;
    ConditionInScene& operator=(const ConditionInScene&) = delete;
    ~ConditionInScene() = default;

    /// `sample`: its scene, edge and variables; its place is not looked at.
    ConditionInScene(const Sample& sample, PrintedCondition condition,
                     std::optional<Condition> where, unsigned digits);

    [[nodiscard]] const EvaluatedScene& scene_values() const { return at_level(0); }
    /// Distances from the edge to the knots inside the contact, as fractions of its length.
    [[nodiscard]] std::vector<Real> knots() const;
    /// nullopt where `where` leaves the place out, or something has no value there.
    [[nodiscard]] std::optional<Margin> at(const Real& fraction) const;
    /// For conditions that name no place.
    [[nodiscard]] std::optional<Margin> anywhere() const;
    /// By enclosures, at a place or, for conditions that name none, without one; nullopt where
    /// `where` does not certainly hold. Decimals stand for their intervals: the
    /// condition fails if it does for all numbers in them, and holds if it does as printed.
    [[nodiscard]] std::optional<Decision> decide_at(const Real* fraction) const;
    [[nodiscard]] std::string text() const;
    /// Sides whose difference is smaller than this, relative to its size nearby, satisfy the
    /// condition: 0 unless all its relations allow equality.
    [[nodiscard]] Real counts_as_equal() const;

private:
    [[nodiscard]] std::optional<Decision> decide_at(const Real* fraction,
                                                    SidesThatAgree agreeing) const;
    static constexpr std::size_t levels = 3;
    [[nodiscard]] const EvaluatedScene& at_level(std::size_t level) const;
    [[nodiscard]] unsigned digits_of(std::size_t level) const;
    [[nodiscard]] std::optional<Margin> margin(const Real* fraction) const;
    [[nodiscard]] Margin margin_at(std::size_t level, const Place* place) const;

    Sample sample_;
    PrintedCondition printed_;
    const Condition& condition_; ///< as printed
    std::optional<Condition> where_;
    unsigned digits_;
    mutable std::array<std::unique_ptr<EvaluatedScene>, levels> scene_values_;
    mutable SampleInBalls in_balls_;
};

} // namespace edgeproof::audit
