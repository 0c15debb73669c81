// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/validation/independent_extent.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/validation/textbook_formula.hpp"

#include <algorithm>
#include <utility>

namespace edgeproof::validation {
namespace {

constexpr unsigned guard = 80;
constexpr int scan_decades = 10;
constexpr int per_decade = 40;
constexpr int even_points = 400;

class ErrorCurve {
public:
    ErrorCurve(const scene::Scene& scene, contact::Edge edge, std::size_t n, unsigned digits)
        : formula_(scene), edge_(edge),
          c_(contact::NormalContact(scene.profile.value(), scene.contact_modulus, scene.load,
                                    digits + guard)
                 .expansion(edge, n)) {}

    [[nodiscard]] Real operator()(const Real& u) const {
        Real sum = c_.back();
        for (std::size_t k = c_.size() - 1; k-- > 0;) {
            sum = sum * u + c_[k];
        }
        const Real x =
            edge_ == contact::Edge::right ? Real(formula_.a() - u) : Real(u - formula_.b());
        return abs(Real(1 - sum * sqrt(u) / formula_.pressure(x)));
    }
    /// Points from 1e-10 of the contact to within 1e-4 of the other edge, geometric and even.
    [[nodiscard]] std::vector<Real> grid() const {
        std::vector<Real> points;
        // The length is slightly reduced, so that no point is on a knot, where the formula is
        // infinity times 0.
        const Real length = (formula_.a() + formula_.b()) * (1 - 1 / pow(Real(2), Real(61) / 4));
        for (int i = -scan_decades * per_decade; i < 0; ++i) {
            points.push_back(length * pow(Real(10), Real(i) / per_decade));
        }
        for (int i = 1; i < even_points; ++i) {
            points.push_back(length * i / even_points);
        }
        for (int i = -4 * per_decade; i < -per_decade; ++i) {
            points.push_back(length * (1 - pow(Real(10), Real(i) / per_decade)));
        }
        std::sort(points.begin(), points.end());
        return points;
    }
    /// The place of the maximum between lo and hi.
    [[nodiscard]] Real summit(Real lo, Real hi, unsigned digits) const {
        // An error d of the place changes the maximum by only d^2.
        const Real enough = hi * pow(Real(10), -static_cast<int>(digits / 2 + 10));
        while (hi - lo > enough) {
            const Real third = (hi - lo) / 3;
            const Real left = lo + third;
            const Real right = hi - third;
            ((*this)(left) < (*this)(right) ? lo : hi) =
                (*this)(left) < (*this)(right) ? left : right;
        }
        return (lo + hi) / 2;
    }

private:
    TextbookFormula<Real> formula_;
    contact::Edge edge_;
    std::vector<Real> c_;
};

} // namespace

SecondRoute independent_extent(const scene::Scene& scene, const scene::AskedValue& asked,
                               unsigned digits) {
    const PrecisionScope scope(digits + guard);
    const ErrorCurve error(scene, asked.edge, asked.k, digits);
    const Real tolerance = asked.tolerance.value().to<Real>();
    const std::vector<Real> u = error.grid();
    std::vector<Real> e;
    const auto crossing = [&](Real inside, Real outside) {
        const Real enough = outside * pow(Real(10), -static_cast<int>(digits + 5));
        while (abs(Real(outside - inside)) > enough) {
            const Real middle = (inside + outside) / 2;
            (error(middle) < tolerance ? inside : outside) = middle;
        }
        return SecondRoute{"independent-scan", outside, enough};
    };
    for (std::size_t i = 0; i < u.size(); ++i) {
        e.push_back(error(u[i]));
        if (i > 1 && e[i] <= e[i - 1] && e[i - 2] < e[i - 1] && e[i - 1] < tolerance &&
            e[i - 1] > tolerance / 2) {
            const Real top = error.summit(u[i - 2], u[i], 2 * digits);
            if (!(error(top) < tolerance)) {
                return crossing(u[i - 2], top);
            }
        }
        if (i > 0 && !(e[i] < tolerance)) {
            // The maximum may lie just before.
            return crossing(u[i - 1], u[i]);
        }
    }
    throw DomainError("the approximation stays within the tolerance");
}

} // namespace edgeproof::validation
