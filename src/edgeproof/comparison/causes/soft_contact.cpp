// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/comparison/causes/causes.hpp"
#include "edgeproof/contact/profile/slope.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/roots/roots.hpp"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace edgeproof::comparison {
namespace {

constexpr int elements_in_contact = 128;
constexpr int elements_outside = 43; ///< on each side
constexpr int steps_of_gap = 8;      ///< within an element
constexpr int most_rounds = 100;
constexpr double near_elements = 2.5;
constexpr double least_softness = 0.001;
constexpr double most_softness = 0.6;
constexpr double softness_ratio = 2; ///< of neighbours
constexpr int golden_steps = 10;

/// Gaussian elimination with pivoting. The rows of `m` end with the right-hand side.
std::vector<double> solved(std::vector<std::vector<double>> m) {
    const std::size_t n = m.size();
    for (std::size_t k = 0; k < n; ++k) {
        const auto pivot = std::max_element(m.begin() + static_cast<std::ptrdiff_t>(k), m.end(),
                                            [k](const auto& one, const auto& other) {
                                                return std::abs(one[k]) < std::abs(other[k]);
                                            });
        std::swap(m[k], *pivot);
        for (std::size_t i = k + 1; i < n; ++i) {
            const double factor = m[i][k] / m[k][k];
            for (std::size_t j = k; factor != 0 && j <= n; ++j) {
                m[i][j] -= factor * m[k][j];
            }
        }
    }
    std::vector<double> x(n);
    for (std::size_t k = n; k-- > 0;) {
        double sum = m[k][n];
        for (std::size_t j = k + 1; j < n; ++j) {
            sum -= m[k][j] * x[j];
        }
        x[k] = sum / m[k][k];
    }
    return x;
}

/// The displacement of the half-space at the radius r under a unit pressure on a disc of radius c,
/// times pi E*/4 (johnson1985, equations 3.29).
double disc(double r, double c) {
    if (r < c) {
        return c * boost::math::ellint_2(r / c);
    }
    const double k = c / r;
    return k == 1 ? r : r * (boost::math::ellint_2(k) - (1 - k * k) * boost::math::ellint_1(k));
}

} // namespace

std::vector<double> gap_of(const scene::Scene& scene, const ExactContact& exact, double first,
                           double width, std::size_t elements) {
    const PrecisionScope scope(20);
    const contact::RealSlope slope(scene.round ? scene.round->profile : exact.profile());
    std::vector<double> gap{0};
    const double step = width / steps_of_gap;
    for (std::size_t i = 1; i < elements; ++i) {
        check_interruption();
        double rise = 0;
        for (int k = 0; k < steps_of_gap; ++k) {
            const Real x(first + static_cast<double>(i - 1) * width + (k + 0.5) * step);
            rise += step * slope.value(slope.piece_at(x), x).convert_to<double>();
        }
        gap.push_back(gap.back() + rise);
    }
    return gap;
}

SoftContact::SoftContact(const scene::Scene& scene, const ExactContact& exact)
    : round_(exact.axisymmetric()), length_(exact.length()), width_(length_ / elements_in_contact),
      force_(exact.force().value), special_{exact.a().value, -exact.b().value} {
    const PrecisionScope scope(20);
    modulus_ = scene.contact_modulus.to<Real>().convert_to<double>();
    if (scene.moment) {
        moment_ = scene.moment->to<Real>().convert_to<double>();
    }
    for (const ContactKnot& knot : exact.knots()) {
        if (knot.corner) {
            special_.push_back(knot.x);
        }
    }
    const int inside = round_ ? elements_in_contact / 2 : elements_in_contact + elements_outside;
    const double first = round_ ? width_ / 2 : -exact.b().value - (elements_outside - 0.5) * width_;
    gap_ = gap_of(scene, exact, first, width_, static_cast<std::size_t>(inside + elements_outside));
    for (std::size_t i = 0; i < gap_.size(); ++i) {
        x_.push_back(first + static_cast<double>(i) * width_);
    }
    find_influences();
    rigid_ = solve(0).value_or(Solution{});
    for (double softness = least_softness; softness < most_softness; softness *= softness_ratio) {
        if (auto solution = solve(softness)) {
            soft_.push_back(std::move(*solution));
        }
    }
}

