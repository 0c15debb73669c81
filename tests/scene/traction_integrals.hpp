// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/quadrature/tanh_sinh.hpp"
#include "edgeproof/scene/scene.hpp"
#include "tests/support/namespaces.hpp"

#include <algorithm>
#include <array>
#include <ios>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

/// A second route for stresses in a body: integrals over the tractions.
namespace edgeproof::scenes {

using scene::Quantity, scene::Scene, scene::SceneValues;

inline Real real_of(const Ball& x) { return at_working_precision(x.midpoint()); }

/// `johnson1985`, eq. 2.23, over the pressure and the shear traction of a scene, by tanh-sinh
/// quadrature.
class TractionIntegrals {
public:
    /// The tractions have `digits` digits, and the integrals fewer: see at().
    TractionIntegrals(const Scene& s, unsigned digits)
        : values_(s, asked(s), {digits, Rounding::nearest, false}), digits_(digits),
          shear_(s.shear.has_value()) {
        const auto length = [&](Quantity quantity) {
            return real_of(values_.value({quantity}).value);
        };
        a_ = length(Quantity::a);
        b_ = length(Quantity::b);
        ends_ = {Real(-b_), Real(0), a_};
        if (s.slips() && !s.history) {
            ends_.push_back(length(Quantity::stick_a));
            ends_.push_back(Real(-length(Quantity::stick_b)));
        }
        if (s.history) {
            for (const scene::LoadHistory::Layer& layer : s.history->layers) {
                Scene part = s;
                part = part.without_shear();
                part.load = contact::Load::force(layer.force);
                scene::SceneValues edges(part, {{Quantity::a}, {Quantity::b}},
                                         {digits + 12, Rounding::nearest, false});
                ends_.push_back(real_of(edges.value({Quantity::a}).value));
                ends_.push_back(Real(-real_of(edges.value({Quantity::b}).value)));
            }
        }
        for (const formula::Exact& knot : s.profile->knots()) {
            ends_.push_back(knot.to<Real>());
        }
    }

    /// sxx, szz, sxz of the tractions at a place of a body, which carries `side` times q, to
    /// `target` digits. With `apart` the integrals are divided at x, for a small depth.
    [[nodiscard]] std::array<Real, 3> at(const Real& x, const Real& z, long side, unsigned target,
                                         bool apart) {
        std::vector<Real> ends = ends_;
        if (apart) {
            ends.push_back(x);
        }
        std::erase_if(ends, [&](const Real& s) { return s < -b_ || s > a_; });
        std::sort(ends.begin(), ends.end());
        std::array<Real, 3> sum{Real(0), Real(0), Real(0)};
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            const Real length = ends[i + 1] - ends[i];
            if (length < pow(Real(10), -static_cast<int>(digits_))) {
                continue;
            }
            for (std::size_t k = 0; k < 3; ++k) {
                const auto f = [&](const Real& lo, const Real& hi) {
                    const Real s = ends[i] + length * lo;
                    const auto edge = s > 0 ? contact::Edge::right : contact::Edge::left;
                    const Real u = s > 0 ? Real(a_ - ends[i + 1] + length * hi)
                                         : Real(b_ + ends[i] + length * lo);
                    const Real d = x - s;
                    const Real r2 = d * d + z * z;
                    const std::array<Real, 3> of_p{z * d * d, z * z * z, z * z * d};
                    const std::array<Real, 3> of_q{d * d * d, z * z * d, z * d * d};
                    Real load = traction(Quantity::p, edge, u) * of_p[k];
                    if (shear_) {
                        load += side * traction(Quantity::q, edge, u) * of_q[k];
                    }
                    return Real(load / (r2 * r2) * length);
                };
                sum[k] += quadrature::tanh_sinh<Real>(f, {.target_digits = target}).value;
            }
        }
        for (Real& x_k : sum) {
            x_k *= -2 / edgeproof::pi<Real>();
        }
        return sum;
    }

private:
    static std::vector<scene::AskedValue> asked(const Scene& s) {
        std::vector<scene::AskedValue> list{{Quantity::p}, {Quantity::a}, {Quantity::b}};
        list.front().u = Exact::parse("1/9");
        if (s.shear) {
            list.push_back({Quantity::q});
        }
        if (s.slips()) {
            list.push_back({Quantity::stick_a});
        }
        return list;
    }
    [[nodiscard]] Real traction(Quantity quantity, contact::Edge edge, const Real& u) {
        scene::AskedValue one{quantity, 0, edge};
        const std::string place = u.str(digits_ + 12, std::ios_base::scientific);
        auto& known = known_[{quantity, edge, place}];
        if (!known) {
            one.u = Exact::parse(place);
            known = real_of(values_.value(one).value);
        }
        return *known;
    }

    SceneValues values_;
    unsigned digits_;
    bool shear_;
    Real a_;
    Real b_;
    std::vector<Real> ends_;
    /// The values at the nodes that several integrals have in common.
    std::map<std::tuple<Quantity, contact::Edge, std::string>, std::optional<Real>> known_;
};

} // namespace edgeproof::scenes
