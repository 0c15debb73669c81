// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/curved/curved_body.hpp"

#include "edgeproof/contact/curved/curved_slope.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/enclosure/rigorous_integral.hpp"
#include "edgeproof/formula/evaluation/complex_taylor.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace edgeproof::contact {
namespace {

constexpr long narrow_bits_of_radius = 48; ///< a radius with fewer bits is a range
constexpr long parts_of_range = 8;         ///< into which a coarse enclosure is divided

bool is_narrow(const Box& s) { return acb_rel_accuracy_bits(s.get()) >= narrow_bits_of_radius; }

/// The piece of g' to the right of a knot.
const Expr& slope_from(const Profile& profile, std::size_t knot) {
    return profile.pieces()[knot + 1].slope;
}

/// The integral of f over 0 < t < 1, or a coarse enclosure of it.
Box integral_or_range(const std::function<Box(const Box& t)>& f, bool narrow, long accuracy,
                      long bits) {
    if (narrow) {
        return inner_integral_of(f, {bits, accuracy, Ball(0, bits), Ball(1, bits)});
    }
    Box sum(bits);
    for (long i = 0; i < parts_of_range; ++i) {
        const Ball lo(Rational(i, parts_of_range), bits);
        const Ball hi(Rational(i + 1, parts_of_range), bits);
        sum = sum + f(Box(Ball::hull(lo, hi)));
    }
    return sum / Ball(parts_of_range, bits);
}

} // namespace

std::optional<Exact> CurvedBody::not_analytic_at(const Profile& profile) {
    constexpr long bits = 128;
    const auto finite = [&](std::size_t piece, const Ball& v) {
        const Ball apart = up_to(power_of_two(-100, bits));
        const Box near(v + apart, apart);
        AcbPolyValue taylor;
        formula::complex_taylor(taylor, profile.pieces()[piece].slope, near.get(), 2, bits);
        Box curvature(bits);
        acb_poly_get_coeff_acb(curvature.get(), taylor, 1);
        return curvature.is_finite();
    };
    for (std::size_t i = profile.origin(); i < profile.knots().size(); ++i) {
        const Ball v = formula::ball_of(profile.knots()[i], bits);
        if (!finite(i + 1, v) || (i > profile.origin() && !finite(i, v))) {
            return profile.knots()[i];
        }
    }
    return {};
}

CurvedBody::CurvedBody(const Profile& profile, const Exact& contact_modulus, const Load& load,
                       long bits)
    : RoundContact(profile, formula::enclosed_constant(contact_modulus, bits), bits) {
    for (std::size_t i = slope_.origin; i < slope_.knots.size(); ++i) {
        const Ball& v = slope_.knots[i];
        Ball jump(0, bits);
        if (profile.has_corner(i)) {
            jump = slope_series(slope_from(profile, i), v, 1, bits)[0];
            if (i > slope_.origin) {
                jump -= slope_series(profile.pieces()[i].slope, v, 1, bits)[0];
            }
        }
        rings_.push_back({v, std::move(jump), i});
    }
    carry(load);
}

CurvedBody::Start CurvedBody::start_for(Load::Kind kind, const Ball& given) const {
    return {kind == Load::Kind::approach ? near_radius(given, Integrand::slope)
                                         : near_radius(given / (modulus_ * 2), Integrand::moment),
            true};
}

std::unique_ptr<RoundContact> CurvedBody::resized(const Ball& a) const {
    auto body = std::make_unique<CurvedBody>(*this);
    body->move_edges(a, a);
    return body;
}

bool CurvedBody::begins_flat(const Ring& ring) const {
    const SlopePiece& piece = profile_.pieces()[ring.knot + 1];
    return piece.linear && certainly_zero(piece.linear->rate) && !profile_.has_corner(ring.knot);
}

Ball CurvedBody::minimum_end() const {
    const auto rises = std::find_if(rings_.begin(), rings_.end(),
                                    [&](const Ring& ring) { return !begins_flat(ring); });
    return rises == rings_.end() ? Ball(0, bits_) : rises->v;
}

Ball CurvedBody::near_radius(const Ball& given, Integrand of) const {
    constexpr long few_bits = 40;
    constexpr int most_halvings = 200;
    Ball lo(0, bits_);
    std::optional<Ball> hi;
    Ball s(1, bits_);
    for (int k = 0; k < most_halvings && !(hi && certainly_less(*hi * 63, lo * 64)); ++k) {
        const Ball found = over_rings(radius(s), of, few_bits).real();
        // Beyond the largest radius at which g' is defined, the integral is not finite.
        if (certainly_less(of == Integrand::slope ? found * s : found, given)) {
            lo = s;
        } else {
            hi = s;
        }
        s = middle(!hi ? s * 2 : certainly_positive(lo) ? (lo + *hi) / 2 : *hi / 2);
    }
    return s;
}

