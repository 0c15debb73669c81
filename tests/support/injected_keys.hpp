// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/scene/input/scene_file.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

/// Mistakes of users, put into right data with noise, test the diagnoses of `edgeproof compare` and
/// `edgeproof check`. They are made without the catalogue (diagnose/diagnose.hpp),
/// which is under test: here by changes of the keys of a scene file, such as "profile.R" -> "2".
namespace edgeproof::test {

using SceneKeys = std::map<std::string, std::string>;
using Change = std::function<std::optional<SceneKeys>(const SceneKeys&)>;

/// Relative, normally distributed noise of the data.
inline constexpr std::array noise_levels{0.0, 1e-6, 1e-3, 1e-2, 5e-2};

struct MistakeCount {
    std::size_t cases = 0; ///< whose mistake changes the data by more than the noise
    std::size_t named = 0; ///< alone or among causes that the data do not distinguish
    std::size_t alone = 0;
    std::size_t hidden = 0; ///< by the noise
    std::size_t wrong = 0;  ///< another cause is named, but not this one, also if hidden
};

/// One diagnosis of data with a mistake.
struct MistakeTrial {
    std::string mistake; ///< its name; empty: the data are right
    std::string contact;
    std::size_t level = 0; ///< of the noise
    std::vector<std::string> named;
    bool hidden = false;
    bool misled = false; ///< a cause is reported for data that are right
};

/// Right data have the name "" and count as named if no cause is reported.
struct MistakeCounts {
    std::map<std::string, std::array<MistakeCount, noise_levels.size()>> of;
    std::string misses;
    std::size_t contacts = 0;

    void count(const MistakeTrial& trial) {
        const auto is_it = [&](const std::string& name) { return name == trial.mistake; };
        const bool named =
            trial.mistake.empty() ? trial.named.empty() : std::ranges::any_of(trial.named, is_it);
        const bool found = named && !trial.hidden;
        const bool wrong = trial.misled || (!named && !trial.named.empty());
        MistakeCount& count = of[trial.mistake].at(trial.level);
        ++(trial.hidden ? count.hidden : count.cases);
        count.named += found ? 1 : 0;
        count.alone += found && std::ranges::all_of(trial.named, is_it) ? 1 : 0;
        count.wrong += wrong ? 1 : 0;
        if (wrong || (!named && !trial.hidden)) {
            misses += fmt::format("\"{}\" in {}, noise {:g}: named {}\n", trial.mistake,
                                  trial.contact, noise_levels.at(trial.level), trial.named);
        }
    }
    /// The sum over the mistakes. Of right data only wrong causes are counted.
    [[nodiscard]] MistakeCount total() const {
        MistakeCount sum;
        for (const auto& [name, levels] : of) {
            for (const MistakeCount& count : levels) {
                sum.wrong += count.wrong;
                if (!name.empty()) {
                    sum.cases += count.cases;
                    sum.named += count.named;
                    sum.alone += count.alone;
                    sum.hidden += count.hidden;
                }
            }
        }
        return sum;
    }
    /// Requires that this share of the mistakes is named, in percent, and none wrongly.
    void check(std::size_t percent) const {
        INFO(misses);
        const MistakeCount sum = total();
        CHECK(sum.wrong == 0);
        CHECK(sum.cases >= 10);
        CHECK(100 * sum.named >= percent * sum.cases);
    }
};

inline double number_in(const SceneKeys& keys, const std::string& key) {
    return std::stod(keys.at(key));
}

/// Changes contacts that have one of the keys.
inline Change with(const std::vector<std::string>& names,
                   const std::function<void(SceneKeys&)>& change) {
    return [=](const SceneKeys& keys) -> std::optional<SceneKeys> {
        if (std::ranges::none_of(names, [&](const auto& name) { return keys.contains(name); })) {
            return {};
        }
        SceneKeys changed = keys;
        change(changed);
        return changed;
    };
}
/// Changes the numbers of those keys that the scene has.
inline Change with_key(const std::vector<std::string>& names,
                       const std::function<double(double)>& change) {
    return with(names, [=](SceneKeys& keys) {
        for (const std::string& name : names) {
            if (keys.contains(name)) {
                keys[name] = fmt::format("{:.17g}", change(number_in(keys, name)));
            }
        }
    });
}
inline Change times_key(const std::string& name, double k) {
    return with_key({name}, [k](double x) { return k * x; });
}

/// Replaces E* by a function of the bodies' constants.
inline Change with_modulus(const std::function<double(double, double, double, double)>& modulus) {
    return with({"load.E1"}, [=](SceneKeys& keys) {
        const double E = modulus(number_in(keys, "load.E1"), number_in(keys, "load.nu1"),
                                 number_in(keys, "load.E2"), number_in(keys, "load.nu2"));
        for (const char* const key : {"load.E1", "load.nu1", "load.E2", "load.nu2"}) {
            keys.erase(key);
        }
        keys["load.contact_modulus"] = fmt::format("{:.17g}", E);
    });
}
inline double first_of(double E1, double nu1) { return E1 / (1 - nu1 * nu1); }

/// Reads "profile.R=2 load.P=3".
inline SceneKeys keys_of(const std::string& text) {
    SceneKeys keys;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        const std::size_t equals = word.find('=');
        keys.emplace(word.substr(0, equals), word.substr(equals + 1));
    }
    return keys;
}

