// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/decimal_token.hpp"

#include "edgeproof/formula/fold.hpp"
#include "edgeproof/formula/names.hpp"
#include "edgeproof/formula/parse.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>

namespace edgeproof::formula {
namespace {

constexpr long max_exponent = 100'000;
/// For all numbers of one expression together.
constexpr std::size_t max_number_bits = 4'000'000;

class DecimalReader {
public:
    DecimalReader(std::string_view text, std::size_t start)
        : text_(text), start_(start), pos_(start) {}

    DecimalToken operator()(std::size_t& bits) {
        long scale = 0;
        read_digits();
        if (peek() == '.') {
            ++pos_;
            scale = -static_cast<long>(read_digits());
        }
        if (digits_.empty()) {
            fail("a '.' without digits" + at_column(text_, start_), "write a number such as 0.5",
                 start_);
        }
        scale += exponent();
        if (peek() == '.') {
            fail("a second '.' in the number" + at_column(text_, start_),
                 "write a number such as 0.5", start_);
        }
        Rational q = value(scale);
        bits += q == 0 ? 0 : bits_of(q);
        if (bits > max_number_bits) {
            fail("the numbers are too long in total," + at_column(text_, pos_),
                 "write fewer digits or smaller exponents", pos_);
        }
        return {std::move(q), pos_};
    }

private:
    [[noreturn]] static void fail(std::string problem, std::string instead, std::size_t offset) {
        throw FormulaError(std::move(problem), std::move(instead), offset);
    }
    static bool is_digit(char c) { return c >= '0' && c <= '9'; }
    [[nodiscard]] char peek() const { return pos_ < text_.size() ? text_[pos_] : '\0'; }

    std::size_t read_digits() {
        const std::size_t from = pos_;
        while (is_digit(peek())) {
            digits_ += text_[pos_++];
        }
        return pos_ - from;
    }

    /// The decimal exponent, if one follows.
    long exponent() {
        std::size_t p = pos_;
        const auto here = [&] { return p < text_.size() ? text_[p] : '\0'; };
        if (here() != 'e' && here() != 'E') {
            return 0;
        }
        ++p;
        const bool negative = here() == '-';
        if (here() == '-' || here() == '+') {
            ++p;
        }
        if (!is_digit(here())) {
            return 0;
        }
        long size = 0;
        for (; is_digit(here()); ++p) {
            size = std::min(10 * size + (here() - '0'), 10 * max_exponent);
        }
        pos_ = p;
        return negative ? -size : size;
    }

    /// The digits * 10^scale, exactly.
    [[nodiscard]] Rational value(long scale) const {
        const std::string digits =
            digits_.substr(std::min(digits_.find_first_not_of('0'), digits_.size()));
        if (digits.empty()) {
            return {};
        }
        if (std::abs(scale + static_cast<long>(digits.size()) - 1) > max_exponent) {
            fail("the number" + at_column(text_, start_) + " has an exponent beyond " +
                     std::to_string(max_exponent),
                 "write an exponent between -" + std::to_string(max_exponent) + " and " +
                     std::to_string(max_exponent),
                 start_);
        }
        const Integer mantissa(digits);
        Integer ten_power;
        mpz_ui_pow_ui(ten_power.backend().data(), 10, static_cast<unsigned long>(std::abs(scale)));
        return scale < 0 ? Rational(mantissa, ten_power) : Rational(mantissa * ten_power);
    }

    std::string_view text_;
    std::size_t start_;
    std::size_t pos_;
    std::string digits_;
};

} // namespace

DecimalToken decimal_token(std::string_view text, std::size_t start, std::size_t& bits) {
    return DecimalReader(text, start)(bits);
}

} // namespace edgeproof::formula
