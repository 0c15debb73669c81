// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/validation/enclosed_value.hpp"

#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/run_scene.hpp"

namespace edgeproof::validation {
namespace {

using scene::AskedValue;
using scene::Quantity;

/// The most digits added until a difference has its digits.
constexpr unsigned most_cancelled = 4000;

scene::Digits to_digits(unsigned digits) { return {digits, Rounding::nearest, false}; }

scene::BoundedValue single(const scene::Scene& scene, const AskedValue& asked, unsigned digits) {
    return scene::SceneValues(scene, {asked}, to_digits(digits)).value(asked);
}

/// Computes x - y with narrower and narrower balls until the difference has its digits.
scene::BoundedValue tilt_difference(const scene::Scene& scene, const AskedValue& asked,
                                    unsigned digits) {
    const scene::Scene other = upright(scene);
    AskedValue pressure = asked;
    pressure.quantity = Quantity::p;
    for (unsigned extra = 32;; extra *= 2) {
        const scene::BoundedValue p = single(scene, pressure, digits + extra);
        const scene::BoundedValue q = single(other, pressure, digits + extra);
        scene::BoundedValue d{p.value - q.value, p.proved && q.proved, p.route};
        if (scene::has_digits(d.value, to_digits(digits)) || extra >= most_cancelled) {
            return d;
        }
    }
}

/// 1 - (the first n terms)/p, with its sign; p = sum of c_k u^(k + 1/2) (docs/expansions.md).
scene::BoundedValue residual(const scene::Scene& scene, const AskedValue& asked, unsigned digits) {
    AskedValue pressure = asked;
    pressure.quantity = Quantity::p;
    std::vector<AskedValue> all{pressure};
    for (std::size_t k = 0; k < asked.k; ++k) {
        all.push_back({Quantity::c, k, asked.edge});
    }
    for (unsigned extra = 32;; extra *= 2) {
        scene::SceneValues values(scene, all, to_digits(digits + extra));
        const scene::BoundedValue p = values.value(pressure);
        const Ball u = ball_of(*asked.u, formula::bits_for(digits + extra) + 64);
        Ball sum;
        bool proved = p.proved;
        for (std::size_t k = asked.k; k-- > 0;) {
            const scene::BoundedValue c = values.value(all[k + 1]);
            proved = proved && c.proved;
            sum = k + 1 < asked.k ? sum * u + c.value : c.value;
        }
        scene::BoundedValue d{1 - sum * sqrt(u) / p.value, proved, "series"};
        if (scene::has_digits(d.value, to_digits(digits)) || extra >= most_cancelled) {
            return d;
        }
    }
}

} // namespace

scene::Scene upright(const scene::Scene& scene) {
    const formula::Exact none = formula::Exact::of(Rational(0));
    const auto& parameters = scene.profile->parameters();
    scene::Scene s = scene;
    switch (scene.profile->kind()) {
    case contact::Profile::Kind::tilted_wedge:
        s.profile = contact::Profile::tilted_wedge(parameters.at("phi"), none);
        return s;
    case contact::Profile::Kind::tilted_flat_and_rounded:
        s.profile =
            contact::Profile::tilted_flat_and_rounded(none, parameters.at("t"), parameters.at("R"));
        return s;
    default:
        throw InputError("a " + scene.profile->kind_name() + " profile has no tilt",
                         "take a tilted-wedge or tilted-flat-and-rounded profile");
    }
}

scene::BoundedValue enclosed_value(const scene::Scene& scene, const AskedValue& asked,
                                   unsigned digits) {
    return asked.quantity == Quantity::tilt_difference ? tilt_difference(scene, asked, digits)
           : asked.quantity == Quantity::residual      ? residual(scene, asked, digits)
                                                       : single(scene, asked, digits);
}

} // namespace edgeproof::validation
