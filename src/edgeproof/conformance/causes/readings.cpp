// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/causes/readings.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/mistakes/scene_mistakes.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace edgeproof::conformance {
namespace {

using namespace convention_rule;

constexpr std::size_t most_rows_of_a_family = 60; // enough to select readings to test on all
constexpr unsigned reading_digits = 30;

/// C as the constant of the gap, g = C x^(m + 1).
bool gap_for_slope(scene::Scene& scene) {
    if (!scene.profile || scene.profile->kind() != contact::Profile::Kind::power_law) {
        return false;
    }
    const auto& parameters = scene.profile->parameters();
    const formula::Exact& m = parameters.at("m");
    if (m.sign() == 0) {
        return false;
    }
    scene.profile = contact::Profile::power_law(
        formula::Exact(parameters.at("C").expr() * (formula::Expr::number(Rational(1)) + m.expr())),
        m);
    return true;
}

bool reverse_shear(scene::Scene& scene) {
    if (!scene.shear) {
        return false;
    }
    scene.shear->Q = formula::Exact(-scene.shear->Q.expr());
    scene.shear->bulk_tension = formula::Exact(-scene.shear->bulk_tension.expr());
    return true;
}

/// The mistakes in the data of a contact.
std::vector<scene::SceneMistake> mistakes_in(const scene::Scene& scene) {
    std::vector<scene::SceneMistake> all = contact_mistakes(scene);
    if (scene.shear) {
        std::ranges::move(shear_mistakes(scene), std::back_inserter(all));
    }
    return all;
}

/// True if the radius is given by C, the curvature.
bool is_circle(const scene::Scene& scene) {
    return scene.profile && scene.profile->kind() == contact::Profile::Kind::power_law;
}

/// The mistake, for all contacts or only for circles (or for other profiles).
Reading reading_of(const scene::SceneMistake& mistake, std::optional<bool> circle) {
    return {std::string(mistake.name), "ours with " + mistake.what, std::string(mistake.advice),
            [what = mistake.what, circle](scene::Scene& scene) {
                for (const scene::SceneMistake& m : mistakes_in(scene)) {
                    if (m.what == what && is_circle(scene) == circle.value_or(is_circle(scene))) {
                        m.change(scene);
                        return true;
                    }
                }
                return false;
            }};
}

/// The readings of which at least one changes a question: the mistakes of the catalogue that are
/// possible for some of the contacts, and those that only questions allow.
std::vector<Reading> readings(const Questions& questions, const std::set<std::size_t>& contacts) {
    std::vector<Reading> all{
        {"gap-for-slope", "ours with C taken for the gap's constant, g = C x^(m + 1)",
         "C is the slope's constant: g' = C x^m", gap_for_slope},
        {"sign", "ours with Q and the bulk tension in the other direction",
         "Q is positive towards +x on the body that it acts on", reverse_shear},
        {"x-for-u",
         "ours with u taken for x",
         "u runs inwards from the edge: x = a - u, or u - b",
         {},
         [](Question& q, const scene::Scene& scene) {
             if (!q.u || scene.load.kind != contact::Load::Kind::right_edge) {
                 return false;
             }
             q.u = formula::Exact(scene.load.value.expr() - q.u->expr());
             return q.u->sign() > 0;
         }},
        {"edges-swapped",
         "ours at the other edge",
         "left taken for right? u runs inwards from the edge: u = a - x at the right one, u = b + "
         "x at the left one; swap the edges",
         {},
         [](Question& q, const scene::Scene&) {
             q.edge = opposite(q.edge);
             return q.at_edge();
         }}};
    for (const auto& [name, words, n] : {std::tuple{"one-term", "the first term", 1U},
                                         std::tuple{"two-term", "the first two terms", 2U},
                                         std::tuple{"three-term", "the first three terms", 3U}}) {
        all.push_back({name,
                       std::string(words) + " of ours at the edge",
                       "the pressure is asked for, not an approximation of it",
                       {},
                       [n = n](Question& q, const scene::Scene&) {
                           const bool pressure = q.quantity == scene::Quantity::p;
                           q.quantity = scene::Quantity::local;
                           q.k = n;
                           return pressure;
                       }});
    }
    std::set<std::pair<std::string, std::optional<bool>>> known;
    const auto add = [&](const scene::SceneMistake& mistake, std::optional<bool> circle) {
        if (known.emplace(mistake.what, circle).second) {
            all.push_back(reading_of(mistake, circle));
        }
    };
    for (const std::size_t contact : contacts) {
        const scene::Scene& scene = questions.contacts[contact].scene;
        for (const scene::SceneMistake& mistake : mistakes_in(scene)) {
            add(mistake, {});
            // A program may take C for 1/R, and yet read R as a diameter.
            if (mistake.name == "radius-as-diameter") {
                add(mistake, is_circle(scene));
            }
        }
    }
    all.push_back({"divided-by-length",
                   "ours over a + b",
                   "a mean pressure for a force per unit length? P is the force",
                   {},
                   {},
                   -1});
    all.push_back({"times-length",
                   "ours times a + b",
                   "a force per unit length for a pressure? p and q are tractions",
                   {},
                   {},
                   1});
    return all;
}

/// Rows of one family, compared with the references of an interpretation.
class Rows {
public:
    /// `ours` and `other`: the reference, and that of the interpretation.
    void add(const Real& answer, const Real& ours, const Real& other) {
        ratio_.push_back(answer / other);
        agreement_.push_back(digits_between(answer, other));
        effect_.push_back(digits_between(ours, other));
    }
    /// Returns the convention, if it explains those rows that it changes by four times their
    /// scatter, and if no constant factor remains: another mistake may have nearly the same effect.
    [[nodiscard]] std::optional<Convention> explained() const {
        Convention c;
        c.held = held_by_most(agreement_);
        c.digits = most_digits;
        std::vector<Real> moved;
        for (std::size_t k = 0; k < effect_.size(); ++k) {
            if (effect_[k] > std::min(same_digits, c.held - least_gain)) {
                continue; // the same in either interpretation
            }
            moved.push_back(ratio_[k]);
            if (agreement_[k] >= follows_from(c.held)) {
                ++c.rows;
                c.digits = std::min(c.digits, agreement_[k]);
            }
        }
        const std::size_t all = moved.size();
        return c.held >= least_digits && enough(c.rows, all) &&
                       Ratios(std::move(moved), all).allow(1)
                   ? std::optional(c)
                   : std::nullopt;
    }

private:
    std::vector<Real> ratio_;       ///< the answer over the value of the interpretation
    std::vector<double> agreement_; ///< digits to which the answer agrees with the interpretation
    std::vector<double> effect_;    ///< digits to which that agrees with the reference
};
using Families = std::map<std::string, Rows>;

/// The references times a power of the length of the contact.
std::vector<std::optional<Real>> times_lengths(const Answers& answers, const Agreements& agreements,
                                               int power, const std::vector<std::size_t>& which,
                                               const ReferenceOptions& options) {
    Questions sizes{answers.questions.file, answers.questions.contacts, {}};
    for (const std::size_t i : which) {
        const Question& q = answers.questions.list[i];
        for (const auto size : {scene::Quantity::a, scene::Quantity::b}) {
            sizes.list.push_back({{size}, "", q.contact, q.line});
        }
    }
    const auto found = references_where_any(sizes, options);
    std::vector<std::optional<Real>> values(which.size());
    for (std::size_t k = 0; k < which.size(); ++k) {
        if (found[2 * k] && found[2 * k + 1]) {
            const Real length =
                found[2 * k]->value.value.midpoint() + found[2 * k + 1]->value.value.midpoint();
            const Real ours = agreements.references[which[k]].value.value.midpoint();
            values[k] = power < 0 ? Real(ours / length) : Real(ours * length);
        }
    }
    return values;
}

class Search {
public:
    Search(const Answers& answers, const Agreements& agreements,
           const std::vector<std::size_t>& failing, const ReferenceOptions& options)
        : answers_(answers), agreements_(agreements), options_(options) {
        std::map<std::string, std::size_t> taken;
        for (const std::size_t i : failing) {
            const std::string family = family_of(answers.questions.list[i]);
            failing_[family].push_back(i);
            if (taken[family]++ < most_rows_of_a_family) {
                sample_.push_back(i);
            }
        }
    }

