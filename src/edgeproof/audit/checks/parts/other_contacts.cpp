// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/parts/other_contacts.hpp"

#include <map>
#include <string_view>
#include <utility>

namespace edgeproof::audit {
namespace {

/// The powers of a length and of a pressure in a parameter.
struct Powers {
    int length = 0;
    int pressure = 0;
};

const std::map<std::string_view, Powers>& known_parameters() {
    static const std::map<std::string_view, Powers> known{
        {"m", {}},     {"phi", {}},      {"alpha", {}},    {"a", {1, 0}}, {"t", {1, 0}},
        {"R", {1, 0}}, {"Es", {0, 1}},   {"P", {1, 1}},    {"M", {2, 1}}, {"Q", {1, 1}},
        {"f", {}},     {"friction", {}}, {"sig0", {0, 1}}, {"nu", {}},
    };
    return known;
}

formula::Exact times(const formula::Exact& x, const Rational& factor) {
    return formula::Exact(x.expr() * formula::Expr::number(factor));
}

} // namespace

std::vector<Sample> other_contacts(const Sample& sample) {
    const auto& parameters = sample.scene.parameters;
    const bool power_law = sample.scene.profile == "power-law";
    if (!sample.variables.empty() || !sample.scene.knots.empty() || sample.scene.axisymmetric) {
        return {};
    }
    for (const auto& [name, value] : parameters) {
        if (!known_parameters().contains(name) && !(power_law && name == "C")) {
            return {};
        }
    }
    std::vector<Sample> others;
    const auto add = [&](const auto& factor_of) {
        Sample other = sample;
        for (auto& [name, value] : other.scene.parameters) {
            if (const Rational factor = factor_of(name); factor != 1) {
                value = times(value, factor);
            }
        }
        others.push_back(std::move(other));
    };
    const bool plain = parameters.size() == 4 && parameters.contains("m") &&
                       parameters.contains("C") && parameters.contains("a") &&
                       parameters.contains("Es");
    if (power_law && plain) {
        const std::pair<std::string_view, Rational> changes[] = {{"a", Rational(7, 5)},
                                                                 {"C", Rational(3, 5)},
                                                                 {"Es", Rational(11, 7)},
                                                                 {"a", Rational(5, 9)}};
        for (const auto& change : changes) {
            add([&change](const std::string& name) {
                return name == change.first ? change.second : Rational(1);
            });
        }
    } else if (!power_law) {
        add([](const std::string& name) {
            const int power = known_parameters().at(name).length;
            return power == 0 ? Rational(1) : power == 1 ? Rational(7, 5) : Rational(49, 25);
        });
        add([](const std::string& name) {
            return known_parameters().at(name).pressure == 0 ? Rational(1) : Rational(11, 7);
        });
    }
    return others;
}

} // namespace edgeproof::audit
