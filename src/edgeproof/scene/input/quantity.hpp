// SPDX-License-Identifier: BSD-3-Clause
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

namespace edgeproof::scene {

struct BoundedValue;
struct Digits;
struct Scene;
class BallLevel;
class ExactValues;

/// A number that a scene can be asked for. quantity_rows.cpp has a row for each; scenes, recipes,
/// questions to other programs, hard cases, tables and reports use these rows.
enum class Quantity {
    p,       ///< pressure at a point
    q,       ///< shear traction at a point
    c,       ///< c_k of u^(k + 1/2) in p at an edge
    s,       ///< s_k of q at an edge, from its lowest power on; s_0 under full stick is K_II
    a,       ///< distance of the right edge from the origin
    b,       ///< distance of the left edge
    P,       ///< normal force per unit length
    M,       ///< moment per unit length
    alpha,   ///< tilt, where P and M are given
    extent,  ///< the first u at which the error of k terms is the tolerance
    measure, ///< the total length of the places where the error of k terms is within the tolerance
    slip,    ///< the size of the slip zone at an edge, with friction
    stick_a, ///< distance of the right edge of the stick zone from the origin
    stick_b, ///< distance of its left edge
    p_max,   ///< the greatest pressure
    cycle_energy, ///< energy dissipated by friction in a cycle of Q at constant P, or in the last
                  ///< pass of the steps of a history, without a bulk tension
    x,            ///< coordinate of a point
    u,            ///< distance of a point from the edge, if it depends on the edges
    local,        ///< the sum of the first k terms of p at a point
    rel,          ///< |1 - local/p|
    q_local,      ///< the sum of the first k terms of q at a point
    q_rel,        ///< |1 - q_local/q|
    extent_fraction,  ///< extent/(a + b)
    measure_fraction, ///< measure/(a + b)
    crossing,         ///< the j-th u at which the error of k terms is the tolerance
    load_ratio,       ///< |Q|/(f P)
    /// The least bulk tension, for the given Q and P, that keeps the stick zone in the contact.
    least_tension,
    most_tension,      ///< the greatest one
    slip_terms,        ///< the size of the slip zone by the first k terms
    slip_rel,          ///< |1 - slip_terms/slip|
    slip_load,         ///< the load ratio up to which slip_rel stays within the tolerance
    sxx,               ///< normal stress along the surface, at a point of a body
    szz,               ///< normal stress across the surface
    sxz,               ///< shear stress
    mises,             ///< equivalent stress of von Mises, in plane strain
    tau_max,           ///< greatest shear stress in the plane
    syy,               ///< normal stress across the plane, in plane strain
    s1,                ///< greatest principal stress, in plane strain
    s2,                ///< middle principal stress
    s3,                ///< least principal stress
    tresca,            ///< equivalent stress of Tresca, s1 - s3
    step_energy,       ///< energy dissipated by friction in the last step of a load history
    gap,               ///< gap between the bodies outside the contact
    slip_displacement, ///< u_A - u_B along the surface, inside the contact
    delta,             ///< approach of the bodies of an axisymmetric contact
    stiffness,         ///< dP/d delta
    ux,                ///< displacement of the surface of a body along x, relative to a reference
    uz,                ///< the same into the body
    slope,             ///< du_z/dx
    dissipation,       ///< energy dissipated in a cycle, per area of the surface
};

/// Quantities that are planned and computed together; `quantities` of a scene file names them.
enum class QuantityGroup {
    pressure,     ///< p at points, and its n-term approximations
    coefficients, ///< c_0, c_1, ... at edges (with shear: also those of q)
    shear,        ///< q at points
    extent,       ///< the distance up to which n terms stay within a tolerance
    slip,         ///< slip zones: their sizes, and the sizes by n terms
    contact,      ///< a, b, P and M
    peak,         ///< the greatest pressure
    stress,       ///< stresses at points of the bodies
    displacement, ///< the gap outside the contact, and the slip inside
    surface,      ///< displacements and slope of the surface of a body, and dissipation
};

/// A is the body on which Q and q act; B is the other one.
enum class Body { A, B };
/// A length: an exact number, or a formula in a and b, which are solved for.
class Coordinate {
public:
    Coordinate() : Coordinate(Exact()) {}
    Coordinate(Exact x) : text_(x.text()), number_(std::move(x)) {} // NOLINT: mostly numbers
    /// @param place from the origin
    explicit Coordinate(const Place& place);

