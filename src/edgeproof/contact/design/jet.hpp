// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace edgeproof::contact {

/// A function of u and one parameter with its first and second derivatives, each a ball that
/// encloses it for every choice of the arguments from their balls, as interval Newton and the mean
/// value form need them (moore-kearfott-cloud2009). Variable 0 is u, 1 is the parameter.
struct Jet {
    static constexpr std::size_t variables = 2;
    Ball v;
    std::array<Ball, variables> g;
    std::array<Ball, 3> h; ///< (0,0) (0,1) (1,1)

    Jet() = default;
    explicit Jet(Ball constant) : v(std::move(constant)) {}
    [[nodiscard]] static Jet variable(const Ball& x, std::size_t which);
    [[nodiscard]] static constexpr std::size_t second(std::size_t i, std::size_t j) {
        return i <= j ? i * variables - i * (i + 1) / 2 + j : second(j, i);
    }

    Jet& operator+=(const Jet& o);
    Jet& operator-=(const Jet& o);
    Jet& operator*=(const Jet& o);
    Jet& operator/=(const Jet& o);
    Jet& operator*=(long k);
    Jet& operator/=(long k);
    Jet& operator+=(long k);
    friend Jet operator-(Jet x) { return std::move(x *= -1); }
    friend Jet operator+(Jet x, const Jet& y) { return std::move(x += y); }
    friend Jet operator-(Jet x, const Jet& y) { return std::move(x -= y); }
    friend Jet operator*(Jet x, const Jet& y) { return std::move(x *= y); }
    friend Jet operator/(Jet x, const Jet& y) { return std::move(x /= y); }
    friend Jet operator*(Jet x, long k) { return std::move(x *= k); }
    friend Jet operator/(Jet x, long k) { return std::move(x /= k); }
    friend Jet operator+(Jet x, long k) { return std::move(x += k); }
    friend Jet operator-(Jet x, long k) { return std::move(x += -k); }
    friend Jet operator-(long k, Jet x) { return std::move((x *= -1) += k); }

private:
    /// Applies f to the value and to each derivative of both jets.
    template <class F> Jet& with_each(const Jet& o, const F& f) {
        f(v, o.v);
        for (std::size_t i = 0; i < g.size(); ++i) {
            f(g[i], o.g[i]);
        }
        for (std::size_t i = 0; i < h.size(); ++i) {
            f(h[i], o.h[i]);
        }
        return *this;
    }
};

/// f(x) for a function of one variable with the derivatives f0, f1, f2 at x.v.
[[nodiscard]] Jet composed(const Jet& x, const Ball& f0, const Ball& f1, const Ball& f2);
[[nodiscard]] Jet sqrt(const Jet& x);
[[nodiscard]] Jet exp(const Jet& x);
[[nodiscard]] Jet log(const Jet& x);
[[nodiscard]] Jet log1p(const Jet& x);
[[nodiscard]] Jet sin(const Jet& x);
[[nodiscard]] Jet cos(const Jet& x);
[[nodiscard]] Jet atan(const Jet& x);

/// Gives templates over Ball and Jet one name for the value.
[[nodiscard]] inline const Ball& value_in(const Ball& x) { return x; }
[[nodiscard]] inline const Ball& value_in(const Jet& x) { return x.v; }

/// Jets as a field of the formulas of contact/law. The root of a number that is not certainly
/// positive has no finite derivatives.
template <> struct Field<Jet> {
    static Jet number(int k, const Jet& like) { return Jet(Field<Ball>::number(k, like.v)); }
    static Jet pi(const Jet& like) { return Jet(Ball::pi(like.v.bits())); }
    static Jet over(const Jet& x, int k) { return x / k; }
    static bool vanishes(const Jet& x) {
        const auto is_zero = [](const Ball& d) { return Field<Ball>::vanishes(d); };
        return is_zero(x.v) && std::ranges::all_of(x.g, is_zero) &&
               std::ranges::all_of(x.h, is_zero);
    }
    static Jet times(const Jet& weight, const Jet& x) { return weight * x; }
    static Jet root(const Jet& x) { return sqrt(x); }
    static Jet angle(const Jet& near, const Jet& far) { return atan(sqrt(near / far)) * 2; }
    template <class Mark> static Jet other_angle(const Mark& m) { return pi(m.h) - m.h; }
};

} // namespace edgeproof::contact
