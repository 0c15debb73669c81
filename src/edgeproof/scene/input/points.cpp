// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/input/points.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <string>

namespace edgeproof::scene {
namespace {

constexpr unsigned point_digits = 12;
constexpr std::size_t most_points = 100'000;

void require_ascending(const formula::Exact& from, const formula::Exact& to) {
    if (formula::Exact(to.expr() - from.expr()).sign() <= 0) {
        throw InputError("the points from " + from.text() + " to " + to.text() + " do not ascend",
                         "give from < to");
    }
}

Rational power_of_ten(std::size_t k) {
    return Rational(boost::multiprecision::pow(Integer(10), static_cast<unsigned>(k)));
}

} // namespace

std::vector<formula::Exact> geometric_points(const formula::Exact& from, const formula::Exact& to,
                                             std::size_t per_decade) {
    if (from.sign() <= 0) {
        throw InputError("the points begin at " + from.text() + ", which is not positive",
                         "give from > 0");
    }
    require_ascending(from, to);
    const PrecisionScope scope(50);
    const Real first = from.to<Real>();
    const Real last = to.to<Real>();
    const Real count = log10(Real(last / first)) * static_cast<unsigned>(per_decade);
    if (count >= most_points) {
        throw InputError("more than 100,000 points from " + from.text() + " to " + to.text(),
                         "give a smaller per_decade");
    }
    // A last point of the sweep that all but meets `to` gives way to it.
    const Real end = last * (1 - pow(Real(10), 1 - static_cast<int>(point_digits)));
    std::vector<formula::Exact> points{from};
    for (std::size_t k = 1;; ++k) {
        const Real x = first * pow(Real(10), Real(static_cast<unsigned>(k)) /
                                                 static_cast<unsigned>(per_decade));
        if (!(x < end)) {
            break;
        }
        if (k % per_decade == 0 && from.is_rational()) {
            points.push_back(formula::Exact::of(from.rational() * power_of_ten(k / per_decade)));
        } else {
            points.push_back(formula::Exact::parse(to_decimal(x, point_digits)));
        }
    }
    points.push_back(to);
    return points;
}

std::vector<formula::Exact> even_points(const formula::Exact& from, const formula::Exact& to,
                                        std::size_t count) {
    require_ascending(from, to);
    if (count < 2 || count > most_points) {
        throw InputError(std::to_string(count) + " evenly spaced points",
                         "give points = 2 ... 100000");
    }
    std::vector<formula::Exact> points{from};
    const auto steps = static_cast<long>(count - 1);
    for (long k = 1; k < steps; ++k) {
        if (from.is_rational() && to.is_rational()) {
            points.push_back(formula::Exact::of(from.rational() +
                                                (to.rational() - from.rational()) * k / steps));
        } else {
            points.emplace_back(from.expr() + (to.expr() - from.expr()) *
                                                  formula::Expr::number(Rational(k, steps)));
        }
    }
    points.push_back(to);
    return points;
}

} // namespace edgeproof::scene
