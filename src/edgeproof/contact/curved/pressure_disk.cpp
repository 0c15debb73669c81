// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/curved/pressure_disk.hpp"

#include "edgeproof/contact/curved/curved_slope.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/rigorous_integral.hpp"
#include "edgeproof/formula/evaluation/complex_taylor.hpp"
#include "edgeproof/precision/ball/arb_values.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace edgeproof::contact {
namespace {

constexpr long box_bits = 64;
constexpr slong most_box_bits = 1L << 20;
constexpr int most_radii = 24; ///< number of radii tried
constexpr long steepest = 256; ///< largest |g' - g0|/r of a disk, over the usual value of g''
constexpr int majorant_depth = 400;
constexpr long outer_bits = 48; ///< of an integral whose result is wide anyway

Ball exact_lower(const Ball& x) { return {x.with_bits(32).lower(), box_bits}; }

/// Returns the bits for a function over a box: enough to separate the box from a branch point,
/// which may be as near as the box is small.
long bits_over(const acb_t s) {
    const slong accuracy = acb_rel_accuracy_bits(s);
    return box_bits + std::clamp<slong>(accuracy, 0, most_box_bits);
}

/// Returns the variable of the formula of g' on a span.
const acb_struct* variable(const quadrature::ThetaPlace& at) {
    return at.span.root == 0 ? at.s : at.t;
}

/// Computes g' - g0.
void slope_change(acb_ptr change, const Expr& slope, const acb_t s, const Ball& g0, long bits) {
    AcbPolyValue taylor;
    complex_taylor(taylor, slope, s, 1, bits);
    acb_poly_get_coeff_acb(change, taylor, 0);
    acb_sub_arb(change, change, g0.data(), bits);
}

/// Returns the largest |g'(z) - g'(x)| for |z - x| <= r by the formula of a piece, with the disk
/// covered by boxes; infinite if the formula may not be holomorphic. g' is real on the real axis,
/// so that half of the disk suffices.
Magnitude largest_change(const Expr& slope, const Ball& x, const Ball& g0, const Ball& r) {
    constexpr int across = 3;
    AcbValue s;
    AcbValue change;
    Magnitude most;
    const Ball step = r / (2L * across) * Ball(Rational(1025, 1024), box_bits);
    for (int i = -across; i < across; ++i) {
        for (int j = 0; j < across; ++j) {
            const int near = i < 0 ? -i - 1 : i;
            if (near * near + j * j >= across * across) {
                continue;
            }
            acb_set_arb(s, Ball(x + step * (2 * i + 1)).data());
            arb_set(acb_imagref(s), Ball(step * (2 * j + 1)).data());
            arb_add_error(acb_realref(s), step.data());
            arb_add_error(acb_imagref(s), step.data());
            slope_change(change, slope, s, g0, bits_over(s));
            const Magnitude here(change);
            most = here <= most ? most : here;
            if (!most.is_finite()) {
                return most;
            }
        }
    }
    return most;
}

/// D_k(s) = (g'(s) - T_k(s))/(s - x)^(k+1) with the Taylor polynomial T_k of g' about x. Its
/// integral is the k-th coefficient of I about x (docs/curved-slopes.md, "Intervals and disks").
class DiskIntegrand : public quadrature::ThetaIntegrand {
public:
    /// g: Taylor coefficients about x, more than `terms`; r: the radius of a disk on which
    /// |g' - g_0| <= change.
    DiskIntegrand(const SlopeOverTheta& integral, std::size_t holds, const Ball& x,
                  std::vector<Ball> g, const Ball& r, const Magnitude& change, std::size_t terms,
                  long bits)
        : integral_(integral), holds_(holds), x_(x), g_(std::move(g)), near_(r / 2), far_(r / 4),
          terms_(terms), bits_(bits) {
        // |g_j| <= change/r^j by Cauchy's estimate, so that |D_k(s)| <= 2 change/r^(k+1)
        // for |s - x| <= r/2.
        const Magnitude least = Magnitude::least(r);
        Magnitude most = change + change;
        for (std::size_t k = 0; k < g_.size(); ++k) {
            most = most / least;
            near_bounds_.push_back(most);
            sizes_.emplace_back(g_[k]);
        }
    }
    [[nodiscard]] std::size_t count() const override { return terms_; }
    bool bound(const quadrature::ThetaPlace& at, std::vector<Magnitude>& most) const override {
        const std::size_t piece = at.span.piece;
        acb_ptr gap = gap_;
        acb_sub_arb(gap, at.s, x_.data(), bits_);
        if (piece == holds_ && Magnitude(gap) <= Magnitude::least(near_)) {
            std::copy_n(near_bounds_.begin(), terms_, most.begin());
            return true;
        }
        const Magnitude least = Magnitude::least(gap);
        if (least.is_zero() || (piece == holds_ && least <= Magnitude(far_))) {
            return false;
        }
        const acb_struct* t = variable(at);
        slope_change(change_, integral_.formulas[at.span.formula], t, g_[0], bits_over(t));
        Magnitude size(change_);
        if (!size.is_finite()) {
            if (arb_is_zero(acb_imagref(t)) == 0) {
                return false;
            }
            size = integral_.most_change;
        }
        for (std::size_t k = 0; k < terms_; ++k) {
            size = (k == 0 ? size : size + sizes_[k]) / least;
            most[k] = size;
        }
        return true;
    }
    void value(const quadrature::ThetaPlace& at, std::vector<Ball>& f) const override {
        Ball gap(0, bits_);
        arb_sub(gap.data(), acb_realref(at.s), x_.data(), bits_);
        if (at.span.piece == holds_ && Magnitude(gap) <= Magnitude::least(near_)) {
            Ball D = near_bounds_.back().ball(bits_);
            for (std::size_t k = g_.size(); --k > 0;) {
                D *= gap;
                D += g_[k];
                if (k <= terms_) {
                    f[k - 1] = D;
                }
            }
            return;
        }
        slope_change(change_, integral_.formulas[at.span.formula], variable(at), g_[0], bits_);
        Ball D(0, bits_);
        arb_set(D.data(), acb_realref(change_));
        const Ball inverse = 1 / gap;
        for (std::size_t k = 0; k < terms_; ++k) {
            if (k > 0) {
                D -= g_[k];
            }
            D *= inverse;
            f[k] = D;
        }
    }

private:
    const SlopeOverTheta& integral_;
    std::size_t holds_;
    const Ball& x_;
    std::vector<Ball> g_;
    Ball near_;
    Ball far_;
    std::size_t terms_;
    long bits_;
    std::vector<Magnitude> near_bounds_;
    std::vector<Magnitude> sizes_;
    mutable AcbValue gap_;
    mutable AcbValue change_;
};

/// Bounds |I(z)| for |z - x| <= reach by real cells of theta; nothing if the depth is not enough.
std::optional<Magnitude> majorant(const SlopeOverTheta& integral, std::size_t holds, const Ball& x,
                                  const Ball& g0, const Ball& r, const Ball& reach,
                                  const Magnitude& change) {
    struct Cell {
        Ball lo;
        Ball hi;
        int depth;
    };
    // |g'(z) - g'(x)| <= change |z - x|/r; and for |s - x| <= r/2, |z - x| <= 2 r/5 the quotient is
    // a sum over |g_j| of at most (10/3) change/r.
    const Magnitude near = Magnitude::least(r / 2);
    const Magnitude at_point = change * Magnitude(Ball(reach / r));
    const Magnitude quotient =
        change * Magnitude(Ball(10, 64)) / Magnitude(Ball(3, 64)) / Magnitude::least(r);
    Magnitude sum;
    AcbValue place;
    AcbValue value;
    for (const quadrature::ThetaSpan& span : integral.pieces) {
        // The radii of the ends are included; there the cells of two spans may overlap.
        std::vector<Cell> cells{{Ball(span.from.with_bits(box_bits).lower(), box_bits),
                                 Ball(span.to.with_bits(box_bits).upper(), box_bits), 0}};
        while (!cells.empty()) {
            const Cell cell = cells.back();
            cells.pop_back();
            const Ball theta = Ball::hull(cell.lo, cell.hi).with_bits(128);
            const Ball s = integral.centre + integral.half_length * cos(theta);
            const Ball gap = abs(Ball(s - x));
            const Magnitude length(Ball(cell.hi - cell.lo));
            if (span.piece == holds && Magnitude(gap) <= near) {
                sum = sum + length * quotient;
                continue;
            }
            const Ball from_disk = Ball(gap.with_bits(box_bits).lower(), box_bits) - reach;
            const Ball width(s.radius(), box_bits);
            if (certainly_positive(from_disk) && !certainly_less(from_disk, width)) {
                acb_set_arb(place, s.data());
                slope_change(value, integral.formulas[span.piece], place, g0, bits_over(place));
                Magnitude size(value);
                if (!(size <= integral.most_change)) {
                    size = integral.most_change;
                }
                sum = sum + length * (size + at_point) / Magnitude::least(from_disk);
                continue;
            }
            if (cell.depth == majorant_depth) {
                return {};
            }
            const Ball between = middle((cell.lo + cell.hi) / 2);
            cells.push_back({between, cell.hi, cell.depth + 1});
            cells.push_back({cell.lo, between, cell.depth + 1});
        }
    }
    return sum;
}

} // namespace

