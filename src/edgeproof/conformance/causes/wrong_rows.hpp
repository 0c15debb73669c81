// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/causes/convention.hpp"
#include "edgeproof/diagnose/choice.hpp"
#include "edgeproof/precision/real.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::conformance {

inline constexpr unsigned most_cause_digits = 40;

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

/// The median of the ratios of the answers to these values, and its standard error, relative;
/// nothing if fewer than nine of ten rows have a value.
struct CommonRatio {
    Real value;
    double error = 0;
    /// |value/of - 1|
    [[nodiscard]] double off(const Real& of) const;
    [[nodiscard]] std::string text() const; ///< with its significant digits
};
[[nodiscard]] std::optional<CommonRatio> common_ratio(const WrongRows& rows, const Values& values);

/// Failing rows with a common property.
struct Group {
    std::string name;              ///< "p", "p, left edge", "c_1"
    std::string family;            ///< "p", "c_k"
    std::vector<std::size_t> rows; ///< questions
    std::vector<diagnose::Candidate> likely = {};
};

/// Groups the rows by quantity (c_k and s_k together, and separately), at both edges and at each
/// edge. The largest group comes first; among groups of the same rows, the most specific name.
[[nodiscard]] std::vector<Group> groups_of(const Questions& questions,
                                           const std::vector<std::size_t>& rows);

/// The digits of a relative error.
[[nodiscard]] double cause_digits(double off);
/// The interval of the ratio of answers and ours, without a twentieth of the rows on each side.
[[nodiscard]] std::pair<double, double> interval_of(const WrongRows& rows);
/// Adds the named factors k near answers of `least` to `most` times ours: the rest, which has
/// another cause, is at most a tenth, and a quarter of the error |k - 1| or |1/k - 1|, and k is
/// not further from the interval than this is wide (unless they are a constant). If the
/// nearest is just within these limits, those that are nearly as near are added, too: the
/// answers do not distinguish them.
void add_near_factors(Convention& of, double least, double most);
/// The interval, if it is not due to noise, and named factors are near it.
[[nodiscard]] std::optional<Convention> varying_factor(const WrongRows& rows, double noise);

/// Compares failing rows, group by group, with all causes: first with those that have a name, then
/// with a constant.
[[nodiscard]] std::vector<Convention> causes_of(const Answers& answers,
                                                const Agreements& agreements,
                                                const std::vector<std::size_t>& failing,
                                                const ReferenceOptions& options,
                                                KnownReadings& known);

} // namespace edgeproof::conformance
