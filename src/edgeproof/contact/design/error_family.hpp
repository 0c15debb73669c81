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

/// The unit of distances.
enum class ReachUnit {
    fraction, ///< u/(a + b)
    distance  ///< u
};

/// f for the parameters of one box. A value that cannot be enclosed is not finite: the box is too
/// wide, or a knot is at the place or at an edge.
class ErrorOverBox {
public:
    virtual ~ErrorOverBox() = default;
    ErrorOverBox(const ErrorOverBox&) = delete;
    ErrorOverBox& operator=(const ErrorOverBox&) = delete;
    /// Encloses f at every distance of a ball, zero included (f = 0 at the edge).
    [[nodiscard]] virtual Ball at(const Ball& u) const = 0;
    /// The same with derivatives, at distances > 0.
    [[nodiscard]] virtual Jet jet(const Ball& u) const = 0;
    /// The length a + b in the unit of distances: 1 for fractions.
    [[nodiscard]] virtual Ball length() const = 0;

protected:
    ErrorOverBox() = default;
};

/// f by a closed form over any field: Form<T> has `error(u)`, and the `length` that limits u;
/// u is a fraction of it if `fraction`.
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

/// The costs of evaluations, in units of about a microsecond on the machine on which they were
/// measured (128 bits, one core). Budgets are counted in these units, so that a result does not
/// depend on the machine.
struct EvaluationCost {
    double over; ///< cost of ErrorFamily::over
    double at;   ///< cost of ErrorOverBox::at
    double jet;
};

class ErrorFamily {
public:
    virtual ~ErrorFamily() = default;
    ErrorFamily(const ErrorFamily&) = delete;
    ErrorFamily& operator=(const ErrorFamily&) = delete;
    /// `parameters`: one ball for each parameter, at the working precision.
    [[nodiscard]] virtual std::unique_ptr<ErrorOverBox>
    over(const std::vector<Ball>& parameters) const = 0;
    [[nodiscard]] virtual EvaluationCost cost() const = 0;

protected:
    ErrorFamily() = default;
};

/// True if an evaluation takes so long that fewer samples are taken.
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
    std::vector<std::string> names; ///< the names of the parameters, one or two
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

/// The pressure of a power law of exponent m. Distances need `half_width`.
[[nodiscard]] std::unique_ptr<ErrorFamily>
power_law_errors(const formula::Expr& m, const std::optional<formula::Expr>& half_width,
                 const ErrorQuestion& question);
/// The shear traction under full stick at constant P, from Q and sigma_0 (contact/law/shear.hpp);
/// a + b is a formula (needed for distances and for a tension).
[[nodiscard]] std::unique_ptr<ErrorFamily> full_stick_errors(const formula::Expr& Q,
                                                             const formula::Expr& bulk_tension,
                                                             const formula::Expr& length,
                                                             const ErrorQuestion& question);
/// The pressure of a piecewise linear profile for which a or P is given.
[[nodiscard]] std::unique_ptr<ErrorFamily> linear_slope_errors(const ParametricSlope& slope,
                                                               const ParametricLoad& load,
                                                               const ErrorQuestion& question);
/// d_n/d - 1 of a slip zone as a function of the load ratio |Q|/(f P), which takes the
/// place of the distance; its range is 1 (docs/partial-slip.md). For a power law without a tension.
[[nodiscard]] std::unique_ptr<ErrorFamily> power_law_slip_errors(const formula::Expr& m,
                                                                 const ErrorQuestion& question);
/// The same for a piecewise linear profile; `tension`: sigma_0/Q. Values are not finite if sigma_0
/// cannot grow in proportion to Q, or if the stick zone does not contain the origin.
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
