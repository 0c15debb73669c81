// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/causes/convention.hpp"
#include "edgeproof/conformance/causes/fit.hpp"
#include "edgeproof/conformance/causes/readings.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace edgeproof::conformance {
namespace {

constexpr unsigned most_digits = 40;
constexpr unsigned reading_digits = 30;
constexpr double same_digits = 6;           // as same_value
constexpr std::size_t most_rows_tried = 60; // enough to select readings to test on all rows
constexpr std::size_t most_right_rows = 12; // of a quantity: enough to contradict a cause
/// A number without a name, and one with an unusual name, are not distinguished by answers that do
/// not determine it better than this.
constexpr double unlikely_by_chance = 6e-4;
/// Rows fail, and are seen here, if they are wrong by more than same_value: they have a common
/// error of that size by this selection.
constexpr double least_constant = 1e-5;
/// Fewer rows with noise have a common factor by chance.
constexpr std::size_t least_rows_of_constant = 6;

/// Failing rows with a common property.
struct Group {
    std::string name;              ///< "p", "p, left edge", "c_1"
    std::string family;            ///< "p", "c_k"
    std::vector<std::size_t> rows; ///< questions
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
        if (answers.given[i].state == Answer::State::number && held.no_reference.empty() &&
            !held.pass && held.digits < same_digits && !explained.contains(i) &&
            !contains_zero(agreements.references[i].value.value)) {
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

constexpr int rank_of_constant = 3;

/// A cause that explains a group.
struct Likely {
    std::string name;
    std::string relation;
    std::string hint;
    double factor = 1;
    int rank = 0;           ///< common factors, mistakes in the data, other factors, a constant
    bool of_family = false; ///< named with the family of the group
    bool contradicted = false;
    double doubtful = 0; ///< the uncertainty of the common ratio
    Fit fit;
    std::optional<std::size_t> reading = {}; ///< `factor` times the values of it, or times ours
};
struct Explained {
    Group group;
    std::vector<Likely> likely; ///< not distinguished by the answers
};

std::vector<std::size_t> evenly(const std::vector<std::size_t>& rows, std::size_t most) {
    std::vector<std::size_t> some;
    const std::size_t n = std::min(rows.size(), most);
    for (std::size_t k = 0; k < n; ++k) {
        some.push_back(rows[k * rows.size() / n]);
    }
    return some;
}

/// Compares the failing rows, group by group, with all causes.
class CauseSearch {
public:
    CauseSearch(const Answers& answers, const Agreements& agreements,
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

    [[nodiscard]] std::vector<Convention> causes() {
        for (const bool named : {true, false}) {
            for (const Group& group : groups_) {
                const bool known = std::ranges::all_of(
                    group.rows, [&](std::size_t row) { return done_.contains(row); });
                if (known || group.rows.size() < least_rows) {
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
        add_causes_of_others();
        std::vector<Convention> found;
        for (Explained& explained : explained_) {
            found.push_back(convention(explained));
        }
        return found;
    }

private:
    using Values = std::vector<std::optional<Real>>;

    /// The values of a reading at these questions, each computed once.
    [[nodiscard]] Values values(std::size_t reading, const std::vector<std::size_t>& questions) {
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

    /// The fit of a reading to some rows, and if it fits these, to all.
    [[nodiscard]] std::optional<Fit> fit(std::size_t reading, const WrongRows& some,
                                         const WrongRows& all) {
        const auto fit = fit_of(some, values(reading, some.questions), noise_);
        return fit && some.size() < all.size() ? fit_of(all, values(reading, all.questions), noise_)
                                               : fit;
    }

    /// True if a reading of the contact would have made a quantity wrong that is right.
    [[nodiscard]] bool contradicted(std::size_t reading, const Fit& fit) {
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

    /// Adds the named factors between the answers and these values.
    void add_factors(const WrongRows& rows, const Values& values,
                     std::optional<std::size_t> swapped, Explained& to) {
        const auto ratio = common_ratio(rows, values);
        if (!ratio) {
            return;
        }
        for (const NamedFactor& factor : factors_) {
            if (abs(Real(ratio->value / factor.value - 1)) > most_scatter) {
                continue;
            }
            if (auto fit = fit_of(rows, times(values, factor.value), noise_)) {
                to.likely.push_back(likely(factor, *ratio, std::move(*fit), swapped));
            }
        }
    }

    [[nodiscard]] static Likely likely(const NamedFactor& factor, const CommonRatio& ratio, Fit fit,
                                       std::optional<std::size_t> swapped) {
        const std::string ours = swapped ? "ours at the other edge" : "ours";
        return {swapped ? "edges-swapped" : factor.name,
                factor.words + ours,
                swapped ? "left taken for right, and a factor" : factor.hint,
                factor.value.convert_to<double>(),
                factor.common && !swapped ? 0 : 2,
                false,
                false,
                4 * ratio.error,
                std::move(fit),
                swapped};
    }

    [[nodiscard]] static Values all_of(const WrongRows& rows) {
        return {rows.ours.begin(), rows.ours.end()};
    }

    [[nodiscard]] Likely likely(std::size_t reading, Fit fit) {
        const Reading& r = readings_[reading];
        const bool refuted = contradicted(reading, fit);
        const int rank = r.name.starts_with("factor") ? 2 : 1;
        return {r.name, r.relation, r.hint, 1, rank, true, refuted, 0, std::move(fit), reading};
    }

    /// Adds the readings that explain the rows: mistakes in the data of a contact and in the value
    /// only if these are all failing rows of the quantity, and so for exchanged edges with a
    /// factor.
    void add_readings(const WrongRows& some, const WrongRows& all, Explained& to) {
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

    /// Adds the readings and factors that fit the rows as well as the causes found, however little
    /// they change or however improbable the noise is with them: the answers do not distinguish
    /// them. If the answers have noise, it may hide what a mistake
    /// in the data of a contact does to other rows of the quantity.
    void add_undistinguished(const WrongRows& some, const WrongRows& all, Explained& to) {
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
            if (!ratio || known || abs(Real(ratio->value / factor.value - 1)) > most_scatter) {
                continue;
            }
            if (misfit(remainder_of(some, times(all_of(some), factor.value)), unit) <= most) {
                to.likely.push_back(likely(
                    factor, *ratio, remainder_of(all, times(all_of(all), factor.value)), {}));
            }
        }
    }

    [[nodiscard]] bool is_whole(const Group& group) const {
        return group.rows.size() == rows_of_family_.at(group.family);
    }
    [[nodiscard]] Values values_of(const Likely& cause, const WrongRows& rows) {
        return times(cause.reading ? values(*cause.reading, rows.questions) : all_of(rows),
                     cause.factor);
    }

    [[nodiscard]] Explained by_name(const Group& group) {
        Explained explained{group, {}};
        const WrongRows all = wrong_rows(answers_, agreements_, group.rows);
        const WrongRows some =
            wrong_rows(answers_, agreements_, evenly(group.rows, most_rows_tried));
        add_factors(all, all_of(all), {}, explained);
        add_readings(some, all, explained);
        add_undistinguished(some, all, explained);
        keep_best(explained);
        add_doubt(all, explained);
        return explained;
    }

    /// The ratio of the answers to ours, as a cause.
    [[nodiscard]] static Likely constant(const CommonRatio& ratio, Fit fit) {
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
    [[nodiscard]] static Values times(Values values, const Real& factor) {
        for (auto& value : values) {
            if (value) {
                *value *= factor;
            }
        }
        return values;
    }
    /// A constant without a name: only of all failing rows of a quantity, and only if the answers
    /// scatter about it from point to point, or no more than those of the other quantities, so that
    /// it is one to the accuracy of the answers.
    [[nodiscard]] Explained by_constant(const Group& group) {
        Explained explained{group, {}};
        const WrongRows all = wrong_rows(answers_, agreements_, group.rows);
        const auto ratio = common_ratio(all, all_of(all));
        if (!ratio || abs(Real(ratio->value - 1)) < std::max(least_constant, 3 * noise_)) {
            return explained;
        }
        auto fit = fit_of(all, times(all_of(all), ratio->value), noise_);
        const double unscattered = std::max(same_value, 3 * noise_);
        if (fit && (is_whole(group) || fit->held <= same_value) &&
            fit->noise_like.value_or(fit->held <= unscattered) &&
            (all.size() >= least_rows_of_constant || fit->held <= same_value)) {
            noise_ = std::max(noise_, fit->scatter);
            explained.likely.push_back(constant(*ratio, std::move(*fit)));
            add_undistinguished(
                wrong_rows(answers_, agreements_, evenly(group.rows, most_rows_tried)), all,
                explained);
            keep_best(explained);
        }
        return explained;
    }

    /// Adds to each group the causes of other groups that fit it as well as its own or better: a
    /// cause that is established for one quantity need not change another clearly.
    void add_causes_of_others() {
        const std::vector<Explained> before = explained_;
        for (Explained& group : explained_) {
            const WrongRows rows = wrong_rows(answers_, agreements_, group.group.rows);
            for (const Explained& other : before) {
                for (Likely cause : other.likely) {
                    // The text of a constant without a name may be that of a named factor.
                    const bool known = std::ranges::any_of(group.likely, [&](const Likely& l) {
                        return l.name == cause.name && l.relation == cause.relation;
                    });
                    if (!known) {
                        cause.fit = remainder_of(rows, values_of(cause, rows));
                        group.likely.push_back(std::move(cause));
                    }
                }
            }
            keep_best(group);
        }
    }

    /// Adds a constant without a name, if noise leaves room for one that fits no worse than the
    /// causes found by more than two standard deviations.
    void add_doubt(const WrongRows& rows, Explained& to) const {
        const auto ratio = common_ratio(rows, all_of(rows));
        if (to.likely.empty() || !ratio || 4 * ratio->error < unlikely_by_chance) {
            return;
        }
        constexpr double two_deviations = 4;
        auto fit = fit_of(rows, times(all_of(rows), ratio->value), noise_);
        const bool as_well = fit && std::ranges::all_of(to.likely, [&](const Likely& l) {
                                 const double unit = std::max(fit->scatter, noise_);
                                 const double allowed =
                                     l.rank == 0 ? -two_deviations : two_deviations;
                                 return misfit(*fit, unit) <= misfit(l.fit, unit) + allowed;
                             });
        if (as_well && fit->noise_like.value_or(true)) {
            to.likely.push_back(constant(*ratio, std::move(*fit)));
        }
    }

    /// The standard deviation by which causes are distinguished.
    [[nodiscard]] double unit_of(const Explained& explained) const {
        double least = std::numeric_limits<double>::max();
        for (const Likely& l : explained.likely) {
            least = std::min(least, l.fit.scatter);
        }
        return std::max(least * uncertainty_of_scatter(explained.group.rows.size()), noise_);
    }

    /// Removes the causes that explain the answers less well than the best, and those that right
    /// answers contradict, unless no others remain.
    void keep_best(Explained& explained) {
        auto& likely = explained.likely;
        if (std::ranges::any_of(likely, [](const Likely& l) { return !l.contradicted; })) {
            std::erase_if(likely, [](const Likely& l) { return l.contradicted; });
        }
        if (likely.empty()) {
            return;
        }
        const double unit = unit_of(explained);
        const auto misfit_in_units = [&](const Likely& l) { return misfit(l.fit, unit); };
        const Likely& best = *std::ranges::min_element(likely, {}, misfit_in_units);
        const double most = misfit_in_units(best) + indistinguishable_misfit(best.fit);
        if (best.fit.noise_like.value_or(false)) {
            noise_ = std::max(noise_, best.fit.scatter);
        }
        std::erase_if(likely, [&](const Likely& l) { return misfit_in_units(l) > most; });
        std::ranges::stable_sort(likely, {}, [&](const Likely& l) {
            return std::pair(l.rank, l.rank == 1 ? 0 : misfit_in_units(l));
        });
    }

    /// The number of rows that a cause explains in all groups.
    [[nodiscard]] std::size_t rows_of(const Likely& cause) const {
        std::size_t rows = 0;
        for (const Explained& explained : explained_) {
            std::size_t most = 0;
            for (const Likely& l : explained.likely) {
                if (l.name == cause.name && l.relation == cause.relation) {
                    most = std::max(most, l.fit.rows);
                }
            }
            rows += most;
        }
        return rows;
    }

    /// The cause of a group that explains most rows of all groups, and the others. A constant
    /// without a name is the first only if it is the only one.
    [[nodiscard]] Convention convention(const Explained& explained) const {
        const auto& likely = explained.likely;
        const Likely& first = *std::ranges::max_element(likely, {}, [&](const Likely& l) {
            return std::pair(l.rank != rank_of_constant, rows_of(l));
        });
        Convention c;
        c.of = first.of_family ? explained.group.family : explained.group.name;
        c.relation = first.relation;
        c.hint = first.hint;
        c.name = first.name;
        c.factor = first.factor;
        c.rows = first.fit.rows;
        c.failing = explained.group.rows.size();
        c.digits = digits_of(first.fit.worst);
        c.held = digits_of(first.fit.held);
        c.remains = first.fit.noise_like.value_or(true) ? 0 : first.fit.held;
        for (const Likely& l : likely) {
            const bool new_words =
                l.relation != c.relation && std::ranges::find(c.also, l.relation) == c.also.end();
            if (new_words) {
                c.also.push_back(l.relation);
                c.equally_likely.push_back(l.name);
            }
        }
        if (first.rank == 2 && first.doubtful > unlikely_by_chance) {
            c.also.emplace_back("a constant without a name");
            c.equally_likely.emplace_back("factor");
        }
        return c;
    }
    [[nodiscard]] static double digits_of(double off) {
        return off == 0 ? most_digits : std::clamp(-std::log10(off), 0.0, double(most_digits));
    }

    const Answers& answers_;
    const Agreements& agreements_;
    ReferenceOptions options_;
    KnownReadings& known_;
    std::vector<Group> groups_;
    std::vector<NamedFactor> factors_;
    std::vector<Reading> readings_;
    std::vector<std::vector<std::size_t>> right_;       ///< some right rows of each quantity
    std::map<std::string, std::size_t> rows_of_family_; ///< that fail
    std::vector<Explained> explained_;
    std::set<std::size_t> done_; ///< questions
    double noise_ = 0;           ///< the scatter of the answers, where known
};

} // namespace

std::vector<Convention> infer_conventions(const Answers& answers, const Agreements& agreements,
                                          const ReferenceOptions& options, KnownReadings& known) {
    const PrecisionScope scope(most_digits + 20);
    std::vector<Convention> found = infer_precision_loss(answers, agreements);
    std::ranges::move(infer_cancellation(answers, agreements), std::back_inserter(found));
    const std::vector<std::size_t> failing = rows_that_fail(answers, agreements, found);
    if (failing.size() >= least_rows) {
        std::ranges::move(CauseSearch(answers, agreements, failing, options, known).causes(),
                          std::back_inserter(found));
    }
    return merged(found);
}

std::vector<Convention> infer_conventions(const Answers& answers, const Agreements& agreements,
                                          const ReferenceOptions& options) {
    KnownReadings known;
    return infer_conventions(answers, agreements, options, known);
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
        if (rows.first >= least_rows && !rows.second) {
            names.push_back(family);
        }
    }
    return names;
}

void FailingRows::add(const Answers& answers, const Agreements& agreements) {
    std::map<std::size_t, std::size_t> contacts; // from the block to those kept
    answers_.questions.file = answers.questions.file;
    agreements_.digits = agreements.digits;
    for (std::size_t i = 0; i < agreements.cases.size(); ++i) {
        if (agreements.cases[i].pass || ++seen_ > most) {
            continue;
        }
        Question q = answers.questions.list[i];
        const auto [found, is_new] =
            contacts.emplace(q.contact, answers_.questions.contacts.size());
        if (is_new) {
            answers_.questions.contacts.push_back(answers.questions.contacts[q.contact]);
        }
        q.contact = found->second;
        answers_.questions.list.push_back(std::move(q));
        answers_.given.push_back(answers.given[i]);
        agreements_.cases.push_back(agreements.cases[i]);
        agreements_.references.push_back(agreements.references[i]);
    }
}

std::vector<Convention> FailingRows::conventions(const ReferenceOptions& options) const {
    return infer_conventions(answers_, agreements_, options);
}

std::vector<std::string>
FailingRows::unexplained_by(const std::vector<Convention>& conventions) const {
    return unexplained(answers_, agreements_, conventions);
}

} // namespace edgeproof::conformance
