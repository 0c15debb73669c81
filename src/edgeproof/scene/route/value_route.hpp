// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/enclosure/ball_extent.hpp"
#include "edgeproof/contact/witness/witness.hpp"
#include "edgeproof/scene/route/ball_level.hpp"
#include "edgeproof/scene/route/exact_values.hpp"
#include "edgeproof/scene/route/rows.hpp"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace edgeproof::scene {

/// Computes a scene's values in balls of more and more bits until they can be printed, each with
/// its error and the name of the route, and counts the work. One object belongs to one thread. Its
/// parts:
///   value_route.cpp    single values, the places of edges and points, the work; the levels of
///                      bits, and the exact forms
///   ball_searches.cpp  extents, partial slip
///   refusals.cpp       the reasons why there is no value
class ValueRoute {
public:
    /// Keeps references to all three arguments.
    ValueRoute(const Scene& scene, const Plan& plan, Work& work);

    /// Throws the reason why no contact is enclosed.
    [[noreturn]] void refuse_contact() const;
    /// Throws InputError unless g' is proved not to decrease in the contact; all proofs for a
    /// curved profile depend on this.
    void check_slope();

    /// One number, by the evaluators of its row (quantity.hpp); the plan must contain it. Throws
    /// DomainError if there is no value (outside the contact, on a corner); InputError, with the
    /// line of the friction, for a value of the slip if the contact slides or if the stick zone
    /// would extend beyond it.
    [[nodiscard]] BoundedValue value(const AskedValue& asked);
    /// For a scene with friction.
    [[nodiscard]] contact::SlipState state(Edge edge, const Distance& u);
    /// The rows of a search for a quantity with `searched`, with the edge and the number of terms
    /// of `asked`. Extents: the first exit, the measure, both as fractions of a + b, and all
    /// crossings, for the tolerance of the scene. Slip zones: the size by these terms, the error,
    /// and with a tolerance the load ratio up to which the error stays within it.
    [[nodiscard]] std::vector<Row> search(const AskedValue& asked);
    /// True if |sigma_0 (a + b)/Q| < 8/pi: both edges slip in the direction of Q from the beginning
    /// of loading if Q and sigma_0 grow in proportion.
    [[nodiscard]] bool in_proportion();
    /// The row of a quantity with `searched`. The search at each place is made once.
    [[nodiscard]] const Row& searched(const AskedValue& asked);

private:
    using InBalls = std::function<Ball(BallLevel&)>;
    using Exactly = std::function<ExactNumber(ExactValues&)>;

    /// A value, and its exact value if that is a rational number and was searched for.
    struct Found {
        Ball value;
        std::optional<Rational> exactly = {};
    };
    /// Evaluates f at more and more bits (starting from `first`) until the value has its digits, or
    /// is zero to 1e-400 and `lost` more bits (at least lost_bits_), or the bits are used up.
    /// Returns nothing if the value is not finite. If the ball is narrow enough but does not round
    /// to one number, more bits cannot help when the value lies exactly on the limit, so the exact
    /// form (if there is one) is tried first.
    [[nodiscard]] std::optional<Found> refine(const InBalls& f, const Exactly& exactly,
                                              const Digits& digits, long first, long lost = 0);
    /// The rational number given by the exact form of the value, if it is known to be rational.
    [[nodiscard]] std::optional<Rational> exact_value(const Exactly& exactly,
                                                      const BallLevel& level, const Ball& near);
    /// Made on first use. Null under a tilt that was solved for and is not zero.
    [[nodiscard]] ExactValues* exact_values(const BallLevel& level);
    /// Null if these bits do not isolate the edges.
    [[nodiscard]] BallLevel* at_level(long bits);
    [[nodiscard]] long last_bits() const;
    [[nodiscard]] bool closed() const { return plan_.closed; }

