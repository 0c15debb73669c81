// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/evaluation/program.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace edgeproof::formula {
namespace {

constexpr long longest_written_out_sum = 1000;

Program::Op op_of(const Expr& e) {
    switch (e.kind()) {
    case Expr::Kind::neg:
        return Program::Op::neg;
    case Expr::Kind::add:
        return Program::Op::add;
    case Expr::Kind::sub:
        return Program::Op::sub;
    case Expr::Kind::mul:
        return Program::Op::mul;
    case Expr::Kind::div:
        return Program::Op::div;
    case Expr::Kind::pow:
        return Program::Op::pow;
    case Expr::Kind::call:
        return e.builtin() == Builtin::none ? Program::Op::extern_call : Program::Op::call;
    default:
        return Program::Op::binder;
    }
}

/// True if the value of e does not depend on the symbols or on the environment.
bool is_constant(const Expr& e) {
    return e.kind() != Expr::Kind::symbol && !e.is_binder() &&
           !(e.kind() == Expr::Kind::call && e.builtin() == Builtin::none) &&
           std::ranges::all_of(e.args(), is_constant);
}

} // namespace

class ProgramBuilder {
public:
    ProgramBuilder(Program& program, const Expr& e) : program_(program) {
        for (std::size_t i = 0; i < program_.symbols_.size(); ++i) {
            known_.emplace(Expr::symbol(program_.symbols_[i]), Slot{Slot::input, i});
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
        const std::size_t symbols = program_.symbols_.size();
        switch (s.where) {
        case Slot::input:
            return s.index;
        case Slot::constant:
            return symbols + s.index;
        default:
            return symbols + program_.constants_.size() + s.index;
        }
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
        if (is_constant(e)) {
            program_.constants_.push_back(e);
            return {Slot::constant, program_.constants_.size() - 1};
        }
        if (e.kind() == Expr::Kind::symbol) {
            throw Error("'" + e.name() + "' has no value here");
        }
        if (e.kind() == Expr::Kind::sum && e.arg(2).rational() != nullptr &&
            e.arg(3).rational() != nullptr) {
            if (const auto [lo, hi] = sum_bounds(e); hi - lo < longest_written_out_sum) {
                return written_out(e, lo, hi);
            }
        }
        std::vector<Slot> in;
        if (!e.is_binder()) {
            for (const Expr& x : e.args()) {
                in.push_back(compile(x));
            }
            if (e.kind() == Expr::Kind::pow && e.arg(1).rational() != nullptr) {
                in.push_back(compile(Expr::number(Rational(1))));
            }
        } else {
            check_symbols(e);
        }
        return add_step(op_of(e), in, e);
    }

    Slot written_out(const Expr& e, long lo, long hi) {
        if (hi < lo) {
            return compile(Expr::number(Rational(0)));
        }
        const auto term = [&](long k) {
            return compile(substitute(e.arg(0), e.arg(1).name(), Expr::number(Rational(k))));
        };
        Slot total = term(lo);
        for (long k = lo + 1; k <= hi; ++k) {
            total = add_step(Program::Op::add, {total, term(k)}, e);
        }
        return total;
    }

    void check_symbols(const Expr& e) const {
        for (const std::string& name : free_symbols(e)) {
            if (std::ranges::find(program_.symbols_, name) == program_.symbols_.end()) {
                throw Error("'" + name + "' has no value here");
            }
        }
    }

    Slot add_step(Program::Op op, const std::vector<Slot>& in, const Expr& source) {
        program_.steps_.push_back({op, operands_.size(), in.size(), source});
        operands_.insert(operands_.end(), in.begin(), in.end());
        return {Slot::result, program_.steps_.size() - 1};
    }

    Program& program_;
    std::vector<Slot> operands_;
    std::unordered_map<Expr, Slot, ExprHash> known_;
};

Program::Program(const Expr& e, std::vector<std::string> symbols) : symbols_(std::move(symbols)) {
    const ProgramBuilder built(*this, e);
}

} // namespace edgeproof::formula
