// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/integrated_contact.hpp"

#include "edgeproof/contact/ball_contact.hpp"
#include "edgeproof/contact/ball_marks.hpp"
#include "edgeproof/contact/complex_taylor.hpp"
#include "edgeproof/formula/enclosure.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace edgeproof {
namespace {

Ball constant(const Exact& x, long bits) {
    if (x.is_rational()) {
        return Ball(x.rational(), bits);
    }
    const auto e = enclose(x.expr(), bits);
    if (!e) {
        throw BudgetError("'" + x.text() + "' cannot be enclosed");
    }
    return Ball::from_interval(e->lower, e->upper, bits);
}

/// What is integrated over theta, s = c + d cos theta: g'(s) cos(n theta), or with x given
/// (g'(s) - g'(x))/(s - x), or with a Taylor polynomial T_k of g' about the right edge a given
/// (g'(s) - T_k(s))/(s - a)^(k+1): what the former becomes at x = a, its k-th coefficient in x - a.
struct Integrand {
    const Expr* slope;
    Ball centre;
    Ball half_length;
    long harmonic = 0;
    const Ball* x = nullptr;
    const Ball* slope_at_x = nullptr;
    bool holds_x = false; ///< g' is this piece's at x too, so that the quotient has no pole
    const std::vector<Ball>* taylor = nullptr; ///< its k + 1 coefficients
};

/// (g'(s) - T_k(s))/(s - a)^(k+1), s - a = -2 d sin^2(theta/2).
void edge_quotient(acb_ptr out, const acb_t theta, const acb_t s, const Integrand& f, slong bits) {
    const auto terms = static_cast<slong>(f.taylor->size());
    acb_t r;
    acb_t power;
    acb_init(r);
    acb_init(power);
    acb_poly_t g;
    acb_poly_init(g);
    acb_mul_2exp_si(r, theta, -1);
    acb_sin(r, r, bits);
    acb_mul(r, r, r, bits);
    acb_mul_arb(r, r, f.half_length.data(), bits);
    acb_mul_si(r, r, -2, bits);
    if (f.holds_x && acb_contains_zero(r) != 0) {
        // A divided difference is a mean of the derivative over the hull of its points.
        acb_set_arb(power, f.x->data());
        acb_union(power, power, s, bits);
        complex_taylor(g, *f.slope, power, terms + 1, bits);
        acb_poly_get_coeff_acb(out, g, terms);
    } else {
        acb_t sum;
        acb_init(sum);
        for (slong k = terms; k-- > 0;) {
            acb_mul(sum, sum, r, bits);
            acb_add_arb(sum, sum, (*f.taylor)[static_cast<std::size_t>(k)].data(), bits);
        }
        complex_taylor(g, *f.slope, s, 1, bits);
        acb_poly_get_coeff_acb(out, g, 0);
        acb_sub(out, out, sum, bits);
        acb_pow_ui(power, r, static_cast<ulong>(terms), bits);
        acb_div(out, out, power, bits);
        acb_clear(sum);
    }
    acb_poly_clear(g);
    acb_clear(power);
    acb_clear(r);
}

int evaluate(acb_ptr out, const acb_t theta, void* parameter, slong, slong bits) {
    const auto& f = *static_cast<const Integrand*>(parameter);
    acb_t cosine;
    acb_t s;
    acb_init(cosine);
    acb_init(s);
    acb_poly_t g;
    acb_poly_init(g);
    acb_cos(cosine, theta, bits);
    acb_mul_arb(s, cosine, f.half_length.data(), bits);
    acb_add_arb(s, s, f.centre.data(), bits);
    if (f.taylor != nullptr) {
        edge_quotient(out, theta, s, f, bits);
    } else if (f.x == nullptr) {
        complex_taylor(g, *f.slope, s, 1, bits);
        acb_poly_get_coeff_acb(out, g, 0);
        acb_mul_si(cosine, theta, f.harmonic, bits);
        acb_cos(cosine, cosine, bits);
        acb_mul(out, out, cosine, bits);
    } else {
        acb_t gap;
        acb_init(gap);
        acb_sub_arb(gap, s, f.x->data(), bits);
        if (f.holds_x && acb_contains_zero(gap) != 0) {
            // The quotient is a mean of g'' over the way from x to s, which stays in their hull.
            acb_t hull;
            acb_init(hull);
            acb_set_arb(hull, f.x->data());
            acb_union(hull, hull, s, bits);
            complex_taylor(g, *f.slope, hull, 2, bits);
            acb_poly_get_coeff_acb(out, g, 1);
            acb_clear(hull);
        } else {
            complex_taylor(g, *f.slope, s, 1, bits);
            acb_poly_get_coeff_acb(out, g, 0);
            acb_sub_arb(out, out, f.slope_at_x->data(), bits);
            acb_div(out, out, gap, bits);
        }
        acb_clear(gap);
    }
    acb_poly_clear(g);
    acb_clear(s);
    acb_clear(cosine);
    return 0;
}

/// The integral from lo to hi: between their middles by Arb, and what their radii leave by the
/// largest value of the integrand over them.
Ball integrate(const Integrand& f, const Ball& lo, const Ball& hi, long bits) {
    acb_t from;
    acb_t to;
    acb_t sum;
    acb_t end;
    acb_init(from);
    acb_init(to);
    acb_init(sum);
    acb_init(end);
    arb_get_mid_arb(acb_realref(from), lo.data());
    arb_get_mid_arb(acb_realref(to), hi.data());
    mag_t tolerance;
    mag_init(tolerance);
    mag_set_ui_2exp_si(tolerance, 1, -bits - 64);
    auto* parameter = const_cast<Integrand*>(&f); // NOLINT: Arb's signature; never written to
    acb_calc_integrate(sum, evaluate, parameter, from, to, bits, tolerance, nullptr, bits);
    Ball result(0, bits);
    arb_set(result.data(), acb_realref(sum));
    for (const Ball* limit : {&lo, &hi}) {
        acb_set_arb(from, limit->data());
        evaluate(end, from, parameter, 0, bits);
        Ball rest(0, bits);
        arb_set(rest.data(), acb_realref(end));
        const Ball radius(limit->radius(), bits);
        result += rest * radius * Ball::from_interval(Real(-1), Real(1), bits);
    }
    mag_clear(tolerance);
    acb_clear(from);
    acb_clear(to);
    acb_clear(sum);
    acb_clear(end);
    return result;
}

} // namespace

