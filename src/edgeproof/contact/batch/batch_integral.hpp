// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/batch/batch_piece.hpp"
#include "edgeproof/contact/batch/batch_pressure.hpp"
#include "edgeproof/contact/batch/batch_sums.hpp"
#include "edgeproof/contact/profile/slope.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace edgeproof::contact {

/// The pressure by eqn:SIEPressure, with its principal value regularised (docs/pressure.md, "The
/// singular integral, and how its pole is taken out"), as a sum over the pieces of g':
///   p = (E*/(2 pi)) (w(x) times the integral of (G - G_x)/(S - S_x) d phi, plus corners).
/// phi and S are defined in batch_piece.hpp, and G. G and S both increase, so that
/// the sum over linear pieces has no cancellation.
class BatchIntegral {
public:
    /// At the working precision of the thread.
    /// @param profile g'(x)
    /// @param modulus contact modulus E* (stress)
    /// @param e distances of both edges from the origin (length)
    /// @param digits relative accuracy wanted, in decimal digits
    /// @param rule quadrature rule
    BatchIntegral(const Profile& profile, const Real& modulus, const Extent<Real>& e,
                  unsigned digits, BatchPressure::Rule rule);
    /// Returns p (stress) with an estimate of its error.
    /// @param at point inside the contact (length)
    [[nodiscard]] RoutedPressure<Real> operator()(const Point<Real>& at);

private:
    /// The contribution of one piece to the integral at a point.
    struct Task {
        enum class Kind {
            inside, ///< x is in the piece: the quotient has no pole
            far,    ///< x is outside, and the rule converges in spite of the pole
            near    ///< x is outside, and the pole is subtracted: the rest has none
        };
        Kind kind = Kind::inside;
        bool above = false;       ///< x is to the right of the piece
        bool by_levels = false;   ///< tanh-sinh is used instead of Gauss-Legendre
        bool mirror_near = false; ///< the pole at s = -x is subtracted as well
        Real gap;                 ///< S from x to the near end
        Real height;              ///< G from x to the near end
        Real step;                ///< s from x to the near end
        double ln_size = 0;       ///< ln of the approximate size of the integral
        std::size_t n = 0;        ///< number of Gauss-Legendre nodes
        double ln_error = -1e300; ///< ln of the bound or estimate of the rule's error
    };
    struct Place {
        Real x;
        Real right;
        Real left;
        Real step_lo; ///< s from the left end of the piece
        Real step_hi;
        std::size_t piece = 0;
        double phi = 0;
    };
    struct Corner {
        std::size_t mark; ///< for a folded pair: of the corner on the right
        bool pair;        ///< a folded contact has a corner at -v as well
        Real jump;
        Real right; ///< distance of the corner from the right edge
        Real left;
    };

    /// Sets the place and the piece of a point (length).
    void locate(const Point<Real>& at);
    /// Sets the distances from the point to each piece, and the sizes of the integrals.
    void set_tasks();
    /// Chooses the rule for piece i; `ln_tolerance` is ln of the absolute error allowed.
    void choose(std::size_t i, double ln_tolerance);
    /// Returns the distance in phi between the piece and the nearest pole 1/(S - S_x).
    [[nodiscard]] double pole_excess(const BatchPiece& piece, const Task& task) const;
    /// Chooses the number of nodes; `excess` is the result of pole_excess.
    void choose_far(const BatchPiece& piece, Task& task, double excess, double ln_tolerance) const;
    /// The same for the quotient by the formula of the piece, for x in the piece or near it.
    void choose_quotient(const BatchPiece& piece, Task& task, double ln_tolerance) const;
    /// Adds the integral over a piece to `sum`.
    void add_share(Real& sum, const BatchPiece& piece, Task& task);
    /// Adds the sum over the nodes of a piece to `sum`; `term` adds the terms of given nodes.
    template <class Term>
    void add_nodes(Real& sum, const BatchPiece& piece, Task& task, const Term& term);
    /// Returns the integral of d phi/|S - S_x| over a piece that does not contain x.
    [[nodiscard]] Real pole_integral(const BatchPiece& piece, const Task& task);
    /// Returns (G(s) - G(x))/(S - S_x) at node `k` close to x.
    [[nodiscard]] Real quotient(const BatchPiece& piece, const BatchNodes& nodes,
                                std::size_t k) const;
    /// Returns the integral of d phi/(s + x) over a piece of a folded contact.
    [[nodiscard]] Real mirror_integral(const BatchPiece& piece) const;
    /// Returns the logarithms of all corners.
    [[nodiscard]] Real corners(const Point<Real>& at);

    unsigned digits_;
    BatchPressure::Rule rule_;
    BatchCircle circle_;
    SlopeIn<Real> slope_;
    Real factor_; ///< E*/(2 pi)
    std::vector<std::unique_ptr<BatchPiece>> pieces_;
    std::vector<Corner> corners_;
    Extent<Real> extent_;
    long S_exponent_;
    long G_exponent_;
    double length_; ///< length of the circle in S, in units of 2^S_exponent

    Place at_;
    std::vector<Task> tasks_;
    NodeSums sums_;
    std::size_t nodes_ = 0;
    bool converged_ = true;
};

} // namespace edgeproof::contact
