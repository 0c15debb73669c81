// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/causes/convention.hpp"

#include "edgeproof/conformance/causes/readings.hpp"
#include "edgeproof/diagnose/fit.hpp"
#include "edgeproof/diagnose/mistakes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace edgeproof::conformance {
namespace {

using diagnose::Candidate;
using diagnose::Fit;
using diagnose::least_gain;
using diagnose::NamedFactor;
using diagnose::same_value;

/// A number without a name, and one with an unusual name, are not distinguished by answers that do
/// not determine it better than this, or leave a greater smooth remainder.
constexpr double unlikely_by_chance = 6e-4;
/// Fewer rows with noise have a common factor by chance.
constexpr std::size_t least_rows_of_constant = 6;
constexpr std::size_t most_rows_tried = 60; // enough to select readings to test on all rows
/// Rows fail, and are seen here, if they are wrong by more than same_value: they have a common
/// error of that size by this selection.
constexpr double least_constant = 1e-5;
/// Two answers have a common error by chance with about the probability of their difference over
/// the error. (Those at both edges of a symmetric contact are one.)
constexpr double chance_of_few = 1e-3;
/// Answers with fewer digits scatter by percents: a factor with a name and another cause may have
/// the effect of a third one.
constexpr double digits_of_percents = 1.5;
constexpr unsigned most_cause_digits = 40;
constexpr double same_digits = 6;        ///< as diagnose::same_value
constexpr std::size_t part_outside = 20; ///< one row of this number lies outside, on each side
/// Relative standard deviations that an interval exceeds: noise of 12 answers has a range of more
/// than 6 in one case of a thousand.
constexpr double noise_in_interval = 6;

/// The median of the ratios of the answers to some values, and its standard error, relative.
struct CommonRatio {
    Real value;
    double error = 0;
    /// |value/of - 1|
    [[nodiscard]] double off(const Real& of) const { return std::abs(relative(value, of)); }
    [[nodiscard]] std::string text() const { ///< with its significant digits
        constexpr double most_printed = 1e-10;
        const double digits = -std::log10(error + most_printed);
        return fmt::format("{:.{}g}", value.convert_to<double>(),
                           static_cast<int>(std::max(2.0, std::round(digits))));
    }
};

/// Returns nothing if fewer than nine of ten rows have a value.
std::optional<CommonRatio> common_ratio(const WrongRows& rows, const Values& values) {
    std::vector<Real> ratios;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        if (values[k]) {
            ratios.emplace_back(rows.answers[k] / *values[k]);
        }
    }
    if (!diagnose::enough(ratios.size(), rows.size())) {
        return {};
    }
    const auto middle = ratios.begin() + static_cast<long>(ratios.size() / 2);
    std::nth_element(ratios.begin(), middle, ratios.end());
    CommonRatio common{*middle};
    if (common.value == 0) {
        return {};
    }
    std::vector<double> about;
    for (const Real& ratio : ratios) {
        about.push_back(std::abs(relative(ratio, common.value)));
    }
    common.error = diagnose::error_of_median(std::move(about));
    return common;
}

/// Failing rows with a common property.
struct Group {
    std::string name;              ///< "p", "p, left edge", "c_1"
    std::string family;            ///< "p", "c_k"
    std::vector<std::size_t> rows; ///< questions
    std::vector<diagnose::Candidate> likely = {};
};

/// Groups the rows by quantity (c_k and s_k together, and separately), at both edges and at each
/// edge. The largest group comes first; among groups of the same rows, the most specific name.
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

/// The digits of a relative error.
double cause_digits(double off) {
    return off == 0 ? most_cause_digits
                    : std::clamp(-std::log10(off), 0.0, double(most_cause_digits));
}

/// Adds the named factors near answers of `least` to `most` times ours (diagnose::near_factors()).
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

