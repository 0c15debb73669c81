// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/ledger/printed_formula.hpp"

#include "edgeproof/precision/arithmetic.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <cctype>

namespace edgeproof::audit {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool begins_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }

} // namespace

Ball PrintedDecimal::interval(const Rational& units, long bits) const {
    return Ball::hull(Ball(Rational(value - units * unit), bits),
                      Ball(Rational(value + units * unit), bits));
}

std::size_t PrintedDecimal::significant_digits() const {
    std::size_t count = 0;
    for (const char c : text.substr(0, text.find_first_of("eE"))) {
        count += is_digit(c) && (count > 0 || c != '0') ? 1 : 0;
    }
    return count;
}

std::string PrintedDecimal::in_its_place(const Real& number) const {
    const Real steps = floor(Real(number / from_rational<Real>(unit) + Real(1) / 2));
    if (text.find_first_of("eE") == std::string::npos) {
        const std::size_t places = text.size() - text.find('.') - 1;
        return Real(steps * from_rational<Real>(unit))
            .str(static_cast<std::streamsize>(places), std::ios_base::fixed);
    }
    return "(" + exact_text(Rational(steps.convert_to<Integer>()) * unit) + ")";
}

std::vector<PrintedDecimal> printed_decimals(std::string_view formula) {
    std::vector<PrintedDecimal> all;
    for (std::size_t i = 0; i < formula.size();) {
        std::size_t end = i;
        if (begins_name(formula[i])) { // a name may contain dots: "right.c0"
            while (end < formula.size() &&
                   (begins_name(formula[end]) || is_digit(formula[end]) || formula[end] == '.')) {
                ++end;
            }
            i = end;
            continue;
        }
        while (end < formula.size() && (is_digit(formula[end]) || formula[end] == '.')) {
            ++end;
        }
        if (end == i) {
            ++i;
            continue;
        }
        const std::size_t point = formula.substr(i, end - i).find('.');
        const std::size_t mantissa = end;
        if (end + 1 < formula.size() && (formula[end] == 'e' || formula[end] == 'E')) {
            std::size_t e = end + 1;
            e += formula[e] == '+' || formula[e] == '-' ? 1 : 0;
            if (e < formula.size() && is_digit(formula[e])) {
                while (e < formula.size() && is_digit(formula[e])) {
                    ++e;
                }
                end = e;
            }
        }
        if (point != std::string_view::npos) {
            PrintedDecimal d{std::string(formula.substr(i, end - i)), i, {}, {}};
            d.value = parse_decimal(d.text);
            const std::size_t places = mantissa - i - point - 1;
            d.unit = parse_decimal("1e-" + std::to_string(places));
            if (end > mantissa) {
                d.unit *=
                    parse_decimal("1" + std::string(formula.substr(mantissa, end - mantissa)));
            }
            if (d.value != 0) {
                all.push_back(std::move(d));
            }
        }
        i = end;
    }
    return all;
}

std::string DecimalFormula::name_of_decimal(std::size_t k) {
    return "printed_decimal_" + std::to_string(k);
}

std::string DecimalFormula::text_with(const std::vector<Real>& numbers) const {
    std::string text = text_;
    for (std::size_t k = decimals_.size(); k-- > 0;) {
        const PrintedDecimal& printed = decimals_[k];
        text.replace(printed.offset, printed.text.size(), printed.in_its_place(numbers[k]));
    }
    return text;
}

namespace {

/// Replaces each decimal by a name and adds that name to the vocabulary.
std::string with_names(std::string text, const std::vector<PrintedDecimal>& decimals,
                       Vocabulary& vocabulary) {
    for (std::size_t k = decimals.size(); k-- > 0;) {
        const std::string name = DecimalFormula::name_of_decimal(k);
        text.replace(decimals[k].offset, decimals[k].text.size(), "(" + name + ")");
        vocabulary.symbols.add(name);
    }
    return text;
}

std::vector<PrintedDecimal> rounded_decimals(const Claim& claim, const std::string& text) {
    return claim.text_or("decimals", "rounded") == "exact" ? std::vector<PrintedDecimal>()
                                                           : printed_decimals(text);
}

} // namespace

PrintedFormula DecimalFormula::read(const Claim& claim, const std::string& text) {
    const Expr as_printed =
        expand_definitions(parse_formula(text, claim.vocabulary), claim.vocabulary);
    std::vector<PrintedDecimal> decimals = rounded_decimals(claim, text);
    if (decimals.empty()) {
        return ExactFormula(as_printed);
    }
    Vocabulary vocabulary = claim.vocabulary;
    const std::string named = with_names(text, decimals, vocabulary);
    DecimalFormula read;
    read.text_ = text;
    read.expr_ = expand_definitions(parse_formula(named, vocabulary), vocabulary);
    read.as_printed_ = as_printed;
    read.decimals_ = std::move(decimals);
    return read;
}

PrintedFormula printed_formula(const Claim& claim, std::string_view key) {
    return DecimalFormula::read(claim, claim.text(key));
}

PrintedCondition printed_condition(const Claim& claim, std::string_view key) {
    PrintedCondition read{claim.condition(key), claim.condition(key), {}};
    const std::string& text = claim.text(key);
    read.decimals = rounded_decimals(claim, text);
    if (!read.decimals.empty()) {
        Vocabulary vocabulary = claim.vocabulary;
        read.named = parse_condition(with_names(text, read.decimals, vocabulary), vocabulary);
        for (Relation& r : read.named) {
            r.lhs = expand_definitions(r.lhs, vocabulary);
            r.rhs = expand_definitions(r.rhs, vocabulary);
        }
    }
    return read;
}

} // namespace edgeproof::audit
