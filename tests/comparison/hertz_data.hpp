// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/comparison/comparison.hpp"
#include "edgeproof/scene/input/scene_words.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iterator>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

/// Data with a known error, from the textbook's formula in double: g' = x/R with R = 2, E* = 3, a =
/// 1.5 has p = E*/(2R) sqrt(a^2 - x^2) (K. L. Johnson, Contact Mechanics, eq. 4.45 with p_0 = E*
/// a/(2R)).
namespace edgeproof::hertz_data {

inline constexpr double a = 1.5;
inline constexpr double p0 = 3 * a / (2 * 2);
inline constexpr double P = std::numbers::pi * a * p0 / 2;

/// The scene of words such as "kind=hertz R=2 a=1.5".
inline scene::Scene scene_of_words(const std::string& text) {
    std::istringstream in(text);
    const std::vector<std::string> words(std::istream_iterator<std::string>(in), {});
    return scene::make_scene(scene::given_scene(words).instead);
}
inline scene::Scene hertz() { return scene_of_words("kind=hertz R=2 a=1.5 contact_modulus=3"); }

inline const comparison::ExactContact& exact() {
    static const comparison::ExactContact contact(hertz());
    return contact;
}

inline double p(double x) { return std::abs(x) < a ? p0 * std::sqrt(1 - x * x / (a * a)) : 0; }

/// Returns the mean of p over (x - h/2, x + h/2), the result of a mesh that smears the edge.
inline double smeared(double x, double h) {
    const auto integral = [](double s) {
        const double t = std::clamp(s / a, -1.0, 1.0);
        return 0.5 * p0 * a * (t * std::sqrt(1 - t * t) + std::asin(t));
    };
    return (integral(x + h / 2) - integral(x - h / 2)) / h;
}

inline std::vector<double> even_places(double from, double to, int n) {
    std::vector<double> places;
    for (int i = 0; i <= n; ++i) {
        places.push_back(from + (to - from) * i / n);
    }
    return places;
}

inline std::string number(double x) {
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", x);
    return text;
}

/// Returns "x,p" and a row for each place.
inline std::string table(const std::vector<double>& places,
                         const std::function<double(double)>& pressure,
                         const std::function<double(double)>& written_x = {}) {
    std::string text = "x,p\n";
    for (const double x : places) {
        text += number(written_x ? written_x(x) : x) + "," + number(pressure(x)) + "\n";
    }
    return text;
}

/// Places of a mesh whose elements are 1/16 wide.
inline const std::vector<double> mesh = even_places(-2, 2, 64);

inline comparison::Tolerances within(double tolerance) {
    comparison::Tolerances t;
    t.pressure = tolerance;
    return t;
}

/// A scene whose data are diagnosed; its origin is that of the data.
struct Diagnosed {
    comparison::ExactContact exact;
    comparison::SuspectContacts suspects;

    explicit Diagnosed(const scene::Scene& scene) : exact(scene), suspects(scene) {}
    comparison::FileComparison of(const std::string& text,
                                  const comparison::Tolerances& tolerances = {}) {
        return comparison::compare_file(comparison::parse_result(text, "r"), exact, tolerances,
                                        Rational(0), &suspects);
    }
};
inline bool is_named(const std::optional<comparison::Diagnosis>& diagnosis,
                     const std::string& name) {
    return diagnosis && std::ranges::find(diagnosis->causes, name, &comparison::Cause::name) !=
                            diagnosis->causes.end();
}

inline comparison::FileComparison compared(const std::string& text,
                                           const comparison::Tolerances& tolerances = {},
                                           const comparison::ResultReading& reading = {}) {
    return comparison::compare_file(comparison::parse_result(text, "result.csv", reading), exact(),
                                    tolerances, {});
}

inline bool has_finding(const comparison::FileComparison& file, const std::string& part) {
    for (const std::string& finding : file.findings()) {
        if (finding.find(part) != std::string::npos) {
            return true;
        }
    }
    return false;
}

} // namespace edgeproof::hertz_data
