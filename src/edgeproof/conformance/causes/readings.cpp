// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/conformance/causes/readings.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/real.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <tuple>

namespace edgeproof::conformance {

double relative(const Real& x, const Real& y) {
    return std::clamp(Real(x / y - 1).convert_to<double>(), -1e300, 1e300);
}

Values times(Values values, const Real& factor) {
    for (auto& value : values) {
        if (value) {
            *value *= factor;
        }
    }
    return values;
}

bool has_value(const Answers& answers, const Agreements& agreements, std::size_t i) {
    return answers.given[i].state == Answer::State::number &&
           agreements.cases[i].no_reference.empty() &&
           !contains_zero(agreements.references[i].value.value);
}

std::vector<std::size_t> evenly(const std::vector<std::size_t>& rows, std::size_t most) {
    std::vector<std::size_t> some;
    const std::size_t n = std::min(rows.size(), most);
    for (std::size_t k = 0; k < n; ++k) {
        some.push_back(rows[k * rows.size() / n]);
    }
    return some;
}

WrongRows wrong_rows(const Answers& answers, const Agreements& agreements,
                     std::vector<std::size_t> questions) {
    WrongRows rows;
    rows.questions = std::move(questions);
    std::vector<std::tuple<std::size_t, std::string, double, std::size_t>> points;
    for (std::size_t k = 0; k < rows.questions.size(); ++k) {
        const std::size_t i = rows.questions[k];
        rows.answers.push_back(Ball(answers.given[i].value, 256).midpoint());
        rows.ours.emplace_back(agreements.references[i].value.value.midpoint());
        const Question& q = answers.questions.list[i];
        if (q.at_point()) {
            points.emplace_back(q.contact, symbol_of(q) + scene::edge_name(q.edge),
                                agreements.cases[i].nearness.edge, k);
        }
    }
    std::ranges::sort(points);
    for (std::size_t k = 1; k < points.size(); ++k) {
        if (std::get<0>(points[k]) == std::get<0>(points[k - 1]) &&
            std::get<1>(points[k]) == std::get<1>(points[k - 1])) {
            rows.neighbours.emplace_back(std::get<3>(points[k - 1]), std::get<3>(points[k]));
        }
    }
    return rows;
}

diagnose::Remainders remainders(const WrongRows& rows, const Values& values) {
    diagnose::Remainders all;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const Real& answer = rows.answers[k];
        const Real& ours = *rows.ours[k];
        all.off.push_back(relative(answer, values[k] ? *values[k] : ours));
        all.before.push_back(std::abs(relative(answer, ours)));
        all.ratio.push_back(std::max(all.before[k], std::abs(relative(ours, answer))));
        all.change.push_back(values[k] ? std::abs(relative(*values[k], ours)) : 0);
    }
    all.neighbours = rows.neighbours;
    return all;
}

std::vector<Group> groups_of(const Answers& answers, const Agreements& agreements,
                             const std::vector<std::size_t>& failing) {
    std::vector<Group> groups;
    for (const std::size_t row : failing) {
        const Question& q = answers.questions.list[row];
        const std::string family = family_of(q);
        const auto add = [&](const std::string& name) {
            auto known = std::ranges::find(groups, name, &Group::name);
            if (known == groups.end()) {
                known = groups.insert(known, {name, family, {}});
            }
            known->rows.questions.push_back(row);
        };
        add(family);
        if (q.at_edge()) {
            add(family + ", " + scene::edge_name(q.edge) + " edge");
        }
        if (symbol_of(q) != family) {
            add(symbol_of(q));
        }
    }
    for (Group& group : groups) {
        const Group& all = *std::ranges::find(groups, group.family, &Group::name);
        group.whole = group.rows.size() == all.rows.size();
    }
    for (Group& group : groups) {
        group.rows = wrong_rows(answers, agreements, std::move(group.rows.questions));
    }
    std::ranges::stable_sort(groups, std::greater(), [](const Group& g) {
        return std::pair(g.rows.size(), g.name.size() + (g.name.ends_with("_k") ? 0 : 1));
    });
    return groups;
}

namespace {

constexpr double most_cause_digits = 40;
constexpr std::size_t part_outside = 20; ///< one row of this number lies outside, on each side
/// Relative standard deviations that an interval exceeds: noise of 12 answers has a range of more
/// than 6 in one case of a thousand.
constexpr double noise_in_interval = 6;

} // namespace

