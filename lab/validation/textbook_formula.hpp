// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/profile/slope.hpp"
#include "edgeproof/precision/arithmetic.hpp"
#include "edgeproof/scene/input/quantity.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <optional>
#include <vector>

namespace edgeproof::validation {

/// The formulas of textbooks, evaluated directly in the arithmetic T, as a user would type them:
/// the place is x = a - u, edges are found by bisection, and cancellation is not avoided. Used only
/// for comparison with the program's own numbers, never to compute them.
///
/// Constants of the scene are rounded to T once (`Real`: to the working precision of the thread,
/// which must not change during the lifetime of the object). Integrals without a closed form use
/// Boost.Math's tanh-sinh with the integrand of one argument. Values may be infinite or NaN; a
/// missing value throws DomainError, or an exception of Boost.Math.
template <Arithmetic T> class TextbookFormula {
public:
    explicit TextbookFormula(const scene::Scene& scene);

    [[nodiscard]] const T& a() const { return a_; }
    [[nodiscard]] const T& b() const { return b_; }
    [[nodiscard]] T value(const scene::AskedValue& asked) const;

    /// p(x): sqrt(a^2 - x^2) for Hertz, arcosh(a/x) for the wedge, the integral of
    /// eqn:MossakovskiiPressure for other powers, logarithms for a piecewise linear g'.
    [[nodiscard]] T pressure(const T& x) const;
    /// P of the extent -b < x < a.
    [[nodiscard]] T force() const { return force(a_, b_); }
    /// q(x) by eqn:Shear_Adhered.
    [[nodiscard]] T shear(const T& x) const;
    /// c_0, c_1 by P' and P'' (eqn:LocalPressureI) for symmetric contacts; any other coefficient by
    /// the series of the contact law.
    [[nodiscard]] T coefficient(contact::Edge edge, std::size_t k) const;
    [[nodiscard]] T shear_coefficient(contact::Edge edge, std::size_t k) const;

private:
    struct Span {
        T lo;
        T hi;
        T at_origin;
        T rate;
    };
    [[nodiscard]] std::vector<Span> spans(const T& a, const T& b) const;
    [[nodiscard]] T imbalance(const T& a, const T& b) const;
    [[nodiscard]] T force(const T& a, const T& b) const;
    [[nodiscard]] T left_edge(const T& a) const;
    [[nodiscard]] T power_pressure(const T& x) const;
    [[nodiscard]] T linear_pressure(const T& x) const;
    [[nodiscard]] std::vector<T> series(contact::Edge edge, std::size_t terms) const;
    [[nodiscard]] T first_exit(const scene::AskedValue& asked) const;

    const scene::Scene& scene_;
    T modulus_;
    bool power_ = false;
    T m_{};
    T C_{};
    std::optional<contact::SlopeIn<T>> slope_; ///< unless `power_`
    T Q_{};
    T sigma_{};
    T a_{};
    T b_{};
};

extern template class TextbookFormula<double>;
extern template class TextbookFormula<long double>;
extern template class TextbookFormula<Float128>;
extern template class TextbookFormula<Real>;

} // namespace edgeproof::validation