PressureDisk::PressureDisk(const SlopeOverTheta& integral, std::size_t holds, const Ball& x,
                           const Ball& gap, std::size_t terms, long bits)
    : terms_(terms), bits_(bits) {
    const Expr& slope = integral.formulas[holds];
    const std::vector<Ball> at_x = slope_series(slope, x, 2, bits);
    const Ball& g0 = at_x[0];
    if (!g0.is_finite() || !certainly_positive(gap)) {
        return;
    }
    const Magnitude mean = integral.most_change / Magnitude::least(integral.half_length * 2);
    const Magnitude at_centre(at_x[1]);
    const Magnitude usual = at_centre.is_finite() && mean <= at_centre ? at_centre : mean;
    // The largest disk where |g' - g0|/r is at most `steepest` times the mean of g'' over the
    // contact, or times g'' at the centre: near a branch point every disk is steeper than the mean.
    // If there is none, the smallest disk.
    std::optional<Ball> chosen;
    Magnitude change;
    Ball r = exact_lower(gap * 7 / 4);
    for (int k = 0; k < most_radii; ++k, r = exact_lower(r * 5 / 7)) {
        const Magnitude here = largest_change(slope, x, g0, r);
        if (!here.is_finite()) {
            continue;
        }
        chosen = r;
        change = here;
        if (change <= usual * Magnitude(r) * Magnitude(Ball(steepest, box_bits))) {
            break;
        }
    }
    if (!chosen) {
        return;
    }
    radius_ = min(exact_lower(gap * 7 / 10), exact_lower(*chosen * 2 / 5));
    const auto bound = majorant(integral, holds, x, g0, *chosen, radius_, change);
    if (!bound) {
        return;
    }
    bound_ = *bound;
    const long goal = disk_goal(bits);
    std::vector<Ball> g = slope_series(slope, x, terms + static_cast<std::size_t>(goal) + 8, bits);
    quadrature::ThetaGoal wanted{Magnitude(bound_.ball(box_bits) * power_of_two(-goal, box_bits)),
                                 {},
                                 static_cast<std::size_t>(goal / 4 + 8),
                                 2 * static_cast<int>(bits)};
    Magnitude scale(Ball(1, box_bits));
    for (std::size_t k = 0; k < terms; ++k) {
        wanted.scale.push_back(scale);
        scale = scale * Magnitude(radius_);
    }
    const DiskIntegrand integrand(integral, holds, x, std::move(g), *chosen, change, terms, bits);
    coefficients_ = integrate_cells(integrand, integral.spans, integral.centre,
                                    integral.half_length, wanted, bits);
    found_ = std::all_of(coefficients_.begin(), coefficients_.end(),
                         [](const Ball& c) { return c.is_finite(); });
}

