// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/causes/suspects.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace edgeproof::comparison {
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

} // namespace

void SuspectMaker::add(const std::string& name, const std::string& what, double a, double b,
                       const Value& value) const {
    Suspect s{name, what, a, b, {}};
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        check_interruption();
        s.values.push_back(value(i));
    }
    take_(s);
}

void SuspectMaker::add(const std::string& name, const std::string& what, const Value& value) const {
    add(name, what, exact_.a().value, exact_.b().value, value);
}

void SuspectMaker::add_scene(const std::string& name, const std::string& what,
                             const std::function<void(scene::Scene&)>& change) const {
    const ExactContact* const contact =
        contacts_.with(name + ": " + what, [&](scene::Scene& other) {
            other.shear.reset();
            change(other);
        });
    if (contact != nullptr) {
        add(name, what, contact->a().value, contact->b().value,
            [&](std::size_t i) { return pressure(*contact, nodes_[i].x); });
    }
}

double SuspectMaker::pressure(const ExactContact& contact, double x) {
    return contact.at(Real(x)).p.value_or(no_value);
}

double SuspectMaker::exact_pressure(std::size_t i, std::ptrdiff_t rows) const {
    const auto at = static_cast<std::ptrdiff_t>(nodes_.nodes[i]) + rows;
    return at < 0 || at >= std::ssize(nodes_.data.nodes)
               ? no_value
               : nodes_.data.nodes[static_cast<std::size_t>(at)].exact.p.value_or(no_value);
}

void for_each_suspect(const NodesLookedAt& nodes, SuspectContacts& contacts,
                      const ExactContact& exact, const TakeSuspect& take) {
    const PrecisionScope scope(ExactContact::place_digits);
    const SuspectMaker make(nodes, contacts, exact, take);
    suspect_factors(make);
    suspect_scenes(make);
    suspect_places(make);
    suspect_terms(make);
}

void for_each_shear_suspect(const NodesLookedAt& nodes, SuspectContacts& contacts,
                            const ExactContact& exact, const TakeSuspect& take) {
    const PrecisionScope scope(ExactContact::place_digits);
    const SuspectMaker make(nodes, contacts, exact, take);
    const scene::Scene& scene = contacts.scene();
    const auto factor = [&](const char* name, const std::string& what, double k) {
        make.add(name, what, [&](std::size_t i) {
            return nodes[i].shear && nodes[i].shear->exact ? k * *nodes[i].shear->exact : no_value;
        });
    };
    factor("factor-2", "q is twice too large", 2);
    factor("factor-2", "q is half as large", 0.5);
    factor("factor-pi", "q is pi times too large", std::acos(-1));
    factor("factor-pi", "q is pi times too small", 1 / std::acos(-1));
    const auto with = [&](const char* name, const std::string& what,
                          const std::function<void(contact::ShearSpec&)>& change) {
        // There is none if it slides, or slips in the other direction.
        const ExactContact* const contact =
            contacts.with(name + (": " + what), [&](scene::Scene& other) { change(*other.shear); });
        if (contact != nullptr) {
            make.add(name, what, [&](std::size_t i) {
                return contact->traction(Real(nodes[i].x), nodes[i].exact).value_or(no_value);
            });
        }
    };
    const formula::Expr two = formula::Expr::number(Rational(2));
    const formula::Expr half = formula::Expr::number(Rational(1, 2));
    const auto times = [](formula::Exact& value, const formula::Expr& k) {
        value = formula::Exact(value.expr() * k);
    };
    if (scene.shear->Q.sign() != 0) {
        with("half-shear-force", "half of Q", [&](auto& s) { times(s.Q, half); });
        with("half-shear-force", "twice Q", [&](auto& s) { times(s.Q, two); });
    }
    if (scene.shear->bulk_tension.sign() != 0) {
        with("half-tension", "half of the bulk tension",
             [&](auto& s) { times(s.bulk_tension, half); });
        with("half-tension", "twice the bulk tension",
             [&](auto& s) { times(s.bulk_tension, two); });
        with("no-tension", "the bulk tension is left out",
             [](auto& s) { s.bulk_tension = formula::Exact(); });
        with("sign-of-tension", "the bulk tension has the wrong sign relative to Q",
             [](auto& s) { s.bulk_tension = formula::Exact(-s.bulk_tension.expr()); });
    }
    if (scene.shear->friction) {
        with("no-slip", "full stick, without friction", [](auto& s) { s.friction.reset(); });
        const double f = scene.shear->friction->to<Real>().convert_to<double>();
        make.add("all-slips", "f p everywhere: full sliding",
                 [&](std::size_t i) { return f * make.exact_pressure(i); });
    }
    if (!exact.symmetric() || scene.shear->bulk_tension.sign() != 0) {
        make.add("mirrored", "x has the opposite direction", exact.b().value, exact.a().value,
                 [&](std::size_t i) {
                     const Real x(-nodes[i].x);
                     return exact.traction(x, exact.at(x)).value_or(no_value);
                 });
    }
}

