// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/stress/plane_jet.hpp"

#include <algorithm>

namespace edgeproof::contact {

Ball square(const Ball& x) {
    Ball r(0, x.bits());
    arb_sqr(r.data(), x.data(), x.bits());
    return r;
}

bool PlaneJet::is_finite() const {
    const auto finite = [](const Ball& x) { return x.is_finite(); };
    return value.is_finite() && std::ranges::all_of(first, finite) &&
           std::ranges::all_of(second, finite);
}

bool PlaneJet::concave() const {
    return certainly_negative(second[0]) &&
           certainly_positive(second[0] * second[2] - square(second[1]));
}

PlaneJet square(const PlaneJet& f) {
    const auto& [x, z] = f.first;
    const auto& [xx, xz, zz] = f.second;
    const Ball& v = f.value;
    return {square(v),
            {v * x * 2, v * z * 2},
            {(square(x) + v * xx) * 2, (x * z + v * xz) * 2, (square(z) + v * zz) * 2}};
}

// The derivatives of a square root by the chain rule, as Krawczyk's operator needs them
// (docs/stress.md, "The greatest values").
PlaneJet root(const PlaneJet& f, const Ball& size) {
    const Ball twice = size * 2;
    const Ball x = f.first[0] / twice;
    const Ball z = f.first[1] / twice;
    return {size,
            {x, z},
            {f.second[0] / twice - square(x) / size, f.second[1] / twice - x * z / size,
             f.second[2] / twice - square(z) / size}};
}

PlaneJet sum(const Ball& by, const PlaneJet& f, const Ball& with, const PlaneJet& g) {
    PlaneJet r{by * f.value + with * g.value, {}, {}};
    for (std::size_t i = 0; i < r.first.size(); ++i) {
        r.first[i] = by * f.first[i] + with * g.first[i];
    }
    for (std::size_t i = 0; i < r.second.size(); ++i) {
        r.second[i] = by * f.second[i] + with * g.second[i];
    }
    return r;
}

} // namespace edgeproof::contact
