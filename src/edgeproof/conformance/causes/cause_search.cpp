// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/conformance/causes/readings.hpp"
#include "edgeproof/diagnose/diagnose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

namespace edgeproof::conformance {
namespace {

using diagnose::Candidate;
using diagnose::Fit;
using diagnose::same_value;

/// A number without a name, and one with an unusual name, are not distinguished by answers that do
/// not determine it better than this, or leave a greater smooth remainder.
constexpr double unlikely_by_chance = 6e-4;
/// Fewer rows with noise have a common factor by chance.
constexpr std::size_t least_rows_of_constant = 6;
constexpr std::size_t most_rows_tried = 60; // enough to select causes to test on all rows
/// Rows fail, and are seen here, if they are wrong by more than same_value: they have a common
/// error of that size by this selection.
constexpr double least_constant = 1e-5;
/// Two answers have a common error by chance with about the probability of their difference over
/// the error. (Those at both edges of a symmetric contact are one.)
constexpr double chance_of_few = 1e-3;
/// Answers with fewer digits scatter by percents: a factor with a name and another cause may have
/// the effect of a third one.
constexpr double digits_of_percents = 1.5;

/// Four standard errors of the common factor of rows, relative, from what it leaves.
double doubt_of(const Fit& fit) {
    const double middle = diagnose::sorted_at(fit.off, 0.5);
    std::vector<double> about;
    for (const double off : fit.off) {
        about.push_back(std::abs((off - middle) / (1 + middle)));
    }
    return 4 * diagnose::error_of_median(std::move(about));
}

class CauseSearch {
public:
    CauseSearch(const Answers& answers, const Agreements& agreements,
                const std::vector<std::size_t>& failing, const ReferenceOptions& options,
                KnownReadings& known)
        : answers_(answers), agreements_(agreements), failing_(failing),
          readings_(answers, agreements, failing, options, known),
          groups_(groups_of(answers, agreements, failing)) {
        find_possible();
    }

    std::vector<Convention> causes() {
        for (const Group& group : groups_) {
            if (!is_done(group) && group.rows.size() >= diagnose::least_rows) {
                keep(explained(group));
            }
        }
        add_causes_of_others();
        std::vector<Convention> found;
        std::ranges::transform(explained_, std::back_inserter(found),
                               [&](const Group& group) { return convention(group); });
        for (const Group& group : groups_) {
            const bool known =
                is_done(group) || !group.whole || group.rows.size() < least_rows_of_constant;
            if (auto varying = known ? std::nullopt : varying_factor(group, noise_)) {
                finish(group);
                found.push_back(std::move(*varying));
            }
        }
        return found;
    }

private:
    [[nodiscard]] bool is_done(const Group& group) const {
        return std::ranges::all_of(group.rows.questions,
                                   [&](std::size_t row) { return done_.contains(row); });
    }
    void finish(const Group& group) {
        done_.insert(group.rows.questions.begin(), group.rows.questions.end());
    }
    /// Keeps a group that is explained, in place of its parts.
    void keep(Group group) {
        if (group.likely.empty()) {
            return;
        }
        finish(group);
        const auto& all = group.rows.questions; // in rising order
        std::erase_if(explained_, [&](const Group& part) {
            return std::ranges::includes(all, part.rows.questions);
        });
        explained_.push_back(std::move(group));
    }

