// SPDX-License-Identifier: BSD-3-Clause
#include "tests/conformance/causes/wrong_programs.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace edgeproof::conformance {
namespace {

constexpr double second_load = 1.7;

AskedContact contact_of(const SceneKeys& keys, double load) {
    std::vector<Parameter> parameters;
    for (const auto& [key, text] : keys) {
        const std::string name = key.substr(key.find('.') + 1);
        const bool scaled =
            name == "a" || name == "P" || name == "delta" || name == "M" || name == "Q";
        parameters.push_back(
            {name, scaled && load != 1 ? "(" + text + ")*" + fmt::format("{:g}", load) : text});
    }
    return make_asked_contact(std::move(parameters), "simulated", 1);
}

formula::Exact exactly(const Real& x) {
    return formula::Exact::parse(fmt::format("{}", x.str(35, std::ios_base::scientific)));
}

std::vector<std::optional<Real>> values_of(const Questions& questions,
                                           const ReferenceOptions& options) {
    std::vector<std::optional<Real>> values;
    for (const auto& [found, why] : references_or_why(questions, options, false)) {
        values.push_back(found ? std::optional(found->value.value.midpoint()) : std::nullopt);
    }
    return values;
}

bool is_force(const Question& q) { return row_of(q.quantity).force_power != 0; }

/// Applies f to the values that are pressures, forces or coefficients.
Program of_values(const std::function<double(const Question&, double)>& f) {
    return [f](const Asked& asked) {
        std::vector<double> values;
        for (std::size_t i = 0; i < asked.right.size(); ++i) {
            const double right = asked.right[i].convert_to<double>();
            const Question& q = asked.questions.list[i];
            values.push_back(is_force(q) ? f(q, right) : right);
        }
        return std::optional(values);
    };
}
Program factor(double k) {
    return of_values([k](const Question&, double value) { return k * value; });
}

/// Answers other questions. Points outside the contact have the pressure 0.
std::optional<std::vector<double>> answered_otherwise(const Asked& asked,
                                                      const Questions& otherwise,
                                                      const ReferenceOptions& options) {
    const auto found = values_of(otherwise, options);
    std::vector<double> values;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (!found[i] && !asked.questions.list[i].at_point()) {
            return {};
        }
        values.push_back(found[i] ? found[i]->convert_to<double>() : 0);
    }
    return values;
}

/// Changes the place of each point: f(edge distance a or b, u), which is no place if it is not
/// positive.
Program of_places(const std::function<Real(const Real&, const Real&)>& f,
                  const ReferenceOptions& options) {
    return [f, options](const Asked& asked) {
        Questions otherwise = asked.questions;
        std::vector<std::size_t> outside;
        for (std::size_t i = 0; i < otherwise.list.size(); ++i) {
            Question& q = otherwise.list[i];
            if (q.u) {
                const auto& edges = q.edge == contact::Edge::right ? asked.a : asked.b;
                const Real u = f(edges[q.contact], q.u->to<Real>());
                if (u > 0) {
                    q.u = exactly(u);
                } else {
                    outside.push_back(i);
                }
            }
        }
        auto values = answered_otherwise(asked, otherwise, options);
        for (const std::size_t i : outside) {
            if (values) {
                (*values)[i] = 0;
            }
        }
        return values;
    };
}

Program terms(std::size_t n) {
    return [n](const Asked& asked) {
        std::map<std::pair<std::size_t, contact::Edge>, std::vector<double>> c;
        const auto& list = asked.questions.list;
        for (std::size_t i = 0; i < list.size(); ++i) {
            if (list[i].quantity == scene::Quantity::c) {
                c[{list[i].contact, list[i].edge}].push_back(asked.right[i].convert_to<double>());
            }
        }
        std::vector<double> values;
        for (std::size_t i = 0; i < list.size(); ++i) {
            values.push_back(asked.right[i].convert_to<double>());
            if (list[i].quantity == scene::Quantity::p) {
                const double u = list[i].u->to<Real>().convert_to<double>();
                values.back() = 0;
                for (std::size_t k = 0; k < n; ++k) {
                    values.back() += c.at({list[i].contact, list[i].edge})[k] *
                                     std::pow(u, static_cast<double>(k) + 0.5);
                }
            }
        }
        return std::optional(values);
    };
}

double rounded(double value, int digits) {
    return std::stod(fmt::format("{:.{}e}", value, digits - 1));
}

/// A factor, and an error that changes from place to place as that of no mistake of the catalogue
/// does: from 0 to twice `size`.
Program smooth_error(double size, double factor = 1) {
    return [size, factor](const Asked& asked) {
        std::vector<double> values;
        for (std::size_t i = 0; i < asked.right.size(); ++i) {
            const Question& q = asked.questions.list[i];
            const Real length = asked.a[q.contact] + asked.b[q.contact];
            const double other = 0.2 + 0.17 * static_cast<double>(q.k + 2 * q.contact);
            const double part = q.u ? Real(q.u->to<Real>() / length).convert_to<double>() : other;
            values.push_back(asked.right[i].convert_to<double>() * (is_force(q) ? factor : 1) *
                             (1 + size * (1 + std::sin(7 * std::cbrt(part)))));
        }
        return std::optional(values);
    };
}

} // namespace

