// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/parts/margin.hpp"

#include "edgeproof/precision/error.hpp"

#include <algorithm>

namespace edgeproof::audit {

namespace {

constexpr unsigned first_digits = 10; // of the enclosures: most margins are wide

} // namespace

ConditionInScene::ConditionInScene(const Sample& sample, PrintedCondition condition,
                                   std::optional<Condition> where, unsigned digits)
    : sample_(sample), printed_(std::move(condition)), condition_(printed_.as_printed),
      where_(std::move(where)), digits_(digits), in_balls_(sample, first_digits, digits + 2) {
    sample_.fraction.reset();
}

std::optional<Decision> ConditionInScene::decide_at(const Real* fraction) const {
    auto found = decide_at(fraction, SidesThatAgree::undecided);
    if (found && std::holds_alternative<std::monostate>(*found) &&
        std::any_of(condition_.begin(), condition_.end(), allows_equality)) {
        found = decide_at(fraction, SidesThatAgree::equal);
    }
    return found;
}

std::optional<Decision> ConditionInScene::decide_at(const Real* fraction,
                                                    SidesThatAgree agreeing) const {
    const double needed = AuditContext::digits_needed(digits_);
    Decision found;
    bool admitted = !where_;
    static_cast<void>(in_balls_.until([&](EnclosedSample& at) {
        if (fraction != nullptr) {
            at.set_place(sample_.edge, Ball(*fraction, at.bits()) * at.length());
        }
        if (!admitted) {
            const Decision there = decide(*where_, at, needed, agreeing);
            admitted = confirms(there);
            if (!admitted) {
                return refutes(there);
            }
        }
        found = decide(printed_.as_printed, at, needed, agreeing);
        if (refutes(found) && !printed_.decimals.empty()) {
            for (std::size_t k = 0; k < printed_.decimals.size(); ++k) {
                at.set(DecimalFormula::name_of_decimal(k),
                       printed_.decimals[k].interval(Rational(1, 2), at.bits()));
            }
            found = decide(printed_.named, at, needed, agreeing);
            if (!refutes(found)) {
                found = {};
                return true; // more bits do not make the intervals narrower
            }
        }
        return !std::holds_alternative<std::monostate>(found);
    }));
    return admitted ? std::optional(found) : std::nullopt;
}

unsigned ConditionInScene::digits_of(std::size_t level) const {
    return level == 0 ? digits_ : level == 1 ? 2 * digits_ + 40 : 4 * digits_ + 160;
}

const EvaluatedScene& ConditionInScene::at_level(std::size_t level) const {
    auto& scene_values = scene_values_[level];
    if (!scene_values) {
        scene_values = std::make_unique<EvaluatedScene>(sample_.scene, digits_of(level));
    }
    return *scene_values;
}

std::vector<Real> ConditionInScene::knots() const {
    const PrecisionScope scope(digits_ + 20);
    const EvaluatedScene& s = scene_values();
    std::vector<Real> fractions;
    for (const formula::Exact& knot : s.contact().profile().knots()) {
        const Real x = knot.to<Real>();
        const Real u = sample_.edge == contact::Edge::right ? Real(s.a() - x) : Real(s.b() + x);
        if (u > 0 && u < s.length()) {
            fractions.push_back(u / s.length());
        }
    }
    std::sort(fractions.begin(), fractions.end());
    return fractions;
}

Margin ConditionInScene::margin_at(std::size_t level, const Place* place) const {
    const EvaluatedScene& s = at_level(level);
    const unsigned digits = digits_of(level);
    const PrecisionScope scope(digits + 20);
    const Real noise = pow(Real(10), -static_cast<int>(digits));
    const Variables variables = s.values_of(sample_.variables);
    std::optional<Margin> least;
    for (const Relation& r : condition_) {
        using Op = Relation::Op;
        const Real lhs = s.evaluate(r.lhs, place, variables).value;
        const Real rhs = s.evaluate(r.rhs, place, variables).value;
        const Real scale = std::max(Real(abs(lhs)), Real(abs(rhs)));
        const Real difference =
            r.op == Op::greater || r.op == Op::greater_equal ? Real(lhs - rhs) : Real(rhs - lhs);
        Margin m{scale == 0 ? Real(0) : Real(difference / scale), difference, true};
        if (!isfinite(lhs) || !isfinite(rhs)) {
            throw BudgetError("a number beyond the range of the arithmetic");
        }
        const bool alike = abs(m.value) <= noise;
        if (r.op == Op::equal) {
            m.value = alike ? Real(1) : Real(-abs(m.value));
            m.difference = m.value;
        } else if (alike) {
            const bool strict = r.op == Op::less || r.op == Op::greater;
            // Zero on both sides is equality; more digits may separate other values.
            m.clear = scale == 0 || (!strict && level + 1 == levels);
            m.value = strict ? Real(0) : noise;
            m.difference = strict ? Real(0) : Real(abs(difference));
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
    try {
        std::optional<Margin> m;
        for (std::size_t level = 0; level < levels && !(m && m->clear); ++level) {
            const EvaluatedScene& s = at_level(level);
            std::optional<Place> place;
            if (fraction != nullptr) {
                const PrecisionScope scope(digits_of(level) + 20);
                place = s.place_at_u(sample_.edge, Real(*fraction * s.length()));
            }
            const Place* at = place ? &*place : nullptr;
            if (level == 0 && where_ && !s.holds(*where_, at, s.values_of(sample_.variables))) {
                return std::nullopt;
            }
            m = margin_at(level, at);
        }
        return m;
    } catch (const DomainError&) {
        return std::nullopt; // at a corner, or beyond the far edge because of roundoff
    }
}

std::optional<Margin> ConditionInScene::at(const Real& fraction) const { return margin(&fraction); }
std::optional<Margin> ConditionInScene::anywhere() const { return margin(nullptr); }
Real ConditionInScene::counts_as_equal() const {
    return std::all_of(condition_.begin(), condition_.end(), allows_equality)
               ? pow(Real(10), -static_cast<int>(AuditContext::digits_needed(digits_)))
               : Real(0);
}

std::string ConditionInScene::text() const { return sample_.scene.family + ": " + sample_.text(); }

} // namespace edgeproof::audit
