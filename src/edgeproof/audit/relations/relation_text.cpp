// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/relations/relations.hpp"

namespace edgeproof::audit {
namespace {

bool is_one_name(const std::string& name) {
    return name.find_first_of("+-*/^ ") == std::string::npos;
}

/// Returns the factors of a term without its numerical coefficient.
std::string factors(const std::vector<unsigned>& exponents,
                    const std::vector<RelatedQuantity>& quantities) {
    std::string text;
    // In reverse order of the quantities: 6*L*b1^2*left.c1.
    for (std::size_t i = exponents.size(); i-- > 0;) {
        if (exponents[i] == 0) {
            continue;
        }
        const std::string& name = quantities[i].name;
        text += text.empty() ? "" : "*";
        text += is_one_name(name) ? name : "(" + name + ")";
        text += exponents[i] > 1 ? "^" + std::to_string(exponents[i]) : "";
    }
    return text;
}

struct TermText {
    Integer coefficient;
    std::string factors;
};

std::string sum_text(const std::vector<TermText>& terms) {
    std::string text;
    for (const TermText& term : terms) {
        const bool minus = term.coefficient < 0;
        const Integer size = minus ? Integer(-term.coefficient) : term.coefficient;
        text += text.empty() ? (minus ? "-" : "") : minus ? " - " : " + ";
        if (term.factors.empty()) {
            text += size.str();
        } else {
            text += size == 1 ? term.factors : size.str() + "*" + term.factors;
        }
    }
    return text;
}

} // namespace

std::string relation_text(const PolynomialRelation& relation,
                          const std::vector<RelatedQuantity>& quantities) {
    std::vector<TermText> terms;
    for (const PolynomialRelation::Term& t : relation.terms) {
        terms.push_back({t.coefficient, factors(t.exponents, quantities)});
    }
    return sum_text(terms) + " = 0";
}

std::optional<std::string> solved_text(const PolynomialRelation& relation,
                                       const std::vector<RelatedQuantity>& quantities,
                                       std::size_t quantity) {
    std::vector<TermText> over;
    std::vector<TermText> under;
    for (const PolynomialRelation::Term& t : relation.terms) {
        std::vector<unsigned> e = t.exponents;
        if (e[quantity] > 1) {
            return {};
        }
        if (e[quantity] == 1) {
            e[quantity] = 0;
            under.push_back({t.coefficient, factors(e, quantities)});
        } else {
            over.push_back({-t.coefficient, factors(e, quantities)});
        }
    }
    if (under.empty() || over.empty()) {
        return {};
    }
    std::string top = sum_text(over);
    std::string bottom = sum_text(under);
    if (over.size() > 1) {
        top = "(" + top + ")";
    }
    if (under.size() > 1 || bottom.find('*') != std::string::npos) {
        bottom = "(" + bottom + ")";
    }
    return quantities[quantity].name + " = " + top + (bottom == "1" ? "" : "/" + bottom);
}

} // namespace edgeproof::audit
