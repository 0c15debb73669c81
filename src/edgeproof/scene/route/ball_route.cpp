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
        if (row.searched) {
            return RowsAt({&searched(asked), 1}).at(asked.quantity, asked.k);
        }
        if (asked.quantity == Quantity::cycle_energy && !encloses_cycle_energy(scene_)) {
            return others().value(asked);
        }
        if (row.of_friction() || (scene_.slips() && row.quantity == Quantity::q)) {
            slips_.check();
        }
        count(asked);
        if (const auto given = stated(row)) { // an enclosure of it would never round down or up
            return {Ball(*given, plan_.bits), true, row.route(scene_, plan_), given};
        }
        if (asked.quantity == Quantity::x || asked.quantity == Quantity::u) {
            const Distance u = asked.distance();
            places_.refuse_outside(asked.edge, u);
            if (const auto x =
                    asked.quantity == Quantity::x ? places_.known_x(asked.edge, u) : std::nullopt) {
                return {Ball(*x, places_.bits()), true, row.route(scene_, plan_), x};
            }
        }
        auto found = balls_.refine([&](BallLevel& level) { return row.ball(level, asked); },
                                   [&](ExactValues& exact) {
                                       return row.exact != nullptr
                                                  ? row.exact(exact, asked)
                                                  : formula::ExactNumber::unknown();
                                   },
                                   row.short_error ? plan_.error_digits() : plan_.digits,
                                   row.cancels_little ? plan_.narrow_bits : plan_.bits);
        if (!found) {
            return others().value(asked);
        }
        if (row.distance_of && places_.known(*row.distance_of)) {
            found->exactly = places_.known(*row.distance_of);
        }
        return {std::move(found->value), true, row.route(scene_, plan_), std::move(found->exactly)};
    }

    contact::SlipState state(contact::Edge edge, const Distance& u) override {
        const auto found = slips_.state(edge, u);
        return found ? *found : others().state(edge, u);
    }

    std::vector<Row> extent(contact::Edge edge, std::size_t n) override {
        ++work_.counts.extents;
        if (auto found = enclosed_extent(balls_, scene_, plan_, edge, n)) {
            return std::move(*found);
        }
        std::vector<Row> sampled = others().extent(edge, n);
        for (Row& row : sampled) {
            if (row.asked.quantity != Quantity::crossing) {
                row.value->route = "scan, undecided in balls";
            }
        }
        return sampled;
    }

    std::vector<Row> slip_terms(contact::Edge edge, std::size_t n) override {
        slips_.check();
        std::vector<Row> rows = slips_.terms(edge, n);
        return rows.empty() ? others().slip_terms(edge, n) : rows;
    }

    bool in_proportion() override { return slips_.in_proportion(); }

private:
    /// A value that the scene gives.
    [[nodiscard]] std::optional<Rational> stated(const QuantityRow& row) const {
        const formula::Exact* given = row.given != nullptr ? row.given(scene_) : nullptr;
        return given != nullptr ? rational_of(*given) : std::nullopt;
    }
    [[nodiscard]] bool is_similar() const {
        return scene_.shear && scene_.shear->path == contact::LoadingPath::together;
    }
    /// Counts the work of a value.
    void count(const AskedValue& asked) {
        contact::Counts& counts = work_.counts;
        const bool of_shear = row_of(asked.quantity).needs == QuantityRow::Needs::shear;
        const bool similar = of_shear && is_similar();
        if (similar && !std::exchange(ratio_counted_, true)) {
            ++counts.resultants;
        }
        switch (asked.quantity) {
        case Quantity::P:
        case Quantity::M:
            ++counts.resultants;
            break;
        case Quantity::p:
            count_pressure();
            if (is_similar()) {
                pressed_.emplace(asked.edge, asked.distance());
            }
            break;
        case Quantity::q:
            ++counts.shear_points;
            // A traction similar to p uses the pressure that was computed just before.
            if (similar && pressed_ != std::pair(asked.edge, asked.distance())) {
                count_pressure();
            }
            pressed_.reset();
            break;
        case Quantity::c:
        case Quantity::local:
        case Quantity::rel:
            counts.expansions += expanded_.insert({asked.edge, false}).second ? 1 : 0;
            break;
        case Quantity::s:
        case Quantity::q_local:
        case Quantity::q_rel:
            counts.expansions += similar && expanded_.insert({asked.edge, false}).second ? 1 : 0;
            counts.shear_expansions += expanded_.insert({asked.edge, true}).second ? 1 : 0;
            break;
        case Quantity::stick_a:
            ++counts.stick_zones;
            break;
        case Quantity::slip:
            ++counts.slip_sizes;
            break;
        default:
            break;
        }
    }
    void count_pressure() {
        ++(balls_.closed() ? work_.counts.closed_forms : work_.counts.quadratures);
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
    /// The place of the last pressure, for q.
    std::optional<std::pair<contact::Edge, Distance>> pressed_;
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
