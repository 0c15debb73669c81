// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/rounding/print.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <doctest/doctest.h>

#include <iomanip>
#include <sstream>

using namespace edgeproof;

namespace {

std::string streamed_ball(const Ball& x, int digits) {
    std::ostringstream out;
    out << std::setprecision(digits) << x;
    return out.str();
}

} // namespace

// pi = 3.14159265358979323846..., so that |3.14159 - pi| = 2.6535...e-6 and |3.1415926536 - pi| =
// 1.0206...e-11.
TEST_CASE("a ball is printed with the digits of the stream and the bound of their error") {
    std::ostringstream out;
    out << Ball::pi(200);
    CHECK(out.str() == "3.14159 +/- 2.7e-06");
    CHECK(streamed_ball(Ball::pi(200), 11) == "3.1415926536 +/- 1.1e-11");
    // The radius of such a ball is at most 2^-100 = 7.9e-31.
    CHECK(streamed_ball(Ball(Rational(3, 10), 100), 4).substr(0, 11) == "0.3000 +/- ");
    CHECK(streamed_ball(Ball(Rational(3, 10), 100), 4).substr(14) == "e-31");
    CHECK(streamed_ball(-Ball(2, 64), 3) == "-2.00 +/- 0");
    CHECK(streamed_ball(Ball(0, 64), 3) == "0 +/- 0");
}

TEST_CASE("a wide ball has fewer digits, or both ends") {
    // Both ends, 1.249023... and 1.250976..., round to 1.25, but not to the same four digits.
    const Ball wide = Ball::around(Real(1.25), Real(0x1p-10), 64);
    CHECK(streamed_ball(wide, 10) == "1.25 +/- 0.00098");
    CHECK(streamed_ball(Ball::around(Real(0), Real(0.25), 64), 10).substr(0, 4) == "[-0.");
    CHECK(streamed_ball(1 / Ball(0, 64), 10) == "nan");
}
