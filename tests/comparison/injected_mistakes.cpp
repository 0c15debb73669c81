// SPDX-License-Identifier: BSD-3-Clause
#include "tests/comparison/injected_mistakes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

namespace edgeproof::comparison {
namespace {

using Make = std::function<std::optional<Program>(const SceneKeys&)>;
constexpr double pi = std::numbers::pi;

/// Changes programs for contacts that have one of the keys; all contacts if no keys are given.
Make with(const std::vector<std::string>& names, const std::function<void(Program&)>& change) {
    return [=](const SceneKeys& keys) -> std::optional<Program> {
        const auto has = [&](const std::string& name) { return keys.contains(name); };
        if (!names.empty() && std::ranges::none_of(names, has)) {
            return {};
        }
        Program program{keys};
        change(program);
        return program;
    };
}
Make factor(double k) {
    return with({}, [k](Program& program) {
        program.p = [k](const ExactContact& contact, double x) { return k * contact.pressure(x); };
    });
}
Make x_times(double k) {
    return with({}, [k](Program& program) { program.written_x = [k](double x) { return k * x; }; });
}
/// A mistake that has an effect only if the edges are not alike.
Make unless_symmetric(const std::function<double(const ExactContact&, double)>& p) {
    return with({"profile.alpha", "load.M"}, [p](Program& program) { program.p = p; });
}
Make terms(std::size_t n) {
    return with({}, [n](Program& program) {
        program.p = [n](const ExactContact& contact, double x) {
            const auto place = contact.at(Real(x));
            double sum = 0;
            for (std::size_t k = 0; place.inside() && k < n; ++k) {
                sum += contact.c(place.nearer(), k).value *
                       std::pow(place.u(), static_cast<double>(k) + 0.5);
            }
            return sum;
        };
    });
}
Make rows(const std::function<void(std::vector<ComputedRow>&)>& change) {
    return with({}, [change](Program& program) { program.rows = change; });
}
/// Springs between the bodies (causes/causes.hpp) instead of rigid contact.
Make springs(double softness) {
    return with({}, [softness](Program& program) {
        program.p = [softness, keys = program.keys,
                     bed = std::make_shared<std::optional<SpringBed>>()](
                        const ExactContact& contact, double x) {
            if (!*bed) {
                bed->emplace(test::scene_of(keys), contact, softness);
            }
            return (*bed)->pressure(x);
        };
    });
}
Make digits(int n) {
    return with({}, [n](Program& program) { program.digits = n; });
}

/// Adds the mistakes in the keys of a scene: those of the pressure before the first that changes
/// places, those of the shear before the first of the shear.
std::vector<InjectedMistake> with_those_of_keys(std::vector<InjectedMistake> list) {
    for (const bool of_shear : {false, true}) {
        std::vector<InjectedMistake> of_keys;
        for (const test::InjectedKeys& mistake : test::injected_keys()) {
            if (mistake.of_shear == of_shear) {
                of_keys.push_back(
                    {mistake.name, of_shear,
                     [change = mistake.change](const SceneKeys& keys) -> std::optional<Program> {
                         auto changed = change(keys);
                         return changed ? std::optional(Program{std::move(*changed)})
                                        : std::nullopt;
                     }});
            }
        }
        const char* const first = of_shear ? "all-slips" : "full-width-for-half";
        list.insert(std::ranges::find(list, first, &InjectedMistake::name), of_keys.begin(),
                    of_keys.end());
    }
    return list;
}

void shift_rows(std::vector<ComputedRow>& list) {
    for (std::size_t i = 0; i + 1 < list.size(); ++i) {
        list[i].p = list[i + 1].p;
    }
    list.pop_back();
}
void average_rows(std::vector<ComputedRow>& list) {
    std::vector<double> means; // of the elements
    for (std::size_t i = 0; i + 1 < list.size(); ++i) {
        means.push_back((list[i].p + list[i + 1].p) / 2);
    }
    for (std::size_t i = 1; i + 1 < list.size(); ++i) {
        list[i].p = (means[i - 1] + means[i]) / 2;
    }
}

/// Values at the corners and in the middles of the sides of quadratic elements.
Make alternating(double corner, double middle) {
    return rows([=](std::vector<ComputedRow>& list) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            list[i].p *= i % 2 == 0 ? corner : middle;
        }
    });
}
/// An error of 5 % that is a wave, and no known mistake.
Make wave(double elements_long) {
    return rows([=](std::vector<ComputedRow>& list) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            list[i].p *= 1 + 0.05 * std::sin(2 * pi * static_cast<double>(i) / elements_long);
        }
    });
}

/// The forces of the nodes, by a linear pressure on each element.
void forces_of_rows(std::vector<ComputedRow>& list) {
    const std::vector<ComputedRow> right = list;
    for (std::size_t i = 0; i < list.size(); ++i) {
        list[i].p = 0;
        for (const std::size_t other : {i - 1, i + 1}) {
            if (other < list.size()) {
                list[i].p +=
                    std::abs(right[other].x - right[i].x) * (2 * right[i].p + right[other].p) / 6;
            }
        }
    }
}

