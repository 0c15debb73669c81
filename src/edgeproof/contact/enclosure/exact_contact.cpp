// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/enclosure/exact_contact.hpp"

#include "edgeproof/algebra/identity.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/law/edge_expansion.hpp"
#include "edgeproof/contact/law/linear_measure.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/series/truncated.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace edgeproof::contact {

namespace {

/// With more knots the exact algebra would take too long.
constexpr std::size_t most_knots_in_symbols = 60;

/// The marks of the knots. Throws NoExactForm if the order of a knot and an edge is not decided.
std::vector<Mark<Form>> exact_marks(const LinearSlope<Form>& slope, const Extent<Form>& e) {
    std::vector<Mark<Form>> marks;
    for (const Form& v : slope.knots) {
        const auto from_right = algebra::decided_sign(Form(e.a - v).expr());
        const auto from_left = algebra::decided_sign(Form(e.b + v).expr());
        if (!from_right || !from_left) {
            throw NoExactForm();
        }
        marks.push_back(*from_right <= 0  ? right_end(e)
                        : *from_left <= 0 ? left_end(e)
                                          : mark(e, v));
    }
    return marks;
}

/// The simplest rational within the relative distance 2^-(bits/3) of q; nothing if it is not
/// simple.
std::optional<Rational> simple_rational(const Rational& q, long bits) {
    if (q <= 0) {
        return std::nullopt;
    }
    const Rational slack = q * power_of_two(-(bits / 3));
    const Rational near = simplest_between(Rational(q - slack), Rational(q + slack));
    const Integer smaller = std::min(numerator(near), denominator(near));
    return smaller >> static_cast<unsigned>(bits / 7) == 0 ? std::optional(near) : std::nullopt;
}

/// The exact numbers that an edge may be equal to: a knot, a simple rational, pi times one, or the
/// square root of one.
std::vector<Expr> candidates(const Ball& near, const std::vector<Expr>& knots, long bits) {
    std::vector<Expr> found;
    const Rational at = exact_value(near.midpoint());
    const Rational slack = abs(at) * power_of_two(-std::max(8L, bits / 4));
    for (const Expr& knot : knots) {
        if (algebra::decided_sign(knot - Expr::number(Rational(at - slack))) == 1 &&
            algebra::decided_sign(Expr::number(Rational(at + slack)) - knot) == 1) {
            found.push_back(knot);
        }
    }
    if (const auto q = simple_rational(at, bits)) {
        found.push_back(Expr::number(*q));
    }
    if (const auto q = simple_rational(exact_value((near / Ball::pi(bits)).midpoint()), bits)) {
        found.push_back(Expr::number(*q) * Expr::pi());
    }
    if (const auto q = simple_rational(at * at, bits)) {
        found.push_back(Expr::call("sqrt", {Expr::number(*q)}));
    }
    return found;
}

/// The distances of the knots right of the origin, in ascending order.
std::vector<Expr> distances(const Profile& profile) {
    std::vector<Expr> list;
    for (std::size_t i = profile.origin() + 1; i < profile.knots().size(); ++i) {
        list.push_back(profile.knots()[i].expr());
    }
    return list;
}

constexpr long most_exponent = 1000;
constexpr std::size_t most_exact_coefficients = 40;

} // namespace

bool odd_within(const Profile& profile, const Expr& a) {
    if (profile.symmetric()) {
        return true;
    }
    if (profile.knots().size() > most_knots_in_symbols) {
        return false;
    }
    const Profile mirror = profile.reflected();
    const std::vector<Expr> right = distances(profile);
    const std::vector<Expr> left = distances(mirror);
    std::size_t i = 0; // number of knots passed on the right; j: on the left
    std::size_t j = 0;
    for (;;) {
        if (!algebra::proved_zero(profile.pieces()[profile.origin() + 1 + i].slope -
                                  mirror.pieces()[mirror.origin() + 1 + j].slope)) {
            return false;
        }
        // The next knots within the contact.
        const auto inside = [&](const std::vector<Expr>& list, std::size_t k) {
            return k < list.size() ? algebra::decided_sign(a - list[k]) : std::optional<int>(0);
        };
        const auto r = inside(right, i);
        const auto l = inside(left, j);
        if (!r || !l) {
            return false;
        }
        if (*r <= 0 && *l <= 0) {
            return true;
        }
        const auto order = *r <= 0   ? std::optional<int>(1)
                           : *l <= 0 ? std::optional<int>(-1)
                                     : algebra::decided_sign(right[i] - left[j]);
        if (!order) {
            return false;
        }
        i += *order <= 0 ? 1 : 0;
        j += *order >= 0 ? 1 : 0;
    }
}

