// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/curved/curved_slope.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/law/linear_measure.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/ball/ball_series.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

/// The relative error f = p_n/p - 1 of n terms at an edge as a function of the distance from it and
/// of a parameter of the scene, enclosed for every value in a ball.
namespace edgeproof::contact {

/// The unit of distances.
enum class ReachUnit {
    fraction, ///< u/(a + b)
    distance  ///< u
};

/// f with its derivatives by u and by the parameter, in this order, each a ball that encloses it
/// for every choice of the arguments from their balls, as interval Newton and the mean value form
/// need them (moore-kearfott-cloud2009).
struct Jet {
    Ball v;
    std::array<Ball, 2> g;
    std::array<Ball, 3> h; ///< by u twice, by both, by the parameter twice
};

/// The arguments that grow with t.
enum class Along { u, parameter, both };
/// The number of terms of a series in t.
inline constexpr std::size_t jet_terms = 3;

/// f for the parameter in one ball. A value that cannot be enclosed is not finite: the ball is too
/// wide, or a knot is at the place or at an edge. An object belongs to one thread, and refers to
/// its family.
struct ErrorOverBox {
    /// Encloses f at every distance of a ball, zero included (f = 0 at the edge).
    std::function<Ball(const Ball& u)> at;
    /// The same as a series in t, at distances > 0.
    std::function<BallSeries(const Ball& u, Along way)> along;
    /// The length a + b in the unit of distances: 1 for fractions.
    Ball length;

    [[nodiscard]] Jet jet(const Ball& u) const {
        const BallSeries by_u = along(u, Along::u);
        const BallSeries by_parameter = along(u, Along::parameter);
        const Ball mixed = along(u, Along::both)[2] - by_u[2] - by_parameter[2];
        return {by_u[0], {by_u[1], by_parameter[1]}, {by_u[2] * 2, mixed, by_parameter[2] * 2}};
    }
};

/// The costs of evaluations, in units of about a microsecond on the machine on which they were
/// measured (128 bits, one core). Budgets are counted in these units, so that a result does not
/// depend on the machine.
struct EvaluationCost {
    double over; ///< cost of ErrorFamily::over
    double at;   ///< cost of ErrorOverBox::at
    double along;
};

struct ErrorFamily {
    EvaluationCost cost;
    /// `parameter`: at the working precision.
    std::function<ErrorOverBox(const Ball& parameter)> over;
};

/// A scene's numbers as formulas in the name of its parameter, their only name.
struct ParametricLoad {
    std::optional<Expr> a; ///< or
    std::optional<Expr> P;
    Expr contact_modulus;
};
struct ErrorQuestion {
    Edge edge = Edge::right;
    std::size_t terms = 1;
    ReachUnit unit = ReachUnit::fraction;
};

/// g' piecewise linear: pieces, knots and the half-planes' load as formulas. The origin is one of
/// the knots. The jumps are not set.
struct ParametricSlope : LinearSlope<Expr> {
    bool symmetric = false;
};

/// The pressure of a power law of exponent m. Distances need `half_width`.
[[nodiscard]] ErrorFamily power_law_errors(const Expr& m, const std::optional<Expr>& half_width,
                                           const ErrorQuestion& question);
/// The shear traction under full stick at constant P, from Q and sigma_0 (contact/law/shear.hpp);
/// a + b is a formula (needed for distances and for a tension).
[[nodiscard]] ErrorFamily full_stick_errors(const Expr& Q, const Expr& bulk_tension,
                                            const Expr& length, const ErrorQuestion& question);
/// The pressure of a piecewise linear profile for which a or P is given.
[[nodiscard]] ErrorFamily linear_slope_errors(const ParametricSlope& slope,
                                              const ParametricLoad& load,
                                              const ErrorQuestion& question);

/// 1/F for the pressure of a power law, which is proportional to sqrt(z (1 - z)) F with z = u/(2a),
/// F = 2F1(1, b; 3/2; y), y = 4 z (1 - z) and b = (1 - m)/2. From Euler's integral (DLMF 15.6.1),
///   F = 1/2 int_0^1 (1 - t)^(-1/2) (1 - y t)^(-b) dt,
/// follows that F and all of its derivatives by b grow with b, and that F grows with y where b > 0
/// and falls where b < 0. Values at the ends of z and b therefore enclose all between, the middle
/// of the contact (y = 1) included, where F has no derivative by z if m < 1.
[[nodiscard]] Ball reciprocal_edge_function(const Ball& z, const Ball& b);
/// The same for series of three terms. At the middle it is finite only if z is a constant.
[[nodiscard]] BallSeries reciprocal_edge_function(const BallSeries& z, const BallSeries& b);

/// Evaluates formulas in the parameter, as balls or as series in its change t.
template <class T> struct ParameterValues {
    using Number = T;
    Ball at;
    bool moves = false; ///< of series: the parameter is at + t

    [[nodiscard]] T operator()(const Expr& e) const {
        const std::vector<Ball> c = slope_series(e, at, moves ? jet_terms : 1, at.bits());
        if constexpr (std::is_same_v<T, Ball>) {
            return c[0];
        } else {
            BallSeries series(c[0], jet_terms);
            for (std::size_t k = 1; k < c.size(); ++k) {
                series.set(k, c[k]);
            }
            return series;
        }
    }
    [[nodiscard]] std::optional<T> operator()(const std::optional<Expr>& e) const {
        return e ? std::optional<T>((*this)(*e)) : std::nullopt;
    }
};

/// The constant of a number or of a series.
[[nodiscard]] inline const Ball& value_in(const Ball& x) { return x; }
[[nodiscard]] inline Ball value_in(const BallSeries& x) { return x[0]; }

/// f in closed form over a ball of the parameter. `form(values)` makes, for values of either type,
/// an object with `error(u)`; `whole` is the length in the unit of distances.
template <class Form>
[[nodiscard]] ErrorOverBox closed_form_error(const Ball& parameter, const Form& form,
                                             const Ball& whole) {
    using Series = decltype(form(ParameterValues<BallSeries>{}));
    return {
        [balls = form(ParameterValues<Ball>{parameter})](const Ball& u) { return balls.error(u); },
        [form, parameter, made = std::array<std::optional<Series>, 2>()](const Ball& u,
                                                                         Along way) mutable {
            auto& series = made.at(way == Along::u ? 0 : 1); // made on first use
            if (!series) {
                series = form(ParameterValues<BallSeries>{parameter, way != Along::u});
            }
            return series->error(way == Along::parameter ? BallSeries(u, jet_terms)
                                                         : BallSeries::variable(u, jet_terms));
        },
        whole};
}

} // namespace edgeproof::contact
