// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/enclosure/integrand.hpp"

#include "edgeproof/audit/enclosure/integrand_program.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>

namespace edgeproof::audit {
namespace {

using Op = IntegrandStep::Op;

constexpr long most_rooted = 64; // n of e +- v^n

} // namespace

Integrand::Program::Program(const formula::Expr& f, std::string variable, IntegrandMeaning meaning,
                            long bits)
    : variable_(std::move(variable)), meaning_(std::move(meaning)), bits_(bits),
      steps_(f, variable_, meaning_), valued_(steps_.all().size(), ValuedBox(bits)),
      zero_(steps_.all().size(), false), sloped_(steps_.all().size(), false) {
    for (std::size_t i = 0; i < all().size(); ++i) {
        if (all()[i].op == Op::constant) {
            const Ball value = meaning_.constant(all()[i].written);
            valued_[i].w = valued_[i].end = Box(value);
        }
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

void Integrand::Program::centre(const formula::Expr& written, const Ball& at, int direction,
                                const Ball& angle, Centre kind) {
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

void Integrand::Program::mark_slopes() {
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

void Integrand::Program::run(const Box& v, bool analytic) {
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

void Integrand::Program::at(acb_ptr out, const Box& v, bool analytic) {
    check_interruption();
    run(v, analytic);
    const ValuedBox& f = valued_[steps_.last()];
    Box y = f.w;
    multiply_by_power(y, f.k + power_ - 1);
    acb_mul_si(out, y.get(), power_, bits_);
    if (meaning_.path != nullptr) {
        acb_mul(out, out, by_angle_.get(), bits_);
    }
}

Integrand::Leading Integrand::Program::leading(const Box& v) {
    run(v, true);
    return {valued_[steps_.last()].k, valued_[steps_.last()].w};
}

void Integrand::Program::multiply_by_power(Box& y, long k) const {
    if (k == 0) {
        return;
    }
    Box factor(bits_);
    acb_pow_si(factor.get(), v_.get(), k, bits_);
    acb_mul(y.get(), y.get(), factor.get(), bits_);
}

void Integrand::Program::place(const Box& at) {
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
        // A derivative over the convex box that contains the segment encloses the quotient.
        const TiltedPath::Point end = meaning_.path->at(start_);
        const TiltedPath::Point over = meaning_.path->at(Box::hull(start_, at));
        variable_now_.end = in_variable(end.s);
        edge_now_.end = end.b;
        find_slope(variable_now_, over.ds * (1 / rate_));
        find_slope(edge_now_, over.db);
    }
}

void Integrand::Program::find_slope(ValuedBox& x, const Box& derivative) const {
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

void Integrand::Program::find_zeros() {
    v_ = Box(bits_);
    analytic_ = false;
    vn_ = Box(bits_);
    wants_slopes_ = false;
    std::vector<std::size_t> found;
    place(start_);
    for (std::size_t i = 0; i < all().size(); ++i) {
        const IntegrandStep& step = all()[i];
        if (step.op == Op::constant) {
            continue;
        }
        take(i);
        ValuedBox& value = valued_[i];
        const bool candidate = step.op == Op::add || step.op == Op::sub || step.op == Op::variable;
        zero_[i] = false;
        if (candidate && value.w.contains_zero() &&
            meaning_.surely_zero(substitute(step.written, variable_, written_))) {
            found.push_back(i);
            acb_zero(value.w.get());
        }
        value.end = value.w;
    }
    for (const std::size_t i : found) {
        zero_[i] = true;
    }
}

void Integrand::Program::choose_power(Centre kind) {
    std::vector<Rational> order(all().size(), Rational(0));
    Integer common = 1;
    bool roots = false; // of parts that vanish at the centre
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

Integrand::Integrand(const formula::Expr& f, std::string variable, IntegrandMeaning meaning,
                     long bits)
    : program_(std::make_unique<Program>(f, std::move(variable), std::move(meaning), bits)) {}
Integrand::~Integrand() = default;
Integrand::Integrand(Integrand&&) noexcept = default;
bool Integrand::vanishes() const { return program_->vanishes(); }
void Integrand::centre(const formula::Expr& written, const Ball& at, int direction,
                       const Ball& angle, Centre kind) {
    program_->centre(written, at, direction, angle, kind);
}
long Integrand::power() const { return program_->power(); }
void Integrand::at(acb_ptr out, const Box& v, bool analytic) { program_->at(out, v, analytic); }
Integrand::Leading Integrand::leading(const Box& v) { return program_->leading(v); }

} // namespace edgeproof::audit