BallSeries PressureDisk::at(const Ball& z, std::size_t order) const {
    std::vector<Ball> c;
    for (const Box& x : at(Box(z), order)) {
        c.push_back(x.real());
    }
    return BallSeries(c);
}

std::vector<Box> PressureDisk::at(const Box& z, std::size_t order) const {
    std::vector<Box> c;
    for (const Ball& x : coefficients_) {
        c.emplace_back(x.with_bits(bits_));
    }
    return taylor_at(std::move(c), radius_, bound_, z, order);
}

bool PressureDisk::good_to(const Ball& z, long bits) const {
    Ball q = abs(z) / radius_;
    arb_pow_ui(q.data(), q.data(), coefficients_.size(), box_bits);
    arb_mul_2exp_si(q.data(), q.data(), bits + 1);
    return certainly_less(q, Ball(1, box_bits));
}

Ball outer_integral(const SlopeOverTheta& integral, const std::vector<quadrature::ThetaSpan>& outer,
                    std::size_t holds, const Ball& x, long bits) {
    const Ball slope = slope_series(integral.formulas[holds], x, 1, bits)[0];
    // D_0 without a disk: no span contains x.
    const DiskIntegrand integrand(integral, integral.formulas.size(), x, {slope}, Ball(1, bits),
                                  Magnitude(), 1, bits);
    const quadrature::ThetaGoal goal{
        Magnitude(integral.most_change.ball(box_bits) / integral.half_length *
                  power_of_two(-outer_bits, box_bits)),
        {Magnitude(Ball(1, box_bits))},
        outer_bits / 4 + 4,
        2 * static_cast<int>(bits)};
    return integrate_cells(integrand, outer, integral.centre, integral.half_length, goal, bits)[0];
}

} // namespace edgeproof::contact
