// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/input/bounded_value.hpp"
#include "lab/counts/counting.hpp"
#include "lab/counts/sample.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::validation {

/// A value that failed or is undecided, with all data needed to repeat it.
struct CountFinding {
    std::size_t contact = 0; ///< number of the contact
    std::size_t value = 0;   ///< number of the value in the contact
    bool failed = false;     ///< otherwise undecided
    std::string what;        ///< the fault
    std::string asked;       ///< for example "p at u = 1e-40 from the right edge"
    std::string text;        ///< as printed
    std::string second;      ///< the value in Real
    std::string scene;       ///< TOML
};

struct EnclosureCountOptions : CountOptions {
    /// Changes the second value before the comparison, for a test that a wrong value is counted.
    std::function<void(const SampledValue&, Real&)> second = {};
};

/// Draws the values and tests each:
///   1. The enclosure used for printing, at `digits` digits, contains the value in Real computed at
///      twice as many: their difference is at most the radius plus 10^-(2 digits) of the value (for
///      a
///      coefficient: of its natural size |c_0|/radius^k if that is larger), which allows for the
///      rounding of the value in Real.
///   2. The printed decimal is the correct rounding: a second enclosure, at twice the digits,
///      rounds to the same text, and so does the value in Real.
///   3. The enclosure is no wider than 10 units of the last digit requested.
/// The value in Real is that of contact::Witness: a pressure is the singular integral, for one of a
/// symmetric contact the integral of Barber-Mossakovskii. The result does not depend on the number
/// of threads.
[[nodiscard]] CountResult<CountFinding> count_values(const EnclosureCountOptions& options);

/// The rows are the profiles of the contacts and the regimes of the values.
[[nodiscard]] report::Table count_table(const EnclosureCountOptions& options,
                                        const CountResult<CountFinding>& result);
/// Returns everything that is needed to reproduce a finding.
[[nodiscard]] std::string text_of(const CountFinding& finding);

/// Throws Interrupted; then no value of the contact is counted.
[[nodiscard]] CountedContact<CountFinding> count_contact(const EnclosureCountOptions& options,
                                                         std::size_t number, std::size_t values);

/// Returns the faults of one value; empty if there are none. `error` is the rounding error allowed
/// for `second`. Adds to the cell.
[[nodiscard]] std::string held_to(const scene::BoundedValue& first,
                                  const scene::BoundedValue& finer, const Real& second,
                                  const Real& error, unsigned digits, CountCell& cell);

} // namespace edgeproof::validation
