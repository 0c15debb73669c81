// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/double_word/logarithm.hpp"

#include "edgeproof/precision/double_word/double_word_ball.hpp"

#include <cmath>

namespace edgeproof {

// docs/double-words.md, lemma 4.
const LogarithmTable& LogarithmTable::get() {
    static const LogarithmTable table = [] {
        constexpr long bits = 256;
        LogarithmTable t{};
        for (int i = 0; i < 128; ++i) {
            const double middle = 1 + (i + 0.5) / 128;
            auto& entry = t.entries[static_cast<std::size_t>(i)];
            const long whole = std::lround(1024 / middle);
            entry.reciprocal = static_cast<double>(whole) / 1024;
            entry.logarithm = to_double_word(-log(Ball(Rational(whole, 1024), bits)));
        }
        t.ln2 = to_double_word(log(Ball(2, bits)));
        t.third = to_double_word(Ball(Rational(1, 3), bits));
        return t;
    }();
    return table;
}

} // namespace edgeproof
