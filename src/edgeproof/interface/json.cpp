// SPDX-License-Identifier: BSD-3-Clause
// The checks of edgeproof.hpp: formulas, programs, meshes, and the commands as JSON.
#include "edgeproof/interface/enclosed_value.hpp"
#include "edgeproof/report/report.hpp"

#include <array>
#include <filesystem>
#include <fmt/format.h>

namespace edgeproof {
namespace {

constexpr long least_digits_of_claims = 10;
constexpr long most_digits_of_claims = 10'000;
constexpr long most_threads = 1024;
constexpr std::size_t most_errors_shown = 20;

Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

audit::AuditResult judged(const std::string& file, const audit::AuditOptions& options) {
    require_digits(options.digits, least_digits_of_claims, most_digits_of_claims);
    const audit::Ledger ledger = audit::read_ledger(file);
    audit::AuditResult result = run_audit(ledger, options);
    certificate::attach_certificates(
        result, ledger, std::filesystem::path(file).parent_path() / "certificates", "certificates");
    return result;
}

/// JSON has no infinity.
std::string number(double x) { return fmt::format("{}", x); }

Json case_of(const report::Conformance& c, std::size_t i) {
    const conformance::Question& question = c.answers.questions.list[i];
    const conformance::Answer& answer = c.answers.given[i];
    const conformance::CaseAgreement& held = c.agreements.cases[i];
    static constexpr std::array states{"number", "missing", "nan", "infinite", "garbage", "died"};
    static_assert(states.size() == static_cast<std::size_t>(conformance::Answer::State::died) + 1);
    return {{"id", question.id},
            {"quantity", scene::symbol_of(question)},
            {"regime", regime_name(held.regime)},
            {"value", answer.text},
            {"state", states.at(static_cast<std::size_t>(answer.state))},
            {"reference", text_or_null(held.reference)},
            {"digits", number(held.digits)},
            {"ulps", number(held.ulps)},
            {"relative", number(held.relative)},
            {"passed", !c.failed(i)},
            {"explained", held.explained},
            {"no_reference", text_or_null(held.no_reference)}};
}

} // namespace

std::vector<Verdict> verify(const std::string& ledger, unsigned digits) {
    audit::AuditOptions options;
    options.digits = digits;
    std::vector<Verdict> verdicts;
    for (const audit::ClaimResult& of : judged(ledger, options).claims) {
        verdicts.push_back({of.claim.id, std::string(audit::name_of(of.outcome.verdict)),
                            of.outcome.correct.value_or(""), of.outcome.note});
    }
    return verdicts;
}

Outcome check(const std::string& recipe, const std::string& answers, double digits) {
    require(digits > 0, "the digits of a check are not positive", "give a number > 0");
    const report::Conformance found =
        report::checked_answers({{"answers", io::read_text(answers, "file of answers (CSV)")},
                                 {"name", answers},
                                 {"recipe", recipe},
                                 {"digits", std::to_string(digits)}},
                                {});
    return {found.pass(), conformance_text(found, most_errors_shown), conformance_json(found)};
}

Outcome compare(const Scene& scene, const std::vector<std::string>& results,
                const std::string& tolerance) {
    std::vector<std::pair<std::string, std::string>> texts;
    for (const std::string& file : results) {
        texts.emplace_back(json::read_text(file, "result (a table of x and p)"), file);
    }
    return json::compare({}, scene, scene_of(scene).file, texts, {{"tolerance", tolerance}});
}

namespace json {

std::string read_text(const std::string& file, const std::string& what) {
    return io::read_text(file, what);
}

std::string verify(const Progress& progress, const std::string& ledger, long digits,
                   const std::string& only, long threads) {
    require_digits(digits, least_digits_of_claims, most_digits_of_claims);
    require(threads >= 0 && threads <= most_threads,
            fmt::format("threads = {} is out of range", threads),
            fmt::format("give a number from 0 (as many as the machine has) to {}", most_threads));
    audit::AuditOptions options;
    options.digits = static_cast<unsigned>(digits);
    options.threads = static_cast<int>(threads);
    options.only = only;
    options.progress = progress;
    const audit::AuditResult result = judged(ledger, options);
    Json all = Json::parse(report::verdicts_json(result));
    all["source"] = result.source;
    all["counts"] = report::counts_line(result);
    all["differences"] =
        report::has_golden_file(ledger)
            ? Json(report::golden_differences(result, report::golden_file(ledger), only))
            : Json(nullptr);
    return json_text(all);
}

std::string questions(const std::string& recipe) {
    const conformance::Recipe asked = conformance::read_recipe(recipe);
    const report::Table table =
        report::question_table(rounded_to_binary64(asked.questions), asked.title);
    Json list = Json::array();
    for (const auto& row : table.rows) {
        Json question = Json::object();
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (!row[i].empty()) {
                question[table.columns.at(i).name] = row[i];
            }
        }
        list.push_back(std::move(question));
    }
    return json_text(list);
}

std::string check(const Progress& progress, const Options& options) {
    const report::Conformance c = report::checked_answers(options, {progress, progress, {}});
    Json cases = Json::array();
    for (std::size_t i = 0; i < c.agreements.cases.size(); ++i) {
        cases.push_back(case_of(c, i));
    }
    Json conventions = Json::array();
    for (const conformance::Convention& k : c.conventions) {
        conventions.push_back({{"of", k.of},
                               {"relation", k.relation},
                               {"digits", number(k.digits)},
                               {"rows", k.rows},
                               {"failing", k.failing},
                               {"hint", k.hint},
                               {"also", k.also}});
    }
    return json_text({{"passed", c.pass()},
                      {"text", conformance_text(c, most_errors_shown)},
                      {"faults", c.answers.faults},
                      {"cases", cases},
                      {"conventions", conventions},
                      {"estimates", c.agreements.estimates}});
}

Outcome compare(const Progress& progress, const Scene& scene, const std::string& name,
                const std::vector<std::pair<std::string, std::string>>& results,
                const Options& options) {
    const report::ComparedResults found = report::compare_results(
        progress ? progress : [](std::size_t /*done*/, std::size_t /*all*/) {}, scene_of(scene),
        name, results, options);
    return {found.passes, found.text, found.json};
}

std::string design(const Progress& progress, const std::string& text, const std::string& file,
                   const Options& options) {
    contact::DesignOptions search;
    io::TomlTable asked{"design", 0, {}};
    long digits = search.digits;
    for (const auto& [key, value] : options) {
        if (key == "digits") {
            digits = std::stol(value);
        } else if (key == "gap") {
            search.gap = parse_decimal(value);
            require(search.gap > 0, "gap = " + value + " is not positive", "give gap=\"1e-6\"");
        } else {
            asked.entries.push_back({key, value});
        }
    }
    require_digits(digits, 2, scene::most_design_digits);
    search.digits = static_cast<unsigned>(digits);
    search.progress = progress;
    const scene::DesignScene design = scene::parse_design(
        text, file, asked.entries.empty() ? std::vector<io::TomlTable>{} : std::vector{asked});
    const scene::DesignResult result = run_design(design, search);
    const contact::BestReach& best = result.best;
    const bool proved = result.proved();
    const auto state = [&](const std::optional<Ball>& x) {
        return x ? Json(value_of({*x, proved, proved ? "branch-and-bound" : "samples", {}},
                                 search.digits)
                            .state())
                 : Json(nullptr);
    };
    const auto by_name = [&](bool has, const auto& number) {
        return has ? Json{{design.parameter, number()}} : Json::object();
    };
    const auto given = [&](const std::optional<Rational>& q) {
        return by_name(q.has_value(), [&] {
            return value_of({Ball(*q, 4 * digits + 64), true, "given", q}, search.digits).state();
        });
    };
    Json all = Json::parse(
        write_table(report::design_table(design, result, search), report::TableFormat::json));
    return json_text(
        {{"table", std::move(all)},
         {"values", by_name(true, [&] { return state(best.value); })},
         {"reach", state(best.reach)},
         {"proved", proved},
         {"missing", result.missing},
         {"attained", best.attained},
         {"touches_at", state(best.touches_at)},
         {"reach_shown_at", given(proved ? std::optional<Rational>(*best.shown_at) : std::nullopt)},
         {"printed", given(design.printed)},
         {"reach_at_printed", state(result.printed_reach)},
         {"falls_short_by", state(result.falls_short)}});
}

std::string relations(const std::vector<std::string>& quantities, long degree, bool symmetric,
                      const std::vector<std::pair<std::string, std::string>>& given,
                      const std::vector<std::string>& free) {
    const audit::RelationQuestion question{quantities, degree, symmetric, given, free};
    return write_table(report::relations_table(question, asked_relations(question)),
                       report::TableFormat::json);
}

} // namespace json

} // namespace edgeproof
