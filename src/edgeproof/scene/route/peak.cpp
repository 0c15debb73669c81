// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/route/peak.hpp"

#include "edgeproof/precision/error.hpp"

namespace edgeproof::scene {

bool peaks_in_the_middle(const Scene& scene) {
    if (!scene.profile || scene.profile->kind() != contact::Profile::Kind::power_law) {
        return false;
    }
    const formula::Exact& m = scene.profile->parameters().at("m");
    return m.sign() > 0 &&
           formula::Exact(m.expr() - formula::Expr::number(Rational(1))).sign() <= 0;
}

void refuse_infinite_peak(const Real& x) {
    throw DomainError("there is no greatest pressure: it is infinite at the corner x = " +
                      x.str(8));
}

} // namespace edgeproof::scene
