// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/comparison/measures/measures.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/real.hpp"
#include "edgeproof/roots/roots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>
#include <tuple>
#include <utility>

namespace edgeproof::comparison {
namespace {

/// Errors below it are those of the exact value and its place in binary64.
constexpr double of_binary64 = 0x1p-52;

constexpr double least_shift = 0.02;     ///< relative to a + b
constexpr double loaded_fraction = 0.02; ///< of the largest pressure of the data
constexpr std::size_t most_fitted = 300;
constexpr double search_width = 1e-9; ///< relative to a + b
constexpr double same_origin = 1e-4;  ///< the same
/// Where a traction may be steep, relative to a + b: at edges and corners.
constexpr double steep = 0.05;

/// The loaded interval of the data, roughly.
struct Support {
    double left = 0;
    double right = 0;
    bool left_falls = false; ///< p falls to zero there, as at an edge
    bool right_falls = false;
};

/// Returns nothing if no node is loaded. `points`: by x.
std::optional<Support> support_of(const std::vector<RoughPoint>& points,
                                  const ExactContact& exact) {
    // The middle of a flat pad has a small part of the greatest pressure.
    const double in_middle = exact.pressure(0.5 * (exact.a().value - exact.b().value));
    const double least = loaded_fraction * std::min(1.0, in_middle / exact.scale().value);
    double most = 0;
    for (const RoughPoint& point : points) {
        most = std::max(most, point.p);
    }
    const auto loaded = [&](const RoughPoint& point) { return point.p > least * most; };
    const auto first = std::ranges::find_if(points, loaded);
    if (first == points.end()) {
        return {};
    }
    const auto last = std::find_if(points.rbegin(), points.rend(), loaded).base() - 1;
    // p^2 vanishes linearly at an edge: within an element of the end of the data, or not there.
    const auto falls = [](auto end, auto stop) {
        const auto next =
            std::find_if(end, stop, [&](const RoughPoint& point) { return point.x != end->x; });
        return next != stop && 2 * end->p * end->p <= next->p * next->p;
    };
    Support s;
    s.left = first == points.begin() ? first->x : 0.5 * (first->x + (first - 1)->x);
    s.right = last + 1 == points.end() ? last->x : 0.5 * (last->x + (last + 1)->x);
    s.left_falls = first != points.begin() || falls(points.begin(), points.end());
    s.right_falls = last + 1 != points.end() || falls(points.rbegin(), points.rend());
    return s;
}

/// The sum of squares of p minus the exact one, for an origin of the data at `origin`; with
/// `any_scale` minus its best multiple, so that a wrong factor of p does not change the origin.
double mismatch(const std::vector<RoughPoint>& points, const ExactContact& exact, double origin,
                bool any_scale) {
    std::vector<double> right;
    double products = 0;
    double squares = 0;
    const auto width = [&](std::size_t i) { return width_of_node(points, i); };
    for (std::size_t i = 0; i < points.size(); ++i) {
        check_interruption();
        right.push_back(exact.pressure(points[i].x - origin));
        products += width(i) * points[i].p * right[i];
        squares += width(i) * right[i] * right[i];
    }
    const double scale = any_scale && squares > 0 ? products / squares : 1;
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double difference = points[i].p - scale * right[i];
        sum += width(i) * difference * difference;
    }
    return sum;
}

/// Some of the nodes that are not near an edge or a corner if the origin is at `start`.
std::vector<RoughPoint> smooth_points(const std::vector<RoughPoint>& all, const ExactContact& exact,
                                      double start) {
    std::vector<double> places{exact.a().value, -exact.b().value};
    for (const ContactKnot& knot : exact.knots()) {
        if (knot.corner) {
            places.push_back(knot.x);
        }
    }
    std::vector<RoughPoint> points;
    const std::size_t step = std::max<std::size_t>(1, all.size() / most_fitted);
    for (std::size_t i = 0; i < all.size(); i += step) {
        if (std::ranges::none_of(places, [&](double place) {
                return std::abs(all[i].x - start - place) < steep * exact.length();
            })) {
            points.push_back(all[i]);
        }
    }
    return points;
}

/// The shift near `start` that fits best, and whether it is clear.
std::pair<double, bool> refined_shift(const std::vector<RoughPoint>& all, const ExactContact& exact,
                                      double start) {
    constexpr int steps = 40; // to `search_width`
    const bool any_scale = start != 0;
    bool clear = false;
    for (int round = 0; round < 2; ++round) { // the second without the nodes at its own edges
        const std::vector<RoughPoint> points = smooth_points(all, exact, start);
        const auto squares = [&](double x) { return mismatch(points, exact, x, any_scale); };
        start = roots::place_of_minimum(squares, start - 0.1 * exact.length(),
                                        start + 0.1 * exact.length(), steps);
        clear = squares(start) < 0.5 * squares(0);
    }
    return {start, clear};
}

/// Returns the power of ten between 10^-5 and 10^-4 of the length.
Rational round_step(double length) {
    const int exponent = static_cast<int>(std::floor(std::log10(length))) - 5;
    const Rational power(pow(Integer(10), static_cast<unsigned>(std::abs(exponent))));
    return exponent < 0 ? Rational(1 / power) : power;
}

class Aligner {
public:
    Aligner(const ResultTable& table, const ExactContact& exact) : table_(table), exact_(exact) {
        for (const ResultRow& row : table.rows) {
            points_.push_back({row.x.convert_to<double>(), row.p.convert_to<double>()});
        }
        find_sign();
    }

