// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/audit/enclosure/tilted_path.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/ball/complex_box.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <unordered_map>
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
/// singular at e has no singularity in v. The logarithm of such a part, k log v + log w, is v^-1
/// times a function that tends to 0, for an n so large that the integrand does, too. The divided
/// difference of a part follows from the finite form of the rules of differentiation; that of b(s)
/// from its derivative over the segment from e, as b is convex.
///
/// In addition to the functions of formulas, it has log_above(z), the logarithm continued from the
/// upper half-plane (real for z > 0), and gauss(a, b, c, z), Gauss's 2F1.
class Integrand {
public:
    /// Throws Error for a part without an enclosure.
    Integrand(const Expr& f, std::string variable, IntegrandMeaning meaning, long bits)
        : variable_(std::move(variable)), meaning_(std::move(meaning)), bits_(bits),
          result_(compiled(f)), valued_(steps_.size(), ValuedBox(bits)),
          zero_(valued_.size(), false), sloped_(valued_.size(), false) {
        for (std::size_t slot = 0; slot < valued_.size(); ++slot) {
            const Step& step = steps_[slot];
            if (step.role == Role::constant) {
                valued_[slot].w = valued_[slot].end = Box(meaning_.constant(step.source));
            }
            exponents_.push_back(step.is_operation() && step.kind == Kind::pow
                                     ? meaning_.rational(step.source.arg(1))
                                     : std::nullopt);
        }
        if (meaning_.path != nullptr) {
            const auto line = contact::as_linear(*meaning_.path_argument, variable_);
            if (!line) {
                throw Error("a contact's edge that is not linear in the variable of an integral");
            }
            offset_ = meaning_.constant(line->at_origin);
            rate_ = meaning_.constant(line->rate);
        }
    }

    /// True if the formula reduces to the constant 0.
    [[nodiscard]] bool vanishes() const { return is_zero(result_); }
    enum class Centre {
        rooted, ///< n is as large as needed for roots of parts that vanish at the centre
        pole,   ///< n = 1, v of either sign; zeros at the centre are ignored if one is under a root
        regular ///< n = 1; zeros at the centre are ignored
    };
    /// Sets the centre e = `at`, where the variable is `written`, with v towards greater values
    /// (direction 1) or smaller ones (-1). `angle`: the angle of e on the path, if there is one.
    void centre(const Expr& written, const Ball& at, int direction, const Ball& angle,
                Centre kind) {
        written_ = written;
        direction_ = certainly_negative(rate_) ? -direction : direction;
        start_ = Box(meaning_.path != nullptr ? angle : at);
        power_ = 1;
        std::fill(zero_.begin(), zero_.end(), false);
        std::fill(sloped_.begin(), sloped_.end(), false);
        if (kind != Centre::regular) {
            find_zeros();
            choose_power(kind);
        }
        mark_slopes();
    }
    /// Returns n; it is 1 if nothing is singular.
    [[nodiscard]] long power() const { return power_; }
    /// Returns f d(variable)/dv, without the sign of the direction. `analytic`: the result is not
    /// finite if the function may not be holomorphic on the whole box.
    void at(acb_ptr out, const Box& v, bool analytic) {
        check_interruption();
        run(v, analytic);
        const ValuedBox& f = valued_[result_];
        Box y = f.w;
        multiply_by_power(y, f.k + power_ - 1);
        acb_mul_si(out, y.get(), power_, bits_);
        if (meaning_.path != nullptr) {
            acb_mul(out, out, by_angle_.get(), bits_);
        }
    }
    /// The lowest power of v in f and its factor (v^n = +-(variable - e)). A polynomial in log v is
    /// taken at log v = 1: if that is not 0, f is at least as great as a multiple of the power.
    struct Leading {
        long power;
        Box factor;
    };
    [[nodiscard]] Leading leading(const Box& v) {
        leading_ = true;
        run(v, true);
        leading_ = false;
        return {valued_[result_].k, valued_[result_].w};
    }

private:
    /// A value v^k w. If needed, for k = 0, w is also given as end + v^n slope.
    struct ValuedBox {
        explicit ValuedBox(long bits) : w(bits), end(bits), slope(bits) {}
        long k = 0;
        Box w;
        Box end;
        Box slope;
    };
    enum class Role { input, constant, operation };
    /// A part of the formula. Equal parts are computed once, parts without the variable beforehand.
    struct Step {
        Role role;
        Expr::Kind kind; ///< of the operation
        Expr source;
        std::vector<std::size_t> operands; ///< of an operation: places of previous steps
        [[nodiscard]] bool is_operation() const { return role == Role::operation; }
    };
    /// The inputs: the variable, and with a path b and P' at its argument.
    enum Input { of_variable, of_edge, of_force_rate };
    /// Makes the inputs and the steps of a formula, and returns the place of its value. The product
    /// of the number 0 and any other factor is this number 0, and so is a quotient of 0 and a part
    /// that is not this number.
    [[nodiscard]] std::size_t compiled(const Expr& f);
    [[nodiscard]] std::size_t place_of(const Expr& part);
    [[nodiscard]] std::size_t new_place_of(const Expr& part);
    [[nodiscard]] std::size_t add(Role role, Expr::Kind kind, const Expr& source,
                                  std::vector<std::size_t> operands = {}) {
        steps_.push_back({role, kind, source, std::move(operands)});
        return steps_.size() - 1;
    }
    /// True for the number 0.
    [[nodiscard]] bool is_zero(std::size_t place) const {
        const Rational* q = steps_[place].source.rational();
        return steps_[place].role == Role::constant && q != nullptr && *q == 0;
    }
    /// Checks that a part has an enclosure, and replaces functions of the contact by formulas.
    [[nodiscard]] std::optional<Expr> written_out(const Expr& part) const;
    [[nodiscard]] const ValuedBox& part(const Step& step, std::size_t k) const {
        return valued_[step.operands[k]];
    }

