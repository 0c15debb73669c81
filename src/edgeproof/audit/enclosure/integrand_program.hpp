// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/enclosure/integrand.hpp"

#include <vector>

namespace edgeproof::audit {

/// One operation of an integrand that is evaluated on many boxes; its operands come before it.
struct IntegrandStep {
    enum class Op {
        constant,
        variable,
        neg,
        add,
        sub,
        mul,
        div,
        power, ///< to a rational number, or to a ball
        sqrt,
        log,
        log_above,
        exp,
        sin,
        cos,
        asin,
        acos,
        atan,
        gauss,
        left_edge,  ///< b(s) of the path
        force_rate, ///< P'(s)
    };
    Op op;
    formula::Expr written;
    std::vector<std::size_t> args;
    std::optional<Rational> exponent; ///< of a power, if it is rational
};

/// The steps of a formula, whose value is that of last(). Equal parts are one step.
class IntegrandSteps {
public:
    IntegrandSteps(const formula::Expr& f, const std::string& variable,
                   const IntegrandMeaning& meaning);
    [[nodiscard]] const std::vector<IntegrandStep>& all() const { return steps_; }
    [[nodiscard]] std::size_t last() const { return last_; }
    [[nodiscard]] bool vanish() const { return is_zero(last_); }

private:
    std::size_t add(const formula::Expr& e);
    std::size_t add_call(const formula::Expr& e);
    std::size_t step(IntegrandStep::Op op, const formula::Expr& e, std::vector<std::size_t> args,
                     std::optional<Rational> exponent = std::nullopt);
    [[nodiscard]] bool is_zero(std::size_t i) const;
    [[nodiscard]] bool holds_variable(const formula::Expr& e) const;
    const std::string& variable_;
    const IntegrandMeaning& meaning_;
    std::vector<IntegrandStep> steps_;
    std::unordered_map<formula::Expr, std::size_t, formula::ExprHash> known_;
    std::size_t last_;
};

/// A value v^k w. If needed, for k = 0, w is also given as end + v^n slope.
struct ValuedBox {
    explicit ValuedBox(long bits) : w(bits), end(bits), slope(bits) {}
    long k = 0;
    Box w;
    Box end;
    Box slope;
};

/// The steps of an integrand, and their values for one v at a time.
class Integrand::Program {
public:
    Program(const formula::Expr& f, std::string variable, IntegrandMeaning meaning, long bits);
    [[nodiscard]] bool vanishes() const { return steps_.vanish(); }
    void centre(const formula::Expr& written, const Ball& at, int direction, const Ball& angle,
                Centre kind);
    [[nodiscard]] long power() const { return power_; }
    void at(acb_ptr out, const Box& v, bool analytic);
    [[nodiscard]] Leading leading(const Box& v);

private:
    [[nodiscard]] const std::vector<IntegrandStep>& all() const { return steps_.all(); }
    void run(const Box& v, bool analytic);
    void multiply_by_power(Box& y, long k) const;
    /// Returns v^k w.
    [[nodiscard]] Box plain(const ValuedBox& x) const {
        Box y = x.w;
        multiply_by_power(y, x.k);
        return y;
    }
    /// Computes the variable, and the contact of the path, at one of its points.
    void place(const Box& at);
    /// Computes the slope from the values at the point and at the centre, and from the derivative
    /// between them. The former is narrow if the box is narrow, the latter near the centre.
    void find_slope(ValuedBox& x, const Box& derivative) const;
    /// Finds the steps that are proved to be zero at v = 0.
    void find_zeros();
    /// Finds the least n for which all powers of v are integers.
    void choose_power(Centre kind);
    /// Marks the parts that are needed for the divided differences of zeros.
    void mark_slopes();

    void take(std::size_t i);
    void take_sum(std::size_t i, bool minus);
    void take_product(std::size_t i);
    void take_quotient(std::size_t i);
    void take_power(std::size_t i);
    void take_root(std::size_t i);
    void take_function(std::size_t i);

    std::string variable_;
    IntegrandMeaning meaning_;
    long bits_;
    IntegrandSteps steps_;
    std::vector<ValuedBox> valued_;
    std::vector<bool> zero_;   ///< proved to vanish at the centre
    std::vector<bool> sloped_; ///< the divided difference is needed
    bool wants_slopes_ = false;
    formula::Expr written_;
    Box start_;
    int direction_ = 1; ///< of the angle, if there is a path
    long power_ = 1;
    Ball offset_;
    Ball rate_;
    Box v_{bits_};
    Box vn_{bits_};
    bool analytic_ = false;
    ValuedBox variable_now_{bits_};
    ValuedBox edge_now_{bits_};
    Box force_rate_{bits_};
    Box by_angle_{bits_};
};

} // namespace edgeproof::audit
