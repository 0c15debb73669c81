// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/double_word/double_word_expansion.hpp"

#include "edgeproof/precision/double_word/double_word.hpp"
#include "edgeproof/precision/rational.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace edgeproof::contact {
namespace {

/// The number of terms after p_n that are summed near the edge (docs/double-words.md, lemma 8).
constexpr std::size_t next_terms = 32;

/// Returns a power of two near the reach, limited to the range of binary64.
double unit_of(const BallContact& contact, Edge edge) {
    constexpr int most = 1000;
    const int exponent = std::ilogb(contact.reach(edge).midpoint().convert_to<double>());
    return std::ldexp(1.0, std::clamp(exponent, -most, most));
}

/// Returns c_k unit^k for k = first, ...
std::vector<DoubleWord> words_of(const std::vector<Ball>& c, std::size_t first, double unit) {
    std::vector<DoubleWord> words;
    for (std::size_t k = first; k < c.size(); ++k) {
        const Ball power = pow_int(Ball(exact_rational(unit), c[k].bits()), static_cast<long>(k));
        words.push_back(to_double_word(c[k] * power));
    }
    return words;
}

/// True if the coefficients are in range. A coefficient that vanishes may be known only as a small
/// ball about 0.
bool in_range(const std::vector<DoubleWord>& c) {
    return std::ranges::all_of(c, [](const DoubleWord& x) {
        return std::isfinite(x.radius) && x.radius < 0x1p200 && std::fabs(x.high) < 0x1p200;
    });
}

} // namespace

DoubleWordSum::DoubleWordSum(const BallContact& contact, Edge edge, std::size_t n)
    : edge_(edge), length_(to_precise_word(contact.a() + contact.b())),
      unit_(unit_of(contact, edge)), per_unit_(1 / unit_),
      c_(words_of(contact.expansion(edge, n), 0, unit_)),
      in_range_(in_double_words_as_constant(length_.first) &&
                in_double_words_as_factor(c_.front()) && contact::in_range(c_)),
      kernel_(DoubleWordKernel<DoubleWordSum>::chosen()) {}

DoubleWordRelativeError::DoubleWordRelativeError(const Profile& profile, const BallContact& contact,
                                                 Edge edge, std::size_t n)
    : sum_(contact, edge, n), pressure_(profile, contact),
      in_range_(sum_.in_range_ && pressure_.in_range()),
      kernel_(DoubleWordKernel<DoubleWordRelativeError>::chosen()) {
    const Ball rho = Ball(contact.reach(edge).lower(), contact.bits()) / 2;
    const Ball M = contact.majorant(edge, rho);
    std::vector<DoubleWord> next = words_of(contact.expansion(edge, n + next_terms), n, sum_.unit_);
    if (!certainly_positive(rho) || !M.is_finite() || !contact::in_range(next)) {
        return;
    }
    // Since |c_k| <= M/rho^k, the terms after the 32 are, for u <= rho/8, at most M (unit/rho)^n
    // 8^-32 (1 + 1/8 + ...) (docs/double-words.md, lemma 8).
    const Ball unit(exact_rational(sum_.unit_), rho.bits());
    const Ball cut = M * 8 / 7 * pow_int(unit / rho, static_cast<long>(n)) /
                     pow_int(Ball(8, rho.bits()), static_cast<long>(next_terms));
    next_ = std::move(next);
    near_ = std::nextafter(Ball(rho / 8).lower().convert_to<double>(), 0.0);
    cut_off_ = std::nextafter(cut.upper().convert_to<double>(), 1e300);
}

} // namespace edgeproof::contact
