// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/enclosure/ball_relative_error.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/route/real_level.hpp"
#include "edgeproof/scene/route/value_route.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace edgeproof::scene {
namespace {

constexpr unsigned most_extra = 4000;

class RealRoute : public ValueRoute {
public:
    RealRoute(const Scene& scene, const Plan& plan, contact::Work& work)
        : scene_(scene), plan_(plan), work_(work) {
        if (scene.punch) {
            const contact::SolvedTilt tilt =
                solve_tilt(*scene.punch, scene.contact_modulus, scene.load.value, *scene.moment,
                           plan.digits.count + tilt_digits);
            ++work.counts.tilts;
            alpha_ = tilt.alpha;
            profile_ = tilt.profile;
        } else {
            profile_ = *scene.profile;
        }
        levels_[0] =
            std::make_unique<RealLevel>(*profile_, alpha_, scene, plan, plan.digits.count, &work);
    }

    BoundedValue value(const AskedValue& asked) override {
        const QuantityRow& row = evaluated_row(asked.quantity);
        if (row.searched != nullptr) {
            return extent(asked.edge, asked.k).*row.searched;
        }
        if (row.at_point()) {
            check_inside(*asked.u);
        }
        return row.real(*levels_[0], asked);
    }

    ContactValues contact() override { return contact_values(*this, scene_, plan_); }

    BoundedValue place(contact::Edge edge, const Distance& u) override {
        if (u.number()) {
            check_inside(*u.number());
            return place_inside(edge, *u.number());
        }
        return by_edges(u).x;
    }

    /// If the place depends on the edges, the function is evaluated at the place and at the end of
    /// its error interval; the difference is the error of the value.
    PointValues at(contact::Edge edge, const Distance& u, bool p, bool q) override {
        if (u.number()) {
            return at_number(edge, *u.number(), p, q);
        }
        const ByEdges place = by_edges(u);
        PointValues values = at_number(edge, place.near, p, q);
        const PointValues at_end = at_number(edge, place.end, p, q);
        values.x = place.x;
        values.u = place.u;
        const auto widen = [](BoundedValue& value, const BoundedValue& other) {
            value = {Ball::hull(value.value, other.value), false, value.route};
        };
        const auto widen_all = [&](std::vector<Approximation>& list,
                                   const std::vector<Approximation>& others) {
            for (std::size_t i = 0; i < list.size(); ++i) {
                widen(list[i].local, others[i].local);
                widen(list[i].relative_error, others[i].relative_error);
            }
        };
        if (p) {
            widen(*values.p, *at_end.p);
        }
        if (q) {
            widen(*values.q, *at_end.q);
        }
        widen_all(values.p_local, at_end.p_local);
        widen_all(values.q_local, at_end.q_local);
        return values;
    }

private:
    PointValues at_number(contact::Edge edge, const formula::Exact& u, bool p, bool q) {
        check_inside(u);
        PointValues values;
        values.x = place_inside(edge, u);
        if (p) {
            values.p = levels_[0]->p(edge, u);
        }
        if (q) {
            values.q = levels_[0]->q(edge, u);
        }
        if (q && scene_.slips()) {
            ++work_.counts.shear_points;
            values.state = levels_[0]->slip().sticks(edge, u.to<Real>()) ? contact::SlipState::stick
                                                                         : contact::SlipState::slip;
        }
        for (const std::size_t n :
             plan_.terms > 0 ? scene_.ask.terms : std::vector<std::size_t>{}) {
            if (p) {
                values.p_local.push_back(approximation(edge, u, n, false));
            }
            if (q && plan_.expand_shear) {
                values.q_local.push_back(approximation(edge, u, n, true));
            }
        }
        return values;
    }

public:
    EdgeValues expansion(contact::Edge edge, bool p, bool q) override {
        EdgeValues values;
        values.edge = edge;
        values.s_half_powers = levels_[0]->shear_half_powers();
        if (p) {
            values.c = levels_[0]->c(edge);
        }
        if (q) {
            values.s = levels_[0]->s(edge);
        }
        return values;
    }

