// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/route/ball_places.hpp"

#include "edgeproof/formula/exact/exact_ball.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <utility>

namespace edgeproof::scene {
namespace {

constexpr long least_bits_of_a_place = 128;

} // namespace

BallPlaces::BallPlaces(BallRefinement& balls, const Scene& scene, const Plan& plan)
    : balls_(balls), scene_(scene), plan_(plan) {
    if (auto length =
            balls.refine([](BallLevel& level) { return level.length(); },
                         [](ExactValues& exact) { return exact.length(); },
                         {plan.digits.count, Rounding::nearest, false}, plan.narrow_bits)) {
        length_ = std::move(length->value);
    }
    if (scene.load.kind == contact::Load::Kind::right_edge) {
        if (const auto given = rational_of(scene.load.value)) {
            known_[contact::Edge::right] = *given;
            if (scene.symmetric()) {
                known_[contact::Edge::left] = *given;
            }
        }
    } else if (length_) {
        know(contact::Edge::right);
    }
    if (length_) {
        know(contact::Edge::left);
    }
    if (known_.size() == 2) {
        known_length_ = known_.at(contact::Edge::right) + known_.at(contact::Edge::left);
    }
}

std::optional<Rational> BallPlaces::known(contact::Edge edge) const {
    const auto found = known_.find(edge);
    return found == known_.end() ? std::nullopt : std::optional(found->second);
}

void BallPlaces::refuse_outside(contact::Edge edge, const Distance& u) {
    if (!u.number()) {
        if (length_) {
            refuse_outside_by_edges(edge, u);
        }
        return;
    }
    const Rational* distance = u.number()->expr().rational();
    const bool inside =
        known_length_ && distance != nullptr
            ? *distance < *known_length_
            : !length_ || certainly_less(u.enclosure({}, {}, length_->bits()), *length_);
    if (!inside) {
        throw DomainError("the point lies outside the contact");
    }
}

void BallPlaces::refuse_outside_by_edges(contact::Edge edge, const Distance& u) {
    refuse_corner_at(u);
    bool outside = false;
    for (long bits = plan_.bits; bits <= 8 * plan_.bits; bits *= 2) {
        const BallLevel* level = balls_.at_level(bits);
        if (level == nullptr) {
            continue;
        }
        const Ball from = level->distance(u);
        if (certainly_negative(from) || certainly_less(level->length(), from)) {
            throw DomainError("the point lies outside the contact");
        }
        outside = !certainly_positive(from) || !certainly_less(from, level->length());
        const auto corners = level->proved_pressure().corners(edge);
        if (!outside && std::ranges::none_of(
                            corners, [&](const Ball& corner) { return overlaps(corner, from); })) {
            return;
        }
    }
    throw DomainError(outside ? "the point is on an edge, or cannot be distinguished from it"
                              : "the point is on a corner, or cannot be distinguished from it");
}

void BallPlaces::refuse_corner_at(const Distance& u) const {
    if (!u.x() || !scene_.profile) {
        return;
    }
    const auto& knots = scene_.profile->knots();
    for (std::size_t i = 0; i < knots.size(); ++i) {
        if (scene_.profile->has_corner(i) &&
            contact::certainly_zero(knots[i].expr() - u.x()->expr())) {
            throw DomainError("the point is on a corner, where the pressure is infinite");
        }
    }
}

std::optional<BallRefinement::Found> BallPlaces::x(contact::Edge edge, const Distance& u) {
    const auto exactly = known(edge);
    const Rational* distance = u.number() ? u.number()->expr().rational() : nullptr;
    const bool right = edge == contact::Edge::right;
    // An exactly known value is printed from its exact form: a ball of any width suffices.
    const long bits = std::max(length_ ? length_->bits() : plan_.bits, least_bits_of_a_place);
    if (const auto given = u.x() ? rational_of(*u.x()) : std::nullopt) {
        return BallRefinement::Found{Ball(*given, bits), *given};
    }
    if (exactly && distance != nullptr) {
        const Rational x = right ? Rational(*exactly - *distance) : Rational(*distance - *exactly);
        return BallRefinement::Found{Ball(x, bits), x};
    }
    return balls_.refine(
        [&](BallLevel& level) {
            if (!u.number()) {
                return u.x_enclosure(level.a(), level.b(), level.bits());
            }
            const Ball at = level.distance(u);
            return right ? level.a() - at : at - level.b();
        },
        [&](ExactValues& exact) { return exact.x(edge, exact.u(u)); }, plan_.digits,
        plan_.narrow_bits);
}

void BallPlaces::know(contact::Edge edge) {
    if (const auto exact = balls_.at_level(length_->bits())->known(edge)) {
        if (const auto rational = rational_of(*exact)) {
            known_[edge] = *rational;
        }
    }
}

} // namespace edgeproof::scene
