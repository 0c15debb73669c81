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

class ProgramBuilder {
public:
    ProgramBuilder(Program& program, const Expr& e, const Program::WrittenOut& written_out)
        : program_(program), written_out_(written_out) {
        for (std::size_t i = 0; i < program_.inputs_.size(); ++i) {
            known_.emplace(program_.inputs_[i], Slot{Slot::input, i});
        }
        const Slot result = compile(e);
        // The number of constants, which precede the results, is known only now.
        for (const Slot& s : operands_) {
            program_.operands_.push_back(resolve(s));
        }
        program_.result_ = resolve(result);
    }

private:
    struct Slot {
        enum Where { input, constant, result } where;
        std::size_t index;
    };

    [[nodiscard]] std::size_t resolve(const Slot& s) const {
        return s.index + (s.where == Slot::input ? 0 : program_.inputs_.size()) +
               (s.where == Slot::result ? program_.constants_.size() : 0);
    }

    Slot compile(const Expr& e) {
        if (const auto it = known_.find(e); it != known_.end()) {
            return it->second;
        }
        const Slot s = compile_new(e);
        known_.emplace(e, s);
        return s;
    }

    Slot compile_new(const Expr& e) {
        const bool constant = std::ranges::none_of(program_.inputs_, [&](const Expr& input) {
            return input.kind() == Expr::Kind::symbol && holds_symbol(e, input.name());
        });
        if (constant) {
            program_.constants_.push_back(e);
            return {Slot::constant, program_.constants_.size() - 1};
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
        std::vector<Slot> in;
        if (!e.is_binder()) {
            for (const Expr& x : e.args()) {
                in.push_back(compile(x));
            }
            if (const auto zero = zero_factor(e.kind(), in)) {
                return *zero;
            }
        }
        return add_step(e.kind(), in, e);
    }

    [[nodiscard]] bool is_zero(const Slot& s) const {
        const Rational* q =
            s.where == Slot::constant ? program_.constants_[s.index].rational() : nullptr;
        return q != nullptr && *q == 0;
    }

    /// Returns the operand that is the number 0 if it is the value of the operation as well.
    [[nodiscard]] std::optional<Slot> zero_factor(Expr::Kind kind,
                                                  const std::vector<Slot>& in) const {
        const bool times = kind == Expr::Kind::mul;
        if (is_zero(in[0]) &&
            (times || kind == Expr::Kind::neg || (kind == Expr::Kind::div && !is_zero(in[1])))) {
            return in[0];
        }
        return times && is_zero(in[1]) ? std::optional(in[1]) : std::nullopt;
    }

    Slot expanded(const Expr& e, long lo, long hi) {
        const auto term = [&](long k) {
            return compile(substitute(e.arg(0), e.arg(1).name(), Expr::number(Rational(k))));
        };
        Slot total = hi < lo ? compile(Expr::number(Rational(0))) : term(lo);
        for (long k = lo + 1; k <= hi; ++k) {
            total = add_step(Expr::Kind::add, {total, term(k)}, e);
        }
        return total;
    }

    Slot add_step(Expr::Kind kind, const std::vector<Slot>& in, const Expr& source) {
        program_.steps_.push_back({kind, operands_.size(), in.size(), source});
        operands_.insert(operands_.end(), in.begin(), in.end());
        return {Slot::result, program_.steps_.size() - 1};
    }

    Program& program_;
    const Program::WrittenOut& written_out_;
    std::vector<Slot> operands_;
    std::unordered_map<Expr, Slot, ExprHash> known_;
};

Program::Program(const Expr& e, std::vector<Expr> inputs, const WrittenOut& written_out)
    : inputs_(std::move(inputs)) {
    const ProgramBuilder built(*this, e, written_out);
}

} // namespace edgeproof::formula
