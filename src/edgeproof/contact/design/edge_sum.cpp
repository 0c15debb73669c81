// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/design/edge_sum.hpp"

#include <cmath>
#include <utility>

namespace edgeproof::contact {
namespace {

constexpr double most_terms_a_bit = 4;

// An array of the one is an array of the other.
static_assert(sizeof(ArbValue) == sizeof(arb_struct));

} // namespace

void EdgeSum::carry(const Ball& b, long n, long bits) {
    if (bits != bits_ || arb_equal(b.data(), b_) == 0) {
        bits_ = bits;
        arb_set(b_, b.data());
        c_.resize(1);
        arb_one(c_[0]);
    }
    for (auto k = static_cast<long>(c_.size()) - 1; k < n; ++k) {
        ArbValue next;
        arb_mul(next, c_.back(), ((b + k) * 2).data(), bits);
        arb_div_si(next, next, 2 * k + 3, bits);
        c_.push_back(std::move(next));
    }
}

std::optional<Ball> EdgeSum::operator()(const Ball& b, const Ball& y) {
    const long bits = y.bits();
    const Ball size = abs(y);
    const double ratio = size.upper().convert_to<double>();
    const double terms = std::ceil(static_cast<double>(bits) / -std::log2(ratio)) + 1;
    if (!(ratio < 1 && terms < most_terms_a_bit * static_cast<double>(bits)) ||
        !certainly_less(b, Ball(1, bits))) {
        return std::nullopt;
    }
    const auto n = static_cast<long>(terms);
    if (!certainly_positive(b + n)) {
        return std::nullopt;
    }
    carry(b, n, bits);
    Ball sum(0, bits);
    _arb_poly_evaluate_rectangular(sum.data(), c_[0], n, y.data(), bits);
    // From term n on, each is less than y times the one before: 0 < b + k < 3/2 + k.
    Ball rest = pow_int(size, n) / (1 - size);
    arb_mul(rest.data(), rest.data(), c_[static_cast<std::size_t>(n)], bits);
    arb_add_error(sum.data(), rest.data());
    return sum;
}

} // namespace edgeproof::contact
