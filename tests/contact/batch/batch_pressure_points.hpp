// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "tests/contact/scenes.hpp"

#include "edgeproof/contact/batch/batch_pressure.hpp"
#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/escalate.hpp"
#include "tests/support/namespaces.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

/// Points that are hard for a quadrature, and a comparison of the batch routes with enclosures.
namespace edgeproof::scenes {

/// Curved pieces on both sides, one corner, no symmetry.
inline Contact own_asymmetric() {
    const Symbols x{"x"};
    return {
        "own asymmetric",
        Profile::piecewise({exact("-1/3"), exact("0"), exact("1/2")},
                           {parse("2*(exp(x + 1/3) - 1) + x/5 - 1/30", x), parse("x/5 - 1/30", x),
                            parse("x/3 + x^3/7", x), parse("x/3 + x^3/7 + sinh(x - 1/2)", x)}),
        exact("7/3"), Load::right_edge(exact("4/5"))};
}

/// Distances from an edge: `count` geometric ones from most of the contact to 1e-8 of it, 1e-40 and
/// 1e-300; from the right edge also 1e-30, 1e-5 and 1e-2 from every knot, on both sides.
struct HardPoint {
    Edge edge;
    Exact u;
};
inline std::vector<HardPoint> hard_points(const Contact& c, int count) {
    std::vector<HardPoint> points;
    const Expr a = c.load.value.expr();
    const auto add = [&](Edge edge, const Expr& u) { points.push_back({edge, Exact(u)}); };
    for (int k = 0; k < count; ++k) {
        const double part = std::pow(10.0, -8.0 * k / std::max(1, count - 1)) * 0.97;
        add(Edge::right, a * Expr::number(Rational(part)));
    }
    for (const char* near : {"1e-40", "1e-300"}) {
        add(Edge::right, exact(near).expr());
        if (!c.profile.symmetric()) {
            add(Edge::left, exact(near).expr());
        }
    }
    for (const Exact& knot : c.profile.knots()) {
        for (const char* offset : {"1e-30", "-1e-30", "1e-5", "-1e-5", "1e-2", "-1e-2"}) {
            const Expr u = a - knot.expr() - a * exact(offset).expr();
            if (Exact(u).sign() > 0) {
                add(Edge::right, u);
            }
        }
    }
    return points;
}

/// Enclosures of one contact, solved once at each number of bits.
class Enclosures {
public:
    explicit Enclosures(const Contact& c) : c_(c) {}
    [[nodiscard]] Ball operator()(const HardPoint& at, unsigned digits) {
        const long wanted = static_cast<long>(3.3219281 * digits) + 24;
        return escalate(
            [&](long bits) { return at_bits(at, bits); },
            [&](const Ball& p) { return p.is_finite() && p.relative_accuracy_bits() >= wanted; },
            {wanted + 64, 1L << 16});
    }

private:
    Ball at_bits(const HardPoint& at, long bits) {
        try {
            if (BallContact::has_closed_form(c_.profile)) {
                const auto made = closed_.try_emplace(bits, c_.profile, c_.modulus, c_.load, bits);
                return made.first->second.pressure(at.edge, at.u);
            }
            const auto made = curved_.try_emplace(bits, c_.profile, c_.modulus, c_.load, bits);
            return made.first->second.pressure(at.edge, at.u);
        } catch (const BudgetError&) {
            Ball unknown(1, bits);
            arb_indeterminate(unknown.data());
            return unknown;
        }
    }

    const Contact& c_;
    std::map<long, BallContact> closed_;
    std::map<long, IntegratedContact> curved_;
};

struct BatchDigits {
    std::size_t points = 0;
    int worst = 100000;         ///< the smallest number of right digits
    bool estimates_hold = true; ///< the error is within a unit of the digit beyond the guard
    std::size_t most_nodes = 0;
    std::string where;
};

inline BatchDigits batch_digits(const Contact& c, BatchPressure::Rule rule, unsigned digits,
                                int count) {
    BatchDigits found;
    const NormalContact contact(c.profile, c.modulus, c.load, digits + 10);
    const BatchPressure fast(contact, digits, rule);
    Enclosures enclosed(c);
    for (const HardPoint& at : hard_points(c, count)) {
        // The point must have enough digits for its distances from a knot and from an edge.
        const PrecisionScope scope(digits + 340);
        const Real a = c.load.value.to<Real>();
        const Extent<Real> e{a, c.profile.symmetric() ? a : contact.b()};
        const Real u = at.u.to<Real>();
        if (!(u < e.length())) {
            continue;
        }
        const RoutedPressure<Real> p = fast(point_at(e, at.edge, u));
        const Ball truth = enclosed(at, digits);
        const Real error = abs(p.value - truth.midpoint()) / abs(truth.midpoint());
        const int right = error == 0 ? 1000 : static_cast<int>(floor(-log10(error)));
        ++found.points;
        found.most_nodes = std::max(found.most_nodes, p.evaluations);
        const Real slack = pow(Real(10), -static_cast<int>(digits) - 5);
        if (!p.converged || error > p.estimate + slack) {
            found.estimates_hold = false;
        }
        if (right < found.worst) {
            found.worst = right;
            found.where =
                c.name + (at.edge == Edge::right ? ", right" : ", left") + ", u = " + at.u.text();
        }
    }
    return found;
}

} // namespace edgeproof::scenes
