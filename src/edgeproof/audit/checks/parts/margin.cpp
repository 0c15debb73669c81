// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/parts/margin.hpp"
#include "edgeproof/audit/agreement/samples.hpp"
#include "edgeproof/audit/checks/parts/decimal_fit.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/roots/bracketed_root.hpp"

#include <algorithm>

namespace edgeproof::audit {

namespace {

constexpr unsigned first_digits = 10; // of the enclosures: most margins are wide
constexpr long clear_bits = 40;       // of a difference, for the comparison with its neighbours

} // namespace

ConditionInScene::ConditionInScene(const Sample& sample, PrintedCondition condition,
                                   std::optional<Condition> where, unsigned digits)
    : sample_(sample), printed_(std::move(condition)), condition_(printed_.as_printed),
      where_(std::move(where)), digits_(digits), in_balls_(sample, first_digits, digits + 2) {}

bool ConditionInScene::moves_to(const Real* fraction) const {
    if (fraction != nullptr) {
        in_balls_.move_to(*fraction);
    }
    Decision there;
    return !where_ || (in_balls_.until([&](const EnclosedSample& at) {
        there = decide(*where_, at, needed(), SidesThatAgree::undecided);
        return !is_open(there);
    }) && confirms(there));
}

std::optional<Decision> ConditionInScene::decide_at(const Real* fraction) const {
    if (!moves_to(fraction)) {
        return std::nullopt;
    }
    const auto look = [&](EnclosedSample& at, SidesThatAgree agreeing, Decision& found) {
        found = decide(condition_, at, needed(), agreeing);
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
    return decide_by(condition_, in_balls_, look);
}

std::vector<Real> ConditionInScene::knots() const {
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

Margin ConditionInScene::margin_at(const EnclosedSample& at) const {
    const PrecisionScope scope(digits_ + 20);
    const Real noise = pow(Real(10), -static_cast<int>(digits_));
    std::optional<Margin> least;
    for (const Relation& r : condition_) {
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

std::optional<Margin> ConditionInScene::margin(const Real* fraction) const {
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

Real ConditionInScene::counts_as_equal() const {
    return std::ranges::all_of(condition_, allows_equality)
               ? pow(Real(10), -static_cast<int>(needed()))
               : Real(0);
}

namespace {

constexpr int places_per_decade = 3;
constexpr int even_places = 24;
constexpr int search_steps = 80;     // each shrinks the interval by 0.618
constexpr unsigned scan_digits = 40; // of the fractions themselves

} // namespace

MarginScan::MarginScan(const ConditionInScene& condition, const Real& nearest)
    : condition_(condition) {
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

void MarginScan::look(const Real& fraction, bool at_knot) {
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

void MarginScan::seek_extrema() {
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
        found.push_back(roots::place_of_minimum(
            height, places_[i - 1].fraction, places_[i + 1].fraction, search_steps, reaches_zero));
    }
    for (const Real& fraction : found) {
        look(fraction, false);
    }
    std::ranges::sort(places_, {}, &Margin::fraction);
}

bool MarginScan::nearly_changes(bool holding) const {
    const Real negligible = pow(Real(10), -14); // the search ends within 2e-17 of an interval
    const Real equal = holding ? condition_.counts_as_equal() : Real(0);
    const int sign = holding ? 1 : -1; // so that the condition changes where a value reaches zero
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

} // namespace edgeproof::audit
