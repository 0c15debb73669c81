// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/causes/convention.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace edgeproof::report {

/// Answers held against the references, to be reported.
struct Conformance {
    conformance::Answers answers;
    conformance::Target target;
    conformance::Agreements agreements;
    std::vector<conformance::Convention> conventions;

    /// No fault, nothing missing, no convention but ours, and every answer within the target.
    [[nodiscard]] bool pass() const;
    [[nodiscard]] bool failed(std::size_t i) const; ///< that answer
};

/// For people: failing cases (at most `errors`), faults, the table by regime with its worst cases,
/// the conventions, and the outcome in the last line.
[[nodiscard]] std::string conformance_text(const Conformance& c, std::size_t errors);

/// JUnit XML: a test case an answer, and one for the faults.
[[nodiscard]] std::string conformance_junit(const Conformance& c);

} // namespace edgeproof::report
