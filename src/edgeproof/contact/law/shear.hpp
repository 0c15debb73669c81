// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/law/kernels.hpp"
#include "edgeproof/formula/exact/exact.hpp"

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

/// The shear traction under full stick (moore-hills EQ34; derived in docs/partial-slip.md):
/// elastically similar half-planes, so that normal and shear problems are uncoupled; the normal
/// load is applied first and held, then a shear force Q per unit length and a differential bulk
/// tension sigma_0; no slip anywhere.
///
/// Signs: q and Q are the traction on body A, exerted by body B, positive towards +x; sigma_0 is
/// the bulk tension of B less that of A. A tension in B pulls the surface of A outwards: q > 0 at
/// the right edge, q < 0 at the left edge. For the traction on B, all signs are opposite.
///
/// With w = sqrt((a-s)(s+b)), PV of q(s)/(s - x) ds = pi sigma_0/4 for every E*. The part
/// (sigma_0/8) (2x + b - a)/w satisfies this and carries no force; the part Q/(pi w) carries the
/// force Q. Both depend on the profile only through a and b.
namespace edgeproof::contact {

/// The order in which the normal load and the shear load are applied.
enum class LoadingPath {
    normal_first, ///< P is held, then Q and sigma_0 are applied (shear.hpp)
    together      ///< P and Q grow in proportion, without bulk tension: q = (Q/P) p
};

/// The shear load of a contact as exact numbers; signs as in shear.hpp.
struct ShearSpec {
    Exact Q;            ///< force per unit length
    Exact bulk_tension; ///< sigma_0, a stress
    LoadingPath path = LoadingPath::normal_first;
    /// The coefficient of friction; without one nothing slips.
    std::optional<Exact> friction = {};
    /// The bulk stress of body A; that of body B is bulk_A + bulk_tension. Only stresses depend on
    /// it.
    Exact bulk_A = {};
    /// q/p, f or -f, where the whole contact slides; Q and `friction` are then not given.
    std::optional<Exact> sliding = {};

    /// Q under the force `P`, and q/p where q is proportional to p; `number` gives an Exact in
    /// another type of numbers.
    template <class Number, class Force>
    [[nodiscard]] auto force(const Number& number, const Force& P) const {
        return sliding ? number(*sliding) * P() : number(Q);
    }
    template <class Number, class Force>
    [[nodiscard]] auto ratio(const Number& number, const Force& P) const {
        return sliding ? number(*sliding) : number(Q) / P();
    }
};

template <class T> struct ShearLoad {
    T Q;            ///< force per unit length
    T bulk_tension; ///< sigma_0, a stress
};

/// q(x), a stress (moore-hills EQ34), from the distances a - x and x + b from both edges (lengths),
/// so that near an edge only Q and sigma_0 can cancel. The digits are those of T less those that
/// cancel so. In balls the result is an enclosure; it is not finite where the point may be an edge.
template <class T>
[[nodiscard]] T full_stick_traction(const T& right, const T& left, const ShearLoad<T>& load) {
    using std::sqrt;
    return T((load.Q / Field<T>::pi(right) + load.bulk_tension * (left - right) / 8) /
             sqrt(T(right * left)));
}
/// q at the distance u from an edge of a contact of length a + b.
template <class T>
[[nodiscard]] T full_stick_traction(const T& length, const ShearLoad<T>& load, Edge edge,
                                    const T& u) {
    const T other = length - u;
    return edge == Edge::right ? full_stick_traction(u, other, load)
                               : full_stick_traction(other, u, load);
}

/// The coefficients of u^(-1/2), u^(1/2), u^(3/2), ... of q at an edge (K_II, L_II, M_II, ... of
/// moore-hills EQ39), over any field, with `scale` in place of the sqrt(a + b) in them.
/// `Q_over_pi` = Q/pi (force per unit length), `length` = D = a + b. With u = D z the traction is
/// [Q/pi +- sigma_0 D (1 - 2z)/8] (1 - z)^(-1/2)/sqrt(D u), and (1 - z)^(-1/2) is the sum of beta_k
/// z^k (docs/partial-slip.md, "The expansion at an edge").
template <class T>
[[nodiscard]] std::vector<T> full_stick_terms(const T& Q_over_pi, const T& bulk_tension,
                                              const T& length, Edge edge, std::size_t terms,
                                              T scale) {
    // The tension pulls the right edge outwards.
    const T by_tension = (edge == Edge::right ? bulk_tension : T(-bulk_tension)) * length;
    const T lead = Q_over_pi + Field<T>::over(by_tension, 8);
    T beta = Field<T>::number(1, length);
    T beta_before = Field<T>::number(0, length);
    std::vector<T> s;
    for (int next = 1; s.size() < terms; ++next) {
        s.push_back(T((lead * beta - Field<T>::over(by_tension, 4) * beta_before) / scale));
        beta_before = beta;
        beta = Field<T>::over(T(beta * Field<T>::number(2 * next - 1, beta)), 2 * next);
        scale = scale * length;
    }
    return s;
}

/// The coefficients s_k of q = sum of s_k u^(k-1/2) at an edge: K_II, L_II, M_II, ... (moore-hills
/// EQ39). Unit of s_k: stress/length^(k-1/2).
template <class T>
[[nodiscard]] std::vector<T> full_stick_expansion(const T& length, const ShearLoad<T>& load,
                                                  Edge edge, std::size_t terms) {
    using std::sqrt;
    return full_stick_terms(T(load.Q / Field<T>::pi(length)), load.bulk_tension, length, edge,
                            terms, T(sqrt(length)));
}

} // namespace edgeproof::contact
