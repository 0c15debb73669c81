// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/integrand.hpp"

#include "edgeproof/audit/integrand_program.hpp"
#include "edgeproof/contact/profile.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <numeric>

namespace edgeproof {
namespace {

using Op = IntegrandStep::Op;

constexpr long most_rooted = 64; // n of e +- v^n

/// v^k w, and, where it is asked for, w = end + v^n slope of what has k = 0.
struct Valued {
    explicit Valued(long bits) : w(bits), end(bits), slope(bits) {}
    long k = 0;
    Box w;
    Box end;
    Box slope;
};

/// Certainly off the cuts of asin and acos, which begin at -1 and 1 and run outwards; turned by a
/// right angle, of those of atan.
bool off_cuts_from_one(const Ball& along, const Ball& across) {
    return !contains_zero(across) || certainly_less(abs(along), Ball(1, along.bits()));
}

void indeterminate(Box& z) { acb_indeterminate(z.get()); }

/// log z with its cut along the negative imaginary axis, real for z > 0.
void log_above(Box& r, const Box& z, bool analytic, long bits) {
    acb_div_onei(r.get(), z.get());
    acb_log_analytic(r.get(), r.get(), analytic ? 1 : 0, bits);
    const Ball quarter = Ball::pi(bits) / 2;
    arb_add(acb_imagref(r.get()), acb_imagref(r.get()), quarter.data(), bits);
}

} // namespace

class Integrand::Program {
public:
    Program(const Expr& f, std::string variable, IntegrandMeaning meaning, long bits)
        : variable_(std::move(variable)), meaning_(std::move(meaning)), bits_(bits),
          steps_(f, variable_, meaning_), valued_(steps_.all().size(), Valued(bits)),
          zero_(steps_.all().size(), false), sloped_(steps_.all().size(), false) {
        for (std::size_t i = 0; i < all().size(); ++i) {
            if (all()[i].op == Op::constant) {
                const Ball value = meaning_.constant(all()[i].written);
                valued_[i].w = valued_[i].end = Box(value);
            }
        }
        if (meaning_.path != nullptr) {
            const auto line = as_linear(*meaning_.path_argument, variable_);
            if (!line) {
                throw Error("a contact's edge that is not linear in the variable of an integral");
            }
            offset_ = meaning_.constant(line->at_origin);
            rate_ = meaning_.constant(line->rate);
        }
    }

    [[nodiscard]] bool vanishes() const { return steps_.vanish(); }

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
        for (std::size_t i = all().size(); i-- > 0;) {
            if (zero_[i]) {
                sloped_[i] = true;
            }
            if (sloped_[i]) {
                for (const std::size_t part : all()[i].args) {
                    sloped_[part] = true;
                }
            }
        }
        wants_slopes_ = std::any_of(sloped_.begin(), sloped_.end(), [](bool x) { return x; });
    }

    [[nodiscard]] long power() const { return power_; }

    void run(const Box& v, bool analytic) {
        v_ = v;
        analytic_ = analytic;
        acb_pow_ui(vn_.get(), v.get(), static_cast<ulong>(power_), bits_);
        Box at = start_;
        (direction_ > 0 ? acb_add : acb_sub)(at.get(), at.get(), vn_.get(), bits_);
        place(at);
        for (std::size_t i = 0; i < all().size(); ++i) {
            if (all()[i].op != Op::constant) {
                take(i);
            }
        }
    }

    void at(acb_ptr out, const Box& v, bool analytic) {
        run(v, analytic);
        const Valued& f = valued_[steps_.last()];
        Box y = f.w;
        multiply_by_power(y, f.k + power_ - 1);
        acb_mul_si(out, y.get(), power_, bits_);
        if (meaning_.path != nullptr) {
            acb_mul(out, out, by_angle_.get(), bits_);
        }
    }

    [[nodiscard]] Leading leading(const Box& v) {
        run(v, true);
        return {valued_[steps_.last()].k, valued_[steps_.last()].w};
    }

private:
    [[nodiscard]] const std::vector<IntegrandStep>& all() const { return steps_.all(); }