CurvedBody::Radius CurvedBody::radius(const Ball& s) const {
    Radius at{Box(s), {}};
    for (const Ring& ring : rings_) {
        if (on_edge_[ring.knot] || certainly_less(s, ring.v)) {
            break;
        }
        at.y.emplace_back(Field<Ball>::root(clamped(s - ring.v) * (s + ring.v)));
    }
    return at;
}

CurvedBody::Radius CurvedBody::radius(const Ball& A, std::optional<std::size_t> on,
                                      const Box& w) const {
    const Box w2 = w * w;
    Radius at{principal_root(w2 + A * A), {}};
    for (std::size_t i = 0; i < rings_.size(); ++i) {
        const Ball& v = rings_[i].v;
        if (on == i) {
            at.y.push_back(w);
            break;
        }
        if (!certainly_less(v, A)) {
            break;
        }
        at.y.push_back(principal_root(w2 + (A - v) * (A + v)));
    }
    return at;
}

CurvedBody::Radius CurvedBody::radius_near_edge(const Box& z) const {
    Radius at{z + a_, {}};
    for (const Ring& ring : rings_) {
        if (!inside(ring.knot)) {
            break;
        }
        at.y.push_back(principal_root((z + (a_ - ring.v)) * (z + (a_ + ring.v))));
    }
    return at;
}

Box CurvedBody::value(std::size_t ring, const Box& r, Integrand of) const {
    const SlopePiece& piece = profile_.pieces()[rings_[ring].knot + 1];
    AcbPolyValue taylor;
    formula::complex_taylor(taylor, piece.slope, r.get(), of == Integrand::rate ? 2 : 1, bits_);
    Box slope(bits_);
    acb_poly_get_coeff_acb(slope.get(), taylor, 0);
    if (of == Integrand::slope) {
        return slope;
    }
    if (of == Integrand::first_moment) {
        return slope * r;
    }
    if (of == Integrand::moment) {
        return slope * r * r;
    }
    Box curvature(bits_);
    acb_poly_get_coeff_acb(curvature.get(), taylor, 1);
    return slope + curvature * r;
}

Box CurvedBody::rate_over_radius(const Box& r) const {
    if (!r.contains_zero()) {
        return value(0, r, Integrand::rate) / r;
    }
    // A mean of the derivative, 2 g'' + r g''', over the way from the axis.
    const Box all = Box::hull(r, Box(Ball(0, bits_)));
    AcbPolyValue taylor;
    formula::complex_taylor(taylor, slope_from(profile_, rings_[0].knot), all.get(), 3, bits_);
    Box second(bits_);
    Box third(bits_);
    acb_poly_get_coeff_acb(second.get(), taylor, 1);
    acb_poly_get_coeff_acb(third.get(), taylor, 2);
    return (second + third * all) * Ball(2, bits_);
}

// docs/axisymmetric.md, "Curved slopes": r = s cos(psi)
Box CurvedBody::over_rings(const Radius& at, Integrand of, long accuracy) const {
    Box sum(bits_);
    const bool narrow = is_narrow(at.s);
    Box outer(Ball::pi(bits_) / 2);
    for (std::size_t i = 0; i < at.y.size(); ++i) {
        const bool last = i + 1 == at.y.size();
        const Box inner = last ? Box(bits_) : principal_arctangent(at.y[i + 1] / rings_[i + 1].v);
        const Box width = outer - inner;
        sum = sum +
              width * integral_or_range(
                          [&](const Box& t) { return value(i, at.s * cos(inner + width * t), of); },
                          narrow, accuracy, bits_);
        outer = inner;
    }
    return sum;
}

Box CurvedBody::rate_over_radius_at(const Box& s) const {
    const Ball quarter = Ball::pi(bits_) / 2;
    return integral_or_range(
               [&](const Box& t) {
                   const Box part = cos(t * quarter); // r/s
                   return rate_over_radius(s * part) * part;
               },
               is_narrow(s), bits_, bits_) *
           quarter;
}

Box CurvedBody::approach_rate(const Radius& at, std::optional<std::size_t> except) const {
    Box sum = over_rings(at, Integrand::rate, bits_);
    for (std::size_t i = 1; i < at.y.size(); ++i) {
        if (i != except && !contains_zero(rings_[i].jump)) {
            sum = sum + Box(rings_[i].jump * rings_[i].v) / at.y[i];
        }
    }
    return sum;
}

Ball CurvedBody::approach_rate_at(const Ball& s) const {
    return approach_rate(radius(s), {}).real();
}

Ball CurvedBody::approach_at(const Ball& s) const {
    return s * over_rings(radius(s), Integrand::slope, bits_).real();
}

Ball CurvedBody::force_at(const Ball& s) const {
    return modulus_ * 2 * over_rings(radius(s), Integrand::moment, bits_).real();
}

