// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/point.hpp"
#include "edgeproof/precision/rational.hpp"
#include "edgeproof/series/functions.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

/// Shear under full stick: elastically similar half-planes (so that normal and shear problems are
/// uncoupled), the normal load applied first and held, then a shear force Q per unit length and a
/// differential bulk tension sigma_0, with no slip anywhere (moore-hills.tex, eqn:Shear_Adhered).
///
/// Signs. q and Q are the traction on body A, positive towards +x, exerted by body B; sigma_0 is
/// the bulk tension of B less that of A. A tension in B draws A's surface outwards: q > 0 at the
/// right edge, q < 0 at the left. (On B everything changes sign: q, Q, and the tension's role.)
///
/// Where the factor 1/8 comes from. In plane strain a traction q on a half-plane strains its
/// surface by du/dx = (2 (1-nu^2)/(pi E)) PV of q(s)/(s - x) ds, and a bulk tension by
/// (1-nu^2)/E sigma. A is strained by q, B by -q and by sigma_0; without slip both strain alike:
///     (2/(pi E*)) PV of q(s)/(s - x) ds = (1-nu^2)/E sigma_0,   1/E* = 2 (1-nu^2)/E,
/// so PV of q(s)/(s - x) ds = pi sigma_0/4, whatever E* is. With w = sqrt((a-s)(s+b)), PV of
/// 1/(w (s-x)) = 0 and PV of s/(w (s-x)) = pi, so q = (sigma_0/8) (2x + b - a)/w carries no force
/// and answers for sigma_0; Q/(pi w) answers for Q. Nothing here depends on the profile but a, b.
namespace edgeproof::contact {

template <class T> struct ShearLoad {
    T Q;            ///< force per unit length
    T bulk_tension; ///< sigma_0, a stress
};

/// q(x), a stress; by the distances from both edges, so that near an edge nothing cancels but Q
/// against sigma_0. Digits: those of T, less what that costs.
template <Arithmetic T>
[[nodiscard]] T full_stick_traction(const Point<T>& at, const ShearLoad<T>& load) {
    using std::sqrt;
    return T((load.Q / pi<T>() + load.bulk_tension * (at.left - at.right) / T(8)) /
             sqrt(T(at.right * at.left)));
}

/// sqrt(a + b) times the coefficients of u^(-1/2), u^(1/2), u^(3/2), ... of q at an edge (K_II,
/// L_II, M_II, ...), over any field T, symbolic ones included: `Q_over_pi` = Q/pi, `length` =
/// a + b. With u = D z the traction is [Q/pi +- sigma_0 D (1 - 2z)/8] (1-z)^(-1/2)/sqrt(D u).
template <class T>
[[nodiscard]] std::vector<T> full_stick_brackets(const T& Q_over_pi, const T& bulk_tension,
                                                 const T& length, Edge edge, std::size_t terms) {
    if (terms == 0) {
        return {};
    }
    const T side(edge == Edge::right ? 1 : -1);
    series::Series<T> load(Q_over_pi + side * bulk_tension * length / T(8), terms);
    series::Series<T> other(T(1), terms); // the distance from the other edge over D
    if (terms > 1) {
        load[1] = -(side * bulk_tension * length / T(4));
        other[1] = T(-1);
    }
    const series::Series<T> z = load * pow_with_constant<T>(other, T(T(-1) / T(2)), T(1));
    std::vector<T> in_u;
    T power(1);
    for (std::size_t k = 0; k < terms; ++k) {
        in_u.push_back(z[k] / power);
        power *= length;
    }
    return in_u;
}

/// K_II, L_II, M_II, ...: q = sum of s_k u^(k-1/2) at an edge; s_k has the units of
/// stress/length^(k-1/2).
template <Arithmetic T>
[[nodiscard]] std::vector<T> full_stick_expansion(const T& length, const ShearLoad<T>& load,
                                                  Edge edge, std::size_t terms) {
    using std::sqrt;
    auto s = full_stick_brackets<T>(T(load.Q / pi<T>()), load.bulk_tension, length, edge, terms);
    const T root = sqrt(length);
    for (T& x : s) {
        x /= root;
    }
    return s;
}

/// r_k such that the k-th coefficient vanishes at the right edge for sigma_0 (a + b)/Q = (8/pi)
/// r_k, and at the left edge for the negative of that. From the series itself, exactly: -1, 1/3,
/// 3/5, 5/7, ...
[[nodiscard]] Rational vanishing_ratio(std::size_t k);

/// At which edge coefficient k can vanish: k = 0 where Q and sigma_0 act against each other, every
/// higher one where they add. `same_sign`: Q and sigma_0 have the same sign.
[[nodiscard]] constexpr Edge vanishing_edge(std::size_t k, bool same_sign) {
    return (k == 0) == same_sign ? Edge::left : Edge::right;
}

/// The singular tractions at both edges have the same sign: |sigma_0 (a + b)/Q| < 8/pi, for either
/// sign of Q and of sigma_0. (At equality one of them vanishes; decided in T as it rounds.)
template <Arithmetic T>
[[nodiscard]] bool same_sign_at_both_edges(const T& length, const ShearLoad<T>& load) {
    using std::abs;
    return abs(T(load.bulk_tension * length)) * pi<T>() < T(8) * abs(load.Q);
}

} // namespace edgeproof::contact
