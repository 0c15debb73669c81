// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/measures/alignment.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/rational.hpp"
#include "edgeproof/roots/bracketed_root.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

namespace edgeproof::comparison {
namespace {

/// Errors below it are those of the exact value and its place in binary64.
constexpr double of_binary64 = 0x1p-52;

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
        } else if (support) {
            find_origin(*support);
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

    void find_origin(const Support& support) {
        const auto found = origin_of(points_, support, result_.half, exact_);
        if (!found) {
            return;
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
        for (std::size_t i = 0; i < table_.rows.size(); ++i) {
            check_interruption();
            const ResultRow& row = table_.rows[i];
            const Real x = Real(row.x) - exact_origin_;
            Node node;
            node.line = row.line;
            node.x = x.convert_to<double>();
            node.p = points_[i].p;
            node.exact = exact_.at(x);
            node.rounding = row.p_rounding;
            if (node.exact.p) {
                node.rounding += of_binary64 * *node.exact.p;
                const Real p = Real(row.p) * Real(result_.sign);
                node.error = Real(p - *node.exact.p).convert_to<double>();
                node.rounding +=
                    moved_by_rounding(i, x, node.exact, [](const auto& place) { return place.p; });
            }
            if (row.q && exact_.shear() != nullptr) {
                NodeShear shear;
                shear.q = row.q->convert_to<double>();
                shear.exact = exact_.traction(node.exact);
                shear.rounding = row.q_rounding + of_binary64 * std::abs(shear.exact.value_or(0));
                if (shear.exact && node.exact.inside()) {
                    shear.rounding +=
                        moved_by_rounding(i, x, node.exact, [this](const auto& place) {
                            return exact_.traction(place);
                        });
                }
                node.shear = shear;
            }
            result_.nodes.push_back(std::move(node));
        }
        find_shear_sign();
    }

    /// Programs write q of either body: the direction with the better agreement is chosen.
    void find_shear_sign() {
        double agreement = 0;
        for (const Node& node : result_.nodes) {
            agreement += node.shear && node.shear->exact ? node.shear->q * *node.shear->exact : 0.0;
        }
        if (agreement < 0) {
            result_.shear_sign = -1;
            result_.findings.emplace_back("q has the opposite sign in the data");
        }
        for (Node& node : result_.nodes) {
            if (node.shear) {
                node.shear->q *= result_.shear_sign;
                node.shear->error = node.shear->exact ? node.shear->q - *node.shear->exact : 0;
            }
        }
    }

    /// The change of an exact value when x changes by half a unit of its last digit. A grid of few
    /// decimals is taken to be exact: its step is not a rounding error.
    template <class Value>
    [[nodiscard]] double moved_by_rounding(std::size_t i, const Real& x,
                                           const ExactContact::Place& here,
                                           const Value& value) const {
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
        const double value_here = *value(here);
        double most = 0;
        for (const Real& neighbour : {Real(x + step), Real(x - step)}) {
            const auto moved = value(exact_.at(neighbour));
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

namespace {

constexpr double least_shift = 0.02;     ///< relative to a + b
constexpr double loaded_fraction = 0.02; ///< of the largest pressure of the data
constexpr std::size_t most_fitted = 300;
constexpr double search_width = 1e-9; ///< relative to a + b

/// The sum of squares of p minus the best multiple of the exact one, for an origin of the data at
/// `origin`. The multiple is free, so that a wrong factor of p does not change the origin.
double mismatch(const std::vector<RoughPoint>& points, const ExactContact& exact, double origin) {
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
    const double scale = squares > 0 ? products / squares : 1;
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double difference = points[i].p - scale * right[i];
        sum += width(i) * difference * difference;
    }
    return sum;
}

double refined_origin(const std::vector<RoughPoint>& all, const ExactContact& exact, double start) {
    std::vector<RoughPoint> points;
    const std::size_t step = std::max<std::size_t>(1, all.size() / most_fitted);
    for (std::size_t i = 0; i < all.size(); i += step) {
        points.push_back(all[i]);
    }
    constexpr int steps = 40; // to `search_width`
    return roots::place_of_minimum([&](double origin) { return mismatch(points, exact, origin); },
                                   start - 0.1 * exact.length(), start + 0.1 * exact.length(),
                                   steps);
}

/// Returns the power of ten between 10^-5 and 10^-4 of the length.
Rational round_step(double length) {
    Rational step(1, 100000);
    for (double unit = 10; unit <= length; unit *= 10) {
        step *= 10;
    }
    for (double unit = 1; unit > length; unit /= 10) {
        step /= 10;
    }
    return step;
}

Integer floor(const Rational& q) {
    const Integer n = numerator(q);
    const Integer d = denominator(q);
    Integer quotient = n / d; // rounded towards zero
    return quotient * d > n ? Integer(quotient - 1) : quotient;
}

constexpr double same_origin = 1e-4; ///< relative to a + b

} // namespace

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

std::optional<FoundOrigin> origin_of(const std::vector<RoughPoint>& points, const Support& support,
                                     const std::optional<contact::Edge>& half,
                                     const ExactContact& exact) {
    const double length = exact.length();
    const double left = -exact.b().value;
    const double right = exact.a().value;
    double start = 0.5 * (support.left + support.right) - 0.5 * (left + right);
    if (half) {
        start = *half == contact::Edge::right ? points.front().x : points.back().x;
    } else if (!support.left_falls || !support.right_falls) {
        // The data end inside the contact: the one edge in them is aligned with the exact one.
        start = support.right_falls  ? support.right - right
                : support.left_falls ? support.left - left
                                     : 0;
    }
    if (!(std::abs(start) >= least_shift * length)) {
        return {};
    }
    double found = refined_origin(points, exact, start);
    if (!std::isfinite(found) || std::abs(found) < least_shift * length) {
        return {}; // the data's own edges had shifted the middle
    }
    if (!(mismatch(points, exact, found) <= 0.5 * mismatch(points, exact, 0))) {
        return {}; // no better than the present origin
    }
    // An origin that programs often use is preferred if the fitted one agrees with it.
    const std::pair<double, std::string_view> usual[] = {
        {-left, ": x is measured from the left edge of the contact"},
        {-right, ": x is measured from the right edge of the contact"},
        {-0.5 * (left + right), ": x is measured from the middle of the contact"},
        {points.front().x, ": it is at the first node"},
        {points.back().x, ": it is at the last node"},
    };
    FoundOrigin origin;
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
        const Rational round = step * Rational(floor(units + Rational(1, 2)));
        const bool meant = std::abs((round - exact_rational(found)).convert_to<double>()) <
                           10 * search_width * length;
        origin.exact = meant ? Real(round) : origin.exact;
        origin.uncertainty = meant ? 0 : 2 * search_width * length;
    }
    return origin;
}

} // namespace edgeproof::comparison
