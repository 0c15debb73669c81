// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/stress/revolution_estimate.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <utility>

namespace edgeproof::contact {
namespace {

using Complex64 = std::complex<double>;

/// The integrals over tau of 1/R, 1/R^3, tau/R^3, 1/(R (R + tau)) and 1/(R + tau), and of the same
/// times tau, without the factor 1/r^2 of the textbook forms: (R - tau) (R + tau) = r^2.
std::array<std::array<Complex64, 2>, 5> integrals(const Complex64& tau, double r) {
    const Complex64 R = std::sqrt(tau + Complex64(0, r)) * std::sqrt(tau - Complex64(0, r));
    const Complex64 sum = R + tau;
    const Complex64 logarithm = std::log(sum);
    const Complex64 part = tau / (sum * 2.0);
    return {{{logarithm, R},
             {-1.0 / (R * sum), -1.0 / R},
             {-1.0 / R, logarithm - tau / R},
             {-1.0 / sum, logarithm / 2.0 - part},
             {logarithm / 2.0 + part, (R * R + R * tau + tau * tau) / (sum * 3.0)}}};
}

} // namespace

RevolutionEstimate::RevolutionEstimate(std::vector<Node> nodes, double modulus, double poisson)
    : nodes_(std::move(nodes)), scale_(modulus / std::numbers::pi), poisson_(poisson) {}

// With tau = z + i s a line h' = p + q s is (p + i q z) - i q tau, and ds = -i dtau.
RevolutionEstimate::State RevolutionEstimate::at(double x, double z) const {
    const double r = std::fabs(x);
    std::array<double, 5> of{};
    auto before = integrals({z, nodes_.front().s}, r);
    for (std::size_t k = 1; k < nodes_.size(); ++k) {
        const Node& lo = nodes_[k - 1];
        const Node& hi = nodes_[k];
        const auto here = integrals({z, hi.s}, r);
        const double q = hi.s > lo.s ? (hi.rate - lo.rate) / (hi.s - lo.s) : 0;
        const Complex64 constant(lo.rate - q * lo.s, q * z);
        for (std::size_t n = 0; n < of.size(); ++n) {
            const Complex64 over = constant * (here[n][0] - before[n][0]) +
                                   Complex64(0, -q) * (here[n][1] - before[n][1]);
            of[n] -= over.real(); // Im(-i x) = -Re(x)
        }
        before = here;
    }
    const double I = of[0];
    const double K = z * of[2];
    const double L = z * of[3];
    const double M = (1 - 2 * poisson_) * of[4];
    return {scale_ * (I - K + L - M), scale_ * (I + K), scale_ * z * x * of[1],
            scale_ * (2 * poisson_ * I - L + M)};
}

} // namespace edgeproof::contact
