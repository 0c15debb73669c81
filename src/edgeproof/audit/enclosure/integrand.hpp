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

/// What an integrand's parts mean on one piece of its interval.
struct IntegrandMeaning {
    /// Of a part without the variable.
    std::function<Ball(const formula::Expr&)> constant;
    /// The same, if it is a rational number: exponents.
    std::function<std::optional<Rational>(const formula::Expr&)> rational;
    /// A function of the contact, or |g'|, written out; throws Error for what has no enclosure.
    std::function<formula::Expr(const formula::Expr& call)> written_out;
    /// That e, in which the variable does not stand, is zero.
    std::function<bool(const formula::Expr& e)> surely_zero;
    /// Where contacts are known by an angle: `path_argument`, which is linear in the variable, is
    /// their right edge.
    const TiltedPath* path = nullptr;
    std::optional<formula::Expr> path_argument;
};

/// A formula in one variable on boxes of the complex plane, counted from a point e, its centre, by
/// v with variable = e +- v^n: parts that are proved to vanish at e are v^n times their divided
/// difference, roots of these are powers of v times what is regular, and so a root that is singular
/// at e is no singularity in v. A part's divided difference follows by the rules of differentiation
/// in their finite form, and of b(s) by its derivative over the segment from e, as that is convex.
///
/// Beside the functions of formulas it knows log_above(z), the logarithm continued from the upper
/// half-plane (that of z > 0 is real), and gauss(a, b, c, z), Gauss's 2F1.
class Integrand {
public:
    Integrand(const formula::Expr& f, std::string variable, IntegrandMeaning meaning, long bits);
    ~Integrand();
    Integrand(Integrand&&) noexcept;

    /// It is 0 as it stands.
    [[nodiscard]] bool vanishes() const;
    enum class Centre {
        rooted, ///< n as large as roots of what vanishes there need it
        pole,   ///< n = 1, v of either sign: nothing is told apart if there are such roots
        regular ///< n = 1, nothing is told apart
    };
    /// Counts from e = `at`, where the variable is `written`, towards greater values (direction 1)
    /// or smaller ones (-1). `angle`: of e on the path, if there is one.
    void centre(const formula::Expr& written, const Ball& at, int direction, const Ball& angle,
                Centre kind);
    /// n: 1 where nothing is singular.
    [[nodiscard]] long power() const;
    /// f d(variable)/dv, without the sign of the direction. `analytic`: not finite where it may not
    /// be holomorphic on the whole box.
    void at(acb_ptr out, const Box& v, bool analytic);
    /// The factor of the lowest power of v in f, and that power (v^n = +-(variable - e)).
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
