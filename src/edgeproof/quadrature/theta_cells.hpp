// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/acb_include.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <cstddef>
#include <vector>

namespace edgeproof::quadrature {

/// A number that is not exceeded: 30 bits, every operation rounded up (Arb's mag_t).
class Magnitude {
public:
    Magnitude() { mag_init(m_); }
    /// The largest size of a number in the ball.
    explicit Magnitude(const Ball& x) : Magnitude() { arb_get_mag(m_, x.data()); }
    explicit Magnitude(const acb_t z) : Magnitude() { acb_get_mag(m_, z); }
    /// The smallest, rounded down: for what others are divided by.
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
    Magnitude(const Magnitude& o) { mag_init_set(m_, o.m_); }
    Magnitude& operator=(const Magnitude& o) {
        mag_set(m_, o.m_);
        return *this;
    }
    ~Magnitude() { mag_clear(m_); }

    friend Magnitude operator+(Magnitude x, const Magnitude& y) {
        mag_add(x.m_, x.m_, y.m_);
        return x;
    }
    friend Magnitude operator*(Magnitude x, const Magnitude& y) {
        mag_mul(x.m_, x.m_, y.m_);
        return x;
    }
    /// At most x/y for the y that is given: infinite for 0.
    friend Magnitude operator/(Magnitude x, const Magnitude& y) {
        mag_div(x.m_, x.m_, y.m_);
        return x;
    }
    [[nodiscard]] bool is_finite() const { return mag_is_finite(m_) != 0; }
    [[nodiscard]] bool is_zero() const { return mag_is_zero(m_) != 0; }
    friend bool operator<=(const Magnitude& x, const Magnitude& y) {
        return mag_cmp(x.m_, y.m_) <= 0;
    }
    /// All numbers of at most that size.
    [[nodiscard]] Ball ball(long bits) const {
        Ball r(0, bits);
        arb_add_error_mag(r.data(), m_);
        return r;
    }

private:
    mag_t m_;
};

/// A piece of g' as far as the contact reaches: s = c + d cos theta, theta from `from` to `to`.
struct ThetaSpan {
    std::size_t piece;
    Ball from;
    Ball to;
};

/// Functions of s that are integrated over theta together.
class ThetaIntegrand {
public:
    virtual ~ThetaIntegrand() = default;
    [[nodiscard]] virtual std::size_t count() const = 0;
    /// What none of them exceeds on a box of s, and that they are holomorphic on it where it is not
    /// real; false where that is not shown.
    virtual bool bound(std::size_t piece, const acb_t s, std::vector<Magnitude>& most) const = 0;
    virtual void value(std::size_t piece, const Ball& s, std::vector<Ball>& f) const = 0;
};

/// How far an integral is driven: |error_k| scale_k <= tolerance on every cell.
struct ThetaGoal {
    Magnitude tolerance;
    std::vector<Magnitude> scale;
    std::size_t nodes = 32;
    int depth = 60; ///< halvings of a span, at most
};

/// The integrals over the spans, enclosed: by the Gauss-Legendre rule on cells that are halved
/// until its error, bounded on an ellipse about the cell (bernstein.hpp), is small; a cell too
/// small to matter counts by its length. Not finite where the depth does not suffice.
[[nodiscard]] std::vector<Ball> integrate_cells(const ThetaIntegrand& f,
                                                const std::vector<ThetaSpan>& spans,
                                                const Ball& centre, const Ball& half_length,
                                                const ThetaGoal& goal, long bits);

} // namespace edgeproof::quadrature
