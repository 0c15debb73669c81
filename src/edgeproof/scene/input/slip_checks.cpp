// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/input/slip_checks.hpp"

#include "edgeproof/precision/error.hpp"

namespace edgeproof::scene {
namespace {

constexpr int told_digits = 8;

} // namespace

void refuse_sliding(const Scene& scene, const Real& force) {
    const contact::ShearSpec& shear = *scene.shear;
    const Real most = force * shear.friction->to<Real>();
    throw InputError("the contact slides: Q = " + shear.Q.text() +
                         " against f P = " + most.str(told_digits),
                     "give a smaller Q, or a greater friction, so that |Q| < f P")
        .at(scene.file, scene.friction_line);
}

void refuse_tension(const Scene& scene, contact::Edge edge, bool reached, const Real& least,
                    const Real& most) {
    throw InputError("bulk_tension = " + scene.shear->bulk_tension.text() +
                         " draws the stick zone " + (reached ? "to the " : "beyond the ") +
                         edge_name(edge) +
                         (reached ? " edge, where nothing slips then, as far as all digits tell"
                                  : " edge, which would slip against Q"),
                     "give a bulk_tension between " + least.str(told_digits) + " and " +
                         most.str(told_digits) + ", the bounds for this Q")
        .at(scene.file, scene.tension_line);
}

} // namespace edgeproof::scene
