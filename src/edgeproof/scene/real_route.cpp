// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/formula/exact/exact_ball.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/value_route.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace edgeproof::scene {
namespace {

/// Of the guard digits of a NormalContact, those that its coefficients and edges keep.
constexpr unsigned kept_digits = 8;
constexpr unsigned most_extra = 4000;
/// Digits of a tilt beyond those asked for.
constexpr unsigned tilt_digits = 20;

/// Everything at one number of digits: the scene's own, or more where a difference is small.
class Level {
public:
    Level(const contact::Profile& profile, const Scene& scene, const Plan& plan, unsigned digits,
          contact::Work* work)
        : scene_(scene), plan_(plan), digits_(digits),
          contact_(profile, scene.contact_modulus, scene.load, digits, work) {
        if (scene.shear) {
            shear_.emplace(contact_, *scene.shear, work);
        }
    }
    Level(const Level&) = delete; // shear_ refers to contact_
    Level& operator=(const Level&) = delete;

    [[nodiscard]] const contact::NormalContact& contact() const { return contact_; }
    [[nodiscard]] unsigned digits() const { return digits_; }
    [[nodiscard]] long bits() const { return formula::bits_for(contact_.a().precision()); }

    /// A value that has lost nothing beyond the guard.
    [[nodiscard]] BoundedValue sound(const Real& x, const char* route) const {
        const PrecisionScope scope(x.precision());
        return estimated(x, Real(abs(x) * unit()), route);
    }
    [[nodiscard]] const std::vector<BoundedValue>& c(contact::Edge edge) {
        auto& c = c_[edge];
        if (c.empty()) {
            raw_c_[edge] = contact_.expansion(edge, plan_.terms);
            const auto& raw = raw_c_[edge];
            const PrecisionScope scope(raw.front().precision());
            // A coefficient that cancels is good on the scale of its neighbours.
            const Real radius = contact_.convergence_radius(edge);
            Real scale = abs(raw.front());
            for (const Real& x : raw) {
                c.push_back(
                    estimated(x, Real(std::max(Real(abs(x)), scale) * unit()), series_name()));
                scale /= radius;
            }
        }
        return c;
    }
    [[nodiscard]] const std::vector<BoundedValue>& s(contact::Edge edge) {
        auto& s = s_[edge];
        if (s.empty()) {
            const bool together = scene_.shear->path == contact::LoadingPath::together;
            if (together) {
                (void)c(edge);
            }
            for (const auto& x : together ? shear_->similar_to(raw_c_[edge])
                                          : shear_->expansion(edge, plan_.terms)) {
                s.push_back(estimated(x.value, x.error, together ? "similar" : "series"));
            }
        }
        return s;
    }
    [[nodiscard]] int shear_half_powers() const {
        return shear_ ? shear_->leading_half_powers() : -1;
    }

    [[nodiscard]] std::string series_name() const {
        return contact_.edge_taken_on_knot() ? "series, an edge taken to be on a knot" : "series";
    }

    struct Values {
        std::optional<BoundedValue> p;
        std::optional<BoundedValue> q;
    };
    [[nodiscard]] Values at(contact::Edge edge, const formula::Exact& u, bool p, bool q) {
        Values values;
        std::optional<contact::Estimated> pressure;
        const bool together = q && scene_.shear->path == contact::LoadingPath::together;
        if (p || together) {
            pressure = contact_.pressure(edge, u, route());
            const PrecisionScope scope(pressure->working_digits);
            values.p = estimated(pressure->value, Real(abs(pressure->value) * pressure->estimate),
                                 route_name(pressure->route));
        }
        if (q) {
            const contact::EstimatedTraction t =
                together ? shear_->similar_to(*pressure) : shear_->traction(edge, u);
            values.q = estimated(t.value, t.error, together ? "similar" : "full-stick");
        }
        return values;
    }

private:
    /// Where balls give a power law's closed form no value, they give the one in Real none either.
    [[nodiscard]] contact::Route route() const {
        return plan_.proved && !contact_.profile().piecewise_linear()
                   ? contact::Route::singular_integral
                   : plan_.route;
    }
    [[nodiscard]] Real unit() const {
        return pow(Real(10), -static_cast<int>(digits_ + kept_digits));
    }

