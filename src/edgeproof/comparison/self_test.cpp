// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/self_test.hpp"

#include "edgeproof/comparison/comparison.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>

namespace edgeproof::comparison {
namespace {

constexpr int elements = 120;
constexpr double above_noise = 5;
constexpr double no_effect = 1e-9;

struct Data {
    std::vector<ComputedRow> rows;
    int digits = 0;
};

/// The output of the program with the mistake, on an interval that contains its own contact.
std::optional<Data> computed(const Program& program, bool shear) {
    try {
        SceneKeys keys = program.keys;
        std::erase_if(
            keys, [shear](const auto& key) { return !shear && key.first.starts_with("shear."); });
        const ExactContact contact(scene_of(keys));
        // If a program takes |x| for u, the pressure covers twice the contact.
        const double reach = 0.23 * contact.length();
        const double whole = program.p ? std::max(contact.a().value, contact.b().value) : 0;
        const double left = std::max(contact.b().value, whole) + reach;
        const double right = std::max(contact.a().value, whole) + reach;
        Data data;
        data.digits = program.digits;
        for (int i = 0; i <= elements; ++i) {
            check_interruption();
            const double x = -left + (left + right) * i / elements;
            const Real at(x);
            const auto place = contact.at(at);
            ComputedRow row;
            row.x = program.written_x ? program.written_x(x) : x;
            row.p = program.p ? program.p(contact, x) : place.p.value_or(contact.pressure(x));
            if (shear) {
                row.q = contact.traction(at, place).value_or(0);
            }
            data.rows.push_back(row);
        }
        if (program.rows) {
            program.rows(data.rows);
        }
        return data;
    } catch (const Error&) { // no contact: no program could have computed it
        return {};
    }
}

std::string written(double value, int digits) {
    if (digits < 0) {
        return fmt::format("{:.16e}", static_cast<double>(static_cast<float>(value)));
    }
    return digits == 0
               ? fmt::format("{:.16e}", value)
               : fmt::format("{:.16e}", std::stod(fmt::format("{:.{}e}", value, digits - 1)));
}

std::string table_of(const Data& data, double noise, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal(0, 1);
    std::string text = data.rows.front().q ? "x,p,q\n" : "x,p\n";
    for (const ComputedRow& row : data.rows) {
        const double p = row.p * (1 + noise * normal(random));
        text += fmt::format("{:.16e},{}", row.x, written(p, data.digits));
        text += row.q ? fmt::format(",{:.16e}\n", *row.q * (1 + noise * normal(random))) : "\n";
    }
    return text;
}

/// The rms of the error of data, over nodes a twentieth of the contact away from an edge, and of
/// the effect of noise of relative size 1; both relative to the largest value there.
struct Moved {
    double by = 0;
    double noise = 0;
};
Moved moved(const FileComparison& file, bool shear, const ExactContact& exact) {
    double off = 0;
    double size = 0;
    double largest = 0;
    std::size_t n = 0;
    for (const Node& node : file.data.nodes) {
        const auto value = shear ? node.shear->exact : node.exact.p;
        const double near = 0.05 * exact.length();
        const bool by_corner = std::ranges::any_of(exact.knots(), [&](const ContactKnot& knot) {
            return knot.corner && std::abs(node.x - knot.x) < near;
        });
        if (value && !by_corner && node.exact.u() > near) {
            const double data = shear ? node.shear->q : node.p;
            off += (data - *value) * (data - *value);
            size += data * data;
            largest = std::max({largest, std::abs(*value), std::abs(data)});
            ++n;
        }
    }
    if (n == 0) {
        return {1, 0}; // no node is near the contact
    }
    const double count = static_cast<double>(n);
    return {std::sqrt(off / count) / largest, std::sqrt(size / count) / largest};
}

class Trials {
public:
    Trials(std::uint64_t seed, SelfTest& result) : seed_(seed), result_(result) {}

