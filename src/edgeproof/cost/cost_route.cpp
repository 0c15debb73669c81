// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cost/cost_route.hpp"

#include "edgeproof/contact/ball_contact.hpp"
#include "edgeproof/contact/fast_pressure.hpp"
#include "edgeproof/contact/integrated_contact.hpp"
#include "edgeproof/contact/normal_contact.hpp"
#include "edgeproof/contact/pressure_routes.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/plan.hpp"
#include "edgeproof/scene/value_route.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace edgeproof {
namespace {

constexpr unsigned guard_digits = 20;
constexpr unsigned most_machine_digits = 40;

long bits_of(unsigned digits) {
    return static_cast<long>(static_cast<double>(digits) * 3.3219281) + 64;
}

/// A route that is a template, in a machine's own arithmetic.
template <Arithmetic T> class InMachine : public ReadyContact {
public:
    InMachine(const CostCase& c, Route route)
        : law_(*c.scene.profile, c.scene.contact_modulus.to<T>()),
          mirrored_(c.scene.profile->reflected(), c.scene.contact_modulus.to<T>()), route_(route) {
        const T load = c.scene.load.value.to<T>();
        extent_ = law_.extent(
            c.scene.load.kind == Load::Kind::right_edge ? load : law_.right_edge_for_force(load));
        for (const Exact& u : c.u) {
            points_.push_back(point_at(extent_, c.edge, u.to<T>()));
        }
    }
    [[nodiscard]] CostValue at(std::size_t i) override {
        const RoutedPressure<T> p = by(points_[i]);
        const PrecisionScope scope(most_machine_digits);
        return {Real(p.value), p.evaluations, {}};
    }

private:
    [[nodiscard]] RoutedPressure<T> by(const Point<T>& at) const {
        if (route_ == Route::closed_form) {
            return logarithmic_closed_form(law_, extent_, at);
        }
        if (route_ == Route::singular_integral) {
            return singular_integral(law_, extent_, at);
        }
        return at.x < T(0) ? barber_mossakovskii(mirrored_, Extent<T>{extent_.b, extent_.a},
                                                 Point<T>{at.left, at.right, T(-at.x)})
                           : barber_mossakovskii(law_, extent_, at);
    }
    ContactLaw<T> law_;
    ContactLaw<T> mirrored_;
    Route route_;
    Extent<T> extent_;
    std::vector<Point<T>> points_;
};

/// A route of NormalContact, at the digits asked for.
class InReal : public ReadyContact {
public:
    InReal(const CostCase& c, unsigned digits, Route route)
        : case_(c), contact_(*c.scene.profile, c.scene.contact_modulus, c.scene.load, digits),
          route_(route) {}
    [[nodiscard]] CostValue at(std::size_t i) override {
        const Estimated p = contact_.pressure(case_.edge, case_.u[i], route_);
        return {p.value, p.evaluations};
    }

private:
    const CostCase& case_;
    NormalContact contact_;
    Route route_;
};

/// FastPressure, by one of its rules.
class InFast : public ReadyContact {
public:
    InFast(const CostCase& c, unsigned digits, FastPressure::Rule rule)
        : edge_(c.edge),
          pressure_(NormalContact(*c.scene.profile, c.scene.contact_modulus, c.scene.load, digits),
                    digits, rule) {
        const bool by_knot = c.near.sign() != 0;
        for (std::size_t i = 0; i < c.u.size(); ++i) {
            // The distance from a knot is a difference, and is to have its digits too.
            const double lost = by_knot ? std::max(0.0, -std::log10(c.distance(i))) : 0;
            const PrecisionScope scope(digits + guard_digits + static_cast<unsigned>(lost));
            u_.push_back(c.u[i].to<Real>());
        }
    }
    [[nodiscard]] CostValue at(std::size_t i) override {
        const RoutedPressure<Real> p = pressure_(edge_, u_[i]);
        if (!p.converged) {
            throw BudgetError("the rule did not converge");
        }
        return {p.value, p.evaluations};
    }

private:
    Edge edge_;
    FastPressure pressure_;
    std::vector<Real> u_;
};

/// An enclosure at so many bits as the digits need where nothing cancels.
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

/// As `edgeproof pressure` has it: more and more bits until it rounds to the digits asked for.
class AsPrinted : public ReadyContact {
public:
    AsPrinted(const CostCase& c, unsigned digits) : case_(c), scene_(c.scene) {
        scene_.shear.reset();
        scene_.ask = {};
        scene_.ask.quantities = {Quantity::pressure};
        scene_.ask.edges = {c.edge};
        scene_.ask.digits.count = digits;
        for (const Exact& u : c.u) {
            scene_.ask.u.push_back({u, 0});
        }
        plan_ = make_plan(scene_);
        route_ = make_ball_route(scene_, plan_, work_);
    }
    [[nodiscard]] CostValue at(std::size_t i) override {
        const PointValues values = route_->at(case_.edge, case_.u[i], true, false);
        const Ball& p = values.p->value;
        return {p.midpoint(), {}, p};
    }

private:
    const CostCase& case_;
    Scene scene_;
    Plan plan_;
    Work work_;
    std::unique_ptr<ValueRoute> route_;
};

bool any(const Scene&) { return true; }
bool piecewise_linear(const Scene& scene) { return scene.profile->piecewise_linear(); }
bool closed(const Scene& scene) { return BallContact::has_closed_form(*scene.profile); }
bool curved(const Scene& scene) {
    return !closed(scene) && IntegratedContact::handles(*scene.profile);
}

/// Where g' is curved, what Barber-Mossakovskii integrates is itself an integral: minutes a point.
std::function<bool(const Scene&)> taken_by(Route route, bool machine) {
    return route == Route::barber_mossakovskii ? closed
           : route != Route::closed_form       ? any
           : machine                           ? piecewise_linear
                                               : closed;
}

template <Arithmetic T>
CostRoute in_machine(std::string name, std::string arithmetic, unsigned digits, Route route) {
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

void add_all_arithmetics(std::vector<CostRoute>& routes, const std::string& name, Route route) {
    routes.push_back(in_machine<double>(name, "double", 16, route));
    routes.push_back(in_machine<long double>(name, "long double", 19, route));
    routes.push_back(in_machine<Float128>(name, "__float128", 34, route));
    routes.push_back({name, "MPFR", 0, false, route != Route::closed_form, taken_by(route, false),
                      [route](const CostCase& c, unsigned digits) {
                          return std::make_unique<InReal>(c, digits, route);
                      }});
}

CostRoute fast(std::string name, FastPressure::Rule rule) {
    return {
        std::move(name), "MPFR", 0, false, false, any, [rule](const CostCase& c, unsigned digits) {
            return std::make_unique<InFast>(c, digits, rule);
        }};
}

template <class Ready> std::unique_ptr<ReadyContact> made(const CostCase& c, unsigned digits) {
    return std::make_unique<Ready>(c, digits);
}

} // namespace

const std::vector<CostRoute>& cost_routes() {
    static const std::vector<CostRoute> routes = [] {
        std::vector<CostRoute> list;
        add_all_arithmetics(list, "Barber-Mossakovskii", Route::barber_mossakovskii);
        add_all_arithmetics(list, "singular integral", Route::singular_integral);
        add_all_arithmetics(list, "closed form", Route::closed_form);
        list.push_back(fast("fast tanh-sinh", FastPressure::Rule::tanh_sinh));
        list.push_back(fast("fast Gauss-Legendre", FastPressure::Rule::gauss_legendre));
        list.push_back({"enclosure", "balls", 0, true, false, closed, made<InBalls<BallContact>>});
        list.push_back(
            {"enclosure", "balls", 0, true, false, curved, made<InBalls<IntegratedContact>>});
        list.push_back({"rounded", "balls", 0, true, false,
                        [](const Scene& scene) { return closed(scene) || curved(scene); },
                        made<AsPrinted>});
        return list;
    }();
    return routes;
}

} // namespace edgeproof