    StickValues stick() override {
        ++work_.counts.stick_zones;
        RealLevel& level = *levels_[0];
        const PrecisionScope scope(level.contact().a().precision());
        StickValues values;
        values.load_ratio = level.sound(level.slip().load_ratio(), "contact-law");
        values.a = level.stick_edge(contact::Edge::right);
        values.b = level.stick_edge(contact::Edge::left);
        values.in_proportion = same_sign_at_both_edges(
            Real(level.contact().a() + level.contact().b()),
            contact::ShearLoad<Real>{scene_.shear->Q.to<Real>(),
                                     scene_.shear->bulk_tension.to<Real>()});
        values.cycle_energy = cycle_energy_of(*this, scene_, plan_);
        return values;
    }

    SlipValues slip(contact::Edge edge) override {
        ++work_.counts.slip_sizes;
        RealLevel& level = *levels_[0];
        const contact::PartialSlip& s = level.slip();
        const PrecisionScope scope(level.contact().a().precision());
        SlipValues values;
        values.edge = edge;
        values.size = level.slip_size(edge);
        if (scene_.ask.terms.empty()) {
            return values;
        }
        const auto series = s.series(scene_.ask.most_terms());
        const auto& kappa = edge == contact::Edge::right ? series.right : series.left;
        for (const std::size_t n : scene_.ask.terms) {
            const Real size = contact::slip_sum(kappa, n, s.load_ratio());
            values.terms.push_back({n,
                                    level.sound(size, "series"),
                                    estimated(Real(abs(Real(1 - size / s.size(edge)))),
                                              Real(2 * s.estimate()), "series"),
                                    {}});
        }
        return values;
    }