    AlignedResult align(const std::optional<Rational>& given) {
        const auto support = support_of(points_, exact_);
        find_half(support, given ? given->convert_to<double>() : 0);
        if (given) {
            result_.origin = given->convert_to<double>();
            exact_origin_ = Real(*given);
            if (result_.origin != 0) {
                result_.findings.push_back(
                    fmt::format("x is measured from {:.6g} of the data, as given", result_.origin));
            }
        } else {
            find_origin();
        }
        lay_over();
        return std::move(result_);
    }

private:
    void find_sign() {
        if (std::ranges::all_of(points_, [](const RoughPoint& point) { return point.p == 0; })) {
            result_.findings.emplace_back("every pressure of the data is zero");
        }
        const auto p = [](const RoughPoint& point) { return point.p; };
        result_.sign = trapezoids(points_, p) < 0 ? -1 : 1;
        if (result_.sign < 0) {
            result_.findings.emplace_back("compression is negative in the data");
            for (RoughPoint& point : points_) {
                point.p = -point.p;
            }
        }
    }

    /// A mesh of half of a symmetric contact ends where p is high, and not beyond the middle:
    /// data from -0.3 a to the right edge are a part of the whole, not a half.
    void find_half(const std::optional<Support>& support, double origin) {
        if (!support || !exact_.symmetric() || support->left_falls == support->right_falls) {
            return;
        }
        const std::size_t last = points_.size() - 1;
        const auto [end, next, other] = support->right_falls
                                            ? std::array<std::size_t, 3>{0, 1, last}
                                            : std::array<std::size_t, 3>{last, last - 1, 0};
        const double beyond = points_[end].x - origin;
        const bool both_sides = beyond * (points_[other].x - origin) < 0;
        constexpr double of_an_element = 0.01; // for rounded places: a half ends in the middle
        if (both_sides &&
            std::abs(beyond) > of_an_element * std::abs(points_[next].x - points_[end].x)) {
            return;
        }
        result_.half = support->right_falls ? contact::Edge::right : contact::Edge::left;
        result_.findings.push_back(
            exact_.axisymmetric()
                ? "the data begin on the axis"
                : fmt::format("the data contain the {} half of a symmetric contact: P is doubled",
                              scene::edge_name(*result_.half)));
    }

    void find_origin() {
        const auto found = found_shift(points_, result_.half, exact_);
        if (!found || !found->clear || abs(found->exact) < least_shift * exact_.length()) {
            return; // the data's own edges may have shifted the middle
        }
        exact_origin_ = found->exact;
        origin_uncertainty_ = found->uncertainty;
        result_.origin = exact_origin_.convert_to<double>();
        result_.origin_found = true;
        result_.findings.push_back(
            fmt::format("the origin of the scene lies at x = {:.10g} of the data, found from the "
                        "data as --origin auto requests{}",
                        result_.origin, found->what));
    }

    void lay_over() {
        const PrecisionScope scope(ExactContact::place_digits);
        double agreement = 0; // of the directions of q
        for (std::size_t i = 0; i < table_.rows.size(); ++i) {
            check_interruption();
            const ResultRow& row = table_.rows[i];
            const Real x = Real(row.x) - exact_origin_;
            Node node{row.line, x.convert_to<double>(), exact_.at(x), {}, {}};
            node.p = traction(i, x, node.place, row.p, row.p_rounding, &ExactContact::p);
            if (row.q && exact_.shear() != nullptr) {
                node.q = traction(i, x, node.place, *row.q, row.q_rounding, &ExactContact::q);
                agreement += node.q->data * node.q->exact.value_or(0);
            }
            result_.nodes.push_back(std::move(node));
        }
        // Programs write q of either body: the direction with the better agreement is chosen.
        if (agreement < 0) {
            result_.shear_sign = -1;
            result_.findings.emplace_back("q has the opposite sign in the data");
        }
        for (std::size_t i = 0; i < table_.rows.size(); ++i) {
            Node& node = result_.nodes[i];
            set_error(node.p, table_.rows[i].p, result_.sign);
            if (node.q) {
                set_error(*node.q, *table_.rows[i].q, result_.shear_sign);
            }
        }
    }
    using Value = std::optional<double> (ExactContact::*)(const ExactContact::Place&) const;
    [[nodiscard]] Traction traction(std::size_t i, const Real& x, const ExactContact::Place& place,
                                    const Rational& written, double rounding, Value value) const {
        Traction t{written.convert_to<double>(), (exact_.*value)(place), 0, rounding};
        if (t.exact) {
            t.rounding += of_binary64 * std::abs(*t.exact);
            // Just inside an edge q may be infinite, which explains no q outside.
            if (place.inside() || value == &ExactContact::p) {
                t.rounding += moved_by_rounding(i, x, place, value);
            }
        }
        return t;
    }
    static void set_error(Traction& t, const Rational& written, double sign) {
        t.data *= sign;
        t.error = t.exact ? Real(Real(written) * Real(sign) - *t.exact).convert_to<double>() : 0.0;
    }