    [[nodiscard]] const std::optional<Exact>& number() const { return number_; }
    [[nodiscard]] bool is_zero() const { return number_ && number_->sign() == 0; }
    /// The length for a and b in these balls.
    [[nodiscard]] Ball enclosure(const Ball& a, const Ball& b, long bits) const;
    [[nodiscard]] const std::string& text() const { return text_; }
    friend bool operator==(const Coordinate& s, const Coordinate& t) { return s.text_ == t.text_; }

private:
    std::string text_;
    std::optional<Exact> number_;
    std::optional<Place> formula_; ///< if there is no number
};
/// A point of a body: x from the origin, z >= 0 the depth into that body.
struct BodyPoint {
    Coordinate x;
    Coordinate z;
    Body body = Body::A;
    friend bool operator==(const BodyPoint&, const BodyPoint&) = default;
};

struct AskedValue {
    Quantity quantity = Quantity::p;
    std::size_t k = 0;                   ///< order of a coefficient; number of terms
    Edge edge = Edge::right;             ///< unless Place::contact
    std::optional<Exact> u = {};         ///< for Place::point
    std::optional<Exact> tolerance = {}; ///< if the row has `tolerance`
    std::optional<Distance> place = {}; ///< used instead of u, if the distance depends on the edges
    std::size_t j = 0;                  ///< the index of a crossing
    std::optional<BodyPoint> in_body = {};  ///< for Place::body; of Place::surface the body
    std::optional<Distance> reference = {}; ///< for Place::surface, the place without displacement

    [[nodiscard]] Distance distance() const { return place ? *place : Distance(*u); }
};

/// What differs from row to row of the quantities, and mostly has these values.
struct QuantityOptions {
    /// The meaning of k of an AskedValue.
    enum class Index { none, order, terms };
    enum class Needs {
        nothing,
        shear,
        friction,
        friction_alone,
        cycle,
        reference,
        history,
        unknown_tilt,
        poisson,
        plane,
        round
    };
    Index index = Index::none;
    Needs needs = Needs::nothing;
    bool tolerance = false; ///< the quantity depends on a tolerance
    /// The explanation after the symbol in the notes of a table; empty: the tables explain the
    /// symbol themselves.
    std::string_view meaning = {};
    /// The name in messages, and of the column of a quantity without a symbol (without the index).
    std::string_view label = {};
    /// The value, if the scene gives it; otherwise null.
    const Exact* (*given)(const Scene&) = nullptr;
    /// The edge whose distance from the origin the quantity is.
    std::optional<Edge> distance_of = {};
    bool cancels_little = false; ///< fewer bits suffice at first
    /// The value comes from a search (SceneValues::search) instead of an evaluator.
    bool searched = false;
    bool short_error = false;    ///< a relative error: see digits_of()
    bool may_be_missing = false; ///< a failure to find the value leaves it out; it is no error
};

struct QuantityRow : QuantityOptions {
    /// The places of the values: one per contact, one at each edge, one at each point of the
    /// contact, one at each point of a body, one at each place x of the surface.
    enum class Place { contact, edge, point, body, surface };

    Quantity quantity;
    /// The name in recipes, questions, answers and headers of columns, without the index ("c" of
    /// c_1); empty: the quantity has no name there.
    std::string_view symbol;
    std::string_view name; ///< in words, as in files of hard cases
    QuantityGroup group;
    Place place;
    /// The unit is force per length to the power force_power, times length to the power
    /// length_power; for a coefficient of order k, also times length^(-k).
    int force_power;
    double length_power;

    // The evaluators; null for a quantity that is searched for. A level computes the value at more
    // and more bits until it has its digits; a ball that is not finite means that the bits do not
    // suffice. Without an exact form, no number of bits may decide the rounding of a value on a
    // limit; such a value is printed as its enclosure.
    Ball (*ball)(BallLevel&, const AskedValue&);
    Form (*exact)(ExactValues&, const AskedValue&);
    /// The name of the route of a value in balls; `route_by` if it depends on the scene.
    const char* route;
    const char* (*route_by)(const Scene&);

