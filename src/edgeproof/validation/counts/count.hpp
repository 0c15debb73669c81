// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/validation/counts/sample.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace edgeproof::validation {

/// What was found of the values of one kind of profile in one regime.
struct CountCell {
    std::size_t values = 0;
    std::size_t excluded = 0;  ///< the enclosure leaves out the value in Real
    std::size_t wrong = 0;     ///< a printed digit is not that of the correct rounding
    std::size_t wide = 0;      ///< the enclosure is wider than 10 units of the last digit asked
    std::size_t undecided = 0; ///< no enclosure, or no second value, within the budgets

    [[nodiscard]] std::size_t failures() const { return excluded + wrong + wide; }
    void add(const CountCell& o);
};
using CountCells =
    std::array<std::array<CountCell, sampled_regimes.size()>, sampled_profiles.size()>;

/// A value that failed, or is undecided: all that it takes to see it again.
struct CountFinding {
    std::size_t contact = 0; ///< number of the contact
    std::size_t value = 0;   ///< of the values of the contact
    bool failed = false;     ///< else undecided
    std::string what;        ///< what is wrong with it
    std::string asked;       ///< "p at u = 1e-40 from the right edge"
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
    /// Called now and then, and at the end, with what is done, from one thread at a time.
    std::function<void(const struct CountState&)> checkpoint = {};
    /// Changes the second value before it is held against the enclosure: how a test makes sure that
    /// a wrong value is counted.
    std::function<void(const SampledValue&, Real&)> second = {};
};

/// A count under way: what was found of each contact that is done.
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

/// Draws the values and tests of each:
///   1. The enclosure that is printed from, at `digits` digits, holds the value in Real worked out
///      at twice as many: their difference is at most the radius plus 10^-(2 digits) of the value
///      (of a coefficient: of its natural size |c_0|/radius^k where that is larger), which is what
///      the value in Real may owe to its own rounding.
///   2. The printed decimal is the correct rounding: a second enclosure, at twice the digits,
///      rounds to the same text, and so does the value in Real.
///   3. The enclosure is no wider than 10 units of the last digit asked.
/// The value in Real is the pressure by the singular integral for a power law that has no
/// logarithms, for a curved g' and for one in 8 of the others, by Barber-Mossakovskii for one of a
/// symmetric contact (b(s) has to be solved for at every node of another's integral, which takes
/// minutes at so many digits), else by logarithms in Real; coefficients, P, b and q by the
/// routes in Real. The result is the same whatever the number of threads. Contacts that `state` has
/// are not done again, unless something was found in them.
[[nodiscard]] CountResult count_values(const CountOptions& options, CountState& state);

} // namespace edgeproof::validation
