// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/enclosure/ball_extent.hpp"
#include "edgeproof/contact/witness/witness.hpp"
#include "edgeproof/scene/route/ball_level.hpp"
#include "edgeproof/scene/route/exact_values.hpp"
#include "edgeproof/scene/route/plan.hpp"
#include "edgeproof/scene/route/rows.hpp"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace edgeproof::scene {

/// A solved scene that answers: it computes values in balls of more and more bits until they can be
/// printed, each with its error and the name of the route; a value with `proved` is an enclosure. p
/// is an estimate by a second route where the scene asks for that. One object belongs to one
/// thread. Its parts:
///   scene_values.cpp   single values, the places of edges and points; the levels of bits, and the
///                      exact forms
///   ball_searches.cpp  extents, partial slip
///   refusals.cpp       the reasons why there is no value
class SceneValues {
public:
    /// Solves the contact. Throws as make_plan does; InputError, with its line, if no contact
    /// carries the load, and unless g' is proved not to decrease in the contact (all proofs for a
    /// curved profile depend on this); BudgetError where no number of bits tried encloses the
    /// edges.
    explicit SceneValues(Scene scene);
    /// The same for asking(scene, values, digits).
    SceneValues(const Scene& scene, const std::vector<AskedValue>& values, const Digits& digits);
    SceneValues(const SceneValues&) = delete; // the levels refer to the scene
    SceneValues& operator=(const SceneValues&) = delete;

    [[nodiscard]] const Plan& plan() const { return plan_; }
    /// Changes the part over which extents are searched for.
    void look_at(const contact::ExtentRange& part) {
        scene_.ask.part = part;
        searched_.clear();
    }

    /// One number, by the evaluators of its row (quantity.hpp), at the place of one that the scene
    /// asks for or at another one (to the same tolerance). Throws DomainError if there is no value
    /// (outside the contact, on a corner, no first exit); InputError, with the
    /// line of the friction, for a value of the slip if the contact slides or if the stick zone
    /// would extend beyond it.
    [[nodiscard]] BoundedValue value(const AskedValue& asked);
    /// The coordinate x of an AskedValue at a point. Throws DomainError outside the contact.
    [[nodiscard]] BoundedValue x(const AskedValue& asked);
    /// For a scene with friction.
    [[nodiscard]] contact::SlipState state(Edge edge, const Distance& u);
    /// The rows of a search for a quantity with `searched`, with the edge and the number of terms
    /// of `asked`. Extents: the first exit, the measure, both as fractions of a + b, and all
    /// crossings, for the tolerance of the scene. Slip zones: the size by these terms, the error,
    /// and with a tolerance the load ratio up to which the error stays within it. The search at
    /// each place is made once.
    [[nodiscard]] const std::vector<Row>& search(const AskedValue& asked);
    /// True if |sigma_0 (a + b)/Q| < 8/pi: both edges slip in the direction of Q from the beginning
    /// of loading if Q and sigma_0 grow in proportion.
    [[nodiscard]] bool in_proportion();
    /// The row of a quantity with `searched`.
    [[nodiscard]] const Row& searched(const AskedValue& asked);
    /// Throws InputError, with the line of its cause, if the contact slides or the stick zone would
    /// extend beyond it.
    void check_slip();

    /// Calls f with levels of `bits`, 2 `bits`, ... up to `most` bits until it returns true;
    /// returns whether it did. A level whose bits do not isolate the edges is left out.
    template <class F> bool raise(long bits, long most, const F& f) {
        for (; bits <= most; bits *= 2) {
            BallLevel* const level = at_level(bits);
            if (level != nullptr && f(*level)) {
                return true;
            }
        }
        return false;
    }

private:
    using InBalls = std::function<Ball(BallLevel&)>;
    using Exactly = std::function<Form(ExactValues&)>;

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

    /// Throws the reason why no contact is enclosed.
    [[noreturn]] void refuse_contact() const;
    void solve();
    void check_slope();
    /// The distance of an edge from the origin, if it is known to be a rational number.
    [[nodiscard]] std::optional<Rational> known(Edge edge) const;
    /// True if a value is proved to be 0 by its definition, where a ball would only contain 0.
    [[nodiscard]] bool exactly_zero(const AskedValue& asked);
    /// True if a place, by its distance from the right edge, is proved to be an edge.
    [[nodiscard]] bool on_edge(const Distance& from_right);
    /// Full stick makes q infinite at the edges; else p and q are 0 there.
    [[nodiscard]] bool no_traction_at_edges() const;
    /// Throws OutsideContact for a point outside the contact, and DomainError for one on an edge or
    /// a place given by the edges that many bits do not separate from a corner.
    void refuse_outside(Edge edge, const Distance& u);
    void refuse_outside_by_edges(Edge edge, const Distance& u);
    /// Refuses a corner where exact algebra knows x.
    void refuse_corner(Edge edge, const Distance& u) const;
    /// Throws an Error with the reason why no number of bits encloses a value.
    [[noreturn]] void refuse_unknown(const QuantityRow& row, const AskedValue& asked);
    /// p by the second route of the scene, with its estimated error.
    [[nodiscard]] BoundedValue by_witness(const AskedValue& asked);

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

    /// Refuses |Q| = f P, decided by the exact form of P.
    void refuse_exactly_sliding(const BallLevel& level);
    /// The rows of a slip zone by the first terms. Throws BudgetError if no number of bits encloses
    /// the slip.
    [[nodiscard]] std::vector<Row> slip_terms(const AskedValue& asked);
    /// The bits lost by cancellation when n + 1 powers of the load ratio are compared with 1.
    [[nodiscard]] long lost_by(std::size_t n) const;
    /// Sets the value of the row of a slip load, if it is found.
    void find_reach(Row& row);

    Scene scene_;
    Plan plan_;
    std::map<long, std::unique_ptr<BallLevel>> levels_;
    std::optional<contact::ExactEdges> edges_; ///< if a level proved them
    std::optional<ExactValues> exact_;
    long lost_bits_ = 0; ///< by the cancellation in values of the slip

    BallLevel* first_ = nullptr; ///< the level of the fewest bits that enclose a + b
    Ball length_;                ///< a + b
    std::optional<Rational> known_length_;

    bool slip_checked_ = false;
    BallLevel* slip_level_ = nullptr; ///< a level that encloses the slip

    std::optional<contact::Witness> witness_;
    std::optional<std::string> no_contact_; ///< why a level found no contact
    std::map<std::tuple<QuantityGroup, Edge, std::size_t>, std::vector<Row>> searched_;
};

/// Returns the scene with a request for these values only; of its own request only `part` is kept.
/// The shear is left out if none of them needs it.
[[nodiscard]] Scene asking(const Scene& scene, const std::vector<AskedValue>& values,
                           const Digits& digits);

} // namespace edgeproof::scene