    [[nodiscard]] const char* route_in(const Scene& scene) const {
        return route_by != nullptr ? route_by(scene) : route;
    }
    [[nodiscard]] bool of_friction() const {
        return needs == Needs::friction || needs == Needs::friction_alone ||
               needs == Needs::cycle || needs == Needs::history;
    }
    /// True if the quantity needs [shear] of the scene; plans of other quantities leave it out.
    [[nodiscard]] bool of_shear() const { return needs == Needs::shear || of_friction(); }
    [[nodiscard]] bool at_point() const { return place == Place::point; }
    [[nodiscard]] bool at_edge() const { return place == Place::edge || at_point(); }
    /// True for a quantity at a point of a body or of the surface.
    [[nodiscard]] bool of_bodies() const { return place == Place::body || place == Place::surface; }
};

[[nodiscard]] std::span<const QuantityRow> quantity_rows();
[[nodiscard]] const QuantityRow& row_of(Quantity quantity);

/// The digits of a quantity where these are asked for: 20 at most of a relative error.
[[nodiscard]] Digits digits_of(Quantity quantity, const Digits& asked);
/// The value outside the contact: 0 of p and q; nothing for other quantities.
[[nodiscard]] std::optional<BoundedValue> value_outside(Quantity quantity, long bits);

struct NamedQuantity {
    Quantity quantity = Quantity::p;
    std::size_t k = 0;
};
/// Reads "p", "c_0", "alpha", "extent_1", ... Returns nothing for other names, for k > 399 and for
/// zero terms.
[[nodiscard]] std::optional<NamedQuantity> quantity_named(std::string_view symbol);
/// Reads the name of a column of a table, too: "rel_2", "s1", "load_ratio".
[[nodiscard]] std::optional<NamedQuantity> column_named(std::string_view name);
/// The inverse of quantity_named: "p", "c_0", ...
[[nodiscard]] std::string symbol_of(const AskedValue& asked);
/// The name for all orders or numbers of terms: "c_k".
[[nodiscard]] std::string family_of(const AskedValue& asked);
/// For messages: "p at u = 1e-40 from the right edge", "c_1 at the left edge".
[[nodiscard]] std::string text_of(const AskedValue& asked);
/// Advice for an unknown name: "did you mean c_1? write p, q, c_0, c_1, ..., or measure_1".
[[nodiscard]] std::string quantity_advice(std::string_view name);

/// The scale for errors of a value of that kind that is zero itself, in a contact of that force and
/// length.
[[nodiscard]] double scale_of(const AskedValue& asked, double force, double length);

/// The data that a scene lacks for a quantity, and what to write instead.
struct Lack {
    std::string problem;
    std::string instead;
};
[[nodiscard]] std::optional<Lack> lack_of(const Scene& scene, const AskedValue& asked);

/// A row of the groups: the data that a scene must give for it, in addition to the effects.
struct GroupRow {
    QuantityGroup group;
    std::string_view name; ///< as in a scene file
    bool points = false;
    bool shear = false;
    bool friction = false;
    bool terms = false;
    bool tolerance = false;
    std::string_view incomplete = {}; ///< the message if terms or tolerance are not given
    std::string_view instead = {};
};
[[nodiscard]] std::span<const GroupRow> group_rows();
/// The effect that a scene lacks for a group.
[[nodiscard]] std::optional<Lack> lack_of(const Scene& scene, const GroupRow& group);
[[nodiscard]] std::string group_name(QuantityGroup group);

[[nodiscard]] std::string edge_name(Edge edge);
[[nodiscard]] std::optional<Edge> edge_named(std::string_view name);
/// The same, but throws InputError for other names than right and left.
[[nodiscard]] Edge edge_of(std::string_view name);
/// Reads A or B. Throws InputError for other names.
[[nodiscard]] Body body_named(std::string_view name);

} // namespace edgeproof::scene
