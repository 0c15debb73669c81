// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/elementary/ratio_series.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <future>
#include <initializer_list>
#include <string>
#include <vector>

namespace {

/// 2F1(a, b; c; x) for fractions with the denominator `under`.
struct Gauss {
    long under;
    long a;
    long b;
    long c;
    [[nodiscard]] RatioSeries series() const { return {{{{under, a, c}, {under, b, under}}}}; }
    [[nodiscard]] Ball value(const Ball& x) const {
        const auto of = [&](long n) { return Ball(Rational(n, under), x.bits()); };
        return hypergeometric_2f1(of(a), of(b), of(c), x);
    }
};

Ball power_of_ten(long k, long bits) { return pow_int(Ball(10, bits), k); }

} // namespace

TEST_CASE("a series of words is Gauss's function, by Arb, and narrow") {
    for (const Gauss& f : {Gauss{2, 1, 3, 3}, Gauss{16, 8, 37, 24}, Gauss{2, 1, 83, 3},
                           Gauss{1000, 500, 1999, 1500}, Gauss{3, 1, 2, 8}}) {
        CAPTURE(f.under);
        CAPTURE(f.b);
        for (const long bits : {64L, 232L, 278L, 1100L, 3500L}) {
            for (const std::string at :
                 {"1e-150", "1e-40", "1e-9", "0.01", "0.2", "1/2", "0.75", "0.97"}) {
                CAPTURE(bits);
                CAPTURE(at);
                const Ball x = at == "1e-150"  ? power_of_ten(-150, bits)
                               : at == "1e-40" ? power_of_ten(-40, bits)
                               : at == "1e-9"  ? power_of_ten(-9, bits)
                               : at == "1/2"   ? Ball(Rational(1, 2), bits)
                                               : Ball(Real(at), bits);
                const auto sum = f.series().sum(x, bits);
                REQUIRE(sum);
                CHECK(overlaps(*sum, f.value(x.with_bits(bits + 200))));
                CHECK(sum->relative_accuracy_bits() > bits - 16);
            }
        }
    }
}

TEST_CASE("the bound of a series holds to its last bit, at every number of bits") {
    // The sum of x^k/(k + 1) is -ln(1 - x)/x.
    const RatioSeries logarithm{{{{1, 1, 2}, {1, 1, 1}}}};
    for (long bits = 40; bits < 700; bits += 3) {
        for (const int n : {3, 50, 77, 95}) {
            const Ball x(Real(n) / 128, bits);
            const Ball wide = x.with_bits(bits + 300);
            const auto sum = logarithm.sum(x, bits);
            REQUIRE(sum);
            CAPTURE(bits);
            CAPTURE(n);
            CHECK(contains(*sum, Ball(-log1p(-wide) / wide).midpoint()));
            CHECK(sum->relative_accuracy_bits() >= bits - 3);
        }
    }
}

TEST_CASE("neighbours share what a thread keeps, and have their own sums") {
    // The sums cross several steps of the values stored for neighbours, with alternating series and
    // bits; a thread without stored values must give the same.
    const auto sums = [](int first, int last) {
        std::vector<Ball> all;
        for (int k = first; k < last; ++k) {
            for (const Gauss& f : {Gauss{2, 1, 3, 3}, Gauss{2, 1, 5, 3}, Gauss{16, 8, 37, 24}}) {
                for (const long bits : {100L, 232L}) {
                    all.push_back(f.series().sum(Ball(Real(k) / 4096, bits), bits).value());
                }
            }
        }
        return all;
    };
    constexpr int begin = 1900; // below 1/2, the end of an octave
    constexpr int end = 2200;
    const std::vector<Ball> together = sums(begin, end);
    std::size_t i = 0;
    for (int k = begin; k < end; ++k) {
        CAPTURE(k);
        const Ball x(Real(k) / 4096, 400);
        for (const Gauss& f : {Gauss{2, 1, 3, 3}, Gauss{2, 1, 5, 3}, Gauss{16, 8, 37, 24}}) {
            const Ball exact = f.value(x);
            for (const long bits : {100L, 232L}) {
                const Ball& sum = together[i++];
                CHECK(contains(sum, exact.midpoint()));
                CHECK(sum.relative_accuracy_bits() >= bits - 8);
            }
        }
        if (k % 50 == 0) {
            const auto alone = std::async(std::launch::async, sums, k, k + 1).get();
            for (std::size_t j = 0; j < alone.size(); ++j) {
                CHECK(alone[j].lower() == together[i - alone.size() + j].lower());
                CHECK(alone[j].upper() == together[i - alone.size() + j].upper());
            }
        }
    }
}

TEST_CASE("with more series than a thread keeps, each has its own sum") {
    const Ball x(Real(1) / 16, 120);
    for (int round = 0; round < 2; ++round) {
        for (long b = 3; b < 803; b += 2) {
            CAPTURE(b);
            const Gauss f{2, 1, b, 3};
            const auto sum = f.series().sum(x, 120);
            REQUIRE(sum);
            CHECK(contains(*sum, f.value(x.with_bits(300)).midpoint()));
        }
    }
}

TEST_CASE("the series at a ball encloses the values at all its numbers") {
    const Gauss f{2, 1, 5, 3};
    for (const double at : {0.001, 0.3, 0.9, 0.99}) {
        for (const int exponent : {-300, -60, -25}) {
            CAPTURE(at);
            CAPTURE(exponent);
            const PrecisionScope scope(200);
            const Real r = ldexp(Real(at), exponent);
            const auto sum = f.series().sum(Ball::around(Real(at), r, 300), 300);
            REQUIRE(sum);
            for (const Real& x : {Real(at), Real(at + r), Real(at - r)}) {
                CHECK(contains(*sum, f.value(Ball(x, 500))));
            }
        }
    }
}

TEST_CASE("a series that cannot be summed in words is left to other methods") {
    const Gauss f{2, 1, 3, 3};
    const auto none = [](const Gauss& of, const Ball& x) { return !of.series().sum(x, 200); };
    CHECK(none(f, Ball(Rational(9995, 10000), 200)));
    CHECK(none(f, Ball(0, 200)));
    CHECK(none(f, Ball(2, 200)));
    CHECK(none(f, Ball::around(Real(1) / 2, Real(1) / 1000, 200)));
    CHECK(none(Gauss{1L << 40, 1L << 39, 1L << 42, 3L << 39}, Ball(Rational(1, 2), 200)));
    CHECK(none(Gauss{1, 1, 1000000000, 2}, Ball(Rational(1, 2), 200))); // 1e300 and more
}
