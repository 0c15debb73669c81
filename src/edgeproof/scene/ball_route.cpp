// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/curved/slope_monotonicity.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/ball_extent.hpp"
#include "edgeproof/contact/profile/profile_checks.hpp"
#include "edgeproof/formula/exact/exact_ball.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/ball_level.hpp"
#include "edgeproof/scene/exact_values.hpp"
#include "edgeproof/scene/value_route.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace edgeproof::scene {
namespace {

/// A value within 1e-400 of zero beside the contact's own scale counts as zero.
constexpr long zero_bits = 1330;
/// A value that is still infinite at so many bits is left to the routes in Real to refuse.
constexpr long least_last_bits = 1L << 14;

class BallRoute : public ValueRoute {
public:
    BallRoute(const Scene& scene, const Plan& plan, contact::Work& work)
        : scene_(scene), plan_(plan), work_(work),
          last_bits_(std::max(least_last_bits, 8 * plan.bits)), last_curved_bits_(8 * plan.bits) {
        work.counts.consistency += scene.symmetric() ? 0 : 1;
        work.counts.tilts += scene.punch ? 1 : 0;
        work.counts.load_inversions += scene.load.kind == contact::Load::Kind::force ? 1 : 0;
        if (auto length = settle([](BallLevel& level) { return level.length(); },
                                 [](ExactValues& exact) { return exact.length(); },
                                 {plan.digits.count, Rounding::nearest, false}, plan.narrow_bits)) {
            length_ = std::move(length->value);
        }
        if (scene.load.kind == contact::Load::Kind::right_edge) {
            known_[contact::Edge::right] = rational_of(scene.load.value);
            if (scene.symmetric()) {
                known_[contact::Edge::left] = known_[contact::Edge::right];
            }
        } else if (length_) {
            know(contact::Edge::right);
        }
        if (length_) {
            know(contact::Edge::left);
        }
        // No contact at any precision: the routes in Real say why.
        if (!length_) {
            (void)others();
        }
    }

    /// Whether g' is proved not to decrease in the contact, on which all that is proved of a curved
    /// profile rests. Throws InputError where it is proved to decrease.
    [[nodiscard]] bool slope_rises() {
        if (closed() || !length_) {
            return true; // decided exactly; or nothing is proved in any case
        }
        const BallLevel* level = at_level(length_->bits());
        check_reach(*scene_.profile, level->a(), level->b());
        const contact::SlopeMonotonicity course =
            monotonicity_of_slope(*scene_.profile, level->a(), level->b());
        if (course.kind == contact::SlopeMonotonicity::Kind::falls) {
            throw InputError("g' decreases near x = " + course.where->midpoint().str(8),
                             "give a convex profile: g' must not decrease")
                .at(scene_.file, scene_.profile_line);
        }
        return course.kind == contact::SlopeMonotonicity::Kind::rises;
    }

    ContactValues contact() override {
        ContactValues values;
        const bool given = scene_.load.kind == contact::Load::Kind::right_edge;
        const char* by_load = given ? "given" : "from P";
        values.a = narrow([](BallLevel& level) { return level.a(); },
                          [](ExactValues& exact) { return exact.a(); }, by_load,
                          [&](ValueRoute& other) { return other.contact().a; });
        values.b = narrow([](BallLevel& level) { return level.b(); },
                          [](ExactValues& exact) { return exact.b(); },
                          scene_.symmetric() ? by_load : "consistency",
                          [&](ValueRoute& other) { return other.contact().b; });
        if (known_[contact::Edge::right]) {
            values.a.exactly = known_[contact::Edge::right];
        }
        if (known_[contact::Edge::left]) {
            values.b.exactly = known_[contact::Edge::left];
        }
        if (scene_.punch) {
            values.alpha =
                bounded_value([](BallLevel& level) { return level.tilt().alpha; },
                              [](ExactValues&) { return formula::ExactNumber::unknown(); }, "tilt",
                              [&](ValueRoute& other) { return *other.contact().alpha; });
            const BallLevel* first = at_level(plan_.narrow_bits);
            if (first != nullptr && first->tilt().exactly_zero) {
                values.alpha->exactly = Rational(0);
            }
        }
        if (plan_.resultants) {
            work_.counts.resultants += 2;
            values.force = bounded_value([](BallLevel& level) { return level.force(); },
                                         [](ExactValues& exact) { return exact.force(); },
                                         given ? "contact-law" : "given",
                                         [&](ValueRoute& other) { return *other.contact().force; });
            if (!given) {
                values.force->exactly = rational_of(scene_.load.value);
            }
            values.moment =
                bounded_value([](BallLevel& level) { return level.moment(); },
                              [](ExactValues& exact) { return exact.moment(); },
                              scene_.moment ? "given" : "contact-law",
                              [&](ValueRoute& other) { return *other.contact().moment; });
            if (scene_.moment) {
                values.moment->exactly = rational_of(*scene_.moment);
            }
        }
        return values;
    }