double cause_digits(double off) {
    return off == 0 ? most_cause_digits : std::clamp(-std::log10(off), 0.0, most_cause_digits);
}

void add_near_factors(Convention& of, double least, double most) {
    for (const auto& [factor, rest] : diagnose::near_factors(least, most)) {
        if (std::ranges::find(of.equally_likely, factor.name) == of.equally_likely.end()) {
            of.also.push_back(
                most > least
                    ? fmt::format("{}ours, and up to {:.2g} % that have another cause",
                                  factor.words, 100 * rest)
                    : fmt::format("{}ours, and {:+.2g} % that have another cause", factor.words,
                                  100 * Real(least / factor.value - 1).convert_to<double>()));
            of.equally_likely.emplace_back(factor.name);
        }
    }
}

std::pair<double, double> interval_of(const WrongRows& all) {
    std::vector<double> ratios = remainders(all, all.ours).off;
    std::ranges::sort(ratios);
    const std::size_t outside = ratios.size() / part_outside;
    return {1 + ratios[outside], 1 + ratios[ratios.size() - 1 - outside]};
}

std::optional<Convention> varying_factor(const Group& group, double noise) {
    const WrongRows& all = group.rows;
    const auto [least, most] = interval_of(all);
    const double wide = noise_in_interval * noise * std::abs(most + least) / 2;
    Convention c;
    if (!remainder_of(remainders(all, all.ours)).noise_like.value_or(most - least < wide)) {
        add_near_factors(c, least, most);
    }
    if (c.also.empty()) {
        return {};
    }
    c.of = group.family;
    c.relation = fmt::format("{:.3g} to {:.3g} times ours", least, most);
    c.hint = "a factor that is no constant";
    c.name = "varying-factor";
    c.factor = (least + most) / 2;
    c.failing = all.size();
    c.rows = c.failing - 2 * (c.failing / part_outside);
    c.held = cause_digits(most / least - 1);
    c.without_digits = true;
    return c;
}

namespace {

constexpr unsigned reading_digits = 30;
constexpr std::size_t most_right_rows = 12; // of a quantity: enough to contradict a cause
constexpr std::size_t rows_of_search = 12;  // for a factor, which is fitted to more rows
constexpr std::size_t rows_of_fit = 60;

/// True if the radius is given by C, the curvature.
bool is_circle(const scene::Scene& scene) {
    return scene.profile && scene.profile->kind() == contact::Profile::Kind::power_law;
}

/// C as the constant of the gap, g = C x^(m + 1).
bool gap_for_slope(scene::Scene& scene, const Reading::Mistakes&) {
    if (!is_circle(scene)) {
        return false;
    }
    const auto& parameters = scene.given_profile().parameters();
    const formula::Exact m = parameters.at("m");
    if (m.sign() == 0) {
        return false;
    }
    const formula::Exact C(parameters.at("C").expr() *
                           (formula::Expr::number(Rational(1)) + m.expr()));
    change_given(scene, [&](scene::Scene& s) { s.profile = contact::Profile::power_law(C, m); });
    return true;
}

bool reverse_shear(scene::Scene& scene, const Reading::Mistakes&) {
    if (!scene.shear) {
        return false;
    }
    const auto reverse = [](auto& load) {
        load.Q = formula::Exact(-load.Q.expr());
        load.bulk_tension = formula::Exact(-load.bulk_tension.expr());
    };
    if (scene.history) {
        change_steps(scene, reverse);
    } else {
        reverse(*scene.shear);
    }
    return true;
}

/// The mistake, for all contacts or only for circles (or for other profiles).
Reading reading_of(const diagnose::Mistake& mistake, std::optional<bool> circle) {
    Reading reading{
        std::string(mistake.name), "ours with " + mistake.what, std::string(mistake.advice),
        [what = mistake.what, circle](scene::Scene& scene, const auto& mistakes) {
            const auto same = std::ranges::find(mistakes, what, &diagnose::Mistake::what);
            if (same == mistakes.end() || is_circle(scene) != circle.value_or(is_circle(scene))) {
                return false;
            }
            same->change(scene);
            return true;
        }};
    reading.only = !circle ? "" : *circle ? "circles" : "others";
    return reading;
}

using Expr = formula::Expr;

/// Asks for another place: `distance` gives that from the origin, towards the edge, for that of the
/// edge and u.
auto asked_at(const std::function<Expr(const Expr& edge, const Expr& u)>& distance) {
    return [distance](Question& q, const scene::Scene& scene) {
        if (q.u) {
            const bool right = q.edge == contact::Edge::right;
            const Expr edge = Expr::symbol(right || scene.symmetric() ? "a" : "b");
            const Expr x = distance(edge, q.u->expr());
            q.place = scene::Distance(edge - x, right ? x : -x);
        }
        return q.u.has_value();
    };
}

/// The interpretations with a factor: of the load, of the places x, of the distances u.
std::vector<Reading> with_factor(double factor, const std::string& text) {
    const Rational exact = exact_rational(factor);
    const Expr k = Expr::number(exact);
    std::vector<Reading> list{{"another-force", "ours under " + text + " times the load",
                               "another load step, or a load in another unit?",
                               [exact](scene::Scene& scene, const auto&) {
                                   diagnose::scale_load(scene, exact);
                                   return true;
                               }},
                              {"factor-of-x", "ours with " + text + " times the places x",
                               "x in another unit, or a stretched mesh?"},
                              {"factor-of-u", "ours with " + text + " times the distances u",
                               "u in another unit, or a stretched mesh?"}};
    list[1].place = asked_at([k](const Expr& edge, const Expr& u) { return (edge - u) / k; });
    list[2].place = [k](Question& q, const scene::Scene&) {
        q.u = q.u ? std::optional(formula::Exact(q.u->expr() / k)) : q.u;
        return q.u.has_value();
    };
    for (Reading& reading : list) {
        reading.only = fmt::format("{}", factor);
        reading.factor = factor;
        reading.fitted = true;
    }
    return list;
}

using Value = std::optional<Real>;
Value decimal_logarithm(const Real& x) { return x > 0 ? Value(log10(x)) : Value(); }

} // namespace

