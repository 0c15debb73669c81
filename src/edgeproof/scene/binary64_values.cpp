// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/binary64_values.hpp"

#include "edgeproof/contact/double_word/double_word_expansion.hpp"
#include "edgeproof/contact/double_word/double_word_shear.hpp"
#include "edgeproof/contact/slip/ball_slip.hpp"
#include "edgeproof/contact/tilt/tilt_solver.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/rational.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/scene/input/readers.hpp"
#include "edgeproof/scene/run_scene.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace edgeproof::scene {

namespace {

template <class... Rest> ClosedFormContact contact_of(Profile profile, Rest... rest) {
    return {profile, [profile, rest...](long bits) { return BallContact(profile, rest..., bits); }};
}

using contact::DoubleWordPressure;

/// A quantity at the distance u from an edge, in double words.
using InWords = std::function<DoubleWord(Edge, const DoubleWord&)>;

constexpr long word_bits = DoubleWordPressure::contact_bits;
constexpr unsigned first_digits = 25;
constexpr unsigned most_digits = 800; ///< 1 - p_n/p cancels near an edge

contact::DoubleWordShear shear_in_words(const Scene& scene, const ClosedFormContact& closed,
                                        const BallContact& solved) {
    const ShearSpec& shear = *scene.shear;
    const contact::ShearLoad<Ball> load{ball_of(shear.Q, word_bits),
                                        ball_of(shear.bulk_tension, word_bits)};
    if (scene.slips()) {
        const auto zones = closed_form_zones(solved);
        const Ball friction = ball_of(*shear.friction, word_bits);
        const contact::BallSlip slip(solved, *zones, solved.force(), load, friction);
        if (slip.sliding()) {
            throw DomainError("the contact slides");
        }
        return contact::DoubleWordShear::partial_slip(closed.profile, solved, slip.stick(),
                                                      friction * shear.Q.sign());
    }
    return scene.together() ? contact::DoubleWordShear::similar({closed.profile, solved},
                                                                load.Q / solved.force())
                            : contact::DoubleWordShear::full_stick(solved, load);
}

/// Returns nothing if the quantity has no formula in double words.
InWords in_words(const Scene& scene, const Binary64Question& question,
                 const ClosedFormContact& closed, const BallContact& solved) {
    const bool has_form = DoubleWordPressure::has_form(closed.profile);
    if (question.quantity == Quantity::q) {
        // The form for partial slip is that of one step of Q in the plane.
        const bool other_slip = scene.slips() && (scene.history || scene.round);
        if (!scene.shear || other_slip || (!has_form && (scene.slips() || scene.together()))) {
            return {};
        }
        return [words = shear_in_words(scene, closed, solved)](Edge edge, const DoubleWord& u) {
            return words.at(edge, u);
        };
    }
    if (question.quantity == Quantity::local) {
        return [words = contact::DoubleWordSum(solved, question.edge, question.n)](
                   Edge, const DoubleWord& u) { return words.at(u); };
    }
    if (!has_form) {
        return {};
    }
    if (question.quantity == Quantity::rel) {
        return [words = contact::DoubleWordRelativeError(closed.profile, solved, question.edge,
                                                         question.n)](Edge, const DoubleWord& u) {
            return words.at(u);
        };
    }
    return [words = DoubleWordPressure(closed.profile, solved)](Edge edge, const DoubleWord& u) {
        return words.at(edge, u);
    };
}

class Values {
public:
    Values(const Scene& scene, const Binary64Question& question)
        : scene_(scene), question_(question) {
        scene_.ask = {};
        scene_.ask.edges = {question.edge};
        scene_.ask.quantities = {QuantityGroup::contact};
        const SceneResult found = run_scene(scene_); // refuses a load that no contact carries
        for (const auto& [end, quantity] :
             {std::pair{&right_, Quantity::a}, {&left_, Quantity::b}}) {
            const BoundedValue& value = found.at(quantity);
            *end = {value.exactly ? Ball(*value.exactly, word_bits) : value.value, value.exactly};
        }
        scene_.ask.quantities = {question.quantity == Quantity::q ? QuantityGroup::shear
                                                                  : QuantityGroup::pressure};
        if (question.n > 0) {
            scene_.ask.terms = {question.n};
        }
        try {
            if (const auto closed = closed_form_contact(scene_, 2 * word_bits)) {
                profile_ = closed->profile;
                const BallContact solved = closed->at(word_bits);
                words_ = in_words(scene_, question_, *closed, solved);
            }
        } catch (const BudgetError&) {
            words_ = {}; // run_scene has more bits
        } catch (const DomainError&) {
            words_ = {}; // run_scene refuses it
        }
    }

