// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/real.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <cfloat>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace edgeproof {
namespace {

// Returns "3.333...e-01" with `digits` digits in all (Boost counts those after the point).
std::string scientific(const Real& x, unsigned digits) {
    return x.str(digits - 1, std::ios_base::scientific);
}

std::string third_at(unsigned digits, unsigned printed) {
    const PrecisionScope scope(digits);
    return scientific(from_rational<Real>(Rational(1, 3)), printed);
}

std::string threes(std::size_t count) { return "3." + std::string(count - 1, '3') + "e-01"; }

} // namespace

TEST_CASE("scopes nest and give the former precision back, also after an exception") {
    const unsigned outside = working_digits();
    try {
        const PrecisionScope fifty(50);
        CHECK(Real(1).precision() == 50);
        {
            const PrecisionScope hundred(100);
            CHECK(working_digits() == 100);
            CHECK(Real(1).precision() == 100);
        }
        CHECK(working_digits() == 50);
        const PrecisionScope hundred(100);
        throw std::runtime_error("out of the scopes");
    } catch (const std::runtime_error&) {
        CHECK(working_digits() == outside);
    }
}

TEST_CASE("a precision outside the range is refused and changes nothing") {
    const PrecisionScope fifty(50);
    CHECK_THROWS_AS(PrecisionScope(0), DomainError);
    CHECK_THROWS_AS(PrecisionScope(1), DomainError);
    CHECK_THROWS_AS(PrecisionScope(1'000'000'000), DomainError);
    CHECK(working_digits() == 50);
}

TEST_CASE("one third at 50 and at 100 digits, side by side") {
    CHECK(third_at(50, 50) == threes(50));
    CHECK(third_at(100, 100) == threes(100));
    // The precision limits the digits: with a precision of 100, this would find threes.
    CHECK(third_at(50, 100) != threes(100));
}

TEST_CASE("a rational, or a number on request, becomes the nearest at the working precision") {
    const PrecisionScope hundred(100);
    const Real finer = from_rational<Real>(Rational(1, 3));
    const PrecisionScope fifty(50);
    const Real rounded = at_working_precision(finer);
    CHECK(rounded.precision() == 50);
    CHECK(rounded == Real(1) / 3);
    CHECK(from_rational<Real>(Rational(1, 3)) == rounded);
    CHECK(rounded != finer);
}

TEST_CASE("pi and the spacing at 1 follow the working precision") {
    const PrecisionScope sixty(60);
    CHECK(pi<Real>().str(60, std::ios_base::fmtflags{}) ==
          "3.14159265358979323846264338327950288419716939937510582097494");
    CHECK(Real(1) + unit_roundoff<Real>() > 1);
    CHECK(Real(1) + unit_roundoff<Real>() / 4 == 1);
    const Real coarse = unit_roundoff<Real>();
    const PrecisionScope hundred(100);
    CHECK(unit_roundoff<Real>() < coarse * Real("1e-38"));
}

} // namespace edgeproof

TEST_CASE("a double is taken exactly, and one that is not finite is refused") {
    CHECK(exact_rational(0.1) * 36028797018963968 == 3602879701896397); // 0.1 = n/2^55
    CHECK(exact_rational(-0x1p-1074) < 0);
    for (const double x : {std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity(), std::nan("")}) {
        CHECK_THROWS_AS((void)exact_rational(x), DomainError);
    }
}