    /// The named factors of ours, the readings, and the factors of ours at the other edge.
    void find_possible() {
        // Another modulus changes the pressure, too.
        const bool only_sizes = std::ranges::all_of(
            groups_, [](const Group& g) { return g.family == "a" || g.family == "b"; });
        const std::vector<diagnose::NamedFactor> factors = diagnose::named_factors();
        for (const diagnose::NamedFactor& f : factors) {
            Candidate& c = possible_.emplace_back(
                Candidate{f.name, f.words + "ours", f.hint, f.value,
                          f.common ? Candidate::common_factor : Candidate::other_factor});
            if (only_sizes && (f.value == 2 || 2 * f.value == 1)) {
                c.name = "full-width-for-half";
                c.advice = "the whole width of the contact for a half (or the reverse)? a and b "
                           "are the distances of its edges from the origin";
            }
        }
        add_readings(0);
        const auto& readings = readings_.list();
        const auto other_edge = std::ranges::find(readings, "edges-swapped", &Reading::name);
        other_edge_ = static_cast<std::size_t>(other_edge - readings.begin());
        for (const diagnose::NamedFactor& f : factors) {
            possible_.push_back({other_edge->name, f.words + "ours at the other edge",
                                 "left taken for right, and a factor", f.value,
                                 Candidate::other_factor, other_edge_});
        }
    }
    /// Adds the readings from this one on.
    void add_readings(std::size_t first) {
        const auto& readings = readings_.list();
        for (std::size_t r = first; r < readings.size(); ++r) {
            const Reading& one = readings[r];
            const auto rank = one.fitted                       ? Candidate::constant
                              : one.name.starts_with("factor") ? Candidate::other_factor
                                                               : Candidate::mistake;
            possible_.push_back({one.name, one.relation, one.hint, 1, rank, r});
        }
    }
    /// Mistakes in the data of a contact and in the value are possible only for all failing rows of
    /// the quantity, and so are exchanged edges with a factor.
    [[nodiscard]] bool possible(const Candidate& cause, const Group& group) const {
        return cause.source
                   ? group.whole || (readings_.list()[*cause.source].place && cause.factor == 1)
                   : diagnose::is_possible(cause.name, group.family);
    }

    /// The medians of the ratios of the answers to ours, and to ours at the other edge.
    struct Medians {
        double ours;
        double other_edge;
        /// False for a factor that is too far from the median to fit.
        [[nodiscard]] bool near(const Candidate& cause) const {
            const double k = cause.factor.convert_to<double>();
            return (cause.source && k == 1) ||
                   std::abs((cause.source ? other_edge : ours) / k - 1) <= diagnose::most_scatter;
        }
    };
    [[nodiscard]] Medians medians_of(const WrongRows& rows) {
        const auto median = [](const diagnose::Remainders& left) {
            return 1 + diagnose::sorted_at(left.off, 0.5);
        };
        return {median(remainders(rows, rows.ours)),
                median(remainders(rows, readings_.values(other_edge_, rows.questions)))};
    }

    [[nodiscard]] diagnose::Remainders left_by(const Candidate& cause, const WrongRows& rows) {
        const Values values =
            cause.source ? readings_.values(*cause.source, rows.questions) : rows.ours;
        return remainders(rows, times(values, cause.factor));
    }
    [[nodiscard]] Fit remainder(const Candidate& cause, const WrongRows& rows) {
        return remainder_of(left_by(cause, rows));
    }
    /// A factor may leave only noise, unless it dominates the error.
    [[nodiscard]] std::optional<Fit> fit(const Candidate& cause, const WrongRows& rows) {
        auto found = fit_of(left_by(cause, rows), noise_);
        const bool reading = cause.source && cause.factor == 1;
        return found && (reading || found->dominates || found->noise_like.value_or(true))
                   ? found
                   : std::nullopt;
    }
    void add(Candidate cause, Fit fit, Group& to) {
        cause.contradicted =
            cause.source && cause.factor == 1 &&
            readings_.contradicted(*cause.source, std::max(same_value, 3 * fit.held));
        cause.fit = std::move(fit);
        to.likely.push_back(std::move(cause));
    }

    /// The causes of a group, with a name or as a constant, that the answers do not distinguish.
    Group explained(Group group) {
        const WrongRows some =
            wrong_rows(answers_, agreements_, evenly(group.rows.questions, most_rows_tried));
        const Medians medians = medians_of(some);
        for (const Candidate& cause : possible_) {
            if (cause.rank != Candidate::constant && possible(cause, group) &&
                medians.near(cause) && fit(cause, some)) { // the others only if these fit
                if (auto found = fit(cause, group.rows)) {
                    add(cause, std::move(*found), group);
                }
            }
        }
        const std::vector<Candidate> fitted = fitted_to(group);
        if (std::ranges::any_of(fitted, [&](const Candidate& c) {
                return constant_is_better(c.fit, group.likely, noise_);
            })) {
            group.likely.clear();
        }
        const bool named = !group.likely.empty();
        if (!named) {
            group.likely = fitted;
        }
        if (!group.likely.empty()) {
            add_undistinguished(some, medians, group);
            keep_best(group.likely, noise_);
        }
        if (named && !group.likely.empty()) {
            add_doubt(group);
        }
        return group;
    }

