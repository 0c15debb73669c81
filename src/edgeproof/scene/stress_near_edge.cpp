// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/stress_near_edge.hpp"

#include "edgeproof/contact/stress/edge_stress.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/scene/route/ball_level.hpp"

#include <algorithm>
#include <functional>

namespace edgeproof::scene {
namespace {

using contact::EdgeStress;
using contact::StressComponent;

/// The most bits, as a multiple of those of the plan.
constexpr long most_doubled = 32;
/// Bits a digit, with which a value is accepted that may be zero or on a limit of rounding.
constexpr long many_bits = 12;

constexpr std::array components{StressComponent::sxx, StressComponent::szz, StressComponent::sxz};

/// True if the ball has the digits, is exactly zero, or if perhaps no number of bits decides its
/// last digit: a coefficient may vanish at an angle, or be a number of few digits.
bool decided(const Ball& x, const Digits& digits) {
    const bool has = has_digits(x, digits) || arb_is_zero(x.data()) != 0;
    return has || (x.bits() > many_bits * static_cast<long>(digits.count) &&
                   may_be_a_limit(x, digits, has));
}

class Series {
public:
    Series(const Scene& scene, Body body)
        : scene_(asking(scene, {AskedValue{Quantity::sxx}}, scene.ask.digits)),
          plan_(make_plan(scene_)), body_(body) {
        const bool tilted_power_law = scene.slips() && scene.shear->bulk_tension.sign() != 0 &&
                                      scene.profile && !scene.profile->piecewise_linear();
        if (scene.round || (scene.profile && !scene.profile->has_closed_form()) ||
            tilted_power_law) {
            throw InputError("the stresses near an edge are expanded for plane power laws without "
                             "a bulk tension and for piecewise linear g', by closed forms",
                             "give such a profile, or ask for stresses at points")
                .at(scene.file, scene.load_line);
        }
    }

    /// Calls f with the series of more and more bits until it returns true.
    void raise(Edge edge, std::size_t terms,
               const std::function<bool(const EdgeStress&)>& f) const {
        const auto extra = static_cast<long>(terms); // each term loses about a bit
        for (long bits = plan_.bits; bits <= most_doubled * plan_.bits; bits *= 2) {
            check_interruption();
            try {
                BallLevel level(scene_, plan_, {}, bits + extra);
                const auto field = level.stress_field(body_);
                if (field && f(EdgeStress(*field, stick(bits + extra), edge, terms))) {
                    return;
                }
            } catch (const BudgetError&) {
                if (bits == most_doubled * plan_.bits) {
                    throw;
                }
            } catch (const DomainError&) { // too few bits for the stick zone
            }
        }
        throw BudgetError("no number of bits tried gives these digits");
    }

private:
    [[nodiscard]] std::optional<contact::ShearLoad<Ball>> stick(long bits) const {
        if (!scene_.shear || scene_.slips() || scene_.together() ||
            (scene_.shear->Q.sign() == 0 && scene_.shear->bulk_tension.sign() == 0)) {
            return {};
        }
        const Ball side(body_ == Body::A ? 1 : -1, bits); // B carries -q
        return contact::ShearLoad<Ball>{ball_of(scene_.shear->Q, bits) * side,
                                        ball_of(scene_.shear->bulk_tension, bits) * side};
    }

    Scene scene_;
    Plan plan_;
    Body body_;
};

BoundedValue proved(const Ball& x) {
    BoundedValue value{x, true, "series"};
    if (arb_is_zero(x.data()) != 0) {
        value.exactly = Rational(0);
    }
    return value;
}

} // namespace

std::vector<RayTerm> ray_terms(const Scene& scene, Body body, const Exact& angle,
                               std::size_t terms) {
    const Series series(scene, body);
    std::vector<RayTerm> all;
    for (const Edge edge : scene.ask.edges) {
        std::vector<RayTerm> found;
        series.raise(edge, terms, [&](const EdgeStress& near) {
            found.clear();
            bool enough = true;
            for (std::size_t i = 0; i < components.size(); ++i) {
                const std::vector<Ball> K = near.along(components[i], angle);
                found.resize(K.size());
                for (std::size_t j = 0; j < K.size(); ++j) {
                    found[j].edge = edge;
                    found[j].halves = static_cast<int>(j) + near.first();
                    found[j].values[i] = proved(K[j]);
                    enough = enough && decided(K[j], scene.ask.digits);
                }
            }
            return enough;
        });
        all.insert(all.end(), found.begin(), found.end());
    }
    return all;
}

} // namespace edgeproof::scene
