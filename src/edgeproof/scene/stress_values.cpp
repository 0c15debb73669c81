// SPDX-License-Identifier: BSD-3-Clause
// The greatest stresses of a body, and the stresses near an edge.
#include "edgeproof/scene/run_scene.hpp"

#include "edgeproof/contact/stress/edge_stress.hpp"
#include "edgeproof/contact/stress/greatest_stress.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/scene/route/ball_level.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

namespace edgeproof::scene {
namespace {

using contact::StressField;

constexpr std::array components{contact::StressComponent::sxx, contact::StressComponent::szz,
                                contact::StressComponent::sxz};
/// Bits a digit, with which a coefficient is accepted that may be zero or on a limit of rounding.
constexpr long many_bits = 12;
constexpr std::size_t most_boxes = 60'000;
constexpr long search_bits = 128;
/// The most bits, as a multiple of those of the plan.
constexpr long most_raised = 64;

[[noreturn]] void refuse(const Scene& scene, const std::string& problem,
                         const std::string& instead) {
    throw InputError(problem, instead).at(scene.file, scene.load_line);
}

/// True if the ratio of shear to pressure has one sign in all layers and its size does not decrease
/// with the force (docs/stress.md, "The greatest values").
bool rises_outwards(const LoadHistory& history) {
    const int sign = history.layers.back().ratio.sign();
    const Exact* before = nullptr;
    return sign != 0 && std::ranges::all_of(history.layers, [&](const LoadHistory::Layer& layer) {
               const Exact* const last = std::exchange(before, &layer.ratio);
               const int growth = last == nullptr ? layer.ratio.sign()
                                                  : Exact(layer.ratio.expr() - last->expr()).sign();
               return growth * sign >= 0;
           });
}

/// Refuses stresses that are infinite, or that have no greatest value.
void check(const Scene& scene, Quantity quantity) {
    const bool sheared = scene.history ? std::ranges::any_of(scene.history->layers,
                                                             [](const LoadHistory::Layer& layer) {
                                                                 return layer.ratio.sign() != 0;
                                                             })
                                       : scene.slips() || scene.proportional();
    if (full_stick_load(scene, Body::A, search_bits)) {
        refuse(scene, "under full stick the stresses are infinite at the edges",
               "give friction in [shear] (partial slip), or path = \"together\"");
    }
    if (quantity == Quantity::sxx && !sheared) {
        refuse(scene,
               "without shear traction sxx on the surface is nowhere above the bulk stress, and "
               "has that value everywhere outside the contact",
               "ask for tau_max or mises, or give Q and friction in [shear]");
    }
}

/// A solved scene with the field of a body.
class Fields : public SceneValues {
public:
    Fields(const Scene& scene, Quantity quantity, Body body)
        : SceneValues(scene, {AskedValue{quantity}}, scene.ask.digits), body_(body),
          slips_(scene.slips()) {}

