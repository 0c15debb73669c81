// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// The cost of a value: digits reached, evaluations counted, processor time with its spread.
///   contacts.cpp  contacts and points that are timed, and the routes to their pressures
///   measure.cpp   CostCell: a route at a number of digits over the points of a contact
///   report.cpp    tables, the page, its pictures
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/report/tables/table.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::cost {

/// A contact and the points at which its pressure is timed.
struct CostCase {
    std::string name;
    scene::Scene scene;
    contact::Edge edge = contact::Edge::right;
    std::vector<formula::Exact> u;
};

/// Returns the cases that are timed if no scene is given. In the first, routes are compared: a
/// flat-and-rounded punch, t = 0.4 a, with 40 points in a geometric sequence from u = 1e-8 a to a.
/// The others are a wedge, a power law of fractional exponent, both tilted profiles, and hard
/// points: near the end of a flat, near the apex of a power law, and within 1e-300 of an edge.
[[nodiscard]] std::vector<CostCase> usual_cases();

/// Returns a user's scene with its own points (at its first edge), or else with 40 points as above.
/// Throws InputError for a scene without a given profile (a load of P and M), because the compared
/// routes need one.
[[nodiscard]] CostCase case_of(const scene::Scene& scene);

/// The result of a route at a point. A route that proves its values gives the ball as well.
struct CostValue {
    Real value;
    std::size_t evaluations = 0; ///< of an integrand; 0 if the route does not count them
    std::optional<Ball> ball = {};
};

/// A contact prepared for one route at one precision: the work that is done once for each contact.
/// Returns p at the point with index i of the case, which must outlive it. Throws the route's
/// errors.
using ReadyContact = std::function<CostValue(std::size_t i)>;

/// One route to a pressure, in one arithmetic.
struct CostRoute {
    const char* name;
    const char* arithmetic;
    bool expensive; ///< so slow that it is timed at few points and digits, unless asked to
    bool (*takes)(const scene::Scene&);
    ReadyContact (*ready)(const CostCase&, unsigned digits);
};
/// Returns all routes; a new route is a new entry of this list.
[[nodiscard]] const std::vector<CostRoute>& cost_routes();

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
    std::string u = {};
    double right = 0;       ///< -log10 of the true relative error
    double evaluations = 0; ///< 0 if they are not counted
    double seconds = 0;     ///< of the processor, median over repeats
    double spread = 0;      ///< interquartile range of the repeats over the median
    std::string failure = {};
};

/// One route at a number of digits over the points of a case.
struct CostCell {
    std::string scene;
    std::string route;
    std::string arithmetic;
    unsigned digits = 0;        ///< asked for
    double contact_seconds = 0; ///< done once for each contact: edges, tables
    std::vector<PointCost> points;

    [[nodiscard]] std::size_t failed() const;
    /// Returns the quartiles of a result, over the points that did not fail.
    [[nodiscard]] Quartiles over_points(double PointCost::*number) const;
    [[nodiscard]] Quartiles right() const { return over_points(&PointCost::right); }
    [[nodiscard]] Quartiles seconds() const { return over_points(&PointCost::seconds); }
};

struct CostOptions {
    std::vector<unsigned> digits;
    std::size_t points = 0; ///< of a case, at most; 0: the more digits, the fewer points
    bool timed = true;      ///< false: counts and digits only
    /// Receives the number of cells done, and of all cells.
    std::function<void(std::size_t, std::size_t)> progress = {};
};

/// Returns at most `most` of the points, equally spaced, including the first and the last.
[[nodiscard]] std::vector<std::size_t> thinned(std::size_t points, std::size_t most);

/// Measures every route that takes a case, at each number of digits, case by case. True errors are
/// computed from an enclosure with more digits than any route is asked for. Throws Interrupted, and
/// InputError for a point that is not inside the contact.
[[nodiscard]] std::vector<CostCell> measure(const std::vector<CostCase>& cases,
                                            const CostOptions& options);

/// share/edgeproof/report/cost.html when the program was built.
extern const std::string_view cost_html;

/// Returns the machine on which times are taken: processor, cores, compiler.
[[nodiscard]] std::string machine();

/// Returns the tables for readers: each contact with a row for each route and number of digits,
/// and growth with the digits (fitted exponents). Tables without rows are left out.
[[nodiscard]] std::vector<report::Table> cost_tables(const std::vector<CostCell>& cells);

/// Writes cost.csv (every point, times in seconds) and cost.html, a self-contained page with the
/// tables and, for the first contact, two pictures: digits right against time, and the growth of
/// the time with the digits. figures/ has the pictures and their data. Throws InputError if the
/// folder is not writable.
void write_cost_page(const std::vector<CostCell>& cells, const std::filesystem::path& folder);

} // namespace edgeproof::cost

namespace edgeproof::cli {

struct Options;
/// The command `cost` of the program.
int cost(Options& options);

} // namespace edgeproof::cli
