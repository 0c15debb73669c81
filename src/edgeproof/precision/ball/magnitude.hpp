// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/precision/ball/arb_values.hpp"
#include "edgeproof/precision/ball/ball.hpp"

namespace edgeproof {

/// An upper bound of 30 bits; every operation rounds up (Arb's mag_t).
class Magnitude {
public:
    Magnitude() = default;
    /// The largest size of a number in the ball.
    explicit Magnitude(const Ball& x) { arb_get_mag(m_, x.data()); }
    explicit Magnitude(const acb_t z) { acb_get_mag(m_, z); }
    /// The smallest size, rounded down, for use as a divisor.
    [[nodiscard]] static Magnitude least(const Ball& x) {
        Magnitude r;
        arb_get_mag_lower(r.m_, x.data());
        return r;
    }
    [[nodiscard]] static Magnitude least(const acb_t z) {
        Magnitude r;
        acb_get_mag_lower(r.m_, z);
        return r;
    }

    friend Magnitude operator+(Magnitude x, const Magnitude& y) {
        mag_add(x.m_, x.m_, y.m_);
        return x;
    }
    friend Magnitude operator*(Magnitude x, const Magnitude& y) {
        mag_mul(x.m_, x.m_, y.m_);
        return x;
    }
    /// An upper bound of x/y; infinite for y = 0.
    friend Magnitude operator/(Magnitude x, const Magnitude& y) {
        mag_div(x.m_, x.m_, y.m_);
        return x;
    }
    [[nodiscard]] bool is_finite() const { return mag_is_finite(m_) != 0; }
    [[nodiscard]] bool is_zero() const { return mag_is_zero(m_) != 0; }
    friend bool operator<=(const Magnitude& x, const Magnitude& y) {
        return mag_cmp(x.m_, y.m_) <= 0;
    }
    /// The ball of all numbers of at most that size.
    [[nodiscard]] Ball ball(long bits) const {
        Ball r(0, bits);
        arb_add_error_mag(r.data(), m_);
        return r;
    }

private:
    MagValue m_;
};

} // namespace edgeproof
