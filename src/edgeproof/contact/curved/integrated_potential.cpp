// SPDX-License-Identifier: BSD-3-Clause
// The Cauchy integral of the pressure over a curved slope, at points and over boxes
// (docs/stress.md, "Curved slopes").
#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/enclosure/rigorous_integral.hpp"
#include "edgeproof/contact/profile/slope.hpp"
#include "edgeproof/contact/stress/cauchy_integral.hpp"
#include "edgeproof/formula/evaluation/complex_taylor.hpp"
#include "edgeproof/precision/ball/arb_values.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace edgeproof::contact {
namespace {

constexpr std::size_t far_terms = 24;  ///< of the Taylor series that serve many boxes
constexpr long bits_of_searches = 128; ///< with more bits a place has a series of its own
constexpr std::size_t few_terms = 6;   ///< of such a series
constexpr long accuracy_of_searches = 48;

CauchyDerivatives unknown_derivatives(long bits) {
    const Box x = unknown_box(bits);
    return {x, x, x, x};
}

Box coefficient_of(const AcbPolyValue& p, std::size_t k, long bits) {
    Box c(bits);
    acb_poly_get_coeff_acb(c.get(), p, static_cast<slong>(k));
    return c;
}
std::vector<Box> coefficients_of(const AcbPolyValue& p, std::size_t terms, long bits) {
    std::vector<Box> c;
    for (std::size_t k = 0; k < terms; ++k) {
        c.push_back(coefficient_of(p, k, bits));
    }
    return c;
}
void set_coefficient(AcbPolyValue& p, std::size_t k, const Box& c) {
    acb_poly_set_coeff_acb(p, static_cast<slong>(k), c.get());
}

/// sqrt(c + rate t) in powers of t.
void root_series(AcbPolyValue& p, const Box& c, long rate, std::size_t terms) {
    set_coefficient(p, 0, c);
    acb_poly_set_coeff_si(p, 1, rate);
    acb_poly_sqrt_series(p, p, static_cast<slong>(terms), c.bits());
}

constexpr std::size_t derivatives = 4;

/// k! times the coefficients 0 ... 3.
CauchyDerivatives derivatives_of(const std::vector<Box>& c) {
    CauchyDerivatives d;
    long factorial = 1;
    for (std::size_t k = 0; k < derivatives; ++k) {
        factorial *= std::max(1L, static_cast<long>(k));
        d.at(k) = c[k] * Ball(factorial, c[k].bits());
    }
    return d;
}

/// The real and imaginary parts of (g'(s) - mean)/(zeta - s)^(k + 1), k = 0, 1, ... On a box that
/// is symmetric about the real axis each part extends to a holomorphic function of at most the size
/// of the quotient.
class PoleIntegrand : public quadrature::ThetaIntegrand {
public:
    PoleIntegrand(const SlopeOverTheta& integral, const Box& zeta, const Ball& mean,
                  std::size_t terms, long bits)
        : integral_(integral), zeta_(zeta), mean_(mean), terms_(terms), bits_(bits) {}
    [[nodiscard]] std::size_t count() const override { return 2 * terms_; }
    bool bound(const quadrature::ThetaPlace& at, std::vector<Magnitude>& most) const override {
        const Magnitude least = Magnitude::least((zeta_ - Box(at.s, bits_)).get());
        if (least.is_zero()) {
            return false;
        }
        Magnitude size(change(at).get());
        if (!size.is_finite()) {
            if (arb_is_zero(acb_imagref(at.t)) == 0) {
                return false;
            }
            size = integral_.most_change;
        }
        for (std::size_t k = 0; k < terms_; ++k) {
            size = size / least;
            most[2 * k] = most[2 * k + 1] = size;
        }
        return true;
    }
    void value(const quadrature::ThetaPlace& at, std::vector<Ball>& f) const override {
        const Box inverse = Box(Ball(1, bits_)) / (zeta_ - Box(at.s, bits_));
        Box all = change(at);
        for (std::size_t k = 0; k < terms_; ++k) {
            all = all * inverse;
            f[2 * k] = all.real();
            f[2 * k + 1] = all.imaginary();
        }
    }

private:
    [[nodiscard]] Box change(const quadrature::ThetaPlace& at) const {
        const bool root = at.span.root != 0;
        return slope_over(integral_.formulas[at.span.formula], Box(root ? at.t : at.s, bits_)) -
               mean_;
    }