Asked asked_about(const SceneKeys& keys, const ReferenceOptions& options) {
    Asked asked;
    Questions& questions = asked.questions;
    questions.file = "simulated";
    Questions sizes{"simulated", {}, {}};
    for (const double load : {1.0, second_load}) {
        questions.contacts.push_back(contact_of(keys, load));
        for (const scene::Quantity size : {scene::Quantity::a, scene::Quantity::b}) {
            sizes.list.push_back({{size}, "", questions.contacts.size() - 1, 1});
        }
    }
    sizes.contacts = questions.contacts;
    const auto found = values_of(sizes, options);
    const auto ask = [&](scene::AskedValue value, std::size_t contact) {
        questions.list.push_back(
            {std::move(value), std::to_string(questions.list.size()), contact, 1});
    };
    for (std::size_t contact = 0; contact < questions.contacts.size(); ++contact) {
        const bool shear = questions.contacts[contact].scene.shear.has_value();
        asked.a.push_back(found[2 * contact].value());
        asked.b.push_back(found[2 * contact + 1].value());
        ask({keys.contains("load.a") ? scene::Quantity::P : scene::Quantity::a}, contact);
        const double length = Real(asked.a.back() + asked.b.back()).convert_to<double>();
        std::vector<double> parts{0.03, 0.08, 0.15, 0.25, 0.38, 0.55};
        for (int k = 2; k <= 15; ++k) {
            parts.push_back(std::pow(10, -k));
        }
        for (const auto edge : {contact::Edge::right, contact::Edge::left}) {
            for (std::size_t k = 0; k < 3; ++k) {
                ask({scene::Quantity::c, k, edge}, contact);
            }
            for (const double part : parts) {
                scene::AskedValue value{scene::Quantity::p, 0, edge};
                value.u = exactly(Real(part * length));
                ask(value, contact);
                if (shear) {
                    value.quantity = scene::Quantity::q;
                    ask(value, contact);
                }
            }
        }
    }
    for (const auto& value : values_of(questions, options)) {
        asked.right.push_back(value.value());
    }
    return asked;
}

std::vector<WrongProgram> wrong_programs(const SceneKeys& keys, const ReferenceOptions& options) {
    constexpr double pi = std::numbers::pi;
    std::vector<WrongProgram> list{
        {"", factor(1)},
        {"", smooth_error(0.02)},
        {"", smooth_error(0.2)},
        {"factor-2", smooth_error(0.01, 2)},
        {"factor-2", smooth_error(0.05, 0.5)},
        {"factor-pi", smooth_error(0.05, pi)},
        {"factor-sqrt-2", smooth_error(0.05, std::sqrt(2))},
        {"power-of-ten", smooth_error(0.05, 1e3)},
        {"factor", factor(1.37)},
        {"factor", factor(3.05)},
        {"factor-2", factor(2)},
        {"factor-2", factor(0.5)},
        {"factor-pi", factor(1 / pi)},
        {"factor-sqrt-2", factor(std::sqrt(2))},
        {"factor-sqrt-pi", factor(std::sqrt(pi))},
        {"factor-sqrt-2-pi", factor(std::sqrt(2 * pi))},
        {"power-of-ten", factor(1e-3)},
        {"unit-g", factor(9.80665)},
        {"unit-psi", factor(1 / 6.894757293168)},
        {"sign", factor(-1)},
        {"log10", of_values([](const Question& q, double value) {
             return q.quantity == scene::Quantity::p ? std::log10(value) : value;
         })},
        {"one-term", terms(1)},
        {"two-term", terms(2)},
        {"three-term", terms(3)},
        {"rounded-to-3", factor(1), [](double value) { return rounded(value, 3); }},
        {"rounded-to-5", factor(1), [](double value) { return rounded(value, 5); }},
        {"binary32", factor(1),
         [](double value) { return static_cast<double>(static_cast<float>(value)); }},
        {"x-for-u",
         of_places([](const Real& edge, const Real& u) { return Real(edge - u); }, options)},
        {"cancellation", of_places(
                             [](const Real& edge, const Real& u) {
                                 const auto a = edge.convert_to<double>();
                                 const double x = a - u.convert_to<double>();
                                 return Real(Real(a) - Real(x));
                             },
                             options)},
        {"edges-swapped",
         [options](const Asked& asked) {
             Questions otherwise = asked.questions;
             for (Question& q : otherwise.list) {
                 q.edge = opposite(q.edge);
             }
             return answered_otherwise(asked, otherwise, options);
         }},
    };
    std::vector<test::InjectedKeys> mistakes = test::injected_keys();
    mistakes.push_back({"another-force", false,
                        test::with_key({"load.a", "load.P", "load.M", "load.delta"},
                                       [](double load) { return 1.37 * load; })});
    for (const test::InjectedKeys& mistake : mistakes) {
        list.push_back(
            {mistake.name, [=](const Asked& asked) -> std::optional<std::vector<double>> {
                 const auto changed = mistake.change(keys);
                 if (!changed) {
                     return {};
                 }
                 Questions otherwise = asked.questions;
                 otherwise.contacts.clear();
                 for (const double load : {1.0, second_load}) {
                     otherwise.contacts.push_back(contact_of(*changed, load));
                 }
                 return answered_otherwise(asked, otherwise, options);
             }});
    }
    const auto stretched = [](const Real& edge, const Real& u) {
        return Real(edge - (edge - u) / Real("1.05"));
    };
    list.push_back({"factor-of-x", of_places(stretched, options)});
    list.push_back({"factor-of-u",
                    of_places([](const Real&, const Real& u) { return Real(u / 1.3); }, options)});
    return list;
}

} // namespace edgeproof::conformance
