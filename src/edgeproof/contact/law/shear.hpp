// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/point.hpp"
#include "edgeproof/precision/rational.hpp"

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
/// against sigma_0. Digits: those of T, less what that costs; a ball is an enclosure, not finite
/// where the point may be an edge.
template <class T>
[[nodiscard]] T full_stick_traction(const T& right, const T& left, const ShearLoad<T>& load) {
    using std::sqrt;
    return T((load.Q / Field<T>::pi(right) + load.bulk_tension * (left - right) / 8) /
             sqrt(T(right * left)));
}
template <class T>
[[nodiscard]] T full_stick_traction(const Point<T>& at, const ShearLoad<T>& load) {
    return full_stick_traction(at.right, at.left, load);
}
/// At the distance u from an edge of a contact of `length` a + b.
template <class T>
[[nodiscard]] T full_stick_traction(const T& length, const ShearLoad<T>& load, Edge edge,
                                    const T& u) {
    const T other = length - u;
    return edge == Edge::right ? full_stick_traction(u, other, load)
                               : full_stick_traction(other, u, load);
}

/// The coefficients of u^(-1/2), u^(1/2), u^(3/2), ... of q at an edge (K_II, L_II, M_II, ...),
/// over any field, with `scale` in place of the sqrt(a + b) in them. `Q_over_pi` = Q/pi, `length` =
/// D = a + b: with u = D z the traction is [Q/pi +- sigma_0 D (1 - 2z)/8] (1 - z)^(-1/2)/sqrt(D u),
/// and (1 - z)^(-1/2) is the sum of beta_k z^k.
template <class T>
[[nodiscard]] std::vector<T> full_stick_terms(const T& Q_over_pi, const T& bulk_tension,
                                              const T& length, Edge edge, std::size_t terms,
                                              T scale) {
    // The tension draws the right edge outwards.
    const T by_tension = (edge == Edge::right ? bulk_tension : T(-bulk_tension)) * length;
    const T lead = Q_over_pi + by_tension / 8;
    T beta = Field<T>::number(1, length);
    T beta_before = Field<T>::number(0, length);
    std::vector<T> s;
    for (int next = 1; s.size() < terms; ++next) {
        s.push_back(T((lead * beta - by_tension / 4 * beta_before) / scale));
        beta_before = beta;
        beta = beta * (2 * next - 1) / (2 * next);
        scale = scale * length;
    }
    return s;
}

/// sqrt(a + b) times K_II, L_II, M_II, ...: no root is left to take.
template <class T>
[[nodiscard]] std::vector<T> full_stick_brackets(const T& Q_over_pi, const T& bulk_tension,
                                                 const T& length, Edge edge, std::size_t terms) {
    return full_stick_terms(Q_over_pi, bulk_tension, length, edge, terms,
                            Field<T>::number(1, length));
}

/// K_II, L_II, M_II, ...: q = sum of s_k u^(k-1/2) at an edge; s_k has the units of
/// stress/length^(k-1/2).
template <class T>
[[nodiscard]] std::vector<T> full_stick_expansion(const T& length, const ShearLoad<T>& load,
                                                  Edge edge, std::size_t terms) {
    using std::sqrt;
    return full_stick_terms(T(load.Q / Field<T>::pi(length)), load.bulk_tension, length, edge,
                            terms, T(sqrt(length)));
}

/// The singular tractions at both edges have the same sign: |sigma_0 (a + b)/Q| < 8/pi, for either
/// sign of Q and of sigma_0. (At equality one of them vanishes; decided in T as it rounds.)
template <Arithmetic T>
[[nodiscard]] bool same_sign_at_both_edges(const T& length, const ShearLoad<T>& load) {
    using std::abs;
    return abs(T(load.bulk_tension * length)) * pi<T>() < T(8) * abs(load.Q);
}

} // namespace edgeproof::contact