    const SlopeOverTheta& integral_;
    const Box& zeta_;
    const Ball& mean_;
    std::size_t terms_;
    long bits_;
};

} // namespace

const IntegratedContact::FieldData& IntegratedContact::field_data() const {
    if (!field_data_) {
        auto made = std::make_shared<FieldData>();
        made->mean = zone_ ? slope_integral(a_, b_, 0) / Ball::pi(bits_) : Ball(0, bits_);
        made->force = force();
        made->steepest = steepest_rise(profile_, a_, b_).with_bits(bits_);
        field_data_ = std::move(made);
    }
    return *field_data_;
}

CauchyIntegral IntegratedContact::cauchy_integral(const Box& zeta,
                                                  const std::optional<Exact>& known_x) const {
    const Ball pi = Ball::pi(bits_);
    const Ball factor = modulus_ / 2;
    const Ball& mean = field_data().mean;
    const Ball x = zeta.real();
    const bool surface = arb_is_zero(zeta.imaginary().data()) != 0;
    if (surface && !certainly_less(a_, x) && !certainly_less(x, -b_)) {
        const Box unknown = unknown_box(bits_);
        for (const Edge edge : {Edge::right, Edge::left}) {
            const Ball off = edge == Edge::right ? a_ - x : x + b_;
            if (!contains_zero(off)) {
                continue;
            }
            const auto piece = edge_piece(edge);
            const Box slope(piece ? (series_of_slope(*piece, x, 1)[0] - mean) * pi
                                  : unknown_ball(bits_));
            if (off.is_exact()) { // p = 0
                return {slope * factor, unknown};
            }
            const Disk* const disk = piece ? disk_at_edge(edge) : nullptr;
            if (disk == nullptr || !disk->disk.found() ||
                !certainly_less(abs(off), disk->disk.radius())) {
                return {unknown, unknown};
            }
            const Ball W = sqrt(upper_end(abs(off)) * (length() + abs(off)));
            return {(slope + box_of_size(W * disk->disk.bound())) * factor, unknown};
        }
        const auto knot = knot_at(known_x);
        const auto piece = knot ? knot : piece_of(x);
        if (!piece) {
            return {unknown, unknown};
        }
        const Ball slope = series_of_slope(*piece, x, 1)[0] - mean;
        const Ball p = zone_pressure(Edge::right, a_ - x, known_x);
        return {Box(slope * pi * factor, -pi * p), unknown};
    }
    const Box root = root_outside({a_, b_}, zeta);
    const auto with_poles = [&](std::size_t poles) {
        return over_spans(a_, b_, [&](const SlopeOnSpan& on, const Box& t, const Box& s) {
            return on.over_distance(zeta, mean, poles, t, s);
        });
    };
    const Box once = with_poles(1);
    const Box twice = surface ? once : with_poles(2); // not used there
    return {root * once * factor, ((zeta - (a_ - b_) / 2) / root * once - root * twice) * factor};
}

std::vector<Ball> IntegratedContact::edge_slope(std::size_t terms) const {
    const auto piece = edge_piece(Edge::right);
    if (!piece) {
        return std::vector<Ball>(terms, unknown_ball(bits_));
    }
    std::vector<Ball> E = series_of_slope(*piece, a_, terms);
    E[0] -= field_data().mean;
    for (Ball& x : E) {
        x *= modulus_ * Ball::pi(bits_) / 2;
    }
    return E;
}

// A mean of the derivative over the way from the edge.
Box IntegratedContact::edge_slope_rate(const Ball& radius) const {
    const auto piece = edge_piece(Edge::right);
    if (!piece) {
        return unknown_box(bits_);
    }
    return holomorphic_series(profile_.pieces()[*piece].slope, box_of_size(radius) + a_, 2,
                              bits_)[1] *
           (modulus_ * Ball::pi(bits_) / 2);
}