Ball CurvedBody::over_width(const Ball& r, const Ball& A, std::optional<std::size_t> on,
                            bool from_r, const Ball& W) const {
    const Ball apart = (A - r) * (A + r);
    const long known = std::min({W.relative_accuracy_bits(), A.relative_accuracy_bits(),
                                 (from_r ? r : apart).relative_accuracy_bits()});
    const long accuracy = useful_accuracy(known, bits_);
    const IntegralGoal goal{bits_, accuracy, Ball(0, bits_), Ball(1, bits_)};
    const bool on_axis = from_r && on == 0U;
    return W * integral_of(
                   [&](const Box& t) {
                       const Box w = t * W;
                       if (on_axis && contains_zero(rings_[0].jump)) {
                           return rate_over_radius_at(w);
                       }
                       const Radius at = radius(A, on, w);
                       if (from_r) {
                           return approach_rate(at, {}) / at.s;
                       }
                       const Box rate =
                           approach_rate(at, on) * w + rings_[*on].jump * rings_[*on].v;
                       return rate / (at.s * principal_root(w * w + apart));
                   },
                   goal);
}

// p near the axis, for g'(0) = 0: pi/E* times p is the integral of h'(s)/s over 0 < w < W. For the
// first w the integrand is enclosed over all s.
Ball CurvedBody::over_axis(const Ball& r, const Ball& W) const {
    const Ball most = upper_end(abs(r));
    const Ball first =
        middle(sqrt(most * W)) + most * 2 + middle(W) * power_of_two(-bits_ / 2, bits_);
    const Ball begin =
        first * rate_over_radius_at(Box(Ball::hull(Ball(0, bits_), first + most))).real();
    const Ball width = W - first;
    const IntegralGoal goal{bits_, useful_accuracy(W.relative_accuracy_bits(), bits_),
                            Ball(0, bits_), Ball(1, bits_)};
    return begin + width * integral_of(
                               [&](const Box& t) {
                                   const Box w = t * width + first;
                                   return rate_over_radius_at(principal_root(w * w + r * r));
                               },
                               goal);
}

Ball CurvedBody::pressure_at(const Ball& u, const Ball& other, const Ball& r,
                             std::optional<std::size_t> on) const {
    if (certainly_negative(u) || certainly_negative(other)) {
        throw DomainError("a point lies outside the contact");
    }
    Ball sum(0, bits_);
    Ball A = r;
    bool from_r = true;
    for (std::size_t i = on ? *on + 1 : 0;; ++i) {
        const bool last = i == rings_.size() || !inside(rings_[i].knot);
        if (!last && !certainly_less(A, rings_[i].v)) {
            if (certainly_less(rings_[i].v, A) || (i == 0 && contains_zero(rings_[0].jump))) {
                continue; // before r
            }
            return unknown_ball(bits_);
        }
        const Ball W = last && from_r ? Field<Ball>::root(clamped(u) * clamped(other))
                       : last         ? Field<Ball>::root(clamped(a_ - A) * (a_ + A))
                                      : sqrt((rings_[i].v - A) * (rings_[i].v + A));
        if (on && !contains_zero(rings_[*on].jump) && from_r) {
            return unknown_ball(bits_); // infinite at a corner
        }
        const bool flat =
            std::all_of(rings_.begin(), rings_.begin() + static_cast<std::ptrdiff_t>(i),
                        [&](const Ring& ring) { return begins_flat(ring); });
        if (!flat) { // h' is 0 up to the end of a flat
            sum += from_r && !on && contains_zero(r) ? over_axis(r, W)
                                                     : over_width(r, A, on, from_r, W);
        }
        if (last) {
            return modulus_ / Ball::pi(bits_) * sum;
        }
        A = rings_[i].v;
        on = i;
        from_r = false;
    }
}

Ball CurvedBody::pressure(Edge edge, const Exact& u) const {
    const Ball from = formula::enclosed_constant(u, bits_);
    std::optional<std::size_t> on;
    const Ball r = abs(a_ - from);
    if (const auto a = known(edge)) {
        const Expr x = a->expr() - u.expr();
        for (std::size_t i = 0; i < rings_.size(); ++i) {
            const Expr v = profile_.knots()[rings_[i].knot].expr();
            if (overlaps(r, rings_[i].v) && (certainly_zero(x - v) || certainly_zero(x + v))) {
                on = i;
            }
        }
    }
    return pressure_at(from, a_ * 2 - from, on ? rings_[*on].v : r, on);
}

Ball CurvedBody::pressure(Edge /*edge*/, const Ball& u) const {
    return pressure_at(u, a_ * 2 - u, abs(a_ - u), {});
}

BallSeries CurvedBody::pressure_series(Edge /*edge*/, const Ball& /*u*/, std::size_t order) const {
    return unknown_series(order, bits_);
}

} // namespace edgeproof::contact
