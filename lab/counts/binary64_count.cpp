// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/counts/binary64_count.hpp"

#include "edgeproof/contact/double_word/double_word_expansion.hpp"
#include "edgeproof/contact/double_word/double_word_shear.hpp"
#include "edgeproof/contact/slip/ball_slip.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/rational.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "lab/counts/sample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace edgeproof::validation {
namespace {

using contact::BallContact;
using contact::Edge;

constexpr long reference_bits = 320;
constexpr long error_bits = 1024; ///< 1 - p_n/p is at least 1e-180
constexpr std::size_t most_terms = 3;
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

constexpr long friction_denominator = 2; ///< f = 1/2

contact::ShearLoad<Ball> slip_load(const BallContact& contact, const Rational& ratio) {
    const long bits = contact.bits();
    return {contact.force() * Ball(ratio, bits) / friction_denominator, Ball(0, bits)};
}

/// Draws |Q|/(f P) from 9/10 to 1e-10: near 0 the stick zone nearly fills the contact.
Rational drawn_ratio(SplitMix64& dice) {
    Rational ratio(1 + static_cast<long>(dice.below(9)), 10);
    for (std::size_t zeros = dice.below(10); zeros > 0; --zeros) {
        ratio /= 10;
    }
    return ratio;
}

/// The slip of a contact, with the objects that it refers to.
struct Slipping {
    std::unique_ptr<BallContact> contact;
    std::unique_ptr<contact::ZoneSolver> zones;
    std::unique_ptr<contact::BallSlip> slip;

    Slipping(const Drawn& drawn, const Rational& ratio, long bits)
        : contact(std::make_unique<BallContact>(drawn.at(bits))),
          zones(contact::closed_form_zones(*contact)),
          slip(std::make_unique<contact::BallSlip>(*contact, *zones, contact->force(),
                                                   slip_load(*contact, ratio),
                                                   Ball(1, bits) / friction_denominator)) {}
};

class Contact {
public:
    Contact(const Drawn& drawn, SplitMix64& dice)
        : drawn_(drawn), words_(drawn.at(contact::DoubleWordPressure::contact_bits)),
          balls_(drawn.at(reference_bits)), fine_(drawn.at(error_bits)),
          ratio_(drawn_ratio(dice)), load_{Rational(1 + static_cast<long>(dice.below(99)), 7),
                                           Rational(3, 7)},
          pressure_(drawn.profile, words_), length(number_of(words_.a() + words_.b())) {
        for (std::size_t i = 0; i < words_.slope().knots.size(); ++i) {
            if (!words_.piecewise_linear() || words_.bends_inside(i)) {
                insets.push_back(number_of(words_.a() - words_.slope().knots[i]));
            }
        }
        shear_.push_back(contact::DoubleWordShear::full_stick(words_, load(words_.bits())));
        shear_.push_back(contact::DoubleWordShear::similar(pressure_, Ball(load_.Q, words_.bits()) /
                                                                          words_.force()));
        try {
            const Slipping slip(drawn, ratio_, words_.bits());
            slip_.emplace(drawn, ratio_, reference_bits);
            if (!slip.slip->sliding()) {
                const contact::BallZone& stick = slip.slip->stick();
                shear_.push_back(contact::DoubleWordShear::partial_slip(
                    drawn.profile, words_, stick, Ball(1, words_.bits()) / friction_denominator));
                insets.push_back(number_of(words_.a() - stick.a));
                insets.push_back(number_of(words_.a() + stick.b));
            }
        } catch (const BudgetError&) {
            // The stick zone ends on a corner: p and the other forms of q remain.
        }
        for (const Edge edge : {Edge::right, Edge::left}) {
            for (std::size_t n = 1; n <= most_terms; ++n) {
                sums_.emplace_back(words_, edge, n);
                errors_.emplace_back(drawn.profile, words_, edge, n);
            }
            c_[index_of(edge)] = balls_.expansion(edge, most_terms);
            fine_c_[index_of(edge)] = fine_.expansion(edge, most_terms);
        }
    }

    [[nodiscard]] bool slips() const { return shear_.size() == 3; }

    [[nodiscard]] DoubleWord words(DrawnForm form, std::size_t n, Edge edge, double u) const {
        const DoubleWord at{u, 0, 0};
        const std::size_t row = index_of(edge) * most_terms + n - 1;
        switch (form) {
        case DrawnForm::p:
            return pressure_.at(edge, at);
        case DrawnForm::sum:
            return sums_[row].at(at);
        case DrawnForm::relative_error:
            return errors_[row].at(at);
        default:
            return shear_[static_cast<std::size_t>(form) - 1].at(edge, at);
        }
    }

