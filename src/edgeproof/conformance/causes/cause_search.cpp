// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/causes/cause_search.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace edgeproof::conformance {
namespace {

constexpr unsigned reading_digits = 30;
constexpr std::size_t most_rows_tried = 60; // enough to select readings to test on all rows
constexpr std::size_t most_right_rows = 12; // of a quantity: enough to contradict a cause
/// Rows fail, and are seen here, if they are wrong by more than same_value: they have a common
/// error of that size by this selection.
constexpr double least_constant = 1e-5;
/// Two answers have a common error by chance with about the probability of their difference over
/// the error. (Those at both edges of a symmetric contact are one.)
constexpr double chance_of_few = 1e-3;

std::vector<std::size_t> evenly(const std::vector<std::size_t>& rows, std::size_t most) {
    std::vector<std::size_t> some;
    const std::size_t n = std::min(rows.size(), most);
    for (std::size_t k = 0; k < n; ++k) {
        some.push_back(rows[k * rows.size() / n]);
    }
    return some;
}

constexpr double same_digits = 6; // as same_value

} // namespace

std::vector<Group> groups_of(const Questions& questions, const std::vector<std::size_t>& rows) {
    std::vector<Group> groups;
    for (const std::size_t row : rows) {
        const Question& q = questions.list[row];
        const std::string family = family_of(q);
        const auto add = [&](const std::string& name) {
            auto known = std::ranges::find(groups, name, &Group::name);
            if (known == groups.end()) {
                known = groups.insert(known, {name, family, {}});
            }
            known->rows.push_back(row);
        };
        add(family);
        if (q.at_edge()) {
            add(family + ", " + scene::edge_name(q.edge) + " edge");
        }
        if (symbol_of(q) != family) {
            add(symbol_of(q));
        }
    }
    std::ranges::stable_sort(groups, std::greater(), [](const Group& g) {
        return std::pair(g.rows.size(), g.name.size() + (g.name.ends_with("_k") ? 0 : 1));
    });
    return groups;
}

std::vector<std::size_t> rows_that_fail(const Answers& answers, const Agreements& agreements,
                                        const std::vector<Convention>& known) {
    std::set<std::size_t> explained;
    for (const Convention& c : known) {
        explained.insert(c.which.begin(), c.which.end());
    }
    std::vector<std::size_t> failing;
    for (std::size_t i = 0; i < agreements.cases.size(); ++i) {
        const CaseAgreement& held = agreements.cases[i];
        if (answers.given[i].state == Answer::State::number && held.no_reference.empty() &&
            !held.pass && held.digits < same_digits && !explained.contains(i) &&
            !contains_zero(agreements.references[i].value.value)) {
            failing.push_back(i);
        }
    }
    return failing;
}

CauseSearch::CauseSearch(const Answers& answers, const Agreements& agreements,
                         const std::vector<std::size_t>& failing, const ReferenceOptions& options,
                         KnownReadings& known)
    : answers_(answers), agreements_(agreements), options_(options), known_(known),
      groups_(groups_of(answers.questions, failing)), factors_(named_factors()) {
    options_.digits = {reading_digits, Rounding::nearest, false};
    options_.progress = {};
    std::set<std::size_t> contacts;
    for (const std::size_t i : failing) {
        contacts.insert(answers.questions.list[i].contact);
    }
    readings_ = readings_of(answers.questions, contacts);
    for (const std::size_t i : failing) {
        ++rows_of_family_[family_of(answers.questions.list[i])];
    }
    std::map<std::string, std::vector<std::size_t>> right;
    for (std::size_t i = 0; i < agreements.cases.size(); ++i) {
        const bool value = answers.given[i].state == Answer::State::number &&
                           agreements.cases[i].no_reference.empty() &&
                           !contains_zero(agreements.references[i].value.value);
        if (value && agreements.cases[i].pass) {
            right[family_of(answers.questions.list[i])].push_back(i);
        }
    }
    for (const auto& [family, rows] : right) {
        right_.push_back(evenly(rows, most_right_rows));
    }
}

std::vector<Convention> CauseSearch::causes() {
    for (const bool named : {true, false}) {
        for (const Group& group : groups_) {
            if (is_done(group) || group.rows.size() < least_rows) {
                continue;
            }
            Explained explained = named ? by_name(group) : by_constant(group);
            if (!explained.likely.empty()) {
                done_.insert(group.rows.begin(), group.rows.end());
                std::erase_if(explained_, [&](const Explained& part) { // of this group
                    return std::ranges::all_of(part.group.rows, [&](std::size_t row) {
                        return std::ranges::find(group.rows, row) != group.rows.end();
                    });
                });
                explained_.push_back(std::move(explained));
            }
        }
    }
    explain_by_others();
    add_causes_of_others();
    std::vector<Convention> found;
    for (Explained& explained : explained_) {
        found.push_back(convention(explained));
    }
    for (const Group& group : groups_) {
        if (auto varying = is_done(group) ? std::nullopt : varying_factor(group)) {
            done_.insert(group.rows.begin(), group.rows.end());
            found.push_back(std::move(*varying));
        }
    }
    return found;
}

