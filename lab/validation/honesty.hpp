// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::validation {

/// A pressure that several routes compute, with the integral that a user would write:
///     p = (1/pi) integral from max(x, t) to a of P'(s)/sqrt((s - x)(x + gamma s)) ds,  x = a - u,
/// P'(s) = K s^m, or K s acos(t/s) for the flat-and-rounded punch (eqn:ContactPressure_NonSym with
/// b(s) = gamma s).
struct HonestyPoint {
    std::string id;
    std::string profile;
    std::string regime;
    scene::Scene scene;
    formula::Exact u;
    /// The parameters of the integral; empty for a profile whose b(s) has no closed form.
    struct Integral {
        bool flat = false;
        formula::Exact a;
        formula::Exact K;
        formula::Exact m;
        formula::Exact t;
        formula::Exact gamma;
    };
    std::optional<Integral> integral;
};
[[nodiscard]] std::vector<HonestyPoint> honesty_points();

/// The value of a route, and the absolute error that it claims.
struct Claimed {
    Real value;
    Real error;
};
using ClaimedValues = std::map<std::string, Claimed>;

/// Returns the integrals as lines for another program: id, digits, kind (power or flat), a, u, K,
/// m, t, gamma, separated by spaces; decimals of up to 80 digits.
[[nodiscard]] std::string integral_questions(const std::vector<HonestyPoint>& points,
                                             unsigned digits);
/// Reads the answers: lines of id, value, claimed absolute error. Other lines are ignored.
[[nodiscard]] ClaimedValues integral_answers(std::string_view text);

/// The results of one route for the points of a profile and regime.
struct HonestyRow {
    std::string route;
    std::string profile;
    std::string regime;
    std::size_t points = 0;
    std::size_t none = 0;        ///< values missing or not finite
    std::size_t understated = 0; ///< errors larger than claimed
    double worst_ratio = 0;      ///< log10 of the largest ratio of true to claimed error
    unsigned least_right = 0;    ///< correct digits of the worst value
    unsigned least_claimed = 0;  ///< claimed digits of that value
};

struct HonestyOptions {
    unsigned digits = 50;
    std::function<void(std::size_t, std::size_t)> progress = {};
};

/// Compares claimed with true errors: of the library's Barber-Mossakovskii and singular integral,
/// of a simple use of Boost.Math's tanh-sinh (plain_tanh_sinh.hpp) in double and in MPFR of that
/// many digits, and of `others` (by name). The true error is the difference from a ball enclosure
/// of at least twice the digits; an error is understated if even the nearest number of the ball is
/// further away than claimed. Throws Interrupted.
[[nodiscard]] std::vector<HonestyRow>
honesty(const std::vector<HonestyPoint>& points,
        const std::vector<std::pair<std::string, ClaimedValues>>& others,
        const HonestyOptions& options);

} // namespace edgeproof::validation
