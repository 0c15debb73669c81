// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/enclosure/tilted_path.hpp"
#include "edgeproof/formula/evaluation/program.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/ball/complex_box.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::audit {

using formula::Expr;

/// The meaning of an integrand's parts on one piece of its interval.
struct IntegrandMeaning {
    /// Returns the value of a part without the variable.
    std::function<Ball(const Expr&)> constant;
    /// Returns that value if it is a rational number, for exponents.
    std::function<std::optional<Rational>(const Expr&)> rational;
    /// A function of the contact, or |g'|, as a formula; throws Error without an enclosure.
    std::function<Expr(const Expr& call)> written_out;
    /// True if e, which does not contain the variable, is zero.
    std::function<bool(const Expr& e)> surely_zero;
    /// For contacts that are given by an angle: `path_argument`, which is linear in the variable,
    /// is their right edge.
    const TiltedPath* path = nullptr;
    std::optional<Expr> path_argument;
};

/// A formula in one variable on boxes of the complex plane. The variable is e +- v^n with a centre
/// e and the new variable v. A part that is proved to vanish at e is v^n times its divided
/// difference, and a root of it is a power of v times a regular function: so a root that is
/// singular at e has no singularity in v. The divided difference of a part follows from the finite
/// form of the rules of differentiation; that of b(s) from its derivative over the segment from e,
/// as b is convex.
///
/// In addition to the functions of formulas, it has log_above(z), the logarithm continued from the
/// upper half-plane (real for z > 0), and gauss(a, b, c, z), Gauss's 2F1.
class Integrand {
public:
    /// Throws Error for a part without an enclosure.
    Integrand(const Expr& f, std::string variable, IntegrandMeaning meaning, long bits);

    /// True if the formula reduces to the constant 0.
    [[nodiscard]] bool vanishes() const;
    enum class Centre {
        rooted, ///< n is as large as needed for roots of parts that vanish at the centre
        pole,   ///< n = 1, v of either sign; zeros at the centre are ignored if one is under a root
        regular ///< n = 1; zeros at the centre are ignored
    };
    /// Sets the centre e = `at`, where the variable is `written`, with v towards greater values
    /// (direction 1) or smaller ones (-1). `angle`: the angle of e on the path, if there is one.
    void centre(const Expr& written, const Ball& at, int direction, const Ball& angle, Centre kind);
    /// Returns n; it is 1 if nothing is singular.
    [[nodiscard]] long power() const { return power_; }
    /// Returns f d(variable)/dv, without the sign of the direction. `analytic`: the result is not
    /// finite if the function may not be holomorphic on the whole box.
    void at(acb_ptr out, const Box& v, bool analytic);
    /// The lowest power of v in f and its factor (v^n = +-(variable - e)).
    struct Leading {
        long power;
        Box factor;
    };
    [[nodiscard]] Leading leading(const Box& v);

private:
    /// A value v^k w. If needed, for k = 0, w is also given as end + v^n slope.
    struct ValuedBox {
        explicit ValuedBox(long bits) : w(bits), end(bits), slope(bits) {}
        long k = 0;
        Box w;
        Box end;
        Box slope;
    };
    using Step = formula::Program::Part;

    /// The inputs of the program: the variable, and with a path b and P' at its argument.
    enum Input { of_variable, of_edge, of_force_rate };
    [[nodiscard]] static std::vector<Expr> inputs(const std::string& variable,
                                                  const IntegrandMeaning& meaning);
    /// Checks that a part has an enclosure, and replaces functions of the contact by formulas.
    [[nodiscard]] std::optional<Expr> written_out(const Expr& part) const;
    [[nodiscard]] const ValuedBox& part(const Step& step, std::size_t k) const {
        return valued_[step.operands[k]];
    }
    void run(const Box& v, bool analytic);
    void multiply_by_power(Box& y, long k) const;
    /// Returns v^k w.
    [[nodiscard]] Box plain(const ValuedBox& x) const {
        Box y = x.w;
        multiply_by_power(y, x.k);
        return y;
    }
    /// Computes the inputs, at one of the points of the variable or of the path.
    void place(const Box& at);
    /// Computes the slope from the values at the point and at the centre, and from the derivative
    /// between them. The former is narrow if the box is narrow, the latter near the centre.
    void find_slope(ValuedBox& x, const Box& derivative) const;
    /// Finds the slots that are proved to be zero at v = 0.
    void find_zeros();
    /// Finds the least n for which all powers of v are integers.
    void choose_power(Centre kind);
    /// Marks the parts that are needed for the divided differences of zeros.
    void mark_slopes();

    /// Computes an operation of the program.
    void take(std::size_t slot);
    void take_sum(const Step& step, std::size_t slot);
    void take_product(const Step& step, std::size_t slot);
    void take_quotient(const Step& step, std::size_t slot);
    void take_power(const Step& step, std::size_t slot);
    void take_root(const Step& step, std::size_t slot);
    void take_function(const Step& step, std::size_t slot);
    /// Applies the proof that a slot is zero at v = 0.
    void apply_zero(std::size_t slot);

    std::string variable_;
    IntegrandMeaning meaning_;
    long bits_;
    formula::Program program_;
    std::vector<std::optional<Rational>> exponents_; ///< of powers, if they are rational
    std::vector<ValuedBox> valued_;                  ///< by places in the program
    std::vector<bool> zero_;                         ///< proved to vanish at the centre
    std::vector<bool> sloped_;                       ///< the divided difference is needed
    bool wants_slopes_ = false;
    Expr written_;
    Box start_;
    int direction_ = 1; ///< of the angle, if there is a path
    long power_ = 1;
    Ball offset_;
    Ball rate_;
    Box v_{bits_};
    Box vn_{bits_};
    bool analytic_ = false;
    Box by_angle_{bits_};
};

/// Returns the integral of f, in the variable of its centre, along the straight line from v to w.
/// For boxes v and w, the result contains the integral between any two of their points.
[[nodiscard]] Box line_integral(Integrand& f, const Box& v, const Box& w, unsigned digits);

} // namespace edgeproof::audit
