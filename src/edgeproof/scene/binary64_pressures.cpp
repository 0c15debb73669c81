// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/binary64_values.hpp"

#include "edgeproof/contact/batch/batch_pressure.hpp"
#include "edgeproof/contact/double_word/double_word_pressure.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/rational.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/scene/run_scene.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace edgeproof::scene {
namespace {

/// The numbers of such balls fit into two words, which need no heap memory.
constexpr long first_bits = 128;
constexpr long most_bits = 4096; ///< for places near the far edge and near corners
constexpr unsigned batch_digits = 25;
/// Digits of the edges: the distance from the far edge or from a knot is a difference with them.
constexpr unsigned edge_digits = 70;
/// An allowance for roundoff, added to the error of the quadrature rule, as a power of ten.
constexpr int roundoff_power = -(static_cast<int>(batch_digits) - 3);

Real real_of(double u) {
    const PrecisionScope scope(edge_digits);
    return Real(u);
}

/// Returns the binary64 to which all numbers within the relative error of x round, if it is unique.
std::optional<double> nearest_within(const Real& x, const Real& relative) {
    const Real change = abs(x) * relative;
    return nearest_binary64(Ball::around(x, change, 2 * first_bits));
}

} // namespace

struct Binary64Pressures::Contact {
    explicit Contact(const Scene& asked) : scene(asked) {
        scene.ask = {};
        scene.ask.quantities = {QuantityGroup::contact};
        // This refuses a load that no contact carries.
        const SceneResult found = run_scene(scene);
        length = found.at(Quantity::a).value + found.at(Quantity::b).value;
        exact_a = found.at(Quantity::a).exactly;
        exact_b = found.at(Quantity::b).exactly;
        if (exact_a && exact_b) {
            exact_length = *exact_a + *exact_b;
        }
        if (const auto closed = closed_form_contact(scene, 2 * first_bits)) {
            profile = closed->profile;
            solved = closed->at;
            balls = solved(first_bits);
            if (contact::DoubleWordPressure::has_form(*profile)) {
                words.emplace(*profile, solved(contact::DoubleWordPressure::contact_bits));
            }
        } else {
            profile = scene.profile;
            if (!profile->axisymmetric()) { // the batch is that of the plane
                make_batch();
            }
        }
    }

    void make_batch() {
        const contact::NormalContact edges(*scene.profile, scene.contact_modulus, scene.load,
                                           edge_digits);
        batch.emplace(edges, batch_digits);
    }

    [[nodiscard]] bool outside(double u) const {
        if (!(u > 0)) {
            return true;
        }
        if (exact_length) {
            return !std::isfinite(u) || exact_rational(u) >= *exact_length;
        }
        return !std::isfinite(u) || certainly_less(length, Ball(real_of(u), length.bits()));
    }

    /// Decides only where the edge is known exactly; elsewhere run_scene has to separate a place
    /// from a corner.
    [[nodiscard]] bool on_corner(Edge edge, double u) const {
        const auto& end = edge == Edge::right ? exact_a : exact_b;
        for (std::size_t i = 0; end && i < profile->knots().size(); ++i) {
            const auto knot = rational_of(profile->knots()[i]);
            if (profile->has_corner(i) && knot &&
                exact_rational(u) ==
                    (edge == Edge::right ? Rational(*end - *knot) : Rational(*end + *knot))) {
                return true;
            }
        }
        return false;
    }

    [[nodiscard]] double at(Edge edge, double u) const {
        if (words) {
            if (const auto nearest = words->nearest(edge, u)) {
                return *nearest;
            }
        }
        if (outside(u)) {
            return 0;
        }
        if (balls) {
            const Ball p = balls->pressure(edge, Ball(real_of(u), first_bits));
            if (const auto nearest = p.is_finite() ? nearest_binary64(p) : std::nullopt) {
                return *nearest;
            }
        } else if (batch) {
            if (const auto nearest = by_batch(edge, u)) {
                return *nearest;
            }
        }
        if (on_corner(edge, u)) {
            return std::numeric_limits<double>::infinity();
        }
        try {
            return in_full(edge, u);
        } catch (const InputError&) {
            if (const auto limit = near_edge_or_corner(edge, u)) {
                return *limit;
            }
            throw;
        }
    }