// Off the contact: T = (E*/2) W M, where M has the coefficients (-1)^k times the integral of
// (g' - mean)/(zeta - s)^(k + 1) over theta. |T^(k)|/k! is at most P/d^(k + 1) at the distance d,
// which bounds the omitted terms.
IntegratedContact::Around
IntegratedContact::series_off_contact(const Box& centre, std::size_t terms, long accuracy) const {
    Around made{centre, distance_from({a_, b_}, centre), {}};
    const SlopeOverTheta& all = over_theta();
    const PoleIntegrand integrand(all, centre, field_data().mean, terms, bits_);
    quadrature::ThetaGoal goal{(all.most_change * Magnitude(power_of_two(-accuracy, 64))) /
                                   Magnitude::least(made.distance),
                               {},
                               static_cast<std::size_t>(accuracy / 4 + 8),
                               2 * static_cast<int>(bits_)};
    Magnitude scale(Ball(1, 64));
    for (std::size_t k = 0; k < terms; ++k) {
        goal.scale.insert(goal.scale.end(), 2, scale);
        scale = scale * Magnitude(made.distance);
    }
    const std::vector<Ball> parts =
        integrate_cells(integrand, all.spans, all.centre, all.half_length, goal, bits_);
    AcbPolyValue M;
    for (std::size_t k = 0; k < terms; ++k) {
        const Box m(parts[2 * k], parts[2 * k + 1]);
        set_coefficient(M, k, k % 2 == 0 ? m : -m);
    }
    AcbPolyValue right;
    AcbPolyValue left;
    const auto length = static_cast<slong>(terms);
    root_series(right, centre - a_, 1, terms);
    root_series(left, centre + b_, 1, terms);
    acb_poly_mullow(M, M, right, length, bits_);
    acb_poly_mullow(M, M, left, length, bits_);
    acb_poly_scalar_mul(M, M, Box(modulus_ / 2).get(), bits_);
    made.T = coefficients_of(M, terms, bits_);
    return made;
}

CauchyDerivatives IntegratedContact::off_contact(const Around& series, const Box& zeta) const {
    const Magnitude most(abs(field_data().force) / series.distance);
    return derivatives_of(
        taylor_at(series.T, series.distance, most, zeta - series.centre, derivatives));
}

// Next to the contact: T = (E*/2)(pi (g' - mean) - W I), W = i sqrt((a - zeta)(zeta + b)), with
// the power series of I about a place of the contact.
CauchyDerivatives IntegratedContact::near_contact(const Box& zeta) const {
    constexpr std::size_t order = derivatives;
    const Ball right = a_ - zeta.real();
    const Ball left = zeta.real() + b_;
    if (!certainly_positive(right) || !certainly_positive(left)) {
        return unknown_derivatives(bits_);
    }
    const Ball height = up_to(zeta.imaginary());
    const Ball u = right + height; // the disk is as high as it is wide
    const Ball x = zeta.real() + height;
    const auto piece = piece_of(x);
    const Disk* const disk = piece ? disk_for(Edge::right, u, order) : nullptr;
    if (disk == nullptr) {
        return unknown_derivatives(bits_);
    }
    AcbPolyValue T;
    AcbPolyValue root;
    AcbPolyValue other;
    AcbPolyValue I;
    const std::vector<Box> c = disk->disk.at(zeta - (a_ - disk->u), order);
    for (std::size_t k = 0; k < order; ++k) {
        set_coefficient(I, k, c[k]);
    }
    root_series(root, a_ - zeta, -1, order);
    root_series(other, zeta + b_, 1, order);
    acb_poly_mullow(root, root, other, order, bits_);
    acb_poly_mullow(root, root, I, order, bits_);
    complex_taylor(T, profile_.pieces()[*piece].slope, zeta.get(), order, bits_);
    const Box slope = coefficient_of(T, 0, bits_) - field_data().mean;
    set_coefficient(T, 0, slope);
    const Box turned(Ball(0, bits_), Ball(-1, bits_));
    acb_poly_scalar_mul(root, root, turned.get(), bits_);
    acb_poly_scalar_mul(T, T, Box(Ball::pi(bits_)).get(), bits_);
    acb_poly_add(T, T, root, bits_);
    acb_poly_scalar_mul(T, T, Box(modulus_ / 2).get(), bits_);
    return derivatives_of(coefficients_of(T, order, bits_));
}

