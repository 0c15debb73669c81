// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/measures/exact_contact.hpp"

#include "edgeproof/precision/precision.hpp"
#include "edgeproof/quadrature/gauss_legendre.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace edgeproof::comparison {
namespace {

constexpr std::array<std::size_t, 2> nodes_of_a_piece{32, 64};
constexpr double most_difference = 1e-9; ///< between both rules, of p
constexpr unsigned digits_of_slope = 20;

} // namespace

// eqn:SIEPressure with its principal value taken out (docs/curved-slopes.md, "What is integrated"):
// p = E*/(2 pi) w(x) times the integral of (g'(s) - g'(x))/(s - x) over theta, s = c + d cos theta.
QuickPressure::QuickPressure(const contact::Profile& profile, double contact_modulus, double a,
                             double b)
    : slope_([&] {
          const PrecisionScope scope(digits_of_slope);
          return contact::RealSlope(profile);
      }()),
      factor_(contact_modulus / (2 * std::numbers::pi)), a_(a), b_(b) {
    const double centre = (a - b) / 2;
    const double half = (a + b) / 2;
    for (std::size_t k = 0; k < rules_.size(); ++k) {
        const auto rule = quadrature::gauss_legendre_balls(nodes_of_a_piece[k], 80);
        const auto add = [&](std::size_t piece, double from, double to) {
            for (std::size_t i = 0; i < rule->x.size(); ++i) {
                const double t = rule->x[i].midpoint().convert_to<double>();
                const double weight =
                    rule->weight[i].midpoint().convert_to<double>() * (to - from) / 2;
                for (const double side : {-1.0, 1.0}) {
                    const double theta = (from + to + side * t * (to - from)) / 2;
                    const double s = centre + half * std::cos(theta);
                    rules_[k].push_back({s, slope(piece, s), weight});
                }
            }
        };
        double from = 0; // theta, from the right edge
        for (std::size_t i = slope_.knots().size(); i-- > 0;) {
            const double knot = slope_.knots()[i].convert_to<double>();
            if (knot < a && knot > -b) {
                const double to = std::acos((knot - centre) / half);
                add(i + 1, from, to);
                from = to;
            }
        }
        add(slope_.piece_at(Real(std::nextafter(-b, a))), from, std::numbers::pi);
    }
}

double QuickPressure::slope(std::size_t piece, double x) const {
    const PrecisionScope scope(digits_of_slope);
    return slope_.value(piece, Real(x)).convert_to<double>();
}

std::optional<double> QuickPressure::at(double x) const {
    const double here = slope(slope_.piece_at(Real(x)), x);
    std::array<double, 2> sum{};
    for (std::size_t k = 0; k < rules_.size(); ++k) {
        for (const Node& node : rules_[k]) {
            sum[k] += node.weight * (node.slope - here) / (node.s - x);
        }
    }
    const bool agree = std::abs(sum[0] - sum[1]) <= most_difference * std::abs(sum[1]);
    return agree ? std::optional(factor_ * std::sqrt((a_ - x) * (x + b_)) * sum[1]) : std::nullopt;
}

} // namespace edgeproof::comparison
