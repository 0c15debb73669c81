// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/enclosure/exact_contact.hpp"

#include "edgeproof/algebra/identity.hpp"
#include "edgeproof/contact/enclosure/ball_relative_error.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/law/edge_expansion.hpp"
#include "edgeproof/contact/law/linear_measure.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/series/functions.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace edgeproof::contact {

namespace {

/// With more knots the exact algebra would take too long.
constexpr std::size_t most_knots_in_symbols = 60;

Expr whole(long k) { return Expr::number(Rational(k)); }

/// The integrals of the law over dg' for exact a and b (docs/mechanics.md, "One measure, six
/// kernels").
class SymbolicLaw {
public:
    /// Throws BudgetError if the order of a knot and an edge cannot be decided.
    SymbolicLaw(const Profile& profile, Expr a, Expr b) : extent_{std::move(a), std::move(b)} {
        if (!profile.piecewise_linear() || profile.knots().size() > most_knots_in_symbols) {
            throw BudgetError("the law of this profile is not written in symbols");
        }
        slope_ = linear_slope<Expr>(profile, [](const Expr& e) { return e; });
        for (const Expr& v : slope_.knots) {
            marks_.push_back(side(extent_.a - v) <= 0   ? right_end(extent_)
                             : side(v + extent_.b) <= 0 ? left_end(extent_)
                                                        : mark(extent_, v));
        }
    }

    /// The consistency condition (moore-hills EQ20): zero if the edges are in balance.
    [[nodiscard]] Expr imbalance() const { return linear_imbalance(slope_, extent_, marks_); }
    /// P divided by E*/2 (moore-hills EQ22).
    [[nodiscard]] Expr twice_force() const {
        return over_linear_measure<ForceKernel>(slope_, extent_, marks_);
    }

private:
    [[nodiscard]] static int side(const Expr& e) {
        const auto sign = algebra::decided_sign(e);
        if (!sign) {
            throw BudgetError("a knot cannot be separated from an edge");
        }
        return *sign;
    }

    LinearSlope<Expr> slope_;
    Extent<Expr> extent_;
    std::vector<Mark<Expr>> marks_;
};

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

/// The distances of the knots on one side of the origin, in ascending order.
std::vector<Expr> distances(const Profile& profile, Edge edge) {
    std::vector<Expr> list;
    const std::size_t o = profile.origin();
    if (edge == Edge::right) {
        for (std::size_t i = o + 1; i < profile.knots().size(); ++i) {
            list.push_back(profile.knots()[i].expr());
        }
    } else {
        for (std::size_t i = o; i-- > 0;) {
            list.push_back(-profile.knots()[i].expr());
        }
    }
    return list;
}

constexpr long most_whole_exponent = 1000;
constexpr std::size_t most_exact_coefficients = 40;

} // namespace

