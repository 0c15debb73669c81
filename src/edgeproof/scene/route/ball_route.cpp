// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/curved/slope_monotonicity.hpp"
#include "edgeproof/contact/profile/profile_checks.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/route/ball_places.hpp"
#include "edgeproof/scene/route/ball_refinement.hpp"
#include "edgeproof/scene/route/ball_slips.hpp"
#include "edgeproof/scene/route/value_route.hpp"

#include <optional>
#include <set>
#include <utility>

namespace edgeproof::scene {
namespace {

class BallRoute : public ValueRoute {
public:
    BallRoute(const Scene& scene, const Plan& plan, contact::Work& work)
        : scene_(scene), plan_(plan), work_(work), balls_(scene, plan, work),
          places_(balls_, scene, plan), slips_(balls_, scene, plan) {
        work.counts.consistency += scene.symmetric() ? 0 : 1;
        work.counts.tilts += scene.punch ? 1 : 0;
        work.counts.load_inversions += scene.load.kind == contact::Load::Kind::force ? 1 : 0;
        // There is no contact at any precision: the routes in Real report the reason.
        if (places_.length() == nullptr) {
            (void)others();
        }
    }

    /// True if g' is proved not to decrease in the contact; all proofs for a curved profile depend
    /// on this. Throws InputError if g' is proved to decrease.
    [[nodiscard]] bool slope_rises() {
        if (balls_.closed() || places_.length() == nullptr) {
            return true; // decided exactly; or nothing is proved in any case
        }
        const BallLevel* level = balls_.at_level(places_.length()->bits());
        check_reach(*scene_.profile, level->a(), level->b());
        const contact::SlopeMonotonicity monotonicity =
            monotonicity_of_slope(*scene_.profile, level->a(), level->b());
        if (monotonicity.kind == contact::SlopeMonotonicity::Kind::falls) {
            throw InputError("g' decreases near x = " + monotonicity.where->midpoint().str(8),
                             "give a convex profile: g' must not decrease")
                .at(scene_.file, scene_.profile_line);
        }
        return monotonicity.kind == contact::SlopeMonotonicity::Kind::rises;
    }

    BoundedValue value(const AskedValue& asked) override {
        const QuantityRow& row = evaluated_row(asked.quantity);
        if (row.searched != nullptr) {
            return extent(asked.edge, asked.k).*row.searched;
        }
        if (asked.quantity == Quantity::cycle_energy && !encloses_cycle_energy(scene_)) {
            return others().value(asked);
        }
        if (row.of_friction() || (scene_.slips() && row.quantity == Quantity::q)) {
            slips_.check();
        }
        if (const auto given = stated(row)) { // an enclosure of it would never round down or up
            return {Ball(*given, plan_.bits), true, row.route(scene_, plan_), given};
        }
        BoundedValue value = bounded(
            balls_.refine([&](BallLevel& level) { return row.ball(level, asked); },
                          [&](ExactValues& exact) {
                              return row.exact != nullptr ? row.exact(exact, asked)
                                                          : formula::ExactNumber::unknown();
                          },
                          plan_.digits, row.cancels_little ? plan_.narrow_bits : plan_.bits),
            row.route(scene_, plan_), [&](ValueRoute& other) { return other.value(asked); });
        if (row.distance_of && places_.known(*row.distance_of)) {
            value.exactly = places_.known(*row.distance_of);
        }
        return value;
    }

    BoundedValue place(contact::Edge edge, const Distance& u) override {
        places_.refuse_outside(edge, u);
        return place_of(edge, u);
    }

    ContactValues contact() override {
        work_.counts.resultants += plan_.resultants ? 2 : 0;
        return contact_values(*this, scene_, plan_);
    }

