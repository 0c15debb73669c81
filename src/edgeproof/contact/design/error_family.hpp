// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/design/jet.hpp"
#include "edgeproof/contact/law/linear_measure.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/formula/expr.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
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

/// f for the parameter in one ball. A value that cannot be enclosed is not finite: the ball is too
/// wide, or a knot is at the place or at an edge. An object belongs to one thread, and refers to
/// its family.
struct ErrorOverBox {
    /// Encloses f at every distance of a ball, zero included (f = 0 at the edge).
    std::function<Ball(const Ball& u)> at;
    /// The same with derivatives, at distances > 0.
    std::function<Jet(const Ball& u)> jet;
    /// The length a + b in the unit of distances: 1 for fractions.
    Ball length;
};

/// The costs of evaluations, in units of about a microsecond on the machine on which they were
/// measured (128 bits, one core). Budgets are counted in these units, so that a result does not
/// depend on the machine.
struct EvaluationCost {
    double over; ///< cost of ErrorFamily::over
    double at;   ///< cost of ErrorOverBox::at
    double jet;
};

struct ErrorFamily {
    EvaluationCost cost;
    /// `parameter`: at the working precision.
    std::function<ErrorOverBox(const Ball& parameter)> over;
};

/// A scene's numbers as formulas in the name of its parameter.
struct ParametricLoad {
    std::optional<Expr> a; ///< or
    std::optional<Expr> P;
    Expr contact_modulus;
};
struct ErrorQuestion {
    Edge edge = Edge::right;
    std::size_t terms = 1;
    ReachUnit unit = ReachUnit::fraction;
    std::string name; ///< of the parameter
};

/// g' piecewise linear: pieces, knots and the half-planes' load as formulas. The origin is one of
/// the knots. The jumps are not set.
struct ParametricSlope : LinearSlope<Expr> {
    bool symmetric = false;
};

/// The pressure of a power law of exponent m. Distances need `half_width`.
[[nodiscard]] std::unique_ptr<ErrorFamily> power_law_errors(const Expr& m,
                                                            const std::optional<Expr>& half_width,
                                                            const ErrorQuestion& question);
/// The shear traction under full stick at constant P, from Q and sigma_0 (contact/law/shear.hpp);
/// a + b is a formula (needed for distances and for a tension).
[[nodiscard]] std::unique_ptr<ErrorFamily> full_stick_errors(const Expr& Q,
                                                             const Expr& bulk_tension,
                                                             const Expr& length,
                                                             const ErrorQuestion& question);
/// The pressure of a piecewise linear profile for which a or P is given.
[[nodiscard]] std::unique_ptr<ErrorFamily> linear_slope_errors(const ParametricSlope& slope,
                                                               const ParametricLoad& load,
                                                               const ErrorQuestion& question);
/// Evaluates formulas in the parameter, over Ball or Jet.
template <class T> class ParameterValues {
public:
    using Number = T;
    ParameterValues(std::string_view name, const Ball& value) : name_(name), bits_(value.bits()) {
        if constexpr (std::is_same_v<T, Ball>) {
            value_ = value;
        } else {
            value_ = Jet::variable(value, 1);
        }
    }
    [[nodiscard]] T number(const Rational& q) const { return T(Ball(q, bits_)); }
    [[nodiscard]] T pi() const { return T(Ball::pi(bits_)); }
    [[nodiscard]] T symbol(std::string_view name) const {
        if (name != name_) {
            throw Error("'" + std::string(name) + "' is not the parameter");
        }
        return value_;
    }
    [[nodiscard]] T operator()(const Expr& e) const { return formula::evaluate<T>(e, *this); }
    [[nodiscard]] std::optional<T> operator()(const std::optional<Expr>& e) const {
        return e ? std::optional<T>((*this)(*e)) : std::nullopt;
    }
    [[nodiscard]] long bits() const { return bits_; }

private:
    std::string_view name_;
    long bits_;
    T value_;
};

/// The family of an error in closed form. `form(values)` makes, for values of either type T, an
/// object with `error(u)` and with `whole()`, the length in the unit of distances.
template <class Form>
[[nodiscard]] std::unique_ptr<ErrorFamily>
closed_form_errors(const ErrorQuestion& question, const EvaluationCost& cost, const Form& form) {
    return std::make_unique<ErrorFamily>(
        ErrorFamily{cost, [name = question.name, form](const Ball& at) {
                        auto balls = form(ParameterValues<Ball>(name, at));
                        Ball whole = balls.whole();
                        return ErrorOverBox{
                            [balls = std::move(balls)](const Ball& u) { return balls.error(u); },
                            [jets = form(ParameterValues<Jet>(name, at))](const Ball& u) {
                                return jets.error(Jet::variable(u, 0));
                            },
                            std::move(whole)};
                    }});
}

} // namespace edgeproof::contact