    /// Adds the readings and factors that fit the rows as well as the causes found, however little
    /// they change or however improbable the noise is with them: the answers do not distinguish
    /// them. If the answers have noise, it may hide what a mistake in the data of a contact does to
    /// other rows of the quantity.
    void add_undistinguished(const WrongRows& some, const Medians& medians, Group& to) {
        const double unit = unit_of(to.likely, noise_);
        const double most = most_misfit(to.likely, unit, some.size(),
                                        [&](const Candidate& c) { return remainder(c, some); });
        for (const Candidate& cause : possible_) {
            const bool known = std::ranges::any_of(to.likely, [&](const Candidate& c) {
                return c.is(cause) && c.source == cause.source;
            });
            const bool plain = !cause.source || cause.factor == 1;
            if (known || !plain || !medians.near(cause) ||
                !(possible(cause, to) || (cause.source && unit > same_value))) {
                continue;
            }
            if (misfit(remainder(cause, some), unit) <= most) {
                add(cause, remainder(cause, to.rows), to);
            }
        }
    }

    /// The causes without a name that explain a group to the accuracy of the answers: a constant;
    /// and, if no other does, the readings with a factor that is fitted to all failing rows.
    [[nodiscard]] std::vector<Candidate> fitted_to(const Group& group) {
        std::vector<Candidate> list;
        if (auto found = constant_of(group)) {
            list.push_back(std::move(*found));
        }
        const auto accurate = [&](const Candidate& c) { return is_accurate(c.fit, noise_); };
        if (!group.whole || group.rows.size() < least_rows_of_constant ||
            std::ranges::any_of(group.likely, accurate)) {
            return list;
        }
        if (!fitted_) {
            fitted_ = true;
            const std::size_t first = readings_.list().size();
            readings_.fit(failing_);
            add_readings(first);
        }
        for (Candidate c : possible_) {
            if (auto found = c.rank == Candidate::constant ? fit(c, group.rows) : std::nullopt) {
                c.fit = std::move(*found);
                // Nine of ten values of noise are less than 1.6 standard deviations.
                if (accurate(c) && 2 * c.fit.rows >= group.rows.size() &&
                    c.fit.held <= std::max(same_value, 3 * c.fit.scatter)) {
                    list.push_back(std::move(c));
                }
            }
        }
        return list;
    }

    /// The median of the ratios of the answers to ours, as a cause, if it explains the rows.
    [[nodiscard]] std::optional<Candidate> constant(const WrongRows& rows) {
        std::vector<Real> ratios;
        for (std::size_t k = 0; k < rows.size(); ++k) {
            ratios.emplace_back(rows.answers[k] / *rows.ours[k]);
        }
        const auto middle = ratios.begin() + static_cast<long>(ratios.size() / 2);
        std::nth_element(ratios.begin(), middle, ratios.end());
        Candidate c{"factor",
                    {},
                    "a constant of proportionality that differs; scale by its inverse",
                    *middle,
                    Candidate::constant};
        auto found = c.factor == 0 ? std::nullopt : fit_of(left_by(c, rows), noise_);
        if (!found) {
            return {};
        }
        const auto factor = c.factor.convert_to<double>();
        c.what = diagnose::FittedFactor{factor, std::abs(factor) * doubt_of(*found) / 4}.text() +
                 " times ours";
        c.fit = std::move(*found);
        return c;
    }
    /// A constant without a name: only of all failing rows of a quantity, and only if the answers
    /// scatter about it from point to point, or no more than those of the other quantities, so that
    /// it is one to the accuracy of the answers.
    [[nodiscard]] std::optional<Candidate> constant_of(const Group& group) {
        auto found = constant(group.rows);
        const double off = found ? std::abs(relative(found->factor, 1)) : 0;
        if (off < std::max(least_constant, 3 * noise_)) {
            return {};
        }
        const Fit& fit = found->fit;
        const double same_of_few = std::min(same_value, chance_of_few * off);
        const bool accepted =
            (group.whole || fit.held <= same_value) && is_accurate(fit, noise_) &&
            (group.rows.size() >= least_rows_of_constant || fit.held <= same_of_few);
        return accepted ? found : std::nullopt;
    }
    /// Adds a constant without a name, if noise leaves room for one.
    void add_doubt(Group& to) {
        auto found = constant(to.rows);
        if (found && doubt_of(found->fit) >= unlikely_by_chance &&
            constant_is_possible(found->fit, to.likely, noise_)) {
            noise_ = std::max(noise_, found->fit.scatter);
            to.likely.push_back(std::move(*found));
        }
    }