bool odd_within(const Profile& profile, const Expr& a) {
    if (profile.symmetric()) {
        return true;
    }
    if (profile.knots().size() > most_knots_in_symbols) {
        return false;
    }
    const std::vector<Expr> right = distances(profile, Edge::right);
    const std::vector<Expr> left = distances(profile, Edge::left);
    const std::size_t o = profile.origin();
    const Expr x = Expr::symbol("x");
    std::size_t i = 0; // number of knots passed on the right; j: on the left
    std::size_t j = 0;
    for (;;) {
        const Expr& to_the_right = profile.pieces()[o + 1 + i].slope;
        const Expr& to_the_left = profile.pieces()[o - j].slope;
        if (!algebra::proved_zero(to_the_right + substitute(to_the_left, "x", -x))) {
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
    const std::vector<Expr> on_left = candidates(near_b, distances(profile, Edge::left), bits);
    std::vector<Expr> all_a{load.value.expr()};
    if (!given) {
        all_a = candidates(near_a, distances(profile, Edge::right), bits);
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
                const SymbolicLaw law(profile, a, b);
                // A flat without force is in balance with any other edge on the flat.
                if (algebra::decided_sign(law.twice_force()) == 1 &&
                    (odd || algebra::proved_zero(law.imbalance())) &&
                    (given ||
                     algebra::proved_zero(load.value.expr() -
                                          contact_modulus.expr() / whole(2) * law.twice_force()))) {
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

ExactNumberContact::ExactNumberContact(const Profile& profile, const Exact& contact_modulus,
                                       const Load& load, const Ball& near_a, const Ball& near_b)
    : profile_(profile), modulus_(ExactNumber::of(contact_modulus.expr())),
      power_law_(profile.kind() == Profile::Kind::power_law), a_(ExactNumber::unknown()),
      b_(ExactNumber::unknown()) {
    if (power_law_) {
        read_power_law();
    } else if (profile.piecewise_linear()) {
        slope_ = linear_slope<ExactNumber>(profile_, ExactNumber::of);
    } else {
        power_factor_ = ExactNumber::unknown();
        if (load.kind == Load::Kind::right_edge) {
            a_ = ExactNumber::of(load.value.expr());
            b_ = profile.symmetric() ? a_ : b_;
        }
        return;
    }
    find_edges(load, near_a, near_b);
}

void ExactNumberContact::read_power_law() {
    const auto m = ExactNumber::of(profile_.parameters().at("m").expr()).rational();
    power_factor_ = ExactNumber::unknown();
    exponent_ = m;
    if (!m || denominator(*m) != 1 || *m > most_whole_exponent) {
        return;
    }
    const auto n = static_cast<unsigned>(numerator(*m).convert_to<unsigned long>());
    whole_exponent_ = n;
    // sqrt(pi)/2 Gamma(1 + m/2)/Gamma((3 + m)/2) (moore-hills EQ11) is 1 for m = 0 and pi/4 for
    // m = 1. A step of m by 2 multiplies it by (m + 2)/(m + 3).
    ExactNumber factor = n % 2 == 0 ? ExactNumber(1) : ExactNumber::pi() / 4;
    for (unsigned k = n % 2; k < n; k += 2) {
        factor *= ExactNumber(Rational(k + 2, k + 3));
    }
    power_factor_ = modulus_ * ExactNumber::of(profile_.parameters().at("C").expr()) * factor;
}

void ExactNumberContact::find_edges(const Load& load, const Ball& near_a, const Ball& near_b) {
    const ExactNumber given = ExactNumber::of(load.value.expr());
    const bool by_force = load.kind == Load::Kind::force;
    std::vector<ExactNumber> guesses;
    if (!by_force) {
        guesses.push_back(given);
    } else if (power_law_) {
        a_ = whole_exponent_
                 ? pow(given / power_factor_, Rational(1, static_cast<int>(*whole_exponent_) + 1))
                 : ExactNumber::unknown();
        b_ = a_;
        return;
    } else {
        // The candidates: a rational number, or the square root of one.
        if (const auto q = simplest_rational(near_a)) {
            guesses.emplace_back(*q);
        }
        if (const auto q = simplest_rational(near_a * near_a)) {
            guesses.push_back(sqrt(ExactNumber(*q)));
        }
    }
    for (const ExactNumber& a : guesses) {
        std::vector<ExactNumber> others{a};
        if (!profile_.symmetric()) {
            if (const auto q = simplest_rational(near_b)) {
                others.emplace_back(*q);
            }
        }
        for (const ExactNumber& b : others) {
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
    a_ = by_force ? ExactNumber::unknown() : given;
    b_ = ExactNumber::unknown();
    placed_ = false;
}

void ExactNumberContact::place_knots() {
    marks_.clear();
    placed_ = true;
    const Extent<ExactNumber> e{a_, b_};
    for (const ExactNumber& v : slope_.knots) {
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

template <class Kernel> ExactNumber ExactNumberContact::over_measure() const {
    return placed_ ? over_linear_measure<Kernel>(slope_, {a_, b_}, marks_) : ExactNumber::unknown();
}

bool ExactNumberContact::balanced() const {
    return placed_ && linear_imbalance(slope_, {a_, b_}, marks_).is_zero();
}

ExactNumber ExactNumberContact::force() const {
    if (power_law_) {
        return whole_exponent_
                   ? power_factor_ * pow(a_, Rational(static_cast<int>(*whole_exponent_) + 1))
                   : ExactNumber::unknown();
    }
    // moore-hills EQ22, by docs/mechanics.md, "One measure, six kernels"
    return modulus_ / 2 * over_measure<ForceKernel>();
}

ExactNumber ExactNumberContact::moment() const {
    if (profile_.symmetric()) {
        return {};
    }
    return modulus_ / 4 * over_measure<MomentKernel>();
}

bool ExactNumberContact::bends(std::size_t knot) const {
    return !(slope_.rate(knot) == slope_.rate(knot + 1) &&
             slope_.pieces[knot].at_origin == slope_.pieces[knot + 1].at_origin);
}

ExactNumber ExactNumberContact::pressure(Edge edge, const ExactNumber& u) const {
    const ExactNumber other = length() - u;
    const ExactNumber root = sqrt(u * other);
    if (power_law_) {
        if (!whole_exponent_ || *whole_exponent_ % 2 == 0) {
            return ExactNumber::unknown(); // a logarithm
        }
        // p = P'(a)/pi I_m(|x|/a) (docs/pressure.md, "Closed form: power laws"). With
        // s^2 = q^2 + t^2 in the integral of s^m/sqrt(s^2 - q^2), m = 2j + 1, y = 1 - q^2:
        // I_m(q) = sum over i of C(j, i) q^(2j - 2i) y^(i + 1/2)/(2i + 1).
        const unsigned j = *whole_exponent_ / 2;
        const ExactNumber y = u * other / (a_ * a_);
        const ExactNumber square = ExactNumber(1) - y;
        ExactNumber sum;
        Rational binomial = 1;
        for (unsigned i = 0; i <= j; ++i) {
            sum += ExactNumber(Rational(binomial / (2 * i + 1))) * pow(square, Rational(j - i)) *
                   pow(y, Rational(i));
            binomial = binomial * (j - i) / (i + 1);
        }
        const int m = static_cast<int>(*whole_exponent_);
        return power_factor_ * (m + 1) * pow(a_, Rational(m - 1)) / ExactNumber::pi() * root * sum;
    }
    if (!placed_) {
        return ExactNumber::unknown();
    }
    const ExactNumber x = edge == Edge::right ? a_ - u : u - b_;
    for (std::size_t i = 0; i < slope_.knots.size(); ++i) {
        const bool on_it = (x - slope_.knots[i]).is_zero() && slope_.jump(i).is_zero();
        if (!marks_[i].end && bends(i) && !on_it) {
            return ExactNumber::unknown(); // a logarithm
        }
    }
    // Without logarithms only the angles remain (docs/pressure.md, "Closed form: piecewise linear
    // slopes").
    const Extent<ExactNumber> e{a_, b_};
    return modulus_ / (ExactNumber::pi() * 2) * arc_of(slope_, e, marks_) * root;
}

std::vector<ExactNumber> ExactNumberContact::expansion(Edge, std::size_t terms) const {
    using S = series::Series<ExactNumber>;
    const auto sign = a_.sign();
    if (terms > 0 && terms <= most_exact_coefficients && exponent_ && !whole_exponent_) {
        return vanishing_coefficients(terms);
    }
    const std::vector<ExactNumber> none(terms, ExactNumber::unknown());
    if (terms == 0 || terms > most_exact_coefficients || !profile_.symmetric() || !sign ||
        *sign <= 0 || (power_law_ ? !whole_exponent_ : !placed_)) {
        return none;
    }
    const S a = S::variable(a_, terms);
    S rate(ExactNumber(0), terms);
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
    return coefficients_of(right_edge_brackets(LawSeries<ExactNumber>{rate, a}, a_), length());
}

/// With dP/da = K a^m, c_k is K a^(m - k - 1/2) times its value for K = a = 1, which has an exact
/// form (docs/expansions.md, "The right edge").
std::vector<ExactNumber> ExactNumberContact::vanishing_coefficients(std::size_t terms) const {
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
