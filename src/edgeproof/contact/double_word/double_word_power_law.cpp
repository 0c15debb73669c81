// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/double_word/double_word_power_law.hpp"

namespace edgeproof::contact {
namespace {

constexpr long bits = 256;
constexpr long coefficients = 400;
constexpr long largest_m = 64;

/// The coefficients of 2F1(1, (1 - n)/2; 3/2; y) (DLMF 15.2.1). The ratio of two,
/// (k + (1 - n)/2)/(k + 3/2), is below 1.
std::vector<Ball> edge_coefficients(const Rational& n) {
    std::vector<Ball> a{Ball(1, bits)};
    for (long k = 0; k + 1 < coefficients; ++k) {
        a.push_back(a.back() * Ball(Rational(2 * k + 1 - n), bits) / (2 * k + 3));
    }
    return a;
}
/// The coefficients beta_k/(n - 2k) (DLMF 15.8.4; docs/pressure.md, "Closed form: power laws"), at
/// most 2 in size, as beta_k <= 1 and n is 1/2 or 3/2.
std::vector<Ball> apex_coefficients(const Rational& n) {
    std::vector<Ball> a;
    Ball beta(1, bits);
    for (long k = 0; k < coefficients; ++k) {
        a.push_back(beta / Ball(Rational(n - 2 * k), bits));
        beta = beta * (2 * k + 1) / (2 * k + 2);
    }
    return a;
}
/// C = (sqrt(pi)/2) Gamma(-n/2)/Gamma((1 - n)/2) (DLMF 15.8.4).
DoubleWord apex_power(const Rational& n) {
    return to_double_word(sqrt(Ball::pi(bits)) / 2 * gamma(Ball(Rational(-n / 2), bits)) /
                          gamma(Ball(Rational((1 - n) / 2), bits)));
}

} // namespace

DoubleWordPowerLaw::Series::Series(const Rational& n)
    : edge(edge_coefficients(n), 1), apex(apex_coefficients(n), 2), power(apex_power(n)) {}

const DoubleWordPowerLaw::Series& DoubleWordPowerLaw::Series::of(Lowest n) {
    if (n == Lowest::half) {
        static const Series half(Rational(1, 2));
        return half;
    }
    static const Series three_halves(Rational(3, 2));
    return three_halves;
}

bool DoubleWordPowerLaw::has(const formula::Exact& m) {
    return m.is_rational() && denominator(m.rational()) <= 2 && m.rational() <= largest_m;
}

DoubleWordPowerLaw::DoubleWordPowerLaw(const formula::Exact& m, const BallContact& contact,
                                       const BallContact& whole)
    : apex_{to_precise_word(whole.a()), to_precise_word(whole.b())},
      inverse_(to_double_word(1 / contact.a())),
      factor_(to_double_word(contact.pressure_factor())) {
    const auto halves = Rational(m.rational() * 2).convert_to<long>();
    n_ = static_cast<Lowest>(halves % 4);
    for (long k = halves % 4 + 4; k <= halves; k += 4) {
        steps_.push_back({to_double_word(Ball(Rational(2, k), bits)),
                          to_double_word(Ball(Rational(k - 2, k), bits))});
    }
    if (halves % 2 == 1) {
        series_ = &Series::of(n_);
    }
}

} // namespace edgeproof::contact
