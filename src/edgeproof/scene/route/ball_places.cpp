// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/route/ball_places.hpp"
#include "edgeproof/contact/enclosure/ball_extent.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <utility>
#include <vector>

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
        const auto corners = level->contact().corners(edge);
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

long BallPlaces::bits() const {
    return std::max(length_ ? length_->bits() : plan_.bits, least_bits_of_a_place);
}

std::optional<Rational> BallPlaces::known_x(contact::Edge edge, const Distance& u) const {
    if (const auto given = u.x() ? rational_of(*u.x()) : std::nullopt) {
        return given;
    }
    const auto from = known(edge);
    const Rational* distance = u.number() ? u.number()->expr().rational() : nullptr;
    if (!from || distance == nullptr) {
        return {};
    }
    return edge == contact::Edge::right ? Rational(*from - *distance) : Rational(*distance - *from);
}

void BallPlaces::know(contact::Edge edge) {
    if (const auto exact = balls_.at_level(length_->bits())->contact().known(edge)) {
        if (const auto rational = rational_of(*exact)) {
            known_[edge] = *rational;
        }
    }
}

namespace {

formula::ExactNumber exactly(const formula::Exact& x) { return formula::ExactNumber::of(x.expr()); }

/// The exact values of those results that are rational numbers.
struct ExactExtents {
    std::optional<Rational> length;
    std::optional<Rational> first_exit;
    std::optional<Rational> measure;
    std::vector<std::optional<Rational>> crossings;
};

class ExtentInBalls {
public:
    ExtentInBalls(BallRefinement& balls, const Scene& scene, const Plan& plan, contact::Edge edge,
                  std::size_t n)
        : balls_(balls), scene_(scene), plan_(plan), edge_(edge), n_(n) {}

    [[nodiscard]] std::optional<std::vector<Row>> found() {
        contact::BallExtentSearch search(
            [&](long bits) -> const contact::ProvedContact& {
                BallLevel* level = balls_.at_level(bits);
                if (level == nullptr) {
                    throw BudgetError("too few bits to enclose the edges");
                }
                return level->contact();
            },
            edge_, n_, *scene_.ask.tolerance, scene_.ask.part);
        const auto enclosed = [&](const Ball& x) { return has_digits(x, plan_.digits); };
        std::optional<contact::EnclosedExtents> best;
        ExactExtents exact;
        for (long bits = plan_.bits; bits <= balls_.last_bits(); bits *= 2) {
            try {
                best = search.at(bits);
            } catch (const BudgetError&) {
                if (search.evaluations() > contact::BallExtentSearch::most_evaluations) {
                    break;
                }
                continue;
            }
            exact = exact_extents(*best, *balls_.at_level(bits));
            bool all = (exact.first_exit || enclosed(best->first_exit)) &&
                       (exact.measure || enclosed(best->measure));
            for (std::size_t k = 0; k < best->crossings.size(); ++k) {
                all = all && (exact.crossings[k] || enclosed(best->crossings[k]));
            }
            if (all) {
                break;
            }
        }
        if (!best) {
            return {};
        }
        const auto proved = [](const Ball& x, const std::optional<Rational>& q) {
            return BoundedValue{x, true, "sign changes", q};
        };
        const auto of_length = [&](const std::optional<Rational>& q) {
            return q && exact.length ? std::optional(Rational(*q / *exact.length)) : std::nullopt;
        };
        std::vector<BoundedValue> crossings;
        for (std::size_t k = 0; k < best->crossings.size(); ++k) {
            crossings.push_back(proved(best->crossings[k], exact.crossings[k]));
        }
        return extent_rows({Quantity::extent, n_, edge_, {}, scene_.ask.tolerance},
                           proved(best->first_exit, exact.first_exit),
                           proved(best->first_exit / best->length, of_length(exact.first_exit)),
                           proved(best->measure, exact.measure),
                           proved(best->measure / best->length, of_length(exact.measure)),
                           std::move(crossings), best->leaves);
    }

private:
    [[nodiscard]] ExactExtents exact_extents(const contact::EnclosedExtents& found,
                                             const BallLevel& level) {
        ExactExtents result;
        result.crossings.resize(found.crossings.size());
        const auto part = [&](const formula::Exact& fraction) {
            return balls_.exact_value(
                [&](ExactValues& e) { return e.length() * exactly(fraction); }, level,
                found.length * ball_of(fraction, found.length.bits()));
        };
        result.length = part(formula::Exact::of(Rational(1)));
        if (!result.length) {
            return result;
        }
        bool all = true;
        for (std::size_t k = 0; k < found.crossings.size(); ++k) {
            result.crossings[k] =
                found.single[k] ? exact_crossing(found.crossings[k], level) : std::nullopt;
            all = all && result.crossings[k];
        }
        const auto start = part(scene_.ask.part.from);
        const auto end = part(scene_.ask.part.to);
        result.first_exit = !found.starts_within ? start
                            : !found.leaves      ? end
                                                 : result.crossings.front();
        if (!all || !start || !end) {
            return result;
        }
        Rational measure = 0;
        Rational entered = *start;
        bool within = found.starts_within;
        for (const auto& u : result.crossings) {
            measure += within ? Rational(*u - entered) : Rational(0);
            entered = *u;
            within = !within;
        }
        measure += within ? Rational(*end - entered) : Rational(0);
        if (contains(found.measure, measure)) {
            result.measure = measure;
        }
        return result;
    }
    /// Returns the crossing in a ball that contains one, if the error there is exactly the
    /// tolerance.
    [[nodiscard]] std::optional<Rational> exact_crossing(const Ball& u, const BallLevel& level) {
        const auto q = may_be_a_limit(u, plan_.digits, has_digits(u, plan_.digits))
                           ? contact::simplest_rational(u)
                           : std::nullopt;
        if (!q || *q <= 0) {
            return {};
        }
        const formula::ExactNumber tolerance = exactly(*scene_.ask.tolerance);
        const auto off = [&](ExactValues& e) {
            const formula::ExactNumber error = e.error(edge_, formula::ExactNumber(*q), n_, false);
            return error == tolerance || error == -tolerance ? formula::ExactNumber(*q)
                                                             : formula::ExactNumber::unknown();
        };
        return balls_.exact_value(off, level, u);
    }

    BallRefinement& balls_;
    const Scene& scene_;
    const Plan& plan_;
    contact::Edge edge_;
    std::size_t n_;
};

} // namespace

std::optional<std::vector<Row>> enclosed_extent(BallRefinement& balls, const Scene& scene,
                                                const Plan& plan, contact::Edge edge,
                                                std::size_t n) {
    return ExtentInBalls(balls, scene, plan, edge, n).found();
}

} // namespace edgeproof::scene
