// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/batch/batch_integral.hpp"

#include "edgeproof/contact/law/linear_measure.hpp"
#include "edgeproof/formula/exact/identity.hpp"
#include "edgeproof/formula/parity.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/quadrature/tanh_sinh_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace edgeproof::contact {

namespace {

constexpr int first_level = 3;
constexpr int last_level = 12;

/// True if g - g(0) is proved to be odd, by its form or by exact algebra.
bool proved_odd(const Expr& slope) {
    if (formula::odd_but_for_a_constant(slope, "x")) {
        return true;
    }
    const Expr zero;
    const Expr mirrored = substitute(slope, "x", -Expr::symbol("x"));
    return formula::proved_zero(slope + mirrored - Expr::number(2) * substitute(slope, "x", zero));
}

/// Returns ln(1 + x).
Real log_one_plus(const Real& x) {
    const long bits = mpfr_get_prec(raw(x)) + 8;
    Real r;
    const Ball l = log1p(Ball(x, bits));
    arf_get_mpfr(raw(r), arb_midref(l.data()), MPFR_RNDN);
    return r;
}

} // namespace

BatchIntegral::BatchIntegral(const Profile& profile, const Real& modulus, const Extent<Real>& e,
                             unsigned digits, BatchPressure::Rule rule)
    : digits_(digits), rule_(rule), circle_(profile, e), slope_(profile),
      factor_(modulus / (2 * pi<Real>())), extent_(e) {
    const bool folded = circle_.folded;
    Real corners(0);
    const std::size_t count = circle_.pieces.size();
    for (std::size_t i = 0; i < count; ++i) {
        const bool origin = folded && i == 0;
        const std::size_t knot = origin ? profile.origin() : circle_.knots[i];
        if ((origin || i > 0) && profile.has_corner(knot)) {
            const Real& jump = slope_.jump(knot);
            corners += origin ? Real(jump / 2) : jump;
            const CircleMark& m = circle_.marks[i];
            const PrecisionScope fine(std::max(working_digits(), e.a.precision()));
            corners_.push_back({i, folded && !origin, jump, m.inset, Real(e.a + e.b - m.inset)});
        }
        const auto& piece = slope_.pieces()[circle_.pieces[i]];
        std::unique_ptr<CurvedSlope> curved;
        Real alpha(0);
        Real beta(0);
        bool odd = false;
        if (piece.linear) {
            beta = piece.rate;
            // Continued through the origin, G is odd, so that alpha is zero there but for roundoff.
            alpha = folded && i > 0 ? Real(piece.at_origin - corners) : Real(0);
        } else {
            const long bits = mpfr_get_prec(raw(corners)) + 40;
            const Ball offset = folded ? Ball(corners, bits) : Ball(0, bits);
            odd = origin && proved_odd(piece.expression);
            curved = std::make_unique<CurvedSlope>(slope_, circle_.pieces[i], offset, folded, bits);
        }
        pieces_.push_back(
            std::make_unique<BatchPiece>(circle_, i, alpha, beta, std::move(curved), odd));
    }
    Real rise(0);
    for (const auto& piece : pieces_) {
        rise += piece->rise;
    }
    S_exponent_ = exponent_of(circle_.length);
    G_exponent_ = exponent_of(rise);
    length_ = in_units(circle_.length, S_exponent_);
    for (const auto& piece : pieces_) {
        piece->measure(S_exponent_, G_exponent_);
        if (!piece->linear()) {
            piece->find_reach(G_exponent_,
                              -(static_cast<double>(digits_) + 4) * std::numbers::ln10);
        }
    }
    tasks_.resize(count);
}

