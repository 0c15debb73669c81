// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/enclosure/ball_relative_error.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/route/real_level.hpp"
#include "edgeproof/scene/route/value_route.hpp"

#include <algorithm>
#include <map>

namespace edgeproof::scene {
namespace {

constexpr unsigned most_extra = 4000;

class RealRoute : public ValueRoute {
public:
    RealRoute(const Scene& scene, const Plan& plan, Work& work)
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

    /// If the place depends on the edges, the function is evaluated at the place and at the end of
    /// its error interval; the difference is the error of the value.
    BoundedValue value(const AskedValue& asked) override {
        const QuantityRow& row = evaluated_row(asked.quantity);
        if (row.searched) {
            return RowsAt({&searched(asked), 1}).at(asked.quantity, asked.k);
        }
        if (row.at_point() && !asked.distance().number()) {
            const ByEdges place = by_edges(*asked.place);
            if (asked.quantity == Quantity::x || asked.quantity == Quantity::u) {
                return asked.quantity == Quantity::x ? place.x : place.u;
            }
            const BoundedValue near = at_number(row, asked, place.near);
            const BoundedValue end = at_number(row, asked, place.end);
            return {Ball::hull(near.value, end.value), false, near.route};
        }
        if (row.at_point()) {
            return at_number(row, asked, *asked.distance().number());
        }
        work_.counts.stick_zones += asked.quantity == Quantity::stick_a ? 1 : 0;
        work_.counts.slip_sizes += asked.quantity == Quantity::slip ? 1 : 0;
        return evaluated(row, asked, *levels_[0]);
    }

    contact::SlipState state(Edge edge, const Distance& u) override {
        const Exact at = u.number() ? *u.number() : by_edges(u).near;
        return levels_[0]->slip().sticks(edge, at.to<Real>()) ? contact::SlipState::stick
                                                              : contact::SlipState::slip;
    }

    bool in_proportion() override {
        const contact::NormalContact& contact = levels_[0]->contact();
        const PrecisionScope scope(contact.a().precision());
        return same_sign_at_both_edges(
            Real(contact.a() + contact.b()),
            contact::ShearLoad<Real>{scene_.shear->Q.to<Real>(),
                                     scene_.shear->bulk_tension.to<Real>()});
    }