    void run(const Box& v, bool analytic) {
        v_ = v;
        analytic_ = analytic;
        acb_pow_ui(vn_.get(), v.get(), static_cast<ulong>(power_), bits_);
        Box at = start_;
        (direction_ > 0 ? acb_add : acb_sub)(at.get(), at.get(), vn_.get(), bits_);
        place(at);
        apply_zero(of_variable);
        for (std::size_t slot = 0; slot < valued_.size(); ++slot) {
            if (steps_[slot].is_operation()) {
                take(slot);
            }
        }
    }

    void multiply_by_power(Box& y, long k) const {
        if (k == 0) {
            return;
        }
        Box factor(bits_);
        acb_pow_si(factor.get(), v_.get(), k, bits_);
        acb_mul(y.get(), y.get(), factor.get(), bits_);
    }
    /// Returns v^k w.
    [[nodiscard]] Box plain(const ValuedBox& x) const {
        Box y = x.w;
        multiply_by_power(y, x.k);
        return y;
    }
    /// Computes the inputs, at one of the points of the variable or of the path.
    void place(const Box& at) {
        ValuedBox& variable = valued_[of_variable];
        variable.k = 0;
        if (meaning_.path == nullptr) {
            variable.w = at;
            variable.end = start_;
            acb_set_si(variable.slope.get(), direction_);
            return;
        }
        ValuedBox& edge = valued_[of_edge];
        const auto in_variable = [&](Box s) { return (std::move(s) - offset_) * (1 / rate_); };
        const TiltedPath::Point here = meaning_.path->at(at);
        variable.w = in_variable(here.s);
        by_angle_ = here.ds * (1 / abs(rate_));
        edge.w = here.b;
        valued_[of_force_rate].w = here.rate;
        acb_indeterminate(valued_[of_force_rate].slope.get());
        if (wants_slopes_) {
            // A derivative over the convex box that contains the segment encloses the quotient.
            const TiltedPath::Point end = meaning_.path->at(start_);
            const TiltedPath::Point over = meaning_.path->at(Box::hull(start_, at));
            variable.end = in_variable(end.s);
            edge.end = end.b;
            find_slope(variable, over.ds * (1 / rate_));
            find_slope(edge, over.db);
        }
    }
    /// Computes the slope from the values at the point and at the centre, and from the derivative
    /// between them. The former is narrow if the box is narrow, the latter near the centre.
    void find_slope(ValuedBox& x, const Box& derivative) const {
        x.slope = direction_ > 0 ? derivative : -derivative;
        const Box quotient = (x.w - x.end) / vn_;
        if (!derivative.is_finite()) {
            x.slope = quotient;
        } else if (quotient.is_finite()) {
            arb_ptr re = acb_realref(x.slope.get());
            arb_ptr im = acb_imagref(x.slope.get());
            arb_intersection(re, re, acb_realref(quotient.get()), bits_);
            arb_intersection(im, im, acb_imagref(quotient.get()), bits_);
        }
    }
    /// Finds the slots that are proved to be zero at v = 0.
    void find_zeros() {
        v_ = Box(bits_);
        analytic_ = false;
        vn_ = Box(bits_);
        wants_slopes_ = false;
        std::vector<std::size_t> found;
        const auto look = [&](std::size_t slot, bool candidate, const Expr& written) {
            ValuedBox& value = valued_[slot];
            if (candidate && value.w.contains_zero() &&
                meaning_.surely_zero(substitute(written, variable_, written_))) {
                found.push_back(slot);
                acb_zero(value.w.get());
            }
            value.end = value.w;
        };
        place(start_);
        for (std::size_t slot = 0; slot < valued_.size(); ++slot) {
            const Step& step = steps_[slot];
            if (step.is_operation()) {
                take(slot);
                look(slot, step.kind == Kind::add || step.kind == Kind::sub, step.source);
            } else if (step.role == Role::input) {
                look(slot, slot == of_variable, step.source);
            }
        }
        for (const std::size_t slot : found) {
            zero_[slot] = true;
        }
    }
    /// The power of the distance from the centre as which a part vanishes there, and the degree in
    /// its logarithm.
    struct Order {
        Rational power = 0;
        long logs = 0;
    };
    /// Finds the least n for which all powers of v are integers, and the integrand tends to 0 with
    /// its logarithms if it has any.
    void choose_power(Centre kind) {
        std::vector<Order> order(valued_.size());
        order[of_variable].power = zero_[of_variable] ? 1 : 0;
        Integer common = 1;
        bool singular = false; // roots and logarithms of parts that vanish at the centre
        bool unknown = false;  // other functions of logarithms
        for (std::size_t slot = 0; slot < valued_.size(); ++slot) {
            const Step& step = steps_[slot];
            Order& here = order[slot];
            const auto part = [&](std::size_t k) -> const Order& {
                return order[step.operands[k]];
            };
            if (zero_[slot]) {
                here.power = 1;
            }
            if (zero_[slot] || !step.is_operation()) {
                continue;
            }
            const auto& exponent = exponents_[slot];
            switch (step.kind) {
            case Kind::neg:
                here = part(0);
                break;
            case Kind::add:
            case Kind::sub:
                here = {std::min(part(0).power, part(1).power),
                        std::max(part(0).logs, part(1).logs)};
                break;
            case Kind::mul:
                here = {part(0).power + part(1).power, part(0).logs + part(1).logs};
                break;
            case Kind::div:
                here = {part(0).power - part(1).power, part(0).logs};
                unknown = unknown || part(1).logs > 0;
                break;
            default: {
                const formula::Builtin f = step.source.builtin();
                const Order& of = part(step.operands.size() - 1 - (step.kind == Kind::pow ? 1 : 0));
                const bool log = f == formula::Builtin::log;
                const auto to = step.kind == Kind::pow        ? exponent
                                : f == formula::Builtin::sqrt ? std::optional(Rational(1, 2))
                                                              : std::nullopt;
                const bool whole = to && denominator(*to) == 1 && *to > 0;
                unknown = unknown || (of.logs > 0 && !whole);
                singular = singular || (of.power != 0 && (log || (to && denominator(*to) != 1)));
                if (to) {
                    here = {of.power * *to, whole ? of.logs * to->convert_to<long>() : 0};
                }
                here.logs += log && of.power != 0 ? 1 : 0;
            }
            }
            common = lcm(common, Integer(denominator(here.power)));
        }
        Rational n(common);
        if (const auto& [power, logs] = order[result_]; logs > 0 && power > -1) {
            while (n < 2 || n * (power + 1) < logs + 1) {
                n += common;
            }
        }
        if (kind == Centre::rooted ? unknown || n > most_rooted : singular) {
            std::fill(zero_.begin(), zero_.end(), false);
        } else {
            power_ = n.convert_to<long>();
        }
    }
    /// Marks the parts that are needed for the divided differences of zeros.
    void mark_slopes() {
        for (std::size_t slot = valued_.size(); slot-- > 0;) {
            sloped_[slot] = sloped_[slot] || zero_[slot];
            if (sloped_[slot]) {
                for (const std::size_t operand : steps_[slot].operands) {
                    sloped_[operand] = true;
                }
            }
        }
        wants_slopes_ = std::ranges::any_of(sloped_, [](bool x) { return x; });
    }

