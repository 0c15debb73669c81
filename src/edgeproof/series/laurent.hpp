// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/arithmetic.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rational.hpp"
#include "edgeproof/series/functions.hpp"
#include "edgeproof/series/truncated.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace edgeproof::series {

/// A truncated series in w = eps^(1/2) that may begin with any power of w: printed expansions are
/// in powers of eps and of its root. The coefficient of the lowest power is not zero, unless all
/// known coefficients are.
template <class T> class Laurent {
public:
    /// The constant c, known for `order` powers of w.
    Laurent(const T& c, std::size_t order) : Laurent(0, Series<T>(c, order)) {}
    Laurent(long lowest, Series<T> s) : lowest_(lowest), s_(std::move(s)) { drop_zeros(); }
    /// w^k, known for `order` powers of w.
    static Laurent power(long k, std::size_t order) { return {k, Series<T>(T(1), order)}; }

    [[nodiscard]] long lowest() const noexcept { return lowest_; }
    /// The lowest power of w whose coefficient is not known.
    [[nodiscard]] long end() const noexcept { return lowest_ + static_cast<long>(s_.order()); }
    [[nodiscard]] const Series<T>& series() const noexcept { return s_; }
    /// The coefficient of w^k. Throws DomainError if it is not known.
    [[nodiscard]] T operator[](long k) const {
        if (k >= end()) {
            throw DomainError("an expansion is not known to the requested order");
        }
        return k < lowest_ ? T(0) : s_[static_cast<std::size_t>(k - lowest_)];
    }
    /// The same series from w^0 on. Throws DomainError if it begins with a negative power.
    [[nodiscard]] Series<T> taylor() const {
        if (lowest_ < 0) {
            throw DomainError("a function that needs a regular expansion has one that begins "
                              "with a negative power");
        }
        std::vector<T> c(static_cast<std::size_t>(lowest_), T(0));
        c.insert(c.end(), s_.coefficients().begin(), s_.coefficients().end());
        return Series<T>(std::move(c));
    }
    template <class Map> [[nodiscard]] Laurent mapped(const Map& map) const {
        std::vector<T> c;
        for (const T& x : s_.coefficients()) {
            c.push_back(map(x));
        }
        return {lowest_, Series<T>(std::move(c))};
    }

    friend Laurent operator-(const Laurent& x) { return {x.lowest_, -x.s_}; }
    friend Laurent operator+(const Laurent& x, const Laurent& y) {
        const long low = std::min(x.lowest_, y.lowest_);
        const long end = std::min(x.end(), y.end());
        std::vector<T> c;
        for (long k = low; k < end; ++k) {
            c.push_back(T(x[k] + y[k]));
        }
        if (c.empty()) {
            c.push_back(T(0));
        }
        return {low, Series<T>(std::move(c))};
    }
    friend Laurent operator-(const Laurent& x, const Laurent& y) { return x + (-y); }
    friend Laurent operator*(const Laurent& x, const Laurent& y) {
        return {x.lowest_ + y.lowest_, x.s_ * y.s_};
    }
    friend Laurent operator/(const Laurent& x, const Laurent& y) {
        y.want_leading();
        return {x.lowest_ - y.lowest_, x.s_ / y.s_};
    }
    /// x^q, with the lowest power of w taken out.
    friend Laurent pow(const Laurent& x, const Rational& q) {
        x.want_leading();
        const Rational lowest = q * x.lowest_;
        if (denominator(lowest) != 1) {
            throw DomainError("a power of the expansion is neither whole nor half");
        }
        using std::pow;
        const T exponent(q);
        return {static_cast<long>(numerator(lowest)),
                pow_with_constant<T>(x.s_, exponent, T(pow(x.s_[0], exponent)))};
    }
    friend Laurent sqrt(const Laurent& x) { return pow(x, Rational(1, 2)); }
    friend Laurent pow(const Laurent& x, const Laurent& y) { return exp(y * log(x)); }
    friend Laurent exp(const Laurent& x) { return {0, exp(x.taylor())}; }
    friend Laurent log(const Laurent& x) {
        x.want_leading();
        return {0, log(x.taylor())};
    }
    friend Laurent asin(const Laurent& x) { return {0, asin(x.taylor())}; }
    friend Laurent acos(const Laurent& x) { return {0, acos(x.taylor())}; }
    friend Laurent atan(const Laurent& x) { return {0, atan(x.taylor())}; }
    friend Laurent sin(const Laurent& x) { return {0, sin(x.taylor())}; }
    friend Laurent cos(const Laurent& x) { return {0, cos(x.taylor())}; }

private:
    void want_leading() const {
        if (s_[0] == T(0)) {
            throw DomainError("division by, or a power of, an expansion whose known terms are "
                              "all zero");
        }
    }
    void drop_zeros() {
        std::size_t k = 0;
        while (k + 1 < s_.order() && s_[k] == T(0)) {
            ++k;
        }
        if (k > 0) {
            s_ =
                Series<T>(std::vector<T>(s_.coefficients().begin() + static_cast<std::ptrdiff_t>(k),
                                         s_.coefficients().end()));
            lowest_ += static_cast<long>(k);
        }
    }

    long lowest_;
    Series<T> s_;
};

} // namespace edgeproof::series