/// A line: the name, and the keys of the scene.
const char* const contacts_and_keys = R"(
two cylinders, like materials: profile.kind=hertz profile.R1=20 profile.R2=50 load.P=300 LIKE
two cylinders, unlike materials: profile.kind=hertz profile.R1=20 profile.R2=50 load.P=300 UNLIKE
a flat with rounded edges, unlike materials: profile.kind=flat-and-rounded profile.t=2 profile.R=75 load.P=400 UNLIKE
a tilted wedge, a given: profile.kind=tilted-wedge profile.phi=0.15 profile.alpha=0.05 load.a=1 LIKE
a tilted flat with rounded edges: profile.kind=tilted-flat-and-rounded profile.alpha=0.01 profile.t=2 profile.R=75 load.P=1500 UNLIKE
a wedge under P and M: profile.kind=tilted-wedge profile.phi=0.1 load.P=5000 load.M=-2000 LIKE
two cylinders, full stick: profile.kind=hertz profile.R1=20 profile.R2=50 load.P=300 LIKE shear.Q=40 shear.bulk_tension=60
a flat with rounded edges, full stick: profile.kind=flat-and-rounded profile.t=2 profile.R=75 load.P=400 LIKE shear.Q=40 shear.bulk_tension=-25
two cylinders, partial slip: profile.kind=hertz profile.R1=20 profile.R2=50 load.P=300 LIKE shear.Q=60 shear.friction=0.5
two spheres: profile.geometry=axisymmetric profile.kind=hertz profile.R1=20 profile.R2=50 load.P=300 UNLIKE
a cone, delta given: profile.geometry=axisymmetric profile.kind=power-law profile.m=0 profile.C=0.1 load.delta=0.19 LIKE
a sphere, partial slip: profile.geometry=axisymmetric profile.kind=hertz profile.R=20 load.P=300 LIKE shear.Q=60 shear.friction=0.5
a tilted flat with rounded edges, partial slip: profile.kind=tilted-flat-and-rounded profile.alpha=0.01 profile.t=2 profile.R=75 load.P=1500 LIKE shear.Q=200 shear.bulk_tension=10 shear.friction=0.4
)";

} // namespace

const std::vector<TestedContact>& tested_contacts() {
    static const std::vector<TestedContact> list = test::contacts_in(
        contacts_and_keys, "load.E1=200e3 load.nu1=0.3 load.E2=70e3 load.nu2=0.35");
    return list;
}

const std::vector<InjectedMistake>& injected_mistakes() {
    static const std::vector<InjectedMistake> list = with_those_of_keys({
        {"", false, with({}, [](Program&) {})},
        {"", true, with({}, [](Program&) {})},
        {"", false, wave(2.3)},
        {"", false, wave(3)},
        {"", false, wave(4)},
        {"", false, wave(17)},
        {"factor-2", false, factor(2)},
        {"factor-pi", false, factor(1 / pi)},
        {"factor-sqrt-pi", false, factor(std::sqrt(pi))},
        {"factor-sqrt-2-pi", false, factor(std::sqrt(2 * pi))},
        {"power-of-ten", false, factor(1e-3)},
        {"power-of-ten", false, x_times(1e3)},
        {"unit-g", false, factor(9.80665)},
        {"unit-psi", false, factor(1 / 6.894757293168)},
        {"unit-psi", false, factor(1 / 0.006894757293168)},
        {"unit-inch", false, x_times(1 / 25.4)},
        {"full-width-for-half", false, x_times(2)},
        {"mirrored", false,
         unless_symmetric([](const ExactContact& c, double x) { return c.pressure(-x); })},
        {"edges-swapped", false, unless_symmetric([](const ExactContact& c, double x) {
             return c.pressure(c.a().value - c.b().value - x);
         })},
        {"x-from-middle", false, unless_symmetric([](const ExactContact& c, double x) {
             return c.pressure(x + (c.a().value - c.b().value) / 2);
         })},
        {"x-for-u", false,
         with({},
              [](Program& program) {
                  program.p = [](const ExactContact& c, double x) {
                      return c.pressure(c.a().value - std::abs(x));
                  };
              })},
        {"shifted-origin", false,
         with({},
              [](Program& program) {
                  const auto a = program.keys.find("load.a");
                  const double shift = a == program.keys.end() ? 0.01 : 0.02 * std::stod(a->second);
                  program.written_x = [shift](double x) { return x + shift; };
              })},
        {"shifted-rows", false, rows(shift_rows)},
        {"element-average", false, rows(average_rows)},
        {"nodal-forces", false,
         [](const SceneKeys& keys) {
             return keys.contains("profile.geometry") ? std::nullopt : rows(forces_of_rows)(keys);
         }},
        {"mid-side-nodes", false, alternating(1, 1.24)},
        {"mid-side-nodes", false, alternating(0.85, 1.15)},
        {"si-units", false,
         with({},
              [](Program& program) {
                  program.written_x = [](double x) { return 1e-3 * x; };
                  program.p = [](const ExactContact& c, double x) { return 1e6 * c.pressure(x); };
              })},
        {"soft-penalty", false, springs(0.02)},
        {"soft-penalty", false, springs(0.1)},
        {"one-term", false, terms(1)},
        {"two-term", false, terms(2)},
        {"three-term", false, terms(3)},
        {"rounded-to-3", false, digits(3)},
        {"rounded-to-5", false, digits(5)},
        {"binary32", false, digits(-1)},
        {"all-slips", true,
         with({"shear.friction"},
              [](Program& program) {
                  program.rows =
                      [f = std::stod(program.keys.at("shear.friction"))](auto& computed) {
                          for (ComputedRow& row : computed) {
                              row.q = f * row.p;
                          }
                      };
              })},
        // The mirror image of a symmetric contact has the same pressure, so only q shows it.
        {"mirrored", true,
         [](const SceneKeys& keys) -> std::optional<Program> {
             Program program{keys};
             program.written_x = [](double x) { return -x; };
             return keys.contains("profile.alpha") || !keys.contains("shear.bulk_tension")
                        ? std::nullopt
                        : std::optional(program);
         }},
    });
    return list;
}

} // namespace edgeproof::comparison
