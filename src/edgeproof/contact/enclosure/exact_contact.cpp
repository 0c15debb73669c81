// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/enclosure/exact_contact.hpp"

#include "edgeproof/contact/enclosure/ball_relative_error.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/law/edge_expansion.hpp"
#include "edgeproof/contact/law/logarithmic_pressure.hpp"
#include "edgeproof/series/functions.hpp"

#include <algorithm>
#include <array>

namespace edgeproof::contact {
namespace {

constexpr long most_whole_exponent = 1000;
constexpr std::size_t most_exact_coefficients = 40;

} // namespace

std::optional<Rational> simplest_rational(const Ball& x) {
    if (!x.is_finite()) {
        return {};
    }
    if (contains_zero(x)) { // any integer may be the result of FLINT there
        return Rational(0);
    }
    return simplest_between(exact_value(x.lower()), exact_value(x.upper()));
}

ExactContact::ExactContact(const Profile& profile, const formula::Exact& contact_modulus,
                           const Load& load, const Ball& near_a, const Ball& near_b)
    : profile_(profile), modulus_(formula::ExactNumber::of(contact_modulus.expr())),
      power_law_(profile.kind() == Profile::Kind::power_law), a_(formula::ExactNumber::unknown()),
      b_(formula::ExactNumber::unknown()) {
    if (power_law_) {
        read_power_law();
    } else if (profile.piecewise_linear()) {
        slope_ = linear_slope<formula::ExactNumber>(profile_, formula::ExactNumber::of);
    } else {
        power_factor_ = formula::ExactNumber::unknown();
        if (load.kind == Load::Kind::right_edge) {
            a_ = formula::ExactNumber::of(load.value.expr());
            b_ = profile.symmetric() ? a_ : b_;
        }
        return;
    }
    find_edges(load, near_a, near_b);
}

void ExactContact::read_power_law() {
    const auto m = formula::ExactNumber::of(profile_.parameters().at("m").expr()).rational();
    power_factor_ = formula::ExactNumber::unknown();
    exponent_ = m;
    if (!m || denominator(*m) != 1 || *m > most_whole_exponent) {
        return;
    }
    const auto n = static_cast<unsigned>(numerator(*m).convert_to<unsigned long>());
    whole_exponent_ = n;
    // sqrt(pi)/2 Gamma(1 + m/2)/Gamma((3 + m)/2) (moore-hills EQ11) is 1 for m = 0 and pi/4 for
    // m = 1. A step of m by 2 multiplies it by (m + 2)/(m + 3).
    formula::ExactNumber factor =
        n % 2 == 0 ? formula::ExactNumber(1) : formula::ExactNumber::pi() / 4;
    for (unsigned k = n % 2; k < n; k += 2) {
        factor *= formula::ExactNumber(Rational(k + 2, k + 3));
    }
    power_factor_ =
        modulus_ * formula::ExactNumber::of(profile_.parameters().at("C").expr()) * factor;
}

void ExactContact::find_edges(const Load& load, const Ball& near_a, const Ball& near_b) {
    const formula::ExactNumber given = formula::ExactNumber::of(load.value.expr());
    const bool by_force = load.kind == Load::Kind::force;
    std::vector<formula::ExactNumber> guesses;
    if (!by_force) {
        guesses.push_back(given);
    } else if (power_law_) {
        a_ = whole_exponent_
                 ? pow(given / power_factor_, Rational(1, static_cast<int>(*whole_exponent_) + 1))
                 : formula::ExactNumber::unknown();
        b_ = a_;
        return;
    } else {
        // The candidates: a rational number, or the square root of one.
        if (const auto q = simplest_rational(near_a)) {
            guesses.emplace_back(*q);
        }
        if (const auto q = simplest_rational(near_a * near_a)) {
            guesses.push_back(sqrt(formula::ExactNumber(*q)));
        }
    }
    for (const formula::ExactNumber& a : guesses) {
        std::vector<formula::ExactNumber> others{a};
        if (!profile_.symmetric()) {
            if (const auto q = simplest_rational(near_b)) {
                others.emplace_back(*q);
            }
        }
        for (const formula::ExactNumber& b : others) {
            if (!overlaps(b.enclosure(near_b.bits()), near_b)) {
                continue;
            }
            a_ = a;
            b_ = b;
            place_knots();
            if ((profile_.symmetric() || balanced()) && (!by_force || force() == given)) {
                return;
            }
        }
    }
    a_ = by_force ? formula::ExactNumber::unknown() : given;
    b_ = formula::ExactNumber::unknown();
    placed_ = false;
}

void ExactContact::place_knots() {
    marks_.clear();
    placed_ = true;
    const Extent<formula::ExactNumber> e{a_, b_};
    for (const formula::ExactNumber& v : slope_.knots) {
        const auto from_right = (a_ - v).sign();
        const auto from_left = (b_ + v).sign();
        if (!from_right || !from_left) {
            placed_ = false;
            return;
        }
        marks_.push_back(*from_right <= 0  ? right_end(e)
                         : *from_left <= 0 ? left_end(e)
                                           : mark(e, v));
    }
}

template <class Kernel> formula::ExactNumber ExactContact::over_measure() const {
    return placed_ ? over_linear_measure<Kernel>(slope_, {a_, b_}, marks_)
                   : formula::ExactNumber::unknown();
}

bool ExactContact::balanced() const {
    return placed_ && linear_imbalance(slope_, {a_, b_}, marks_).is_zero();
}

formula::ExactNumber ExactContact::force() const {
    if (power_law_) {
        return whole_exponent_
                   ? power_factor_ * pow(a_, Rational(static_cast<int>(*whole_exponent_) + 1))
                   : formula::ExactNumber::unknown();
    }
    // moore-hills EQ22, by docs/mechanics.md, "One measure, six kernels"
    return modulus_ / 2 * over_measure<ForceKernel>();
}

formula::ExactNumber ExactContact::moment() const {
    if (profile_.symmetric()) {
        return {};
    }
    return modulus_ / 4 * over_measure<MomentKernel>();
}

bool ExactContact::bends(std::size_t knot) const {
    return !(slope_.rate(knot) == slope_.rate(knot + 1) &&
             slope_.pieces[knot].at_origin == slope_.pieces[knot + 1].at_origin);
}

formula::ExactNumber ExactContact::pressure(Edge edge, const formula::ExactNumber& u) const {
    const formula::ExactNumber other = length() - u;
    const formula::ExactNumber root = sqrt(u * other);
    if (power_law_) {
        if (!whole_exponent_ || *whole_exponent_ % 2 == 0) {
            return formula::ExactNumber::unknown(); // a logarithm
        }
        // p = P'(a)/pi I_m(|x|/a) (docs/pressure.md, "Closed form: power laws"). With
        // s^2 = q^2 + t^2 in the integral of s^m/sqrt(s^2 - q^2), m = 2j + 1, y = 1 - q^2:
        // I_m(q) = sum over i of C(j, i) q^(2j - 2i) y^(i + 1/2)/(2i + 1).
        const unsigned j = *whole_exponent_ / 2;
        const formula::ExactNumber y = u * other / (a_ * a_);
        const formula::ExactNumber square = formula::ExactNumber(1) - y;
        formula::ExactNumber sum;
        Rational binomial = 1;
        for (unsigned i = 0; i <= j; ++i) {
            sum += formula::ExactNumber(Rational(binomial / (2 * i + 1))) *
                   pow(square, Rational(j - i)) * pow(y, Rational(i));
            binomial = binomial * (j - i) / (i + 1);
        }
        const int m = static_cast<int>(*whole_exponent_);
        return power_factor_ * (m + 1) * pow(a_, Rational(m - 1)) / formula::ExactNumber::pi() *
               root * sum;
    }
    if (!placed_) {
        return formula::ExactNumber::unknown();
    }
    const formula::ExactNumber x = edge == Edge::right ? a_ - u : u - b_;
    for (std::size_t i = 0; i < slope_.knots.size(); ++i) {
        const bool on_it = (x - slope_.knots[i]).is_zero() && slope_.jump(i).is_zero();
        if (!marks_[i].end && bends(i) && !on_it) {
            return formula::ExactNumber::unknown(); // a logarithm
        }
    }
    // Without logarithms only the angles remain (docs/pressure.md, "Closed form: piecewise linear
    // slopes").
    const Extent<formula::ExactNumber> e{a_, b_};
    return modulus_ / (formula::ExactNumber::pi() * 2) * arc_of(slope_, e, marks_) * root;
}

std::vector<formula::ExactNumber> ExactContact::expansion(Edge, std::size_t terms) const {
    using S = series::Series<formula::ExactNumber>;
    const auto sign = a_.sign();
    if (terms > 0 && terms <= most_exact_coefficients && exponent_ && !whole_exponent_) {
        return vanishing_coefficients(terms);
    }
    const std::vector<formula::ExactNumber> none(terms, formula::ExactNumber::unknown());
    if (terms == 0 || terms > most_exact_coefficients || !profile_.symmetric() || !sign ||
        *sign <= 0 || (power_law_ ? !whole_exponent_ : !placed_)) {
        return none;
    }
    const S a = S::variable(a_, terms);
    S rate(formula::ExactNumber(0), terms);
    if (power_law_) {
        const auto m = static_cast<long>(*whole_exponent_);
        rate = pow_int(a, m) * (power_factor_ * static_cast<int>(m + 1));
    } else {
        const Extent<S> e{a, a};
        std::vector<Mark<S>> moving;
        for (std::size_t i = 0; i < marks_.size(); ++i) {
            const auto& end = marks_[i].end;
            moving.push_back(end ? end_mark(e, *end) : mark(e, slope_.knots[i]));
        }
        rate = over_linear_measure<RightRateKernel>(slope_, e, moving);
        rate *= modulus_ / 2;
    }
    // docs/expansions.md, "The right edge"
    return coefficients_of(right_edge_brackets(LawSeries<formula::ExactNumber>{rate, a}, a_),
                           length());
}

/// With dP/da = K a^m, c_k is K a^(m - k - 1/2) times its value for K = a = 1, which has an exact
/// form (docs/expansions.md, "The right edge").
std::vector<formula::ExactNumber> ExactContact::vanishing_coefficients(std::size_t terms) const {
    using formula::ExactNumber;
    using S = series::Series<ExactNumber>;
    const S a = S::variable(ExactNumber(1), terms);
    S rate(ExactNumber(0), terms);
    ExactNumber binomial(1); // m over k
    for (std::size_t k = 0; k < terms; ++k) {
        rate[k] = binomial;
        binomial *=
            ExactNumber(Rational((*exponent_ - static_cast<long>(k)) / (static_cast<long>(k) + 1)));
    }
    std::vector<ExactNumber> list = coefficients_of(
        right_edge_brackets(LawSeries<ExactNumber>{rate, a}, ExactNumber(1)), ExactNumber(2));
    for (ExactNumber& c : list) {
        c = c.is_zero() ? c : ExactNumber::unknown();
    }
    return list;
}

} // namespace edgeproof::contact