    /// Computes an operation.
    void take(std::size_t slot);
    void take_sum(const Step& step, std::size_t slot);
    void take_product(const Step& step, std::size_t slot);
    void take_quotient(const Step& step, std::size_t slot);
    void take_power(const Step& step, std::size_t slot);
    void take_root(const Step& step, std::size_t slot);
    /// The logarithm of a part that vanishes or is infinite at the centre.
    void take_log(const ValuedBox& x, ValuedBox& r) const;
    void take_function(const Step& step, std::size_t slot);
    /// Applies the proof that a slot is zero at v = 0.
    void apply_zero(std::size_t slot);

    using Kind = Expr::Kind;
    static constexpr long most_rooted = 64; ///< n of e +- v^n

    std::string variable_;
    IntegrandMeaning meaning_;
    long bits_;
    std::vector<Step> steps_; ///< the inputs, and then each part after its operands
    std::unordered_map<Expr, std::size_t, formula::ExprHash> places_; ///< of the parts
    std::size_t result_;
    std::vector<std::optional<Rational>> exponents_; ///< of powers, if they are rational
    std::vector<ValuedBox> valued_;                  ///< by places of steps
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
    bool leading_ = false; ///< log v is taken as 1
    Box by_angle_{bits_};
};

/// Returns the integral of f, in the variable of its centre, along the straight line from v to w.
/// For boxes v and w, the result contains the integral between any two of their points.
[[nodiscard]] Box line_integral(Integrand& f, const Box& v, const Box& w, unsigned digits);

} // namespace edgeproof::audit
