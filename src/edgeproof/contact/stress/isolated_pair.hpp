// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <array>
#include <cstddef>
#include <optional>

namespace edgeproof::contact {

using BallPair = std::array<Ball, 2>;

/// Two functions of two unknowns over a box, with their derivatives, those of the first one first.
struct PairOfEquations {
    BallPair f;
    std::array<BallPair, 2> rates;

    /// Replaces an equation by one that keeps its unknown.
    void fix(std::size_t i) {
        const long bits = f[i].bits();
        f[i] = Ball(0, bits);
        rates[i] = {Ball(i == 0 ? 1 : 0, bits), Ball(i == 1 ? 1 : 0, bits)};
    }
};

/// Encloses the only zero near a start, to its bits, by Newton's method on midpoints and then, with
/// proof, by Krawczyk's operator: where m - Y f(m) + (1 - Y J(X)) (X - m) lies in the inner
/// part of X, there is one zero in X, and no other (`moore-kearfott-cloud2009`). Nothing if the
/// zero is not isolated.
/// @param equations PairOfEquations over a pair of balls
/// @param start near the zero
/// @param free false for an unknown that keeps its value
template <class Equations>
[[nodiscard]] std::optional<BallPair>
isolated_pair(const Equations& equations, const BallPair& start,
              const std::array<bool, 2>& free = {true, true}) {
    constexpr int most_steps = 40;
    constexpr int most_widths = 14;
    const long bits = start[0].bits();
    const auto at = [&](const BallPair& x) {
        check_interruption();
        PairOfEquations e = equations(x);
        for (std::size_t i = 0; i < free.size(); ++i) {
            if (!free[i]) {
                e.fix(i);
            }
        }
        return e;
    };
    const auto size = [](const BallPair& x) { return middle(max(abs(x[0]), abs(x[1]))); };
    const auto times = [](const std::array<BallPair, 2>& m, const BallPair& x) {
        return BallPair{m[0][0] * x[0] + m[0][1] * x[1], m[1][0] * x[0] + m[1][1] * x[1]};
    };
    BallPair x{middle(start[0]), middle(start[1])};
    PairOfEquations here = at(x);
    Ball last(1, bits);
    std::array<BallPair, 2> Y;
    for (int k = 0; k < most_steps; ++k) {
        const auto& J = here.rates;
        const Ball det = J[0][0] * J[1][1] - J[0][1] * J[1][0];
        Y = {{{middle(J[1][1] / det), middle(-(J[0][1] / det))},
              {middle(-(J[1][0] / det)), middle(J[0][0] / det)}}};
        const BallPair step = times(Y, here.f);
        if (!step[0].is_finite() || !step[1].is_finite()) {
            return {};
        }
        x = {middle(x[0] - step[0]), middle(x[1] - step[1])};
        here = at(x);
        const Ball now = size(step);
        const bool near = certainly_less(now, size(x) * power_of_two(-(bits / 4), bits));
        const bool stalls = (near || k > 6) && !certainly_less(now * 2, last);
        last = now;
        if (stalls) {
            break;
        }
    }
    const BallPair off = times(Y, here.f);
    Ball radius = last * 4 + size(x) * power_of_two(8 - bits, bits);
    for (int k = 0; k < most_widths; ++k, radius = middle(radius * 64)) {
        const Ball h = up_to(radius);
        const Ball none(0, bits);
        const BallPair around{free[0] ? h : none, free[1] ? h : none};
        const BallPair X{x[0] + around[0], x[1] + around[1]};
        const PairOfEquations over = at(X);
        BallPair image;
        for (std::size_t i = 0; i < image.size(); ++i) {
            image[i] = x[i] - off[i];
            for (std::size_t j = 0; j < image.size(); ++j) {
                const Ball product = Y[i][0] * over.rates[0][j] + Y[i][1] * over.rates[1][j];
                image[i] += ((i == j ? 1 : 0) - product) * around[j];
            }
        }
        const auto inside = [&](std::size_t i) {
            return !free[i] || certainly_less(abs(image[i] - x[i]), radius);
        };
        if (image[0].is_finite() && image[1].is_finite() && inside(0) && inside(1)) {
            return image;
        }
    }
    return {};
}

} // namespace edgeproof::contact
