// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/enclosure/sample_in_balls.hpp"

namespace edgeproof::audit {

std::optional<Ball> enclosed(const Expr& e, const Sample& sample, unsigned digits) {
    constexpr unsigned integral_digits = 20;
    std::optional<Ball> best;
    SampleInBalls in_balls(sample, digits, integral_digits);
    static_cast<void>(in_balls.until([&](const EnclosedSample& at) {
        best = at.finite(e);
        return best->relative_accuracy_bits() >= formula::bits_for(digits);
    }));
    return best;
}

namespace {

/// A quantity of the same dimension as a name that does not vanish where the name does.
Expr scale_of_name(const Expr& e) {
    const std::string& name = e.name();
    if (name == "M") {
        return Expr::symbol("P") * Expr::symbol("L");
    }
    for (const char* stem : {"right_c", "left_c", "right_s", "left_s"}) {
        if (const auto k = order_behind(name, stem)) {
            const Expr first = Expr::symbol(std::string(stem) + "0");
            return first / pow(Expr::symbol("L"), Expr::number(Rational(*k)));
        }
    }
    return e;
}

/// Returns the sum of the sizes of two parts of an integral; the cut is at a place where no
/// symmetry makes a part vanish.
Ball scale_of_integral(const Expr& e, const EnclosedSample& sample) {
    const Expr cut = e.arg(2) + Expr::number(Rational(3, 7)) * (e.arg(3) - e.arg(2));
    const auto part = [&](const Expr& from, const Expr& to) {
        return abs(sample.evaluate(Expr::with_args(e, {e.arg(0), e.arg(1), from, to})));
    };
    return part(e.arg(2), cut) + part(cut, e.arg(3));
}

} // namespace

Ball scale_of_terms(const Expr& e, const EnclosedSample& sample) {
    using Kind = Expr::Kind;
    const auto part = [&](std::size_t k) { return scale_of_terms(e.arg(k), sample); };
    switch (e.kind()) {
    case Kind::neg:
        return part(0);
    case Kind::add:
    case Kind::sub:
        return part(0) + part(1);
    case Kind::mul:
        return part(0) * part(1);
    case Kind::div:
        return part(0) / abs(sample.evaluate(e.arg(1)));
    case Kind::integral:
        return scale_of_integral(e, sample);
    case Kind::symbol: {
        const Ball value = sample.evaluate(e);
        return abs(contains_zero(value) ? sample.evaluate(scale_of_name(e)) : value);
    }
    case Kind::call:
        if (e.builtin() == formula::Builtin::abs || e.builtin() == formula::Builtin::max ||
            e.builtin() == formula::Builtin::min) {
            Ball sum = part(0);
            for (std::size_t k = 1; k < e.args().size(); ++k) {
                sum += part(k);
            }
            return sum;
        }
        [[fallthrough]];
    default:
        return abs(sample.evaluate(e));
    }
}

namespace {

Decision equal(const Relation& r, const Ball& lhs, const Ball& rhs, const EnclosedSample& sample,
               double digits) {
    std::optional<Ball> scale; // none if a part has no enclosure
    try {
        scale = scale_of_terms(r.lhs, sample) + scale_of_terms(r.rhs, sample);
    } catch (const Error&) {
    }
    return equality(lhs, rhs, scale, digits);
}

} // namespace

bool allows_equality(const Relation& r) {
    using Op = Relation::Op;
    return r.op == Op::equal || r.op == Op::less_equal || r.op == Op::greater_equal;
}

std::pair<Ball, Ball> sides_of(const Relation& r, const EnclosedSample& sample) {
    const Ball lhs = sample.evaluate(r.lhs);
    if (r.lhs == r.rhs && lhs.is_finite()) {
        return {Ball(0, lhs.bits()), Ball(0, lhs.bits())};
    }
    return {lhs, sample.evaluate(r.rhs)};
}

namespace {

Decision decide_one(const Relation& r, const EnclosedSample& sample, double digits, bool agreeing) {
    using Op = Relation::Op;
    const auto [lhs, rhs] = sides_of(r, sample);
    if (r.op == Op::equal) {
        return equal(r, lhs, rhs, sample, digits);
    }
    const bool below = r.op == Op::less || r.op == Op::less_equal;
    const Ball& lesser = below ? lhs : rhs;
    const Ball& greater = below ? rhs : lhs;
    const bool or_equal = allows_equality(r);
    const Decision ordered = decision(Refutation::less(greater, lesser, !or_equal),
                                      Confirmation::less(lesser, greater, or_equal));
    if (!agreeing || !or_equal || !is_open(ordered)) {
        return ordered;
    }
    const Decision agree = equal(r, lhs, rhs, sample, digits);
    return confirms(agree) ? agree : Decision();
}

} // namespace

Decision decide(const Condition& condition, const EnclosedSample& sample, double digits,
                bool agreeing) {
    Decision all;
    bool open = false;
    for (const Relation& r : condition) {
        const Decision one = decide_one(r, sample, digits, agreeing);
        if (refutes(one)) {
            return one;
        }
        open = open || !confirms(one);
        all = one;
    }
    return open ? Decision() : all;
}

Decision decide(const Condition& condition, SampleInBalls& sample, double digits) {
    return decide_by(condition, sample,
                     [&](const EnclosedSample& at, bool agreeing, Decision& found) {
                         found = decide(condition, at, digits, agreeing);
                         return !is_open(found);
                     });
}

} // namespace edgeproof::audit
