// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/validation/value_routes.hpp"

#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/run_scene.hpp"
#include "lab/validation/abel_quadrature.hpp"
#include "lab/validation/axisymmetric_formula.hpp"
#include "lab/validation/stress_formula.hpp"
#include "lab/validation/textbook_formula.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace edgeproof::validation {
namespace {

using scene::AskedValue;
using scene::Quantity;

/// The most digits added until a difference has its digits.
constexpr unsigned most_cancelled = 4000;

scene::Digits to_digits(unsigned digits) { return {digits, Rounding::nearest, false}; }

scene::BoundedValue single(const scene::Scene& scene, const AskedValue& asked, unsigned digits) {
    return scene::SceneValues(scene, {asked}, to_digits(digits)).value(asked);
}

/// Returns value(digits + extra) with more and more extra digits until it has its digits.
template <class Value> scene::BoundedValue with_its_digits(unsigned digits, const Value& value) {
    for (unsigned extra = 32;; extra *= 2) {
        scene::BoundedValue d = value(digits + extra);
        if (scene::has_digits(d.value, to_digits(digits)) || extra >= most_cancelled) {
            return d;
        }
    }
}

scene::BoundedValue tilt_difference(const scene::Scene& scene, const AskedValue& asked,
                                    unsigned digits) {
    const scene::Scene other = upright(scene);
    AskedValue pressure = asked;
    pressure.quantity = Quantity::p;
    return with_its_digits(digits, [&](unsigned more) -> scene::BoundedValue {
        const scene::BoundedValue p = single(scene, pressure, more);
        const scene::BoundedValue q = single(other, pressure, more);
        return {p.value - q.value, p.proved && q.proved, p.route};
    });
}

/// 1 - (the first n terms)/p, with its sign; p = sum of c_k u^(k + 1/2) (docs/expansions.md).
scene::BoundedValue residual(const scene::Scene& scene, const AskedValue& asked, unsigned digits) {
    AskedValue pressure = asked;
    pressure.quantity = Quantity::p;
    std::vector<AskedValue> all{pressure};
    for (std::size_t k = 0; k < asked.k; ++k) {
        all.push_back({Quantity::c, k, asked.edge});
    }
    return with_its_digits(digits, [&](unsigned more) -> scene::BoundedValue {
        scene::SceneValues values(scene, all, to_digits(more));
        const scene::BoundedValue p = values.value(pressure);
        const Ball u = ball_of(*asked.u, formula::bits_for(more) + 64);
        Ball sum;
        bool proved = p.proved;
        for (std::size_t k = asked.k; k-- > 0;) {
            const scene::BoundedValue c = values.value(all[k + 1]);
            proved = proved && c.proved;
            sum = k + 1 < asked.k ? sum * u + c.value : c.value;
        }
        return {1 - sum * sqrt(u) / p.value, proved, "series"};
    });
}

} // namespace

scene::Scene upright(const scene::Scene& scene) {
    const formula::Exact none = formula::Exact::of(Rational(0));
    const auto& parameters = scene.profile->parameters();
    scene::Scene s = scene;
    switch (scene.profile->kind()) {
    case contact::Profile::Kind::tilted_wedge:
        s.profile = contact::Profile::tilted_wedge(parameters.at("phi"), none);
        return s;
    case contact::Profile::Kind::tilted_flat_and_rounded:
        s.profile =
            contact::Profile::tilted_flat_and_rounded(none, parameters.at("t"), parameters.at("R"));
        return s;
    default:
        throw InputError("a " + scene.profile->kind_name() + " profile has no tilt",
                         "take a tilted-wedge or tilted-flat-and-rounded profile");
    }
}

scene::BoundedValue enclosed_value(const scene::Scene& scene, const AskedValue& asked,
                                   unsigned digits) {
    return asked.quantity == Quantity::tilt_difference ? tilt_difference(scene, asked, digits)
           : asked.quantity == Quantity::residual      ? residual(scene, asked, digits)
                                                       : single(scene, asked, digits);
}

