// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/causes/readings.hpp"

#include "edgeproof/conformance/causes/ratios.hpp"
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

/// An alternative interpretation of questions.
struct Reading {
    std::string name; ///< of the cause (scene_mistakes.hpp)
    std::string relation;
    std::string hint;
    /// Changes the contact to that interpretation; false if this does not change it.
    std::function<bool(scene::Scene&)> contact;
    /// Changes the place of a question of that contact. Null: places are as in the question.
    std::function<bool(Question&, const scene::Scene&)> place = {};
};

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

using Applies = std::function<bool(const scene::Scene&)>;

/// The readings of which at least one changes a question: the mistakes of the catalogue that are
/// possible for some of the contacts, and those that only questions allow.
std::vector<Reading> readings(const Questions& questions, const std::set<std::size_t>& contacts) {
    std::vector<Reading> all{
        {"gap-for-slope", "ours with C taken for the gap's constant, g = C x^(m + 1)",
         "C is the slope's constant: g' = C x^m", gap_for_slope},
        {"sign", "ours with Q and the bulk tension in the other direction",
         "Q is positive towards +x on the body that it acts on", reverse_shear},
        {"x-for-u", "ours with u taken for x", "u runs inwards from the edge: x = a - u, or u - b",
         [](scene::Scene&) { return true; },
         [](Question& q, const scene::Scene& scene) {
             if (!q.u || scene.load.kind != contact::Load::Kind::right_edge) {
                 return false;
             }
             q.u = formula::Exact(scene.load.value.expr() - q.u->expr());
             return q.u->sign() > 0;
         }},
        {"edges-swapped", "ours at the other edge",
         "left taken for right? u runs inwards from the edge: u = a - x at the right one, u = b + "
         "x at the left one; swap the edges",
         [](scene::Scene&) { return true; },
         [](Question& q, const scene::Scene&) {
             q.edge = opposite(q.edge);
             return q.at_edge();
         }}};
    for (const auto& [name, words, n] : {std::tuple{"one-term", "the first term", 1U},
                                         std::tuple{"two-term", "the first two terms", 2U},
                                         std::tuple{"three-term", "the first three terms", 3U}}) {
        all.push_back({name, std::string(words) + " of ours at the edge",
                       "the pressure is asked for, not an approximation of it",
                       [](scene::Scene&) { return true; },
                       [n = n](Question& q, const scene::Scene&) {
                           const bool pressure = q.quantity == scene::Quantity::p;
                           q.quantity = scene::Quantity::local;
                           q.k = n;
                           return pressure;
                       }});
    }
    std::set<std::string> known;
    const auto add = [&](const scene::SceneMistake& mistake, const Applies& applies,
                         const std::string& key) {
        if (!known.insert(key).second) {
            return;
        }
        all.push_back({std::string(mistake.name), "ours with " + mistake.what,
                       std::string(mistake.advice), [what = mistake.what, applies](auto& scene) {
                           for (const scene::SceneMistake& m : mistakes_in(scene)) {
                               if (m.what == what && applies(scene)) {
                                   m.change(scene);
                                   return true;
                               }
                           }
                           return false;
                       }});
    };
    for (const std::size_t contact : contacts) {
        const scene::Scene& scene = questions.contacts[contact].scene;
        for (const scene::SceneMistake& mistake : mistakes_in(scene)) {
            add(
                mistake, [](const auto&) { return true; }, mistake.what);
            // A program may take C for 1/R, and yet read R as a diameter.
            if (mistake.name == "radius-as-diameter") {
                const bool circle = is_circle(scene);
                add(
                    mistake, [circle](const auto& other) { return is_circle(other) == circle; },
                    mistake.what + (circle ? " of C" : " of R"));
            }
        }
    }
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

    /// The contacts of the failing rows.
    [[nodiscard]] std::set<std::size_t> contacts() const {
        std::set<std::size_t> all;
        for (const std::size_t i : sample_) {
            all.insert(answers_.questions.list[i].contact);
        }
        return all;
    }

    void look(const Reading& reading) {
        keep(reading.name, reading.relation, reading.hint,
             [this, reading](const std::vector<std::size_t>& which) {
                 return held_to(reading, which);
             });
    }

    /// Tests if the answers are the references divided or multiplied by the length of the contact.
    void look_at_lengths() {
        for (const int power : {-1, 1}) {
            keep(power < 0 ? "divided-by-length" : "times-length",
                 power < 0 ? "ours over a + b" : "ours times a + b",
                 power < 0 ? "a mean pressure for a force per unit length? P is the force"
                           : "a force per unit length for a pressure? p and q are tractions",
                 [this, power](const std::vector<std::size_t>& which) {
                     return held_to_lengths(power, which);
                 });
        }
    }

    /// Returns the best candidate of each family, with equally good ones. A candidate that fits the
    /// sample of a family is compared with every failing row of it, so that the counts are exact.
    [[nodiscard]] std::vector<Convention> best() const {
        std::vector<Convention> found;
        for (const auto& [family, candidates] : candidates_) {
            const auto first = std::max_element(
                candidates.begin(), candidates.end(),
                [](const Candidate& x, const Candidate& y) { return x.held < y.held; });
            const Families all = first->hold_to(failing_.at(family));
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
            for (const Candidate& other : candidates) {
                if (&other != &*first && other.held >= first->held - as_good) {
                    c->also.push_back(other.relation);
                    c->equally_likely.push_back(other.name);
                }
            }
            found.push_back(std::move(*c));
        }
        return found;
    }

private:
    using HoldTo = std::function<Families(const std::vector<std::size_t>&)>;
    struct Candidate {
        std::string name;
        std::string relation;
        std::string hint;
        double held; ///< on the sample
        HoldTo hold_to;
    };

    Families held_to(const Reading& reading, const std::vector<std::size_t>& which) const {
        Questions otherwise;
        otherwise.file = answers_.questions.file;
        std::map<std::size_t, std::optional<std::size_t>> contacts;
        std::vector<std::size_t> of;
        for (const std::size_t i : which) {
            Question q = answers_.questions.list[i];
            try {
                const auto [known, is_new] = contacts.emplace(q.contact, std::nullopt);
                if (is_new) {
                    AskedContact contact = answers_.questions.contacts[q.contact];
                    if (reading.contact(contact.scene)) {
                        otherwise.contacts.push_back(std::move(contact));
                        known->second = otherwise.contacts.size() - 1;
                    }
                }
                if (!known->second ||
                    (reading.place &&
                     !reading.place(q, otherwise.contacts[*known->second].scene))) {
                    continue;
                }
                q.contact = *known->second;
            } catch (const Error&) { // not a valid contact
                continue;
            }
            otherwise.list.push_back(std::move(q));
            of.push_back(i);
        }
        const auto values = references_where_any(otherwise, options_);
        Families families;
        for (std::size_t k = 0; k < of.size(); ++k) {
            if (values[k] && !contains_zero(values[k]->value.value)) {
                hold(of[k], values[k]->value.value.midpoint(), families);
            }
        }
        return families;
    }

    Families held_to_lengths(int power, const std::vector<std::size_t>& which) const {
        Questions sizes;
        sizes.file = answers_.questions.file;
        sizes.contacts = answers_.questions.contacts;
        for (const std::size_t i : which) {
            const Question& q = answers_.questions.list[i];
            for (const auto size : {scene::Quantity::a, scene::Quantity::b}) {
                sizes.list.push_back({{size}, "", q.contact, q.line});
            }
        }
        const auto values = references_where_any(sizes, options_);
        Families families;
        for (std::size_t k = 0; k < which.size(); ++k) {
            if (values[2 * k] && values[2 * k + 1]) {
                const Real length = values[2 * k]->value.value.midpoint() +
                                    values[2 * k + 1]->value.value.midpoint();
                const Real ours = agreements_.references[which[k]].value.value.midpoint();
                hold(which[k], power < 0 ? Real(ours / length) : Real(ours * length), families);
            }
        }
        return families;
    }

    void hold(std::size_t i, const Real& other, Families& families) const {
        if (other != 0) {
            const Real ours = agreements_.references[i].value.value.midpoint();
            const Real value = Ball(answers_.given[i].value, 256).midpoint();
            families[family_of(answers_.questions.list[i])].add(value, ours, other);
        }
    }

    void keep(const std::string& name, const std::string& relation, const std::string& hint,
              const HoldTo& hold_to) {
        for (const auto& [family, rows] : hold_to(sample_)) {
            if (const auto c = rows.explained()) {
                candidates_[family].push_back({name, relation, hint, c->held, hold_to});
            }
        }
    }

    const Answers& answers_;
    const Agreements& agreements_;
    ReferenceOptions options_;
    std::vector<std::size_t> sample_;
    std::map<std::string, std::vector<std::size_t>> failing_;
    std::map<std::string, std::vector<Candidate>> candidates_; ///< by family
};

} // namespace

std::vector<Convention> infer_readings(const Answers& answers, const Agreements& agreements,
                                       const std::vector<std::size_t>& failing,
                                       ReferenceOptions options) {
    if (failing.size() < least_rows) {
        return {};
    }
    options.digits = {reading_digits, Rounding::nearest, false};
    options.progress = {};
    const PrecisionScope scope(reading_digits + 20);
    Search search(answers, agreements, failing, options);
    for (const Reading& reading : readings(answers.questions, search.contacts())) {
        search.look(reading);
    }
    search.look_at_lengths();
    return search.best();
}

} // namespace edgeproof::conformance