/// A piece of g' as far as the contact reaches: theta from `from` to `to`.
struct IntegratedContact::Span {
    std::size_t piece;
    Ball from;
    Ball to;
};

bool IntegratedContact::handles(const Profile& profile, const Load& load) {
    return (load.kind == Load::Kind::right_edge || profile.symmetric()) &&
           std::all_of(profile.pieces().begin(), profile.pieces().end(),
                       [](const SlopePiece& piece) { return has_complex_taylor(piece.slope); });
}

IntegratedContact::IntegratedContact(const Profile& profile, const Exact& contact_modulus,
                                     const Load& load, long bits)
    : profile_(profile), load_(load), bits_(bits), modulus_(constant(contact_modulus, bits)) {
    for (const Exact& knot : profile.knots()) {
        knots_.push_back(constant(knot, bits));
    }
    if (load.kind == Load::Kind::right_edge) {
        a_ = constant(load.value, bits);
    }
    if (load.kind == Load::Kind::right_edge && profile.symmetric()) {
        b_ = a_;
    } else {
        enclose_edges(contact_modulus);
    }
}

std::vector<IntegratedContact::Span> IntegratedContact::spans(const Ball& a, const Ball& b) const {
    // From the right: theta = 0 at the right edge. A knot that may lie on an edge clamps onto it.
    std::vector<Span> list;
    Ball from(0, bits_);
    for (std::size_t i = knots_.size() + 1; i-- > 0;) {
        const BallMark next = i > 0 ? BallMark::at(a, b, knots_[i - 1]) : BallMark::left_end(a, b);
        const bool beyond_right = i > 0 && next.outside && contains_zero(next.right);
        if (beyond_right) {
            continue;
        }
        list.push_back({i, from, next.h});
        from = next.h;
        if (next.outside) {
            break;
        }
    }
    return list;
}