bool CauseSearch::is_done(const Group& group) const {
    return std::ranges::all_of(group.rows, [&](std::size_t row) { return done_.contains(row); });
}

CauseSearch::Values CauseSearch::values(std::size_t reading,
                                        const std::vector<std::size_t>& questions) {
    auto& known = known_[key_of(readings_[reading])];
    std::vector<std::size_t> missing;
    for (const std::size_t i : questions) {
        if (!known.contains(i)) {
            missing.push_back(i);
        }
    }
    const Values found =
        values_read_otherwise(answers_, agreements_, readings_[reading], missing, options_);
    for (std::size_t k = 0; k < missing.size(); ++k) {
        known.emplace(missing[k], found[k]);
    }
    Values values;
    for (const std::size_t i : questions) {
        values.push_back(known.at(i));
    }
    return values;
}

std::optional<Fit> CauseSearch::fit(std::size_t reading, const WrongRows& some,
                                    const WrongRows& all) {
    const auto fit = fit_of(some, values(reading, some.questions), noise_);
    return fit && some.size() < all.size() ? fit_of(all, values(reading, all.questions), noise_)
                                           : fit;
}

bool CauseSearch::contradicted(std::size_t reading, const Fit& fit) {
    if (!readings_[reading].contact) {
        return false;
    }
    return std::ranges::any_of(right_, [&](const std::vector<std::size_t>& rows) {
        const Values otherwise = values(reading, rows);
        std::size_t wrong = 0;
        for (std::size_t k = 0; k < rows.size(); ++k) {
            const Real answer = Ball(answers_.given[rows[k]].value, 256).midpoint();
            const double most = std::max(same_value, 3 * fit.held);
            wrong += otherwise[k] && abs(Real(answer / *otherwise[k] - 1)) > most ? 1 : 0;
        }
        return 2 * wrong > rows.size();
    });
}

void CauseSearch::add_factors(const WrongRows& rows, const Values& values,
                              std::optional<std::size_t> swapped, Explained& to) {
    const auto ratio = common_ratio(rows, values);
    if (!ratio) {
        return;
    }
    for (const NamedFactor& factor : factors_) {
        if (!possible(factor, to.group.family) ||
            abs(Real(ratio->value / factor.value - 1)) > most_scatter) {
            continue;
        }
        auto fit = fit_of(rows, times(values, factor.value), noise_);
        const bool smooth = fit && !fit->noise_like.value_or(true);
        if (fit && (fit->dominates || !smooth)) {
            to.likely.push_back(likely(factor, *ratio, std::move(*fit), swapped));
        }
    }
}

bool CauseSearch::possible(const NamedFactor& factor, const std::string& family) {
    return factor.name != std::string_view("mean-for-peak") || family == "p" || family == "c_k";
}

Likely CauseSearch::likely(const NamedFactor& factor, const CommonRatio& ratio, Fit fit,
                           std::optional<std::size_t> swapped) const {
    const std::string ours = swapped ? "ours at the other edge" : "ours";
    // Another modulus changes the pressure, too.
    const bool only_sizes = std::ranges::all_of(rows_of_family_, [](const auto& failing) {
        return failing.first == "a" || failing.first == "b";
    });
    const bool width = only_sizes && (factor.value == 2 || factor.value == Real(1) / 2);
    return {swapped ? "edges-swapped"
            : width ? "full-width-for-half"
                    : factor.name,
            factor.words + ours,
            swapped ? "left taken for right, and a factor"
            : width ? "the whole width of the contact for a half (or the reverse)? a and b are "
                      "the distances of its edges from the origin"
                    : factor.hint,
            factor.value.convert_to<double>(),
            factor.common && !swapped ? 0 : 2,
            false,
            false,
            4 * ratio.error,
            std::move(fit),
            swapped};
}

CauseSearch::Values CauseSearch::all_of(const WrongRows& rows) {
    return {rows.ours.begin(), rows.ours.end()};
}

Likely CauseSearch::likely(std::size_t reading, Fit fit) {
    const Reading& r = readings_[reading];
    const bool refuted = contradicted(reading, fit);
    const int rank = r.name.starts_with("factor") ? 2 : 1;
    return {r.name, r.relation, r.hint, 1, rank, true, refuted, 0, std::move(fit), reading};
}

void CauseSearch::add_readings(const WrongRows& some, const WrongRows& all, Explained& to) {
    const bool whole = is_whole(to.group);
    for (std::size_t r = 0; r < readings_.size(); ++r) {
        if (auto fitted = whole || readings_[r].place ? fit(r, some, all) : std::nullopt) {
            to.likely.push_back(likely(r, std::move(*fitted)));
        } else if (whole && readings_[r].name == "edges-swapped" &&
                   common_ratio(some, values(r, some.questions))) {
            add_factors(all, values(r, all.questions), r, to);
        }
    }
}