    /// Calls f with fields of more and more bits until it returns true.
    void raise(long bits, const std::function<bool(const StressField&)>& f) {
        const bool enough = SceneValues::raise(bits, most_raised * plan().bits, [&](auto& level) {
            check_interruption();
            std::optional<StressField> field;
            try {
                field = level.stress_field(body_);
            } catch (const BudgetError&) {
            }
            return field && f(*field);
        });
        if (!enough) {
            if (slips_) {
                check_slip();
            }
            throw BudgetError("no number of bits tried encloses the stress to these digits");
        }
    }

private:
    Body body_;
    bool slips_;
};

BoundedValue proved(const Ball& x, const std::string& route) {
    const bool zero = arb_is_zero(x.data()) != 0;
    return {x, true, route, zero ? std::optional(Rational(0)) : std::nullopt};
}

/// True if the ball has the digits, is exactly zero, or if perhaps no number of bits decides its
/// last digit: a coefficient may vanish at an angle, or be a number of few digits.
bool decided(const Ball& x, const Digits& digits) {
    const bool has = has_digits(x, digits) || arb_is_zero(x.data()) != 0;
    return has || (x.bits() > many_bits * static_cast<long>(digits.count) &&
                   may_be_a_limit(x, digits, has));
}

/// The coordinate of an edge of the contact, or of the stick zone.
BoundedValue place_of_edge(SceneValues& values, bool stick, Edge edge) {
    const bool right = edge == Edge::right;
    const AskedValue asked{stick ? (right ? Quantity::stick_a : Quantity::stick_b)
                                 : (right ? Quantity::a : Quantity::b)};
    BoundedValue x = values.value(asked);
    if (!right) {
        x.value = -x.value;
        if (x.exactly) {
            x.exactly = Rational(-*x.exactly);
        }
    }
    return x;
}

BoundedValue zero(const std::string& route) {
    return {Ball(0, search_bits), true, route, Rational(0)};
}

GreatestValue greatest_tension(const Scene& scene, Fields& fields) {
    std::optional<contact::SurfaceTension> found;
    fields.raise(fields.plan().bits, [&](const StressField& field) {
        found = greatest_surface_tension(field);
        return has_digits(found->value, scene.ask.digits);
    });
    return {proved(found->value, "trailing edge"),
            place_of_edge(fields, false, found->edge),
            zero("trailing edge"),
            {"sxx is greatest at the trailing edge of the contact"}};
}

/// True if x = 0 is the only place of the surface in the region: there F has the same values at x
/// and -x, as in the zone that has always stuck, where q is even and p + sxx is 0.
bool is_on_axis(const StressField& field, const contact::GreatestPlace& place) {
    const Ball over = place.region.real();
    if (place.kind != contact::GreatestPlace::Kind::surface || !contains_zero(place.x) ||
        !contains(over, Ball(-place.x))) {
        return false;
    }
    return field.mirrored || (field.surface_mirrored && field.untilted && field.parts.size() > 1 &&
                              std::ranges::all_of(field.parts, [&](const contact::LoadPart& part) {
                                  return certainly_less(abs(over), part.contact->a()) &&
                                         certainly_less(abs(over), part.contact->b());
                              }));
}

GreatestValue greatest_inside(const Scene& scene, Fields& fields, Quantity quantity, Body body) {
    using contact::GreatestPlace;
    const auto measure = [&](const StressField& field) {
        using Kind = contact::StressNorm::Kind;
        contact::StressNorm norm;
        if (quantity == Quantity::sxx) {
            norm.kind = Kind::surface_sxx;
        } else if (quantity == Quantity::mises) {
            norm.kind = Kind::mises;
            norm.poisson = ball_of(*scene.poisson(body), field.bits());
        }
        return contact::StressMeasure(field, norm);
    };
    std::optional<contact::GreatestStress> found;
    bool mirrored = false;
    fields.raise(search_bits, [&](const StressField& field) {
        mirrored = field.mirrored;
        for (const contact::LoadPart& part : field.parts) {
            if (!part.contact->corners(Edge::right).empty()) {
                refuse(scene,
                       "the profile has a corner inside the contact, where the stress has no "
                       "finite limit",
                       "give a profile without corners");
            }
        }
        if (field.contact().edge_may_be_on_knot()) {
            return false;
        }
        found = greatest_stress(measure(field), most_boxes);
        return true;
    });
    GreatestPlace place = found->places.front();
    Ball stress;
    bool on_axis = place.kind == GreatestPlace::Kind::axis;
    fields.raise(fields.plan().bits, [&](const StressField& field) {
        const contact::StressMeasure F = measure(field);
        const auto at = refined(F, place);
        if (!at) {
            return false;
        }
        stress = F.stress(at->F);
        place.x = at->x;
        place.z = at->z;
        const auto enough = [&](const Ball& x) { return has_digits(x, scene.ask.digits); };
        on_axis = on_axis || is_on_axis(field, place);
        const bool has_x = on_axis || (place.kind == GreatestPlace::Kind::edge && !scene.history) ||
                           enough(place.x);
        const bool has_z = contains_zero(place.z) || enough(place.z);
        return enough(stress) && has_x && has_z;
    });
    const std::string route = "branch and bound";
    GreatestValue result{proved(stress, route), proved(place.x, route), proved(place.z, route), {}};
    if (on_axis) {
        result.x = zero(route);
    }
    switch (place.kind) {
    case GreatestPlace::Kind::surface:
        result.z = zero(route);
        break;
    case GreatestPlace::Kind::edge:
        if (!scene.history) { // else the zone is that of any layer
            result.x = place_of_edge(fields, place.part == 1, place.edge);
        }
        result.z = zero(route);
        result.notes.push_back(place.part == 0 ? "the place is an edge of the contact"
                               : scene.history ? "the place is an edge of a zone of the history"
                                               : "the place is an edge of the stick zone");
        break;
    case GreatestPlace::Kind::axis:
    case GreatestPlace::Kind::inside:
        break;
    }
    const bool twins = found->places.size() == 2 || (mirrored && !on_axis);
    result.notes.emplace_back(twins ? "the mirror image of the place, at -x, has the same value"
                              : quantity == Quantity::sxx
                                  ? "at all other places of the surface the value is less"
                                  : "at all other places the value is less");
    result.notes.push_back(std::to_string(found->boxes) + " boxes were examined");
    return result;
}

/// The greatest tau_max, or mises = 2 tau_max, on the axis of an axisymmetric contact. Below a
/// sphere nothing is greater off the axis (docs/axisymmetric.md, "The greatest stresses").
GreatestValue greatest_on_axis(const Scene& asked, Quantity quantity, Body body) {
    if (quantity == Quantity::sxx) {
        refuse(asked,
               "of an axisymmetric contact only the greatest stresses on the axis are computed",
               "write --greatest tau_max or mises");
    }
    const Ball factor(quantity == Quantity::mises ? 2 : 1, 64);
    SceneValues values(asked, {AskedValue{quantity}}, asked.ask.digits);
    const long most = 8 * values.plan().bits;
    const std::string route = "branch and bound";
    std::optional<GreatestValue> greatest;
    values.raise(values.plan().bits, most, [&](const BallLevel& level) {
        try {
            const auto found = level.axisymmetric_stress(body).greatest_on_axis();
            if (has_digits(found.value, asked.ask.digits) &&
                has_digits(found.z, asked.ask.digits)) {
                greatest = {proved(found.value * factor, route),
                            zero(route),
                            proved(found.z, route),
                            {std::string("at all other places ") +
                                 (asked.is_sphere() ? "" : "of the axis x = 0 ") +
                                 "the value is less",
                             std::to_string(found.intervals) + " intervals were examined"}};
            }
        } catch (const BudgetError&) {
            if (level.bits() == most) {
                throw;
            }
        }
        return greatest.has_value();
    });
    if (!greatest) {
        throw BudgetError("no number of bits tried encloses the greatest value to these digits");
    }
    return *greatest;
}

} // namespace

Quantity greatest_of(std::string_view stress) {
    for (const Quantity quantity : {Quantity::mises, Quantity::tau_max, Quantity::sxx}) {
        if (stress == row_of(quantity).name) {
            return quantity;
        }
    }
    throw InputError(std::string(stress) + " is not searched for",
                     "ask for mises, tau_max (for z >= 0) or sxx (on the surface)");
}

GreatestValue greatest_value(const Scene& scene, Quantity quantity, Body body) {
    if (quantity == Quantity::mises && !scene.poisson(body)) {
        refuse(scene, "mises needs Poisson's ratio", "add nu = \"0.3\" to [load]");
    }
    if (scene.round) {
        return greatest_on_axis(scene, quantity, body);
    }
    check(scene, quantity);
    Fields fields(scene, quantity, body);
    return quantity == Quantity::sxx && (!scene.history || rises_outwards(*scene.history))
               ? greatest_tension(scene, fields)
               : greatest_inside(scene, fields, quantity, body);
}

Exact parse_angle(const std::string& text) {
    Exact angle = Exact::parse(text);
    require(angle.sign() >= 0 && Exact(angle.expr() - Exact::of(Rational(180)).expr()).sign() <= 0,
            text + " does not lie in the body",
            "write degrees from 0 (along the contact) to 180 (along the free surface)");
    return angle;
}

std::vector<RayTerm> ray_terms(const Scene& scene, Body body, const Exact& angle,
                               std::size_t terms) {
    if (scene.round) {
        refuse(scene, "the stresses near an edge are expanded for plane contacts",
               "ask for stresses at points");
    }
    Fields fields(scene, Quantity::sxx, body);
    const long first = fields.plan().bits + static_cast<long>(terms); // a term loses about a bit
    std::vector<RayTerm> all;
    for (const Edge edge : scene.ask.edges) {
        std::vector<RayTerm> found;
        fields.raise(first, [&](const StressField& field) {
            found.clear();
            bool enough = true;
            try {
                const contact::EdgeStress near(field, full_stick_load(scene, body, field.bits()),
                                               edge, terms);
                for (std::size_t i = 0; i < components.size(); ++i) {
                    const std::vector<Ball> K = near.along(components[i], angle);
                    found.resize(K.size());
                    for (std::size_t j = 0; j < K.size(); ++j) {
                        found[j].edge = edge;
                        found[j].halves = static_cast<int>(j) + near.first();
                        found[j].values[i] = proved(K[j], "series");
                        enough = enough && decided(K[j], scene.ask.digits);
                    }
                }
            } catch (const BudgetError&) {
                return false;
            }
            return enough;
        });
        all.insert(all.end(), found.begin(), found.end());
    }
    return all;
}

} // namespace edgeproof::scene