namespace {

constexpr unsigned most_extra = 6000;
/// Additional digits for a coefficient far below its natural size.
constexpr unsigned cancelled = 25;

Real power_of_ten(int k) { return pow(Real(10), k); }

contact::NormalContact contact_of(const scene::Scene& scene, unsigned digits) {
    if (!scene.profile) {
        throw DomainError("the tilt is not given");
    }
    return {*scene.profile, scene.contact_modulus, scene.load, digits};
}

SecondRoute relative(std::string route, const Real& value, const Real& error) {
    return {std::move(route), value, Real(abs(value) * error)};
}

SecondRoute pressure_by(const scene::Scene& scene, const AskedValue& asked, unsigned digits,
                        contact::Route route) {
    const contact::Estimated p = contact_of(scene, digits).pressure(asked.edge, *asked.u, route);
    const PrecisionScope scope(p.working_digits);
    return relative(route_name(route), p.value, p.estimate);
}

SecondRoute tilt_difference_by(const scene::Scene& scene, const AskedValue& asked, unsigned digits,
                               contact::Route route) {
    const scene::Scene other = upright(scene);
    for (unsigned extra = 32;; extra *= 2) {
        const SecondRoute p = pressure_by(scene, asked, digits + extra, route);
        const SecondRoute q = pressure_by(other, asked, digits + extra, route);
        const PrecisionScope scope(digits + extra + 20);
        const Real d = p.value - q.value;
        const Real error = p.error + q.error;
        if (error <= abs(d) * power_of_ten(-static_cast<int>(digits)) || extra >= most_extra) {
            return {p.route, d, error};
        }
    }
}

SecondRoute by_series(const scene::Scene& scene, const AskedValue& asked, unsigned digits) {
    const Real c = contact_of(scene, digits + cancelled).expansion(asked.edge, asked.k + 1).back();
    const PrecisionScope scope(c.precision());
    return relative("series", c, power_of_ten(-static_cast<int>(digits)));
}

SecondRoute by_differences(const scene::Scene& scene, const AskedValue& asked, unsigned digits) {
    const contact::NormalContact contact = contact_of(scene, difference_digits(asked.k, digits));
    const Real c = coefficient_by_differences(
        asked.k, digits, contact.convergence_radius(asked.edge), [&](const Real& u) {
            return contact.pressure(asked.edge, u, contact::Route::singular_integral).value;
        });
    return relative("divided-differences", c, power_of_ten(-static_cast<int>(digits)));
}

Real sum_of(const std::vector<Real>& c, const Real& u, std::size_t from) {
    Real sum = c.back();
    for (std::size_t k = c.size() - 1; k-- > from;) {
        sum = sum * u + c[k];
    }
    return sum * pow(u, static_cast<int>(from)) * sqrt(u);
}

/// 1 - (n terms)/p, by the singular integral with additional digits for the cancellation.
SecondRoute residual_directly(const scene::Scene& scene, const AskedValue& asked, unsigned digits) {
    for (unsigned working = digits + 32;;) {
        const contact::NormalContact contact = contact_of(scene, working);
        const auto c = contact.expansion(asked.edge, asked.k);
        const PrecisionScope scope(working + 20);
        const Real p =
            contact.pressure(asked.edge, *asked.u, contact::Route::singular_integral).value;
        const Real value = 1 - sum_of(c, asked.u->to<Real>(), 0) / p;
        const Real error = power_of_ten(-static_cast<int>(working));
        if (error <= abs(value) * power_of_ten(-static_cast<int>(digits)) || working > most_extra) {
            return {"singular-integral", value, error};
        }
        working = value == 0 ? 2 * working
                             : digits + 32 + static_cast<unsigned>(ceil(-log10(abs(value))));
    }
}

/// The omitted terms divided by p.
SecondRoute residual_by_tail(const scene::Scene& scene, const AskedValue& asked, unsigned digits) {
    const contact::NormalContact contact = contact_of(scene, digits + 10);
    const PrecisionScope scope(digits + 30);
    const Real u = asked.u->to<Real>();
    const Real ratio = u / contact.convergence_radius(asked.edge);
    if (!(ratio < Real(1) / 4)) {
        throw DomainError("the point is too far from the edge for the tail of the series");
    }
    const unsigned more = static_cast<unsigned>(ceil((digits + 10) / -log10(ratio))) + 1;
    const auto c = contact.expansion(asked.edge, asked.k + more);
    const Real p =
        contact.pressure(asked.edge, *asked.u, contact::Route::barber_mossakovskii).value;
    return relative("series-tail", Real(sum_of(c, u, asked.k) / p),
                    power_of_ten(-static_cast<int>(digits)));
}

/// The printed formula with the number of digits raised until doubling it does not change the
/// value.
SecondRoute by_formula(const scene::Scene& scene, const AskedValue& asked, unsigned digits) {
    unsigned working = digits + 100;
    if (asked.u) {
        const PrecisionScope scope(50);
        const Real small = -log10(asked.u->to<Real>());
        working += small > 0 ? 2 * static_cast<unsigned>(ceil(small)) : 0;
    }
    std::optional<Real> before;
    for (;; working *= 2) {
        const PrecisionScope scope(working);
        const Real now = scene.round ? AxisymmetricFormula<Real>(scene).value(asked)
                                     : TextbookFormula<Real>(scene).value(asked);
        if (before) {
            const Real change = abs(now - *before);
            if (change <= abs(now) * power_of_ten(-static_cast<int>(digits)) ||
                working > most_extra) {
                return {"printed-formula", now, change};
            }
        }
        before = now;
    }
}

SecondRoute by_shear(const scene::Scene& scene, const AskedValue& asked, unsigned digits) {
    const contact::NormalContact contact = contact_of(scene, digits + 10);
    const contact::ShearTraction shear(contact, scene.shear.value());
    const contact::EstimatedTraction t = asked.quantity == Quantity::q
                                             ? shear.traction(asked.edge, *asked.u)
                                             : shear.expansion(asked.edge, asked.k + 1).back();
    return {"full-stick", t.value, t.error};
}

SecondRoute by_law(const scene::Scene& scene, const AskedValue& asked, unsigned digits) {
    const contact::NormalContact contact = contact_of(scene, digits);
    const Real x = asked.quantity == Quantity::P ? contact.force() : contact.b();
    const PrecisionScope scope(x.precision());
    return relative("contact-law", x, power_of_ten(-static_cast<int>(digits + 8)));
}

SecondRoute by_library_scan(const scene::Scene& scene, const AskedValue& asked, unsigned digits) {
    const contact::Extents e =
        within_tolerance(contact_of(scene, digits), asked.edge, asked.k, asked.tolerance.value());
    const PrecisionScope scope(e.length.precision());
    return relative("scan", e.first_exit,
                    Real(e.estimate + power_of_ten(-static_cast<int>(digits))));
}

constexpr unsigned guard = 80;
constexpr int scan_decades = 10;
constexpr int per_decade = 40;
constexpr int even_points = 400;

class ErrorCurve {
public:
    ErrorCurve(const scene::Scene& scene, contact::Edge edge, std::size_t n, unsigned digits)
        : formula_(scene), edge_(edge),
          c_(contact::NormalContact(scene.profile.value(), scene.contact_modulus, scene.load,
                                    digits + guard)
                 .expansion(edge, n)) {}

