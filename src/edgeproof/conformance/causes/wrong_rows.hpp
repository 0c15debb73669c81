// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/causes/convention.hpp"
#include "edgeproof/diagnose/fit.hpp"
#include "edgeproof/precision/real.hpp"

#include <cstddef>
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

} // namespace edgeproof::conformance