    void multiply_by_power(Box& y, long k) const {
        if (k == 0) {
            return;
        }
        Box factor(bits_);
        acb_pow_si(factor.get(), v_.get(), k, bits_);
        acb_mul(y.get(), y.get(), factor.get(), bits_);
    }

    /// The variable, and the contact of the path, at a point of it.
    void place(const Box& at) {
        variable_now_.k = 0;
        if (meaning_.path == nullptr) {
            variable_now_.w = at;
            variable_now_.end = start_;
            acb_set_si(variable_now_.slope.get(), direction_);
            return;
        }
        const auto in_variable = [&](Box s) { return (std::move(s) - offset_) * (1 / rate_); };
        const TiltedPath::Point here = meaning_.path->at(at);
        variable_now_.w = in_variable(here.s);
        by_angle_ = here.ds * (1 / abs(rate_));
        edge_now_.w = here.b;
        force_rate_ = here.rate;
        if (wants_slopes_) {
            // A derivative over the convex box that holds the segment encloses the quotient.
            const TiltedPath::Point end = meaning_.path->at(start_);
            const TiltedPath::Point over = meaning_.path->at(Box::hull(start_, at));
            variable_now_.end = in_variable(end.s);
            edge_now_.end = end.b;
            find_slope(variable_now_, over.ds * (1 / rate_));
            find_slope(edge_now_, over.db);
        }
    }