RoutedPressure<Real> BatchIntegral::operator()(const Point<Real>& at) {
    nodes_ = 0;
    converged_ = true;
    locate(at);
    set_tasks();
    double ln_total = -1e300;
    for (const Task& task : tasks_) {
        ln_total = std::max(ln_total, task.ln_size);
    }
    const double ln_tolerance = ln_total - (digits_ + 3) * std::numbers::ln10 -
                                std::log(static_cast<double>(tasks_.size()));
    Real sum(0);
    for (std::size_t i = 0; i < tasks_.size(); ++i) {
        choose(i, ln_tolerance);
        add_share(sum, *pieces_[i], tasks_[i]);
    }
    double ln_error = -1e300;
    for (const Task& task : tasks_) {
        ln_error = std::max(ln_error, task.ln_error);
    }
    ln_error += std::log(static_cast<double>(tasks_.size())) +
                0.6931471805599453 * static_cast<double>(G_exponent_ - S_exponent_);
    // p = (E*/(2 pi)) (w(x) sum + corners), eqn:SIEPressure regularised (docs/pressure.md)
    Real value;
    mpfr_mul(raw(value), raw(at.right), raw(at.left), MPFR_RNDN);
    mpfr_sqrt(raw(value), raw(value), MPFR_RNDN);
    ln_error += quadrature::ln_size(value);
    value *= sum;
    if (!corners_.empty()) {
        value += corners(at);
    }
    RoutedPressure<Real> p;
    ln_error -= quadrature::ln_size(value);
    p.estimate = quadrature::from_ln_size(ln_error);
    p.value = value * factor_;
    p.evaluations = nodes_;
    p.converged = converged_ && ln_error < -static_cast<double>(digits_) * std::numbers::ln10;
    return p;
}

void BatchIntegral::locate(const Point<Real>& at) {
    const bool folded = circle_.folded;
    const bool mirrored = folded && at.x < 0;
    const Real& to_right = mirrored ? at.left : at.right;
    const Real& to_left = mirrored ? at.right : at.left;
    mpfr_set(raw(at_.x), raw(at.x), MPFR_RNDN);
    if (folded) {
        mpfr_abs(raw(at_.x), raw(at_.x), MPFR_RNDN);
        mpfr_mul(raw(at_.right), raw(at.right), raw(at.left), MPFR_RNDN);
        mpfr_sqr(raw(at_.left), raw(at_.x), MPFR_RNDN);
    } else {
        mpfr_set(raw(at_.right), raw(to_right), MPFR_RNDN);
        mpfr_set(raw(at_.left), raw(to_left), MPFR_RNDN);
    }
    // The steps from the marks follow from the smaller distance, which has its full relative
    // accuracy.
    const bool by_right = folded || to_right < to_left;
    const auto step_from = [&](std::size_t i, Real& step) {
        if (folded && i == 0) {
            mpfr_set(raw(step), raw(at_.x), MPFR_RNDN);
        } else if (by_right) {
            mpfr_sub(raw(step), raw(circle_.marks[i].inset), raw(to_right), MPFR_RNDN);
        } else {
            mpfr_sub(raw(step), raw(to_left), raw(circle_.marks[i].left), MPFR_RNDN);
        }
    };
    const std::size_t count = pieces_.size();
    at_.piece = count - 1;
    step_from(at_.piece, at_.step_lo);
    while (at_.piece > 0 && at_.step_lo < 0) {
        --at_.piece;
        step_from(at_.piece, at_.step_lo);
    }
    if (at_.piece + 1 == count) {
        mpfr_set(raw(at_.step_hi), raw(to_right), MPFR_RNDN);
    } else {
        step_from(at_.piece + 1, at_.step_hi);
        mpfr_neg(raw(at_.step_hi), raw(at_.step_hi), MPFR_RNDN);
    }
    if (!folded && at_.piece == 0) {
        mpfr_set(raw(at_.step_lo), raw(to_left), MPFR_RNDN);
    }
    const long exponent = S_exponent_;
    at_.phi = 2 * std::atan2(std::sqrt(in_units(at_.right, exponent)),
                             std::sqrt(in_units(at_.left, exponent)));
}

