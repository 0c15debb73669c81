// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/causes/convention.hpp"
#include "edgeproof/parallel/parallel_for.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "tests/support/injected_keys.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <random>
#include <utility>

// Each contact has two loads. Every cause reported, of any quantity, must have the name of the
// mistake, alone or among those equally likely. A mistake is hidden if it changes fewer than eight
// answers by more than five times the noise. Mistakes without a name are right answers, and errors
// that no mistake of the catalogue explains.
// The mistakes are made without the catalogue that is under test:
// the keys of the contact are changed (tests/support/injected_keys.hpp), or places and values as a
// program would change them.
namespace edgeproof::conformance {
namespace {

using test::SceneKeys;

/// The questions about a profile under two loads, and the right answers.
struct Asked {
    Questions questions;
    std::vector<Real> a; ///< by contact
    std::vector<Real> b;
    std::vector<Real> right;
};

/// The answers of a program; nothing if the program could not have computed any.
using Program = std::function<std::optional<std::vector<double>>(const Asked&)>;
struct WrongProgram {
    std::string name;
    Program program;
    std::function<double(double)> write = {}; ///< changes an answer after the noise
};

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

std::vector<WrongProgram> mistakes(const SceneKeys& keys, const ReferenceOptions& options) {
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
    for (const test::InjectedKeys& mistake : test::injected_keys()) {
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
    return list;
}

constexpr double above_noise = 5;
constexpr std::size_t least_changed = 8; // answers
constexpr double no_change = 1e-10;

struct TestedProfile {
    std::string name;
    SceneKeys keys;
};
/// A line: the name, and the keys of the scene.
const char* const contacts_and_keys = R"(
a wedge: profile.kind=power-law profile.m=0 profile.C=0.1 load.a=1.3 UNLIKE
a cylinder, a given: profile.kind=cylinder-on-flat profile.R=40 load.a=0.7 LIKE
two cylinders, P given: profile.kind=hertz profile.R1=20 profile.R2=50 load.P=300 UNLIKE
a power law, P given: profile.kind=power-law profile.m=3 profile.C=0.02 load.P=300 load.contact_modulus=80e3
a flat with rounded edges, a given: profile.kind=flat-and-rounded profile.t=1 profile.R=75 load.a=1.6 UNLIKE
a flat with rounded edges, P given: profile.kind=flat-and-rounded profile.t=2 profile.R=75 load.P=400 LIKE
a tilted wedge: profile.kind=tilted-wedge profile.phi=0.15 profile.alpha=0.05 load.a=1 LIKE
a tilted flat with rounded edges: profile.kind=tilted-flat-and-rounded profile.alpha=0.01 profile.t=1 profile.R=75 load.a=3 UNLIKE
a wedge under P and M: profile.kind=tilted-wedge profile.phi=0.1 load.P=5000 load.M=-2000 LIKE
a piecewise linear profile: profile.kind=piecewise profile.knots=-1/2;0;1/3 profile.slopes=-3/20;-1/20;1/10;1/5 load.a=1 UNLIKE
two spheres: profile.geometry=axisymmetric profile.kind=hertz profile.R1=20 profile.R2=50 load.P=300 UNLIKE
a sphere, delta given: profile.geometry=axisymmetric profile.kind=hertz profile.R=30 load.delta=0.02 LIKE
a cylinder, full stick: profile.kind=cylinder-on-flat profile.R=30 load.P=300 shear.Q=40 shear.bulk_tension=60 LIKE
)";

std::vector<TestedProfile> tested_profiles() {
    std::vector<TestedProfile> all;
    std::istringstream text(contacts_and_keys);
    for (std::string line; std::getline(text, line);) {
        const std::size_t colon = line.find(": ");
        if (colon == std::string::npos) {
            continue;
        }
        SceneKeys keys = test::keys_of(line.substr(colon + 2));
        if (keys.erase("LIKE") == 1) {
            keys.merge(test::keys_of("load.E1=200e3 load.nu1=0.3 load.E2=200e3 load.nu2=0.3"));
        } else if (keys.erase("UNLIKE") == 1) {
            keys.merge(test::keys_of("load.E1=115e3 load.nu1=0.32 load.E2=70e3 load.nu2=0.25"));
        }
        all.push_back({line.substr(0, colon), std::move(keys)});
    }
    return all;
}

Answer written(double value) {
    Answer answer = read_answer(fmt::format("{:.17g}", value));
    answer.line = 1;
    return answer;
}

/// The number of answers that are wrong by more than `by`.
std::size_t changed(const Asked& asked, const std::vector<double>& values, double by) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        count += std::abs(values[i] / asked.right[i].convert_to<double>() - 1) > by ? 1 : 0;
    }
    return count;
}

test::MistakeTrial trial_of(const WrongProgram& mistake, const TestedProfile& tested,
                            std::size_t level, const std::vector<Convention>& found,
                            std::size_t changed) {
    test::MistakeTrial trial{mistake.name, tested.name, level, {}};
    trial.hidden = !mistake.name.empty() && changed < least_changed;
    for (const Convention& c : found) {
        std::vector<std::string> names = c.equally_likely;
        names.push_back(c.name);
        trial.misled = trial.misled || std::ranges::find(names, mistake.name) == names.end();
        trial.named.insert(trial.named.end(), names.begin(), names.end());
    }
    return trial;
}

