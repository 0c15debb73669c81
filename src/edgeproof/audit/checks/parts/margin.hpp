// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/audit/checks/parts/decimal_fit.hpp"
#include "edgeproof/audit/enclosure/sample_in_balls.hpp"
#include "edgeproof/audit/ledger/printed_formula.hpp"
#include "edgeproof/audit/sample/audit_context.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/roots/roots.hpp"

#include <algorithm>
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
    ConditionInScene(const Sample& sample, PrintedCondition condition,
                     std::optional<Condition> where, unsigned digits)
        : sample_(sample), printed_(std::move(condition)), where_(std::move(where)),
          digits_(digits), in_balls_(sample, first_digits, digits + 2) {}

    /// Distances from the edge to the knots inside the contact, as fractions of its length.
    [[nodiscard]] std::vector<Real> knots() const {
        const PrecisionScope scope(digits_ + 20);
        const long bits = formula::bits_for(digits_ + 20);
        const EnclosedSample at(sample_, bits);
        const auto value = [&](const char* name) { return at.evaluate(Expr::symbol(name)); };
        const auto scene = sample_.scene.as_scene();
        std::vector<Real> fractions;
        for (const Exact& knot : scene->profile->knots()) {
            const Ball x = ball_of(knot, bits);
            const Ball u = sample_.edge == Edge::right ? value("a") - x : value("b") + x;
            const Real fraction = at_working_precision((u / at.length()).midpoint());
            if (fraction > 0 && fraction < 1) {
                fractions.push_back(fraction);
            }
        }
        std::ranges::sort(fractions);
        return fractions;
    }
    /// Returns the margin, from the middles of enclosures, at a place or (nullptr) at the place of
    /// the sample; nullopt if `where` does not certainly hold there. Throws
    /// BudgetError if a side is not enclosed.
    [[nodiscard]] std::optional<Margin> margin(const Real* fraction) const {
        if (!moves_to(fraction)) {
            return std::nullopt;
        }
        std::optional<Margin> m;
        static_cast<void>(in_balls_.until([&](const EnclosedSample& at) {
            m = margin_at(at);
            return m->clear;
        }));
        if (!m) {
            throw BudgetError(in_balls_.problem());
        }
        if (fraction != nullptr) {
            m->fraction = *fraction;
        }
        return m;
    }
    /// Decides by enclosures, at a place or (nullptr) at that of the sample; returns nullopt if
    /// `where` does not certainly hold. Decimals represent their intervals: the condition fails if
    /// it fails for all numbers in them, and holds if it holds as printed.
    [[nodiscard]] std::optional<Decision> decide_at(const Real* fraction) const {
        if (!moves_to(fraction)) {
            return std::nullopt;
        }
        const auto look = [&](EnclosedSample& at, bool agreeing, Decision& found) {
            found = decide(printed_.as_printed, at, needed(), agreeing);
            if (refutes(found) && !printed_.decimals.empty()) {
                Decimals intervals;
                for (const PrintedDecimal& decimal : printed_.decimals) {
                    intervals.push_back(decimal.interval(rounding_units(), at.bits()));
                }
                set_decimals(at, intervals);
                found = decide(printed_.named, at, needed(), agreeing);
                if (!refutes(found)) {
                    found = {};
                    return true; // more bits do not make the intervals narrower
                }
            }
            return !is_open(found);
        };
        return decide_by(printed_.as_printed, in_balls_, look);
    }
    /// Sides whose difference is smaller than this, relative to its size nearby, satisfy the
    /// condition: 0 unless all its relations allow equality.
    [[nodiscard]] Real counts_as_equal() const {
        return std::ranges::all_of(printed_.as_printed, allows_equality)
                   ? pow(Real(10), -static_cast<int>(needed()))
                   : Real(0);
    }

