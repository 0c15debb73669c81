// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/print.hpp"

#include <algorithm>
#include <ostream>

namespace edgeproof::scene {

std::ostream& operator<<(std::ostream& out, const BoundedValue& x) {
    if (x.exactly) { // the ball of a rational number is wider than the number
        const auto digits = static_cast<unsigned>(std::max<std::streamsize>(out.precision(), 1));
        const PrintedValue p = printed(x, {digits});
        out << p.text << " +/- " << p.bound;
    } else {
        out << x.value;
    }
    return out << " (" << x.how() << ')';
}

} // namespace edgeproof::scene