const ExactContact* SuspectContacts::with(const std::string& mistake,
                                          const std::function<void(scene::Scene&)>& change) {
    const auto known = solved_.find(mistake);
    if (known != solved_.end()) {
        return known->second.get();
    }
    std::unique_ptr<ExactContact> contact;
    try {
        scene::Scene other = scene_;
        change(other);
        contact = std::make_unique<ExactContact>(other);
    } catch (const Error&) { // the changed scene has no contact
    }
    return solved_.emplace(mistake, std::move(contact)).first->second.get();
}

void suspect_factors(const SuspectMaker& make) {
    const auto both_ways = [&](const char* name, const std::string& what, double k) {
        make.add(name, "p is " + what + " times too large",
                 [&](std::size_t i) { return k * make.exact_pressure(i); });
        make.add(name, "p is " + what + " times too small",
                 [&](std::size_t i) { return make.exact_pressure(i) / k; });
    };
    const double pi = std::numbers::pi;
    both_ways("factor-2", "2", 2);
    both_ways("factor-pi", "pi", pi);
    both_ways("factor-pi", "2 pi", 2 * pi);
    both_ways("factor-sqrt-pi", "sqrt(pi)", std::sqrt(pi));
    // K = sqrt(2 pi) c_0: the stress intensity of fracture mechanics.
    both_ways("factor-sqrt-2-pi", "sqrt(2 pi)", std::sqrt(2 * pi));
    both_ways("unit-g", "9.80665", 9.80665);
    // One psi is 6894.757 Pa; one MPa is 145.038 psi.
    both_ways("unit-psi", "145.038", 1e6 / 6894.757293168);
    for (const double ten : {1.0, 1e-3, 1e3}) {
        both_ways("unit-psi", fmt::format("{:g}", 6894.757293168 * ten), 6894.757293168 * ten);
    }
    for (const int n : {1, 2, 3, 4, 5, 6, 9}) {
        both_ways("power-of-ten", fmt::format("1e{}", n), std::pow(10.0, n));
    }
    const ExactContact& exact = make.exact();
    const auto scale = [&](const char* name, double k) {
        const double origin = make.nodes().data.origin; // undoes the shift that was found
        make.add(name, fmt::format("x is {:g} times too large", k), exact.a().value * k - origin,
                 exact.b().value * k + origin, [&](std::size_t i) {
                     return make.pressure(exact, (make.nodes()[i].x + origin) / k);
                 });
    };
    for (const int n : {1, 2, 3, 6}) {
        scale("power-of-ten", std::pow(10.0, n));
        scale("power-of-ten", std::pow(10.0, -n));
    }
    scale("unit-inch", 25.4);
    scale("unit-inch", 1 / 25.4);
    scale("full-width-for-half", 2);
    scale("full-width-for-half", 0.5);
}

} // namespace edgeproof::comparison
