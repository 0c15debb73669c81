// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/injected_mistake.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string_view>

namespace edgeproof::comparison {
namespace {

using Make = std::function<std::optional<Program>(const SceneKeys&)>;
constexpr double pi = std::numbers::pi;

/// Reads "profile.R=2 load.P=3".
SceneKeys keys_of(const std::string& text) {
    SceneKeys keys;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        const std::size_t equals = word.find('=');
        keys.emplace(word.substr(0, equals), word.substr(equals + 1));
    }
    return keys;
}

double number_in(const SceneKeys& keys, const std::string& key) { return std::stod(keys.at(key)); }

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
/// Changes the numbers of those keys that the scene has.
Make with_key(const std::vector<std::string>& names, const std::function<double(double)>& change) {
    return with(names, [=](Program& program) {
        for (const std::string& name : names) {
            if (program.keys.contains(name)) {
                program.keys[name] = fmt::format("{:.17g}", change(number_in(program.keys, name)));
            }
        }
    });
}
Make times_key(const std::string& name, double k) {
    return with_key({name}, [k](double x) { return k * x; });
}

/// Replaces E* by a function of the bodies' constants.
Make with_modulus(const std::function<double(double, double, double, double)>& modulus) {
    return with({"load.E1"}, [=](Program& program) {
        SceneKeys& keys = program.keys;
        const double E = modulus(number_in(keys, "load.E1"), number_in(keys, "load.nu1"),
                                 number_in(keys, "load.E2"), number_in(keys, "load.nu2"));
        for (const char* const key : {"load.E1", "load.nu1", "load.E2", "load.nu2"}) {
            keys.erase(key);
        }
        keys["load.contact_modulus"] = fmt::format("{:.17g}", E);
    });
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
Make digits(int n) {
    return with({}, [n](Program& program) { program.digits = n; });
}

double first_of(double E1, double nu1) { return E1 / (1 - nu1 * nu1); }

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

} // namespace

scene::Scene scene_of(const SceneKeys& keys) {
    scene::SceneEntries entries;
    for (const auto& [key, value] : keys) {
        const std::size_t dot = key.find('.');
        const std::string section = key.substr(0, dot);
        (section == "profile" ? entries.profile
         : section == "load"  ? entries.load
                              : entries.shear)
            .push_back({key.substr(dot + 1), value});
    }
    return scene::make_scene(entries);
}

const std::vector<TestedContact>& tested_contacts() {
    static const std::string like = " load.E1=200e3 load.nu1=0.3 load.E2=200e3 load.nu2=0.3";
    static const std::string unlike = " load.E1=200e3 load.nu1=0.3 load.E2=70e3 load.nu2=0.35";
    static const std::string cylinders =
        "profile.kind=hertz profile.R1=20 profile.R2=50 load.P=300";
    static const std::string pad =
        "profile.kind=flat-and-rounded profile.t=2 profile.R=75 load.P=400";
    static const std::string tilted = "profile.kind=tilted-flat-and-rounded profile.alpha=0.01 "
                                      "profile.t=2 profile.R=75 load.P=1500";
    static const std::vector<TestedContact> list{
        {"two cylinders, like materials", keys_of(cylinders + like)},
        {"two cylinders, unlike materials", keys_of(cylinders + unlike)},
        {"a flat with rounded edges, unlike materials", keys_of(pad + unlike)},
        {"a tilted wedge, a given",
         keys_of("profile.kind=tilted-wedge profile.phi=0.15 profile.alpha=0.05 load.a=1" + like)},
        {"a tilted flat with rounded edges", keys_of(tilted + unlike)},
        {"a wedge under P and M",
         keys_of("profile.kind=tilted-wedge profile.phi=0.1 load.P=5000 load.M=-2000" + like)},
        {"two cylinders, full stick",
         keys_of(cylinders + like + " shear.Q=40 shear.bulk_tension=60")},
        {"a flat with rounded edges, full stick",
         keys_of(pad + like + " shear.Q=40 shear.bulk_tension=-25")},
        {"two cylinders, partial slip",
         keys_of(cylinders + like + " shear.Q=60 shear.friction=0.5")},
        {"a tilted flat with rounded edges, partial slip",
         keys_of(tilted + like + " shear.Q=200 shear.bulk_tension=10 shear.friction=0.4")},
    };
    return list;
}

const std::vector<InjectedMistake>& injected_mistakes() {
    static const auto tangent = [](double x) { return std::tan(x); };
    static const auto degrees = [](double x) { return x * 180 / pi; };
    static const std::vector<std::string> angles{"profile.phi", "profile.alpha"};
    static const std::vector<InjectedMistake> list{
        {"", false, with({}, [](Program&) {})},
        {"", true, with({}, [](Program&) {})},
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
        {"e-for-e-star", false, with_modulus([](double E1, double, double, double) { return E1; })},
        {"one-body-modulus", false,
         with_modulus([](double E1, double nu1, double, double) { return first_of(E1, nu1); })},
        {"one-body-modulus", false,
         with_modulus([](double, double, double E2, double nu2) { return first_of(E2, nu2) / 2; })},
        {"nu-not-squared", false, with_modulus([](double E1, double nu1, double E2, double nu2) {
             return 1 / ((1 - nu1) / E1 + (1 - nu2) / E2);
         })},
        {"plane-stress", false,
         with_modulus([](double E1, double, double E2, double) { return 1 / (1 / E1 + 1 / E2); })},
        {"shear-modulus", false, with_modulus([](double E1, double nu1, double E2, double nu2) {
             return 1 / ((1 + nu1) / E1 + (1 + nu2) / E2);
         })},
        {"radius-as-diameter", false, times_key("profile.R", 2)},
        {"radius-as-diameter", false,
         with_key({"profile.R1", "profile.R2"}, [](double R) { return R / 2; })},
        {"one-body-radius", false, with_key({"profile.R2"}, [](double) { return 1e30; })},
        {"flat-as-full-width", false, times_key("profile.t", 0.5)},
        {"half-force", false, times_key("load.P", 0.5)},
        {"full-width-for-half", false, times_key("load.a", 2)},
        {"full-width-for-half", false, x_times(2)},
        {"sign-of-moment", false, times_key("load.M", -1)},
        {"half-moment", false, times_key("load.M", 0.5)},
        {"tangent-of-angle", false, with_key(angles, tangent)},
        {"degrees", false, with_key(angles, degrees)},
        {"no-tilt", false, times_key("profile.alpha", 0)},
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
                  const double length = number_in(
                      program.keys, program.keys.contains("load.a") ? "load.a" : "load.P");
                  program.written_x = [length,
                                       given_a = program.keys.contains("load.a")](double x) {
                      return x + (given_a ? 0.02 * length : 0.01);
                  };
              })},
        {"shifted-rows", false, rows(shift_rows)},
        {"element-average", false, rows(average_rows)},
        {"one-term", false, terms(1)},
        {"two-term", false, terms(2)},
        {"three-term", false, terms(3)},
        {"rounded-to-3", false, digits(3)},
        {"rounded-to-5", false, digits(5)},
        {"binary32", false, digits(-1)},
        {"half-shear-force", true, times_key("shear.Q", 0.5)},
        {"half-tension", true, times_key("shear.bulk_tension", 0.5)},
        {"no-tension", true, times_key("shear.bulk_tension", 0)},
        {"sign-of-tension", true, times_key("shear.bulk_tension", -1)},
        {"no-slip", true,
         with({"shear.friction"}, [](Program& program) { program.keys.erase("shear.friction"); })},
        {"all-slips", true,
         with({"shear.friction"},
              [](Program& program) {
                  program.rows = [f = number_in(program.keys, "shear.friction")](auto& computed) {
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
    };
    return list;
}

} // namespace edgeproof::comparison
