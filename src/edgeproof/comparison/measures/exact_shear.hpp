// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/point.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <memory>

namespace edgeproof::comparison {

/// The exact shear traction of a scene at many places, to 20 digits minus those that cancel if Q
/// and sigma_0 act against each other. Under full stick in closed form; on the path `together`
/// (Q/P) p; in partial slip f (p - p*) with the batch rule for the pressure p* of the stick zone
/// (docs/partial-slip.md), or, if a bulk tension moves the stick zone of a symmetric profile out of
/// the middle, by PartialSlip. An estimate. One object belongs to one thread.
class ExactShear {
public:
    /// Keeps a reference to the scene, which has shear. `whole`: the contact; `force`: P. Throws
    /// InputError, with the line, if the contact slides or the stick zone reaches an edge.
    ExactShear(const scene::Scene& scene, const contact::Profile& profile,
               const contact::Extent<Real>& whole, const Real& force);
    ~ExactShear();
    ExactShear(ExactShear&&) noexcept;
    ExactShear& operator=(ExactShear&&) noexcept;

    /// q at a place inside the contact where the pressure is p.
    [[nodiscard]] Real at(const contact::Point<Real>& place, const Real& p) const;
    /// |Q|/(a + b) + |sigma_0|/4, the mean of |q| under full stick of Q and of sigma_0 alone: the
    /// reference of relative errors of q, since q itself may be infinite at the edges.
    [[nodiscard]] double scale() const;
    [[nodiscard]] double force() const; ///< Q
    /// True if q grows without bound towards the edges: no partial slip.
    [[nodiscard]] bool singular() const;

private:
    struct Solved;
    std::unique_ptr<Solved> solved_;
};

} // namespace edgeproof::comparison
