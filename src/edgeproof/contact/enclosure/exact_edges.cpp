// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/enclosure/exact_edges.hpp"

#include "edgeproof/contact/enclosure/ball_relative_error.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/law/linear_measure.hpp"
#include "edgeproof/formula/exact/identity.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::contact {
namespace {

/// With more knots the exact algebra would take too long.
constexpr std::size_t most_knots_in_symbols = 60;

formula::Expr whole(long k) { return formula::Expr::number(Rational(k)); }

/// The integrals of the law over dg' for exact a and b (docs/mechanics.md, "One measure, six
/// kernels").
class SymbolicLaw {
public:
    /// Throws BudgetError if the order of a knot and an edge cannot be decided.
    SymbolicLaw(const Profile& profile, formula::Expr a, formula::Expr b)
        : extent_{std::move(a), std::move(b)} {
        if (!profile.piecewise_linear() || profile.knots().size() > most_knots_in_symbols) {
            throw BudgetError("the law of this profile is not written in symbols");
        }
        slope_ = linear_slope<formula::Expr>(profile, [](const formula::Expr& e) { return e; });
        for (const formula::Expr& v : slope_.knots) {
            marks_.push_back(side(extent_.a - v) <= 0   ? right_end(extent_)
                             : side(v + extent_.b) <= 0 ? left_end(extent_)
                                                        : mark(extent_, v));
        }
    }

    /// The consistency condition (moore-hills EQ20): zero if the edges are in balance.
    [[nodiscard]] formula::Expr imbalance() const {
        return linear_imbalance(slope_, extent_, marks_);
    }
    /// P divided by E*/2 (moore-hills EQ22).
    [[nodiscard]] formula::Expr twice_force() const {
        return over_linear_measure<ForceKernel>(slope_, extent_, marks_);
    }

private:
    [[nodiscard]] static int side(const formula::Expr& e) {
        const auto sign = decided_sign(e);
        if (!sign) {
            throw BudgetError("a knot cannot be separated from an edge");
        }
        return *sign;
    }

    LinearSlope<formula::Expr> slope_;
    Extent<formula::Expr> extent_;
    std::vector<Mark<formula::Expr>> marks_;
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
std::vector<formula::Expr> candidates(const Ball& near, const std::vector<formula::Expr>& knots,
                                      long bits) {
    std::vector<formula::Expr> found;
    const Rational at = exact_value(near.midpoint());
    const Rational slack = abs(at) * power_of_two(-std::max(8L, bits / 4));
    for (const formula::Expr& knot : knots) {
        if (decided_sign(knot - formula::Expr::number(Rational(at - slack))) == 1 &&
            decided_sign(formula::Expr::number(Rational(at + slack)) - knot) == 1) {
            found.push_back(knot);
        }
    }
    if (const auto q = simple_rational(at, bits)) {
        found.push_back(formula::Expr::number(*q));
    }
    if (const auto q = simple_rational(exact_value((near / Ball::pi(bits)).midpoint()), bits)) {
        found.push_back(formula::Expr::number(*q) * formula::Expr::pi());
    }
    if (const auto q = simple_rational(at * at, bits)) {
        found.push_back(formula::Expr::call("sqrt", {formula::Expr::number(*q)}));
    }
    return found;
}

/// The distances of the knots on one side of the origin, in ascending order.
std::vector<formula::Expr> distances(const Profile& profile, Edge edge) {
    std::vector<formula::Expr> list;
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

} // namespace

bool odd_within(const Profile& profile, const formula::Expr& a) {
    if (profile.symmetric()) {
        return true;
    }
    if (profile.knots().size() > most_knots_in_symbols) {
        return false;
    }
    const std::vector<formula::Expr> right = distances(profile, Edge::right);
    const std::vector<formula::Expr> left = distances(profile, Edge::left);
    const std::size_t o = profile.origin();
    const formula::Expr x = formula::Expr::symbol("x");
    std::size_t i = 0; // number of knots passed on the right; j: on the left
    std::size_t j = 0;
    for (;;) {
        const formula::Expr& to_the_right = profile.pieces()[o + 1 + i].slope;
        const formula::Expr& to_the_left = profile.pieces()[o - j].slope;
        if (!proved_zero(to_the_right + substitute(to_the_left, "x", -x))) {
            return false;
        }
        // The next knots within the contact.
        const auto inside = [&](const std::vector<formula::Expr>& list, std::size_t k) {
            return k < list.size() ? decided_sign(a - list[k]) : std::optional<int>(0);
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
                                     : decided_sign(right[i] - left[j]);
        if (!order) {
            return false;
        }
        i += *order <= 0 ? 1 : 0;
        j += *order >= 0 ? 1 : 0;
    }
}

std::optional<ExactEdges> exact_edges(const Profile& profile, const formula::Exact& contact_modulus,
                                      const Load& load, const Ball& near_a, const Ball& near_b) {
    const long bits = near_b.bits();
    const bool given = load.kind == Load::Kind::right_edge;
    const std::vector<formula::Expr> on_left =
        candidates(near_b, distances(profile, Edge::left), bits);
    std::vector<formula::Expr> all_a{load.value.expr()};
    if (!given) {
        all_a = candidates(near_a, distances(profile, Edge::right), bits);
        if (overlaps(near_a, near_b)) { // b may be the mirror image of a knot
            all_a.insert(all_a.end(), on_left.begin(), on_left.end());
        }
    }
    for (const formula::Expr& a : all_a) {
        const bool odd = odd_within(profile, a);
        for (const formula::Expr& b : odd ? std::vector<formula::Expr>{a} : on_left) {
            try {
                if (given && odd && !profile.piecewise_linear()) {
                    return ExactEdges{load.value, formula::Exact(b)};
                }
                const SymbolicLaw law(profile, a, b);
                // A flat without force is in balance with any other edge on the flat.
                if (decided_sign(law.twice_force()) == 1 && (odd || proved_zero(law.imbalance())) &&
                    (given || proved_zero(load.value.expr() -
                                          contact_modulus.expr() / whole(2) * law.twice_force()))) {
                    return ExactEdges{given ? load.value : formula::Exact(a), formula::Exact(b)};
                }
            } catch (const Error&) {
                continue; // not decided
            }
        }
    }
    return std::nullopt;
}

} // namespace edgeproof::contact
