// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/rounding/print.hpp"

#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>
#include <ostream>

namespace edgeproof {

std::ostream& operator<<(std::ostream& out, const Ball& x) {
    constexpr unsigned digits_of_ends = 2;
    constexpr long bits_beyond = 16;
    if (!x.is_finite()) {
        return out << "nan";
    }
    const auto digits = static_cast<unsigned>(std::max<std::streamsize>(out.precision(), 1));
    const Rounded r = round_ball(x, digits);
    if (r.text.empty() || r.digits == 0) {
        if (contains_zero(x) && x.is_exact()) {
            return out << "0 +/- 0";
        }
        return out << round_ball(x, digits_of_ends, Rounding::enclosure).text;
    }
    const Ball error = abs(Ball(x - r.lower.enclosure(x.bits() + bits_beyond)));
    return out << r.text << " +/- " << bound_text(error.upper());
}

} // namespace edgeproof
