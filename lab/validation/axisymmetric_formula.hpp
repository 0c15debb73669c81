// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/arithmetic.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <vector>

namespace edgeproof::validation {

/// p, P and delta of an axisymmetric contact (docs/axisymmetric.md) as a user would program them in
/// the arithmetic T: h and h' in closed form, the radius for a given P or delta by bisection, the
/// Abel integral by Boost.Math's tanh-sinh with the place r = a - u. As TextbookFormula.
template <Arithmetic T> class AxisymmetricFormula {
public:
    explicit AxisymmetricFormula(const scene::Scene& scene);
    [[nodiscard]] const T& a() const { return a_; }
    [[nodiscard]] T value(const scene::AskedValue& asked) const;

private:
    struct Bend {
        T v;
        T jump; ///< of g'
        T rate; ///< change of g''
    };
    [[nodiscard]] T approach(const T& s) const;
    [[nodiscard]] T force(const T& a) const;
    [[nodiscard]] T pressure(const T& r) const;
    template <class F> [[nodiscard]] T over_bends(const T& s, const F& f) const;

    T modulus_;
    bool power_ = false;
    T m_{};
    T kappa_{}; ///< h = kappa s^(m + 1)
    std::vector<Bend> bends_;
    T a_{};
};

extern template class AxisymmetricFormula<double>;
extern template class AxisymmetricFormula<long double>;
extern template class AxisymmetricFormula<Float128>;
extern template class AxisymmetricFormula<Real>;

} // namespace edgeproof::validation