    void operator()(std::span<const double> places, std::span<double> values) {
        std::vector<std::size_t> left;
        for (std::size_t i = 0; i < places.size(); ++i) {
            check_interruption();
            if (std::isnan(places[i])) {
                throw DomainError("a place is not a number");
            }
            if (const auto value = at_once(places[i])) {
                values[i] = *value;
            } else {
                left.push_back(i);
            }
        }
        for (unsigned digits = first_digits; !left.empty(); digits *= 2) {
            if (digits > most_digits) {
                throw BudgetError("the binary64 nearest to the value is undecided at " +
                                  name(places[left.front()]));
            }
            left = computed(places, values, left, digits);
        }
    }

private:
    struct End {
        Ball distance; ///< of the edge from the origin
        std::optional<Rational> exactly;
    };

    [[nodiscard]] const End& end(Edge edge) const { return edge == Edge::right ? right_ : left_; }
    [[nodiscard]] bool is_traction() const {
        return question_.quantity == Quantity::p || question_.quantity == Quantity::q;
    }
    [[nodiscard]] std::string name(double place) const {
        return (question_.from_origin ? "x = " : "u = ") + exact_text(exact_rational(place));
    }
    /// Returns the distance of a place from an edge, exactly if the edges are known.
    [[nodiscard]] std::optional<Rational> exact_distance(Edge edge, double place) const {
        const auto& a = end(question_.from_origin ? edge : question_.edge).exactly;
        const Rational q = exact_rational(place);
        if (question_.from_origin) {
            return !a                    ? std::nullopt
                   : edge == Edge::right ? std::optional(Rational(*a - q))
                                         : std::optional(Rational(*a + q));
        }
        if (edge == question_.edge) {
            return q;
        }
        return right_.exactly && left_.exactly
                   ? std::optional(Rational(*right_.exactly + *left_.exactly - q))
                   : std::nullopt;
    }
    [[nodiscard]] Ball distance(Edge edge, double place) const {
        const Ball q(exact_rational(place), word_bits);
        if (question_.from_origin) {
            return edge == Edge::right ? Ball(right_.distance - q) : Ball(left_.distance + q);
        }
        return edge == question_.edge ? q : Ball(right_.distance + left_.distance - q);
    }
    /// True if the quantity is 0 at the edges: p, and q unless all sticks.
    [[nodiscard]] bool is_zero_at_edges() const {
        return question_.quantity == Quantity::p || scene_.slips() || scene_.together();
    }
    /// True if p or q is certainly 0: outside the contact or on its edge.
    [[nodiscard]] bool outside(double place) const {
        if (!std::isfinite(place)) {
            return true;
        }
        for (const Edge edge : {Edge::right, Edge::left}) {
            const auto exactly = exact_distance(edge, place);
            const bool on_edge = exactly && *exactly == 0;
            if (on_edge ? is_zero_at_edges() : certainly_negative(distance(edge, place))) {
                return true;
            }
        }
        return false;
    }
    [[nodiscard]] bool on_corner(double x) const {
        for (std::size_t i = 0; profile_ && i < profile_->knots().size(); ++i) {
            const auto knot = rational_of(profile_->knots()[i]);
            if (profile_->has_corner(i) && knot && *knot == exact_rational(x)) {
                return true;
            }
        }
        return false;
    }
    [[nodiscard]] std::optional<double> at_once(double place) const {
        if (!std::isfinite(place) || (is_traction() && outside(place))) {
            if (!is_traction()) {
                throw InputError("a place is infinite", "give places of the contact");
            }
            return 0;
        }
        if (question_.quantity == Quantity::p && question_.from_origin && !scene_.punch &&
            on_corner(place)) {
            return std::numeric_limits<double>::infinity();
        }
        if (!words_) {
            return {};
        }
        // p and q are the same from both edges; the nearer one loses fewer digits.
        const Edge edge = question_.from_origin && is_traction()
                              ? (place < 0 ? Edge::left : Edge::right)
                              : question_.edge;
        const DoubleWord u = to_double_word(distance(edge, place));
        const auto nearest = nearest_binary64(words_(edge, u));
        return nearest && std::isfinite(*nearest) ? std::optional(*nearest + 0.0) : std::nullopt;
    }
    /// Computes the values at these indices by the routes of the scene; returns the indices whose
    /// binary64 these digits do not decide.
    [[nodiscard]] std::vector<std::size_t> computed(std::span<const double> places,
                                                    std::span<double> values,
                                                    const std::vector<std::size_t>& indices,
                                                    unsigned digits) {
        scene_.ask.u.clear();
        for (const std::size_t i : indices) {
            const Exact place = Exact::of(exact_rational(places[i]));
            AskedPoint point{place};
            if (question_.from_origin) {
                point.place = Place::parse(place.text(), Place::From::origin, names_of(scene_));
            }
            scene_.ask.u.push_back(std::move(point));
        }
        scene_.ask.digits = {digits, Rounding::nearest, true};
        const SceneResult result = run_scene(scene_);
        std::vector<std::size_t> undecided;
        for (const RowsAt& at : result.points()) {
            const std::size_t i = indices[at.point()];
            if (const auto nearest = nearest_of(at, digits)) {
                values[i] = *nearest + 0.0;
            } else {
                undecided.push_back(i);
            }
        }
        return undecided;
    }
    [[nodiscard]] std::optional<double> nearest_of(const RowsAt& at, unsigned digits) const {
        if (question_.quantity == Quantity::rel) { // the row has only a few digits
            const Ball sum = at.at(Quantity::local, question_.n).value;
            return nearest_binary64(abs(1 - sum / at.at(Quantity::p).value));
        }
        return printed(at.at(question_.quantity, question_.n), {digits, Rounding::nearest, true})
            .binary64;
    }

