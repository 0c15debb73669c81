// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/batch/batch_piece.hpp"
#include "edgeproof/contact/batch/batch_pressure.hpp"
#include "edgeproof/contact/batch/batch_sums.hpp"
#include "edgeproof/contact/profile/slope.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace edgeproof::contact {

/// eqn:SIEPressure with its principal value made regular, as a sum over the pieces of g':
///   p = (E*/(2 pi)) (w_x times the integral of (G - G_x)/(S - S_x) d phi, corners by logarithms).
/// See batch_circle.hpp for phi, S, and batch_piece.hpp for G. Both G and S grow, so that no sum of
/// a linear piece cancels.
class BatchIntegral {
public:
    /// At the thread's working precision.
    BatchIntegral(const Profile& profile, const Real& modulus, const Extent<Real>& e,
                  unsigned digits, BatchPressure::Rule rule);
    [[nodiscard]] RoutedPressure<Real> operator()(const Point<Real>& at);

private:
    /// What a point makes of one piece.
    struct Task {
        enum class Kind {
            inside, ///< x is in the piece: the quotient has no pole
            far,    ///< x is not, and the rule converges in spite of the pole
            near    ///< the pole is taken out: what is left has none
        };
        Kind kind = Kind::inside;
        bool above = false; ///< x is right of the piece
        bool by_levels = false;
        bool mirror_near = false; ///< the pole at s = -x is taken out as well
        Real gap;                 ///< S from x to the near end
        Real height;              ///< G from x to the near end
        Real step;                ///< s from x to the near end
        double ln_size = 0;       ///< roughly, of its integral
        std::size_t n = 0;
        double ln_error = -1e300;
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
        std::size_t mark; ///< of the right one of a folded pair
        bool pair;        ///< a folded contact has it at -v as well
        Real jump;
        Real right; ///< its distances from the edges
        Real left;
    };

    void locate(const Point<Real>& at);
    void set_tasks();
    void choose(std::size_t i, double ln_tolerance);
    [[nodiscard]] double pole_excess(const BatchPiece& piece, const Task& task) const;
    void choose_far(const BatchPiece& piece, Task& task, double excess, double ln_tolerance) const;
    void choose_quotient(const BatchPiece& piece, Task& task, double ln_tolerance) const;
    void add_share(Real& sum, const BatchPiece& piece, Task& task);
    template <class Term>
    void add_nodes(Real& sum, const BatchPiece& piece, Task& task, const Term& term);
    [[nodiscard]] Real pole_integral(const BatchPiece& piece, const Task& task);
    [[nodiscard]] Real quotient(const BatchPiece& piece, const BatchNodes& nodes,
                                std::size_t k) const;
    [[nodiscard]] Real mirror_integral(const BatchPiece& piece) const;
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
    double length_; ///< of the circle in S, in units of 2^S_exponent

    Place at_;
    std::vector<Task> tasks_;
    NodeSums sums_;
    std::size_t nodes_ = 0;
    bool converged_ = true;
};

} // namespace edgeproof::contact