std::optional<ExactEdges> exact_edges(const Profile& profile, const Exact& contact_modulus,
                                      const Load& load, const Ball& near_a, const Ball& near_b) {
    const long bits = near_b.bits();
    const bool given = load.kind == Load::Kind::right_edge;
    const std::vector<Expr> on_left = candidates(near_b, distances(profile.reflected()), bits);
    std::vector<Expr> all_a{load.value.expr()};
    if (!given) {
        all_a = candidates(near_a, distances(profile), bits);
        if (overlaps(near_a, near_b)) { // b may be the mirror image of a knot
            all_a.insert(all_a.end(), on_left.begin(), on_left.end());
        }
    }
    for (const Expr& a : all_a) {
        const bool odd = odd_within(profile, a);
        for (const Expr& b : odd ? std::vector<Expr>{a} : on_left) {
            try {
                if (given && odd && !profile.piecewise_linear()) {
                    return ExactEdges{load.value, Exact(b)};
                }
                if (!profile.piecewise_linear() || profile.knots().size() > most_knots_in_symbols) {
                    return std::nullopt;
                }
                const auto slope = linear_slope<Form>(profile, exact_form);
                const Extent<Form> e{exact_form(a), exact_form(b)};
                const std::vector<Mark<Form>> marks = exact_marks(slope, e);
                const Form twice_force = over_linear_measure<ForceKernel>(slope, e, marks);
                // A flat without force is in balance with any other edge on the flat.
                if (algebra::decided_sign(twice_force.expr()) == 1 &&
                    (odd || linear_imbalance(slope, e, marks).is_zero()) &&
                    (given || exact_form(load.value.expr()) ==
                                  exact_form(contact_modulus.expr()) / 2 * twice_force)) {
                    return ExactEdges{given ? load.value : Exact(a), Exact(b)};
                }
            } catch (const Error&) {
                continue; // not decided
            }
        }
    }
    return std::nullopt;
}

std::optional<Rational> simplest_rational(const Ball& x) {
    if (!x.is_finite()) {
        return {};
    }
    if (contains_zero(x)) { // any integer may be the result of FLINT there
        return Rational(0);
    }
    return simplest_between(exact_value(x.lower()), exact_value(x.upper()));
}

Form exact_form(const Expr& e) {
    return algebra::form_of(e, [](std::string_view) -> Form { throw NoExactForm(); });
}

AlgebraicContact::AlgebraicContact(const Profile& profile, const Exact& contact_modulus,
                                   const Load& load, const Ball& near_a, const Ball& near_b)
    : profile_(profile), modulus_(exact_form(contact_modulus.expr())) {
    if (profile.kind() == Profile::Kind::power_law) {
        const auto m = exact_form(profile.parameters().at("m").expr()).rational();
        if (!m || *m > most_exponent) {
            throw NoExactForm();
        }
        exponent_ = m;
        const auto gamma = [](const Form& x) {
            return Form::call(formula::Builtin::gamma, {&x, 1});
        };
        const Form half = Form(*m) / 2;
        // moore-hills EQ11
        power_factor_ = modulus_ * exact_form(profile.parameters().at("C").expr()) *
                        sqrt(Form::pi()) / 2 * gamma(1 + half) / gamma(Form(Rational(3, 2)) + half);
    } else if (profile.piecewise_linear()) {
        slope_ = linear_slope<Form>(profile_, exact_form);
    } else {
        if (load.kind == Load::Kind::right_edge) {
            a_ = exact_form(load.value.expr());
            b_ = profile.symmetric() ? a_ : b_;
        }
        return;
    }
    find_edges(load, near_a, near_b);
}

const Form& AlgebraicContact::known(const std::optional<Form>& x) {
    return x ? *x : throw NoExactForm();
}

const std::vector<Mark<Form>>& AlgebraicContact::marks() const {
    return marks_.empty() ? throw NoExactForm() : marks_;
}

void AlgebraicContact::find_edges(const Load& load, const Ball& near_a, const Ball& near_b) {
    const Form given = exact_form(load.value.expr());
    const bool by_force = load.kind == Load::Kind::force;
    std::vector<Form> guesses;
    if (!by_force) {
        guesses.push_back(given);
    } else if (exponent_) {
        a_ = pow(given / power_factor_, Rational(1 / (*exponent_ + 1)));
        b_ = a_;
        return;
    } else {
        // The candidates: a rational number, or the square root of one.
        if (const auto q = simplest_rational(near_a)) {
            guesses.emplace_back(*q);
        }
        if (const auto q = simplest_rational(near_a * near_a)) {
            guesses.push_back(sqrt(Form(*q)));
        }
    }
    for (const Form& a : guesses) {
        std::vector<Form> others{a};
        if (!profile_.symmetric()) {
            if (const auto q = simplest_rational(near_b)) {
                others.emplace_back(*q);
            }
        }
        for (const Form& b : others) {
            a_ = a;
            b_ = b;
            if (overlaps(formula::enclosed_constant(b.expr(), near_b.bits()), near_b) &&
                holds(load)) {
                return;
            }
        }
    }
    a_ = by_force ? std::nullopt : std::optional(given);
    b_.reset();
    marks_.clear();
}