    Scene scene_;
    Binary64Question question_;
    End right_;
    End left_;
    std::optional<Profile> profile_;
    InWords words_;
};

} // namespace

std::optional<ClosedFormContact> closed_form_contact(const Scene& scene, long tilt_bits) {
    if (scene.punch) {
        contact::EnclosedTilt tilt = enclose_tilt(*scene.punch, scene.contact_modulus,
                                                  scene.load.value, *scene.moment, tilt_bits);
        return tilt.exactly_zero
                   ? contact_of(std::move(tilt.near), scene.contact_modulus, scene.load)
                   : contact_of(std::move(tilt.near), tilt.alpha, scene.contact_modulus,
                                scene.load);
    }
    if (scene.profile->axisymmetric() || !BallContact::has_closed_form(*scene.profile)) {
        return {};
    }
    return contact_of(*scene.profile, scene.contact_modulus, scene.load);
}

void compute_binary64(const Scene& scene, const Binary64Question& question,
                      std::span<const double> places, std::span<double> values) {
    const bool has_terms = row_of(question.quantity).index == QuantityRow::Index::terms;
    if (has_terms && question.n == 0) {
        throw InputError("terms = 0 is out of range", "give 1 or more");
    }
    if (question.quantity == Quantity::p && !question.from_origin) {
        const Binary64Pressures pressures(scene);
        pressures(question.edge, places, values);
        return;
    }
    if (question.quantity == Quantity::q) {
        if (const auto lack = lack_of(scene, AskedValue{Quantity::q})) {
            throw InputError(lack->problem, lack->instead);
        }
    }
    Values(scene, question)(places, values);
}

} // namespace edgeproof::scene