/// The interval of the ratio of answers and ours, without a twentieth of the rows on each side.
std::pair<double, double> interval_of(const WrongRows& all) {
    std::vector<double> ratios = remainders(all, all.ours).off;
    std::ranges::sort(ratios);
    const std::size_t outside = ratios.size() / part_outside;
    return {1 + ratios[outside], 1 + ratios[ratios.size() - 1 - outside]};
}

/// The interval, if it is not due to noise, and named factors are near it.
std::optional<Convention> varying_factor(const WrongRows& all, double noise) {
    const auto [least, most] = interval_of(all);
    const double wide = noise_in_interval * noise * std::abs(most + least) / 2;
    Convention c;
    if (!remainder_of(remainders(all, all.ours)).noise_like.value_or(most - least < wide)) {
        add_near_factors(c, least, most);
    }
    if (c.also.empty()) {
        return {};
    }
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

class CauseSearch {
public:
    CauseSearch(const Answers& answers, const Agreements& agreements,
                const std::vector<std::size_t>& failing, const ReferenceOptions& options,
                KnownReadings& known)
        : answers_(answers), agreements_(agreements),
          readings_(answers, agreements, failing, options, known),
          factors_(diagnose::named_factors()), groups_(groups_of(answers.questions, failing)) {
        for (const std::size_t i : failing) {
            ++rows_of_family_[family_of(answers.questions.list[i])];
        }
    }

    std::vector<Convention> causes() {
        for (const bool named : {true, false}) {
            for (const Group& group : groups_) {
                if (!is_done(group) && group.rows.size() >= diagnose::least_rows) {
                    keep(explained(group, named));
                }
            }
        }
        explain_by_others();
        add_causes_of_others();
        std::vector<Convention> found;
        std::ranges::transform(explained_, std::back_inserter(found),
                               [&](const Group& group) { return convention(group); });
        for (const Group& group : groups_) {
            const bool known =
                is_done(group) || !is_whole(group) || group.rows.size() < least_rows_of_constant;
            if (auto varying = known ? std::nullopt : varying_factor(rows_of(group.rows), noise_)) {
                varying->of = group.family;
                done_.insert(group.rows.begin(), group.rows.end());
                found.push_back(std::move(*varying));
            }
        }
        return found;
    }

private:
    [[nodiscard]] bool is_done(const Group& group) const {
        return std::ranges::all_of(group.rows,
                                   [&](std::size_t row) { return done_.contains(row); });
    }
    /// True if these are all failing rows of the quantity.
    [[nodiscard]] bool is_whole(const Group& group) const {
        return group.rows.size() == rows_of_family_.at(group.family);
    }
    [[nodiscard]] WrongRows rows_of(const std::vector<std::size_t>& questions) const {
        return wrong_rows(answers_, agreements_, questions);
    }
    [[nodiscard]] Fit remainder(const Candidate& cause, const WrongRows& rows) {
        const Values values =
            cause.source ? readings_.values(*cause.source, rows.questions) : rows.ours;
        return remainder_of(remainders(rows, times(values, cause.factor)));
    }
    [[nodiscard]] Fit remainder(std::size_t reading, const WrongRows& rows) {
        return remainder_of(remainders(rows, readings_.values(reading, rows.questions)));
    }
    [[nodiscard]] std::optional<Fit> fit(const WrongRows& rows, const Values& values) const {
        return fit_of(remainders(rows, values), noise_);
    }

    /// Keeps a group that is explained, in place of its parts.
    void keep(Group group) {
        if (group.likely.empty()) {
            return;
        }
        done_.insert(group.rows.begin(), group.rows.end());
        std::erase_if(explained_, [&](const Group& part) {
            return std::ranges::all_of(part.rows, [&](std::size_t row) {
                return std::ranges::find(group.rows, row) != group.rows.end();
            });
        });
        explained_.push_back(std::move(group));
    }

    /// The causes of a group, with a name or as a constant, that the answers do not distinguish.
    Group explained(Group group, bool named) {
        const WrongRows all = rows_of(group.rows);
        const WrongRows some = rows_of(evenly(group.rows, most_rows_tried));
        const auto constant = constant_of(group, all);
        if (named) {
            add_factors(all, all.ours, {}, group);
            add_readings(some, all, group);
            if (constant && constant_is_better(constant->fit, group.likely, noise_)) {
                group.likely.clear();
            }
        } else if (constant) {
            noise_ = std::max(noise_, constant->fit.scatter);
            group.likely.push_back(*constant);
        }
        if (!group.likely.empty()) {
            add_undistinguished(some, all, group);
            keep_best(group.likely, noise_);
        }
        if (named && !group.likely.empty()) {
            add_doubt(all, group);
        }
        return group;
    }

    [[nodiscard]] Candidate candidate(const NamedFactor& factor, const CommonRatio& ratio, Fit fit,
                                      std::optional<std::size_t> swapped) const {
        const double k = factor.value.convert_to<double>();
        const auto rank =
            factor.common && !swapped ? Candidate::common_factor : Candidate::other_factor;
        Candidate c{factor.name, factor.words + "ours", factor.hint, k, rank, swapped};
        // Another modulus changes the pressure, too.
        const bool only_sizes = std::ranges::all_of(rows_of_family_, [](const auto& failing) {
            return failing.first == "a" || failing.first == "b";
        });
        if (swapped) {
            c.name = "edges-swapped";
            c.what += " at the other edge";
            c.advice = "left taken for right, and a factor";
        } else if (only_sizes && (k == 2 || k == 0.5)) {
            c.name = "full-width-for-half";
            c.advice = "the whole width of the contact for a half (or the reverse)? a and b are "
                       "the distances of its edges from the origin";
        }
        c.doubtful = 4 * ratio.error;
        c.fit = std::move(fit);
        return c;
    }
    /// Calls add(factor, ratio) for the named factors near the ratio of the answers to these
    /// values.
    template <class Add>
    void for_factors(const WrongRows& rows, const Values& values, const std::string& family,
                     const Add& add) const {
        const auto ratio = common_ratio(rows, values);
        for (const NamedFactor& factor : factors_) {
            if (ratio && factor.possible(family) &&
                ratio->off(factor.value) <= diagnose::most_scatter) {
                add(factor, *ratio);
            }
        }
    }
    /// Adds the named factors between the answers and these values.
    void add_factors(const WrongRows& rows, const Values& values,
                     std::optional<std::size_t> swapped, Group& to) {
        for_factors(rows, values, to.family, [&](const auto& factor, const auto& ratio) {
            auto found = fit(rows, times(values, factor.value));
            if (found && (found->dominates || found->noise_like.value_or(true))) {
                to.likely.push_back(candidate(factor, ratio, std::move(*found), swapped));
            }
        });
    }

    [[nodiscard]] Candidate candidate(std::size_t reading, Fit fit) {
        const Reading& r = readings_.list()[reading];
        const bool factor = r.name.starts_with("factor");
        Candidate c{
            r.name, r.relation, r.hint, 1, factor ? Candidate::other_factor : Candidate::mistake,
            reading};
        c.contradicted = readings_.contradicted(reading, std::max(same_value, 3 * fit.held));
        c.fit = std::move(fit);
        return c;
    }
    /// Adds the readings that explain the rows: mistakes in the data of a contact and in the value
    /// only if these are all failing rows of the quantity, and so for exchanged edges with a
    /// factor.
    void add_readings(const WrongRows& some, const WrongRows& all, Group& to) {
        const bool whole = is_whole(to);
        const auto& readings = readings_.list();
        for (std::size_t r = 0; r < readings.size(); ++r) {
            if (!whole && !readings[r].place) {
                continue;
            }
            auto found = fit(some, readings_.values(r, some.questions));
            if (found) { // the others are asked only if these fit
                found = fit(all, readings_.values(r, all.questions));
            }
            if (found) {
                to.likely.push_back(candidate(r, std::move(*found)));
            } else if (whole && readings[r].name == "edges-swapped" &&
                       common_ratio(some, readings_.values(r, some.questions))) {
                add_factors(all, readings_.values(r, all.questions), r, to);
            }
        }
    }
    /// Adds the readings and factors that fit the rows as well as the causes found, however little
    /// they change or however improbable the noise is with them: the answers do not distinguish
    /// them. If the answers have noise, it may hide what a mistake in the data of a contact does to
    /// other rows of the quantity.
    void add_undistinguished(const WrongRows& some, const WrongRows& all, Group& to) {
        const double unit = unit_of(to.likely, noise_);
        const double most = most_misfit(to.likely, unit, some.size(),
                                        [&](const Candidate& c) { return remainder(c, some); });
        const auto& readings = readings_.list();
        for (std::size_t r = 0; r < readings.size(); ++r) {
            const bool known = std::ranges::any_of(
                to.likely, [&](const Candidate& c) { return c.source == r && c.factor == 1; });
            if (known || !(is_whole(to) || readings[r].place || unit > same_value)) {
                continue;
            }
            if (misfit(remainder(r, some), unit) <= most) {
                to.likely.push_back(candidate(r, remainder(r, all)));
            }
        }
        for_factors(all, all.ours, to.family, [&](const auto& factor, const auto& ratio) {
            Candidate c = candidate(factor, ratio, {}, {});
            if (!contains(to.likely, c) && misfit(remainder(c, some), unit) <= most) {
                c.fit = remainder(c, all);
                to.likely.push_back(std::move(c));
            }
        });
    }
    static bool contains(const std::vector<Candidate>& list, const Candidate& cause) {
        return std::ranges::any_of(list, [&](const Candidate& c) { return c.is(cause); });
    }

    /// The ratio of the answers to ours, as a cause.
    [[nodiscard]] static Candidate constant(const CommonRatio& ratio, Fit fit) {
        Candidate c{"factor",
                    ratio.text() + " times ours",
                    "a constant of proportionality that differs; scale by its inverse",
                    ratio.value.convert_to<double>(),
                    Candidate::constant,
                    {}};
        c.fit = std::move(fit);
        return c;
    }
    /// A constant without a name: only of all failing rows of a quantity, and only if the answers
    /// scatter about it from point to point, or no more than those of the other quantities, so that
    /// it is one to the accuracy of the answers.
    [[nodiscard]] std::optional<Candidate> constant_of(const Group& group,
                                                       const WrongRows& all) const {
        const auto ratio = common_ratio(all, all.ours);
        if (!ratio || ratio->off(1) < std::max(least_constant, 3 * noise_)) {
            return {};
        }
        auto found = fit(all, times(all.ours, ratio->value));
        const double unscattered = std::max(same_value, 3 * noise_);
        const double same_of_few = std::min(same_value, chance_of_few * ratio->off(1));
        const bool accepted = found && (is_whole(group) || found->held <= same_value) &&
                              found->noise_like.value_or(found->held <= unscattered) &&
                              (all.size() >= least_rows_of_constant || found->held <= same_of_few);
        return accepted ? std::optional(constant(*ratio, std::move(*found))) : std::nullopt;
    }
    /// Adds a constant without a name, if noise leaves room for one.
    void add_doubt(const WrongRows& rows, Group& to) {
        const auto ratio = common_ratio(rows, rows.ours);
        if (!ratio || 4 * ratio->error < unlikely_by_chance) {
            return;
        }
        auto found = fit(rows, times(rows.ours, ratio->value));
        if (found && constant_is_possible(*found, to.likely, noise_)) {
            noise_ = std::max(noise_, found->scatter);
            to.likely.push_back(constant(*ratio, std::move(*found)));
        }
    }

    /// Explains a quantity that no cause fits by one of another quantity, if that leaves noise
    /// only: its noise may have a mean of several deviations by chance.
    void explain_by_others() {
        std::vector<Group> more;
        for (Group group : groups_) {
            if (is_done(group) || !is_whole(group)) {
                continue;
            }
            const WrongRows rows = rows_of(group.rows);
            const double before = remainder_of(remainders(rows, rows.ours)).scatter;
            for (const Group& other : explained_) {
                for (Candidate cause : other.likely) {
                    cause.fit = remainder(cause, rows);
                    if (cause.fit.noise_like.value_or(false) &&
                        least_gain * cause.fit.scatter < before) {
                        group.likely.push_back(std::move(cause));
                    }
                }
            }
            if (!group.likely.empty()) {
                done_.insert(group.rows.begin(), group.rows.end());
                more.push_back(std::move(group));
            }
        }
        std::ranges::move(more, std::back_inserter(explained_));
    }
    /// Adds to each group the causes of other groups that fit it as well as its own or better: a
    /// cause that is established for one quantity need not change another clearly.
    void add_causes_of_others() {
        const std::vector<Group> before = explained_;
        for (Group& group : explained_) {
            const WrongRows rows = rows_of(group.rows);
            for (const Group& other : before) {
                for (Candidate cause : other.likely) {
                    // The text of a constant without a name may be that of a named factor.
                    if (!contains(group.likely, cause)) {
                        cause.fit = remainder(cause, rows);
                        group.likely.push_back(std::move(cause));
                    }
                }
            }
            keep_best(group.likely, noise_);
        }
    }

    /// The number of rows that a cause explains in all groups.
    [[nodiscard]] std::size_t rows_of(const Candidate& cause) const {
        std::size_t rows = 0;
        for (const Group& group : explained_) {
            std::size_t most = 0;
            for (const Candidate& c : group.likely) {
                most = c.is(cause) ? std::max(most, c.fit.rows) : most;
            }
            rows += most;
        }
        return rows;
    }
    /// The cause of a group that explains most rows of all groups, and the others. A constant
    /// without a name must explain twice as many rows.
    [[nodiscard]] Convention convention(const Group& group) const {
        const Candidate& first =
            *std::ranges::max_element(group.likely, {}, [&](const Candidate& candidate) {
                return (candidate.rank == Candidate::constant ? 1 : 2) * rows_of(candidate);
            });
        Convention c;
        c.of = first.source && first.factor == 1 ? group.family : group.name;
        c.relation = first.what;
        c.hint = first.advice;
        c.name = first.name;
        c.factor = first.factor;
        c.rows = first.fit.rows;
        c.failing = group.rows.size();
        c.digits = cause_digits(first.fit.worst);
        c.held = cause_digits(first.fit.held);
        c.remains = first.fit.noise_like.value_or(true) ? 0 : first.fit.held;
        for (const Candidate& other : group.likely) {
            if (other.what != c.relation && std::ranges::find(c.also, other.what) == c.also.end()) {
                c.also.push_back(other.what);
                c.equally_likely.push_back(other.name);
            }
        }
        if (first.rank == Candidate::other_factor &&
            std::max(first.doubtful, c.remains) > unlikely_by_chance) {
            c.also.emplace_back(c.remains == 0
                                    ? "a constant without a name"
                                    : "a factor that varies, near that number by chance");
            c.equally_likely.emplace_back("factor");
        }
        const auto [least, most] = interval_of(rows_of(group.rows));
        // A mistake that leaves a smooth remainder may have nearly the effect of a factor by
        // chance.
        if (first.rank == Candidate::mistake && c.remains > unlikely_by_chance) {
            add_near_factors(c, least, most);
        }
        if (first.rank == Candidate::constant) {
            add_near_factors(c, c.factor, c.factor);
        } else if (c.held < digits_of_percents) {
            add_near_factors(c, (least + most) / 2, (least + most) / 2);
        }
        return c;
    }

    const Answers& answers_;
    const Agreements& agreements_;
    Readings readings_;
    std::vector<NamedFactor> factors_;
    std::vector<Group> groups_;
    std::map<std::string, std::size_t> rows_of_family_; ///< that fail
    std::vector<Group> explained_;
    std::set<std::size_t> done_; ///< questions
    double noise_ = 0;           ///< the scatter of the answers, where known
};

/// Returns the rows with wrong values, not only with too few digits, that none of `known` explains.
std::vector<std::size_t> rows_that_fail(const Answers& answers, const Agreements& agreements,
                                        const std::vector<Convention>& known) {
    std::set<std::size_t> explained;
    for (const Convention& c : known) {
        explained.insert(c.which.begin(), c.which.end());
    }
    std::vector<std::size_t> failing;
    for (std::size_t i = 0; i < agreements.cases.size(); ++i) {
        const CaseAgreement& held = agreements.cases[i];
        if (has_value(answers, agreements, i) && !held.pass && held.digits < same_digits &&
            !explained.contains(i)) {
            failing.push_back(i);
        }
    }
    return failing;
}

/// Merges equal conventions of several quantities.
std::vector<Convention> merged(const std::vector<Convention>& found) {
    std::vector<Convention> merged;
    for (const Convention& c : found) {
        const auto same = std::ranges::find_if(merged, [&](const Convention& m) {
            return m.relation == c.relation && m.hint == c.hint;
        });
        if (same == merged.end()) {
            merged.push_back(c);
            continue;
        }
        same->of += "; " + c.of;
        for (auto list : {&Convention::also, &Convention::equally_likely}) {
            std::erase_if((*same).*list, [&](const std::string& other) {
                return std::ranges::find(c.*list, other) == (c.*list).end();
            });
        }
        same->remains = std::max(same->remains, c.remains);
        same->digits = std::min(same->digits, c.digits);
        same->held = std::min(same->held, c.held);
        same->rows += c.rows;
        same->failing += c.failing;
    }
    return merged;
}

} // namespace

