// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "lab/cost/cost_route.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::cost {

/// The extremes and the quartiles of some numbers.
struct Quartiles {
    double least = 0;
    double low = 0;
    double median = 0;
    double high = 0;
    double most = 0;
};
/// Returns zeros if there are no numbers.
[[nodiscard]] Quartiles quartiles(std::vector<double> numbers);

/// One point by one route. A failed point has no digits and no time.
struct PointCost {
    std::size_t point = 0; ///< of the case
    double right = 0;      ///< -log10 of the true relative error
    std::optional<std::size_t> evaluations = {};
    double seconds = 0; ///< of the processor, median over repeats
    double spread = 0;  ///< interquartile range of the repeats over the median
    std::string failure = {};
};

/// One route at a number of digits over the points of a case.
struct CostCell {
    std::string scene;
    std::string route;
    std::string arithmetic;
    unsigned digits = 0; ///< asked for
    bool proves = false;
    double contact_seconds = 0; ///< done once for each contact: edges, tables
    std::vector<PointCost> points;

    [[nodiscard]] std::size_t failed() const;
    [[nodiscard]] Quartiles right() const;
    [[nodiscard]] Quartiles seconds() const;
    /// Returns no value if they are not counted.
    [[nodiscard]] std::optional<Quartiles> evaluations() const;
    [[nodiscard]] std::size_t total_evaluations() const;
    /// Returns the median, over the points, of the spread of the repeats.
    [[nodiscard]] double spread() const;
};

struct CostOptions {
    std::vector<unsigned> digits;
    std::size_t points = 0; ///< of a case, at most; 0: the more digits, the fewer points
    bool full = false;      ///< treats expensive routes like the others
    bool timed = true;      ///< false: counts and digits only
    /// Receives the number of cells done, and of all cells.
    std::function<void(std::size_t, std::size_t)> progress = {};
};

/// Returns the number of points of a case that are measured at `digits` digits; in the first case
/// the routes are compared. 0: the route is left out.
[[nodiscard]] std::size_t usual_points(const CostRoute& route, unsigned digits, bool first_case);

/// Measures every route that takes a case, at each number of digits, case by case. True errors are
/// computed from an enclosure with more digits than any route is asked for. Throws Interrupted, and
/// InputError for a point that is not inside the contact.
[[nodiscard]] std::vector<CostCell> measure(const std::vector<CostCase>& cases,
                                            const CostOptions& options);

/// Returns the machine on which times are taken as names and values: processor, cores, compiler,
/// libraries with versions.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> machine();

} // namespace edgeproof::cost