    void contact(const TestedContact& tested) {
        const bool shear = tested.keys.contains("shear.Q");
        SuspectContacts suspects(scene_of(tested.keys));
        const ExactContact exact(suspects.scene());
        for (const InjectedMistake& mistake : injected_mistakes()) {
            if (mistake.of_shear != shear) {
                continue;
            }
            const auto program = mistake.make(tested.keys);
            const auto data = program ? computed(*program, shear) : std::nullopt;
            for (std::size_t i = 0; data && i < noise_levels.size(); ++i) {
                trial(tested, suspects, exact, mistake, *data, i);
            }
        }
    }

private:
    static std::vector<std::string> names_in(const std::optional<Diagnosis>& diagnosis) {
        std::vector<std::string> names;
        if (diagnosis) {
            std::ranges::transform(diagnosis->causes, std::back_inserter(names), &Cause::name);
        }
        return names;
    }
    void trial(const TestedContact& tested, SuspectContacts& suspects, const ExactContact& exact,
               const InjectedMistake& mistake, const Data& data, std::size_t level) {
        const double noise = noise_levels[level];
        Tolerances strict;
        strict.pressure = no_effect;
        const auto compared = [&](double at) {
            return compare_file(parse_result(table_of(data, at, seed_), "self-test.csv"), exact,
                                strict, Rational(0), &suspects);
        };
        const bool right = mistake.name.empty();
        const Moved effect = moved(clean(mistake, tested, compared), mistake.of_shear, exact);
        if (!right && effect.by < no_effect) {
            return; // no mistake in this contact
        }
        const FileComparison file = compared(noise);
        const auto& diagnosis = mistake.of_shear ? file.shear_diagnosis : file.diagnosis;
        const std::vector<std::string> names = names_in(diagnosis);
        // With a mistake in q, p is right.
        const bool misled = mistake.of_shear && !names_in(file.diagnosis).empty();
        const bool named =
            right ? names.empty() : std::ranges::find(names, mistake.name) != names.end();
        const bool hidden = !right && effect.by < above_noise * noise * effect.noise;
        SelfTestCount& count = row(mistake.name).at[level];
        count.cases += hidden ? 0 : 1;
        count.beyond += hidden ? 1 : 0;
        count.named += named && !hidden ? 1 : 0;
        count.alone +=
            named && !hidden &&
                    std::ranges::all_of(
                        names, [&](const std::string& name) { return name == mistake.name; })
                ? 1
                : 0;
        count.wrong += misled || (!named && !names.empty()) ? 1 : 0;
        if (misled || (!named && (!hidden || !names.empty()))) {
            std::string said;
            for (const std::string& name : names) {
                said += (said.empty() ? "" : ", ") + name;
            }
            result_.misses.push_back(fmt::format(
                "{} in {}, noise {:g}: {} (it changes {} by {:.2g}, {:.2g} are unexplained)",
                right ? "right data" : mistake.name, tested.name, noise,
                said.empty() ? "nothing is named" : "named " + said, mistake.of_shear ? "q" : "p",
                effect.by, diagnosis ? diagnosis->unexplained : 0));
        }
    }
    /// Returns the comparison without noise, computed once for all levels.
    template <class Compare>
    const FileComparison& clean(const InjectedMistake& mistake, const TestedContact& tested,
                                const Compare& compared) {
        if (last_mistake_ != &mistake || last_contact_ != &tested) {
            clean_ = compared(0.0);
            last_mistake_ = &mistake;
            last_contact_ = &tested;
        }
        return clean_;
    }
    SelfTestRow& row(const std::string& name) {
        const auto found = std::ranges::find(result_.rows, name, &SelfTestRow::name);
        if (found != result_.rows.end()) {
            return *found;
        }
        result_.rows.push_back({name, {}});
        return result_.rows.back();
    }

    std::uint64_t seed_;
    SelfTest& result_;
    const InjectedMistake* last_mistake_ = nullptr;
    const TestedContact* last_contact_ = nullptr;
    FileComparison clean_;
};

} // namespace

SelfTestCount SelfTest::total() const {
    SelfTestCount sum;
    for (const SelfTestRow& row : rows) {
        for (const SelfTestCount& count : row.at) {
            sum.wrong += count.wrong;
            if (row.name.empty()) {
                continue;
            }
            sum.cases += count.cases;
            sum.named += count.named;
            sum.alone += count.alone;
            sum.beyond += count.beyond;
        }
    }
    return sum;
}

bool SelfTest::passes() const {
    const SelfTestCount sum = total();
    return sum.cases > 0 && sum.wrong == 0 && 100 * sum.named >= 95 * sum.cases;
}

SelfTest run_self_test(std::uint64_t seed, const std::vector<std::string>& contacts,
                       const std::function<void(std::size_t, std::size_t)>& progress) {
    SelfTest result;
    Trials trials(seed, result);
    std::size_t done = 0;
    for (const TestedContact& contact : tested_contacts()) {
        if (contacts.empty() || std::ranges::find(contacts, contact.name) != contacts.end()) {
            trials.contact(contact);
        }
        ++done;
        if (progress) {
            progress(done, tested_contacts().size());
        }
    }
    return result;
}

} // namespace edgeproof::comparison
