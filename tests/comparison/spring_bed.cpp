// SPDX-License-Identifier: BSD-3-Clause
#include "tests/comparison/injected_mistakes.hpp"

#include "edgeproof/comparison/causes/causes.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace edgeproof::comparison {
namespace {

/// The integral of ln|z| over a hat of half-width h about the distance d, divided by h.
double hat_of_logarithm(double d, double h) {
    const auto twice = [](double z) {
        return z == 0 ? 0 : z * z * (0.5 * std::log(std::abs(z)) - 0.75);
    };
    return (twice(d + h) - 2 * twice(d) + twice(d - h)) / h;
}

} // namespace

SpringBed::SpringBed(const scene::Scene& scene, const ExactContact& exact, double softness)
    : round_(exact.axisymmetric()), softness_(0),
      modulus_(scene.contact_modulus.to<Real>().convert_to<double>()),
      width_(exact.length() / (round_ ? 260 : 200)) {
    softness_ = softness * exact.length() / modulus_;
    const double reach = 0.45 * exact.length();
    const double first = round_ ? width_ / 2 : -exact.b().value - reach;
    const auto n = static_cast<std::size_t>((exact.a().value + reach - first) / width_);
    gap_ = gap_of(scene, exact, first, width_, n);
    for (std::size_t i = 0; i < n; ++i) {
        x_.push_back(first + static_cast<double>(i) * width_);
        weight_.push_back(round_ ? 2 * std::numbers::pi * x_[i] * width_ : width_);
    }
    for (std::size_t i = 0; i < n; ++i) {
        check_interruption();
        Values& row = u_.emplace_back();
        for (std::size_t j = 0; j < n; ++j) {
            row.push_back(influence(i, j));
        }
    }
    // The couple of a flat punch that turns gives the tilt for the moment (tilt_solver.hpp).
    double tilt = 0;
    for (int round = 0; round < (scene.moment ? 12 : 1); ++round) {
        solve(exact.force().value, tilt);
        const double moment = total(p_, x_);
        const double wanted = scene.moment ? scene.moment->to<Real>().convert_to<double>() : moment;
        tilt +=
            4 * (wanted - moment) / (std::numbers::pi * modulus_ * std::pow(exact.length() / 2, 2));
    }
}

double SpringBed::influence(std::size_t at, std::size_t of) const {
    if (!round_) {
        return -2 / (std::numbers::pi * modulus_) * hat_of_logarithm(x_[at] - x_[of], width_);
    }
    const int steps = at == of ? 256 : 8;
    double sum = 0;
    for (int k = 0; k < steps; ++k) {
        const double s = x_[of] + width_ * ((k + 0.5) / steps - 0.5);
        const double both = x_[at] + s;
        sum += s / both * std::comp_ellint_1(2 * std::sqrt(x_[at] * s) / both);
    }
    return 4 / (std::numbers::pi * modulus_) * sum * width_ / steps;
}

SpringBed::Values SpringBed::displacement(const Values& p) const {
    Values u;
    for (std::size_t i = 0; i < p.size(); ++i) {
        double sum = softness_ * p[i];
        for (std::size_t j = 0; j < p.size(); ++j) {
            sum += u_[i][j] * p[j];
        }
        u.push_back(sum);
    }
    return u;
}

double SpringBed::total(const Values& one, const Values& other) const {
    double sum = 0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        sum += weight_[i] * one[i] * other[i];
    }
    return sum;
}

void SpringBed::solve(double force, double tilt) {
    const std::size_t n = x_.size();
    const Values ones(n, 1);
    p_.assign(n, force / total(ones, ones));
    Values direction(n, 0);
    double last = 1;
    bool conjugate = false;
    for (int round = 0; round < 2000; ++round) {
        check_interruption();
        Values touching;
        std::ranges::transform(p_, std::back_inserter(touching), [](double p) { return p > 0; });
        const auto less_mean = [&](Values values) {
            const double mean = total(values, touching) / total(touching, touching);
            for (double& value : values) {
                value -= mean;
            }
            return values;
        };
        Values off = displacement(p_);
        for (std::size_t i = 0; i < n; ++i) {
            off[i] += gap_[i] - tilt * x_[i];
        }
        off = less_mean(std::move(off));
        Values inside = off;
        for (std::size_t i = 0; i < n; ++i) {
            inside[i] *= touching[i];
        }
        const double square = total(inside, inside);
        for (std::size_t i = 0; i < n; ++i) {
            direction[i] = touching[i] * (off[i] + (conjugate ? square / last : 0) * direction[i]);
        }
        last = square;
        const double step =
            total(inside, direction) / total(less_mean(displacement(direction)), direction);
        conjugate = true;
        const Values before = p_;
        for (std::size_t i = 0; i < n; ++i) {
            p_[i] = std::max(0.0, p_[i] - step * direction[i]);
            if (p_[i] == 0 && off[i] < 0) {
                p_[i] = -step * off[i];
                conjugate = false;
            }
        }
        const double scale = force / total(p_, ones);
        double moved = 0;
        for (std::size_t i = 0; i < n; ++i) {
            p_[i] *= scale;
            moved += weight_[i] * std::abs(p_[i] - before[i]);
        }
        if (moved < 1e-11 * force) {
            return;
        }
    }
}

double SpringBed::pressure(double x) const {
    const double from_first = std::max(0.0, ((round_ ? std::abs(x) : x) - x_.front()) / width_);
    const auto i = static_cast<std::size_t>(from_first);
    return i + 1 < p_.size() ? p_[i] + (from_first - static_cast<double>(i)) * (p_[i + 1] - p_[i])
                             : 0;
}

} // namespace edgeproof::comparison