    /// Returns p at a place that run_scene refuses: closer to the far edge or to a corner than its
    /// bits separate, or exactly on one of them (as far as most_bits decide).
    [[nodiscard]] std::optional<double> near_edge_or_corner(Edge edge, double u) const {
        bool on_corner = false;
        for (long bits = 2 * first_bits; solved && bits <= most_bits; bits *= 2) {
            const BallContact closer = solved(bits);
            const Ball from(real_of(u), bits);
            if (!certainly_less(from, Ball(closer.a() + closer.b()))) {
                continue;
            }
            const Ball p = closer.pressure(edge, from);
            if (const auto nearest = p.is_finite() ? nearest_binary64(p) : std::nullopt) {
                return nearest;
            }
            const std::vector<Ball> corners = closer.corners(edge);
            on_corner = std::any_of(corners.begin(), corners.end(),
                                    [&](const Ball& corner) { return overlaps(corner, from); });
        }
        if (on_corner) {
            return std::numeric_limits<double>::infinity();
        }
        return certainly_less(Ball(real_of(u), length.bits()), length) ? std::nullopt
                                                                       : std::optional(0.0);
    }

    [[nodiscard]] std::optional<double> by_batch(Edge edge, double u) const {
        try {
            const contact::RoutedPressure<Real> p = (*batch)(edge, real_of(u));
            if (!p.converged) {
                return {};
            }
            const PrecisionScope scope(edge_digits);
            return nearest_within(p.value, p.estimate + pow(Real(10), roundoff_power));
        } catch (const DomainError&) {
            return {}; // on a corner, or too near to the far edge for the digits
        }
    }

    /// Computes one value by the routes of the scene.
    [[nodiscard]] double in_full(Edge edge, double u) const {
        Scene one = scene;
        one.ask.edges = {edge};
        one.ask.u = {{Exact::of(exact_rational(u)), 0}};
        one.ask.quantities = {QuantityGroup::pressure};
        one.ask.digits = {batch_digits, Rounding::nearest, true};
        const SceneResult result = run_scene(one);
        const PrintedValue text = printed(result.points().front().at(Quantity::p), one.ask.digits);
        if (!text.binary64) {
            throw BudgetError("the binary64 nearest to p is undecided at u = " +
                              exact_text(exact_rational(u)));
        }
        return *text.binary64;
    }

    Scene scene;
    Ball length;
    std::optional<Rational> exact_a;
    std::optional<Rational> exact_b;
    std::optional<Rational> exact_length;
    std::optional<Profile> profile;
    std::optional<BallContact> balls;
    std::function<BallContact(long)> solved;          ///< the same contact at these bits
    std::optional<contact::DoubleWordPressure> words; ///< decides nearly all places
    std::optional<contact::BatchPressure> batch;
};

Binary64Pressures::Binary64Pressures(const Scene& scene)
    : contact_(std::make_unique<Contact>(scene)) {}
Binary64Pressures::~Binary64Pressures() = default;
Binary64Pressures::Binary64Pressures(Binary64Pressures&&) noexcept = default;
Binary64Pressures& Binary64Pressures::operator=(Binary64Pressures&&) noexcept = default;

double Binary64Pressures::operator()(Edge edge, double u) const {
    if (std::isnan(u)) {
        throw DomainError("u is not a number");
    }
    return contact_->at(edge, u);
}

void Binary64Pressures::operator()(Edge edge, std::span<const double> u,
                                   std::span<double> p) const {
    for (std::size_t i = 0; i < u.size(); ++i) {
        check_interruption();
        p[i] = (*this)(edge, u[i]);
    }
}

bool Binary64Pressures::proved() const noexcept { return contact_->balls.has_value(); }

} // namespace edgeproof::scene