    ExtentValues extent(contact::Edge edge, std::size_t n) override {
        ++work_.counts.extents;
        const contact::Extents e = within_tolerance(levels_[0]->contact(), edge, n,
                                                    *scene_.ask.tolerance, scene_.ask.part);
        const PrecisionScope scope(e.length.precision());
        ExtentValues values;
        values.edge = edge;
        values.n = n;
        values.leaves = e.leaves;
        // Each crossing has the error of the worst one; the measure adds the errors.
        const Real error =
            e.estimate * e.length +
            e.length * pow(Real(10), -static_cast<int>(plan_.digits.count + kept_digits));
        const auto near = [&](const Real& x, const Real& by) { return estimated(x, by, "scan"); };
        const Real all = error * static_cast<unsigned>(e.crossings.size() + 1);
        values.first_exit =
            near(e.first_exit, Real(e.first_exit * (e.estimate + error / e.length)));
        values.measure = near(e.measure, all);
        values.first_exit_fraction =
            near(Real(e.first_exit / e.length),
                 Real(e.first_exit / e.length * (e.estimate + error / e.length)));
        values.measure_fraction = near(Real(e.measure / e.length), Real(all / e.length));
        for (const Real& u : e.crossings) {
            values.crossings.push_back(near(u, Real(u * (e.estimate + error / e.length))));
        }
        if (scene_.ask.process_zone) {
            values.covers_zone = e.first_exit >= scene_.ask.process_zone->to<Real>();
        }
        return values;
    }

private:
    /// A distance that depends on the edges: a number near it, and the end of its error interval.
    struct ByEdges {
        formula::Exact near;
        formula::Exact end;
        BoundedValue u;
        BoundedValue x;
    };
    [[nodiscard]] ByEdges by_edges(const Distance& u) const {
        const RealLevel& level = *levels_.at(0);
        const Ball a = level.distance(contact::Edge::right).value;
        const Ball b = level.distance(contact::Edge::left).value;
        const Ball from = u.enclosure(a, b, level.bits());
        if (!certainly_positive(from)) {
            throw DomainError("the point lies outside the contact");
        }
        const Rational near = contact::exact_value(from.midpoint());
        return {formula::Exact::of(near),
                formula::Exact::of(near + contact::exact_value(from.radius())),
                {from, false, "given"},
                {u.x_enclosure(a, b, level.bits()), u.x().has_value(), "given"}};
    }
    void check_inside(const formula::Exact& u) const {
        const RealLevel& level = *levels_.at(0);
        if (!certainly_less(ball_of(u, level.bits()),
                            Ball(level.distance(contact::Edge::right).value +
                                 level.distance(contact::Edge::left).value))) {
            throw DomainError("the point lies outside the contact");
        }
    }
    /// The coordinate x, exact if the edge is given.
    [[nodiscard]] BoundedValue place_inside(contact::Edge edge, const formula::Exact& u) const {
        const RealLevel& level = *levels_.at(0);
        const bool given = scene_.load.kind == contact::Load::Kind::right_edge &&
                           (edge == contact::Edge::right || scene_.symmetric());
        if (given) {
            const formula::Expr& a = scene_.load.value.expr();
            const formula::Exact x(edge == contact::Edge::right ? a - u.expr() : u.expr() - a);
            return {ball_of(x, level.bits()), true, "given", rational_of(x)};
        }
        const Ball from_edge = ball_of(u, level.bits());
        BoundedValue x = level.distance(edge);
        x.value = edge == contact::Edge::right ? x.value - from_edge : from_edge - x.value;
        return x;
    }
    /// The sum of n terms; its relative error is computed with more digits if it cancels.
    [[nodiscard]] Approximation approximation(contact::Edge edge, const formula::Exact& u,
                                              std::size_t n, bool shear) {
        const Digits digits = plan_.error_digits();
        const unsigned wanted = digits.count;
        Approximation result{n, {}, {}};
        std::optional<Real> before; // the radius with fewer digits
        for (unsigned extra = 0;;) {
            RealLevel& level = at_level(extra);
            const Ball value = (shear ? level.q(edge, u) : level.p(edge, u)).value;
            const Ball local = level.sum(edge, u, n, shear);
            const Ball error = abs(Ball(1 - local / value));
            if (extra == 0) {
                result.local = {local, false, level.series_name()};
            }
            // If more digits did not help, still more will not help.
            const bool worse = before && !(error.radius() < *before);
            if (!worse) {
                result.relative_error = {error, false, level.series_name()};
            }
            if (worse || has_digits(error, digits) || contains_zero(value)) {
                return result;
            }
            before = error.radius();
            const Real lost = -log10(error.upper());
            const unsigned needed = lost > 0 ? static_cast<unsigned>(ceil(lost)) + wanted : wanted;
            const unsigned next = needed > plan_.digits.count ? needed - plan_.digits.count : 0;
            // Rounded up to steps, so that neighbouring points share one solved contact.
            extra = (std::max(next, 2 * extra + 1) + 15) / 16 * 16;
            if (extra > most_extra) {
                return result;
            }
        }
    }
    [[nodiscard]] RealLevel& at_level(unsigned extra) {
        auto& slot = levels_[extra];
        if (!slot) {
            ++work_.raised;
            slot = std::make_unique<RealLevel>(*profile_, alpha_, scene_, plan_,
                                               plan_.digits.count + extra, nullptr);
        }
        return *slot;
    }

    const Scene& scene_;
    const Plan& plan_;
    contact::Work& work_;
    std::optional<formula::Exact> alpha_;
    std::optional<contact::Profile> profile_;
    std::map<unsigned, std::unique_ptr<RealLevel>> levels_;
};

} // namespace

std::unique_ptr<ValueRoute> make_real_route(const Scene& scene, const Plan& plan,
                                            contact::Work& work) {
    try {
        return std::make_unique<RealRoute>(scene, plan, work);
    } catch (const InputError& error) {
        if (error.file().empty()) {
            throw error.at(scene.file, scene.load_line);
        }
        throw;
    } catch (const DomainError& error) {
        throw InputError(error.what(), "give a load that a contact of this profile can carry")
            .at(scene.file, scene.load_line);
    }
}

} // namespace edgeproof::scene
