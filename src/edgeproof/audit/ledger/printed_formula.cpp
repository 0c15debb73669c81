// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/ledger/printed_formula.hpp"

#include "edgeproof/precision/real.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>

namespace edgeproof::audit {
Ball PrintedDecimal::interval(const Rational& units, long bits) const {
    return Ball::hull(Ball(Rational(value - units * unit), bits),
                      Ball(Rational(value + units * unit), bits));
}

std::size_t PrintedDecimal::significant_digits() const {
    std::size_t count = 0;
    for (const char c : text.substr(0, text.find_first_of("eE"))) {
        count += c != '.' && (count > 0 || c != '0') ? 1 : 0;
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

std::string name_of_decimal(std::size_t k) { return "printed_decimal_" + std::to_string(k); }

Expr with_names(Expr e, std::string_view text, std::vector<PrintedDecimal>& decimals) {
    for (const formula::Path& path : paths(e)) {
        const Expr number = at(e, path);
        const std::string written(text.substr(number.offset(), number.length()));
        const std::size_t point = written.find('.');
        if (number.kind() != Expr::Kind::number || point == std::string::npos ||
            number.number() == 0) {
            continue;
        }
        const std::size_t power = std::min(written.find_first_of("eE"), written.size());
        const Rational unit = parse_decimal("1" + written.substr(power)) *
                              parse_decimal("1e-" + std::to_string(power - point - 1));
        e = replace(e, path, Expr::symbol(name_of_decimal(decimals.size())));
        decimals.push_back({written, number.offset(), number.number(), unit});
    }
    return e;
}

std::string PrintedFormula::text_with(const std::vector<Real>& numbers) const {
    std::string with = text;
    for (std::size_t k = decimals.size(); k-- > 0;) {
        const PrintedDecimal& printed = decimals[k];
        with.replace(printed.offset, printed.text.size(), printed.in_its_place(numbers[k]));
    }
    return with;
}

namespace {

bool has_exact_decimals(const Claim& claim) {
    return claim.text_or("decimals", "rounded") == "exact";
}

} // namespace

PrintedFormula printed_formula(const Claim& claim) {
    const Expr& as_printed = claim.formula("says");
    PrintedFormula read{claim.text("says"), as_printed, as_printed, {}};
    if (!has_exact_decimals(claim)) {
        read.named = expand_definitions(with_names(claim.written("says"), read.text, read.decimals),
                                        claim.vocabulary);
    }
    return read;
}

PrintedCondition printed_condition(const Claim& claim) {
    PrintedCondition read{claim.condition("says"), claim.condition("says"), {}};
    if (!has_exact_decimals(claim)) {
        read.named = parse_condition(claim.text("says"), [&](std::string_view side) {
            const Expr written = parse_formula(side, claim.vocabulary);
            return expand_definitions(with_names(written, side, read.decimals), claim.vocabulary);
        });
    }
    return read;
}

} // namespace edgeproof::audit
