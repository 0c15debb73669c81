// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/enclosure/tilted_path.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/ball/complex_box.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace edgeproof::audit {

/// The meaning of an integrand's parts on one piece of its interval.
struct IntegrandMeaning {
    /// Returns the value of a part without the variable.
    std::function<Ball(const formula::Expr&)> constant;
    /// Returns that value if it is a rational number, for exponents.
    std::function<std::optional<Rational>(const formula::Expr&)> rational;
    /// A function of the contact, or |g'|, as a formula; throws Error without an enclosure.
    std::function<formula::Expr(const formula::Expr& call)> written_out;
    /// True if e, which does not contain the variable, is zero.
    std::function<bool(const formula::Expr& e)> surely_zero;
    /// For contacts that are given by an angle: `path_argument`, which is linear in the variable,
    /// is their right edge.
    const TiltedPath* path = nullptr;
    std::optional<formula::Expr> path_argument;
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
    Integrand(const formula::Expr& f, std::string variable, IntegrandMeaning meaning, long bits);
    ~Integrand();
    Integrand(Integrand&&) noexcept;

    /// True if the formula reduces to the constant 0.
    [[nodiscard]] bool vanishes() const;
    enum class Centre {
        rooted, ///< n is as large as needed for roots of parts that vanish at the centre
        pole,   ///< n = 1, v of either sign; zeros at the centre are ignored if one is under a root
        regular ///< n = 1; zeros at the centre are ignored
    };
    /// Sets the centre e = `at`, where the variable is `written`, with v towards greater values
    /// (direction 1) or smaller ones (-1). `angle`: the angle of e on the path, if there is one.
    void centre(const formula::Expr& written, const Ball& at, int direction, const Ball& angle,
                Centre kind);
    /// Returns n; it is 1 if nothing is singular.
    [[nodiscard]] long power() const;
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
    class Program;
    std::unique_ptr<Program> program_;
};

} // namespace edgeproof::audit