CauchyDerivatives IntegratedContact::cauchy_derivatives(const Box& zeta) const {
    const Box middle = zeta.middle();
    const Ball size = upper_end(abs(zeta - middle));
    const Ball distance = distance_from({a_, b_}, middle);
    // one disk on the contact serves more boxes than a series off it
    const CauchyDerivatives near = near_contact(zeta);
    if (near[1].is_finite() || !certainly_less(size * 4, distance)) {
        return near;
    }
    if (bits_ > bits_of_searches) {
        return off_contact(series_off_contact(middle, few_terms, bits_), zeta);
    }
    for (const Around& known : field_data().around) {
        if (certainly_less(abs(zeta - known.centre) * 3, known.distance)) {
            return off_contact(known, zeta);
        }
    }
    field_data().around.push_back(series_off_contact(middle, far_terms, accuracy_of_searches));
    return off_contact(field_data().around.back(), zeta);
}

// Where T is not smooth. For any X of the contact T = (E*/2)(W N + pi (g'(X) - mean)), N the
// integral of (g'(s) - g'(X))/(zeta - s) over theta, and T' = (E*/2)(W' N + W N'). With the X
// nearest to x the quotient is at most the greatest g'', L, so that |N| <= pi L, z |N'| <= pi L,
// and |N'| <= L J, J the integral of 1/|zeta - s|. At the distance 2 r or more from both edges J <=
// 2 (1 + ln(r/z))/sqrt(r D/2) + pi/r, and T differs from its value at the top of a box by the
// integral of that.
CauchyBounds IntegratedContact::cauchy_bounds(const Box& zeta) const {
    const CauchyDerivatives smooth = cauchy_derivatives(zeta);
    if (smooth[1].is_finite()) {
        return {smooth[0], smooth[1] * zeta.imaginary()};
    }
    const Ball pi = Ball::pi(bits_);
    const Ball factor = modulus_ / 2;
    const Ball L = field_data().steepest;
    const Extent<Ball> e{a_, b_};
    const Ball W = upper_end(abs(root_above(e, zeta)));
    const Ball from_middle = upper_end(abs(zeta - (a_ - b_) / 2));
    const Ball top = upper_end(zeta.imaginary());
    const Ball breadth = up_to(Ball(zeta.real().radius(), bits_));
    const Ball r = lower_end(min(a_ - zeta.real(), zeta.real() + b_)) / 2;
    if (certainly_less((top + upper_end(breadth)) * 4, r) && certainly_positive(top)) {
        const Ball by_root = from_middle / lower_end(abs(root_above(e, zeta))) * pi; // |W' N|/L
        const Ball by_logarithm = W * 2 / sqrt(r * length() / 2);
        const Ball at_top =
            by_root + W * pi / r + by_logarithm * (log(r / top) + 1); // |T'| 2/(E* L)
        const Ball across = upper_end(breadth) * at_top;
        const Ball down = top * (at_top + by_logarithm);
        const Box start = cauchy_derivatives(Box(middle(zeta.real()), top))[0];
        return {start + box_of_size((across + down) * factor * L),
                box_of_size(top * (at_top + by_logarithm) * factor * L)};
    }
    const auto slope_at = [&](const Ball& x) { // at a point, which may be a knot
        if (const auto piece = piece_of(x)) {
            return series_of_slope(*piece, x, 1)[0];
        }
        Ball either = unknown_ball(bits_);
        for (std::size_t i = 0; i < slope_.knots.size(); ++i) {
            if (overlaps(x, slope_.knots[i])) {
                either = Ball::hull(series_of_slope(i, x, 1)[0], series_of_slope(i + 1, x, 1)[0]);
            }
        }
        return either;
    };
    const Ball X = max(min(zeta.real(), a_), -b_);
    const Ball slope = Ball::hull(slope_at(lower_end(X)), slope_at(upper_end(X)));
    return {(box_of_size(W * L) + (slope - field_data().mean)) * (pi * factor),
            box_of_size((from_middle * abs(depth_over_root(e, zeta)) + W) * pi * L * factor)};
}

} // namespace edgeproof::contact
