// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/double_word/double_word_ball.hpp"

#include "edgeproof/precision/ball/arb_values.hpp"

namespace edgeproof {

DoubleWord to_double_word(const Ball& x) {
    if (!x.is_finite()) {
        return double_word::unknown();
    }
    DoubleWord word;
    ArfValue rest;
    ArfValue part;
    arf_set(rest, arb_midref(x.data()));
    for (double* const next : {&word.high, &word.low}) {
        *next = arf_get_d(rest, ARF_RND_NEAR);
        arf_set_d(part, *next);
        arf_sub(rest, rest, part, ARF_PREC_EXACT, ARF_RND_DOWN);
    }
    const double size = std::fabs(word.high);
    if (arf_is_zero(arb_midref(x.data())) == 0 && !(size > 0x1p-900 && size < 0x1p900)) {
        return double_word::unknown();
    }
    MagValue radius;
    arf_get_mag(radius, rest);
    mag_add(radius, radius, arb_radref(x.data()));
    // mag_get_d rounds to nearest.
    word.radius = mag_is_zero(radius) != 0
                      ? 0
                      : std::nextafter(mag_get_d(radius), std::numeric_limits<double>::infinity());
    return word;
}

} // namespace edgeproof