/// A contact into whose data mistakes are put.
struct TestedContact {
    std::string name;
    SceneKeys keys;
};
/// Reads lines such as "a wedge: profile.kind=power-law ...". LIKE stands for two bodies of steel;
/// UNLIKE for bodies with the keys `unlike`.
inline std::vector<TestedContact> contacts_in(const std::string& text, const std::string& unlike) {
    std::vector<TestedContact> all;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t colon = line.find(": ");
        if (colon == std::string::npos) {
            continue;
        }
        SceneKeys keys = keys_of(line.substr(colon + 2));
        if (keys.erase("LIKE") == 1) {
            keys.merge(keys_of("load.E1=200e3 load.nu1=0.3 load.E2=200e3 load.nu2=0.3"));
        } else if (keys.erase("UNLIKE") == 1) {
            keys.merge(keys_of(unlike));
        }
        all.push_back({line.substr(0, colon), std::move(keys)});
    }
    return all;
}

inline scene::Scene scene_of(const SceneKeys& keys) {
    std::vector<io::TomlTable> tables{{"profile", 0, {}}, {"load", 0, {}}, {"shear", 0, {}}};
    for (const auto& [key, value] : keys) {
        const std::size_t dot = key.find('.');
        std::ranges::find(tables, key.substr(0, dot), &io::TomlTable::name)
            ->entries.push_back({key.substr(dot + 1), value});
    }
    return scene::make_scene(tables);
}

struct InjectedKeys {
    std::string name; ///< the name that a diagnosis should give
    bool of_shear = false;
    /// Returns the changed keys; nothing if the mistake is not possible in the contact.
    Change change;
};

inline const std::vector<InjectedKeys>& injected_keys() {
    static const auto tangent = [](double x) { return std::tan(x); };
    static const auto degrees = [](double x) { return x * 180 / std::numbers::pi; };
    static const std::vector<std::string> angles{"profile.phi", "profile.alpha"};
    static const std::vector<InjectedKeys> list{
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
        {"shear-modulus", false, with_modulus([](double E1, double nu1, double E2, double nu2) {
             const auto with_g = [](double E, double nu) {
                 return 2 * (1 + nu) * (1 - nu * nu) / E;
             };
             return 1 / (with_g(E1, nu1) + with_g(E2, nu2));
         })},
        {"sum-of-moduli", false, with_modulus([](double E1, double nu1, double E2, double nu2) {
             return first_of(E1, nu1) + first_of(E2, nu2);
         })},
        {"sum-of-moduli", false,
         with_modulus([](double E1, double, double E2, double) { return E1 + E2; })},
        {"factor-2", false, with_modulus([](double E1, double nu1, double E2, double nu2) {
             return 0.5 / ((1 - nu1 * nu1) / E1 + (1 - nu2 * nu2) / E2);
         })},
        {"radius-as-diameter", false, times_key("profile.R", 2)},
        {"radius-as-diameter", false,
         with_key({"profile.R1", "profile.R2"}, [](double R) { return R / 2; })},
        {"one-body-radius", false, with_key({"profile.R2"}, [](double) { return 1e30; })},
        {"flat-as-full-width", false, times_key("profile.t", 0.5)},
        {"half-force", false, times_key("load.P", 0.5)},
        {"force-per-radian", false,
         [](const SceneKeys& keys) -> std::optional<SceneKeys> {
             return keys.contains("profile.geometry")
                        ? times_key("load.P", 1 / (2 * std::numbers::pi))(keys)
                        : std::nullopt;
         }},
        {"plane-for-axisymmetric", false,
         with({"profile.geometry"}, [](SceneKeys& keys) { keys.erase("profile.geometry"); })},
        {"half-approach", false, times_key("load.delta", 0.5)},
        {"full-width-for-half", false, times_key("load.a", 2)},
        {"sign-of-moment", false, times_key("load.M", -1)},
        {"half-moment", false, times_key("load.M", 0.5)},
        {"tangent-of-angle", false, with_key(angles, tangent)},
        {"degrees", false, with_key(angles, degrees)},
        {"no-tilt", false, times_key("profile.alpha", 0)},
        {"half-shear-force", true, times_key("shear.Q", 0.5)},
        {"half-tension", true, times_key("shear.bulk_tension", 0.5)},
        {"no-tension", true, times_key("shear.bulk_tension", 0)},
        {"sign-of-tension", true, times_key("shear.bulk_tension", -1)},
        {"no-slip", true,
         with({"shear.friction"}, [](SceneKeys& keys) { keys.erase("shear.friction"); })},
    };
    return list;
}

} // namespace edgeproof::test
