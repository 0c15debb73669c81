// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/input/slip_checks.hpp"

#include "edgeproof/precision/error.hpp"

namespace edgeproof::scene {
namespace {

constexpr int shown_digits = 8;

} // namespace

void refuse_sliding(const Scene& scene, const Real& force) {
    const contact::ShearSpec& shear = *scene.shear;
    const Real most = force * shear.friction->to<Real>();
    throw InputError("the contact slides: Q = " + shear.Q.text() +
                         ", but f P = " + most.str(shown_digits),
                     "give a smaller Q, or a greater friction, so that |Q| < f P")
        .at(scene.file, scene.friction_line);
}

void refuse_tension(const Scene& scene, contact::Edge edge, bool reached, const Real& least,
                    const Real& most) {
    throw InputError("bulk_tension = " + scene.shear->bulk_tension.text() +
                         " moves the stick zone " + (reached ? "to the " : "beyond the ") +
                         edge_name(edge) +
                         (reached ? " edge to within all digits, so that nothing slips there"
                                  : " edge, which would slip in the direction opposite to Q"),
                     "give a bulk_tension between " + least.str(shown_digits) + " and " +
                         most.str(shown_digits) + ", the bounds for this Q")
        .at(scene.file, scene.tension_line);
}

} // namespace edgeproof::scene
