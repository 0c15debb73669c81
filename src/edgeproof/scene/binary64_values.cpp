// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/scene/binary64_values.hpp"

#include "edgeproof/contact/double_word/double_word_pressure.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/rational.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/scene/input/readers.hpp"
#include "edgeproof/scene/run_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace edgeproof::scene {
namespace {

using contact::DoubleWordPressure;

/// The numbers of such balls fit into two words, which need no heap memory.
constexpr long first_bits = 128;
constexpr long most_bits = 4096; ///< for places near the far edge and near corners
constexpr unsigned first_digits = 25;
constexpr unsigned most_digits = 800; ///< 1 - p_n/p cancels near an edge

std::optional<double> nearest(const Ball& x) {
    return x.is_finite() ? nearest_binary64(x) : std::nullopt;
}

} // namespace

class Binary64Values::Contact {
public:
    Contact(const Scene& scene, const Binary64Question& question)
        : scene_(scene), question_(question) {
        scene_.ask = {};
        scene_.ask.quantities = {QuantityGroup::contact};
        const SceneResult found = run_scene(scene_); // refuses a load that no contact carries
        for (const auto& [edge, quantity] :
             {std::pair{Edge::right, Quantity::a}, {Edge::left, Quantity::b}}) {
            end_[index_of(edge)] = {found.at(quantity).value, found.at(quantity).exactly};
        }
        profile_ = scene_.profile;
        if (question_.quantity != Quantity::p || !scene_.closed()) {
            return;
        }
        balls_ = at_bits(first_bits);
        if (scene_.punch) {
            profile_ = BallLevel(scene_, 2 * first_bits).tilt().near;
        }
        const bool form = balls_ && DoubleWordPressure::has_form(*profile_);
        if (const auto closer = form ? at_bits(DoubleWordPressure::contact_bits) : balls_;
            form && closer) {
            words_.emplace(*profile_, *closer);
        }
    }

    [[nodiscard]] double at(Edge edge, double place) const {
        if (std::isnan(place)) {
            throw DomainError("a place is not a number");
        }
        if (words_ && std::isfinite(place)) {
            const DoubleWord u = question_.from_origin
                                     ? to_double_word(distance(nearer(edge, place), place,
                                                               DoubleWordPressure::contact_bits))
                                     : DoubleWord{place, 0, 0};
            const auto value = nearest_binary64(words_->at(nearer(edge, place), u));
            if (value && std::isfinite(*value)) {
                return *value + 0.0;
            }
        }
        if (!std::isfinite(place) || outside(edge, place)) {
            if (!is_traction()) {
                throw InputError("a place is outside the contact", "give places of the contact");
            }
            return 0;
        }
        if (question_.quantity == Quantity::p) {
            if (on_corner(edge, place)) {
                return std::numeric_limits<double>::infinity();
            }
            if (const auto value = by_balls(edge, place)) {
                return *value;
            }
        }
        return in_full(edge, place);
    }

private:
    struct End {
        Ball distance; ///< of the edge from the origin
        std::optional<Rational> exactly;
    };

    /// The contact of p; nothing where these bits do not separate an edge from a corner.
    [[nodiscard]] std::optional<BallContact> at_bits(long bits) const {
        try {
            return *BallLevel(scene_, bits).contact().closed_form();
        } catch (const BudgetError&) {
            return {};
        }
    }
    [[nodiscard]] bool is_traction() const {
        return question_.quantity == Quantity::p || question_.quantity == Quantity::q;
    }
    /// True for q under full stick; p and every other q are 0 at the edges.
    [[nodiscard]] bool is_infinite_at_edges() const {
        return question_.quantity == Quantity::q && !scene_.slips() && !scene_.proportional();
    }
    /// p is the same from both edges; the nearer one loses fewer digits.
    [[nodiscard]] Edge nearer(Edge edge, double place) const {
        return !question_.from_origin ? edge : place < 0 ? Edge::left : Edge::right;
    }
    /// Returns the distance of a place from an edge `to`, if the contact has these edges.
    template <class Number>
    [[nodiscard]] Number distance(Edge to, Edge edge, const Number& place, const Number& a,
                                  const Number& b) const {
        if (question_.from_origin) {
            return to == Edge::right ? Number(a - place) : Number(b + place);
        }
        return to == edge ? place : Number(a + b - place);
    }
    [[nodiscard]] Ball distance(Edge edge, double place, long bits) const {
        return distance(edge, edge, Ball(exact_rational(place), bits), end_[0].distance,
                        end_[1].distance);
    }
    [[nodiscard]] std::optional<Rational> exact_distance(Edge to, Edge edge, double place) const {
        const auto& [a, b] = std::pair(end_[0].exactly, end_[1].exactly);
        if (!question_.from_origin && to == edge) {
            return exact_rational(place);
        }
        const bool known = question_.from_origin ? end_[index_of(to)].exactly.has_value() : a && b;
        return known ? std::optional(
                           distance(to, edge, exact_rational(place), a.value_or(0), b.value_or(0)))
                     : std::nullopt;
    }
    /// True if the place is certainly outside the contact, or on an edge where q is finite.
    [[nodiscard]] bool outside(Edge edge, double place) const {
        return std::ranges::any_of(std::array{Edge::right, Edge::left}, [&](Edge to) {
            if (const auto exactly = exact_distance(to, edge, place)) {
                return *exactly < 0 || (*exactly == 0 && !is_infinite_at_edges());
            }
            return certainly_negative(distance(to, edge, Ball(exact_rational(place), first_bits),
                                               end_[0].distance, end_[1].distance));
        });
    }
    /// Decides only where the edge is known exactly; elsewhere more bits have to separate a place
    /// from a corner.
    [[nodiscard]] bool on_corner(Edge edge, double place) const {
        for (std::size_t i = 0; i < profile_->knots().size(); ++i) {
            const auto knot = rational_of(profile_->knots()[i]);
            const auto u = exact_distance(edge, edge, place);
            const auto& end = end_[index_of(edge)].exactly;
            if (profile_->has_corner(i) && knot && u && end &&
                *u == (edge == Edge::right ? Rational(*end - *knot) : Rational(*end + *knot))) {
                return true;
            }
        }
        return false;
    }
    [[nodiscard]] std::optional<double> pressure(const BallContact& contact, Edge edge,
                                                 double place) const {
        const Edge from = nearer(edge, place);
        const Ball u = distance(from, edge, Ball(exact_rational(place), contact.bits()),
                                contact.a(), contact.b());
        return certainly_less(u, Ball(contact.a() + contact.b()))
                   ? nearest(contact.pressure(from, u))
                   : std::nullopt;
    }
    /// Returns p by a closed form at more and more bits. A place that no number of them separates
    /// from an edge or from a corner is taken to be on it; nothing for any other that is undecided.
    [[nodiscard]] std::optional<double> by_balls(Edge edge, double place) const {
        bool is_inside = true;
        bool on_corner = false;
        for (long bits = first_bits; scene_.closed() && bits <= most_bits; bits *= 2) {
            const auto closer = bits == first_bits ? balls_ : at_bits(bits);
            if (!closer) {
                continue;
            }
            if (const auto value = pressure(*closer, edge, place)) {
                return value;
            }
            const Edge from = nearer(edge, place);
            const Ball u =
                distance(from, edge, Ball(exact_rational(place), bits), closer->a(), closer->b());
            is_inside = certainly_positive(u) && certainly_less(u, Ball(closer->a() + closer->b()));
            on_corner = is_inside && std::ranges::any_of(closer->corners(from), [&](const Ball& x) {
                            return overlaps(x, u);
                        });
        }
        return on_corner   ? std::optional(std::numeric_limits<double>::infinity())
               : is_inside ? std::nullopt
                           : std::optional(0.0);
    }

