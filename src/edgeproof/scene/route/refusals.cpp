// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/scene/route/scene_values.hpp"

#include "edgeproof/contact/curved/curved_slope.hpp"
#include "edgeproof/contact/profile/slope.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>

namespace edgeproof::scene {

void SceneValues::refuse_contact() const {
    if (no_contact_) {
        throw InputError(*no_contact_, "give a load that a contact of this profile can carry");
    }
    throw BudgetError("no number of bits encloses the edges of the contact");
}

void SceneValues::check_slope() {
    if (scene_.closed()) {
        return; // decided exactly
    }
    check_reach(*scene_.profile, first_->a(), first_->b());
    const contact::SlopeMonotonicity monotonicity =
        monotonicity_of_slope(*scene_.profile, first_->a(), first_->b());
    if (monotonicity.kind == contact::SlopeMonotonicity::Kind::falls) {
        throw InputError("g' decreases near x = " + monotonicity.where->midpoint().str(8),
                         "give a convex profile: g' must not decrease")
            .at(scene_.file, scene_.profile_line);
    }
    if (monotonicity.kind != contact::SlopeMonotonicity::Kind::rises) {
        throw InputError("g' could not be proved to rise in the contact",
                         "write the slope in another form, such as (x - 3/10)^3 + 27/1000 for its "
                         "expanded polynomial, or in more pieces")
            .at(scene_.file, scene_.profile_line);
    }
}

void SceneValues::refuse_unknown(const QuantityRow& row, const AskedValue& asked) {
    if (row.of_bodies()) {
        throw BudgetError(std::string("no number of bits encloses the value") +
                          (row.place == QuantityRow::Place::body
                               ? ", which may be infinite there: at an edge under full stick, or "
                                 "at a corner"
                               : ""));
    }
    if (row.at_point()) {
        const Distance u = asked.distance();
        refuse_outside(asked.edge, u);
        if (u.number() && u.number()->sign() == 0) {
            throw DomainError("the point is on an edge");
        }
        refuse_corner(asked.edge, u);
        if (std::ranges::any_of(first_->contact().corners(asked.edge), [&](const Ball& corner) {
                return overlaps(corner, first_->distance(u));
            })) {
            throw IndistinctPlace(true,
                                  "the point is on a corner, or cannot be distinguished from it");
        }
    }
    throw BudgetError("no number of bits encloses " + text_of(asked) +
                      (first_->contact().edge_may_be_on_knot()
                           ? ": an edge may lie on a knot of g', which balls do not decide"
                           : ""));
}

bool SceneValues::no_traction_at_edges() const {
    return !scene_.shear || scene_.slips() || scene_.proportional();
}

void SceneValues::refuse_outside(Edge edge, const Distance& u) {
    if (!u.number()) {
        refuse_outside_by_edges(edge, u);
        return;
    }
    const Rational* distance = u.number()->expr().rational();
    const Ball from = u.enclosure({}, {}, length_.bits());
    const bool exact = known_length_ && distance != nullptr;
    const bool on_edge = exact && (*distance == 0 || *distance == *known_length_);
    if (on_edge && no_traction_at_edges()) {
        throw OutsideContact("is on an edge");
    }
    if (u.number()->sign() < 0 ||
        (exact ? *distance > *known_length_ : certainly_less(length_, from))) {
        throw OutsideContact();
    }
    if (!(exact ? *distance < *known_length_ : certainly_less(from, length_))) {
        throw IndistinctPlace(false, "the point is on an edge, or cannot be distinguished from it");
    }
}

void SceneValues::refuse_outside_by_edges(Edge edge, const Distance& u) {
    refuse_corner(edge, u);
    const auto symbol = [](std::string_view name) { return Form::name(name, true); };
    const auto given = first_->contact().known(Edge::right); // a formula has its value in it
    const Form a = given ? algebra::form_of(given->expr(), symbol) : symbol("a");
    const Form b = scene_.symmetric() ? a : symbol("b");
    const Form distance = u.exactly([&](std::string_view name) { return name == "a" ? a : b; });
    const Form length = a + b;
    if ((distance == Form() || distance == length) && no_traction_at_edges()) {
        throw OutsideContact("is on an edge");
    }
    bool outside = false;
    const bool inside = raise(plan_.bits, 8 * plan_.bits, [&](const BallLevel& level) {
        const Ball from = level.distance(u);
        if (certainly_negative(from) || certainly_less(level.length(), from)) {
            throw OutsideContact();
        }
        outside = !certainly_positive(from) || !certainly_less(from, level.length());
        return !outside &&
               std::ranges::none_of(level.contact().corners(edge),
                                    [&](const Ball& corner) { return overlaps(corner, from); });
    });
    if (inside) {
        return;
    }
    throw IndistinctPlace(!outside,
                          outside ? "the point is on an edge, or cannot be distinguished from it"
                                  : "the point is on a corner, or cannot be distinguished from it");
}

void SceneValues::refuse_corner(Edge edge, const Distance& u) const {
    const auto x = scene_.profile ? first_->known_x(edge, u) : std::nullopt;
    for (std::size_t i = 0; x && i < scene_.profile->knots().size(); ++i) {
        if (scene_.profile->has_corner(i) &&
            contact::certainly_zero(scene_.profile->knots()[i].expr() - x->expr())) {
            throw IndistinctPlace(true, u.number()
                                            ? "the pressure is infinite at a corner of the profile"
                                            : "the point is on a corner, where the pressure is "
                                              "infinite");
        }
    }
}

} // namespace edgeproof::scene