    [[nodiscard]] Real operator()(const Real& u) const {
        const Real x =
            edge_ == contact::Edge::right ? Real(formula_.a() - u) : Real(u - formula_.b());
        return abs(Real(1 - sum_of(c_, u, 0) / formula_.pressure(x)));
    }
    /// Points from 1e-10 of the contact to within 1e-4 of the other edge, geometric and even.
    [[nodiscard]] std::vector<Real> grid() const {
        std::vector<Real> points;
        // The length is slightly reduced, so that no point is on a knot, where the formula is
        // infinity times 0.
        const Real length = (formula_.a() + formula_.b()) * (1 - 1 / pow(Real(2), Real(61) / 4));
        for (int i = -scan_decades * per_decade; i < 0; ++i) {
            points.push_back(length * pow(Real(10), Real(i) / per_decade));
        }
        for (int i = 1; i < even_points; ++i) {
            points.push_back(length * i / even_points);
        }
        for (int i = -4 * per_decade; i < -per_decade; ++i) {
            points.push_back(length * (1 - pow(Real(10), Real(i) / per_decade)));
        }
        std::sort(points.begin(), points.end());
        return points;
    }
    /// The place of the maximum between lo and hi.
    [[nodiscard]] Real summit(Real lo, Real hi, unsigned digits) const {
        // An error d of the place changes the maximum by only d^2.
        const Real enough = hi * pow(Real(10), -static_cast<int>(digits / 2 + 10));
        while (hi - lo > enough) {
            const Real third = (hi - lo) / 3;
            const Real left = lo + third;
            const Real right = hi - third;
            ((*this)(left) < (*this)(right) ? lo : hi) =
                (*this)(left) < (*this)(right) ? left : right;
        }
        return (lo + hi) / 2;
    }

private:
    TextbookFormula<Real> formula_;
    contact::Edge edge_;
    std::vector<Real> c_;
};

/// Finds the first exit by a scan that uses only the coefficients of the library, not
/// contact/extent.hpp: the pressure is the printed formula with more digits than it loses; every
/// local maximum of the error above half the tolerance is located by trisection; the root is found
/// by bisection. Throws DomainError if there is no exit.
SecondRoute independent_extent(const scene::Scene& scene, const scene::AskedValue& asked,
                               unsigned digits) {
    const PrecisionScope scope(digits + guard);
    const ErrorCurve error(scene, asked.edge, asked.k, digits);
    const Real tolerance = asked.tolerance.value().to<Real>();
    const std::vector<Real> u = error.grid();
    std::vector<Real> e;
    const auto crossing = [&](Real inside, Real outside) {
        const Real enough = outside * pow(Real(10), -static_cast<int>(digits + 5));
        while (abs(Real(outside - inside)) > enough) {
            const Real middle = (inside + outside) / 2;
            (error(middle) < tolerance ? inside : outside) = middle;
        }
        return SecondRoute{"independent-scan", outside, enough};
    };
    for (std::size_t i = 0; i < u.size(); ++i) {
        e.push_back(error(u[i]));
        if (i > 1 && e[i] <= e[i - 1] && e[i - 2] < e[i - 1] && e[i - 1] < tolerance &&
            e[i - 1] > tolerance / 2) {
            const Real top = error.summit(u[i - 2], u[i], 2 * digits);
            if (!(error(top) < tolerance)) {
                return crossing(u[i - 2], top);
            }
        }
        if (i > 0 && !(e[i] < tolerance)) {
            // The maximum may lie just before.
            return crossing(u[i - 1], u[i]);
        }
    }
    throw DomainError("the approximation stays within the tolerance");
}

using By = SecondRoute (*)(const scene::Scene&, const AskedValue&, unsigned);

template <contact::Route route>
SecondRoute pressure_along(const scene::Scene& scene, const AskedValue& asked, unsigned digits) {
    return pressure_by(scene, asked, digits, route);
}
template <contact::Route route>
SecondRoute difference_along(const scene::Scene& scene, const AskedValue& asked, unsigned digits) {
    return tilt_difference_by(scene, asked, digits, route);
}

struct TwoRoutes {
    Quantity quantity;
    By first;
    By second;
};
constexpr TwoRoutes two_routes[] = {
    {Quantity::p, pressure_along<contact::Route::barber_mossakovskii>,
     pressure_along<contact::Route::singular_integral>},
    {Quantity::c, by_series, by_differences},
    {Quantity::residual, residual_directly, residual_by_tail},
    {Quantity::q, by_shear, by_formula},
    {Quantity::s, by_shear, by_formula},
    {Quantity::P, by_law, by_formula},
    {Quantity::b, by_law, by_formula},
    {Quantity::tilt_difference, difference_along<contact::Route::barber_mossakovskii>,
     difference_along<contact::Route::singular_integral>},
    {Quantity::extent, by_library_scan, independent_extent},
    {Quantity::sxx, by_pressure_integrals, by_slope_integrals},
    {Quantity::szz, by_pressure_integrals, by_slope_integrals},
    {Quantity::sxz, by_pressure_integrals, by_slope_integrals},
};
constexpr TwoRoutes axisymmetric_routes[] = {
    {Quantity::p, by_nested_integrals, by_elliptic_integrals},
    {Quantity::P, by_nested_integrals, by_formula},
    {Quantity::delta, by_nested_integrals, by_formula},
};

std::span<const TwoRoutes> routes_for(bool axisymmetric) {
    return axisymmetric ? std::span<const TwoRoutes>(axisymmetric_routes)
                        : std::span<const TwoRoutes>(two_routes);
}

} // namespace

std::vector<SecondRoute> second_routes(const scene::Scene& scene, const AskedValue& asked,
                                       unsigned digits) {
    for (const TwoRoutes& routes : routes_for(scene.round.has_value())) {
        if (routes.quantity == asked.quantity) {
            return {routes.first(scene, asked, digits), routes.second(scene, asked, digits)};
        }
    }
    throw Error("there are no two routes to a " + std::string(row_of(asked.quantity).name));
}

std::vector<Quantity> second_route_quantities(bool axisymmetric) {
    std::vector<Quantity> list;
    for (const TwoRoutes& routes : routes_for(axisymmetric)) {
        list.push_back(routes.quantity);
    }
    return list;
}

} // namespace edgeproof::validation
