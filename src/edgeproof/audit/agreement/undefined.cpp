// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/agreement/enclosures.hpp"

#include "edgeproof/audit/enclosure/enclosed_integral.hpp"
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"
#include "edgeproof/audit/ledger/ledger_parts.hpp"
#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/precision/error.hpp"

#include <map>

namespace edgeproof::audit {
namespace {

using Kind = Expr::Kind;
using Found = std::optional<std::string>;

constexpr int halvings = 16; // places in an integral: at least 2^-16 of its length from an end

/// A formula at a sample, with values for the variables of the integrals around it.
class Subexpression {
public:
    Subexpression(const Sample& sample, long bits, std::map<std::string, Ball> variables)
        : sample_(sample), at_(sample, bits), bits_(bits),
          profile_(*sample.scene.as_scene()->profile), variables_(std::move(variables)) {
        for (const auto& [name, value] : variables_) {
            at_.set(name, value);
        }
    }

    /// Returns the innermost, first part without a value.
    [[nodiscard]] Found undefined(const Expr& e) const {
        if (e.rational() != nullptr) {
            return std::nullopt;
        }
        if (e.kind() == Kind::integral || e.kind() == Kind::pv) {
            return undefined_within(e);
        }
        if (e.is_binder()) {
            return std::nullopt;
        }
        for (const Expr& part : e.args()) {
            if (auto found = undefined(part)) {
                return found;
            }
        }
        return undefined_itself(e);
    }

private:
    [[nodiscard]] Found undefined_itself(const Expr& e) const {
        if (e.kind() == Kind::div) {
            return zero(e.arg(1)) ? Found(inside("division by zero", e)) : std::nullopt;
        }
        if (e.kind() == Kind::pow) {
            const Rational* k = e.arg(1).rational();
            if (k != nullptr && *k < 0 && zero(e.arg(0))) {
                return inside("zero to a negative power", e);
            }
            return k != nullptr && denominator(*k) != 1
                       ? beyond({e.arg(0)}, "a negative number to a power that is not an integer",
                                e)
                       : std::nullopt;
        }
        if (e.kind() != Kind::call) {
            return std::nullopt;
        }
        const Expr& x = e.arg(0);
        const std::string& name = e.name();
        if (name == "p" || name == "q" || name == "slip") {
            const std::string what = name == "p" ? "pressure" : name == "q" ? "traction" : name;
            return beyond({Expr::symbol("a") - x, x + Expr::symbol("b")},
                          what + " at a place beyond the contact", e);
        }
        if (is_stress(name)) {
            return beyond({e.arg(1)}, "stress at a negative depth", e);
        }
        if (name == "bof" || name == "binv" || name == "Pof" || name == "P1of") {
            return beyond({x}, name + " of a number that is not positive", e);
        }
        const Expr one = Expr::number(1);
        const std::string of = std::string(name_of(e.builtin())) + " of a number that is ";
        switch (e.builtin()) {
        case formula::Builtin::log:
            return zero(x) ? Found(inside("log of zero", e)) : beyond({x}, of + "negative", e);
        case formula::Builtin::sqrt:
            return beyond({x}, of + "negative", e);
        case formula::Builtin::asin:
        case formula::Builtin::acos:
        case formula::Builtin::atanh:
            return beyond({one - x, one + x}, of + "not between -1 and 1", e);
        case formula::Builtin::acosh:
            return beyond({x - one}, of + "less than 1", e);
        case formula::Builtin::gamma: {
            const Rational* k = x.rational();
            return k != nullptr && denominator(*k) == 1 && *k <= 0 ? Found(inside(of + "a pole", e))
                                                                   : std::nullopt;
        }
        default:
            return std::nullopt;
        }
    }

    /// True if e is zero for all values of its names, so that a quotient by it is undefined.
    [[nodiscard]] bool zero(const Expr& e) const {
        const bool wedge = profile_.kind() == contact::Profile::Kind::tilted_wedge;
        return vanishes_where_defined(e, profile_.symmetric() ? EdgeLaw::symmetric
                                         : wedge              ? EdgeLaw::linear
                                                              : EdgeLaw::any);
    }

    /// Returns `what` if one of the margins is certainly negative.
    [[nodiscard]] Found beyond(const std::vector<Expr>& margins, const std::string& what,
                               const Expr& e) const {
        for (const Expr& margin : margins) {
            try {
                if (certainly_negative(at_.evaluate(margin))) {
                    return inside(what, e);
                }
            } catch (const Error&) {
                continue; // it has an undefined part, which is checked separately, or no enclosure
            }
        }
        return std::nullopt;
    }
    [[nodiscard]] Found undefined_within(const Expr& integral) const {
        const Expr& from = integral.arg(2);
        const Expr& to = integral.arg(3);
        for (const Expr* limit : {&from, &to}) {
            if (auto found = undefined(*limit)) {
                return found;
            }
        }
        try {
            if (at_.diverges(integral)) {
                return inside("an integral that diverges", integral);
            }
            const Ball lo = at_.evaluate(from);
            const Ball length = at_.evaluate(to) - lo;
            for (int k = 1; k <= halvings; ++k) {
                const Ball part = length / (1L << k);
                for (const Ball& s : {lo + part, lo + length - part}) {
                    auto inside = variables_;
                    inside.insert_or_assign(integral.arg(1).name(), Ball(s.midpoint(), bits_));
                    if (auto found = Subexpression(sample_, bits_, std::move(inside))
                                         .undefined(integral.arg(0))) {
                        return found;
                    }
                }
            }
        } catch (const Error&) {
            return std::nullopt; // the limits have no value for reasons that are not relevant here
        }
        return std::nullopt;
    }

    const Sample& sample_;
    EnclosedSample at_;
    long bits_;
    contact::Profile profile_;
    std::map<std::string, Ball> variables_;
};

} // namespace

std::optional<std::string> no_value_of(const Expr& e, const Sample& sample, long bits) {
    try {
        return Subexpression(sample, bits, {}).undefined(e);
    } catch (const BudgetError&) { // too few bits for the contact
        return std::nullopt;
    }
}

} // namespace edgeproof::audit
