// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/enclosure/enclosed_condition.hpp"

namespace edgeproof::audit {
namespace {

std::optional<Confirmation> equal(const Relation& r, const Ball& lhs, const Ball& rhs,
                                  const EnclosedSample& sample, double digits) {
    try {
        const Ball scale = scale_of_terms(r.lhs, sample) + scale_of_terms(r.rhs, sample);
        return Confirmation::agreement(lhs, rhs, scale, digits);
    } catch (const Error&) {
        return std::nullopt; // a part has no enclosure
    }
}

} // namespace

bool allows_equality(const Relation& r) {
    using Op = Relation::Op;
    return r.op == Op::equal || r.op == Op::less_equal || r.op == Op::greater_equal;
}

Decision decide(const Relation& r, const EnclosedSample& sample, double digits,
                SidesThatAgree agreeing) {
    using Op = Relation::Op;
    const Ball lhs = sample.evaluate(r.lhs);
    const Ball rhs = sample.evaluate(r.rhs);
    if (r.op == Op::equal) {
        return decision(Refutation::disjoint(lhs, rhs), equal(r, lhs, rhs, sample, digits));
    }
    const bool below = r.op == Op::less || r.op == Op::less_equal;
    const Ball& lesser = below ? lhs : rhs;
    const Ball& greater = below ? rhs : lhs;
    const Decision strict =
        decision(Refutation::less(greater, lesser), Confirmation::less(lesser, greater));
    if (agreeing == SidesThatAgree::undecided || !allows_equality(r) ||
        !std::holds_alternative<std::monostate>(strict)) {
        return strict;
    }
    return decision(std::nullopt, equal(r, lhs, rhs, sample, digits));
}

Decision decide(const Condition& condition, const EnclosedSample& sample, double digits,
                SidesThatAgree agreeing) {
    Decision all;
    bool open = false;
    for (const Relation& r : condition) {
        const Decision one = decide(r, sample, digits, agreeing);
        if (refutes(one)) {
            return one;
        }
        open = open || !confirms(one);
        all = one;
    }
    return open ? Decision() : all;
}

Decision decide(const Condition& condition, SampleInBalls& sample, double digits) {
    Decision found;
    for (const SidesThatAgree agreeing : {SidesThatAgree::undecided, SidesThatAgree::equal}) {
        static_cast<void>(sample.until([&](const EnclosedSample& at) {
            found = decide(condition, at, digits, agreeing);
            return !std::holds_alternative<std::monostate>(found);
        }));
        if (!std::holds_alternative<std::monostate>(found)) {
            break;
        }
    }
    return found;
}

} // namespace edgeproof::audit
