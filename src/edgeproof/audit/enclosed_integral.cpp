// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/enclosed_integral.hpp"

#include "edgeproof/precision/acb_include.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <exception>
#include <string>

namespace edgeproof {
namespace {

using Kind = Expr::Kind;

constexpr long most_evaluations = 20000;

/// A complex box, its centre and radii Arb's.
class Box {
public:
    Box() { acb_init(z_); }
    explicit Box(const Ball& x) : Box() { acb_set_arb(z_, x.data()); }
    explicit Box(const acb_t z) : Box() { acb_set(z_, z); }
    Box(const Box& o) : Box(o.z_) {}
    Box(Box&& o) noexcept : Box() { acb_swap(z_, o.z_); }
    Box& operator=(const Box&) = delete;
    Box& operator=(Box&&) = delete;
    ~Box() { acb_clear(z_); }
    [[nodiscard]] acb_ptr get() { return z_; }
    [[nodiscard]] acb_srcptr get() const { return z_; }

private:
    acb_t z_;
};

/// A formula on a box of the variable.
struct OnBox {
    std::string_view variable;
    const NameEnclosure& names;
    const Box& at;
    bool analytic; ///< not finite where the formula may not be holomorphic on the whole box
    long bits;

    [[nodiscard]] Box operator()(const Expr& e) const {
        if (const Rational* q = e.rational()) {
            return Box(Ball(*q, bits));
        }
        Box y;
        switch (e.kind()) {
        case Kind::pi:
            return Box(Ball::pi(bits));
        case Kind::symbol:
            return e.name() == variable ? at : Box(names(e.name()));
        case Kind::neg:
            acb_neg(y.get(), (*this)(e.arg(0)).get());
            return y;
        case Kind::add:
            acb_add(y.get(), (*this)(e.arg(0)).get(), (*this)(e.arg(1)).get(), bits);
            return y;
        case Kind::sub:
            acb_sub(y.get(), (*this)(e.arg(0)).get(), (*this)(e.arg(1)).get(), bits);
            return y;
        case Kind::mul:
            acb_mul(y.get(), (*this)(e.arg(0)).get(), (*this)(e.arg(1)).get(), bits);
            return y;
        case Kind::div:
            acb_div(y.get(), (*this)(e.arg(0)).get(), (*this)(e.arg(1)).get(), bits);
            return y;
        case Kind::pow:
            return power(e);
        case Kind::call:
            return call(e);
        default:
            throw Error("'" + e.name() + "' has no enclosure inside an integral");
        }
    }

private:
    [[nodiscard]] Box power(const Expr& e) const {
        Box y;
        const Box base = (*this)(e.arg(0));
        const Rational* q = e.arg(1).rational();
        if (q != nullptr && denominator(*q) == 1 && abs(*q) < 1000) {
            acb_pow_si(y.get(), base.get(), q->convert_to<long>(), bits);
        } else {
            acb_pow_analytic(y.get(), base.get(), (*this)(e.arg(1)).get(), analytic ? 1 : 0, bits);
        }
        return y;
    }
    [[nodiscard]] Box call(const Expr& e) const {
        if (e.args().size() != 1) {
            throw Error("'" + e.name() + "' has no enclosure inside an integral");
        }
        const Box x = (*this)(e.arg(0));
        Box y;
        const int whole = analytic ? 1 : 0;
        switch (e.builtin()) {
        case Builtin::sqrt:
            acb_sqrt_analytic(y.get(), x.get(), whole, bits);
            break;
        case Builtin::log:
            acb_log_analytic(y.get(), x.get(), whole, bits);
            break;
        case Builtin::exp:
            acb_exp(y.get(), x.get(), bits);
            break;
        case Builtin::sin:
            acb_sin(y.get(), x.get(), bits);
            break;
        case Builtin::cos:
            acb_cos(y.get(), x.get(), bits);
            break;
        case Builtin::asin:
            (analytic && !within_one(x) ? acb_indeterminate(y.get())
                                        : acb_asin(y.get(), x.get(), bits));
            break;
        case Builtin::acos:
            (analytic && !within_one(x) ? acb_indeterminate(y.get())
                                        : acb_acos(y.get(), x.get(), bits));
            break;
        default:
            throw Error("'" + e.name() + "' has no enclosure inside an integral");
        }
        return y;
    }
    /// Certainly off the cuts of asin and acos, which begin at -1 and 1 and run outwards.
    static bool within_one(const Box& x) {
        if (arb_contains_zero(acb_imagref(x.get())) == 0) {
            return true;
        }
        const Ball one(1, 64);
        arb_t size;
        arb_init(size);
        arb_abs(size, acb_realref(x.get()));
        const bool within = arb_lt(size, one.data()) != 0;
        arb_clear(size);
        return within;
    }
};

struct IntegrandCall {
    const Expr& integrand;
    std::string_view variable;
    const NameEnclosure& names;
    std::exception_ptr thrown;
};

int integrand_on(acb_ptr out, const acb_t at, void* parameter, slong order, slong bits) {
    auto& work = *static_cast<IntegrandCall*>(parameter);
    // No exception may pass through Arb, which goes on asking after the first.
    if (work.thrown) {
        acb_indeterminate(out);
        return 0;
    }
    try {
        const Box box(at);
        const Box value = OnBox{work.variable, work.names, box, order != 0, bits}(work.integrand);
        acb_set(out, value.get());
    } catch (...) {
        work.thrown = std::current_exception();
        acb_indeterminate(out);
    }
    return 0;
}

} // namespace

Ball enclosed_integral(const Expr& integrand, std::string_view variable, const NameEnclosure& names,
                       const Ball& lo, const Ball& hi, unsigned digits) {
    const long bits = std::max(lo.bits(), hi.bits());
    const auto goal = static_cast<slong>(digits) * 10 / 3;
    IntegrandCall work{integrand, variable, names, nullptr};
    acb_calc_integrate_opt_t options;
    acb_calc_integrate_opt_init(options);
    options->eval_limit = most_evaluations;
    options->depth_limit = 4 * bits;
    mag_t tolerance;
    mag_init(tolerance);
    mag_set_ui_2exp_si(tolerance, 1, -goal);
    Box from;
    Box to;
    arb_get_mid_arb(acb_realref(from.get()), lo.data());
    arb_get_mid_arb(acb_realref(to.get()), hi.data());
    Box sum;
    acb_calc_integrate(sum.get(), integrand_on, &work, from.get(), to.get(), goal, tolerance,
                       options, bits);
    mag_clear(tolerance);
    if (work.thrown) {
        std::rethrow_exception(work.thrown);
    }
    Ball result(0, bits);
    if (arb_contains_zero(acb_imagref(sum.get())) == 0) {
        arb_indeterminate(
            result.data()); // a root of what is negative somewhere: not of real numbers
    } else {
        arb_set(result.data(), acb_realref(sum.get()));
    }
    // What the radii of the limits leave: at most the largest value over them.
    for (const Ball* limit : {&lo, &hi}) {
        const Box at(*limit);
        const Box value = OnBox{variable, names, at, false, bits}(integrand);
        Ball rest(0, bits);
        arb_set(rest.data(), acb_realref(value.get()));
        result += rest * Ball(limit->radius(), bits) * Ball::from_interval(Real(-1), Real(1), bits);
    }
    return result;
}

} // namespace edgeproof