    PointValues at(contact::Edge edge, const formula::Exact& u, bool p, bool q) override {
        const Ball from = ball_of(u, length_ ? length_->bits() : plan_.bits);
        if (length_ && !certainly_less(from, *length_)) {
            throw DomainError("the point lies outside the contact");
        }
        const bool together = q && scene_.shear->path == contact::LoadingPath::together;
        (closed() ? work_.counts.closed_forms : work_.counts.quadratures) += p || together ? 1 : 0;
        work_.counts.shear_points += q ? 1 : 0;
        count_ratio(together);
        PointValues values;
        std::optional<PointValues> other;
        const auto instead = [&](ValueRoute& route) -> const PointValues& {
            if (!other) {
                other = route.at(edge, u, p, q);
            }
            return *other;
        };
        values.x = place(edge, u, from, [&](ValueRoute& route) { return instead(route).x; });
        if (p) {
            values.p = narrow([&](BallLevel& level) { return level.p(edge, u); },
                              [&](ExactValues& exact) { return exact.p(edge, exactly(u)); },
                              closed() ? "closed-form" : "singular-integral",
                              [&](ValueRoute& route) { return *instead(route).p; });
        }
        if (q) {
            values.q = bounded_value([&](BallLevel& level) { return level.q(edge, u); },
                                     [&](ExactValues& exact) { return exact.q(edge, exactly(u)); },
                                     together ? "similar" : "full-stick",
                                     [&](ValueRoute& route) { return *instead(route).q; });
        }
        if (plan_.terms == 0) {
            return values;
        }
        count_expansions(edge, p, q);
        for (std::size_t i = 0; i < scene_.ask.terms.size(); ++i) {
            if (p) {
                values.p_local.push_back(approximation(edge, u, i, false, [&](ValueRoute& route) {
                    return instead(route).p_local.at(i);
                }));
            }
            if (q) {
                values.q_local.push_back(approximation(edge, u, i, true, [&](ValueRoute& route) {
                    return instead(route).q_local.at(i);
                }));
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
        std::optional<EdgeValues> other;
        const auto instead = [&](ValueRoute& route) -> const EdgeValues& {
            if (!other) {
                other = route.expansion(edge, p, q);
            }
            return *other;
        };
        for (std::size_t k = 0; k < plan_.terms; ++k) {
            if (p) {
                values.c.push_back(bounded_value(
                    [&](BallLevel& level) { return level.c(edge)[k]; },
                    [&](ExactValues& exact) { return exact.c(edge, plan_.terms).at(k); }, "series",
                    [&](ValueRoute& route) { return instead(route).c.at(k); }));
            }
            if (q) {
                values.s.push_back(bounded_value(
                    [&](BallLevel& level) { return level.s(edge)[k]; },
                    [&](ExactValues& exact) { return exact.s(edge, plan_.terms).at(k); },
                    together ? "similar" : "full-stick",
                    [&](ValueRoute& route) { return instead(route).s.at(k); }));
            }
        }
        return values;
    }

    ExtentValues extent(contact::Edge edge, std::size_t n) override {
        ++work_.counts.extents;
        if (auto found = enclosed_extent(edge, n)) {
            return std::move(*found);
        }
        ExtentValues sampled = others().extent(edge, n);
        for (BoundedValue* v : {&sampled.first_exit, &sampled.measure, &sampled.first_exit_fraction,
                                &sampled.measure_fraction}) {
            v->route = "scan, undecided in balls";
        }
        return sampled;
    }

private:
    /// Nothing where the budget does not decide.
    [[nodiscard]] std::optional<ExtentValues> enclosed_extent(contact::Edge edge, std::size_t n) {
        contact::BallExtentSearch search(
            [&](long bits) -> const contact::ProvedPressure& {
                BallLevel* level = at_level(bits);
                if (level == nullptr) {
                    throw BudgetError("so few bits do not enclose the edges");
                }
                return level->proved_pressure();
            },
            edge, n, *scene_.ask.tolerance, scene_.ask.part);
        const auto settled = [&](const Ball& x) { return settles(x, plan_.digits); };
        std::optional<contact::EnclosedExtents> best;
        ExactExtents exactly;
        const long last = closed() ? last_bits_ : last_curved_bits_;
        for (long bits = plan_.bits; bits <= last; bits *= 2) {
            try {
                best = search.at(bits);
            } catch (const BudgetError&) {
                if (search.evaluations() > contact::BallExtentSearch::most_evaluations) {
                    break;
                }
                continue;
            }
            exactly = exact_extents(*best, *at_level(bits), edge, n);
            bool all = (exactly.first_exit || settled(best->first_exit)) &&
                       (exactly.measure || settled(best->measure));
            for (std::size_t k = 0; k < best->crossings.size(); ++k) {
                all = all && (exactly.crossings[k] || settled(best->crossings[k]));
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
            return q && exactly.length ? std::optional(Rational(*q / *exactly.length))
                                       : std::nullopt;
        };
        ExtentValues values;
        values.edge = edge;
        values.n = n;
        values.leaves = best->leaves;
        values.first_exit = proved(best->first_exit, exactly.first_exit);
        values.measure = proved(best->measure, exactly.measure);
        values.first_exit_fraction =
            proved(best->first_exit / best->length, of_length(exactly.first_exit));
        values.measure_fraction = proved(best->measure / best->length, of_length(exactly.measure));
        for (std::size_t k = 0; k < best->crossings.size(); ++k) {
            values.crossings.push_back(proved(best->crossings[k], exactly.crossings[k]));
        }
        if (scene_.ask.process_zone) {
            values.covers_zone = certainly_less(
                ball_of(*scene_.ask.process_zone, best->length.bits()), best->first_exit);
        }
        return values;
    }
    /// What is a rational number by its exact form.
    struct ExactExtents {
        std::optional<Rational> length;
        std::optional<Rational> first_exit;
        std::optional<Rational> measure;
        std::vector<std::optional<Rational>> crossings;
    };
    [[nodiscard]] ExactExtents exact_extents(const contact::EnclosedExtents& found,
                                             const BallLevel& level, contact::Edge edge,
                                             std::size_t n) {
        ExactExtents result;
        result.crossings.resize(found.crossings.size());
        const auto part = [&](const formula::Exact& fraction) {
            return exact_value([&](ExactValues& e) { return e.length() * exactly(fraction); },
                               level, found.length * ball_of(fraction, found.length.bits()));
        };
        result.length = part(formula::Exact::of(Rational(1)));
        if (!result.length) {
            return result;
        }
        bool all = true;
        for (std::size_t k = 0; k < found.crossings.size(); ++k) {
            result.crossings[k] =
                found.single[k] ? exact_crossing(found.crossings[k], level, edge, n) : std::nullopt;
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
    /// The crossing in a ball that holds one, where the error there is the tolerance exactly.
    [[nodiscard]] std::optional<Rational> exact_crossing(const Ball& u, const BallLevel& level,
                                                         contact::Edge edge, std::size_t n) {
        const auto q =
            may_be_a_limit(u, plan_.digits) ? contact::simplest_rational(u) : std::nullopt;
        if (!q || *q <= 0) {
            return {};
        }
        const formula::ExactNumber tolerance = exactly(*scene_.ask.tolerance);
        const auto off = [&](ExactValues& e) {
            const formula::ExactNumber error = e.error(edge, formula::ExactNumber(*q), n, false);
            return error == tolerance || error == -tolerance ? formula::ExactNumber(*q)
                                                             : formula::ExactNumber::unknown();
        };
        return exact_value(off, level, u);
    }
    [[nodiscard]] bool closed() const { return plan_.route == contact::Route::closed_form; }
    /// A value, and what it is exactly where that is a rational number and was looked at.
    struct Found {
        Ball value;
        std::optional<Rational> exactly = {};
    };
    /// f at more and more bits, until its digits are settled, or it cannot be told from zero, or
    /// the bits are used up. Nothing where it has no finite value. Where the ball has the digits
    /// and yet does not round alike, more bits cannot help if the value lies exactly on the limit:
    /// so the exact form is looked at first.
    template <class F, class Exactly>
    [[nodiscard]] std::optional<Found> settle(const F& f, const Exactly& exactly,
                                              const Digits& digits, long first = 0) {
        std::optional<Found> best;
        bool looked = false;
        const long last = closed() ? last_bits_ : last_curved_bits_;
        for (long bits = first != 0 ? first : plan_.bits; bits <= last; bits = after(bits)) {
            BallLevel* level = at_level(bits);
            if (level == nullptr) {
                continue;
            }
            Ball x = f(*level);
            if (!x.is_finite()) {
                if (level->edge_may_be_on_knot() && bits >= plan_.bits + zero_bits) {
                    break; // no number of bits tells the two apart
                }
                continue;
            }
            best = Found{std::move(x)};
            if (!looked && may_be_a_limit(best->value, digits)) {
                looked = true;
                best->exactly = exact_value(exactly, *level, best->value);
            }
            if (best->exactly || settles(best->value, digits) ||
                (contains_zero(best->value) && bits >= plan_.bits + zero_bits)) {
                break;
            }
        }
        return best;
    }
    /// The rational number that the value is by its exact form, if it is known to be one.
    template <class Exactly>
    [[nodiscard]] std::optional<Rational> exact_value(const Exactly& exactly,
                                                      const BallLevel& level, const Ball& near) {
        ExactValues* exact = exact_values(level);
        if (exact == nullptr) {
            return {};
        }
        try {
            auto q = exactly(*exact).rational();
            return q && contains(near, *q) ? q : std::nullopt;
        } catch (const DomainError&) { // a series that the exact form does not have
            return {};
        }
    }
    [[nodiscard]] static formula::ExactNumber exactly(const formula::Exact& x) {
        return formula::ExactNumber::of(x.expr());
    }
    /// Made when it is first asked for. Null under a tilt that was solved for.
    [[nodiscard]] ExactValues* exact_values(const BallLevel& level) {
        if (!exact_) {
            if (!scene_.punch) {
                exact_.emplace(scene_, *scene_.profile, level.a(), level.b());
            } else if (level.tilt().exactly_zero) {
                exact_.emplace(scene_, level.tilt().near, level.a(), level.b());
            }
        }
        return exact_ ? &*exact_ : nullptr;
    }
    /// The bits of the next attempt.
    [[nodiscard]] long after(long bits) const { return bits < plan_.bits ? plan_.bits : 2 * bits; }
    template <class F, class Exactly, class Instead>
    [[nodiscard]] BoundedValue bounded_value(const F& f, const Exactly& exactly, const char* route,
                                             const Instead& instead) {
        return bounded(settle(f, exactly, plan_.digits), route, instead);
    }
    /// Of what cancels little, so that fewer bits will do at first.
    template <class F, class Exactly, class Instead>
    [[nodiscard]] BoundedValue narrow(const F& f, const Exactly& exactly, const char* route,
                                      const Instead& instead) {
        return bounded(settle(f, exactly, plan_.digits, plan_.narrow_bits), route, instead);
    }
    template <class Instead>
    [[nodiscard]] BoundedValue bounded(std::optional<Found> x, const char* route,
                                       const Instead& instead) {
        if (x) {
            return {std::move(x->value), true, route, std::move(x->exactly)};
        }
        return instead(others());
    }
    template <class Instead>
    [[nodiscard]] Approximation approximation(contact::Edge edge, const formula::Exact& u,
                                              std::size_t i, bool shear, const Instead& instead) {
        const std::size_t n = scene_.ask.terms[i];
        const auto local =
            settle([&](BallLevel& level) { return level.sum(edge, u, n, shear); },
                   [&](ExactValues& exact) { return exact.sum(edge, exactly(u), n, shear); },
                   plan_.digits);
        const auto error = settle(
            [&](BallLevel& level) {
                const Ball value = shear ? level.q(edge, u) : level.p(edge, u);
                return abs(Ball(1 - level.sum(edge, u, n, shear) / value));
            },
            [&](ExactValues& exact) { return abs(exact.error(edge, exactly(u), n, shear)); },
            plan_.error_digits());
        if (!local || !error) {
            return instead(others());
        }
        return {n,
                {local->value, true, "series", local->exactly},
                {error->value, true, "series", error->exactly}};
    }
    /// x of the point u, which is `from` in a ball.
    template <class Instead>
    [[nodiscard]] BoundedValue place(contact::Edge edge, const formula::Exact& u, const Ball& from,
                                     const Instead& instead) {
        const auto& known = known_[edge];
        const Rational* distance = u.expr().rational();
        const bool right = edge == contact::Edge::right;
        if (known && distance != nullptr) {
            const Rational x = right ? Rational(*known - *distance) : Rational(*distance - *known);
            // The text of what is known exactly is made of that: a ball of any width will do.
            const long bits = plan_.digits.binary64 ? std::max(from.bits(), 128L) : from.bits();
            return {Ball(x, bits), true, "given", x};
        }
        return narrow(
            [&](BallLevel& level) {
                const Ball at = ball_of(u, level.bits());
                return right ? level.a() - at : at - level.b();
            },
            [&](ExactValues& exact) { return exact.x(edge, exactly(u)); }, "given", instead);
    }
    /// Keeps where an edge is, if that is a rational number, and known.
    void know(contact::Edge edge) {
        if (const auto exact = at_level(length_->bits())->known(edge)) {
            known_[edge] = rational_of(*exact);
        }
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
    /// Null where so few bits do not isolate the edges.
    [[nodiscard]] BallLevel* at_level(long bits) {
        const auto known = levels_.find(bits);
        if (known != levels_.end()) {
            return known->second.get();
        }
        work_.raised += bits > plan_.bits ? 1 : 0;
        auto& slot = levels_[bits];
        try {
            slot = std::make_unique<BallLevel>(scene_, plan_, edges_, bits);
            const auto a = slot->known(contact::Edge::right);
            const auto b = slot->known(contact::Edge::left);
            if (a && b && !scene_.symmetric()) {
                edges_ = contact::ExactEdges{*a, *b};
            }
        } catch (const BudgetError&) {
        } catch (const DomainError&) {
        }
        return slot.get();
    }
    /// The routes in Real; what they do stands in for what was counted here.
    [[nodiscard]] ValueRoute& others() {
        if (!others_) {
            others_ = make_real_route(scene_, plan_, work_of_others_);
        }
        return *others_;
    }

    const Scene& scene_;
    const Plan& plan_;
    contact::Work& work_;
    long last_bits_;
    long last_curved_bits_; ///< integrals cost more
    std::map<long, std::unique_ptr<BallLevel>> levels_;
    std::optional<contact::ExactEdges> edges_; ///< where a level proved them
    std::optional<Ball> length_;
    std::map<contact::Edge, std::optional<Rational>>
        known_; ///< distances of the edges from the origin
    std::optional<ExactValues> exact_;
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