Readings::Readings(const Answers& answers, const Agreements& agreements,
                   const std::vector<std::size_t>& failing, ReferenceOptions options,
                   KnownReadings& known)
    : answers_(answers), agreements_(agreements), options_(std::move(options)), known_(known) {
    options_.digits = {reading_digits, Rounding::nearest, false};
    options_.progress = {};
    std::set<std::size_t> contacts;
    for (const std::size_t i : failing) {
        contacts.insert(answers.questions.list[i].contact);
    }
    find({contacts.begin(), contacts.end()});
    std::map<std::string, std::vector<std::size_t>> right;
    for (std::size_t i = 0; i < agreements.cases.size(); ++i) {
        if (has_value(answers, agreements, i) && agreements.cases[i].pass) {
            right[family_of(answers.questions.list[i])].push_back(i);
        }
    }
    for (const auto& [family, rows] : right) {
        right_.push_back(evenly(rows, most_right_rows));
    }
}

const Reading::Mistakes& Readings::mistakes_in(std::size_t contact) {
    const auto [found, is_new] = mistakes_.try_emplace(contact);
    if (is_new) {
        const scene::Scene& scene = answers_.questions.contacts[contact].scene;
        found->second = diagnose::contact_mistakes(scene);
        if (scene.shear) {
            std::ranges::move(diagnose::shear_mistakes(scene), std::back_inserter(found->second));
        }
    }
    return found->second;
}

