// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/cost/cost_route.hpp"

#include "edgeproof/contact/batch/batch_pressure.hpp"
#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/routes/normal_contact.hpp"
#include "edgeproof/contact/routes/pressure_routes.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/route/plan.hpp"
#include "edgeproof/scene/route/value_route.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace edgeproof::cost {
namespace {

constexpr unsigned guard_digits = 20;
constexpr unsigned most_machine_digits = 40;

long bits_of(unsigned digits) {
    return static_cast<long>(static_cast<double>(digits) * 3.3219281) + 64;
}

/// A route that is a template, in a hardware arithmetic.
template <Arithmetic T> class InMachine : public ReadyContact {
public:
    InMachine(const CostCase& c, contact::Route route)
        : law_(*c.scene.profile, c.scene.contact_modulus.to<T>()),
          mirrored_(c.scene.profile->reflected(), c.scene.contact_modulus.to<T>()), route_(route) {
        const T load = c.scene.load.value.to<T>();
        extent_ = law_.extent(c.scene.load.kind == contact::Load::Kind::right_edge
                                  ? load
                                  : law_.right_edge_for_force(load));
        for (const formula::Exact& u : c.u) {
            points_.push_back(point_at(extent_, c.edge, u.to<T>()));
        }
    }
    [[nodiscard]] CostValue at(std::size_t i) override {
        const contact::RoutedPressure<T> p = by(points_[i]);
        const PrecisionScope scope(most_machine_digits);
        return {Real(p.value), p.evaluations, {}};
    }

private:
    [[nodiscard]] contact::RoutedPressure<T> by(const contact::Point<T>& at) const {
        if (route_ == contact::Route::closed_form) {
            return logarithmic_closed_form(law_, extent_, at);
        }
        if (route_ == contact::Route::singular_integral) {
            return singular_integral(law_, extent_, at);
        }
        return at.x < T(0)
                   ? barber_mossakovskii(mirrored_, contact::Extent<T>{extent_.b, extent_.a},
                                         contact::Point<T>{at.left, at.right, T(-at.x)})
                   : barber_mossakovskii(law_, extent_, at);
    }
    contact::ContactLaw<T> law_;
    contact::ContactLaw<T> mirrored_;
    contact::Route route_;
    contact::Extent<T> extent_;
    std::vector<contact::Point<T>> points_;
};

/// A route of NormalContact, at the digits asked for.
class InReal : public ReadyContact {
public:
    InReal(const CostCase& c, unsigned digits, contact::Route route)
        : case_(c), contact_(*c.scene.profile, c.scene.contact_modulus, c.scene.load, digits),
          route_(route) {}
    [[nodiscard]] CostValue at(std::size_t i) override {
        const contact::Estimated p = contact_.pressure(case_.edge, case_.u[i], route_);
        return {p.value, p.evaluations};
    }

private:
    const CostCase& case_;
    contact::NormalContact contact_;
    contact::Route route_;
};

/// BatchPressure with one of its rules.
class InBatch : public ReadyContact {
public:
    InBatch(const CostCase& c, unsigned digits, contact::BatchPressure::Rule rule)
        : edge_(c.edge), pressure_(contact::NormalContact(*c.scene.profile, c.scene.contact_modulus,
                                                          c.scene.load, digits),
                                   digits, rule) {
        const bool by_knot = c.near.sign() != 0;
        for (std::size_t i = 0; i < c.u.size(); ++i) {
            // The distance from a knot is a difference and must have the full digits, too.
            const double lost = by_knot ? std::max(0.0, -std::log10(c.distance(i))) : 0;
            const PrecisionScope scope(digits + guard_digits + static_cast<unsigned>(lost));
            u_.push_back(c.u[i].to<Real>());
        }
    }
    [[nodiscard]] CostValue at(std::size_t i) override {
        const contact::RoutedPressure<Real> p = pressure_(edge_, u_[i]);
        if (!p.converged) {
            throw BudgetError("the rule did not converge");
        }
        return {p.value, p.evaluations};
    }

private:
    contact::Edge edge_;
    contact::BatchPressure pressure_;
    std::vector<Real> u_;
};

/// An enclosure with as many bits as the digits need if nothing cancels.
template <class Contact> class InBalls : public ReadyContact {
public:
    InBalls(const CostCase& c, unsigned digits)
        : case_(c),
          contact_(*c.scene.profile, c.scene.contact_modulus, c.scene.load, bits_of(digits)) {}
    [[nodiscard]] CostValue at(std::size_t i) override {
        const Ball p = contact_.pressure(case_.edge, case_.u[i]);
        return {p.midpoint(), {}, p};
    }

private:
    const CostCase& case_;
    Contact contact_;
};

/// The method of `edgeproof pressure`: more and more bits until the value rounds as asked.
class AsPrinted : public ReadyContact {
public:
    AsPrinted(const CostCase& c, unsigned digits) : case_(c), scene_(c.scene) {
        scene_.shear.reset();
        scene_.ask = {};
        scene_.ask.quantities = {scene::QuantityGroup::pressure};
        scene_.ask.edges = {c.edge};
        scene_.ask.digits.count = digits;
        for (const formula::Exact& u : c.u) {
            scene_.ask.u.push_back({u, 0});
        }
        plan_ = make_plan(scene_);
        route_ = make_route(scene_, plan_, work_);
    }
    [[nodiscard]] CostValue at(std::size_t i) override {
        const Ball p =
            route_->value({.quantity = scene::Quantity::p, .edge = case_.edge, .u = case_.u[i]})
                .value;
        return {p.midpoint(), {}, p};
    }

private:
    const CostCase& case_;
    scene::Scene scene_;
    scene::Plan plan_;
    contact::Work work_;
    std::unique_ptr<scene::ValueRoute> route_;
};

bool any(const scene::Scene&) { return true; }
bool piecewise_linear(const scene::Scene& scene) { return scene.profile->piecewise_linear(); }
bool closed(const scene::Scene& scene) {
    return contact::BallContact::has_closed_form(*scene.profile);
}
bool curved(const scene::Scene& scene) {
    return !closed(scene) && contact::IntegratedContact::handles(*scene.profile);
}

/// For a curved g', the integrand of Barber-Mossakovskii is itself an integral: minutes for each
/// point.
std::function<bool(const scene::Scene&)> taken_by(contact::Route route, bool machine) {
    return route == contact::Route::barber_mossakovskii ? closed
           : route != contact::Route::closed_form       ? any
           : machine                                    ? piecewise_linear
                                                        : closed;
}

template <Arithmetic T>
CostRoute in_machine(std::string name, std::string arithmetic, unsigned digits,
                     contact::Route route) {
    CostRoute r;
    r.name = std::move(name);
    r.arithmetic = std::move(arithmetic);
    r.digits = digits;
    r.takes = taken_by(route, true);
    r.ready = [route](const CostCase& c, unsigned) {
        return std::make_unique<InMachine<T>>(c, route);
    };
    return r;
}

void add_all_arithmetics(std::vector<CostRoute>& routes, const std::string& name,
                         contact::Route route) {
    routes.push_back(in_machine<double>(name, "double", 16, route));
    routes.push_back(in_machine<long double>(name, "long double", 19, route));
    routes.push_back(in_machine<Float128>(name, "__float128", 34, route));
    routes.push_back({name, "MPFR", 0, false, route != contact::Route::closed_form,
                      taken_by(route, false), [route](const CostCase& c, unsigned digits) {
                          return std::make_unique<InReal>(c, digits, route);
                      }});
}

CostRoute fast(std::string name, contact::BatchPressure::Rule rule) {
    return {
        std::move(name), "MPFR", 0, false, false, any, [rule](const CostCase& c, unsigned digits) {
            return std::make_unique<InBatch>(c, digits, rule);
        }};
}

template <class Ready> std::unique_ptr<ReadyContact> made(const CostCase& c, unsigned digits) {
    return std::make_unique<Ready>(c, digits);
}

} // namespace

const std::vector<CostRoute>& cost_routes() {
    static const std::vector<CostRoute> routes = [] {
        std::vector<CostRoute> list;
        add_all_arithmetics(list, "Barber-Mossakovskii", contact::Route::barber_mossakovskii);
        add_all_arithmetics(list, "singular integral", contact::Route::singular_integral);
        add_all_arithmetics(list, "closed form", contact::Route::closed_form);
        list.push_back(fast("fast tanh-sinh", contact::BatchPressure::Rule::tanh_sinh));
        list.push_back(fast("fast Gauss-Legendre", contact::BatchPressure::Rule::gauss_legendre));
        list.push_back(
            {"enclosure", "balls", 0, true, false, closed, made<InBalls<contact::BallContact>>});
        list.push_back({"enclosure", "balls", 0, true, false, curved,
                        made<InBalls<contact::IntegratedContact>>});
        list.push_back({"rounded", "balls", 0, true, false,
                        [](const scene::Scene& scene) { return closed(scene) || curved(scene); },
                        made<AsPrinted>});
        return list;
    }();
    return routes;
}

} // namespace edgeproof::cost
