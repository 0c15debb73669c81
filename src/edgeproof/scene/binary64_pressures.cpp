// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/binary64_values.hpp"

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
constexpr Digits digits_of_value{25, Rounding::nearest, true};

Ball ball_at(double u, long bits) {
    Ball x(0, bits);
    arb_set_d(x.data(), u);
    return x;
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
        }
    }

    [[nodiscard]] bool outside(double u) const {
        if (!(u > 0)) {
            return true;
        }
        if (exact_length) {
            return !std::isfinite(u) || exact_rational(u) >= *exact_length;
        }
        return !std::isfinite(u) || certainly_less(length, ball_at(u, length.bits()));
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
            const Ball p = balls->pressure(edge, ball_at(u, first_bits));
            if (const auto nearest = p.is_finite() ? nearest_binary64(p) : std::nullopt) {
                return *nearest;
            }
        }
        if (on_corner(edge, u)) {
            return std::numeric_limits<double>::infinity();
        }
        try {
            return in_full(edge, u);
        } catch (const Error&) {
            if (const auto limit = near_edge_or_corner(edge, u)) {
                return *limit;
            }
            throw;
        }
    }

    /// Returns p at a place that the route of the scene refuses: closer to the far edge or to a
    /// corner than its bits separate, or exactly on one of them (as far as most_bits decide).
    [[nodiscard]] std::optional<double> near_edge_or_corner(Edge edge, double u) const {
        bool on_corner = false;
        for (long bits = 2 * first_bits; solved && bits <= most_bits; bits *= 2) {
            const BallContact closer = solved(bits);
            const Ball from = ball_at(u, bits);
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
        return certainly_less(ball_at(u, length.bits()), length) ? std::nullopt
                                                                 : std::optional(0.0);
    }

    /// Computes one value by the route of the scene.
    [[nodiscard]] double in_full(Edge edge, double u) const {
        const AskedValue p{
            .quantity = Quantity::p, .edge = edge, .u = Exact::of(exact_rational(u))};
        if (!values) {
            values.emplace(scene, std::vector{p}, digits_of_value);
        }
        const PrintedValue text = printed(values->value(p), digits_of_value);
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
    mutable std::optional<SceneValues> values;        ///< decides the others
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

} // namespace edgeproof::scene
