// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/batch/batch_integral.hpp"
#include "edgeproof/quadrature/holomorphic_reach.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

/// The error control of the Gauss-Legendre rule: it decides which poles are subtracted, and how
/// many nodes the other pieces need, by ellipses in which the integrand is holomorphic and bounded
/// (docs/pressure.md, "Many points of one contact"; trefethen2013, theorem 19.3).
namespace edgeproof::contact {
namespace {

constexpr double pi_double = std::numbers::pi;
/// A pole is subtracted if ln(rho) of its ellipse is below this (for a doubled piece: 2 ln(rho)):
/// the error of the Gauss rule then decreases too slowly with the number of nodes.
constexpr double slow = 1.1;

} // namespace

double BatchIntegral::pole_excess(const BatchPiece& piece, const Task& task) const {
    const double end = task.above ? piece.phi_right : piece.phi_right + piece.angle_double;
    const double between = std::sin((end + at_.phi) / 2);
    // The angle follows from the distance in S, which is accurate even if the angles are nearly
    // equal (DLMF 4.21.9).
    const double near =
        2 * std::asin(std::min(1.0, in_units(task.gap, S_exponent_) / (length_ * between)));
    const double other = task.above ? 2 * pi_double - at_.phi - piece.phi_right - piece.angle_double
                                    : at_.phi + piece.phi_right;
    return std::min(near, other);
}

void BatchIntegral::choose(std::size_t i, double ln_tolerance) {
    const BatchPiece& piece = *pieces_[i];
    Task& task = tasks_[i];
    task.by_levels = rule_ == BatchPressure::Rule::tanh_sinh || (!piece.linear() && !piece.reach);
    task.n = 0;
    task.mirror_near = false;
    if (i != at_.piece) {
        const double excess = pole_excess(piece, task);
        const double half = piece.doubled ? piece.angle_double : piece.angle_double / 2;
        const bool known =
            piece.linear() || (piece.reach && excess < piece.reach->ellipse.excess() / 2);
        const double rate = std::log(quadrature::BernsteinEllipse::beyond(half, excess).rho) *
                            (piece.doubled ? 2 : 1);
        const bool close = task.by_levels ? excess < piece.angle_double / 8 : rate < slow;
        task.kind = known && close ? Task::Kind::near : Task::Kind::far;
        if (task.kind == Task::Kind::far) {
            if (task.by_levels) {
                task.ln_error = ln_tolerance;
            } else {
                choose_far(piece, task, excess, ln_tolerance);
            }
            return;
        }
    }
    if (task.by_levels) {
        task.ln_error = ln_tolerance;
        task.mirror_near =
            piece.linear() && circle_.folded && piece.alpha != 0 &&
            2 * pi_double - at_.phi - piece.phi_right - piece.angle_double < piece.angle_double / 8;
    } else {
        choose_quotient(piece, task, ln_tolerance);
    }
}

void BatchIntegral::choose_far(const BatchPiece& piece, Task& task, double excess,
                               double ln_tolerance) const {
    const double half = piece.doubled ? piece.angle_double : piece.angle_double / 2;
    const double times = piece.doubled ? 2 : 1;
    const quadrature::BernsteinEllipse whole = quadrature::BernsteinEllipse::beyond(half, excess);
    const double t = excess / half;
    // The bound grows like the reciprocal of the remaining distance to the pole, so that an ellipse
    // too close to the pole does not pay.
    const double guess = (task.ln_size - ln_tolerance + 5) / (2 * std::log(whole.rho));
    double part = 1 - 1 / (1 + 2 * guess * std::sqrt(t / (t + 2)));
    if (piece.reach) {
        part = std::min(part, piece.reach->ellipse.excess() / excess);
    }
    const quadrature::BernsteinEllipse ellipse =
        quadrature::BernsteinEllipse::beyond(half, part * excess);
    const double e = part * excess;
    // |cos phi - cos phi_x| over the ellipse is least where the ellipse crosses the real axis: the
    // square is (cosh y - cos(x - phi_x))(cosh y - cos(x + phi_x)) at phi = x + i y (DLMF 4.21.9).
    const auto distance = [&](double at) {
        return std::abs(2 * std::sin((at + at_.phi) / 2) * std::sin((at - at_.phi) / 2));
    };
    const double phi_left = piece.phi_right + piece.angle_double;
    double least = task.above ? distance(piece.phi_right - e) : distance(phi_left + e);
    if (!piece.doubled) {
        least =
            std::min(least, task.above ? distance(phi_left + e) : distance(piece.phi_right - e));
    }
    double numerator = in_units(task.height, G_exponent_);
    if (piece.constant_height(task.gap, task.height)) {
        numerator = std::abs(numerator - piece.beta_units * in_units(task.gap, S_exponent_));
    } else {
        numerator += piece.largest_rise(ellipse);
    }
    // numerator/|S - S_x|, with S - S_x = (length/2) (cos phi - cos phi_x)
    const double ln_M = std::log(numerator / (length_ / 2 * least));
    const double needed = gauss_legendre_nodes_needed(ellipse, ln_M, ln_tolerance);
    task.n = quadrature::rounded_up_nodes(needed / times);
    task.ln_error =
        gauss_legendre_log_error(ellipse, ln_M, static_cast<std::size_t>(times) * task.n);
}

void BatchIntegral::choose_quotient(const BatchPiece& piece, Task& task,
                                    double ln_tolerance) const {
    const double half = piece.doubled ? piece.angle_double : piece.angle_double / 2;
    const double times = piece.doubled ? 2 : 1;
    const double phi_left = piece.phi_right + piece.angle_double;
    quadrature::BernsteinEllipse ellipse{half, 2};
    double ln_M = 0;
    if (piece.linear()) {
        if (!circle_.folded || piece.alpha == 0) {
            return;
        }
        // alpha/(s + x) has its pole at s = -x, that is, at phi = 2 pi - phi_x.
        const double excess = 2 * pi_double - at_.phi - phi_left;
        const double t = excess / half;
        const quadrature::BernsteinEllipse whole =
            quadrature::BernsteinEllipse::beyond(half, excess);
        if (std::log(whole.rho) * times < slow) {
            task.mirror_near = true;
            return;
        }
        const double guess = (task.ln_size - ln_tolerance + 5) / (2 * std::log(whole.rho));
        const double e = excess * (1 - 1 / (1 + 2 * guess * std::sqrt(t / (t + 2))));
        ellipse = quadrature::BernsteinEllipse::beyond(half, e);
        // S = s^2 and `length` is the square of the half-length, so that alpha/(s + x) has the unit
        // of G/S.
        ln_M = std::log(piece.alpha_units / length_ /
                        (std::cos((phi_left + e) / 2) + std::cos(at_.phi / 2)));
    } else {
        ellipse = piece.reach->ellipse;
        // |sin z| >= (2/pi) |z| for |Re z| <= pi/2 (DLMF 4.18.1): from the ellipse to the point and
        // to the mirror image of the point.
        const double e = ellipse.excess();
        const double near = task.kind == Task::Kind::near ? e / 2 : e;
        double mirror = near;
        if (!piece.doubled) {
            mirror = 2 * std::min(piece.at_right_edge ? pi_double : piece.phi_right,
                                  piece.at_left_edge ? pi_double : pi_double - phi_left) -
                     e - near / 2;
        }
        const double least = 2 * near * std::min(mirror, pi_double) / (pi_double * pi_double);
        ln_M = piece.reach->ln_bound + std::log(4 / (length_ * least));
    }
    task.n = quadrature::rounded_up_nodes(gauss_legendre_nodes_needed(ellipse, ln_M, ln_tolerance) /
                                          times);
    task.ln_error =
        gauss_legendre_log_error(ellipse, ln_M, static_cast<std::size_t>(times) * task.n);
}

} // namespace edgeproof::contact