Ball IntegratedContact::slope_integral(const Ball& a, const Ball& b, long harmonic) const {
    Ball sum(0, bits_);
    for (const Span& span : spans(a, b)) {
        Integrand f{&profile_.pieces()[span.piece].slope, (a - b) / 2, (a + b) / 2};
        f.harmonic = harmonic;
        sum += integrate(f, span.from, span.to, bits_);
    }
    return sum;
}

/// P = (E*/2) times the integral of g'(s) (s - c)/w(s) ds.
Ball IntegratedContact::force_of(const Ball& a, const Ball& b) const {
    return modulus_ * (a + b) / 4 * slope_integral(a, b, 1);
}

Ball IntegratedContact::moment() const {
    if (profile_.symmetric()) {
        return {0, bits_};
    }
    // (E*/4) times the integral of w (v - c + 2c) dg'(v), by parts.
    const Ball d = (a_ + b_) / 2;
    return modulus_ / 4 * d *
           (d * slope_integral(a_, b_, 2) + (a_ - b_) * slope_integral(a_, b_, 1));
}

std::vector<Ball> IntegratedContact::expansion(Edge edge, std::size_t terms) const {
    if (edge == Edge::left && !profile_.symmetric()) {
        IntegratedContact mirror(*this);
        mirror.profile_ = profile_.reflected();
        mirror.knots_.clear();
        for (const Exact& knot : mirror.profile_.knots()) {
            mirror.knots_.push_back(constant(knot, bits_));
        }
        std::swap(mirror.a_, mirror.b_);
        return mirror.right_expansion(terms);
    }
    return right_expansion(terms);
}

std::vector<Ball> IntegratedContact::right_expansion(std::size_t terms) const {
    Ball unknown(0, bits_);
    arb_indeterminate(unknown.data());
    std::size_t last = 0; // the piece at the edge
    for (const Ball& knot : knots_) {
        if (certainly_less(knot, a_)) {
            ++last;
        } else if (!certainly_less(a_, knot)) {
            return std::vector<Ball>(terms, unknown);
        }
    }
    // p = (E*/(2 pi)) sqrt(u (D - u)) I(x), and I = sum of I_k (-u)^k.
    const std::vector<Ball> taylor = slope_series(last, a_, terms);
    std::vector<Ball> I;
    for (std::size_t k = 0; k < terms; ++k) {
        const std::vector<Ball> head(taylor.begin(),
                                     taylor.begin() + static_cast<std::ptrdiff_t>(k) + 1);
        Ball sum(0, bits_);
        for (const Span& span : spans(a_, b_)) {
            Integrand f{&profile_.pieces()[span.piece].slope, (a_ - b_) / 2, (a_ + b_) / 2};
            f.x = &a_;
            f.holds_x = span.piece == last;
            f.taylor = &head;
            sum += integrate(f, span.from, span.to, bits_);
        }
        I.push_back(k % 2 == 0 ? sum : -sum);
    }
    const Ball D = a_ + b_;
    std::vector<Ball> root{Ball(1, bits_)}; // of sqrt(1 - u/D)
    for (std::size_t k = 1; k < terms; ++k) {
        const long n = static_cast<long>(k);
        root.push_back(root.back() * (2 * n - 3) / (2 * n) / D);
    }
    const Ball scale = modulus_ / (Ball::pi(bits_) * 2) * sqrt(D);
    std::vector<Ball> c;
    for (std::size_t n = 0; n < terms; ++n) {
        Ball sum(0, bits_);
        for (std::size_t k = 0; k <= n; ++k) {
            sum += I[k] * root[n - k];
        }
        c.push_back(scale * sum);
    }
    return c;
}