    /// Returns the best reading of each family, with equally good ones. A reading that fits the
    /// sample of a family is compared with every failing row of it, so that the counts are exact.
    [[nodiscard]] std::vector<Convention> best() const {
        std::set<std::size_t> contacts;
        for (const std::size_t i : sample_) {
            contacts.insert(answers_.questions.list[i].contact);
        }
        const std::vector<Reading> all_readings = readings(answers_.questions, contacts);
        std::map<std::string, std::vector<std::pair<const Reading*, double>>> candidates;
        for (const Reading& reading : all_readings) {
            for (const auto& [family, rows] : held_to(reading, sample_)) {
                if (const auto c = rows.explained()) {
                    candidates[family].emplace_back(&reading, c->held);
                }
            }
        }
        std::vector<Convention> found;
        for (const auto& [family, of_family] : candidates) {
            const auto [first, first_held] = *std::ranges::max_element(
                of_family, {}, [](const auto& candidate) { return candidate.second; });
            const Families all = held_to(*first, failing_.at(family));
            const auto rows = all.find(family);
            auto c = rows == all.end() ? std::nullopt : rows->second.explained();
            if (!c) {
                continue;
            }
            c->of = family;
            c->name = first->name;
            c->relation = first->relation;
            c->hint = first->hint;
            c->failing = failing_.at(family).size();
            for (const auto& [other, held] : of_family) {
                if (other != first && held >= first_held - as_good) {
                    c->also.push_back(other->relation);
                    c->equally_likely.push_back(other->name);
                }
            }
            found.push_back(std::move(*c));
        }
        return found;
    }

private:
    Families held_to(const Reading& reading, const std::vector<std::size_t>& which) const {
        const auto values = values_read_otherwise(answers_, agreements_, reading, which, options_);
        Families families;
        for (std::size_t k = 0; k < which.size(); ++k) {
            if (values[k] && *values[k] != 0) {
                families[family_of(answers_.questions.list[which[k]])].add(
                    Ball(answers_.given[which[k]].value, 256).midpoint(),
                    agreements_.references[which[k]].value.value.midpoint(), *values[k]);
            }
        }
        return families;
    }

