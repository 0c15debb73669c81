// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/commands/check/check_kinds.hpp"
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/conformance/causes/convention.hpp"
#include "edgeproof/io/csv.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

namespace edgeproof::cli {
namespace {

constexpr const char* what_answers_are = "file of answers (CSV)";

/// Reads the file once. `twice`: the lines among which an id occurs twice; if it is empty, those
/// found are stored in it. Returns no value if one block holds all answers.
std::optional<report::ConformanceSummary> one_reading(const std::filesystem::path& file,
                                                      const conformance::Target& target,
                                                      std::size_t errors,
                                                      conformance::ReferenceOptions options,
                                                      std::set<std::size_t>& twice) {
    std::error_code unknown;
    const auto size = static_cast<std::size_t>(std::filesystem::file_size(file, unknown));
    io::CsvReader rows(file, what_answers_are);
    conformance::AnswerReader reader(
        rows.head(), [&](io::Csv::Row& row) { return rows.next(row); }, twice);
    report::ConformanceSummary summary(target, errors);
    conformance::FailingRows failing;
    conformance::Questions without_reference; // of the first block, until an answer has one
    bool any_reference = false;
    Progress progress("bytes of answers");
    conformance::Answers block;
    // One more than the number of answers whose conditioning is always found.
    for (bool first = true; reader.next(block, conformance::most_conditioned + 1); first = false) {
        check_interruption();
        if (first && reader.ended()) {
            return {};
        }
        const auto agreements = compare_block(block, target, options);
        for (const conformance::CaseAgreement& held : agreements.cases) {
            any_reference = any_reference || held.no_reference.empty();
        }
        if (first && !any_reference) {
            without_reference = block.questions;
        }
        summary.add(block, agreements);
        failing.add(block, agreements);
        progress(rows.bytes(), std::max(size, rows.bytes()));
    }
    if (!any_reference) {
        options.digits.count = reference_digits(target);
        (void)references(without_reference, options); // throws the first error
    }
    if (twice.empty()) {
        twice = reader.maybe_twice();
    }
    const auto conventions = failing.conventions(options);
    summary.add(conventions, failing.unexplained_by(conventions));
    if (failing.cut()) {
        summary.note(fmt::format("conventions are looked for in the first {} of {} rows that fail",
                                 failing.kept(), failing.seen()));
    }
    return summary;
}

} // namespace

std::optional<report::ConformanceSummary>
check_in_blocks(const std::filesystem::path& file, const conformance::Target& target,
                std::size_t errors, const conformance::ReferenceOptions& options) {
    std::error_code unknown;
    if (file == "-" || !std::filesystem::is_regular_file(file, unknown)) {
        return {}; // it can be read only once
    }
    std::set<std::size_t> twice;
    auto summary = one_reading(file, target, errors, options, twice);
    return summary && !twice.empty() ? one_reading(file, target, errors, options, twice)
                                     : std::move(summary);
}

} // namespace edgeproof::cli
