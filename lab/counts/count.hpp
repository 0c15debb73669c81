// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/input/bounded_value.hpp"
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

/// The counts for one kind of profile in one regime.
struct CountCell {
    std::size_t values = 0;
    std::size_t excluded = 0;  ///< the enclosure does not contain the value in Real
    std::size_t wrong = 0;     ///< a printed digit differs from the correct rounding
    std::size_t wide = 0;      ///< the enclosure is wider than 10 units of the last digit requested
    std::size_t undecided = 0; ///< no enclosure, or no second value, within the budgets

    [[nodiscard]] std::size_t failures() const { return excluded + wrong + wide; }
    void add(const CountCell& o);
};
using CountCells =
    std::array<std::array<CountCell, sampled_regimes.size()>, sampled_profiles.size()>;

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

struct CountOptions {
    std::uint64_t seed = 1;
    std::size_t values = 100'000;
    unsigned digits = 50;
    unsigned threads = 0; ///< 0: as many as the machine has
    std::function<void(std::size_t, std::size_t)> progress = {};
    /// Called occasionally, and at the end, with the finished results, from one thread at a time.
    std::function<void(const struct CountState&)> checkpoint = {};
    /// Changes the second value before the comparison, for a test that a wrong value is counted.
    std::function<void(const SampledValue&, Real&)> second = {};
};

/// The state of a count: the results of the finished contacts.
struct CountState {
    std::uint64_t seed = 1;
    std::size_t values = 0;
    unsigned digits = 50;
    std::map<std::size_t, std::map<std::size_t, CountCell>> contacts; ///< by profile*regimes+regime
};

struct CountResult {
    CountCells cells{};
    CountCell total;
    std::vector<CountFinding> findings; ///< in the order of the contacts
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
/// The value in Real is the pressure by the singular integral for a power law without logarithms,
/// for a curved g' and for one in 8 of the others, by Barber-Mossakovskii for one of a symmetric
/// contact (for others b(s) has to be solved at every node of the integral, which takes minutes at
/// this number of digits), else by logarithms in Real; coefficients, P, b and q are computed by the
/// routes in Real. The result does not depend on the number of threads. Contacts in `state` are not
/// repeated, unless they had findings.
[[nodiscard]] CountResult count_values(const CountOptions& options, CountState& state);

struct CountedContact {
    std::map<std::size_t, CountCell> cells; ///< as in CountState
    std::vector<CountFinding> findings;
};

/// Throws Interrupted; then no value of the contact is counted.
[[nodiscard]] CountedContact count_contact(const CountOptions& options, std::size_t number,
                                           std::size_t values);

/// Returns the faults of one value; empty if there are none. `error` is the rounding error allowed
/// for `second`. Adds to the cell.
[[nodiscard]] std::string held_to(const scene::BoundedValue& first,
                                  const scene::BoundedValue& finer, const Real& second,
                                  const Real& error, unsigned digits, CountCell& cell);

/// Writes the contacts without findings, one line each; those with findings are left out, so that
/// they are repeated.
[[nodiscard]] std::string write_count_state(const CountState& state);
/// Throws InputError with the line for a text that is not such a state, or one of another seed,
/// number of values or digits than `wanted`.
[[nodiscard]] CountState parse_count_state(std::string_view text, const std::string& file,
                                           const CountState& wanted);

} // namespace edgeproof::validation
