// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/mutation/mutants.hpp"

#include <array>
#include <string_view>
#include <unordered_set>
#include <utility>

namespace edgeproof::audit {
namespace {

using Kind = formula::Expr::Kind;

class Breaker {
public:
    explicit Breaker(const formula::Expr& formula) : formula_(formula) {}

    std::vector<Mutant> operator()() {
        for (const formula::Path& path : paths(formula_)) {
            path_ = path;
            break_at(at(formula_, path));
        }
        return std::move(mutants_);
    }

private:
    void put(const char* kind, const formula::Expr& value) {
        formula::Expr mutated = replace(formula_, path_, value);
        if (seen_.insert(mutated).second) {
            mutants_.push_back({kind, std::move(mutated)});
        }
    }
    [[nodiscard]] bool is_exponent() const {
        if (path_.empty() || path_.back() != 1) {
            return false;
        }
        return at(formula_, formula::Path(path_.begin(), path_.end() - 1)).kind() == Kind::pow;
    }

    void break_at(const formula::Expr& node) {
        switch (node.kind()) {
        case Kind::add:
            put("sign", node.arg(0) - node.arg(1));
            break;
        case Kind::sub:
            put("sign", node.arg(0) + node.arg(1));
            break;
        case Kind::neg:
            put("sign", node.arg(0));
            break;
        case Kind::number:
            number(node);
            break;
        case Kind::mul:
            put("factor", node.arg(0));
            put("factor", node.arg(1));
            break;
        case Kind::div:
            put("factor", node.arg(0));
            break;
        case Kind::symbol:
            symbol(node.name());
            break;
        case Kind::call:
            call(node);
            break;
        default:
            break;
        }
    }

    void number(const formula::Expr& node) {
        const Rational& n = node.number();
        if (is_exponent()) {
            put("exponent", formula::Expr::number(Rational(n + Rational(1, 2))));
            put("exponent", formula::Expr::number(Rational(n - Rational(1, 2))));
            return;
        }
        // Change the number by one unit in its last written digit.
        Rational unit(1);
        while (denominator(Rational(n / unit)) != 1) {
            unit /= 10;
        }
        put("coefficient", formula::Expr::number(Rational(n + unit)));
        if (n != unit) {
            put("coefficient", formula::Expr::number(Rational(n - unit)));
        }
    }

    void symbol(const std::string& name) {
        if (name == "a" || name == "b") {
            put("a for b", formula::Expr::symbol(name == "a" ? "b" : "a"));
        }
        // P1, P2, ... and b1, b2, ... denote derivatives.
        if (name == "P") {
            put("prime", formula::Expr::symbol("P1"));
        }
        if (name.size() == 2 && (name[0] == 'P' || name[0] == 'b') && name[1] >= '1' &&
            name[1] < '9') {
            put("prime",
                formula::Expr::symbol(std::string{name[0], static_cast<char>(name[1] + 1)}));
        }
        const bool right = name.starts_with("right_");
        if (right || name.starts_with("left_")) {
            const std::string rest = name.substr(name.find('_'));
            put("left for right", formula::Expr::symbol((right ? "left" : "right") + rest));
        }
    }

    void call(const formula::Expr& node) {
        if (node.builtin() == formula::Builtin::sqrt) {
            put("root", node.arg(0));
        }
        if (node.name() == "right_local" || node.name() == "left_local") {
            put("left for right",
                formula::Expr::call(
                    node.name() == "right_local" ? "left_local" : "right_local",
                    std::vector<formula::Expr>(node.args().begin(), node.args().end())));
        }
    }

    const formula::Expr& formula_;
    formula::Path path_;
    std::vector<Mutant> mutants_;
    std::unordered_set<formula::Expr, formula::ExprHash> seen_{formula_};
};

} // namespace

const std::vector<std::string>& mutation_kinds() {
    static const std::vector<std::string> kinds{"sign",  "coefficient", "exponent",       "a for b",
                                                "prime", "factor",      "left for right", "root"};
    return kinds;
}

std::vector<Mutant> mutants_of(const formula::Expr& formula) { return Breaker(formula)(); }

} // namespace edgeproof::audit
