// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/causes/convention.hpp"
#include "edgeproof/conformance/causes/fit.hpp"
#include "edgeproof/conformance/causes/readings.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::conformance {

inline constexpr unsigned most_cause_digits = 40;
/// A number without a name, and one with an unusual name, are not distinguished by answers that do
/// not determine it better than this, or leave a greater smooth remainder.
inline constexpr double unlikely_by_chance = 6e-4;
inline constexpr int rank_of_constant = 3;
/// Fewer rows with noise have a common factor by chance.
inline constexpr std::size_t least_rows_of_constant = 6;

/// Failing rows with a common property.
struct Group {
    std::string name;              ///< "p", "p, left edge", "c_1"
    std::string family;            ///< "p", "c_k"
    std::vector<std::size_t> rows; ///< questions
};

/// Groups the rows by quantity (c_k and s_k together, and separately), at both edges and at each
/// edge. The largest group comes first; among groups of the same rows, the most specific name.
[[nodiscard]] std::vector<Group> groups_of(const Questions& questions,
                                           const std::vector<std::size_t>& rows);

/// Returns the rows with wrong values, not only with too few digits, that none of `known` explains.
[[nodiscard]] std::vector<std::size_t> rows_that_fail(const Answers& answers,
                                                      const Agreements& agreements,
                                                      const std::vector<Convention>& known);

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

/// Compares the failing rows, group by group, with all causes. The causes are found in
/// cause_search.cpp, and those to report are chosen in cause_choice.cpp.
class CauseSearch {
public:
    CauseSearch(const Answers& answers, const Agreements& agreements,
                const std::vector<std::size_t>& failing, const ReferenceOptions& options,
                KnownReadings& known);

    [[nodiscard]] std::vector<Convention> causes();

private:
    using Values = std::vector<std::optional<Real>>;

    /// The values of a reading at these questions, each computed once.
    [[nodiscard]] Values values(std::size_t reading, const std::vector<std::size_t>& questions);

    /// The fit of a reading to some rows, and if it fits these, to all.
    [[nodiscard]] std::optional<Fit> fit(std::size_t reading, const WrongRows& some,
                                         const WrongRows& all);

    /// True if a reading of the contact would have made a quantity wrong that is right.
    [[nodiscard]] bool contradicted(std::size_t reading, const Fit& fit);

    /// Adds the named factors between the answers and these values.
    void add_factors(const WrongRows& rows, const Values& values,
                     std::optional<std::size_t> swapped, Explained& to);

    [[nodiscard]] Likely likely(const NamedFactor& factor, const CommonRatio& ratio, Fit fit,
                                std::optional<std::size_t> swapped) const;
    /// True if a factor of this name is possible in a quantity.
    [[nodiscard]] static bool possible(const NamedFactor& factor, const std::string& family);

    [[nodiscard]] static Values all_of(const WrongRows& rows);

    [[nodiscard]] Likely likely(std::size_t reading, Fit fit);

    /// Adds the readings that explain the rows: mistakes in the data of a contact and in the value
    /// only if these are all failing rows of the quantity, and so for exchanged edges with a
    /// factor.
    void add_readings(const WrongRows& some, const WrongRows& all, Explained& to);

    /// Adds the readings and factors that fit the rows as well as the causes found, however little
    /// they change or however improbable the noise is with them: the answers do not distinguish
    /// them. If the answers have noise, it may hide what a mistake in the data of a contact does to
    /// other rows of the quantity.
    void add_undistinguished(const WrongRows& some, const WrongRows& all, Explained& to);

    [[nodiscard]] bool is_done(const Group& group) const;
    [[nodiscard]] bool is_whole(const Group& group) const;
    [[nodiscard]] Values values_of(const Likely& cause, const WrongRows& rows);

    [[nodiscard]] Explained by_name(const Group& group);

    /// The ratio of the answers to ours, as a cause.
    [[nodiscard]] static Likely constant(const CommonRatio& ratio, Fit fit);
    [[nodiscard]] static Values times(Values values, const Real& factor);
    /// A constant without a name: only of all failing rows of a quantity, and only if the answers
    /// scatter about it from point to point, or no more than those of the other quantities, so that
    /// it is one to the accuracy of the answers.
    [[nodiscard]] std::optional<Likely> constant_of(const Group& group, const WrongRows& all) const;
    /// True if all named causes leave a remainder that is not known to be noise, and that a
    /// constant without a name does not leave: one that is nearly the effect of a mistake by
    /// chance. If a named factor dominates the error, the answers must be known to be constant.
    [[nodiscard]] bool constant_is_better(const WrongRows& all, const Explained& named) const;
    [[nodiscard]] Explained by_constant(const Group& group);

    /// Explains a quantity that no cause fits by one of another quantity, if that leaves noise
    /// only: its noise may have a mean of several deviations by chance.
    void explain_by_others();

    /// Adds to each group the causes of other groups that fit it as well as its own or better: a
    /// cause that is established for one quantity need not change another clearly.
    void add_causes_of_others();

    /// Adds a constant without a name, if noise leaves room for one that fits no worse than the
    /// causes found by more than two standard deviations.
    void add_doubt(const WrongRows& rows, Explained& to);

    /// The standard deviation by which causes are distinguished.
    [[nodiscard]] double unit_of(const Explained& explained) const;

    /// Removes the causes that explain the answers less well than the best, and those that right
    /// answers contradict, unless no others remain.
    void keep_best(Explained& explained);

    /// The number of rows that a cause explains in all groups.
    [[nodiscard]] std::size_t rows_of(const Likely& cause) const;

    /// The cause of a group that explains most rows of all groups, and the others. A constant
    /// without a name must explain twice as many rows.
    [[nodiscard]] Convention convention(const Explained& explained) const;
    /// Adds the named factors k near answers of `least` to `most` times ours: the rest, which has
    /// another cause, is at most a tenth, and a quarter of the error |k - 1| or |1/k - 1|, and k is
    /// not further from the interval than this is wide (unless they are a constant). If the
    /// nearest is just within these limits, those that are nearly as near are added, too: the
    /// answers do not distinguish them.
    void add_near_factors(Convention& of, double least, double most) const;
    /// The interval of the ratio of answers and ours, without a twentieth of the rows on each side.
    [[nodiscard]] std::pair<double, double> interval_of(const Group& group) const;
    /// That interval, if no cause explains the answers, it is not due to their noise, and named
    /// factors are near it.
    [[nodiscard]] std::optional<Convention> varying_factor(const Group& group) const;
    [[nodiscard]] static double digits_of(double off);

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

} // namespace edgeproof::conformance