private:
    /// Moves to a place; false if `where` does not certainly hold there.
    [[nodiscard]] bool moves_to(const Real* fraction) const {
        if (fraction != nullptr) {
            in_balls_.move_to(*fraction);
        }
        Decision there;
        return !where_ || (in_balls_.until([&](const EnclosedSample& at) {
            there = decide(*where_, at, needed(), false);
            return !is_open(there);
        }) && confirms(there));
    }
    [[nodiscard]] unsigned needed() const { return AuditContext::digits_needed(digits_); }
    [[nodiscard]] Margin margin_at(const EnclosedSample& at) const {
        const PrecisionScope scope(digits_ + 20);
        const Real noise = pow(Real(10), -static_cast<int>(digits_));
        std::optional<Margin> least;
        for (const Relation& r : printed_.as_printed) {
            using Op = Relation::Op;
            const auto [lhs, rhs] = sides_of(r, at);
            if (!lhs.is_finite() || !rhs.is_finite()) {
                throw BudgetError("a side of the relation that is not enclosed");
            }
            const Ball difference =
                r.op == Op::greater || r.op == Op::greater_equal ? lhs - rhs : rhs - lhs;
            const Real scale = max(abs(lhs), abs(rhs)).midpoint();
            const Real d = difference.midpoint();
            Margin m{Real(0), scale == 0 ? Real(0) : Real(d / scale), d,
                     difference.relative_accuracy_bits() >= clear_bits};
            if (r.op == Op::equal) {
                const bool alike = abs(difference).upper() <= noise * scale;
                m.clear = m.clear || alike;
                m.value = alike ? Real(1) : Real(-abs(m.value));
                m.difference = m.value;
            } else if (contains_zero(difference)) {
                const bool strict = r.op == Op::less || r.op == Op::greater;
                m.value = strict ? Real(0) : noise;
                m.difference = Real(0);
            }
            if (m.clear && m.value < 0) {
                return m; // one relation that fails decides
            }
            if (!least) {
                least = m;
                continue;
            }
            least->clear = least->clear && m.clear;
            least->value = std::min(least->value, m.value);
            least->difference = std::min(least->difference, m.difference);
        }
        return *least;
    }

    static constexpr unsigned first_digits = 10; ///< of the enclosures: most margins are wide
    static constexpr long clear_bits =
        40; ///< of a difference, for the comparison with its neighbours

    Sample sample_;
    PrintedCondition printed_;
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
    MarginScan(const ConditionInScene& condition, const Real& nearest) : condition_(condition) {
        const PrecisionScope scope(scan_digits);
        std::vector<Real> marks = condition.knots();
        marks.insert(marks.begin(), Real(0));
        marks.emplace_back(1);
        std::vector<Real> fractions;
        const Real step = pow(Real(10), Real(-1) / places_per_decade);
        for (std::size_t i = 0; i + 1 < marks.size(); ++i) {
            const Real width = marks[i + 1] - marks[i];
            for (Real d = width / 2; d > width * nearest; d *= step) {
                fractions.push_back(marks[i] + d);
                fractions.push_back(marks[i + 1] - d);
            }
            for (int k = 1; k < even_places; ++k) {
                fractions.push_back(marks[i] + width * k / even_places);
            }
            if (i > 0) {
                fractions.push_back(marks[i]);
            }
        }
        std::ranges::sort(fractions);
        fractions.erase(std::unique(fractions.begin(), fractions.end()), fractions.end());
        for (const Real& fraction : fractions) {
            look(fraction, std::ranges::find(marks, fraction) != marks.end());
        }
        seek_extrema();
    }

    /// The places in the order of their distance from the edge.
    [[nodiscard]] const std::vector<Margin>& places() const noexcept { return places_; }
    /// For a condition that holds (or fails) at all places of the scan: whether the difference of
    /// its sides is so small at one place, compared with its neighbours, that the condition may
    /// fail (or hold) at a point between them.
    [[nodiscard]] bool nearly_changes(bool holding) const {
        const Real negligible = pow(Real(10), -14); // the search ends within 2e-17 of an interval
        const Real equal = holding ? condition_.counts_as_equal() : Real(0);
        const int sign =
            holding ? 1 : -1; // so that the condition changes where a value reaches zero
        for (std::size_t i = 1; i + 1 < places_.size(); ++i) {
            const Real l = sign * places_[i - 1].difference;
            const Real m = sign * places_[i].difference;
            const Real r = sign * places_[i + 1].difference;
            const Real nearby = std::max(Real(abs(l)), Real(abs(r)));
            const bool counts_as_equal = equal > 0 && abs(m) <= equal * nearby;
            if (m <= l && m <= r && abs(m) <= negligible * nearby && !counts_as_equal) {
                return true;
            }
        }
        return false;
    }

private:
    void look(const Real& fraction, bool at_knot) {
        try {
            if (const auto margin = condition_.margin(&fraction)) {
                places_.push_back(*margin);
            }
        } catch (const BudgetError&) {
            if (!at_knot) { // at a corner the pressure is infinite
                throw;
            }
        }
    }
    void seek_extrema() {
        const PrecisionScope scope(scan_digits);
        const auto reaches_zero = [](const Real& height) { return height <= 0; };
        std::vector<Real> found;
        for (std::size_t i = 1; i + 1 < places_.size(); ++i) {
            const Real& l = places_[i - 1].difference;
            const Real& m = places_[i].difference;
            const Real& r = places_[i + 1].difference;
            const bool dip = m > 0 && m <= l && m <= r;
            const bool bump = m < 0 && m >= l && m >= r;
            const Real reach = 4 * std::max(Real(abs(m - l)), Real(abs(m - r)));
            if (dip == bump || abs(m) > reach) {
                continue; // no extremum, or one too flat to reach zero
            }
            const auto height = [&](const Real& x) {
                const auto margin = condition_.margin(&x);
                return !margin ? Real(2 * abs(m))
                       : dip   ? margin->difference
                               : Real(-margin->difference);
            };
            found.push_back(roots::place_of_minimum(height, places_[i - 1].fraction,
                                                    places_[i + 1].fraction, search_steps,
                                                    reaches_zero));
        }
        for (const Real& fraction : found) {
            look(fraction, false);
        }
        std::ranges::sort(places_, {}, &Margin::fraction);
    }

    static constexpr int places_per_decade = 3;
    static constexpr int even_places = 24;
    static constexpr int search_steps = 80;     ///< each shrinks the interval by 0.618
    static constexpr unsigned scan_digits = 40; ///< of the fractions themselves

    const ConditionInScene& condition_;
    std::vector<Margin> places_;
};

} // namespace edgeproof::audit