// The best of the solutions, and then golden section between its neighbours.
std::optional<SoftContact::Solution>
SoftContact::fitted(const std::function<double(const Solution&)>& left) const {
    double best = left(rigid_) / 2;
    double softness = 0;
    for (const Solution& solution : soft_) {
        if (const double here = left(solution); here < best) {
            best = here;
            softness = solution.softness;
        }
    }
    if (softness == 0) {
        return {};
    }
    const auto left_at = [&](double logarithm) {
        const auto solution = solve(std::exp(logarithm));
        return solution ? left(*solution) : std::numeric_limits<double>::infinity();
    };
    const double ratio = std::log(softness_ratio);
    return solve(std::exp(roots::place_of_minimum(left_at, std::log(softness) - ratio,
                                                  std::log(softness) + ratio, golden_steps)));
}

void SoftContact::find_influences() {
    const double of_unit = 1 / (std::numbers::pi * modulus_);
    const auto integral = [](double z) { return z * std::log(std::abs(z)) - z; };
    u_.assign(x_.size(), std::vector<double>(x_.size()));
    for (std::size_t i = 0; i < x_.size(); ++i) {
        check_interruption();
        for (std::size_t j = 0; j < x_.size(); ++j) {
            const double left = x_[j] - width_ / 2;
            const double right = x_[j] + width_ / 2;
            u_[i][j] = round_ ? 4 * of_unit * (disc(x_[i], right) - disc(x_[i], left))
                              : -2 * of_unit * (integral(x_[i] - left) - integral(x_[i] - right));
        }
    }
}

std::optional<SoftContact::Solution> SoftContact::solve(double softness) const {
    const std::size_t n = x_.size();
    const auto weight = [&](std::size_t i) {
        return round_ ? 2 * std::numbers::pi * x_[i] * width_ : width_;
    };
    std::vector<std::size_t> active;
    for (std::size_t i = 0; i < n; ++i) {
        if (x_[i] > special_[1] && x_[i] < special_[0]) {
            active.push_back(i);
        }
    }
    for (int round = 0; round < most_rounds; ++round) {
        check_interruption();
        const std::size_t m = active.size();
        const std::size_t unknowns = m + (moment_ ? 2 : 1);
        std::vector<std::vector<double>> matrix(unknowns, std::vector<double>(unknowns + 1));
        for (std::size_t i = 0; i < m; ++i) {
            const std::size_t at = active[i];
            for (std::size_t j = 0; j < m; ++j) {
                matrix[i][j] = u_[at][active[j]];
            }
            matrix[i][i] += softness * length_ / modulus_;
            matrix[i][m] = -1;
            matrix[m][i] = weight(at);
            if (moment_) {
                matrix[i][m + 1] = -x_[at];
                matrix[m + 1][i] = weight(at) * x_[at];
            }
            matrix[i][unknowns] = -gap_[at];
        }
        matrix[m][unknowns] = force_;
        if (moment_) {
            matrix[m + 1][unknowns] = *moment_;
        }
        const std::vector<double> found = solved(std::move(matrix));
        Solution solution{softness, 0, 0, std::vector<double>(n)};
        for (std::size_t i = 0; i < m; ++i) {
            solution.p[active[i]] = found[i];
        }
        std::vector<std::size_t> next;
        for (std::size_t i = 0, k = 0; i < n; ++i) {
            const bool was_active = k < m && active[k] == i;
            k += was_active ? 1 : 0;
            double penetration = found[m] + (moment_ ? found[m + 1] * x_[i] : 0) - gap_[i];
            for (std::size_t j = 0; !was_active && j < m; ++j) {
                penetration -= u_[i][active[j]] * found[j];
            }
            if (was_active ? solution.p[i] > 0 : penetration > 0) {
                next.push_back(i);
            }
        }
        if (next.empty() || next.back() + 1 == n || (!round_ && next.front() == 0)) {
            return {};
        }
        if (next == active) {
            solution.a = x_[next.back()] + width_ / 2;
            solution.b = round_ ? solution.a : width_ / 2 - x_[next.front()];
            return solution;
        }
        active = std::move(next);
    }
    return {};
}

double SoftContact::change(const Solution& soft, double x) const {
    const double place = round_ ? std::abs(x) : x;
    const bool near = std::ranges::any_of(
        special_, [&](double at) { return std::abs(x - at) < near_elements * width_; });
    if (near || rigid_.p.empty()) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    const double from_first = (place - x_.front()) / width_;
    // The place is compared before it becomes an index: a node may be farther away than an integer
    // can count.
    if (!(from_first < static_cast<double>(x_.size() - 1))) {
        return 0;
    }
    const auto k = static_cast<std::size_t>(std::max(0.0, from_first));
    const double part = std::max(0.0, from_first) - static_cast<double>(k);
    const auto at = [&](std::size_t j) { return soft.p[j] - rigid_.p[j]; };
    return from_first < 0 && !round_ ? 0 : at(k) + part * (at(k + 1) - at(k));
}

} // namespace edgeproof::comparison
