// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/input/quantity.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::validation {

/// A value that is difficult to compute, with the reason.
struct HardCase {
    std::string name;
    std::string family;
    std::string reason; ///< one line
    /// The reason why no ball decides it, if that is impossible; otherwise empty.
    std::string undecided;
    scene::Scene scene;
    scene::AskedValue asked;
    std::size_t line = 0;
};

/// Reads a file of cases:
///
///     [cases.hertz-40]                 # any name
///     class = "u = 1e-40 a"
///     reason = "..."
///     undecided = "..."                # only if no ball can enclose it: the reason
///     quantity = "pressure"            # see scene/route/quantity_rows.cpp
///     edge = "right"
///     u = "1e-40"                      # if the quantity has a place
///     n = 1                            # order of a coefficient, or number of terms
///     tolerance = "1%"                 # of an extent
///     profile = { kind = "power-law", m = "1", C = "1" }   # as in a scene
///     load = { a = "1", contact_modulus = "1" }
///     shear = { Q = "0.3" }            # if there is one
///
/// Throws InputError with file and line for malformed input.
[[nodiscard]] std::vector<HardCase> parse_hard_cases(std::string_view text,
                                                     const std::string& file);

/// The arithmetics in which the textbook formula is evaluated, in the order of the columns.
inline constexpr std::array<std::string_view, 4> plain_arithmetics{"double", "long double",
                                                                   "__float128", "MPFR 50"};

struct CaseSecondRoute {
    std::string route;
    std::string value;   ///< with the requested digits, or the reason why there is no value
    unsigned digits = 0; ///< that agree with the enclosure, at most those of the enclosure
    bool agrees = false; ///< in all requested digits, to 1 unit of the last
};

struct CaseOutcome {
    std::string value; ///< as printed
    std::string bound;
    std::string route;
    bool proved = false;
    bool complete = false; ///< all requested digits are given
    unsigned digits = 0;   ///< digits that the enclosure proves
    std::vector<CaseSecondRoute> second_routes;
    std::array<unsigned, plain_arithmetics.size()> plain{}; ///< digits of the textbook formula
    bool undecided = false; ///< as the case expects: an estimate, with which both routes agree
    std::string fault;      ///< empty if ball and both routes agree
};

struct CaseOptions {
    unsigned digits = 50;
    unsigned threads = 0; ///< 0: as many as the machine has
    std::function<void(std::size_t, std::size_t)> progress = {};
};

/// Computes one case by balls to `digits` digits, by two routes in Real at the same number, and by
/// the textbook formula in double, long double, __float128 and 50-digit MPFR. Errors are not thrown
/// but reported as the fault of the case.
[[nodiscard]] CaseOutcome run_case(const HardCase& c, unsigned digits);

/// Computes all cases, in order. Throws Interrupted.
[[nodiscard]] std::vector<CaseOutcome> run_cases(const std::vector<HardCase>& cases,
                                                 const CaseOptions& options);

/// The correct digits for a class: those of the worst and of the median case.
struct FamilySummary {
    std::string family;
    std::size_t cases = 0;
    std::size_t agree = 0; ///< ball and both routes agree
    std::array<unsigned, plain_arithmetics.size()> worst{};
    std::array<unsigned, plain_arithmetics.size()> median{};
    unsigned worst_proved = 0;
    unsigned median_proved = 0;
};
/// Returns a summary of each class, in the order of first occurrence.
[[nodiscard]] std::vector<FamilySummary> summary(const std::vector<HardCase>& cases,
                                                 const std::vector<CaseOutcome>& outcomes);

} // namespace edgeproof::validation