void BatchIntegral::set_tasks() {
    const std::size_t i = at_.piece;
    const BatchPiece& here = *pieces_[i];
    Task& inside = tasks_[i];
    inside.kind = Task::Kind::inside;
    inside.ln_error = -1e300;
    const auto from_lo = [&](Task& task) {
        task.gap = circle_.folded ? Real(at_.step_lo * (at_.x + here.lo->v)) : at_.step_lo;
        task.height = here.flat ? Real(0) : here.rise_from_lo(at_.x, at_.step_lo);
        task.step = at_.step_lo;
    };
    const auto from_hi = [&](Task& task) {
        task.gap = circle_.folded ? Real(at_.step_hi * (at_.x + here.hi->v)) : at_.step_hi;
        task.height = here.flat ? Real(0) : here.rise_to_hi(at_.x, at_.step_hi);
        task.step = at_.step_hi;
    };
    if (!here.linear()) {
        // The nearer end is used, so that the difference has no cancellation.
        inside.above = at_.step_hi < at_.step_lo;
        inside.above ? from_hi(inside) : from_lo(inside);
    }
    inside.ln_size = std::log(here.rise_units / here.span_units * here.angle_double);
    const auto go_on = [](Task& task, const Task& nearer, const BatchPiece& between) {
        mpfr_add(raw(task.gap), raw(nearer.gap), raw(between.span), MPFR_RNDN);
        mpfr_add(raw(task.height), raw(nearer.height), raw(between.rise), MPFR_RNDN);
        mpfr_add(raw(task.step), raw(nearer.step), raw(between.width), MPFR_RNDN);
    };
    const auto spread = [&](Task& task, const BatchPiece& piece) {
        task.ln_error = -1e300;
        const double gap = in_units(task.gap, S_exponent_);
        const double height = in_units(task.height, G_exponent_);
        task.ln_size = std::log((height + piece.rise_units / 2) / (gap + piece.span_units / 2) *
                                piece.angle_double);
    };
    for (std::size_t j = i; j-- > 0;) {
        Task& task = tasks_[j];
        task.above = true;
        if (j + 1 == i) {
            from_lo(task);
        } else {
            go_on(task, tasks_[j + 1], *pieces_[j + 1]);
        }
        spread(task, *pieces_[j]);
    }
    for (std::size_t j = i + 1; j < tasks_.size(); ++j) {
        Task& task = tasks_[j];
        task.above = false;
        if (j == i + 1) {
            from_hi(task);
        } else {
            go_on(task, tasks_[j - 1], *pieces_[j - 1]);
        }
        spread(task, *pieces_[j]);
    }
}

template <class Term>
void BatchIntegral::add_nodes(Real& sum, const BatchPiece& piece, Task& task, const Term& term) {
    if (!task.by_levels) {
        const BatchNodes& nodes = piece.gauss(task.n);
        term(sum, nodes);
        nodes_ += nodes.weight.size();
        return;
    }
    const double ln_tolerance = task.ln_error;
    const double ln_units = 0.6931471805599453 * static_cast<double>(G_exponent_ - S_exponent_);
    quadrature::LevelEstimate estimate;
    Real levels(0);
    Real value(0);
    bool done = false;
    for (int k = 0; k <= last_level && !done; ++k) {
        const BatchNodes& nodes = piece.level(k);
        term(levels, nodes);
        nodes_ += nodes.weight.size();
        value = levels * quadrature::TanhSinhNodes<Real>::step(k);
        task.ln_error = estimate.next(value) - ln_units;
        done = k > first_level && task.ln_error <= ln_tolerance;
    }
    converged_ = converged_ && done;
    sum += value;
}

