// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/conformance/causes/convention.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::report {

/// The comparison of answers with the references, for a report.
struct Conformance {
    conformance::Answers answers;
    conformance::Target target;
    conformance::Agreements agreements;
    std::vector<conformance::Convention> conventions;

    /// True without faults, missing answers and foreign conventions, if every answer is within the
    /// target.
    [[nodiscard]] bool pass() const;
    [[nodiscard]] bool failed(std::size_t i) const; ///< True if answer i fails
    [[nodiscard]] std::size_t failures() const;     ///< the number of answers that fail
};

using Progress = std::function<void(std::size_t done, std::size_t total)>;

/// What is called while answers are compared: with the answers of a program, with the references,
/// and with the text that the program writes to its standard error.
struct CheckCalls {
    Progress answers = {};
    Progress references = {};
    std::function<void(std::string_view)> said = {};
};

/// Compares answers with the references. Options: `answers`, the text of a file, with its `name` in
/// errors, and perhaps the `recipe`; or `command`, a program that answers the recipe, with
/// `seconds` for a run, `batch` and `runs` (conformance::ProgramDriverOptions); `only`, a pattern
/// of ids; digits, ulps, conditioned, threads. Throws InputError.
[[nodiscard]] Conformance
checked_answers(const std::map<std::string, std::string, std::less<>>& options,
                const CheckCalls& calls);

/// Returns the report as text: the outcome in the first line, the causes with that of most rows
/// first, at most `errors` faults and failing cases, and the table by regime with its worst cases.
[[nodiscard]] std::string conformance_text(const Conformance& c, std::size_t errors);

/// Returns {"passes", "rows", "failures", "causes": [{"name", "factor", "rows", "equally_likely",
/// "remainder", "of", "relation"}]}; the cause of most rows comes first. `remainder`: the relative
/// error that nine of ten of those rows do not exceed after correction.
[[nodiscard]] std::string conformance_json(const Conformance& c);

/// Returns JUnit XML: a test case per answer, and one for the faults.
[[nodiscard]] std::string conformance_junit(const Conformance& c);

} // namespace edgeproof::report
