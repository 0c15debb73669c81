// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/causes/unit_mistake.hpp"

#include "edgeproof/conformance/causes/convention_rule.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

namespace edgeproof::conformance {
namespace {

using namespace convention_rule;

constexpr std::size_t most_rows_of_a_family = 60; // enough to select readings to test on all
constexpr unsigned reading_digits = 30;

using Parameters = std::vector<Parameter>;

std::string* find(Parameters& parameters, std::string_view key) {
    for (Parameter& p : parameters) {
        if (p.key == key) {
            return &p.text;
        }
    }
    return nullptr;
}

/// Replaces each of the existing parameters by `form`, with its text in place of %.
bool replaced(Parameters& parameters, const std::vector<std::string_view>& keys,
              const std::string& form) {
    bool any = false;
    for (const std::string_view key : keys) {
        std::string* const text = find(parameters, key);
        if (text != nullptr && formula::Exact::parse(*text).sign() != 0) {
            std::string changed = form;
            changed.replace(changed.find('%'), 1, "(" + *text + ")");
            *text = changed;
            any = true;
        }
    }
    return any;
}

/// Replaces the moduli and Poisson's ratios by one modulus.
bool modulus(Parameters& parameters, const std::string& form) {
    const std::string* const e1 = find(parameters, "E1");
    const std::string* const nu1 = find(parameters, "nu1");
    const std::string* const e2 = find(parameters, "E2");
    if (e1 == nullptr || nu1 == nullptr || e2 == nullptr) {
        return false;
    }
    std::string text;
    for (const char c : form) {
        text += c == '1'   ? "(" + *e1 + ")"
                : c == '2' ? "(" + *e2 + ")"
                : c == 'n' ? "(" + *nu1 + ")"
                : c == 'I' ? "1"
                           : std::string(1, c);
    }
    std::erase_if(parameters, [](const Parameter& p) {
        return p.key == "E1" || p.key == "E2" || p.key == "nu1" || p.key == "nu2";
    });
    parameters.push_back({"contact_modulus", text, 0});
    return true;
}

/// An alternative interpretation of a question.
struct Reading {
    const char* relation;
    const char* hint;
    /// Changes the question to that interpretation; false if this does not change it.
    std::function<bool(Parameters&, Question&)> change;
};

Reading of_parameters(const char* relation, const char* hint, std::vector<std::string_view> keys,
                      std::string form) {
    return {relation, hint, [keys = std::move(keys), form = std::move(form)](auto& p, auto&) {
                return replaced(p, keys, form);
            }};
}

const std::vector<Reading>& readings() {
    static const std::vector<Reading> all{
        of_parameters("ours with alpha and phi read in degrees",
                      "angles are in radians; do not convert them", {"alpha", "phi"}, "%*pi/180"),
        of_parameters("ours with alpha and phi converted to degrees",
                      "angles are in radians; do not convert them", {"alpha", "phi"}, "%*180/pi"),
        of_parameters("ours with a taken for the whole width",
                      "a is the distance from the minimum of the profile to the right edge, the "
                      "half-width of a symmetric contact",
                      {"a"}, "%/2"),
        of_parameters("ours with a doubled", "a is a half-width already", {"a"}, "%*2"),
        of_parameters("ours with R taken for a diameter", "R is the radius of the arcs", {"R"},
                      "%/2"),
        of_parameters("ours with R doubled", "R is the radius of the arcs already", {"R"}, "%*2"),
        of_parameters("ours with t taken for the whole flat", "the flat is 2 t wide", {"t"}, "%/2"),
        of_parameters("ours with t doubled", "t is half the flat already", {"t"}, "%*2"),
        of_parameters("ours with the contact modulus doubled",
                      "contact_modulus is E* with 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2",
                      {"contact_modulus"}, "%*2"),
        of_parameters("ours with the contact modulus halved",
                      "contact_modulus is E* with 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2",
                      {"contact_modulus"}, "%/2"),
        of_parameters("ours with Q and the bulk tension in the other direction",
                      "Q is positive towards +x on the body that it acts on", {"Q", "bulk_tension"},
                      "-%"),
        of_parameters("ours with the bulk tension in the other direction",
                      "bulk_tension is that of the other body less that of this one",
                      {"bulk_tension"}, "-%"),
        {"ours with C taken for the gap's constant, g = C x^(m + 1)",
         "C is the slope's constant: g' = C x^m",
         [](Parameters& p, Question&) {
             const std::string* const m = find(p, "m");
             return m != nullptr && formula::Exact::parse(*m).sign() != 0 &&
                    replaced(p, {"C"}, "%*(1+(" + *m + "))");
         }},
        {"ours with u taken for x", "u runs inwards from the edge: x = a - u, or u - b",
         [](Parameters& p, Question& q) {
             const std::string* const a = find(p, "a");
             if (!q.u || a == nullptr) {
                 return false;
             }
             q.u = formula::Exact(formula::Exact::parse(*a).expr() - q.u->expr());
             return q.u->sign() > 0;
         }},
        {"ours at the other edge",
         "left taken for right? u runs inwards from the edge: u = a - x at the right one, u = b + "
         "x "
         "at the left one; swap the edges",
         [](Parameters&, Question& q) {
             q.edge = opposite(q.edge);
             return q.at_edge();
         }},
        {"ours with E/(1 - nu^2) of one body for the contact modulus",
         "1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2: both bodies deform",
         [](Parameters& p, Question&) { return modulus(p, "1/(I-n^I*n)"); }},
        {"ours with Poisson's ratio left out",
         "1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2: plane strain",
         [](Parameters& p, Question&) { return modulus(p, "1*2/(1+2)"); }},
    };
    return all;
}

/// Rows of one family, compared with the references of an interpretation.
class Rows {
public:
    void add(double agreement, double effect) {
        agreement_.push_back(agreement);
        effect_.push_back(effect);
    }
    /// Returns the convention, if it explains those rows that it changes by four times their
    /// scatter.
    [[nodiscard]] std::optional<Convention> explained() const {
        Convention c;
        c.held = held_by_most(agreement_);
        c.digits = most_digits;
        std::size_t moved = 0;
        for (std::size_t k = 0; k < effect_.size(); ++k) {
            if (effect_[k] > std::min(same_digits, c.held - least_gain)) {
                continue; // the same in either interpretation
            }
            ++moved;
            if (agreement_[k] >= follows_from(c.held)) {
                ++c.rows;
                c.digits = std::min(c.digits, agreement_[k]);
            }
        }
        return c.held >= least_digits && enough(c.rows, moved) ? std::optional(c) : std::nullopt;
    }

private:
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