void BatchIntegral::add_share(Real& sum, const BatchPiece& piece, Task& task) {
    using Kind = Task::Kind;
    if (piece.flat && (task.kind == Kind::inside || task.height == 0)) {
        task.ln_error = -1e300;
        return;
    }
    if (task.kind == Kind::far) {
        const auto& from = [&](const BatchNodes& n) -> const std::vector<Real>& {
            return task.above ? n.from_hi : n.from_lo;
        };
        const auto& lift = [&](const BatchNodes& n) -> const std::vector<Real>& {
            return task.above ? n.lift_hi : n.lift_lo;
        };
        // (G - G_x)/(S - S_x) = (height + rise)/(gap + from), and for a linear piece
        // = beta + (height - beta gap)/(gap + from).
        if (piece.constant_height(task.gap, task.height)) {
            const Real height =
                piece.flat ? task.height : Real(task.height - piece.beta * task.gap);
            Real quotients(0);
            add_nodes(quotients, piece, task, [&](Real& s, const BatchNodes& n) {
                sums_.add_quotients(s, n.weight, from(n), task.gap);
            });
            sum += piece.flat ? Real(height * quotients)
                              : Real(height * quotients + piece.beta * piece.angle);
        } else if (task.height == 0) {
            add_nodes(sum, piece, task, [&](Real& s, const BatchNodes& n) {
                sums_.add_quotients(s, lift(n), from(n), task.gap);
            });
        } else {
            add_nodes(sum, piece, task, [&](Real& s, const BatchNodes& n) {
                sums_.add_lifted(s, task.height, n.weight, lift(n), from(n), task.gap);
            });
        }
        return;
    }
    // With G_x by the formula of this piece the quotient has no pole; the difference of both G_x
    // times 1/(S - S_x) is added below.
    Real own(0); // G from the near end to x by the formula of this piece
    if (task.kind == Kind::near) {
        own = task.above ? piece.rise_to_hi(at_.x, Real(-task.step))
                         : piece.rise_from_lo(at_.x, Real(-task.step));
        own = -own;
    }
    if (piece.linear()) {
        sum += piece.beta * piece.angle;
        if (task.mirror_near) {
            sum += piece.alpha * mirror_integral(piece);
            task.ln_error = -1e300;
        } else if (circle_.folded && piece.alpha != 0) {
            Real quotients(0);
            add_nodes(quotients, piece, task, [&](Real& s, const BatchNodes& n) {
                sums_.add_quotients(s, n.weight, n.s, at_.x);
            });
            sum += piece.alpha * quotients;
        } else {
            task.ln_error = -1e300;
        }
    } else if (task.kind == Kind::inside) {
        add_nodes(sum, piece, task, [&](Real& s, const BatchNodes& n) {
            sums_.add_differences(s, n.weight, task.above ? n.rise_hi : n.rise_lo, task.height,
                                  task.above ? n.from_hi : n.from_lo, task.gap,
                                  [&](std::size_t k) { return quotient(piece, n, k); });
        });
    } else {
        add_nodes(sum, piece, task, [&](Real& s, const BatchNodes& n) {
            sums_.add_lifted(s, own, n.weight, task.above ? n.lift_hi : n.lift_lo,
                             task.above ? n.from_hi : n.from_lo, task.gap);
        });
    }
    if (task.kind == Kind::near && task.gap != 0) {
        sum += (task.height - own) * pole_integral(piece, task);
    }
}

Real BatchIntegral::quotient(const BatchPiece& piece, const BatchNodes& nodes,
                             std::size_t k) const {
    const Task& task = tasks_[at_.piece];
    const Real delta_S =
        task.above ? Real(task.gap - nodes.from_hi[k]) : Real(nodes.from_lo[k] - task.gap);
    const Real& x = at_.x;
    if (!circle_.folded) {
        return piece.curved->quotient(x, Real(x + delta_S), delta_S);
    }
    // ((s g(s) - x g(x))/(s - x))/(s + x), where g is g' without the corners.
    const Real& s = nodes.s[k];
    const Real q = piece.curved->quotient(x, s, Real(delta_S / (s + x)));
    const Real G = at_working_precision(piece.curved->G(Ball(x, 64)).midpoint());
    return Real((G / x + s * q) / (s + x));
}