void IntegratedContact::enclose_edges(const Exact& contact_modulus) {
    const auto digits = static_cast<unsigned>(bits_ * 3 / 10);
    const NormalContact guess(Profile(profile_), contact_modulus, Load(load_), digits);
    const bool by_force = load_.kind == Load::Kind::force;
    const Ball P = by_force ? constant(load_.value, bits_) : Ball(0, bits_);
    const Real start = by_force ? guess.a() : guess.b();
    // Positive where the trial edge lies too far in.
    const auto too_near = [&](const Ball& trial) {
        return by_force ? P - force_of(trial, trial) : slope_integral(a_, trial, 0);
    };
    for (long narrow = bits_ - 24; narrow > 8; narrow -= bits_ / 8) {
        const Ball middle(start, bits_);
        const Ball slack =
            abs(middle) * Ball(Rational(1, Integer(1) << static_cast<unsigned>(narrow)), bits_);
        const Ball lo(Ball(middle - slack).lower(), bits_);
        const Ball hi(Ball(middle + slack).upper(), bits_);
        if (certainly_positive(too_near(lo)) && certainly_negative(too_near(hi))) {
            b_ = Ball::hull(lo, hi);
            if (by_force) {
                a_ = b_;
            }
            return;
        }
    }
    throw BudgetError("ball arithmetic at " + std::to_string(bits_) +
                      " bits does not enclose an edge");
}

std::vector<Ball> IntegratedContact::slope_series(std::size_t piece, const Ball& x,
                                                  std::size_t terms) const {
    acb_t at;
    acb_t value;
    acb_poly_t g;
    acb_init(at);
    acb_init(value);
    acb_poly_init(g);
    acb_set_arb(at, x.data());
    complex_taylor(g, profile_.pieces()[piece].slope, at, static_cast<slong>(terms), bits_);
    std::vector<Ball> series;
    for (std::size_t k = 0; k < terms; ++k) {
        acb_poly_get_coeff_acb(value, g, static_cast<slong>(k));
        series.emplace_back(0, bits_);
        arb_set(series.back().data(), acb_realref(value));
    }
    acb_poly_clear(g);
    acb_clear(value);
    acb_clear(at);
    return series;
}

Ball IntegratedContact::pressure(Edge edge, const Exact& u) const {
    const Ball from_edge = constant(u, bits_);
    const Ball other = a_ + b_ - from_edge;
    if (certainly_negative(from_edge) || certainly_negative(other)) {
        throw DomainError("a point lies outside the contact");
    }
    const Ball x = edge == Edge::right ? a_ - from_edge : from_edge - b_;
    Ball unknown(0, bits_);
    arb_indeterminate(unknown.data());
    // The piece that x is on; on a knot where g' only bends, both that meet there have one value.
    std::size_t piece = 0;
    std::optional<std::size_t> on_knot;
    for (std::size_t i = 0; i < knots_.size(); ++i) {
        if (certainly_less(knots_[i], x)) {
            piece = i + 1;
        } else if (!certainly_less(x, knots_[i])) {
            const bool given = load_.kind == Load::Kind::right_edge &&
                               (edge == Edge::right || profile_.symmetric());
            const Expr& a = load_.value.expr();
            const Expr exactly = edge == Edge::right ? a - u.expr() : u.expr() - a;
            if (profile_.has_corner(i) || !given ||
                !certainly_zero(exactly - profile_.knots()[i].expr())) {
                return unknown;
            }
            on_knot = i;
            piece = i;
        }
    }
    const Ball slope = slope_series(piece, x, 1)[0];
    Ball sum(0, bits_);
    for (const Span& span : spans(a_, b_)) {
        Integrand f{&profile_.pieces()[span.piece].slope, (a_ - b_) / 2, (a_ + b_) / 2};
        // Of two pieces that meet at x, each by its own expression; their values there are equal.
        const Ball here =
            on_knot && span.piece == *on_knot + 1 ? slope_series(span.piece, x, 1)[0] : slope;
        f.x = &x;
        f.slope_at_x = &here;
        f.holds_x = span.piece == piece || (on_knot && span.piece == *on_knot + 1);
        sum += integrate(f, span.from, span.to, bits_);
    }
    return modulus_ / (Ball::pi(bits_) * 2) * sqrt(from_edge * other) * sum;
}

} // namespace edgeproof