    void look(const Reading& reading) {
        keep(reading.relation, reading.hint,
             [&](const std::vector<std::size_t>& which) { return held_to(reading, which); });
    }

    /// Tests if the answers are the references divided or multiplied by the length of the contact.
    void look_at_lengths() {
        for (const int power : {-1, 1}) {
            keep(power < 0 ? "ours over a + b" : "ours times a + b",
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
            c->relation = first->relation;
            c->hint = first->hint;
            c->failing = failing_.at(family).size();
            for (const Candidate& other : candidates) {
                if (&other != &*first && other.held >= first->held - as_good) {
                    c->also.emplace_back(other.relation);
                }
            }
            found.push_back(std::move(*c));
        }
        return found;
    }

private:
    using HoldTo = std::function<Families(const std::vector<std::size_t>&)>;
    struct Candidate {
        const char* relation;
        const char* hint;
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
            Parameters parameters = answers_.questions.contacts[q.contact].parameters;
            try {
                if (!reading.change(parameters, q)) {
                    continue;
                }
                const auto [known, is_new] = contacts.emplace(q.contact, std::nullopt);
                if (is_new) {
                    otherwise.contacts.push_back(
                        make_asked_contact(std::move(parameters), otherwise.file, q.line));
                    known->second = otherwise.contacts.size() - 1;
                }
                if (!known->second) {
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
            families[family_of(answers_.questions.list[i])].add(digits_between(value, other),
                                                                digits_between(ours, other));
        }
    }

    void keep(const char* relation, const char* hint, const HoldTo& hold_to) {
        for (const auto& [family, rows] : hold_to(sample_)) {
            if (const auto c = rows.explained()) {
                candidates_[family].push_back({relation, hint, c->held, hold_to});
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

std::vector<Convention> infer_unit_mistakes(const Answers& answers, const Agreements& agreements,
                                            const std::vector<std::size_t>& failing,
                                            ReferenceOptions options) {
    if (failing.size() < least_rows) {
        return {};
    }
    options.digits = {reading_digits, Rounding::nearest, false};
    options.progress = {};
    const PrecisionScope scope(reading_digits + 20);
    Search search(answers, agreements, failing, options);
    for (const Reading& reading : readings()) {
        search.look(reading);
    }
    search.look_at_lengths();
    return search.best();
}

} // namespace edgeproof::conformance
