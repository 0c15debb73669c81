// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/algebra/form.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/real.hpp"
#include "edgeproof/series/truncated.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::algebra {

/// A truncated series in w = eps^(1/2) that may begin with any power of w: printed expansions are
/// in powers of eps and of its root. The coefficient of the lowest power is not zero, unless all
/// known coefficients are.
class Laurent {
public:
    using Series = edgeproof::series::Series<Form>;
    /// The constant c, known for `order` powers of w.
    Laurent(const Form& c, std::size_t order) : Laurent(0, Series(c, order)) {}
    Laurent(long lowest, Series s) : lowest_(lowest), s_(std::move(s)) { drop_zeros(); }
    /// w^k, known for `order` powers of w.
    static Laurent power(long k, std::size_t order) { return {k, Series(Form(1), order)}; }

    [[nodiscard]] long lowest() const noexcept { return lowest_; }
    /// The lowest power of w whose coefficient is not known.
    [[nodiscard]] long end() const noexcept { return lowest_ + static_cast<long>(s_.order()); }
    [[nodiscard]] const Series& series() const noexcept { return s_; }
    /// The coefficient of w^k. Throws DomainError if it is not known.
    [[nodiscard]] Form operator[](long k) const {
        if (k >= end()) {
            throw DomainError("an expansion is not known to the requested order");
        }
        return k < lowest_ ? Form(0) : s_[static_cast<std::size_t>(k - lowest_)];
    }
    /// The same series from w^0 on. Throws DomainError if it begins with a negative power.
    [[nodiscard]] Series taylor() const {
        if (lowest_ < 0) {
            throw DomainError("a function that needs a regular expansion has one that begins "
                              "with a negative power");
        }
        std::vector<Form> c(static_cast<std::size_t>(lowest_), Form(0));
        c.insert(c.end(), s_.coefficients().begin(), s_.coefficients().end());
        return Series(std::move(c));
    }
    template <class Map> [[nodiscard]] Laurent mapped(const Map& map) const {
        std::vector<Form> c;
        for (const Form& x : s_.coefficients()) {
            c.push_back(map(x));
        }
        return {lowest_, Series(std::move(c))};
    }

    friend Laurent operator-(const Laurent& x) { return {x.lowest_, -x.s_}; }
    friend Laurent operator+(const Laurent& x, const Laurent& y) {
        const long low = std::min(x.lowest_, y.lowest_);
        const long end = std::min(x.end(), y.end());
        std::vector<Form> c;
        for (long k = low; k < end; ++k) {
            c.push_back(Form(x[k] + y[k]));
        }
        if (c.empty()) {
            c.push_back(Form(0));
        }
        return {low, Series(std::move(c))};
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
        const Form exponent(q);
        return {static_cast<long>(numerator(lowest)),
                pow_with_constant<Form>(x.s_, exponent, Form(pow(x.s_[0], exponent)))};
    }
    friend Laurent sqrt(const Laurent& x) { return pow(x, Rational(1, 2)); }
    friend Laurent pow(const Laurent& x, const Laurent& y) {
        const Laurent exponent = y * call(Builtin::log, {&x, 1});
        return call(Builtin::exp, {&exponent, 1});
    }

    /// c(0) + c(1) y + ... + c(n-1) y^(n-1), n > 0, where c is known for `order` powers of w.
    template <class C>
    static Laurent polynomial(const Laurent& y, unsigned n, std::size_t order, const C& c) {
        Laurent sum(c(n - 1), order);
        for (unsigned k = n - 1; k-- > 0;) {
            sum = sum * y + Laurent(c(k), order);
        }
        return sum;
    }
    /// A built-in function of one argument, by Taylor's formula with the derivatives of f.
    static Laurent call(Builtin f, std::span<const Laurent> x) {
        if (f == Builtin::sqrt) {
            return sqrt(x[0]);
        }
        const Series s = x[0].taylor();
        if (x.size() != 1 || (f == Builtin::log && s[0] == Form(0))) {
            throw DomainError("'" + std::string(name_of(f)) + "' has no expansion");
        }
        const Laurent step(0, s - s[0]);
        const Form variable = Form::name("t", false);
        Form derivative = Form::call(f, {&variable, 1});
        const auto last = static_cast<long>(s.order() - 1) / std::max(step.lowest_, 1L);
        const auto n = step.s_[0] == Form(0) ? 1 : static_cast<unsigned>(last + 1);
        std::vector<Form> c{Form::call(f, {&s[0], 1})};
        Form factorial(1);
        for (unsigned k = 1; k < n; ++k) {
            derivative = derivative.derivative("t");
            factorial *= Form(static_cast<int>(k));
            c.push_back(derivative(s[0]) / factorial);
        }
        return polynomial(step, n, s.order(), [&](unsigned k) { return c[k]; });
    }

private:
    void want_leading() const {
        if (s_[0] == Form(0)) {
            throw DomainError("division by, or a power of, an expansion whose known terms are "
                              "all zero");
        }
    }
    void drop_zeros() {
        std::size_t k = 0;
        while (k + 1 < s_.order() && s_[k] == Form(0)) {
            ++k;
        }
        if (k > 0) {
            s_ =
                Series(std::vector<Form>(s_.coefficients().begin() + static_cast<std::ptrdiff_t>(k),
                                         s_.coefficients().end()));
            lowest_ += static_cast<long>(k);
        }
    }

    long lowest_;
    Series s_;
};

} // namespace edgeproof::algebra
