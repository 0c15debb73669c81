// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/scene/binary64_values.hpp"

#include "edgeproof/contact/double_word/double_word_pressure.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/real.hpp"
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
constexpr long most_bits = 4096; ///< for places next to the edges
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
        a_ = found.at(Quantity::a).value;
        b_ = found.at(Quantity::b).value;
        if (question_.quantity != Quantity::p || !scene_.closed()) {
            return;
        }
        try {
            balls_ = *BallLevel(scene_, first_bits).contact().closed_form();
            const BallLevel closer(scene_, DoubleWordPressure::contact_bits);
            const Profile& profile = scene_.punch ? closer.tilt().near : *scene_.profile;
            if (DoubleWordPressure::has_form(profile)) {
                words_.emplace(profile, *closer.contact().closed_form());
            }
        } catch (const BudgetError&) { // more bits decide
        }
    }

    [[nodiscard]] double at(Edge edge, double place) const {
        if (std::isnan(place)) {
            throw DomainError("a place is not a number");
        }
        const bool far = !std::isfinite(place);
        const Edge from = nearer(edge, place);
        if (const auto value = far ? std::nullopt : by_words(from, edge, place)) {
            return *value + 0.0;
        }
        const bool traction =
            question_.quantity == Quantity::p || question_.quantity == Quantity::q;
        try {
            if (far || certainly_negative(distance(from, edge, place)) ||
                certainly_negative(distance(opposite(from), edge, place))) {
                throw OutsideContact();
            }
            return in_full(edge, place);
        } catch (const OutsideContact&) {
            require(traction, "a place is outside the contact", "give places of the contact");
            return 0;
        }
    }

private:
    /// p is the same from both edges; the nearer one loses fewer digits.
    [[nodiscard]] Edge nearer(Edge edge, double place) const {
        return !question_.from_origin ? edge : place < 0 ? Edge::left : Edge::right;
    }
    /// The distance of a place from the edge `to`, at the bits of the edges.
    [[nodiscard]] Ball distance(Edge to, Edge edge, double place) const {
        const Ball x(exact_rational(place), std::max(a_.bits(), first_bits));
        if (question_.from_origin) {
            return to == Edge::right ? a_ - x : b_ + x;
        }
        return to == edge ? x : a_ + b_ - x;
    }
    /// p by double words, and by few bits; nothing where they do not decide.
    [[nodiscard]] std::optional<double> by_words(Edge from, Edge edge, double place) const {
        if (words_) {
            const DoubleWord u = question_.from_origin ? to_double_word(distance(from, edge, place))
                                                       : DoubleWord{place, 0, 0};
            const auto value = nearest_binary64(words_->at(from, u));
            if (value && std::isfinite(*value)) {
                return value;
            }
        }
        if (!balls_) {
            return {};
        }
        const Ball u = distance(from, edge, place);
        return certainly_positive(u) && certainly_less(u, Ball(balls_->a() + balls_->b()))
                   ? nearest(balls_->pressure(from, u))
                   : std::nullopt;
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
        } catch (const OutsideContact&) {
            throw;
        } catch (const DomainError& error) {
            const auto* const place_of_p = question_.quantity == Quantity::p
                                               ? dynamic_cast<const IndistinctPlace*>(&error)
                                               : nullptr;
            if (place_of_p != nullptr) {
                return place_of_p->on_corner ? std::numeric_limits<double>::infinity() : 0;
            }
            if (question_.quantity == Quantity::p && outside(asked.distance())) {
                throw OutsideContact();
            }
            throw InputError(name + ": " + error.what(),
                             "give places of the contact, off every corner");
        }
        throw BudgetError("the binary64 nearest to " +
                          std::string(row_of(question_.quantity).name) + " is undecided at " +
                          name);
    }
    /// True if one of more and more bits shows that the place is outside.
    [[nodiscard]] bool outside(const Distance& u) const {
        return levels_.front()->raise(first_bits, most_bits, [&](const BallLevel& level) {
            const Ball from = level.distance(u);
            return certainly_negative(from) || certainly_less(level.length(), from);
        });
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
        if (question_.n > 0 && level == 0) { // sums of terms have values outside, too
            AskedValue at = asked;
            at.quantity = Quantity::x;
            (void)values.value(at);
        }
        if (is_error) {
            return nearest(abs(1 - values.value(first).value / values.value(second).value));
        }
        const BoundedValue value = values.value(first);
        return value.exactly ? nearest_binary64(*value.exactly) : nearest(value.value);
    }

    Scene scene_;
    Binary64Question question_;
    Ball a_;
    Ball b_;
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