    PointValues at(contact::Edge edge, const Distance& u, bool p, bool q) override {
        places_.refuse_outside(edge, u);
        const bool together = q && scene_.shear->path == contact::LoadingPath::together;
        (balls_.closed() ? work_.counts.closed_forms : work_.counts.quadratures) +=
            p || together ? 1 : 0;
        work_.counts.shear_points += q ? 1 : 0;
        count_ratio(together);
        PointValues values;
        values.x = place_of(edge, u);
        AskedValue asked{.edge = edge, .u = u.number()};
        if (!u.number()) {
            asked.place = u;
            values.u = bounded(
                balls_.refine([&](BallLevel& level) { return level.distance(u); },
                              [&](ExactValues& exact) { return exact.u(u); }, plan_.digits,
                              plan_.narrow_bits),
                "given", [&](ValueRoute& other) { return *other.at(edge, u, false, false).u; });
        }
        if (p) {
            asked.quantity = Quantity::p;
            values.p = value(asked);
        }
        if (q) {
            asked.quantity = Quantity::q;
            values.q = value(asked);
        }
        std::optional<PointValues> other;
        const auto instead = [&]() -> const PointValues& {
            if (!other) {
                other = others().at(edge, u, p, q);
            }
            return *other;
        };
        if (q && scene_.slips()) {
            values.state = slips_.state(edge, u);
            if (!values.state) {
                values.state = instead().state;
            }
        }
        if (plan_.terms == 0) {
            return values;
        }
        const bool q_terms = q && plan_.expand_shear;
        count_expansions(edge, p, q_terms);
        for (std::size_t i = 0; i < scene_.ask.terms.size(); ++i) {
            if (p) {
                values.p_local.push_back(
                    approximation(edge, u, i, false, [&] { return instead().p_local.at(i); }));
            }
            if (q_terms) {
                values.q_local.push_back(
                    approximation(edge, u, i, true, [&] { return instead().q_local.at(i); }));
            }
        }
        return values;
    }

    EdgeValues expansion(contact::Edge edge, bool p, bool q) override {
        count_expansions(edge, p, q);
        EdgeValues values;
        values.edge = edge;
        const bool together = scene_.shear && scene_.shear->path == contact::LoadingPath::together;
        values.s_half_powers = together ? 1 : -1;
        for (std::size_t k = 0; k < plan_.terms; ++k) {
            if (p) {
                values.c.push_back(value({Quantity::c, k, edge}));
            }
            if (q) {
                values.s.push_back(value({Quantity::s, k, edge}));
            }
        }
        return values;
    }

    ExtentValues extent(contact::Edge edge, std::size_t n) override {
        ++work_.counts.extents;
        if (auto found = enclosed_extent(balls_, scene_, plan_, edge, n)) {
            return std::move(*found);
        }
        ExtentValues sampled = others().extent(edge, n);
        for (BoundedValue* v : {&sampled.first_exit, &sampled.measure, &sampled.first_exit_fraction,
                                &sampled.measure_fraction}) {
            v->route = "scan, undecided in balls";
        }
        return sampled;
    }

    StickValues stick() override {
        ++work_.counts.stick_zones;
        slips_.check();
        StickValues values;
        values.a = value({Quantity::stick_a});
        values.b = value({Quantity::stick_b});
        auto ratio = slips_.load_ratio();
        values.load_ratio = ratio ? std::move(*ratio) : others().stick().load_ratio;
        values.in_proportion = slips_.in_proportion();
        if (plan_.slip && scene_.shear->bulk_tension.sign() != 0) {
            const bool forwards = scene_.shear->Q.sign() > 0;
            values.least_tension =
                slips_.tension_limit(forwards ? contact::Edge::right : contact::Edge::left);
            values.most_tension =
                slips_.tension_limit(forwards ? contact::Edge::left : contact::Edge::right);
        }
        values.cycle_energy = cycle_energy_of(*this, scene_, plan_);
        return values;
    }