    /// The change of an exact value when x changes by half a unit of its last digit. A grid of few
    /// decimals is taken to be exact: its step is not a rounding error.
    [[nodiscard]] double moved_by_rounding(std::size_t i, const Real& x,
                                           const ExactContact::Place& here, Value value) const {
        const double half = table_.rows[i].x_rounding + origin_uncertainty_;
        const double gap =
            std::min(i > 0 ? points_[i].x - points_[i - 1].x : exact_.length(),
                     i + 1 < points_.size() ? points_[i + 1].x - points_[i].x : exact_.length());
        constexpr double small = 0.02;
        constexpr double negligible = 1e-12;
        if (half > small * gap || half < negligible * std::abs(here.u())) {
            return 0;
        }
        const Real step = here.nearer() == contact::Edge::right ? Real(half) : Real(-half);
        const double value_here = *(exact_.*value)(here);
        double most = 0;
        for (const Real& neighbour : {Real(x + step), Real(x - step)}) {
            const auto moved = (exact_.*value)(exact_.at(neighbour));
            most = std::max(most, moved ? std::abs(*moved - value_here) : 0.0);
        }
        return most;
    }

    const ResultTable& table_;
    const ExactContact& exact_;
    std::vector<RoughPoint> points_;
    Real exact_origin_ = Real(0);
    double origin_uncertainty_ = 0;
    AlignedResult result_;
};

} // namespace

AlignedResult align(const ResultTable& table, const ExactContact& exact,
                    const std::optional<Rational>& origin) {
    const PrecisionScope scope(ExactContact::place_digits);
    return Aligner(table, exact).align(origin);
}

std::optional<FoundShift> found_shift(const std::vector<RoughPoint>& points,
                                      const std::optional<contact::Edge>& half,
                                      const ExactContact& exact) {
    const auto support = support_of(points, exact);
    if (!support) {
        return {};
    }
    const double length = exact.length();
    const double left = -exact.b().value;
    const double right = exact.a().value;
    double start = 0.5 * (support->left + support->right) - 0.5 * (left + right);
    if (half) {
        start = *half == contact::Edge::right ? points.front().x : points.back().x;
    } else if (!support->left_falls || !support->right_falls) {
        // The data end inside the contact: the one edge in them is aligned with the exact one.
        start = support->right_falls  ? support->right - right
                : support->left_falls ? support->left - left
                                      : 0;
    }
    FoundShift origin;
    double found = 0;
    if (std::abs(start) >= least_shift * length) {
        std::tie(found, origin.clear) = refined_shift(points, exact, start);
    }
    if (!origin.clear) {
        std::tie(found, origin.clear) = refined_shift(points, exact, 0);
    }
    // An origin that programs often use is preferred if the fitted one agrees with it.
    const std::pair<double, std::string_view> usual[] = {
        {-left, ": x is measured from the left edge of the contact"},
        {-right, ": x is measured from the right edge of the contact"},
        {-0.5 * (left + right), ": x is measured from the middle of the contact"},
        {points.front().x, ": it is at the first node"},
        {points.back().x, ": it is at the last node"},
    };
    const auto near = std::ranges::find_if(usual, [&](const auto& place) {
        return std::abs(place.first - found) < same_origin * length &&
               std::abs(place.first) > least_shift * length;
    });
    if (near != std::end(usual)) {
        found = near->first;
        origin.what = near->second;
    }
    origin.exact = Real(found);
    if (origin.what.empty()) {
        // A round number within the resolution of the search is chosen; otherwise the last digit of
        // the origin is uncertain.
        const Rational step = round_step(length);
        const Rational units = exact_rational(found) / step;
        const Rational round = step * exact_rational(std::round(units.convert_to<double>()));
        const bool meant = std::abs((round - exact_rational(found)).convert_to<double>()) <
                           10 * search_width * length;
        origin.exact = meant ? Real(round) : origin.exact;
        origin.uncertainty = meant ? 0 : 2 * search_width * length;
    }
    return origin;
}

} // namespace edgeproof::comparison
