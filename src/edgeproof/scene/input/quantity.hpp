// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/scene/input/place.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace edgeproof::formula {
class ExactNumber;
}

namespace edgeproof::scene {

struct BoundedValue;
struct ExtentValues;
struct Plan;
struct Scene;
class BallLevel;
class ExactValues;
class RealLevel;

/// A number that may be asked of a scene. quantity.cpp has a row for each, from which scenes,
/// recipes, questions to other programs, hard cases, tables and reports take what they need.
enum class Quantity {
    p,        ///< pressure at a point
    q,        ///< shear traction at a point
    c,        ///< c_k of u^(k + 1/2) in p at an edge
    s,        ///< s_k of q at an edge, from its lowest power on; s_0 under full stick is K_II
    a,        ///< distance of the right edge from the origin
    b,        ///< distance of the left edge
    P,        ///< normal force per unit length
    M,        ///< moment per unit length
    alpha,    ///< tilt, where P and M are given
    extent,   ///< the first u at which k terms are off by the tolerance
    measure,  ///< the length of all that k terms are right to the tolerance at
    slip,     ///< the size of the slip zone at an edge, with friction
    stick_a,  ///< distance of the right edge of the stick zone from the origin
    stick_b,  ///< distance of its left edge
    residual, ///< 1 - (the first k terms)/p at a point, with its sign
    tilt_difference, ///< p at a point less that of the same profile and a, upright
    p_max,           ///< the greatest pressure
    cycle_energy     ///< what friction takes in a cycle of Q, P held, without a bulk tension
};

/// What is planned and computed together; `quantities` of a scene file names these.
enum class QuantityGroup {
    pressure,     ///< p at points, and its n-term approximations
    coefficients, ///< c_0, c_1, ... at edges (with shear: those of q too)
    shear,        ///< q at points
    extent,       ///< how far n terms stay within a tolerance
    slip,         ///< slip zones: their sizes, and those of n terms
    contact,      ///< a, b, P and M
    peak          ///< the greatest pressure
};

/// One number that is asked of a scene.
struct AskedValue {
    Quantity quantity = Quantity::p;
    std::size_t k = 0;                            ///< order of a coefficient; number of terms
    contact::Edge edge = contact::Edge::right;    ///< unless Place::contact
    std::optional<formula::Exact> u = {};         ///< of Place::point
    std::optional<formula::Exact> tolerance = {}; ///< where the row says so
    std::optional<Distance> place = {};           ///< in place of u, where edges tell it

    [[nodiscard]] Distance distance() const { return place ? *place : Distance(*u); }
};

/// A row of the table.
struct QuantityRow {
    /// Where there is a value: one a contact, one at each edge, one at each point.
    enum class Place { contact, edge, point };
    /// What k of an AskedValue is.
    enum class Index { none, order, terms };
    /// What a scene must have.
    enum class Needs { nothing, shear, friction, friction_alone, unknown_tilt };

    Quantity quantity;
    /// In recipes, questions, answers and headers of columns, without the index ("c" of c_1);
    /// empty: not to be asked there.
    std::string_view symbol;
    std::string_view name; ///< in words, as files of hard cases write it
    QuantityGroup group = QuantityGroup::contact;
    Place place = Place::contact;
    Index index = Index::none;
    Needs needs = Needs::nothing;
    bool tolerance = false; ///< compared with one
    /// The unit is a force per length to this power, times a length to that one; of a coefficient
    /// of order k, times a length to -k more.
    int force_power = 0;
    double length_power = 0;
    /// For the notes of a table that holds it, behind the symbol; empty: every table says it.
    std::string_view meaning = {};
    /// In messages, where the symbol does not say it.
    std::string_view label = {};

    // The evaluators. None: the value is made of others by whoever asks for it. A level is asked
    // for the value at more and more bits, until it has its digits; a ball that is not finite
    // says that so few bits give none. Without an exact form, no number of bits may tell a limit of
    // rounding, and the value is printed as its enclosure there.
    Ball (*ball)(BallLevel&, const AskedValue&) = nullptr;
    formula::ExactNumber (*exact)(ExactValues&, const AskedValue&) = nullptr;
    BoundedValue (*real)(RealLevel&, const AskedValue&) = nullptr;
    /// How a value in balls was computed.
    const char* (*route)(const Scene&, const Plan&) = nullptr;
    /// The value, where the scene states it; null: it does not.
    const formula::Exact* (*given)(const Scene&) = nullptr;
    /// The edge whose distance from the origin it is.
    std::optional<contact::Edge> distance_of = {};
    bool cancels_little = false; ///< so that fewer bits will do at first
    /// In place of evaluators: where a search for crossings puts it.
    BoundedValue ExtentValues::*searched = nullptr;

    [[nodiscard]] bool of_friction() const {
        return needs == Needs::friction || needs == Needs::friction_alone;
    }
    /// Needs [shear] of the scene, which is left out of the plan of others.
    [[nodiscard]] bool of_shear() const { return needs == Needs::shear || of_friction(); }
    [[nodiscard]] bool at_point() const { return place == Place::point; }
    [[nodiscard]] bool at_edge() const { return place != Place::contact; }
};

[[nodiscard]] std::span<const QuantityRow> quantity_rows();
[[nodiscard]] const QuantityRow& row_of(Quantity quantity);
/// The same. Throws Error for one that has no evaluators.
[[nodiscard]] const QuantityRow& evaluated_row(Quantity quantity);

/// A quantity with its index.
struct NamedQuantity {
    Quantity quantity = Quantity::p;
    std::size_t k = 0;
};
/// "p", "c_0", "alpha", "extent_1", ... Nothing for other names, for k > 399 and for no terms.
[[nodiscard]] std::optional<NamedQuantity> quantity_named(std::string_view symbol);
/// The inverse: "p", "c_0", ...
[[nodiscard]] std::string symbol_of(const AskedValue& asked);
/// The same for all orders or numbers of terms: "c_k".
[[nodiscard]] std::string family_of(const AskedValue& asked);
/// "p at u = 1e-40 from the right edge", "c_1 at the left edge": for messages.
[[nodiscard]] std::string text_of(const AskedValue& asked);
/// For a name that is none: "did you mean c_1? write p, q, c_0, c_1, ..., or measure_1".
[[nodiscard]] std::string quantity_advice(std::string_view name);

/// What a value of that kind is measured by where it is zero itself, in a contact of that force and
/// length.
[[nodiscard]] double scale_of(const AskedValue& asked, double force, double length);

/// What a scene lacks for a quantity, and what to write instead.
struct Lack {
    std::string problem;
    std::string instead;
};
[[nodiscard]] std::optional<Lack> lack_of(const Scene& scene, const AskedValue& asked);

/// A row of the groups: what a scene must give for it, beside the effects.
struct GroupRow {
    QuantityGroup group;
    std::string_view name; ///< as a scene file writes it
    bool points = false;
    bool shear = false;
    bool friction = false;
    bool terms = false;
    bool tolerance = false;
    std::string_view incomplete = {}; ///< what to say where terms or tolerance are not given
    std::string_view instead = {};
};
[[nodiscard]] std::span<const GroupRow> group_rows();
[[nodiscard]] std::string group_name(QuantityGroup group);

/// "right" and "left".
[[nodiscard]] std::string edge_name(contact::Edge edge);
[[nodiscard]] std::optional<contact::Edge> edge_named(std::string_view name);

} // namespace edgeproof::scene