    SlipValues slip(contact::Edge edge) override {
        ++work_.counts.slip_sizes;
        SlipValues values;
        values.edge = edge;
        values.size = value({.quantity = Quantity::slip, .edge = edge});
        std::optional<SlipValues> other;
        for (std::size_t i = 0; i < scene_.ask.terms.size(); ++i) {
            auto terms = slips_.terms(edge, scene_.ask.terms[i]);
            if (!terms) {
                other = other ? std::move(other) : others().slip(edge);
                terms = other->terms.at(i);
            }
            values.terms.push_back(std::move(*terms));
        }
        return values;
    }

private:
    template <class Instead>
    [[nodiscard]] BoundedValue bounded(std::optional<BallRefinement::Found> x, const char* route,
                                       const Instead& instead) {
        return x ? BoundedValue{std::move(x->value), true, route, std::move(x->exactly)}
                 : instead(others());
    }
    /// A value that the scene gives.
    [[nodiscard]] std::optional<Rational> stated(const QuantityRow& row) const {
        const formula::Exact* given = row.given != nullptr ? row.given(scene_) : nullptr;
        return given != nullptr ? rational_of(*given) : std::nullopt;
    }
    /// The coordinate x of the point u, which is inside the contact.
    [[nodiscard]] BoundedValue place_of(contact::Edge edge, const Distance& u) {
        return bounded(places_.x(edge, u), "given",
                       [&](ValueRoute& other) { return other.place(edge, u); });
    }
    template <class Instead>
    [[nodiscard]] Approximation approximation(contact::Edge edge, const Distance& u, std::size_t i,
                                              bool shear, const Instead& instead) {
        const std::size_t n = scene_.ask.terms[i];
        const auto local =
            balls_.refine([&](BallLevel& level) { return level.sum(edge, u, n, shear); },
                          [&](ExactValues& exact) { return exact.sum(edge, exact.u(u), n, shear); },
                          plan_.digits);
        const auto error = balls_.refine(
            [&](BallLevel& level) { return abs(level.relative_error(edge, u, n, shear)); },
            [&](ExactValues& exact) { return abs(exact.error(edge, exact.u(u), n, shear)); },
            plan_.error_digits());
        if (!local || !error) {
            return instead();
        }
        return {n,
                {local->value, true, "series", local->exactly},
                {error->value, true, "series", error->exactly}};
    }
    void count_expansions(contact::Edge edge, bool p, bool q) {
        const bool together = q && scene_.shear->path == contact::LoadingPath::together;
        count_ratio(together);
        if ((p || together) && expanded_.insert({edge, false}).second) {
            ++work_.counts.expansions;
        }
        if (q && expanded_.insert({edge, true}).second) {
            ++work_.counts.shear_expansions;
        }
    }
    void count_ratio(bool together) {
        if (together && !std::exchange(ratio_counted_, true)) {
            ++work_.counts.resultants;
        }
    }
    /// The routes in Real. Their work is not counted: the work of this route is counted instead.
    [[nodiscard]] ValueRoute& others() {
        if (!others_) {
            others_ = make_real_route(scene_, plan_, work_of_others_);
        }
        return *others_;
    }

    const Scene& scene_;
    const Plan& plan_;
    contact::Work& work_;
    BallRefinement balls_;
    BallPlaces places_;
    BallSlips slips_;
    std::set<std::pair<contact::Edge, bool>> expanded_;
    bool ratio_counted_ = false;
    contact::Work work_of_others_;
    std::unique_ptr<ValueRoute> others_;
};

} // namespace

std::unique_ptr<ValueRoute> make_ball_route(const Scene& scene, const Plan& plan,
                                            contact::Work& work) {
    try {
        const contact::Work before = work;
        auto route = std::make_unique<BallRoute>(scene, plan, work);
        if (route->slope_rises()) {
            return route;
        }
        work = before;
        return make_real_route(scene, plan, work);
    } catch (const InputError& error) {
        if (error.file().empty()) {
            throw error.at(scene.file, scene.load_line);
        }
        throw;
    }
}

} // namespace edgeproof::scene