std::vector<Convention> infer_conventions(const Answers& answers, const Agreements& agreements,
                                          const ReferenceOptions& options, KnownReadings* known) {
    const PrecisionScope scope(most_cause_digits + 20);
    std::vector<Convention> found = infer_precision_loss(answers, agreements);
    std::ranges::move(infer_cancellation(answers, agreements), std::back_inserter(found));
    std::vector<std::size_t> failing = rows_that_fail(answers, agreements, found);
    failing.resize(std::min(failing.size(), most_failing));
    if (failing.size() >= diagnose::least_rows) {
        KnownReadings own;
        CauseSearch search(answers, agreements, failing, options, known == nullptr ? own : *known);
        std::ranges::move(search.causes(), std::back_inserter(found));
    }
    return merged(found);
}

std::vector<std::string> unexplained(const Answers& answers, const Agreements& agreements,
                                     const std::vector<Convention>& conventions) {
    std::string explained;
    for (const Convention& c : conventions) {
        explained += "; " + c.of;
    }
    std::map<std::string, std::pair<std::size_t, bool>> families; // rows, explained
    for (const std::size_t i : rows_that_fail(answers, agreements, conventions)) {
        const Question& q = answers.questions.list[i];
        auto& [rows, known] = families[family_of(q)];
        ++rows;
        for (const std::string& name : {family_of(q), symbol_of(q)}) {
            known = known || (explained + ";").find("; " + name + ";") != std::string::npos ||
                    explained.find("; " + name + ",") != std::string::npos;
        }
    }
    std::vector<std::string> names;
    for (const auto& [family, rows] : families) {
        if (rows.first >= diagnose::least_rows && !rows.second) {
            names.push_back(family);
        }
    }
    return names;
}

} // namespace edgeproof::conformance