void Readings::find(const std::vector<std::size_t>& contacts) {
    list_ = {
        {"sign", "ours with Q and the bulk tension in the other direction",
         "Q is positive towards +x on the body that it acts on", reverse_shear},
        {"x-for-u", "ours with u taken for x", "u runs inwards from the edge: x = a - u, or u - b"},
        {"edges-swapped", "ours at the other edge",
         "left taken for right? u runs inwards from the edge: u = a - x at the right one, u = b "
         "+ x at the left one; swap the edges"}};
    list_[1].place = asked_at([](const Expr&, const Expr& u) { return u; });
    list_[2].place = [](Question& q, const scene::Scene& scene) {
        q.edge = opposite(q.edge);
        return q.at_edge() && (!scene.symmetric() || scene.shear);
    };
    const bool gives_C = std::ranges::any_of(contacts, [&](std::size_t contact) {
        return !parameter_text(answers_.questions.contacts[contact], "C").empty();
    });
    if (gives_C) {
        list_.insert(list_.begin(),
                     Reading{"gap-for-slope",
                             "ours with C taken for the gap's constant, g = C x^(m + 1)",
                             "C is the slope's constant: g' = C x^m", gap_for_slope});
    }
    for (const auto& [name, words, n] : {std::tuple{"one-term", "the first term", 1U},
                                         {"two-term", "the first two terms", 2U},
                                         {"three-term", "the first three terms", 3U}}) {
        list_.push_back({name, std::string(words) + " of ours at the edge",
                         "the pressure is asked for, not an approximation of it"});
        list_.back().place = [n = n](Question& q, const scene::Scene&) {
            const bool pressure = q.quantity == scene::Quantity::p;
            q.quantity = scene::Quantity::local;
            q.k = n;
            return pressure;
        };
    }
    std::set<std::pair<std::string, std::optional<bool>>> known;
    for (const std::size_t contact : contacts) {
        const bool circle = is_circle(answers_.questions.contacts[contact].scene);
        for (const diagnose::Mistake& mistake : mistakes_in(contact)) {
            // A program may take C for 1/R, and yet read R as a diameter.
            for (const auto& only : {std::optional<bool>(), std::optional(circle)}) {
                if ((!only || mistake.name == "radius-as-diameter") &&
                    known.emplace(mistake.what, only).second) {
                    list_.push_back(reading_of(mistake, only));
                }
            }
        }
    }
    list_.push_back({"log10", "the decimal logarithm of ours", "the value itself is asked for"});
    list_.back().value = &decimal_logarithm;
}

Values Readings::values(std::size_t reading, const std::vector<std::size_t>& questions) {
    const Reading& r = list_[reading];
    auto& known = known_[r.name + ": " + r.relation + ": " + r.only];
    std::vector<std::size_t> missing;
    std::ranges::copy_if(questions, std::back_inserter(missing),
                         [&](std::size_t i) { return !known.contains(i); });
    const Values more = found(r, missing);
    for (std::size_t k = 0; k < missing.size(); ++k) {
        known.emplace(missing[k], more[k]);
    }
    Values values;
    std::ranges::transform(questions, std::back_inserter(values),
                           [&](std::size_t i) { return known.at(i); });
    return values;
}

void Readings::fit(const std::vector<std::size_t>& failing) {
    for (std::size_t which = 0; which < with_factor(1, "").size(); ++which) {
        const auto off = [&](std::size_t most) {
            return [&, rows = wrong_rows(answers_, agreements_, evenly(failing, most))](double k) {
                const Values values = found(with_factor(k, "")[which], rows.questions);
                std::vector<double> list;
                for (std::size_t i = 0; i < values.size(); ++i) {
                    const double ratio =
                        values[i] ? Real(rows.answers[i] / *values[i]).convert_to<double>() : 0;
                    list.push_back(std::log(ratio)); // as large for 1/2 as for 2
                }
                return list;
            };
        };
        const auto fitted = diagnose::fitted_factor(off(rows_of_search), off(rows_of_fit));
        if (fitted) {
            list_.push_back(with_factor(fitted->value, fitted->text())[which]);
        }
    }
}

bool Readings::contradicted(std::size_t reading, double most) {
    return list_[reading].contact &&
           std::ranges::any_of(right_, [&](const std::vector<std::size_t>& rows) {
               const auto off =
                   remainders(wrong_rows(answers_, agreements_, rows), values(reading, rows));
               std::size_t wrong = 0;
               for (std::size_t k = 0; k < rows.size(); ++k) {
                   wrong += off.change[k] != 0 && std::abs(off.off[k]) > most ? 1 : 0;
               }
               return 2 * wrong > rows.size();
           });
}

Values Readings::found(const Reading& reading, const std::vector<std::size_t>& which) {
    std::vector<Way> ways;
    std::ranges::transform(which, std::back_inserter(ways),
                           [](std::size_t i) { return Way(i, 0); });
    const auto found = values_otherwise(
        answers_.questions, ways,
        [&](const Way& way, AskedContact& contact) {
            const std::size_t index = answers_.questions.list[way.first].contact;
            return !reading.contact || reading.contact(contact.scene, mistakes_in(index));
        },
        [&](const Way&, Question& q, const scene::Scene& scene) {
            return !reading.place || reading.place(q, scene);
        },
        options_);
    Values values;
    for (const Way& way : ways) {
        const auto ball = found.find(way);
        const bool known = ball != found.end() && !contains_zero(ball->second);
        const Value value = known ? Value(ball->second.midpoint()) : Value();
        values.push_back(value && reading.value ? reading.value(*value) : value);
    }
    return values;
}

} // namespace edgeproof::conformance
