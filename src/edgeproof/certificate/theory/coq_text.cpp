// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/theory/theory.hpp"

#include <fmt/format.h>

#include <utility>

namespace edgeproof::certificate {
namespace {

using formula::Builtin;
using Kind = Expr::Kind;

/// The binding strength of a term: an operand that binds more weakly needs parentheses.
enum class Strength { sum = 1, product, sign, power, application, atom };

struct Term {
    std::string text;
    Strength strength;
};

std::string parenthesized(const Term& t, Strength least) {
    return t.strength < least ? "(" + t.text + ")" : t.text;
}

/// The functions that Coq's library of real numbers has.
constexpr std::pair<Builtin, const char*> coq_functions[] = {
    {Builtin::sqrt, "sqrt"}, {Builtin::exp, "exp"},   {Builtin::log, "ln"},
    {Builtin::sin, "sin"},   {Builtin::cos, "cos"},   {Builtin::tan, "tan"},
    {Builtin::asin, "asin"}, {Builtin::acos, "acos"}, {Builtin::atan, "atan"},
    {Builtin::abs, "Rabs"},  {Builtin::max, "Rmax"},  {Builtin::min, "Rmin"}};

class Writer {
public:
    Writer(const CoqNames& names, const CoqCall& call) : names_(names), call_(call) {}

    Term operator()(const Expr& e) const {
        switch (e.kind()) {
        case Kind::number:
            return number(e.number());
        case Kind::pi:
            return {"PI", Strength::atom};
        case Kind::symbol:
            return symbol(e.name());
        case Kind::neg:
            return {"- " + operand(e.arg(0), Strength::power), Strength::sign};
        case Kind::add:
            return binary(e, " + ", Strength::sum, Strength::product);
        case Kind::sub:
            return binary(e, " - ", Strength::sum, Strength::product);
        case Kind::mul:
            return binary(e, " * ", Strength::product, Strength::power);
        case Kind::div:
            return binary(e, " / ", Strength::product, Strength::power);
        case Kind::pow:
            return power(e);
        case Kind::call:
            for (const auto& [builtin, name] : coq_functions) {
                if (builtin == e.builtin()) {
                    return application(name, e);
                }
            }
            if (const auto gamma = names_.find("gamma");
                e.builtin() == Builtin::gamma && gamma != names_.end()) {
                return application(gamma->second, e);
            }
            break;
        default:
            break;
        }
        if (call_) {
            return {call_(e), Strength::atom};
        }
        throw NotStated(fmt::format("{} is not stated in Coq", to_text(e)));
    }

private:
    std::string operand(const Expr& e, Strength least) const {
        return parenthesized((*this)(e), least);
    }
    /// The tree is left-associative: a right operand of equal strength needs parentheses.
    Term binary(const Expr& e, std::string_view sign, Strength own, Strength right) const {
        return {operand(e.arg(0), own) + std::string(sign) + operand(e.arg(1), right), own};
    }
    static Term number(const Rational& q) {
        if (denominator(q) == 1 && q >= 0) {
            return {numerator(q).str(), Strength::atom};
        }
        return {coq_number(q), Strength::atom};
    }
    Term symbol(const std::string& name) const {
        const auto found = names_.find(name);
        if (found == names_.end()) {
            throw NotStated(fmt::format("'{}' is not stated in Coq", name));
        }
        const bool plain = found->second.find(' ') == std::string::npos;
        return {found->second,
                plain || found->second.front() == '(' ? Strength::atom : Strength::application};
    }
    Term power(const Expr& e) const {
        const Rational* const exponent = e.arg(1).rational();
        if (exponent == nullptr) {
            return {fmt::format("Rpower {} {}", operand(e.arg(0), Strength::atom),
                                operand(e.arg(1), Strength::atom)),
                    Strength::application};
        }
        if (denominator(*exponent) == 1 && *exponent >= 0) {
            return {operand(e.arg(0), Strength::application) + " ^ " + numerator(*exponent).str(),
                    Strength::power};
        }
        if (denominator(*exponent) == 1) {
            return {fmt::format("(/ {} ^ {})", operand(e.arg(0), Strength::application),
                                numerator(Rational(-*exponent)).str()),
                    Strength::atom};
        }
        return {
            fmt::format("Rpower {} {}", operand(e.arg(0), Strength::atom), coq_number(*exponent)),
            Strength::application};
    }
    Term application(std::string text, const Expr& e) const {
        for (const Expr& argument : e.args()) {
            text += " " + operand(argument, Strength::atom);
        }
        return {std::move(text), Strength::application};
    }

    const CoqNames& names_;
    const CoqCall& call_;
};

} // namespace

std::string coq_number(const Rational& q) {
    const Rational size = q < 0 ? Rational(-q) : q;
    const std::string text =
        denominator(size) == 1
            ? numerator(size).str()
            : fmt::format("({} / {})", numerator(size).str(), denominator(size).str());
    return q < 0 ? fmt::format("(- {})", text) : text;
}

std::string coq_text(const Expr& e, const CoqNames& names, const CoqCall& call) {
    return Writer(names, call)(e).text;
}

} // namespace edgeproof::certificate