    const Scene& scene_;
    const Plan& plan_;
    unsigned digits_;
    contact::NormalContact contact_;
    std::optional<contact::ShearTraction> shear_;
    std::map<contact::Edge, std::vector<Real>> raw_c_;
    std::map<contact::Edge, std::vector<BoundedValue>> c_;
    std::map<contact::Edge, std::vector<BoundedValue>> s_;
};

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
        levels_[0] = std::make_unique<Level>(*profile_, scene, plan, plan.digits.count, &work);
    }

    ContactValues contact() override {
        const Level& level = *levels_[0];
        const bool force = scene_.load.kind == contact::Load::Kind::force;
        const BoundedValue load{ball_of(scene_.load.value, level.bits()), true, "given",
                                rational_of(scene_.load.value)};
        ContactValues values;
        values.a = force ? level.sound(level.contact().a(), "from P") : load;
        values.b = scene_.symmetric() ? values.a : level.sound(level.contact().b(), "consistency");
        if (alpha_) {
            const PrecisionScope scope(plan_.digits.count + tilt_digits);
            values.alpha = level.sound(alpha_->to<Real>(), "tilt");
        }
        if (plan_.resultants) {
            values.force = level.sound(level.contact().force(), "contact-law");
            values.moment = level.sound(level.contact().moment(), "contact-law");
            if (force) {
                values.force = load;
            }
            if (scene_.moment) {
                values.moment = BoundedValue{ball_of(*scene_.moment, level.bits()), true, "given",
                                             rational_of(*scene_.moment)};
            }
        }
        return values;
    }

    PointValues at(contact::Edge edge, const formula::Exact& u, bool p, bool q) override {
        Level& base = *levels_[0];
        if (!certainly_less(ball_of(u, base.bits()), Ball(length_of(contact::Edge::right).value +
                                                          length_of(contact::Edge::left).value))) {
            throw DomainError("the point lies outside the contact");
        }
        PointValues values;
        values.x = place(edge, u);
        const Level::Values found = base.at(edge, u, p, q);
        if (p) {
            values.p = found.p;
        }
        values.q = found.q;
        for (const std::size_t n :
             plan_.terms > 0 ? scene_.ask.terms : std::vector<std::size_t>{}) {
            if (p) {
                values.p_local.push_back(approximation(edge, u, n, found, false));
            }
            if (q) {
                values.q_local.push_back(approximation(edge, u, n, found, true));
            }
        }
        return values;
    }

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

    ExtentValues extent(contact::Edge edge, std::size_t n) override {
        ++work_.counts.extents;
        const contact::Extents e = within_tolerance(levels_[0]->contact(), edge, n,
                                                    *scene_.ask.tolerance, scene_.ask.part);
        const PrecisionScope scope(e.length.precision());
        ExtentValues values;
        values.edge = edge;
        values.n = n;
        values.leaves = e.leaves;
        // Each crossing carries the error of the worst; the measure adds them up.
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
    [[nodiscard]] BoundedValue length_of(contact::Edge edge) const {
        const Level& level = *levels_.at(0);
        return level.sound(edge == contact::Edge::right ? level.contact().a() : level.contact().b(),
                           "");
    }
    /// x, exact where the edge is given.
    [[nodiscard]] BoundedValue place(contact::Edge edge, const formula::Exact& u) const {
        const long bits = levels_.at(0)->bits();
        const bool given = scene_.load.kind == contact::Load::Kind::right_edge &&
                           (edge == contact::Edge::right || scene_.symmetric());
        if (given) {
            const formula::Expr& a = scene_.load.value.expr();
            const formula::Exact x(edge == contact::Edge::right ? a - u.expr() : u.expr() - a);
            return {ball_of(x, bits), true, "given", rational_of(x)};
        }
        const Ball from_edge = ball_of(u, bits);
        BoundedValue length = length_of(edge);
        length.value =
            edge == contact::Edge::right ? length.value - from_edge : from_edge - length.value;
        return length;
    }
    /// The sum of n terms; its relative error is worked out with more digits where it cancels.
    [[nodiscard]] Approximation approximation(contact::Edge edge, const formula::Exact& u,
                                              std::size_t n, const Level::Values& at_base,
                                              bool shear) {
        const Digits digits = plan_.error_digits();
        const unsigned wanted = digits.count;
        Approximation result{n, {}, {}};
        std::optional<Real> before; // the radius with fewer digits
        for (unsigned extra = 0;;) {
            Level& level = at_level(extra);
            const Level::Values found = extra == 0 ? at_base : level.at(edge, u, !shear, shear);
            const Ball& value = shear ? found.q->value : found.p->value;
            const Ball local = sum(level, edge, u, n, shear);
            const Ball error = abs(Ball(1 - local / value));
            if (extra == 0) {
                result.local = {local, false, level.series_name()};
            }
            // More digits that do not help will not.
            const bool worse = before && !(error.radius() < *before);
            if (!worse) {
                result.relative_error = {error, false, level.series_name()};
            }
            if (worse || settles(error, digits) || contains_zero(value)) {
                return result;
            }
            before = error.radius();
            const Real lost = -log10(error.upper());
            const unsigned needed = lost > 0 ? static_cast<unsigned>(ceil(lost)) + wanted : wanted;
            const unsigned next = needed > plan_.digits.count ? needed - plan_.digits.count : 0;
            // In steps, so that neighbouring points share one solved contact.
            extra = (std::max(next, 2 * extra + 1) + 15) / 16 * 16;
            if (extra > most_extra) {
                return result;
            }
        }
    }
    [[nodiscard]] Ball sum(Level& level, contact::Edge edge, const formula::Exact& u, std::size_t n,
                           bool shear) {
        const std::vector<BoundedValue>& c = shear ? level.s(edge) : level.c(edge);
        const Ball at = ball_of(u, level.bits());
        Ball total = c[n - 1].value;
        for (std::size_t k = n - 1; k-- > 0;) {
            total = total * at + c[k].value;
        }
        return shear && level.shear_half_powers() < 0 ? Ball(total / sqrt(at))
                                                      : Ball(total * sqrt(at));
    }
    [[nodiscard]] Level& at_level(unsigned extra) {
        auto& slot = levels_[extra];
        if (!slot) {
            ++work_.raised;
            slot = std::make_unique<Level>(*profile_, scene_, plan_, plan_.digits.count + extra,
                                           nullptr);
        }
        return *slot;
    }

    const Scene& scene_;
    const Plan& plan_;
    contact::Work& work_;
    std::optional<formula::Exact> alpha_;
    std::optional<contact::Profile> profile_;
    std::map<unsigned, std::unique_ptr<Level>> levels_;
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