    const Answers& answers_;
    const Agreements& agreements_;
    const ReferenceOptions& options_;
    std::vector<std::size_t> sample_;
    std::map<std::string, std::vector<std::size_t>> failing_;
};

} // namespace

std::vector<std::optional<Real>>
values_read_otherwise(const Answers& answers, const Agreements& agreements, const Reading& reading,
                      const std::vector<std::size_t>& which, const ReferenceOptions& options) {
    if (reading.length_power != 0) {
        return times_lengths(answers, agreements, reading.length_power, which, options);
    }
    Questions otherwise{answers.questions.file, {}, {}};
    std::map<std::size_t, std::optional<std::size_t>> contacts;
    std::vector<std::size_t> of;
    for (std::size_t k = 0; k < which.size(); ++k) {
        Question q = answers.questions.list[which[k]];
        try {
            const auto [known, is_new] = contacts.try_emplace(q.contact);
            if (is_new) {
                AskedContact contact = answers.questions.contacts[q.contact];
                if (!reading.contact || reading.contact(contact.scene)) {
                    known->second = otherwise.contacts.size();
                    otherwise.contacts.push_back(std::move(contact));
                }
            }
            if (!known->second ||
                (reading.place && !reading.place(q, otherwise.contacts[*known->second].scene))) {
                continue;
            }
            q.contact = *known->second;
        } catch (const Error&) { // not a valid contact
            continue;
        }
        otherwise.list.push_back(std::move(q));
        of.push_back(k);
    }
    const auto found = references_where_any(otherwise, options);
    std::vector<std::optional<Real>> values(which.size());
    for (std::size_t k = 0; k < of.size(); ++k) {
        if (found[k] && !contains_zero(found[k]->value.value)) {
            values[of[k]] = found[k]->value.value.midpoint();
        }
    }
    return values;
}

std::vector<Convention> infer_readings(const Answers& answers, const Agreements& agreements,
                                       const std::vector<std::size_t>& failing,
                                       ReferenceOptions options) {
    if (failing.size() < least_rows) {
        return {};
    }
    options.digits = {reading_digits, Rounding::nearest, false};
    options.progress = {};
    const PrecisionScope scope(reading_digits + 20);
    return Search(answers, agreements, failing, options).best();
}

} // namespace edgeproof::conformance
