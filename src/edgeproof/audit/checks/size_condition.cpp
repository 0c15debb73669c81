// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/size_extents.hpp"
#include "edgeproof/audit/checks/parts/size_scan.hpp"
#include "edgeproof/audit/enclosure/sample_in_balls.hpp"
#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>

namespace edgeproof::audit {
namespace {

/// Evaluates a, b, L and the coefficients at both edges in binary128.
class SizeEnvironment {
public:
    explicit SizeEnvironment(ContactsBySize::At& contact) : contact_(contact) {}
    [[nodiscard]] Float128 number(const Rational& q) const { return from_rational<Float128>(q); }
    [[nodiscard]] Float128 pi() const { return edgeproof::pi<Float128>(); }
    [[nodiscard]] Float128 symbol(std::string_view name) const {
        const auto& e = contact_.extent();
        if (name == "a" || name == "b" || name == "L") {
            return name == "a" ? e.a : name == "b" ? e.b : e.length();
        }
        for (const contact::Edge edge : {contact::Edge::right, contact::Edge::left}) {
            const std::string_view prefix = edge == contact::Edge::right ? "right_c" : "left_c";
            if (name.starts_with(prefix) && name.size() == prefix.size() + 1) {
                const auto k = static_cast<std::size_t>(name.back() - '0');
                if (k < ContactsBySize::most_terms) {
                    return contact_.coefficients(edge, k + 1)[k];
                }
            }
        }
        throw Error("'" + std::string(name) + "' is not known where the size varies");
    }

private:
    ContactsBySize::At& contact_;
};

/// Throws BudgetError if a side is not finite.
bool holds(const Relation& r, const SizeEnvironment& at) {
    const auto lhs = evaluate<Float128>(r.lhs, at);
    const auto rhs = evaluate<Float128>(r.rhs, at);
    if (lhs - lhs != 0 || rhs - rhs != 0) {
        throw BudgetError("a number beyond the range of the arithmetic");
    }
    return compare(r.op, lhs, rhs);
}

const char* sign_of(Relation::Op op) {
    switch (op) {
    case Relation::Op::less:
        return " < ";
    case Relation::Op::less_equal:
        return " <= ";
    case Relation::Op::greater:
        return " > ";
    case Relation::Op::greater_equal:
        return " >= ";
    case Relation::Op::equal:
        break;
    }
    return " = ";
}

std::string relation_text(const Relation& r) {
    return to_text(r.lhs) + sign_of(r.op) + to_text(r.rhs);
}

/// Judges a condition at the tried sizes, by enclosures. A finite list of sizes confirms it only at
/// these sizes, as the note states; if it fails at all of them, it may still hold between them.
Judgement at_sizes(const SceneSpec& scene, const Condition& condition,
                   const std::vector<Float128>& sizes, const Claim& claim,
                   const AuditContext& context) {
    std::size_t holding = 0;
    std::size_t failing = 0;
    Judgement last;
    for (const Float128& a : sizes) {
        SampleInBalls sample({with_size(scene, a), std::nullopt, claim.edge(), {}},
                             context.digits());
        const Decision found = decide(condition, sample, context.digits_needed());
        holding += confirms(found) ? 1 : 0;
        failing += refutes(found) ? 1 : 0;
        last = Judgement(found);
    }
    if (holding == sizes.size()) {
        return last;
    }
    return holding > 0 && failing > 0 ? Judgement(Undecided::underspecified) : Judgement();
}

} // namespace

Outcome check_size_condition(const Claim& claim, const AuditContext& context) {
    const std::vector<SceneSpec> scenes = context.scenes(claim);
    const auto& range = claim.list("sizes");
    if (scenes.size() != 1 || range.size() != 2) {
        claim.reject(scenes.size() != 1 ? "over" : "sizes",
                     "a size is sought for one scene and between two sizes",
                     "name a family with count = 1 and write sizes = [\"FROM\", \"TO\"]");
    }
    const Condition condition = claim.condition("says");
    const contact::Profile profile = scenes.front().make_profile();
    const ContactsBySize contacts(profile);
    const SizeScan scan(profile, formula::Exact::parse(range[0]), formula::Exact::parse(range[1]),
                        4);
    const auto where = [&](const Condition& all) {
        return scan.where([&](const Float128& a) {
            ContactsBySize::At contact = contacts.at(a);
            const SizeEnvironment at(contact);
            return std::all_of(all.begin(), all.end(),
                               [&](const Relation& r) { return holds(r, at); });
        });
    };
    const SizeSet set = where(condition);
    Outcome outcome;
    scan.describe(range, outcome.evidence);
    outcome.evidence.add("holds_for_a", to_text(set));
    outcome.verdict = at_sizes(scenes.front(), condition, scan.sizes(), claim, context);
    const std::string looked_at = " (at " + std::to_string(scan.sizes().size()) + " sizes)";
    if (outcome.verdict == Verdict::confirmed) {
        outcome.note = "the size is not given, and it holds at every size" + looked_at;
    } else if (outcome.verdict == Verdict::undecided) {
        outcome.note = set.empty() ? "it holds at no size that was examined" + looked_at
                                   : "the enclosures do not decide at some sizes";
    } else {
        outcome.note = "the size is not given; it would hold for a = " + to_text(set, 4);
        Evidence each;
        for (const Relation& r : condition) {
            each.add(relation_text(r), to_text(where({r})));
        }
        outcome.evidence.add("each_holds_for_a", each);
    }
    return outcome;
}

} // namespace edgeproof::audit
