// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cmath>

namespace edgeproof::contact {

/// The contact law of g' = C sgn(x) |x|^m: P = factor a^(m+1) with factor = E* C (sqrt(pi)/2)
/// Gamma(1 + m/2)/Gamma((3 + m)/2) (moore-hills EQ11; docs/mechanics.md, "Closed forms of the
/// law"), over any field that has powers.
template <class T> struct PowerLaw {
    T exponent; ///< m
    T factor;   ///< in force per unit length over length^(m+1)

    /// The normal force P per unit length for the half-width a (length).
    [[nodiscard]] T force(const T& a) const {
        using std::pow;
        return T(factor * pow(a, T(exponent + 1)));
    }
    /// dP/da, in force per unit length over length.
    [[nodiscard]] T force_rate(const T& a) const {
        using std::pow;
        return T(factor * (exponent + 1) * pow(a, exponent));
    }
    /// dP/da as a power series, for a half-width that is a power series.
    template <class S> [[nodiscard]] S force_rate_series(const S& a) const {
        return pow(a, exponent) * T(factor * (exponent + 1));
    }
    /// The half-width a (length) for the normal force P per unit length.
    [[nodiscard]] T half_width(const T& P) const {
        using std::pow;
        return T(pow(T(P / factor), T(1 / (exponent + 1))));
    }
};

} // namespace edgeproof::contact
