// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/formula/evaluation/program.hpp"

#include <algorithm>
#include <unordered_map>
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

namespace {

using Part = Program::Part;

class ProgramBuilder {
public:
    ProgramBuilder(std::vector<Part>& parts, const std::vector<Expr>& inputs,
                   const Program::WrittenOut& written_out)
        : parts_(parts), inputs_(inputs), written_out_(written_out) {
        for (const Expr& input : inputs) {
            known_.emplace(input, add({Part::Role::input, input.kind(), input, {}}));
        }
    }

    std::size_t compile(const Expr& e) {
        if (const auto it = known_.find(e); it != known_.end()) {
            return it->second;
        }
        const std::size_t place = compile_new(e);
        known_.emplace(e, place);
        return place;
    }

private:
    std::size_t add(Part part) {
        parts_.push_back(std::move(part));
        return parts_.size() - 1;
    }

    std::size_t compile_new(const Expr& e) {
        const bool constant = std::ranges::none_of(inputs_, [&](const Expr& input) {
            return input.kind() == Expr::Kind::symbol && holds_symbol(e, input.name());
        });
        if (constant) {
            return add({Part::Role::constant, e.kind(), e, {}});
        }
        if (const auto other = written_out_(e)) {
            return compile(*other);
        }
        if (e.kind() == Expr::Kind::sum && e.arg(2).rational() != nullptr &&
            e.arg(3).rational() != nullptr) {
            constexpr long longest_written_out = 1000;
            if (const auto [lo, hi] = sum_bounds(e); hi - lo < longest_written_out) {
                return expanded(e, lo, hi);
            }
        }
        std::vector<std::size_t> in;
        if (!e.is_binder()) {
            for (const Expr& x : e.args()) {
                in.push_back(compile(x));
            }
            if (const auto zero = zero_factor(e.kind(), in)) {
                return *zero;
            }
        }
        return add({Part::Role::operation, e.kind(), e, std::move(in)});
    }

    [[nodiscard]] bool is_zero(std::size_t place) const {
        const Rational* q = parts_[place].source.rational();
        return parts_[place].role == Part::Role::constant && q != nullptr && *q == 0;
    }

    /// Returns the operand that is the number 0 if it is the value of the operation as well.
    [[nodiscard]] std::optional<std::size_t> zero_factor(Expr::Kind kind,
                                                         const std::vector<std::size_t>& in) const {
        const bool times = kind == Expr::Kind::mul;
        if (is_zero(in[0]) &&
            (times || kind == Expr::Kind::neg || (kind == Expr::Kind::div && !is_zero(in[1])))) {
            return in[0];
        }
        return times && is_zero(in[1]) ? std::optional(in[1]) : std::nullopt;
    }

    std::size_t expanded(const Expr& e, long lo, long hi) {
        const auto term = [&](long k) {
            return compile(substitute(e.arg(0), e.arg(1).name(), Expr::number(Rational(k))));
        };
        std::size_t total = hi < lo ? compile(Expr::number(Rational(0))) : term(lo);
        for (long k = lo + 1; k <= hi; ++k) {
            total = add({Part::Role::operation, Expr::Kind::add, e, {total, term(k)}});
        }
        return total;
    }

    std::vector<Part>& parts_;
    const std::vector<Expr>& inputs_;
    const Program::WrittenOut& written_out_;
    std::unordered_map<Expr, std::size_t, ExprHash> known_;
};

} // namespace

Program::Program(const Expr& e, const std::vector<Expr>& inputs, const WrittenOut& written_out)
    : result_(ProgramBuilder(parts_, inputs, written_out).compile(e)) {}

} // namespace edgeproof::formula