    /// Computes one value by the route of the scene.
    [[nodiscard]] double in_full(Edge edge, double place) const {
        const Exact exact = Exact::of(exact_rational(place));
        AskedValue asked{
            .quantity = question_.quantity, .k = question_.n, .edge = edge, .u = exact};
        if (question_.from_origin) {
            asked.u.reset();
            asked.place =
                Place::parse(exact.text(), Place::From::origin, names_of(scene_)).distance(edge);
        }
        const std::string name = (question_.from_origin ? "x = " : "u = ") + exact.text();
        try {
            std::size_t level = 0;
            for (unsigned digits = first_digits; digits <= most_digits; digits *= 2) {
                if (const auto value = to_digits(asked, digits, level++)) {
                    return *value + 0.0;
                }
            }
        } catch (const DomainError& error) {
            throw InputError(name + ": " + error.what(),
                             "give places of the contact, off every corner");
        }
        throw BudgetError("the binary64 nearest to " +
                          std::string(row_of(question_.quantity).name) + " is undecided at " +
                          name);
    }
    [[nodiscard]] std::optional<double> to_digits(const AskedValue& asked, unsigned digits,
                                                  std::size_t level) const {
        const Digits format{digits, Rounding::nearest, true};
        // The row of rel has only a few digits.
        const bool is_error = question_.quantity == Quantity::rel;
        AskedValue first = asked;
        AskedValue second = asked;
        first.quantity = is_error ? Quantity::local : asked.quantity;
        second.quantity = Quantity::p;
        if (levels_.size() == level) {
            levels_.push_back(std::make_unique<SceneValues>(
                scene_, is_error ? std::vector{first, second} : std::vector{first}, format));
        }
        SceneValues& values = *levels_[level];
        if (is_error) {
            return nearest(abs(1 - values.value(first).value / values.value(second).value));
        }
        return printed(values.value(first), format).binary64;
    }

    Scene scene_;
    Binary64Question question_;
    std::array<End, 2> end_;
    std::optional<Profile> profile_;
    std::optional<BallContact> balls_;        ///< the contact of p at first_bits
    std::optional<DoubleWordPressure> words_; ///< decides nearly all places
    /// Decide the others, each to twice the digits of the one before.
    mutable std::vector<std::unique_ptr<SceneValues>> levels_;
};

Binary64Values::Binary64Values(const Scene& scene, const Binary64Question& question) {
    const QuantityRow& row = row_of(question.quantity);
    require(row.index != QuantityRow::Index::terms || question.n > 0, "terms = 0 is out of range",
            "give 1 or more");
    if (const auto lack = lack_of(scene, AskedValue{question.quantity})) {
        throw InputError(lack->problem, lack->instead);
    }
    contact_ = std::make_unique<Contact>(scene, question);
}
Binary64Values::~Binary64Values() = default;
Binary64Values::Binary64Values(Binary64Values&&) noexcept = default;
Binary64Values& Binary64Values::operator=(Binary64Values&&) noexcept = default;

double Binary64Values::operator()(Edge edge, double place) const {
    return contact_->at(edge, place);
}

void Binary64Values::operator()(Edge edge, std::span<const double> places,
                                std::span<double> values) const {
    for (std::size_t i = 0; i < places.size(); ++i) {
        check_interruption();
        values[i] = (*this)(edge, places[i]);
    }
}

} // namespace edgeproof::scene