    [[nodiscard]] Ball ball(DrawnForm form, std::size_t n, Edge edge, const Rational& at) const {
        const Ball u(at, reference_bits);
        switch (form) {
        case DrawnForm::p:
            return balls_.pressure(edge, u);
        case DrawnForm::full_stick:
            return full_stick_traction(Ball(balls_.a() + balls_.b()), load(reference_bits), edge,
                                       u);
        case DrawnForm::similar:
            return Ball(load_.Q, reference_bits) / balls_.force() * balls_.pressure(edge, u);
        case DrawnForm::partial_slip:
            return slip_->slip->traction(edge, u, balls_.pressure(edge, u));
        case DrawnForm::sum:
            return sum(c_[index_of(edge)], n, u);
        case DrawnForm::relative_error:
            break;
        }
        const Ball fine_u(at, error_bits);
        return abs(1 - sum(fine_c_[index_of(edge)], n, fine_u) / fine_.pressure(edge, fine_u));
    }

    /// True if `value` is the correct limit on a corner, where no ball is finite or narrow enough.
    /// For q in a stick zone it must be the value on both sides, 2^-128 away; this also covers
    /// edges that are only enclosed, where algebra does not decide the corner.
    [[nodiscard]] bool is_limit(DrawnForm form, Edge edge, double u, double value) const {
        if (form == DrawnForm::partial_slip &&
            slip_->slip->state(edge, Ball(exact_rational(u), reference_bits)) !=
                contact::SlipState::slip) {
            const Rational step = exact_rational(u) * exact_rational(0x1p-128);
            return nearest_binary64(ball(form, 0, edge, exact_rational(u) - step)) == value &&
                   nearest_binary64(ball(form, 0, edge, exact_rational(u) + step)) == value;
        }
        return on_corner(edge, u) &&
               (form == DrawnForm::relative_error ? value == 1 : std::isinf(value));
    }

private:
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
    [[nodiscard]] contact::ShearLoad<Ball> load(long bits) const {
        return {Ball(load_.Q, bits), Ball(load_.bulk_tension, bits)};
    }
    static Ball sum(const std::vector<Ball>& c, std::size_t n, const Ball& u) {
        Ball total = c[n - 1];
        for (std::size_t k = n - 1; k-- > 0;) {
            total = total * u + c[k];
        }
        return total * sqrt(u);
    }

    const Drawn& drawn_;
    BallContact words_; ///< the source of the double words
    BallContact balls_;
    BallContact fine_;
    Rational ratio_;
    contact::ShearLoad<Rational> load_;
    contact::DoubleWordPressure pressure_;
    std::vector<contact::DoubleWordShear> shear_; ///< in the order of DrawnForm
    std::optional<Slipping> slip_;
    std::vector<contact::DoubleWordSum> sums_;
    std::vector<contact::DoubleWordRelativeError> errors_;
    std::array<std::vector<Ball>, 2> c_;
    std::array<std::vector<Ball>, 2> fine_c_;

public:
    double length;
    std::vector<double> insets; ///< of knots and edges of the stick zone, from an edge
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

DrawnForm drawn_form(SplitMix64& dice, const Contact& contact) {
    // Half of the forms are pressures.
    const auto form = static_cast<DrawnForm>(
        std::max<std::ptrdiff_t>(0, static_cast<std::ptrdiff_t>(dice.below(10)) - 4));
    return form == DrawnForm::partial_slip && !contact.slips() ? DrawnForm::full_stick : form;
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
    t.title = "Values in double words, in " + std::to_string(count.contacts) + " contacts";
    t.notes = {"undecided: left to balls, as the rounding is open",
               "wrong: not the binary64 that an enclosure of 320 bits or more rounds to"};
    add_counts(t,
               {"value",
                "place",
                {drawn_forms.begin(), drawn_forms.end()},
                {drawn_places.begin(), drawn_places.end()}},
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
    const Contact contact(drawn, dice);
    CountedContact<std::string> found;
    for (std::size_t cell = 0; cell < drawn_forms.size() * drawn_places.size(); ++cell) {
        found.cells[cell] = {};
    }
    for (; values > 0; --values) {
        check_interruption();
        const Place at = drawn_place(dice, contact);
        const DrawnForm form = drawn_form(dice, contact);
        const std::size_t n = 1 + dice.below(most_terms);
        CountCell& cell = found.cells.at(static_cast<std::size_t>(form) * drawn_places.size() +
                                         static_cast<std::size_t>(at.where));
        ++cell.values;
        DoubleWord word = contact.words(form, n, at.edge, at.u);
        if (options.changed) {
            options.changed(word);
        }
        const auto value = nearest_binary64(word);
        if (!value) {
            ++cell.undecided;
            continue;
        }
        const auto right = nearest_binary64(contact.ball(form, n, at.edge, exact_rational(at.u)));
        if (right ? *right != *value : !contact.is_limit(form, at.edge, at.u, *value)) {
            ++cell.wrong;
            found.findings.push_back(fmt::format(
                "{}\n{} (n = {}) at u = {:a} from the {} edge: {:a}, where a ball has {}",
                drawn.text, drawn_forms.at(static_cast<std::size_t>(form)), n, at.u,
                at.edge == Edge::right ? "right" : "left", *value,
                right ? fmt::format("{:a}", *right) : "several"));
        }
    }
    return found;
}

} // namespace edgeproof::validation
