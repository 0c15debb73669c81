// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/conformance/causes/convention.hpp"
#include "edgeproof/diagnose/diagnose.hpp"
#include "edgeproof/precision/real.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::conformance {

/// x/y - 1, within the range of a double.
[[nodiscard]] double relative(const Real& x, const Real& y);

/// Values of some rows, or factors of them; nothing where there is none.
using Values = std::vector<std::optional<Real>>;
[[nodiscard]] Values times(Values values, const Real& factor);

/// True if an answer is compared with a value other than 0.
[[nodiscard]] bool has_value(const Answers& answers, const Agreements& agreements, std::size_t i);
/// At most `most` of the rows, at equal steps.
[[nodiscard]] std::vector<std::size_t> evenly(const std::vector<std::size_t>& rows,
                                              std::size_t most);

/// Wrong answers of one quantity, at both edges or at one.
struct WrongRows {
    std::vector<std::size_t> questions;
    std::vector<Real> answers;
    Values ours; ///< the references
    std::vector<std::pair<std::size_t, std::size_t>> neighbours;

    [[nodiscard]] std::size_t size() const { return questions.size(); }
};
[[nodiscard]] WrongRows wrong_rows(const Answers& answers, const Agreements& agreements,
                                   std::vector<std::size_t> questions);

/// The errors of the answers, before and after a cause with these values.
[[nodiscard]] diagnose::Remainders remainders(const WrongRows& rows, const Values& values);

/// Failing rows with a common property, and the causes that may explain them.
struct Group {
    std::string name;   ///< "p", "p, left edge", "c_1"
    std::string family; ///< "p", "c_k"
    WrongRows rows;
    bool whole = false; ///< these are all failing rows of the family
    std::vector<diagnose::Candidate> likely = {};
};
/// Groups the rows by quantity (c_k and s_k together, and separately), at both edges and at each
/// edge. The largest group comes first; among groups of the same rows, the most specific name.
[[nodiscard]] std::vector<Group> groups_of(const Answers& answers, const Agreements& agreements,
                                           const std::vector<std::size_t>& failing);

/// The digits of a relative error.
[[nodiscard]] double cause_digits(double off);

/// Adds the named factors near answers of `least` to `most` times ours (diagnose::near_factors()).
void add_near_factors(Convention& of, double least, double most);

/// The interval of the ratio of answers and ours, without a twentieth of the rows on each side.
[[nodiscard]] std::pair<double, double> interval_of(const WrongRows& all);

/// The interval, if it is not due to noise, and named factors are near it.
[[nodiscard]] std::optional<Convention> varying_factor(const Group& group, double noise);

/// Another interpretation of questions.
struct Reading {
    using Mistakes = std::vector<diagnose::Mistake>; ///< of a contact

    std::string name; ///< of the cause (diagnose/diagnose.hpp)
    std::string relation;
    std::string hint;
    /// Changes the contact to that interpretation; false if this does not change it. Null: the
    /// contact is as in the question.
    std::function<bool(scene::Scene&, const Mistakes&)> contact = {};
    /// Changes the place of a question of that contact. Null: places are as in the question.
    std::function<bool(Question&, const scene::Scene&)> place = {};
    /// Changes the value. Null: it stays.
    std::function<std::optional<Real>(const Real&)> value = {};
    std::string only = {}; ///< the profiles that it is restricted to
    double factor = 1;
    bool fitted = false; ///< with this factor
};

/// The interpretations that change a question about the contacts of failing rows: the mistakes of
/// the catalogue, x for u, another edge, terms of the expansion for the pressure, the constant of
/// the gap for that of the slope, and the decimal logarithm of the value. Each value is computed
/// once.
class Readings {
public:
    Readings(const Answers& answers, const Agreements& agreements,
             const std::vector<std::size_t>& failing, ReferenceOptions options,
             KnownReadings& known);

    [[nodiscard]] const std::vector<Reading>& list() const { return list_; }
    /// The references of the questions in an interpretation; nothing for those that it does not
    /// change or that have no value other than 0.
    [[nodiscard]] Values values(std::size_t reading, const std::vector<std::size_t>& questions);
    /// Adds the interpretations with one factor, of the load, of the places x or of the distances u
    /// from the edge, that is fitted to the failing rows (diagnose::fitted_factor()).
    void fit(const std::vector<std::size_t>& failing);
    /// True if a reading of the contact would have made a quantity wrong that is right, by more
    /// than `most`.
    [[nodiscard]] bool contradicted(std::size_t reading, double most);

private:
    void find(const std::vector<std::size_t>& contacts);
    [[nodiscard]] Values found(const Reading& reading, const std::vector<std::size_t>& which);
    [[nodiscard]] const Reading::Mistakes& mistakes_in(std::size_t contact);

    const Answers& answers_;
    const Agreements& agreements_;
    ReferenceOptions options_;
    KnownReadings& known_;
    std::vector<Reading> list_;
    std::map<std::size_t, Reading::Mistakes> mistakes_;
    std::vector<std::vector<std::size_t>> right_; ///< some right rows of each quantity
};

/// Searches rows with wrong values for questions interpreted differently and for
/// factors, as infer_conventions() describes. `known`: as there.
[[nodiscard]] std::vector<Convention> causes_of_wrong_rows(const Answers& answers,
                                                           const Agreements& agreements,
                                                           const std::vector<std::size_t>& failing,
                                                           const ReferenceOptions& options,
                                                           KnownReadings& known);

} // namespace edgeproof::conformance