bool AlgebraicContact::holds(const Load& load) {
    try {
        marks_ = exact_marks(slope_, {*a_, *b_});
        for (const Mark<Form>& m : marks_) {
            if (!(m.h / Form::pi()).rational()) {
                return false; // sums of angles other than multiples of pi/12 would take too long
            }
        }
        return (profile_.symmetric() || linear_imbalance(slope_, {*a_, *b_}, marks_).is_zero()) &&
               (load.kind != Load::Kind::force || force() == exact_form(load.value.expr()));
    } catch (const Error&) {
        return false;
    }
}

template <class Kernel> Form AlgebraicContact::over_measure() const {
    return over_linear_measure<Kernel>(slope_, {a(), b()}, marks());
}

Form AlgebraicContact::force() const {
    // moore-hills EQ22, by docs/mechanics.md, "One measure, six kernels"
    return exponent_ ? power_factor_ * pow(a(), Rational(*exponent_ + 1))
                     : modulus_ / 2 * over_measure<ForceKernel>();
}

Form AlgebraicContact::moment() const {
    return profile_.symmetric() ? Form() : modulus_ / 4 * over_measure<MomentKernel>();
}

bool AlgebraicContact::bends(std::size_t knot) const {
    return !(slope_.rate(knot) == slope_.rate(knot + 1) &&
             slope_.pieces[knot].at_origin == slope_.pieces[knot + 1].at_origin);
}

Form AlgebraicContact::pressure(Edge edge, const Form& u) const {
    const Form other = length() - u;
    const Form root = sqrt(u * other);
    if (exponent_) {
        const Rational j = (*exponent_ - 1) / 2;
        if (denominator(j) != 1) {
            throw NoExactForm(); // a logarithm
        }
        // p = P'(a)/pi I_m(|x|/a) (docs/pressure.md, "Closed form: power laws"). With
        // s^2 = q^2 + t^2 in the integral of s^m/sqrt(s^2 - q^2), m = 2j + 1, y = 1 - q^2:
        // I_m(q) = sum over i of C(j, i) q^(2j - 2i) y^(i + 1/2)/(2i + 1).
        const Form y = u * other / (a() * a());
        const Form square = 1 - y;
        Form sum;
        Rational binomial = 1;
        for (int i = 0; i <= j; ++i) {
            sum += Form(Rational(binomial / (2 * i + 1))) * pow(square, Rational(j - i)) *
                   pow(y, Rational(i));
            binomial = binomial * (j - i) / (i + 1);
        }
        const Rational& m = *exponent_;
        return power_factor_ * Form(Rational(m + 1)) * pow(a(), Rational(m - 1)) / Form::pi() *
               root * sum;
    }
    const Form x = edge == Edge::right ? a() - u : u - b();
    for (std::size_t i = 0; i < slope_.knots.size(); ++i) {
        const bool on_it = (x - slope_.knots[i]).is_zero() && slope_.jump(i).is_zero();
        if (!marks()[i].end && bends(i) && !on_it) {
            throw NoExactForm(); // a logarithm
        }
    }
    // Without logarithms only the angles remain (docs/pressure.md, "Closed form: piecewise linear
    // slopes").
    const Extent<Form> e{a(), b()};
    return modulus_ / (2 * Form::pi()) * arc_of(slope_, e, marks()) * root;
}

std::vector<Form> AlgebraicContact::expansion(Edge, std::size_t terms) const {
    using S = series::Series<Form>;
    if (terms == 0 || terms > most_exact_coefficients || !profile_.symmetric()) {
        throw NoExactForm();
    }
    // docs/expansions.md, "The right edge"
    const auto coefficients = [](const S& rate, const S& a) {
        return coefficients_of(right_edge_brackets(LawSeries<S>{rate, a}, a[0]), a[0] * 2);
    };
    if (exponent_) {
        // With dP/da = K a^m, c_k is K a^(m - k - 1/2) times its value for K = a = 1.
        const S one = S::variable(Form(1), terms);
        std::vector<Form> list =
            coefficients(pow_with_constant(one, Form(*exponent_), Form(1)), one);
        Form factor = power_factor_ * Form(Rational(*exponent_ + 1)) *
                      pow(a(), Rational(*exponent_ - Rational(1, 2)));
        for (Form& c : list) {
            c *= factor;
            factor /= a();
        }
        return list;
    }
    const S a = S::variable(this->a(), terms);
    const Extent<S> e{a, a};
    std::vector<Mark<S>> moving;
    for (std::size_t i = 0; i < marks().size(); ++i) {
        const auto& end = marks_[i].end;
        moving.push_back(end ? end_mark(e, *end) : mark(e, slope_.knots[i]));
    }
    S rate = over_linear_measure<RightRateKernel>(slope_, e, moving);
    rate *= modulus_ / 2;
    return coefficients(rate, a);
}

} // namespace edgeproof::contact