    /// From values at the point and at the centre, and from what the derivative is between them:
    /// the one is narrow where the box is, the other where it is near the centre.
    void find_slope(Valued& x, const Box& derivative) {
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

    /// With v = 0, step by step: what contains zero there, and is zero.
    void find_zeros() {
        v_ = Box(bits_);
        analytic_ = false;
        vn_ = Box(bits_);
        wants_slopes_ = false;
        place(start_);
        for (std::size_t i = 0; i < all().size(); ++i) {
            const IntegrandStep& step = all()[i];
            if (step.op == Op::constant) {
                continue;
            }
            take(i);
            Valued& value = valued_[i];
            const bool candidate =
                step.op == Op::add || step.op == Op::sub || step.op == Op::variable;
            zero_[i] = false;
            if (candidate && value.w.contains_zero() &&
                meaning_.surely_zero(substitute(step.written, variable_, written_))) {
                found_.push_back(i);
                acb_zero(value.w.get());
            }
            value.end = value.w;
        }
        for (const std::size_t i : found_) {
            zero_[i] = true;
        }
        found_.clear();
    }

    /// The least n that makes all powers of v whole.
    void choose_power(Centre kind) {
        std::vector<Rational> order(all().size(), Rational(0));
        Integer common = 1;
        bool roots = false; // of what vanishes at the centre
        for (std::size_t i = 0; i < all().size(); ++i) {
            const IntegrandStep& step = all()[i];
            const auto part = [&](std::size_t k) -> const Rational& { return order[step.args[k]]; };
            if (zero_[i]) {
                order[i] = 1;
                continue;
            }
            switch (step.op) {
            case Op::neg:
                order[i] = part(0);
                break;
            case Op::add:
            case Op::sub:
                order[i] = std::min(part(0), part(1));
                break;
            case Op::mul:
                order[i] = part(0) + part(1);
                break;
            case Op::div:
                order[i] = part(0) - part(1);
                break;
            case Op::sqrt:
                order[i] = part(0) / 2;
                roots = roots || part(0) != 0;
                break;
            case Op::power:
                if (step.exponent) {
                    order[i] = part(0) * *step.exponent;
                    roots = roots || (part(0) != 0 && denominator(*step.exponent) != 1);
                }
                break;
            default:
                break;
            }
            common = lcm(common, Integer(denominator(order[i])));
        }
        if (kind == Centre::rooted ? common > most_rooted : roots) {
            std::fill(zero_.begin(), zero_.end(), false);
        } else {
            power_ = common.convert_to<long>();
        }
    }

    /// w with v^k put in.
    [[nodiscard]] Box plain(const Valued& x) const {
        Box y = x.w;
        multiply_by_power(y, x.k);
        return y;
    }

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
    std::vector<Valued> valued_;
    std::vector<bool> zero_;   ///< proved to vanish at the centre
    std::vector<bool> sloped_; ///< whose divided differences are wanted
    std::vector<std::size_t> found_;
    bool wants_slopes_ = false;
    Expr written_;
    Box start_;
    int direction_ = 1; ///< of the angle, where there is a path
    long power_ = 1;
    Ball offset_;
    Ball rate_;
    Box v_{bits_};
    Box vn_{bits_};
    bool analytic_ = false;
    Valued variable_now_{bits_};
    Valued edge_now_{bits_};
    Box force_rate_{bits_};
    Box by_angle_{bits_};
};

void Integrand::Program::take(std::size_t i) {
    const IntegrandStep& step = all()[i];
    Valued& r = valued_[i];
    switch (step.op) {
    case Op::constant:
        return;
    case Op::variable:
        r = variable_now_;
        break;
    case Op::left_edge:
        r = edge_now_;
        break;
    case Op::force_rate:
        r.k = 0;
        r.w = force_rate_;
        indeterminate(r.slope);
        break;
    case Op::neg: {
        const Valued& x = valued_[step.args[0]];
        r.k = x.k;
        r.w = -x.w;
        if (sloped_[i]) {
            r.end = -x.end;
            r.slope = -x.slope;
        }
        break;
    }
    case Op::add:
        take_sum(i, false);
        break;
    case Op::sub:
        take_sum(i, true);
        break;
    case Op::mul:
        take_product(i);
        break;
    case Op::div:
        take_quotient(i);
        break;
    case Op::power:
        take_power(i);
        break;
    case Op::sqrt:
        take_root(i);
        break;
    default:
        take_function(i);
    }
    if (zero_[i]) {
        r.k = power_;
        r.w = r.slope;
        acb_zero(r.end.get());
    }
}

void Integrand::Program::take_sum(std::size_t i, bool minus) {
    const Valued& x = valued_[all()[i].args[0]];
    const Valued& y = valued_[all()[i].args[1]];
    Valued& r = valued_[i];
    const auto combine = minus ? acb_sub : acb_add;
    if (sloped_[i]) {
        combine(r.slope.get(), x.slope.get(), y.slope.get(), bits_);
        combine(r.end.get(), x.end.get(), y.end.get(), bits_);
    }
    if (zero_[i]) {
        return;
    }
    r.k = std::min(x.k, y.k);
    if (x.k == y.k) {
        combine(r.w.get(), x.w.get(), y.w.get(), bits_);
        return;
    }
    Box lower = x.w;
    Box upper = y.w;
    multiply_by_power(lower, x.k - r.k);
    multiply_by_power(upper, y.k - r.k);
    combine(r.w.get(), lower.get(), upper.get(), bits_);
}

void Integrand::Program::take_product(std::size_t i) {
    const Valued& x = valued_[all()[i].args[0]];
    const Valued& y = valued_[all()[i].args[1]];
    Valued& r = valued_[i];
    r.k = x.k + y.k;
    acb_mul(r.w.get(), x.w.get(), y.w.get(), bits_);
    if (sloped_[i]) {
        r.slope = plain(x) * y.slope + y.end * x.slope;
        r.end = x.end * y.end;
    }
}

void Integrand::Program::take_quotient(std::size_t i) {
    const Valued& x = valued_[all()[i].args[0]];
    const Valued& y = valued_[all()[i].args[1]];
    Valued& r = valued_[i];
    r.k = x.k - y.k;
    acb_div(r.w.get(), x.w.get(), y.w.get(), bits_);
    if (sloped_[i]) {
        r.end = x.end / y.end;
        r.slope = (x.slope - r.end * y.slope) / plain(y);
    }
}

void Integrand::Program::take_power(std::size_t i) {
    const IntegrandStep& step = all()[i];
    const Valued& x = valued_[step.args[0]];
    Valued& r = valued_[i];
    const bool whole = step.exponent && denominator(*step.exponent) == 1 && abs(*step.exponent) < 1000;
    if (whole) {
        const long n = step.exponent->convert_to<long>();
        r.k = x.k * n;
        acb_pow_si(r.w.get(), x.w.get(), n, bits_);
        if (sloped_[i]) {
            constexpr long most_written = 8;
            if (n < 1 || n > most_written) {
                indeterminate(r.slope);
                return;
            }
            const Box now = plain(x);
            r.end = x.end;
            r.slope = x.slope;
            for (long j = 1; j < n; ++j) {
                r.slope = now * r.slope + r.end * x.slope;
                r.end = r.end * x.end;
            }
        }
        return;
    }
    indeterminate(r.slope);
    const Rational order = step.exponent ? Rational(*step.exponent * x.k) : Rational(0);
    const bool split = x.k != 0 && step.exponent && denominator(order) == 1;
    const Box base = split ? x.w : plain(x);
    r.k = split ? order.convert_to<long>() : 0;
    acb_pow_analytic(r.w.get(), base.get(), valued_[step.args[1]].w.get(), analytic_ ? 1 : 0, bits_);
    if (sloped_[i]) {
        r.end = r.w; // of no use without a slope
    }
}

void Integrand::Program::take_root(std::size_t i) {
    const Valued& x = valued_[all()[i].args[0]];
    Valued& r = valued_[i];
    const bool split = x.k % 2 == 0;
    const Box base = split ? x.w : plain(x);
    r.k = split ? x.k / 2 : 0;
    acb_sqrt_analytic(r.w.get(), base.get(), analytic_ ? 1 : 0, bits_);
    if (!sloped_[i]) {
        return;
    }
    acb_sqrt(r.end.get(), x.end.get(), bits_);
    if (x.k == 0) {
        r.slope = x.slope / (r.w + r.end);
    } else {
        indeterminate(r.slope);
    }
}

void Integrand::Program::take_function(std::size_t i) {
    const IntegrandStep& step = all()[i];
    Valued& r = valued_[i];
    const int whole = analytic_ ? 1 : 0;
    const Box x = plain(valued_[step.args.back()]);
    r.k = 0;
    acb_ptr y = r.w.get();
    switch (step.op) {
    case Op::log:
        acb_log_analytic(y, x.get(), whole, bits_);
        break;
    case Op::log_above:
        log_above(r.w, x, analytic_, bits_);
        break;
    case Op::exp:
        acb_exp(y, x.get(), bits_);
        break;
    case Op::sin:
        acb_sin(y, x.get(), bits_);
        break;
    case Op::cos:
        acb_cos(y, x.get(), bits_);
        break;
    case Op::asin:
    case Op::acos:
        if (analytic_ && !off_cuts_from_one(x.real(), x.imaginary())) {
            indeterminate(r.w);
        } else {
            (step.op == Op::asin ? acb_asin : acb_acos)(y, x.get(), bits_);
        }
        break;
    case Op::atan:
        if (analytic_ && !off_cuts_from_one(x.imaginary(), x.real())) {
            indeterminate(r.w);
        } else {
            acb_atan(y, x.get(), bits_);
        }
        break;
    case Op::gauss: {
        // Its cut runs from 1 outwards.
        const bool off = !x.may_be_real() || certainly_less(x.real(), Ball(1, bits_));
        if (analytic_ && !off) {
            indeterminate(r.w);
        } else {
            const auto part = [&](std::size_t k) { return valued_[step.args[k]].w.get(); };
            acb_hypgeom_2f1(y, part(0), part(1), part(2), x.get(), 0, bits_);
        }
        break;
    }
    default:
        indeterminate(r.w);
    }
    if (sloped_[i]) {
        r.end = r.w;
        indeterminate(r.slope);
    }
}

Integrand::Integrand(const Expr& f, std::string variable, IntegrandMeaning meaning, long bits)
    : program_(std::make_unique<Program>(f, std::move(variable), std::move(meaning), bits)) {}
Integrand::~Integrand() = default;
Integrand::Integrand(Integrand&&) noexcept = default;
bool Integrand::vanishes() const { return program_->vanishes(); }
void Integrand::centre(const Expr& written, const Ball& at, int direction, const Ball& angle,
                       Centre kind) {
    program_->centre(written, at, direction, angle, kind);
}
long Integrand::power() const { return program_->power(); }
void Integrand::at(acb_ptr out, const Box& v, bool analytic) { program_->at(out, v, analytic); }
Integrand::Leading Integrand::leading(const Box& v) { return program_->leading(v); }

} // namespace edgeproof
