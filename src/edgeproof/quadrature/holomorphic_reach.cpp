// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/quadrature/holomorphic_reach.hpp"

#include "edgeproof/precision/ball/acb_values.hpp"

#include <algorithm>

namespace edgeproof::quadrature {
namespace {

constexpr int most_balls = 600;

/// Covers the upper half of an ellipse with balls. f is real on the real axis, so that the bound
/// holds for the lower half, too.
class Cover {
public:
    Cover(const ComplexFunction& f, double centre, const BernsteinEllipse& ellipse)
        : f_(f), centre_(centre), wide_(ellipse.half + ellipse.excess()), high_(ellipse.height()) {}

    [[nodiscard]] std::optional<double> ln_bound() {
        const double step = wide_ / 4;
        for (int i = -4; i < 4; ++i) {
            for (int j = 0; j * step < high_; ++j) {
                if (!box(i * step, j * step, step)) {
                    return {};
                }
            }
        }
        return ln_bound_;
    }

private:
    /// Covers the square with its lower left corner at (x, y), relative to the centre.
    bool box(double x, double y, double side) {
        const double nearest = x > 0 ? x : x + side < 0 ? x + side : 0;
        const double u = nearest / wide_;
        const double v = y / high_;
        if (u * u + v * v > 1.001) {
            return true;
        }
        if (++balls_ > most_balls) {
            return false;
        }
        // Slightly larger than the square, for the roundoff of its corners.
        arb_set_d(acb_realref(phi_), centre_ + x + side / 2);
        arb_set_d(acb_imagref(phi_), y + side / 2);
        mag_set_d(arb_radref(acb_realref(phi_)), side * 0.5001);
        mag_set_d(arb_radref(acb_imagref(phi_)), side * 0.5001);
        f_(value_, phi_);
        acb_get_mag(size_, value_);
        if (acb_is_finite(value_) != 0 && mag_is_finite(size_) != 0) {
            ln_bound_ = std::max(ln_bound_, mag_get_d_log2_approx(size_) * 0.6931471805599453);
            return true;
        }
        const double half = side / 2;
        if (half < wide_ / 600) {
            return false;
        }
        return box(x, y, half) && box(x + half, y, half) && box(x, y + half, half) &&
               box(x + half, y + half, half);
    }

    const ComplexFunction& f_;
    double centre_;
    double wide_;
    double high_;
    int balls_ = 0;
    double ln_bound_ = -1e9;
    AcbValue phi_;
    AcbValue value_;
    MagValue size_;
};

} // namespace

std::optional<HolomorphicReach> holomorphic_reach(const ComplexFunction& f, double centre,
                                                  double half, double most_excess,
                                                  double ln_tolerance) {
    std::optional<HolomorphicReach> best;
    double fewest = 1e9;
    std::optional<double> scale;
    for (const double rho : {1.3, 1.6, 2.0, 2.5, 3.2, 4.0, 5.0, 6.5, 8.0, 11.0, 15.0}) {
        const BernsteinEllipse ellipse{half, rho};
        if (ellipse.excess() > most_excess) {
            break;
        }
        const auto bound = Cover(f, centre, ellipse).ln_bound();
        if (!bound) {
            break;
        }
        if (!scale) {
            scale = bound;
        }
        // `trefethen2013`, theorem 19.3
        const double nodes =
            gauss_legendre_nodes_needed(ellipse, *bound - *scale + 1, ln_tolerance);
        if (nodes < fewest) {
            fewest = nodes;
            best = HolomorphicReach{ellipse, *bound};
        } else if (nodes > 2 * fewest) {
            break;
        }
    }
    return best;
}

} // namespace edgeproof::quadrature