// The closed forms: poles close to a piece, and corners.

/// Returns the integral of d phi/|S - S_x| over a piece that does not contain x, from
///   dG/dv = w(x)/(w(v) (x - v)) (docs/pressure.md, "Closed form: piecewise linear slopes").
Real BatchIntegral::pole_integral(const BatchPiece& piece, const Task& task) {
    const CircleMark& near = task.above ? *piece.hi : *piece.lo;
    const CircleMark& far = task.above ? *piece.lo : *piece.hi;
    const bool far_is_end = task.above ? piece.at_left_edge : piece.at_right_edge;
    if (at_.left == 0) {
        // x is in the middle of a folded contact, at the left end of the circle:
        // the integral of d phi/S is (2/length) tan(phi/2).
        return Real(2 / circle_.length *
                    (near.root_right / near.root_left -
                     (far_is_end ? Real(0) : Real(far.root_right / far.root_left))));
    }
    const Real root_right = sqrt(at_.right);
    const Real root_left = sqrt(at_.left);
    const auto logarithm = [&](const CircleMark& m, const Real& gap) {
        const Real root = m.root_right * root_left * root_right * m.root_left;
        return log_one_plus(
            Real(green_excess(Real(m.right * at_.left), Real(at_.right * m.left), root) /
                 (circle_.length * gap)));
    };
    Real l = logarithm(near, task.gap);
    if (!far_is_end) {
        l -= logarithm(far, Real(task.gap + piece.span));
    }
    return Real(l / (root_right * root_left));
}

/// Returns the integral of d phi/(s + x) over a piece of a folded contact, which is twice that of
/// ds/(w (s + x)).
Real BatchIntegral::mirror_integral(const BatchPiece& piece) const {
    const Real a = at_working_precision(extent_.a);
    const Real length = 2 * a;
    const Real to_right = a + at_.x; // from -x
    const Real to_left = at_.right / to_right;
    const auto logarithm = [&](const CircleMark& m) {
        // The distances from both edges of the unfolded contact.
        const Real left = a + m.v;
        const Real right = m.right / left;
        const Real p = right * to_left;
        const Real q = to_right * left;
        return log_one_plus(Real(green_excess(p, q, Real(m.root_right * sqrt(at_.right))) /
                                 (length * (m.v + at_.x))));
    };
    Real l = logarithm(*piece.lo);
    if (!piece.at_right_edge) {
        l -= logarithm(*piece.hi);
    }
    return Real(2 * l / sqrt(at_.right));
}

/// Returns the sum of jump times G(x, v) over the corners (docs/pressure.md, "Closed form:
/// piecewise linear slopes").
Real BatchIntegral::corners(const Point<Real>& at) {
    Real sum(0);
    const Real right = at_working_precision(at.right);
    const Real left = at_working_precision(at.left);
    const Real length = at_working_precision(extent_.length());
    for (const Corner& corner : corners_) {
        const auto excess = [&](const Real& v_right, const Real& v_left) {
            const bool by_right = at.right < at.left;
            const Real gap = at_working_precision(abs(circle_.marks[corner.mark].v == 0 ? at.x
                                                      : by_right ? Real(v_right - at.right)
                                                                 : Real(v_left - at.left)));
            if (gap == 0) {
                throw DomainError("the pressure is infinite at a corner of the profile");
            }
            const Real p = at_working_precision(v_right * left);
            const Real q = at_working_precision(right * v_left);
            return Real(green_excess(p, q, Real(sqrt(p) * sqrt(q))) / (length * gap));
        };
        Real e = excess(corner.right, corner.left);
        if (corner.pair) {
            const Real other = excess(corner.left, corner.right);
            e = e + other + e * other;
        }
        sum += corner.jump * log_one_plus(e);
    }
    return sum;
}

} // namespace edgeproof::contact