void CauseSearch::add_undistinguished(const WrongRows& some, const WrongRows& all, Explained& to) {
    if (to.likely.empty()) {
        return;
    }
    const double unit = unit_of(to);
    std::vector<double> found;
    for (const Likely& l : to.likely) {
        found.push_back(misfit(remainder_of(some, values_of(l, some)), unit));
    }
    const double most =
        *std::ranges::min_element(found) + indistinguishable_misfit(to.likely.front().fit);
    for (std::size_t r = 0; r < readings_.size(); ++r) {
        const bool known = std::ranges::any_of(
            to.likely, [&](const Likely& l) { return l.reading == r && l.factor == 1; });
        const bool possible = is_whole(to.group) || readings_[r].place || unit > same_value;
        if (known || !possible) {
            continue;
        }
        Fit fit = remainder_of(some, values(r, some.questions));
        if (misfit(fit, unit) <= most) {
            to.likely.push_back(likely(r, some.size() < all.size()
                                              ? remainder_of(all, values(r, all.questions))
                                              : std::move(fit)));
        }
    }
    const auto ratio = common_ratio(all, all_of(all));
    for (const NamedFactor& factor : factors_) {
        const bool known = std::ranges::any_of(to.likely, [&](const Likely& l) {
            return l.name == factor.name && l.relation == factor.words + "ours";
        });
        if (!ratio || known || !possible(factor, to.group.family) ||
            abs(Real(ratio->value / factor.value - 1)) > most_scatter) {
            continue;
        }
        if (misfit(remainder_of(some, times(all_of(some), factor.value)), unit) <= most) {
            to.likely.push_back(
                likely(factor, *ratio, remainder_of(all, times(all_of(all), factor.value)), {}));
        }
    }
}

bool CauseSearch::is_whole(const Group& group) const {
    return group.rows.size() == rows_of_family_.at(group.family);
}

CauseSearch::Values CauseSearch::values_of(const Likely& cause, const WrongRows& rows) {
    return times(cause.reading ? values(*cause.reading, rows.questions) : all_of(rows),
                 cause.factor);
}

Explained CauseSearch::by_name(const Group& group) {
    Explained explained{group, {}};
    const WrongRows all = wrong_rows(answers_, agreements_, group.rows);
    const WrongRows some = wrong_rows(answers_, agreements_, evenly(group.rows, most_rows_tried));
    add_factors(all, all_of(all), {}, explained);
    add_readings(some, all, explained);
    if (constant_is_better(all, explained)) {
        return {group, {}};
    }
    add_undistinguished(some, all, explained);
    keep_best(explained);
    add_doubt(all, explained);
    return explained;
}

Likely CauseSearch::constant(const CommonRatio& ratio, Fit fit) {
    return {"factor",
            ratio.text() + " times ours",
            "a constant of proportionality that differs; scale by its inverse",
            ratio.value.convert_to<double>(),
            rank_of_constant,
            false,
            false,
            0,
            std::move(fit)};
}

CauseSearch::Values CauseSearch::times(Values values, const Real& factor) {
    for (auto& value : values) {
        if (value) {
            *value *= factor;
        }
    }
    return values;
}

std::optional<Likely> CauseSearch::constant_of(const Group& group, const WrongRows& all) const {
    const auto ratio = common_ratio(all, all_of(all));
    if (!ratio || abs(Real(ratio->value - 1)) < std::max(least_constant, 3 * noise_)) {
        return {};
    }
    auto fit = fit_of(all, times(all_of(all), ratio->value), noise_);
    const double unscattered = std::max(same_value, 3 * noise_);
    const double same_of_few =
        std::min(same_value, chance_of_few * std::abs(Real(ratio->value - 1).convert_to<double>()));
    const bool accepted = fit && (is_whole(group) || fit->held <= same_value) &&
                          fit->noise_like.value_or(fit->held <= unscattered) &&
                          (all.size() >= least_rows_of_constant || fit->held <= same_of_few);
    return accepted ? std::optional(constant(*ratio, std::move(*fit))) : std::nullopt;
}

bool CauseSearch::constant_is_better(const WrongRows& all, const Explained& named) const {
    const auto other = named.likely.empty() ? std::nullopt : constant_of(named.group, all);
    if (!other) {
        return false;
    }
    const double unit = std::max(other->fit.scatter, noise_);
    const bool is_constant = other->fit.noise_like.value_or(other->fit.held <= same_value);
    return std::ranges::all_of(named.likely, [&](const Likely& l) {
        return !l.fit.noise_like.value_or(false) && (is_constant || !l.fit.dominates) &&
               misfit(l.fit, unit) > misfit(other->fit, unit) + indistinguishable_misfit(l.fit);
    });
}

Explained CauseSearch::by_constant(const Group& group) {
    Explained explained{group, {}};
    const WrongRows all = wrong_rows(answers_, agreements_, group.rows);
    if (auto found = constant_of(group, all)) {
        noise_ = std::max(noise_, found->fit.scatter);
        explained.likely.push_back(std::move(*found));
        add_undistinguished(wrong_rows(answers_, agreements_, evenly(group.rows, most_rows_tried)),
                            all, explained);
        keep_best(explained);
    }
    return explained;
}

} // namespace edgeproof::conformance
