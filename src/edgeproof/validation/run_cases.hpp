// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/validation/hard_cases.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::validation {

/// The arithmetics that the textbook formula is tried in, in the order of the columns.
inline constexpr std::array<std::string_view, 4> plain_arithmetics{"double", "long double",
                                                                   "__float128", "MPFR 50"};

/// What one route in Real said of a case.
struct CaseSecondRoute {
    std::string route;
    std::string value;   ///< as many digits as were asked for, or why there are none
    unsigned digits = 0; ///< that agree with the enclosure, no more than the enclosure has
    bool agrees = false; ///< with every digit asked for, to 1 unit of the last
};

/// A hard case done.
struct CaseOutcome {
    std::string value; ///< as printed
    std::string bound;
    std::string route;
    bool proved = false;
    bool complete = false; ///< all the digits asked for
    unsigned digits = 0;   ///< proved: of the enclosure
    std::vector<CaseSecondRoute> second_routes;
    std::array<unsigned, plain_arithmetics.size()> plain{}; ///< digits of the textbook formula
    bool undecided = false; ///< as the case says: an estimate, with which both routes agree
    std::string fault;      ///< empty where ball and both routes agree
};

struct CaseOptions {
    unsigned digits = 50;
    unsigned threads = 0; ///< 0: as many as the machine has
    std::function<void(std::size_t, std::size_t)> progress = {};
};

/// One case: by ball to `digits` digits, by two routes in Real at that many, and by the
/// textbook formula in double, long double, __float128 and 50-digit MPFR. Never throws for what
/// goes wrong on the way: that is the case's fault.
[[nodiscard]] CaseOutcome run_case(const HardCase& c, unsigned digits);

/// All of them, in their order. Throws Interrupted.
[[nodiscard]] std::vector<CaseOutcome> run_cases(const std::vector<HardCase>& cases,
                                                 const CaseOptions& options);

/// Digits of a class: the worst and the median of its cases.
struct FamilySummary {
    std::string family;
    std::size_t cases = 0;
    std::size_t agree = 0; ///< by ball and by both routes
    std::array<unsigned, plain_arithmetics.size()> worst{};
    std::array<unsigned, plain_arithmetics.size()> median{};
    unsigned worst_proved = 0;
    unsigned median_proved = 0;
};
/// Class by class, in the order in which they first occur.
[[nodiscard]] std::vector<FamilySummary> summary(const std::vector<HardCase>& cases,
                                                 const std::vector<CaseOutcome>& outcomes);

} // namespace edgeproof::validation
