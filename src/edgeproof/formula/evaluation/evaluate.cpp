// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/formula/evaluation/evaluate.hpp"

#include <utility>

namespace edgeproof::formula {

std::string inside(const std::string& what, const Expr& part) {
    constexpr std::size_t longest = 60;
    std::string text = to_text(part);
    if (text.size() > longest) {
        text.resize(longest);
        text += "...";
    }
    return what + " in " + text;
}

std::pair<long, long> sum_bounds(const Expr& node) {
    constexpr long most_terms = 100'000;
    const auto bound = [&node](std::size_t i) {
        const Rational* q = node.arg(i).rational();
        if (q == nullptr || denominator(*q) != 1) {
            throw DomainError(inside("a bound that is not an integer", node));
        }
        if (abs(*q) > Rational(Integer(1) << 40U)) {
            throw BudgetError(inside("a bound beyond 2^40", node));
        }
        return Integer(numerator(*q)).convert_to<long>();
    };
    const long lo = bound(2);
    const long hi = bound(3);
    if (hi - lo >= most_terms) {
        throw BudgetError(inside("more than 100000 terms", node));
    }
    return {lo, hi};
}

} // namespace edgeproof::formula