    std::vector<Row> search(const AskedValue& asked) override {
        const AskedValue of{asked.quantity, asked.k, asked.edge, {}, scene_.ask.tolerance};
        return row_of(asked.quantity).group == QuantityGroup::slip ? slip_terms(of) : extent(of);
    }

private:
    [[nodiscard]] std::vector<Row> slip_terms(const AskedValue& asked) {
        RealLevel& level = *levels_[0];
        const contact::PartialSlip& s = level.slip();
        const PrecisionScope scope(level.contact().a().precision());
        if (!slip_series_) {
            slip_series_ = s.series(scene_.ask.most_terms());
        }
        const bool right = asked.edge == Edge::right;
        const Real size = contact::slip_sum(right ? slip_series_->right : slip_series_->left,
                                            asked.k, s.load_ratio());
        return slip_rows(asked, level.sound(size, "series"),
                         estimated(Real(abs(Real(1 - size / s.size(asked.edge)))),
                                   Real(2 * s.estimate()), "series"));
    }
    [[nodiscard]] std::vector<Row> extent(const AskedValue& asked) {
        ++work_.counts.extents;
        const contact::Extents e = within_tolerance(levels_[0]->contact(), asked.edge, asked.k,
                                                    *asked.tolerance, scene_.ask.part);
        const PrecisionScope scope(e.length.precision());
        // Each crossing has the error of the worst one; the measure adds the errors.
        const Real error =
            e.estimate * e.length +
            e.length * pow(Real(10), -static_cast<int>(plan_.digits.count + kept_digits));
        const auto near = [&](const Real& x, const Real& by) { return estimated(x, by, "scan"); };
        const Real all = error * static_cast<unsigned>(e.crossings.size() + 1);
        std::vector<BoundedValue> crossings;
        for (const Real& u : e.crossings) {
            crossings.push_back(near(u, Real(u * (e.estimate + error / e.length))));
        }
        return extent_rows(
            asked,
            {near(e.first_exit, Real(e.first_exit * (e.estimate + error / e.length))),
             near(Real(e.first_exit / e.length),
                  Real(e.first_exit / e.length * (e.estimate + error / e.length))),
             near(e.measure, all), near(Real(e.measure / e.length), Real(all / e.length))},
            crossings, e.leaves);
    }
    /// A distance that depends on the edges: a number near it, and the end of its error interval.
    struct ByEdges {
        Exact near;
        Exact end;
        BoundedValue u;
        BoundedValue x;
    };
    [[nodiscard]] ByEdges by_edges(const Distance& u) const {
        const RealLevel& level = *levels_.at(0);
        const Ball a = level.distance(Edge::right).value;
        const Ball b = level.distance(Edge::left).value;
        const Ball from = u.enclosure(a, b, level.bits());
        if (!certainly_positive(from)) {
            throw DomainError("the point lies outside the contact");
        }
        const Rational near = contact::exact_value(from.midpoint());
        return {Exact::of(near),
                Exact::of(near + contact::exact_value(from.radius())),
                {from, false, "given"},
                {u.x_enclosure(a, b, level.bits()), u.x().has_value(), "given"}};
    }
    void check_inside(const Exact& u) const {
        const RealLevel& level = *levels_.at(0);
        if (!certainly_less(ball_of(u, level.bits()), Ball(level.distance(Edge::right).value +
                                                           level.distance(Edge::left).value))) {
            throw DomainError("the point lies outside the contact");
        }
    }
    /// The coordinate x, exact if the edge is given.
    [[nodiscard]] BoundedValue place_inside(Edge edge, const Exact& u) const {
        const RealLevel& level = *levels_.at(0);
        const bool given = scene_.load.kind == Load::Kind::right_edge &&
                           (edge == Edge::right || scene_.symmetric());
        if (given) {
            const Expr& a = scene_.load.value.expr();
            const Exact x(edge == Edge::right ? a - u.expr() : u.expr() - a);
            return {ball_of(x, level.bits()), true, "given", rational_of(x)};
        }
        const Ball from_edge = ball_of(u, level.bits());
        BoundedValue x = level.distance(edge);
        x.value = edge == Edge::right ? x.value - from_edge : from_edge - x.value;
        return x;
    }
    [[nodiscard]] BoundedValue at_number(const QuantityRow& row, AskedValue asked, const Exact& u) {
        check_inside(u);
        if (asked.quantity == Quantity::x) {
            return place_inside(asked.edge, u);
        }
        if (asked.quantity == Quantity::u) {
            return {ball_of(u, levels_[0]->bits()), true, "given", rational_of(u)};
        }
        asked.u = u;
        asked.place.reset();
        work_.counts.shear_points += asked.quantity == Quantity::q && scene_.slips() ? 1 : 0;
        return row.short_error ? with_more_digits(row, asked) : evaluated(row, asked, *levels_[0]);
    }
    [[nodiscard]] static BoundedValue evaluated(const QuantityRow& row, const AskedValue& asked,
                                                RealLevel& level) {
        if (row.real == nullptr) {
            throw Error("a " + std::string(row.name) + " is computed in balls only");
        }
        return row.real(level, asked);
    }
    /// A relative error: it is computed with more digits if it cancels.
    [[nodiscard]] BoundedValue with_more_digits(const QuantityRow& row, const AskedValue& asked) {
        const Digits digits = plan_.error_digits();
        std::optional<BoundedValue> result; // with fewer digits
        for (unsigned extra = 0;;) {
            BoundedValue error = evaluated(row, asked, at_level(extra));
            // If more digits did not help, still more will not help.
            if (result && !(error.value.radius() < result->value.radius())) {
                return *result;
            }
            result = error;
            if (has_digits(error.value, digits) || !error.value.is_finite()) {
                return error;
            }
            const Real lost = -log10(error.value.upper());
            const unsigned needed =
                lost > 0 ? static_cast<unsigned>(ceil(lost)) + digits.count : digits.count;
            const unsigned next = needed > plan_.digits.count ? needed - plan_.digits.count : 0;
            // Rounded up to steps, so that neighbouring points share one solved contact.
            extra = (std::max(next, 2 * extra + 1) + 15) / 16 * 16;
            if (extra > most_extra) {
                return *result;
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
    Work& work_;
    std::optional<Exact> alpha_;
    std::optional<Profile> profile_;
    std::map<unsigned, std::unique_ptr<RealLevel>> levels_;
    std::optional<contact::SlipSeries<Real>> slip_series_;
};

} // namespace

std::unique_ptr<ValueRoute> make_real_route(const Scene& scene, const Plan& plan, Work& work) {
    try {
        return std::make_unique<RealRoute>(scene, plan, work);
    } catch (const InputError& error) {
        throw error.file().empty() ? error.at(scene.file, scene.load_line) : error;
    } catch (const DomainError& error) {
        throw InputError(error.what(), "give a load that a contact of this profile can carry")
            .at(scene.file, scene.load_line);
    }
}

} // namespace edgeproof::scene
