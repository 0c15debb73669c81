// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/input/points.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <string>
#include <utility>

namespace edgeproof::scene {
namespace {

constexpr unsigned point_digits = 12;
constexpr unsigned digits_of_ratios = 50;
constexpr std::size_t most_points = 100'000;

Rational power_of_ten(std::size_t k) {
    return Rational(boost::multiprecision::pow(Integer(10), static_cast<unsigned>(k)));
}

} // namespace

PointRange::PointRange(Exact from, Exact to, std::size_t per_decade)
    : from_(std::move(from)), to_(std::move(to)), per_decade_(per_decade) {
    if (Exact(to_.expr() - from_.expr()).sign() <= 0) {
        throw InputError("the points from " + from_.text() + " to " + to_.text() + " do not ascend",
                         "give from < to");
    }
}

PointRange PointRange::geometric(const Exact& from, const Exact& to, std::size_t per_decade) {
    if (from.sign() <= 0) {
        throw InputError("the points begin at " + from.text() + ", which is not positive",
                         "give from > 0");
    }
    PointRange range(from, to, per_decade);
    const PrecisionScope scope(digits_of_ratios);
    range.first_ = from.to<Real>();
    const Real last = to.to<Real>();
    const Real count = log10(Real(last / range.first_)) * static_cast<unsigned>(per_decade);
    if (count >= most_points) {
        throw InputError("more than 100,000 points from " + from.text() + " to " + to.text(),
                         "give a smaller per_decade");
    }
    // The last point of the sweep is replaced by `to` if the two nearly coincide.
    const Real end = last * (1 - pow(Real(10), 1 - static_cast<int>(point_digits)));
    auto k = count.convert_to<std::size_t>() + 1;
    while (k > 0 && !(range.between(k) < end)) {
        --k;
    }
    range.size_ = k + 2;
    return range;
}

PointRange PointRange::even(const Exact& from, const Exact& to, std::size_t count) {
    PointRange range(from, to, 0);
    if (count < 2 || count > most_points) {
        throw InputError(std::to_string(count) + " evenly spaced points",
                         "give points = 2 ... 100000");
    }
    range.size_ = count;
    if (from.is_rational() && to.is_rational()) {
        const Integer below_from = denominator(from.rational());
        const Integer below_to = denominator(to.rational());
        range.whole_ = Whole{numerator(from.rational()) * below_to,
                             numerator(to.rational()) * below_from, below_from * below_to};
    }
    return range;
}

Real PointRange::between(std::size_t k) const {
    return first_ *
           pow(Real(10), Real(static_cast<unsigned>(k)) / static_cast<unsigned>(per_decade_));
}

Exact PointRange::at(std::size_t k) const {
    if (k == 0 || k + 1 == size_) {
        return k == 0 ? from_ : to_;
    }
    if (per_decade_ > 0) {
        if (k % per_decade_ == 0 && from_.is_rational()) {
            return Exact::of(from_.rational() * power_of_ten(k / per_decade_));
        }
        const PrecisionScope scope(digits_of_ratios);
        return Exact::parse(to_decimal(between(k), point_digits));
    }
    const std::size_t n = size_ - 1;
    if (whole_) { // a single fraction to reduce
        return Exact::of(Rational(Integer(whole_->lower * (n - k) + whole_->upper * k),
                                  Integer(whole_->under * n)));
    }
    return Exact(from_.expr() +
                 (to_.expr() - from_.expr()) *
                     formula::Expr::number(Rational(static_cast<long>(k), static_cast<long>(n))));
}

std::string PointRange::text() const {
    return from_.text() + " " + to_.text() + " " + std::to_string(per_decade_) + " " +
           std::to_string(size_);
}

std::vector<Exact> PointRange::all() const {
    std::vector<Exact> points;
    points.reserve(size_);
    for (std::size_t k = 0; k < size_; ++k) {
        points.push_back(at(k));
    }
    return points;
}

} // namespace edgeproof::scene
