// SPDX-License-Identifier: GPL-3.0-or-later
// The functions of edgeproof.hpp: texts become the types of the library, and back.
#include "edgeproof/audit/run.hpp"
#include "edgeproof/comparison/comparison.hpp"
#include "edgeproof/conformance/answers/answers.hpp"
#include "edgeproof/conformance/questions/question.hpp"
#include "edgeproof/edgeproof.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/report/tables/agreement_report.hpp"
#include "edgeproof/report/tables/comparison_report.hpp"
#include "edgeproof/scene/binary64_values.hpp"
#include "edgeproof/scene/input/readers.hpp"
#include "edgeproof/scene/input/scene_words.hpp"
#include "edgeproof/scene/run_scene.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <sstream>

namespace edgeproof {
namespace {

constexpr unsigned least_digits = 2;
constexpr unsigned least_digits_of_claims = 10;
constexpr unsigned most_digits = 10'000;
constexpr std::size_t most_errors_shown = 20;

void require_digits(unsigned digits, unsigned least) {
    require(digits >= least && digits <= most_digits,
            "digits = " + std::to_string(digits) + " is out of range",
            "give a number from " + std::to_string(least) + " to " + std::to_string(most_digits));
}

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> words;
    for (std::string word; in >> word;) {
        words.push_back(word);
    }
    return words;
}

scene::AskedValue asked_of(const Query& query, const scene::Place::Names& names) {
    static constexpr std::string_view keys[] = {"u",    "x",         "edge",     "at",
                                                "body", "tolerance", "reference"};
    std::map<std::string, std::string> where;
    for (const std::string& word : words_of(query.where)) {
        const std::size_t equals = std::min(word.find('='), word.size());
        const std::string key = word.substr(0, equals);
        require(equals < word.size() && std::ranges::find(keys, key) != std::end(keys),
                "'" + word + "' is no place of " + query.quantity,
                "write u=, x=, edge=, at=X,Z, body=, tolerance= or reference=");
        where[key] = word.substr(equals + 1);
    }
    return scene::asked_value(query.quantity, where, names);
}

scene::BoundedValue value_of(scene::SceneValues& solved, const scene::AskedValue& asked,
                             unsigned digits) {
    if (scene::row_of(asked.quantity).searched && asked.quantity != scene::Quantity::extent) {
        const scene::Row& found = solved.searched(asked);
        if (!found.value || !found.reached) {
            throw DomainError("there is no " + text_of(asked) +
                              ": the terms stay within the "
                              "tolerance");
        }
        return *found.value;
    }
    if (const auto outside = value_outside(asked.quantity, formula::bits_for(digits))) {
        try {
            scene::AskedValue place = asked;
            place.quantity = scene::Quantity::x;
            (void)solved.value(place);
        } catch (const scene::OutsideContact&) {
            return *outside;
        }
    }
    return solved.value(asked);
}

} // namespace

struct Scene::Solved {
    scene::Scene scene;

    [[nodiscard]] std::vector<Value> values(const std::vector<Query>& queries,
                                            unsigned digits) const {
        require_digits(digits, least_digits);
        const scene::Place::Names names = scene::exact_names_of(scene);
        std::vector<scene::AskedValue> asked;
        std::vector<scene::AskedValue> together; // a solved scene has one tolerance, one reference
        for (const Query& query : queries) {
            asked.push_back(asked_of(query, names));
            if (!asked.back().tolerance && !asked.back().reference) {
                together.push_back(asked.back());
            }
        }
        std::optional<scene::SceneValues> shared;
        if (!together.empty()) {
            shared.emplace(scene, together, scene::Digits{digits});
        }
        std::vector<Value> values;
        for (const scene::AskedValue& one : asked) {
            std::optional<scene::SceneValues> own;
            if (one.tolerance || one.reference) {
                own.emplace(scene, std::vector{one}, scene::Digits{digits});
            }
            const scene::BoundedValue value = value_of(own ? *own : *shared, one, digits);
            const scene::PrintedValue text =
                scene::printed(value, digits_of(one.quantity, scene::Digits{digits}));
            values.push_back({text.text, text.bound, value.proved, scene::how(value, text)});
        }
        return values;
    }
    void array(scene::Quantity quantity, std::span<const double> x, std::span<double> to) const {
        if (x.size() != to.size()) {
            throw Error("the places and the values differ in number");
        }
        const scene::Binary64Values at(scene, {quantity, 0, true});
        at(contact::Edge::right, x, to);
    }
};

