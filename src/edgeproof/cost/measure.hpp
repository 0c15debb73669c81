// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/cost/cost_route.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::cost {

/// The middle half of some numbers.
struct Quartiles {
    double least = 0;
    double low = 0;
    double median = 0;
    double high = 0;
    double most = 0;
};
/// All 0 for no numbers.
[[nodiscard]] Quartiles quartiles(std::vector<double> numbers);

/// One point by one route. What failed has no digits and no time.
struct PointCost {
    std::size_t point = 0; ///< of the case
    double right = 0;      ///< -log10 of the true relative error
    std::optional<std::size_t> evaluations = {};
    double seconds = 0; ///< of the processor, median over repeats
    double spread = 0;  ///< interquartile range of the repeats over the median
    std::string failure = {};
};

/// One route at so many digits over the points of a case.
struct CostCell {
    std::string scene;
    std::string route;
    std::string arithmetic;
    unsigned digits = 0; ///< asked for, or what the arithmetic has
    bool proves = false;
    double contact_seconds = 0; ///< once a contact: edges, tables
    std::vector<PointCost> points;

    [[nodiscard]] std::size_t failed() const;
    [[nodiscard]] Quartiles right() const;
    [[nodiscard]] Quartiles seconds() const;
    /// Nothing where they are not counted.
    [[nodiscard]] std::optional<Quartiles> evaluations() const;
    [[nodiscard]] std::size_t total_evaluations() const;
    /// Median over the points of the spread over repeats.
    [[nodiscard]] double spread() const;
};

struct CostOptions {
    std::vector<unsigned> digits;
    std::size_t points = 0; ///< of a case, at most; 0: fewer the more digits there are
    bool full = false;      ///< expensive routes as the others
    bool timed = true;      ///< else counts and digits only
    /// Cells done, of how many.
    std::function<void(std::size_t, std::size_t)> progress = {};
};

/// So many points of a case are taken at so many digits, the first case being the one at which the
/// routes are compared; 0: the route is left out.
[[nodiscard]] std::size_t usual_points(const CostRoute& route, unsigned digits, bool first_case);

/// Every route that takes a case, at each number of digits (a machine's arithmetic once, where its
/// digits are no more than the most asked for), case by case. True errors are taken against an
/// enclosure with more digits than any route is asked for. Throws Interrupted,
/// InputError for a point that is not inside the contact.
[[nodiscard]] std::vector<CostCell> measure(const std::vector<CostCase>& cases,
                                            const CostOptions& options);

} // namespace edgeproof::cost