    /// Adds to each group the causes of other groups that fit it as well as its own or better: a
    /// cause that is established for one quantity need not change another clearly. If no cause fits
    /// a quantity, those that leave noise only are its causes: its noise may have a mean of several
    /// deviations by chance.
    void add_causes_of_others() {
        const std::vector<Group> before = explained_;
        std::ranges::copy_if(groups_, std::back_inserter(explained_),
                             [&](const Group& group) { return group.whole && !is_done(group); });
        for (Group& group : explained_) {
            const bool own = !group.likely.empty();
            const double error = remainder_of(remainders(group.rows, group.rows.ours)).scatter;
            for (const Group& other : own || !is_done(group) ? before : std::vector<Group>()) {
                for (Candidate cause : other.likely) {
                    // The text of a constant without a name may be that of a named factor.
                    const bool known = std::ranges::any_of(
                        group.likely, [&](const Candidate& c) { return c.is(cause); });
                    cause.fit = remainder(cause, group.rows);
                    if (!known && (own || (cause.fit.noise_like.value_or(false) &&
                                           diagnose::least_gain * cause.fit.scatter < error))) {
                        group.likely.push_back(std::move(cause));
                    }
                }
            }
            keep_best(group.likely, noise_);
            if (!group.likely.empty()) {
                finish(group);
            }
        }
        std::erase_if(explained_, [](const Group& group) { return group.likely.empty(); });
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
        const bool reading = first.source && first.factor == 1;
        Convention c;
        c.of = reading ? group.family : group.name;
        c.relation = first.what;
        c.hint = first.advice;
        c.name = first.name;
        c.factor =
            reading ? readings_.list()[*first.source].factor : first.factor.convert_to<double>();
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
            std::max(reading ? 0 : doubt_of(first.fit), c.remains) > unlikely_by_chance) {
            c.also.emplace_back(c.remains == 0
                                    ? "a constant without a name"
                                    : "a factor that varies, near that number by chance");
            c.equally_likely.emplace_back("factor");
        }
        const auto [least, most] = interval_of(group.rows);
        // A mistake that leaves a smooth remainder may have nearly the effect of a factor by
        // chance.
        if (first.rank == Candidate::mistake && c.remains > unlikely_by_chance) {
            add_near_factors(c, least, most);
        }
        if (first.rank == Candidate::constant && !reading) {
            add_near_factors(c, c.factor, c.factor);
        } else if (c.held < digits_of_percents) {
            add_near_factors(c, (least + most) / 2, (least + most) / 2);
        }
        return c;
    }

    const Answers& answers_;
    const Agreements& agreements_;
    const std::vector<std::size_t>& failing_;
    Readings readings_;
    std::vector<Group> groups_;
    std::vector<Candidate> possible_; ///< without fits
    std::size_t other_edge_ = 0;      ///< the reading
    bool fitted_ = false;             ///< the readings with a factor are known
    std::vector<Group> explained_;
    std::set<std::size_t> done_; ///< questions
    double noise_ = 0;           ///< the scatter of the answers, where known
};

} // namespace

std::vector<Convention> causes_of_wrong_rows(const Answers& answers, const Agreements& agreements,
                                             const std::vector<std::size_t>& failing,
                                             const ReferenceOptions& options,
                                             KnownReadings& known) {
    return CauseSearch(answers, agreements, failing, options, known).causes();
}

} // namespace edgeproof::conformance
