// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/commands/check/check_kinds.hpp"
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/conformance/causes/self_test.hpp"
#include "edgeproof/conformance/questions/recipe.hpp"
#include "edgeproof/precision/rational.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/report/tables/agreement_report.hpp"
#include "edgeproof/report/tables/reference_table.hpp"
#include "edgeproof/report/text/program_line.hpp"

#include <cstdio>
#include <functional>
#include <map>

namespace edgeproof::cli {
namespace {

/// Returns the doubles nearest to the references: the answers of a program without errors.
io::Csv right_answers(const conformance::Questions& asked, const std::string& title,
                      const conformance::ReferenceOptions& options) {
    io::Csv csv = io::parse_csv(
        write_table(report::question_table(asked, title), report::TableFormat::csv), "answers");
    const auto values = references(asked, options);
    csv.header.cells.emplace_back("value");
    for (std::size_t i = 0; i < values.size(); ++i) {
        const scene::PrintedValue value = printed(values[i].value, options.digits);
        csv.rows[i].cells.push_back(value.binary64 ? exact_text(exact_rational(*value.binary64))
                                                   : "0");
    }
    return csv;
}

/// Returns the complaint about the answers; empty if they pass.
std::string complaint(const conformance::Questions& asked, const std::string& text,
                      const conformance::ReferenceOptions& options) {
    report::Conformance result;
    result.target.ulps = 0.5;
    try {
        result.answers = answers_to(asked, io::parse_csv(text, "answers", {.keep_faults = true}));
        result.agreements = compare(result.answers, result.target, options);
    } catch (const InputError& error) { // refused answers count as found
        return error.what();
    }
    return result.pass() ? "" : conformance_text(result, 3);
}

} // namespace

int self_test(const std::string& recipe_file, const std::string& seed_text,
              const std::string& files_text, const std::string& threads) {
    const std::size_t seed = whole_number("--seed", seed_text, 0, 1'000'000'000);
    const std::size_t files = whole_number("--files", files_text, 1, 100'000);
    const conformance::Recipe recipe = conformance::read_recipe(recipe_file);
    const conformance::Questions asked = rounded_to_binary64(recipe.questions);
    conformance::ReferenceOptions options;
    options.digits.binary64 = true;
    options.threads = threads_of(threads);
    const io::Csv right = right_answers(asked, recipe.title, options);
    const std::string said = complaint(asked, conformance::csv_text(right), options);

    struct Tally {
        std::size_t files = 0;
        std::size_t found = 0;
    };
    std::map<std::string, Tally> tallies;
    std::string missed;
    std::size_t found = 0;
    {
        Progress progress("files");
        std::size_t done = 0;
        for (const conformance::Corruption& corrupted :
             conformance::corruptions(right, seed, files)) {
            Tally& t = tallies[corrupted.kind];
            ++t.files;
            if (!complaint(asked, corrupted.text, options).empty()) {
                ++t.found;
                ++found;
            } else {
                missed += "missed: " + corrupted.kind + ": " + corrupted.what + "\n";
            }
            progress(++done, files);
        }
    }
    std::printf("%-44s%8s%8s\n", "corrupted by", "files", "found");
    for (const auto& [kind, t] : tallies) {
        std::printf("%-44s%8zu%8zu\n", kind.c_str(), t.files, t.found);
    }
    std::printf("%s\n", report::program_line().c_str());
    std::printf("%s%s", missed.c_str(), said.c_str());
    std::printf("the right answers %s; %zu of %zu corrupted files found (seed %zu, %zu answers a "
                "file, target 0.5 ulps)\n",
                said.empty() ? "pass" : "FAIL", found, files, seed, asked.list.size());
    return said.empty() && found == files ? 0 : 1;
}

int self_test_of_causes(const std::string& seed_text, const std::string& threads) {
    const std::size_t seed = whole_number("--seed", seed_text, 0, 1'000'000'000);
    std::function<void(std::size_t, std::size_t)> progress;
    const scene::MistakeCounts counts = with_progress("contacts", progress, [&] {
        return conformance::test_causes(seed, threads_of(threads), {}, progress);
    });
    const std::string text = counts.text();
    std::fwrite(text.data(), 1, text.size(), stdout);
    return counts.passes(conformance::least_percent_named) ? 0 : 1;
}

} // namespace edgeproof::cli
