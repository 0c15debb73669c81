// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/design/jet.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/formula/expr.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// The relative error f = p_n/p - 1 of n terms at an edge as a function of the distance from it and
/// of parameters of the scene, enclosed for every parameter of a ball.
namespace edgeproof::contact {

/// What distances are measured in.
enum class ReachUnit {
    fraction, ///< u/(a + b)
    distance  ///< u
};

/// f for the parameters of one box. Values are not finite where nothing is known: the box too wide,
/// a knot at the place or at an edge.
class ErrorOverBox {
public:
    virtual ~ErrorOverBox() = default;
    ErrorOverBox(const ErrorOverBox&) = delete;
    ErrorOverBox& operator=(const ErrorOverBox&) = delete;
    /// At every distance of a ball, zero included (f = 0 at the edge).
    [[nodiscard]] virtual Ball at(const Ball& u) const = 0;
    /// With derivatives, at distances > 0.
    [[nodiscard]] virtual Jet jet(const Ball& u) const = 0;
    /// a + b, in the unit: 1 for fractions.
    [[nodiscard]] virtual Ball length() const = 0;

protected:
    ErrorOverBox() = default;
};

/// f by a closed form over any field: Form<T> has `error(u)`, and the `length` to which u is held,
/// in fractions of it if `fraction`.
template <template <class> class Form> class ClosedFormOverBox : public ErrorOverBox {
public:
    ClosedFormOverBox(Form<Ball> balls, Form<Jet> jets)
        : balls_(std::move(balls)), jets_(std::move(jets)) {}
    [[nodiscard]] Ball at(const Ball& u) const override { return balls_.error(u); }
    [[nodiscard]] Jet jet(const Ball& u) const override { return jets_.error(Jet::variable(u, 0)); }
    [[nodiscard]] Ball length() const override {
        return balls_.fraction ? Ball(1, balls_.length.bits()) : balls_.length;
    }

private:
    Form<Ball> balls_;
    Form<Jet> jets_;
};

/// What evaluations cost, in units that are about a microsecond of the machine that they were
/// measured on (128 bits, one core). Budgets are counted in them, so that a result does not depend
/// on the machine.
struct EvaluationCost {
    double over; ///< of ErrorFamily::over
    double at;   ///< of ErrorOverBox::at
    double jet;
};

class ErrorFamily {
public:
    virtual ~ErrorFamily() = default;
    ErrorFamily(const ErrorFamily&) = delete;
    ErrorFamily& operator=(const ErrorFamily&) = delete;
    /// One ball a parameter, at the working precision.
    [[nodiscard]] virtual std::unique_ptr<ErrorOverBox>
    over(const std::vector<Ball>& parameters) const = 0;
    [[nodiscard]] virtual EvaluationCost cost() const = 0;

protected:
    ErrorFamily() = default;
};

/// Samples are fewer where an evaluation takes long.
[[nodiscard]] inline bool is_costly(const ErrorFamily& f) { return f.cost().at > 60; }

/// A scene's numbers as formulas in the names of its parameters.
struct ParametricLoad {
    std::optional<formula::Expr> a; ///< or
    std::optional<formula::Expr> P;
    formula::Expr contact_modulus;
};
struct ErrorQuestion {
    Edge edge = Edge::right;
    std::size_t terms = 1;
    ReachUnit unit = ReachUnit::fraction;
    std::vector<std::string> names; ///< of the parameters, one or two
};

/// g' piecewise linear: pieces, knots and the half-planes' load as formulas. The origin is one of
/// the knots.
struct ParametricSlope {
    struct Piece {
        formula::Expr at_origin;
        formula::Expr rate;
    };
    std::vector<formula::Expr> knots;
    std::vector<Piece> pieces;
    std::vector<bool> corner; ///< whether g' may jump at a knot
    std::size_t origin = 0;
    bool symmetric = false;
};

/// Pressure of a power law of exponent m. `half_width` is needed where distances are.
[[nodiscard]] std::unique_ptr<ErrorFamily>
power_law_errors(const formula::Expr& m, const std::optional<formula::Expr>& half_width,
                 const ErrorQuestion& question);
/// Shear traction under full stick, P held: by Q and sigma_0 (contact/law/shear.hpp), and a + b as
/// a formula (with distances, or a tension).
[[nodiscard]] std::unique_ptr<ErrorFamily> full_stick_errors(const formula::Expr& Q,
                                                             const formula::Expr& bulk_tension,
                                                             const formula::Expr& length,
                                                             const ErrorQuestion& question);
/// Pressure of a piecewise linear profile; a or P is given.
[[nodiscard]] std::unique_ptr<ErrorFamily> linear_slope_errors(const ParametricSlope& slope,
                                                               const ParametricLoad& load,
                                                               const ErrorQuestion& question);
/// d_n/d - 1 of a slip zone as a function of the load ratio |Q|/(f P), which stands for the
/// distance; its range is 1 (docs/partial-slip.md). Of a power law without a tension.
[[nodiscard]] std::unique_ptr<ErrorFamily> power_law_slip_errors(const formula::Expr& m,
                                                                 const ErrorQuestion& question);
/// Of a piecewise linear profile; `tension`: sigma_0/Q. Nothing is known where sigma_0 cannot grow
/// in proportion to Q, and where the stick zone leaves the origin.
[[nodiscard]] std::unique_ptr<ErrorFamily>
linear_slip_errors(const ParametricSlope& slope, const ParametricLoad& load,
                   const std::optional<formula::Expr>& tension, const ErrorQuestion& question);

/// Evaluates formulas in the parameters, over Ball or Jet.
template <class T> class ParameterValues {
public:
    ParameterValues(const std::vector<std::string>& names, const std::vector<Ball>& values)
        : names_(names), bits_(values.front().bits()) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            if constexpr (std::is_same_v<T, Ball>) {
                values_.push_back(values[i]);
            } else {
                values_.push_back(Jet::variable(values[i], i + 1));
            }
        }
    }
    [[nodiscard]] T number(const Rational& q) const { return T(Ball(q, bits_)); }
    [[nodiscard]] T pi() const { return T(Ball::pi(bits_)); }
    [[nodiscard]] T symbol(std::string_view name) const {
        for (std::size_t i = 0; i < names_.size(); ++i) {
            if (names_[i] == name) {
                return values_[i];
            }
        }
        throw Error("'" + std::string(name) + "' is no parameter");
    }
    [[nodiscard]] T operator()(const formula::Expr& e) const {
        return formula::evaluate<T>(e, *this);
    }
    [[nodiscard]] long bits() const { return bits_; }

private:
    const std::vector<std::string>& names_;
    long bits_;
    std::vector<T> values_;
};

} // namespace edgeproof::contact
