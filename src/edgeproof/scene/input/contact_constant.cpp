// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/input/contact_constant.hpp"

#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>
#include <string>

namespace edgeproof::scene {
namespace {

constexpr long bits_of_size = 64;
constexpr std::size_t most_shown = 60;

const Rational& largest_size() {
    static const Rational q = parse_decimal("1e10000");
    return q;
}
const Rational& smallest_size() {
    static const Rational q = parse_decimal("1e-10000");
    return q;
}

bool numbers_in_range(const formula::Expr& e) {
    if (const Rational* q = e.rational()) {
        const Rational size = abs(*q);
        return size == 0 || (smallest_size() <= size && size <= largest_size());
    }
    return std::ranges::all_of(e.args(), numbers_in_range);
}

/// False only where the value is proved to be beyond the range.
bool value_in_range(const formula::Expr& e) {
    const auto x = formula::enclose(e, bits_of_size);
    if (!x) {
        return true;
    }
    const PrecisionScope scope(30);
    const Real largest = from_rational<Real>(largest_size());
    const Real smallest = from_rational<Real>(smallest_size());
    const bool is_larger = x->lower > largest || x->upper < -largest;
    const bool is_smaller =
        (x->lower > 0 || x->upper < 0) && abs(x->lower) < smallest && abs(x->upper) < smallest;
    return !is_larger && !is_smaller;
}

} // namespace

void check_size(const io::TomlSection& section, std::string_view key, const formula::Expr& e,
                std::string_view text) {
    if (!numbers_in_range(e) ||
        (formula::free_symbols(e).empty() && !formula::has_binder(e) && !value_in_range(e))) {
        section.reject(key,
                       std::string(key) + " = " + shortened(text, most_shown) +
                           " is beyond the range of what defines a contact",
                       "write 0, or a number between 1e-10000 and 1e10000");
    }
}

formula::Exact contact_constant(const io::TomlSection& section, std::string_view key) {
    formula::Exact value = section.exact(key);
    check_size(section, key, value.expr(), value.text());
    return value;
}

} // namespace edgeproof::scene