std::vector<test::MistakeTrial> trials_of(const TestedProfile& tested, std::uint64_t seed,
                                          const ReferenceOptions& options) {
    const PrecisionScope scope(60);
    const Asked asked = asked_about(tested.keys, options);
    Answers answers{asked.questions, {}, {}};
    for (const Real& right : asked.right) {
        answers.given.push_back(written(right.convert_to<double>()));
    }
    constexpr Target target{11, {}, false};
    const Agreements right = compare(answers, target, options);
    KnownReadings known;
    std::vector<test::MistakeTrial> trials;
    for (const WrongProgram& mistake : mistakes(tested.keys, options)) {
        std::optional<std::vector<double>> values;
        try {
            values = mistake.program(asked);
        } catch (const Error&) { // the changed keys are no contact
        }
        if (!values) {
            continue;
        }
        std::vector<double> without_noise = *values;
        if (mistake.write) {
            std::ranges::transform(*values, without_noise.begin(), mistake.write);
        }
        if (!mistake.name.empty() && changed(asked, without_noise, no_change) == 0) {
            continue;
        }
        for (std::size_t level = 0; level < test::noise_levels.size(); ++level) {
            const double noise = test::noise_levels[level];
            std::mt19937_64 random(seed++);
            std::normal_distribution<double> normal;
            for (std::size_t i = 0; i < values->size(); ++i) {
                const double value = (*values)[i] * (1 + noise * normal(random));
                answers.given[i] = written(mistake.write ? mistake.write(value) : value);
            }
            const auto found =
                infer_conventions(answers, compare_again(answers, target, right), options, &known);
            trials.push_back(
                trial_of(mistake, tested, level, found,
                         changed(asked, without_noise, std::max(no_change, above_noise * noise))));
        }
    }
    return trials;
}

constexpr std::size_t least_percent_named = 90;

test::MistakeCounts count_named(std::uint64_t seed, const std::vector<std::string>& contacts = {}) {
    ReferenceOptions options;
    options.digits = {30, Rounding::nearest, false};
    options.threads = 1; // each contact has a thread
    const std::vector<TestedProfile> profiles = tested_profiles();
    std::vector<std::vector<test::MistakeTrial>> trials(profiles.size());
    parallel::parallel_for(profiles.size(), 0, [&](std::size_t i) {
        if (contacts.empty() || std::ranges::find(contacts, profiles[i].name) != contacts.end()) {
            // The same answers whichever contacts are tested.
            trials[i] = trials_of(profiles[i], seed * 1'000'003 + i * 10'007, options);
        }
    });
    test::MistakeCounts counts;
    for (const auto& of_contact : trials) {
        counts.contacts += of_contact.empty() ? 0 : 1;
        std::ranges::for_each(of_contact, [&](const auto& trial) { counts.count(trial); });
    }
    return counts;
}

} // namespace

TEST_CASE("named causes: mistakes are named under noise, and none wrongly" *
          doctest::test_suite("slow")) {
    const test::MistakeCounts counts = count_named(7, {"two cylinders, P given"});
    counts.check(least_percent_named);
    CHECK(counts.contacts == 1);
    CHECK(counts.of.at("cancellation")[0].named == 1);
    CHECK(counts.of.at("sum-of-moduli")[2].named == 2); // 0.1 % of noise: not called a factor pi
    CHECK(counts.of.at("plane-stress")[2].named == 1);
    CHECK(counts.of.at("x-for-u")[0].named == 1);
    CHECK(counts.of.at("")[4].named == 3); // right answers and two smooth errors, 5 % of noise
}

TEST_CASE("named causes: noise by which wrong causes were named once" *
          doctest::test_suite("slow")) {
    const std::pair<std::uint64_t, std::vector<std::string>> draws[] = {
        // sqrt(2) and a smooth rest, with 5 % of noise
        {91102, {"a wedge", "a piecewise linear profile"}},
        // sqrt(2) and a rest of just over a tenth; the noise of 12 answers has a mean of 4
        // deviations
        {12, {"a cylinder, a given", "a flat with rounded edges, a given"}},
        // 1.37 near sqrt(2): the constant is added to the named causes
        {300003, {"two spheres"}},
        // the noise of p has a mean of several deviations; c_k has the cause
        {600005, {"two spheres"}},
        // 12 answers that noise spreads over 3.5 deviations
        {300002, {"a cylinder, full stick"}},
        // two answers of 5 digits with the same error
        {500004, {"a cylinder, full stick"}},
    };
    for (const auto& [seed, contacts] : draws) {
        const test::MistakeCounts counts = count_named(seed, contacts);
        counts.check(least_percent_named);
        CHECK(counts.contacts == contacts.size());
    }
}

TEST_CASE("named causes: all contacts" * doctest::test_suite("slow")) {
    for (const std::uint64_t seed : {11, 12, 13}) {
        CAPTURE(seed);
        const test::MistakeCounts counts = count_named(seed);
        counts.check(least_percent_named);
        CHECK(counts.contacts == 13);
    }
}

} // namespace edgeproof::conformance
