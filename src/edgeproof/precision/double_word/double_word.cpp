// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/precision/double_word/double_word.hpp"

#include "edgeproof/precision/ball/arb_values.hpp"

namespace edgeproof {

namespace {

/// The part of a ball that remains after its leading words have been extracted.
struct Unsplit {
    explicit Unsplit(const Ball& x) { arf_set(rest, arb_midref(x.data())); }
    double next() {
        const double word = arf_get_d(rest, ARF_RND_NEAR);
        ArfValue part;
        arf_set_d(part, word);
        arf_sub(rest, rest, part, ARF_PREC_EXACT, ARF_RND_DOWN);
        return word;
    }
    /// Returns an upper bound of the remainder plus the radius of the ball.
    [[nodiscard]] double radius(const Ball& x) const {
        MagValue sum;
        arf_get_mag(sum, rest);
        mag_add(sum, sum, arb_radref(x.data()));
        // mag_get_d rounds to nearest.
        return mag_is_zero(sum) != 0
                   ? 0
                   : std::nextafter(mag_get_d(sum), std::numeric_limits<double>::infinity());
    }
    ArfValue rest;
};

bool in_range(const Ball& x, double high) {
    const double size = std::fabs(high);
    return x.is_finite() &&
           (arf_is_zero(arb_midref(x.data())) != 0 || (size > 0x1p-900 && size < 0x1p900));
}

} // namespace

DoubleWord to_double_word(const Ball& x) {
    Unsplit parts(x);
    DoubleWord word;
    word.high = parts.next();
    if (!in_range(x, word.high)) {
        return double_word::unknown();
    }
    word.low = parts.next();
    word.radius = parts.radius(x);
    return word;
}

DoubleWord to_double_word(const Real& x) {
    return to_double_word(Ball(x, static_cast<long>(x.backend().data()[0]._mpfr_prec)));
}

PreciseWord to_precise_word(const Ball& x) {
    Unsplit parts(x);
    PreciseWord word;
    word.first.high = parts.next();
    if (!in_range(x, word.first.high)) {
        return {double_word::unknown(), double_word::unknown()};
    }
    word.first.low = parts.next();
    word.rest.high = parts.next();
    word.rest.radius = parts.radius(x);
    return word;
}

} // namespace edgeproof