    /// The distance of an edge from the origin, if it is known to be a rational number.
    [[nodiscard]] std::optional<Rational> known(Edge edge) const;
    /// Stores that distance.
    void know(Edge edge);
    /// True if a value is proved to be 0 by its definition, where a ball would only contain 0.
    [[nodiscard]] bool exactly_zero(const AskedValue& asked);
    /// True if a place, by its distance from the right edge, is proved to be an edge.
    [[nodiscard]] bool on_edge(const Distance& from_right);
    /// Throws OutsideContact for a point outside the contact, and DomainError for one on an edge or
    /// a place given by the edges that many bits do not separate from a corner.
    void refuse_outside(Edge edge, const Distance& u);
    void refuse_outside_by_edges(Edge edge, const Distance& u);
    /// If x is a number, exact algebra decides.
    void refuse_corner_at(const Distance& u) const;
    /// The same for a distance from an edge that is known exactly.
    void refuse_known_corner(Edge edge, const Distance& u);
    /// Throws an Error with the reason why no number of bits encloses a value.
    [[noreturn]] void refuse_unknown(const QuantityRow& row, const AskedValue& asked);
    /// p by the second route of the scene, with its estimated error.
    [[nodiscard]] BoundedValue by_witness(const AskedValue& asked);
    /// The coordinate x of the point u, which is inside the contact, if it is known to be a
    /// rational number.
    [[nodiscard]] std::optional<Rational> known_x(Edge edge, const Distance& u) const;

    /// Counts the work of a value.
    void count(const AskedValue& asked);
    void count_pressure() {
        ++(closed() && !scene_.ask.route ? work_.counts.closed_forms : work_.counts.quadratures);
    }

    /// The rows of an extent, proved by the signs of the error between the crossings. Throws
    /// BudgetError if the budget does not decide.
    [[nodiscard]] std::vector<Row> extent(const AskedValue& asked);
    /// The exact values of those results of an extent that are rational numbers.
    struct ExactExtents {
        std::optional<Rational> length;
        std::optional<Rational> first_exit;
        std::optional<Rational> measure;
        std::vector<std::optional<Rational>> crossings;
    };
    [[nodiscard]] ExactExtents exact_extents(const AskedValue& asked,
                                             const contact::EnclosedExtents& found,
                                             const BallLevel& level);
    /// Returns the crossing in a ball that contains one, if the error there is exactly the
    /// tolerance.
    [[nodiscard]] std::optional<Rational> exact_crossing(const AskedValue& asked, const Ball& u,
                                                         const BallLevel& level);

    /// Throws InputError, with the line of its cause, if the contact slides or the stick zone would
    /// extend beyond it.
    void check_slip();
    /// Refuses |Q| = f P, decided by the exact form of P.
    void refuse_exactly_sliding(const BallLevel& level);
    /// The rows of a slip zone by the first terms. Throws BudgetError if no number of bits encloses
    /// the slip.
    [[nodiscard]] std::vector<Row> slip_terms(const AskedValue& asked);
    /// The bits lost by cancellation when n + 1 powers of the load ratio are compared with 1.
    [[nodiscard]] long lost_by(std::size_t n) const;
    /// Sets the value of the row of a slip load, if it is found.
    void find_reach(Row& row);

    const Scene& scene_;
    const Plan& plan_;
    Work& work_;
    std::map<long, std::unique_ptr<BallLevel>> levels_;
    std::optional<contact::ExactEdges> edges_; ///< if a level proved them
    std::optional<ExactValues> exact_;
    long lost_bits_ = 0; ///< by the cancellation in values of the slip

    std::optional<Ball> length_; ///< a + b; empty if no number of bits isolates the edges
    std::optional<Rational> known_length_;
    std::map<Edge, Rational> known_;

    bool slip_checked_ = false;
    BallLevel* slip_level_ = nullptr; ///< a level that encloses the slip

    std::set<std::pair<Edge, bool>> expanded_;
    /// The place of the last pressure, for q.
    std::optional<std::pair<Edge, Distance>> pressed_;
    std::optional<contact::Witness> witness_;
    std::optional<std::string> no_contact_; ///< why a level found no contact
    std::map<std::tuple<QuantityGroup, Edge, std::size_t>, std::vector<Row>> searched_;
};

/// Makes the route of a plan, in balls with proved values (BallContact, IntegratedContact,
/// shear.hpp): more and more bits until each value rounds correctly. p is an estimate by
/// Plan::witness where the scene asks for that. Keeps references to all three arguments. Throws
/// InputError, with its line, if no contact carries the load, and if g' is not proved to rise in
/// the contact; BudgetError where no number of bits tried encloses a value.
[[nodiscard]] std::unique_ptr<ValueRoute> make_route(const Scene& scene, const Plan& plan,
                                                     Work& work);

} // namespace edgeproof::scene
