// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/enclosure/sample_in_balls.hpp"

#include "edgeproof/formula/magnitude.hpp"

namespace edgeproof::audit {
namespace {

formula::Expr named(const char* name) { return formula::Expr::symbol(name); }

/// A quantity of the same dimension as a name that does not vanish where the name does.
formula::Expr scale_of_name(const formula::Expr& e) {
    const std::string& name = e.name();
    if (name == "M") {
        return named("P") * named("L");
    }
    for (const char* first : {"right_c0", "left_c0", "right_s0", "left_s0"}) {
        const std::string stem(first, std::string(first).size() - 1);
        if (name.size() == stem.size() + 1 && name.starts_with(stem)) {
            return named(first) /
                   pow(named("L"), formula::Expr::number(Rational(name.back() - '0')));
        }
    }
    return e;
}

/// Returns the sum of the sizes of two parts of an integral; the cut is at a place where no
/// symmetry makes a part vanish.
Ball scale_of_integral(const formula::Expr& e, const EnclosedSample& sample) {
    const formula::Expr cut =
        e.arg(2) + formula::Expr::number(Rational(3, 7)) * (e.arg(3) - e.arg(2));
    const auto part = [&](const formula::Expr& from, const formula::Expr& to) {
        return abs(sample.evaluate(formula::Expr::with_args(e, {e.arg(0), e.arg(1), from, to})));
    };
    return part(e.arg(2), cut) + part(cut, e.arg(3));
}

} // namespace

Ball scale_of_terms(const formula::Expr& e, const EnclosedSample& sample) {
    return magnitude(e, [&](const formula::Expr& part) {
        if (part.kind() == formula::Expr::Kind::integral) {
            return scale_of_integral(part, sample);
        }
        if (part.kind() == formula::Expr::Kind::symbol) {
            const Ball value = sample.evaluate(part);
            const formula::Expr scale = scale_of_name(part);
            return contains_zero(value) && !(scale == part) ? abs(sample.evaluate(scale)) : value;
        }
        return sample.evaluate(part);
    });
}

} // namespace edgeproof::audit
