// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/precision/ball/arb_values.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <cstddef>
#include <vector>

namespace edgeproof {

/// A truncated power series with balls as coefficients (Arb's arb_poly). Each coefficient of a
/// result encloses the exact one for every choice of coefficients from the balls of the operands.
class BallSeries {
public:
    /// The constant c, with `order` terms.
    BallSeries(const Ball& c, std::size_t order);
    explicit BallSeries(const std::vector<Ball>& coefficients);
    /// Returns c + z.
    static BallSeries variable(const Ball& c, std::size_t order);

    [[nodiscard]] std::size_t order() const noexcept { return order_; }
    [[nodiscard]] long bits() const noexcept { return bits_; }
    [[nodiscard]] Ball operator[](std::size_t k) const;
    [[nodiscard]] std::vector<Ball> coefficients() const;
    void set(std::size_t k, const Ball& c);
    /// The series with fewer terms, or with more terms that are exactly 0 (as a start for Newton's
    /// method).
    [[nodiscard]] BallSeries resized(std::size_t order) const;

    friend BallSeries operator+(const BallSeries& x, const BallSeries& y);
    friend BallSeries operator-(const BallSeries& x, const BallSeries& y);
    friend BallSeries operator*(const BallSeries& x, const BallSeries& y);
    friend BallSeries operator/(const BallSeries& x, const BallSeries& y);
    friend BallSeries operator*(const BallSeries& x, const Ball& c);
    friend BallSeries operator+(const BallSeries& x, const Ball& c);
    friend BallSeries operator-(const BallSeries& x);
    friend BallSeries sqrt(const BallSeries& x);
    friend BallSeries log1p(const BallSeries& x);
    friend BallSeries atan(const BallSeries& x);
    friend BallSeries pow(const BallSeries& x, const Ball& exponent);
    /// Returns the series y with x(y(z)) = z; x has no constant term.
    friend BallSeries inverse_function(const BallSeries& x);

private:
    BallSeries(std::size_t order, long bits);
    template <class F> static BallSeries apply(F f, const BallSeries& x, const BallSeries& y);
    template <class F> static BallSeries apply(F f, const BallSeries& x);
    ArbPolyValue poly_;
    std::size_t order_;
    long bits_;
};

} // namespace edgeproof
