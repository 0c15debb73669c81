// SPDX-License-Identifier: BSD-3-Clause
#include "tests/comparison/injected_mistakes.hpp"

#include "edgeproof/comparison/comparison.hpp"
#include "edgeproof/comparison/measures/measures.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "tests/support/namespaces.hpp"
#include "tests/support/paths.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>

namespace edgeproof::comparison {
namespace {

constexpr int elements = 120;
constexpr double above_noise = 5;
constexpr double no_effect = 1e-9;

/// The output of the program with the mistake, on an interval that contains its own contact.
std::optional<std::vector<ComputedRow>> computed(const Program& program, bool shear) {
    try {
        SceneKeys keys = program.keys;
        std::erase_if(
            keys, [shear](const auto& key) { return !shear && key.first.starts_with("shear."); });
        const ExactContact contact(test::scene_of(keys));
        // If a program takes |x| for u, the pressure covers twice the contact.
        const double reach = 0.23 * contact.length();
        const double whole = program.p ? std::max(contact.a().value, contact.b().value) : 0;
        const double left = std::max(contact.b().value, whole) + reach;
        const double right = std::max(contact.a().value, whole) + reach;
        std::vector<ComputedRow> rows;
        for (int i = 0; i <= elements; ++i) {
            check_interruption();
            const double x = -left + (left + right) * i / elements;
            const Real at(x);
            const auto place = contact.at(at);
            ComputedRow row;
            row.x = program.written_x ? program.written_x(x) : x;
            row.p =
                program.p ? program.p(contact, x) : contact.p(place).value_or(contact.pressure(x));
            if (shear) {
                row.q = contact.q(place).value_or(0);
            }
            rows.push_back(row);
        }
        if (program.rows) {
            program.rows(rows);
        }
        return rows;
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

std::string table_of(const std::vector<ComputedRow>& rows, int digits, double noise,
                     std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal(0, 1);
    std::string text = rows.front().q ? "x,p,q\n" : "x,p\n";
    for (const ComputedRow& row : rows) {
        const double p = row.p * (1 + noise * normal(random));
        text += fmt::format("{:.16e},{}", row.x, written(p, digits));
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
        const auto value = shear ? node.q->exact : node.p.exact;
        const double near = 0.05 * exact.length();
        const bool by_corner = std::ranges::any_of(exact.knots(), [&](const ContactKnot& knot) {
            return knot.corner && std::abs(node.x - knot.x) < near;
        });
        if (value && !by_corner && node.place.u() > near) {
            const double data = shear ? node.q->data : node.p.data;
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

std::vector<std::string> names_in(const std::optional<Diagnosis>& diagnosis) {
    std::vector<std::string> names;
    if (diagnosis) {
        std::ranges::transform(diagnosis->causes, std::back_inserter(names), &Cause::name);
    }
    return names;
}

/// Counts the trials of all mistakes in one contact. `drawn`: the number of cases before, each of
/// which has its own noise.
void count_in(const TestedContact& tested, std::uint64_t seed, std::uint64_t& drawn,
              test::MistakeCounts& counts) {
    const bool shear = tested.keys.contains("shear.Q");
    SuspectContacts suspects(test::scene_of(tested.keys));
    const ExactContact exact(suspects.scene());
    for (const InjectedMistake& mistake : injected_mistakes()) {
        if (mistake.of_shear != shear) {
            continue;
        }
        const auto program = mistake.make(tested.keys);
        const auto rows = program ? computed(*program, shear) : std::nullopt;
        if (!rows) {
            continue;
        }
        Tolerances strict;
        strict.pressure = no_effect;
        const auto compared = [&](double noise) {
            ++drawn;
            return compare_file(
                parse_result(table_of(*rows, program->digits, noise, seed + (drawn << 32U)),
                             "simulated.csv"),
                exact, strict, Rational(0), &suspects);
        };
        const Moved effect = moved(compared(0), shear, exact);
        if (!mistake.name.empty() && effect.by < no_effect) {
            continue; // no mistake in this contact
        }
        for (std::size_t level = 0; level < test::noise_levels.size(); ++level) {
            const double noise = test::noise_levels[level];
            const FileComparison file = compared(noise);
            test::MistakeTrial trial{mistake.name, tested.name, level,
                                     names_in(shear ? file.shear_diagnosis : file.diagnosis)};
            trial.hidden = !mistake.name.empty() && effect.by < above_noise * noise * effect.noise;
            // With a mistake in q, p is right.
            trial.misled = shear && !names_in(file.diagnosis).empty();
            counts.count(trial);
        }
    }
}

} // namespace

test::MistakeCounts count_named(std::uint64_t seed, const std::vector<std::string>& contacts) {
    test::MistakeCounts result;
    std::uint64_t drawn = 0;
    for (const TestedContact& contact : tested_contacts()) {
        if (contacts.empty() || std::ranges::find(contacts, contact.name) != contacts.end()) {
            count_in(contact, seed, drawn, result);
            ++result.contacts;
        }
    }
    return result;
}

} // namespace edgeproof::comparison

TEST_CASE("named causes: mistakes are named under noise, and none wrongly") {
    const auto counts = count_named(5, {"two cylinders, full stick"});
    counts.check(95);
    CHECK(counts.of.at("sign-of-tension")[2].named == 1);
    const auto pressures =
        count_named(5, {"two cylinders, unlike materials", "a wedge under P and M"});
    pressures.check(95);
    for (const auto& right : pressures.of.at("")) {
        CHECK(right.named == 10); // right data, and four waves, at any noise
    }
    // If a moment tilts a wedge, its angle is that of the punch.
    CHECK(pressures.of.at("tangent-of-angle")[0].named == 1);
    const auto axisymmetric = count_named(5, {"two spheres", "a cone, delta given"});
    axisymmetric.check(95);
    CHECK(axisymmetric.of.at("plane-for-axisymmetric")[0].named > 0);
    count_named(5, {"a sphere, partial slip"}).check(95);
    // The apex of a wedge is a corner, where the noise of one node has the effect of a small shift.
    count_named(424243, {"a wedge under P and M"}).check(95);
}

TEST_CASE("named causes: all contacts; docs/compare.md has the counts" *
          doctest::test_suite("slow")) {
    const auto counts = count_named(1);
    counts.check(95);
    const test::MistakeCount sum = counts.total();
    std::ifstream file(test::source_dir() / "docs" / "compare.md");
    std::ostringstream page;
    page << file.rdbuf();
    const std::string line =
        fmt::format("{} of {} cases named ({} of them alone), {} hidden by the noise, {} wrongly "
                    "named, in {} contacts",
                    sum.named, sum.cases, sum.alone, sum.hidden, sum.wrong, counts.contacts);
    CHECK_MESSAGE(page.str().find("\n    " + line + "\n") != std::string::npos, line);
}

TEST_CASE("the allowance for a mesh by a corner is that of boundary elements with rigid springs") {
    constexpr double elements = 200; // in the contact
    double greatest = 0;
    int count = 0;
    for (const TestedContact& tested : tested_contacts()) {
        const Scene scene = test::scene_of(tested.keys);
        const ExactContact exact(scene);
        if (!exact.scale().mean || exact.axisymmetric()) {
            continue;
        }
        ++count;
        const SpringBed rigid(scene, exact, 0);
        double products = 0;
        double squares = 0;
        for (int i = 0; i < 400; ++i) {
            const double x = -exact.b().value + exact.length() * (i + 0.37) / 400;
            const auto at = exact.at(x);
            const double zone = 2 * exact.length() / 100; // two elements of 100 in the contact
            const bool near_corner = std::ranges::any_of(exact.knots(), [&](const auto& knot) {
                return knot.corner && std::abs(x - knot.x) < zone;
            });
            const auto p = exact.p(at);
            if (p && at.u() > zone && !near_corner) {
                products += rigid.pressure(x) * *p;
                squares += *p * *p;
            }
        }
        CAPTURE(tested.name);
        CAPTURE(elements * std::abs(products / squares - 1));
        greatest = std::max(greatest, elements * std::abs(products / squares - 1));
    }
    CHECK(count >= 2);
    CHECK(greatest <= mesh_error_by_corner_times_elements);
    CHECK(greatest > 0.75 * mesh_error_by_corner_times_elements); // and not much more
}
