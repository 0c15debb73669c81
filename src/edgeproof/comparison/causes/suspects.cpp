// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/causes/suspects.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/scene/mistakes/scene_mistakes.hpp"

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
    for (const scene::SceneMistake& mistake : scene::shear_mistakes(scene)) {
        // There is no contact if it slides, or slips in the other direction.
        const ExactContact* const contact =
            contacts.with(std::string(mistake.name) + ": " + mistake.what, mistake.change);
        if (contact != nullptr) {
            make.add(std::string(mistake.name), mistake.what, [&](std::size_t i) {
                return contact->traction(Real(nodes[i].x), nodes[i].exact).value_or(no_value);
            });
        }
    }
    if (scene.shear->friction) {
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

void suspect_scenes(const SuspectMaker& make) {
    for (const scene::SceneMistake& mistake : scene::contact_mistakes(make.scene())) {
        make.add_scene(std::string(mistake.name), mistake.what, mistake.change);
    }
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
