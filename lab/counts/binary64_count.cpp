// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/counts/binary64_count.hpp"

#include "edgeproof/contact/double_word/double_word_pressure.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/rational.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "lab/counts/sample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace edgeproof::validation {
namespace {

using contact::BallContact;
using contact::Edge;

constexpr long reference_bits = 320;
/// The number of sampled contacts from which the first one with a form is chosen.
constexpr std::size_t choices = 16;

/// Returns a number 0 <= x < 1 of 53 bits.
double uniform(SplitMix64& dice) { return static_cast<double>(dice.next() >> 11U) * 0x1p-53; }

double number_of(const Ball& x) { return x.midpoint().convert_to<double>(); }

struct Drawn {
    std::string text;
    contact::Profile profile;
    formula::Exact modulus;
    contact::Load load;

    [[nodiscard]] BallContact at(long bits) const { return {profile, modulus, load, bits}; }
};

Drawn drawn_contact(std::uint64_t seed, std::size_t number, SplitMix64& dice) {
    for (std::size_t choice = 0;; ++choice) {
        const SampledContact sample = sampled_contact(seed, number * choices + choice, 1);
        const scene::Scene& scene = sample.scene;
        if (!scene.profile || !scene.profile->has_closed_form()) {
            continue;
        }
        Drawn drawn{sample.text, *scene.profile, scene.contact_modulus, scene.load};
        if (!contact::DoubleWordPressure::has_form(drawn.profile)) {
            const Rational m(2 * static_cast<long>(dice.below(9)) + 1, 2);
            drawn.profile = contact::Profile::power_law(drawn.profile.parameters().at("C"),
                                                        formula::Exact::of(m));
            drawn.text += "with m = " + exact_text(m) + "\n";
        }
        return drawn;
    }
}

class Contact {
public:
    explicit Contact(const Drawn& drawn)
        : drawn_(drawn), balls_(drawn.at(reference_bits)),
          pressure_(drawn.profile, drawn.at(contact::DoubleWordPressure::contact_bits)),
          length(number_of(balls_.a() + balls_.b())) {
        for (std::size_t i = 0; i < balls_.slope().knots.size(); ++i) {
            if (!balls_.piecewise_linear() || balls_.bends_inside(i)) {
                insets.push_back(number_of(balls_.a() - balls_.slope().knots[i]));
            }
        }
    }

    [[nodiscard]] DoubleWord words(Edge edge, double u) const {
        return pressure_.at(edge, {u, 0, 0});
    }
    [[nodiscard]] Ball ball(Edge edge, double u) const {
        return balls_.pressure(edge, Ball(exact_rational(u), reference_bits));
    }
    /// Decided by exact algebra.
    [[nodiscard]] bool on_corner(Edge edge, double u) const {
        const auto& end = balls_.known(edge);
        for (std::size_t i = 0; end && i < drawn_.profile.knots().size(); ++i) {
            const formula::Expr knot = drawn_.profile.knots()[i].expr();
            const formula::Expr inset =
                edge == Edge::right ? end->expr() - knot : end->expr() + knot;
            if (drawn_.profile.has_corner(i) &&
                contact::certainly_zero(inset - formula::Expr::number(exact_rational(u)))) {
                return true;
            }
        }
        return false;
    }

private:
    const Drawn& drawn_;
    BallContact balls_;
    contact::DoubleWordPressure pressure_;

public:
    double length;
    std::vector<double> insets; ///< of knots, from the right edge
};

struct Place {
    Edge edge;
    double u;
    DrawnPlace where;
};

Place drawn_place(SplitMix64& dice, const Contact& contact) {
    const double length = contact.length;
    const Edge edge = dice.below(2) == 0 ? Edge::right : Edge::left;
    const auto where = static_cast<DrawnPlace>(
        dice.below(contact.insets.empty() ? drawn_places.size() - 1 : drawn_places.size()));
    switch (where) {
    case DrawnPlace::by_the_edge:
        return {edge, length * std::pow(10.0, -60 * uniform(dice)), where};
    case DrawnPlace::inside:
        return {edge, length * uniform(dice), where};
    case DrawnPlace::by_a_knot:
        break;
    }
    const double inset = contact.insets[dice.below(contact.insets.size())];
    // The place lies on the far or on the near side of the knot. It is limited to the contact if
    // the knot is closer to an edge than the last bit of the length.
    const double at = std::clamp(edge == Edge::right ? inset : length - inset, 0x1p-100 * length,
                                 std::nextafter(length, 0.0));
    const bool far = dice.below(2) == 0;
    const double step = (far ? length - at : at) * std::pow(10.0, -18 * uniform(dice));
    return {edge, far ? at + step : at - step, where};
}

} // namespace

CountResult<std::string> count_binary64(const Binary64Options& options) {
    return count_contacts<std::string>(places_a_contact, options,
                                       [&options](std::size_t number, std::size_t values) {
                                           return count_binary64_contact(options, number, values);
                                       });
}

report::Table binary64_table(const CountResult<std::string>& count) {
    report::Table t;
    t.title = "Pressures in double words, in " + std::to_string(count.contacts) + " contacts";
    t.notes = {"undecided: left to balls, as the rounding is open",
               "wrong: not the binary64 that an enclosure of 320 bits rounds to"};
    add_counts(t, {"value", "place", {"p"}, {drawn_places.begin(), drawn_places.end()}},
               {{"values", &CountCell::values},
                {"undecided", &CountCell::undecided},
                {"wrong", &CountCell::wrong}},
               count.cells, count.total);
    return t;
}

CountedContact<std::string> count_binary64_contact(const Binary64Options& options,
                                                   std::size_t number, std::size_t values) {
    SplitMix64 dice(SplitMix64(options.seed).next() + number);
    const Drawn drawn = drawn_contact(options.seed, number, dice);
    const Contact contact(drawn);
    CountedContact<std::string> found;
    for (std::size_t cell = 0; cell < drawn_places.size(); ++cell) {
        found.cells[cell] = {};
    }
    for (; values > 0; --values) {
        check_interruption();
        const Place at = drawn_place(dice, contact);
        CountCell& cell = found.cells.at(static_cast<std::size_t>(at.where));
        ++cell.values;
        DoubleWord word = contact.words(at.edge, at.u);
        if (options.changed) {
            options.changed(word);
        }
        const auto value = nearest_binary64(word);
        if (!value) {
            ++cell.undecided;
            continue;
        }
        const auto right = nearest_binary64(contact.ball(at.edge, at.u));
        if (right ? *right != *value : !contact.on_corner(at.edge, at.u) || !std::isinf(*value)) {
            ++cell.wrong;
            found.findings.push_back(
                fmt::format("{}\np at u = {:a} from the {} edge: {:a}, where a ball has {}",
                            drawn.text, at.u, at.edge == Edge::right ? "right" : "left", *value,
                            right ? fmt::format("{:a}", *right) : "several"));
        }
    }
    return found;
}

} // namespace edgeproof::validation
