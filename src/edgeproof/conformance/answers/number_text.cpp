// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/answers/number_text.hpp"

#include "edgeproof/conformance/answers/answers.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>
#include <charconv>

namespace edgeproof::conformance {
namespace {

constexpr long most_binary_exponent = 332'192; // 2^332192 < 10^100000
constexpr std::size_t most_hexadecimal_digits = 100'000;

// <cctype> depends on the locale.
bool is_decimal_digit(char c) { return c >= '0' && c <= '9'; }
bool is_hexadecimal_digit(char c) { return is_decimal_digit(c) || (c >= 'a' && c <= 'f'); }
bool is_word(char c) { return is_decimal_digit(c) || (c >= 'a' && c <= 'z') || c == '_'; }

std::string in_lower_case(std::string_view text) {
    std::string out(text);
    for (char& c : out) {
        c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    }
    return out;
}

/// Splits a text from its front.
class Scanner {
public:
    explicit Scanner(std::string_view text) : rest_(text) {}
    bool take(std::string_view word) {
        const bool there = rest_.starts_with(word);
        rest_.remove_prefix(there ? word.size() : 0);
        return there;
    }
    template <class Is> std::string_view take_all(const Is& is) {
        const auto end = std::find_if_not(rest_.begin(), rest_.end(), is);
        const std::string_view taken =
            rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
        rest_.remove_prefix(taken.size());
        return taken;
    }
    /// Returns -1, or 1 for a plus or no sign.
    int sign() { return take("-") ? -1 : (take("+"), 1); }
    [[nodiscard]] bool at_end() const { return rest_.empty(); }

private:
    std::string_view rest_;
};

struct WrittenDigits {
    std::string all;
    std::size_t behind_point = 0;
};

template <class Is>
std::optional<WrittenDigits> digits_with_a_point(Scanner& scanner, const Is& is) {
    WrittenDigits digits;
    digits.all = scanner.take_all(is);
    if (scanner.take(".")) {
        const std::string_view behind = scanner.take_all(is);
        digits.behind_point = behind.size();
        digits.all += behind;
    }
    return digits.all.empty() ? std::nullopt : std::optional(digits);
}

/// Reads the part after the letter of an exponent: an optional sign, and digits up to the end.
std::optional<long> exponent_to_the_end(Scanner& scanner) {
    const int sign = scanner.sign();
    const std::string_view digits = scanner.take_all(is_decimal_digit);
    long value = 0;
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const bool whole = !digits.empty() && scanner.at_end() && read.ec == std::errc{};
    return whole ? std::optional(sign * value) : std::nullopt;
}

std::optional<Rational> hexadecimal_value(Scanner& scanner) {
    const auto digits = digits_with_a_point(scanner, is_hexadecimal_digit);
    if (!digits || digits->all.size() > most_hexadecimal_digits) {
        return {};
    }
    long exponent = 0;
    if (scanner.take("p")) {
        const auto written = exponent_to_the_end(scanner);
        if (!written || std::abs(*written) > most_binary_exponent) {
            return {};
        }
        exponent = *written;
    }
    if (!scanner.at_end()) {
        return {};
    }
    // The leading zero does not make the number octal, and prevents an empty number.
    const Integer whole("0x0" + digits->all);
    exponent -= 4 * static_cast<long>(digits->behind_point);
    const Integer power = Integer(1) << static_cast<unsigned>(std::abs(exponent));
    return exponent < 0 ? Rational(whole, power) : Rational(whole * power);
}

/// Checks the grammar; the value is that of `plain`, which has E for the exponent.
std::optional<Rational> decimal_value(Scanner& scanner, std::string plain) {
    if (!digits_with_a_point(scanner, is_decimal_digit)) {
        return {};
    }
    if (scanner.take("e") || scanner.take("d")) {
        if (!exponent_to_the_end(scanner)) {
            return {};
        }
    }
    if (!scanner.at_end()) {
        return {};
    }
    std::replace(plain.begin(), plain.end(), 'd', 'e');
    try {
        return parse_decimal(plain);
    } catch (const InputError&) { // too long, or out of range
        return {};
    }
}

} // namespace

WrittenNumber written_number(std::string_view text) {
    const std::string lower = in_lower_case(text);
    Scanner scanner(lower);
    const int sign = scanner.sign();
    if (scanner.take("nan")) {
        if (scanner.take("(")) {
            scanner.take_all(is_word);
            if (!scanner.take(")")) {
                return {};
            }
        }
        return {scanner.at_end() ? WrittenNumber::Kind::nan : WrittenNumber::Kind::other, {}};
    }
    if (scanner.take("inf")) {
        scanner.take("inity");
        return {scanner.at_end() ? WrittenNumber::Kind::infinite : WrittenNumber::Kind::other, {}};
    }
    const bool hexadecimal = scanner.take("0x");
    const std::size_t unsigned_from = lower.find_first_not_of("+-");
    const auto value = hexadecimal ? hexadecimal_value(scanner)
                       : unsigned_from == std::string::npos
                           ? std::nullopt
                           : decimal_value(scanner, lower.substr(unsigned_from));
    return value ? WrittenNumber{WrittenNumber::Kind::number, Rational(*value * sign)}
                 : WrittenNumber{};
}

std::optional<std::string> with_decimal_point(std::string_view text) {
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos || text.find('.') != std::string_view::npos ||
        text.find_first_of("xX") != std::string_view::npos) {
        return {};
    }
    std::string pointed(text);
    pointed[comma] = '.';
    return written_number(pointed).kind == WrittenNumber::Kind::number ? std::optional(pointed)
                                                                       : std::nullopt;
}

Answer read_answer(std::string_view given) {
    Answer answer;
    answer.text = std::string(given);
    WrittenNumber number = written_number(given);
    switch (number.kind) {
    case WrittenNumber::Kind::number:
        answer.state = Answer::State::number;
        answer.value = std::move(number.value);
        break;
    case WrittenNumber::Kind::nan:
        answer.state = Answer::State::nan;
        break;
    case WrittenNumber::Kind::infinite:
        answer.state = Answer::State::infinite;
        break;
    case WrittenNumber::Kind::other:
        answer.state = given.empty() ? Answer::State::missing : Answer::State::garbage;
        break;
    }
    return answer;
}

} // namespace edgeproof::conformance
