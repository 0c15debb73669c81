// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/input/quantity.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <cmath>

namespace edgeproof::scene {

double scale_of(const AskedValue& asked, double force, double length) {
    const QuantityRow& row = row_of(asked.quantity);
    const double power =
        row.length_power -
        (row.index == QuantityRow::Index::order ? static_cast<double>(asked.k) : 0.0);
    const double unit = row.force_power == 0 ? 1 : force;
    return power < 0 ? unit / std::pow(length, -power) : unit * std::pow(length, power);
}

bool has_cycle_energy(const Scene& scene) {
    return scene.shear->bulk_tension.sign() == 0 &&
           (scene.punch || scene.profile->has_closed_form());
}

std::optional<Lack> lack_of(const Scene& scene, const AskedValue& asked) {
    const std::string symbol = symbol_of(asked);
    switch (row_of(asked.quantity).needs) {
    case QuantityRow::Needs::nothing:
        break;
    case QuantityRow::Needs::shear:
        if (!scene.shear) {
            return Lack{symbol + " is requested, but there is no shear",
                        "add Q or bulk_tension, or leave " + symbol + " out"};
        }
        break;
    case QuantityRow::Needs::friction:
        if (!scene.slips()) {
            return Lack{symbol + " is requested, but there is no friction",
                        "add friction, or leave " + symbol + " out"};
        }
        break;
    case QuantityRow::Needs::friction_alone:
        if (!scene.slips() || scene.shear->bulk_tension.sign() != 0) {
            return Lack{symbol + " is requested, but there is " +
                            (scene.slips() ? "a bulk tension" : "no friction"),
                        scene.slips() ? "leave bulk_tension out, or leave " + symbol + " out"
                                      : "add friction, or leave " + symbol + " out"};
        }
        if (!has_cycle_energy(scene)) {
            return Lack{symbol + " is requested, but is not computed for curved slopes",
                        "leave " + symbol + " out"};
        }
        break;
    case QuantityRow::Needs::unknown_tilt:
        if (!scene.punch) {
            return Lack{symbol + " is requested, but is not an unknown of the scene",
                        "give P and M and no " + symbol + ", or leave " + symbol +
                            " out of the quantities"};
        }
        break;
    }
    return {};
}

} // namespace edgeproof::scene
