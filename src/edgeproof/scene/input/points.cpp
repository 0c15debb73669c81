// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/scene/input/readers.hpp"

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

void require_ascent(const Exact& from, const Exact& to) {
    require(Exact(to.expr() - from.expr()).sign() > 0,
            "the points from " + from.text() + " to " + to.text() + " do not ascend",
            "give from < to");
}

/// Returns the points in equal ratios, `per_decade` per factor of 10: `from` times a power of 10 if
/// that is rational, else the nearest decimal of 12 significant digits, the same on every machine.
std::vector<Exact> geometric_points(const Exact& from, const Exact& to, std::size_t per_decade) {
    require(from.sign() > 0, "the points begin at " + from.text() + ", which is not positive",
            "give from > 0");
    require_ascent(from, to);
    const PrecisionScope scope(digits_of_ratios);
    const Real first = from.to<Real>();
    const Real last = to.to<Real>();
    const auto decade = static_cast<unsigned>(per_decade);
    require(log10(Real(last / first)) * decade < most_points,
            "more than 100,000 points from " + from.text() + " to " + to.text(),
            "give a smaller per_decade");
    // The last point of the sweep is replaced by `to` if the two nearly coincide.
    const Real end = last * (1 - pow(Real(10), 1 - static_cast<int>(point_digits)));
    std::vector<Exact> points{from};
    for (unsigned k = 1;; ++k) {
        const Real between = first * pow(Real(10), Real(k) / decade);
        if (!(between < end)) {
            break;
        }
        points.push_back(k % decade == 0 && from.is_rational()
                             ? Exact::of(from.rational() * power_of_ten(k / decade))
                             : Exact::parse(to_decimal(between, point_digits)));
    }
    points.push_back(to);
    return points;
}

/// Returns `count` points at equal distances, exact.
std::vector<Exact> even_points(const Exact& from, const Exact& to, std::size_t count) {
    require_ascent(from, to);
    require(count >= 2 && count <= most_points, std::to_string(count) + " evenly spaced points",
            "give points = 2 ... 100000");
    std::vector<Exact> points{from};
    for (std::size_t k = 1; k + 1 < count; ++k) {
        const Rational part(static_cast<long>(k), static_cast<long>(count - 1));
        points.push_back(
            from.is_rational() && to.is_rational()
                ? Exact::of(Rational(from.rational() + (to.rational() - from.rational()) * part))
                : Exact(from.expr() + (to.expr() - from.expr()) * formula::Expr::number(part)));
    }
    points.push_back(to);
    return points;
}

} // namespace

std::vector<Exact> points_of_range(const io::TomlSection& section, std::string_view key, bool even,
                                   const EndOfRange& end) {
    const std::size_t line = section.line(key);
    const io::TomlSection range = section.section(key);
    const std::string name(key);
    range.allow(even ? std::vector<std::string_view>{"from", "to", "points"}
                     : std::vector<std::string_view>{"from", "to", "per_decade", "points"});
    section.require(range.has("per_decade") != range.has("points"), line,
                    "a range of " + name +
                        (even ? " needs points" : " needs one of per_decade and points"),
                    "write " + name +
                        (even ? " = { from = \"-0.5\", to = \"0.5\", points = 11 }"
                              : " = { from = \"1e-3\", to = \"0.5\", points = 20 }"));
    return io::at_place(section.file(), line, [&] {
        const Exact from = end(range, "from");
        const Exact to = end(range, "to");
        return range.has("per_decade")
                   ? geometric_points(from, to, range.count("per_decade", 1, 10'000))
                   : even_points(from, to, range.count("points", 2, 100'000));
    });
}

} // namespace edgeproof::scene