Scene::Scene(const std::string& words) {
    const scene::GivenScene given =
        scene::given_scene(std::filesystem::exists(words) ? std::vector{words} : words_of(words));
    solved_ = std::make_shared<Solved>(Solved{given.file.empty()
                                                  ? scene::parse_scene("", "scene", given.instead)
                                                  : scene::read_scene(given.file, given.instead)});
}
Scene Scene::from_text(const std::string& text, const std::string& file) {
    return Scene(std::make_shared<Solved>(Solved{scene::parse_scene(text, file)}));
}
Value Scene::value(const std::string& quantity, const std::string& where, unsigned digits) const {
    return solved_->values({{quantity, where}}, digits).front();
}
std::vector<Value> Scene::values(const std::vector<Query>& queries, unsigned digits) const {
    return solved_->values(queries, digits);
}
void Scene::pressures(std::span<const double> x, std::span<double> p) const {
    solved_->array(scene::Quantity::p, x, p);
}
void Scene::shears(std::span<const double> x, std::span<double> q) const {
    solved_->array(scene::Quantity::q, x, q);
}
void Scene::stresses(std::span<const double> x, std::span<const double> z, const Stresses& at,
                     bool body_B) const {
    const std::span<double> mises = at.mises.empty() ? at.sxx : at.mises;
    for (const std::span<double> array : {at.sxx, at.szz, at.sxz, at.tau_max, mises, at.bound}) {
        if (x.size() != z.size() || array.size() != x.size()) {
            throw Error("the places and the values differ in number");
        }
    }
    compute_binary64(solved_->scene, body_B ? scene::Body::B : scene::Body::A, x, z,
                     {at.sxx, at.szz, at.sxz, at.tau_max, at.mises, at.bound});
}

std::vector<Verdict> verify(const std::string& ledger, unsigned digits) {
    require_digits(digits, least_digits_of_claims);
    audit::AuditOptions options;
    options.digits = digits;
    std::vector<Verdict> verdicts;
    for (const audit::ClaimResult& of : run_audit(audit::read_ledger(ledger), options).claims) {
        verdicts.push_back({of.claim.id, std::string(audit::name_of(of.outcome.verdict)),
                            of.outcome.correct.value_or(""), of.outcome.note});
    }
    return verdicts;
}

Outcome check(const std::string& recipe, const std::string& answers, double digits) {
    require(digits > 0, "the digits of a check are not positive", "give a number > 0");
    const conformance::Questions asked =
        rounded_to_binary64(conformance::read_recipe(recipe).questions);
    report::Conformance found;
    found.target.digits = digits;
    found.answers = conformance::answers_to(
        asked, io::parse_csv(io::read_text(answers, "file of answers (CSV)"), answers,
                             {.keep_faults = true}));
    found.agreements = compare(found.answers, found.target, {});
    found.conventions = infer_conventions(found.answers, found.agreements, {});
    return {found.pass(), conformance_text(found, most_errors_shown), conformance_json(found)};
}

Outcome compare(const Scene& scene, const std::vector<std::string>& results,
                const std::string& tolerance) {
    const scene::Scene& exactly = scene.solved_->scene;
    comparison::Tolerances tolerances;
    tolerances.pressure = scene::parse_tolerance(tolerance).to<double>();
    tolerances.stated = true;
    comparison::ResultReading reading;
    reading.units = exactly.units;
    std::vector<comparison::ResultTable> tables;
    for (const std::string& file : results) {
        tables.push_back(comparison::read_result(file, reading));
    }
    const comparison::ExactContact contact(exactly);
    const report::ComparisonReport report{
        exactly.file, exactly.title, exactly.units, &contact,
        compare_tables(std::move(tables), exactly, contact, tolerances, Rational(0),
                       [](std::size_t /*done*/, std::size_t /*total*/) {})};
    return {report.comparison.passes(), comparison_text(report), comparison_json(report)};
}

} // namespace edgeproof
