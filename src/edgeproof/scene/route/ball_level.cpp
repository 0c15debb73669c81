// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/scene/route/ball_level.hpp"

namespace edgeproof::scene {

Ball BallLevel::relative_error(Edge edge, const Distance& u, std::size_t n, bool shear) {
    const Ball value = shear ? q(edge, u) : p(edge, u);
    const Ball difference = 1 - sum(edge, u, n, shear) / value;
    if (!difference.is_finite() || !contains_zero(difference)) {
        return difference;
    }
    const Ball at = distance(u);
    const Ball left_out = omitted_terms(shear ? q_series(edge) : p_series(edge), n, at);
    const Ball error =
        (singular(shear) ? Ball(left_out / sqrt(at)) : Ball(left_out * sqrt(at))) / value;
    return error.is_finite() ? error : difference;
}

const std::vector<Ball>& BallLevel::slip_series(Edge edge, std::size_t terms) {
    if (!slip_series_) {
        const BallSlip* s = slip();
        slip_series_ = s != nullptr ? s->series(terms)
                                    : contact::SlipSeries{std::vector<Ball>(terms, not_known()),
                                                          std::vector<Ball>(terms, not_known())};
    }
    return edge == Edge::right ? slip_series_->right : slip_series_->left;
}

BoundedSeries BallLevel::p_series(Edge edge) const {
    const ProvedContact& pressure = contact();
    const Ball radius = Ball(pressure.reach(edge).lower(), bits_) / 2;
    return {[&pressure, edge](std::size_t n) { return pressure.expansion(edge, n); },
            certainly_positive(radius) ? pressure.majorant(edge, radius) : not_known(), radius};
}

BoundedSeries BallLevel::q_series(Edge edge) {
    if (scene_.proportional()) {
        BoundedSeries series = p_series(edge);
        const Ball ratio = shear_ratio();
        series.most *= abs(ratio);
        series.coefficients = [of_p = series.coefficients, ratio](std::size_t n) {
            std::vector<Ball> c = of_p(n);
            for (Ball& x : c) {
                x *= ratio;
            }
            return c;
        };
        return series;
    }
    const Ball L = length();
    const contact::ShearLoad<Ball> given = load();
    const Ball most =
        (abs(given.Q) / Ball::pi(bits_) + abs(given.bulk_tension) * L * 3 / 8) / sqrt(L);
    return {[L, given, edge](std::size_t n) {
                return contact::full_stick_expansion(L, given, edge, n);
            },
            most, L};
}

void BallLevel::make_slip(const std::optional<contact::BallZone>& stick) {
    const ShearSpec& shear = *scene_.shear;
    try {
        if (!zones_) {
            zones_ = zone_solver(*contact_, tilt_ ? tilt_->near : *scene_.profile,
                                 scene_.contact_modulus, shear.bulk_tension.sign() != 0,
                                 scene_.round ? std::optional(whole_force()) : std::nullopt);
        }
        if (scene_.history) {
            std::vector<contact::ShearLayer> layers;
            for (const LoadHistory::Layer& layer : scene_.history->layers) {
                layers.push_back({ball_of(layer.force, bits_), ball_of(layer.ratio, bits_)});
            }
            const auto& stuck = scene_.history->stick;
            slip_.emplace(contact(), *zones_, load().Q, ball_of(*shear.friction, bits_), layers,
                          stuck ? std::optional(ball_of(*stuck, bits_)) : std::nullopt);
            return;
        }
        slip_.emplace(contact(), *zones_,
                      scene_.load.kind == Load::Kind::force ? ball_of(scene_.load.value, bits_)
                                                            : whole_force(),
                      load(), ball_of(*shear.friction, bits_), stick);
    } catch (const BudgetError&) {
        slip_.reset();
    } catch (const DomainError&) {
        slip_.reset();
    }
}

std::optional<contact::BallZone> BallLevel::exact_stick() const {
    const ShearSpec& shear = *scene_.shear;
    if (contact_->closed_form() == nullptr || scene_.round || scene_.history || tilt_ ||
        shear.bulk_tension.sign() != 0 || scene_.load.kind != Load::Kind::force) {
        return {};
    }
    try {
        const Expr Q = shear.Q.sign() > 0 ? shear.Q.expr() : -shear.Q.expr();
        const BallContact inner(
            *scene_.profile, scene_.contact_modulus,
            Load::force(Exact(scene_.load.value.expr() - Q / shear.friction->expr())), bits_);
        return contact::BallZone{inner.a(), inner.b()};
    } catch (const Error&) {
        return {};
    }
}

Ball BallLevel::pressure(Edge edge, const Distance& u) const {
    if (const auto& number = u.number()) {
        return contact_->pressure(edge, *number);
    }
    return u.x() ? contact_->pressure(edge, distance(u), *u.x())
                 : contact_->pressure(edge, distance(u));
}

std::optional<Exact> BallLevel::known_x(Edge edge, const Distance& u) const {
    const auto known = contact_->known(edge);
    if (!u.number() || !known) {
        return u.x();
    }
    const Expr inwards = known->expr() - u.number()->expr();
    return Exact(edge == Edge::right ? inwards : -inwards);
}

bool BallLevel::greater_off_axis() const {
    constexpr long places = 16;
    const Ball on_axis = contact_->pressure(Edge::right, a(), Exact());
    for (long k = 1; k < places; ++k) {
        if (certainly_less(on_axis, contact_->pressure(Edge::right, a() * k / places))) {
            return true;
        }
    }
    return false;
}

} // namespace edgeproof::scene
