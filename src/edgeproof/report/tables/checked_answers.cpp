// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/run.hpp"
#include "edgeproof/conformance/answers/answers.hpp"
#include "edgeproof/conformance/questions/question.hpp"
#include "edgeproof/io/foreign_text.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/report/tables/agreement_report.hpp"
#include "edgeproof/report/tables/reference_table.hpp"

#include <optional>
#include <utility>

namespace edgeproof::report {
namespace {

/// The options of checked_answers.
struct Asked {
    const std::map<std::string, std::string, std::less<>>& options;

    [[nodiscard]] std::string text(std::string_view key, const char* otherwise = "") const {
        const auto found = options.find(key);
        return found == options.end() ? otherwise : found->second;
    }
    [[nodiscard]] std::optional<double> number(std::string_view key) const {
        const std::string given = text(key);
        return given.empty() ? std::nullopt : std::optional(std::stod(given));
    }
    [[nodiscard]] bool only_some() const { return text("only", "*") != "*"; }
    /// True if an id matches `only`.
    [[nodiscard]] bool has(const std::string& id) const {
        return audit::matches(text("only", "*"), id);
    }
    void refuse_if_none(bool none, const char* what) const {
        require(!none || !only_some(), "--only " + text("only") + ": no id of " + what + " matches",
                "write the begin of ids and a star, such as 'hertz:*'");
    }
};

/// Reads the answers whose ids match. A note of the number of questions is then left out.
io::Csv answers_in(const Asked& asked) {
    io::Csv csv = io::parse_csv(asked.text("answers"), asked.text("name"), {.keep_faults = true});
    const auto id = csv.column("id");
    if (asked.only_some() && id) {
        std::erase_if(csv.rows, [&](const io::Csv::Row& row) {
            return row.cells.size() > *id && !asked.has(row.cells[*id]);
        });
        asked.refuse_if_none(csv.rows.empty(), "an answer");
        csv.notes.clear();
        csv.note_lines.clear();
    }
    return csv;
}

/// Returns the questions of a recipe whose ids match, rounded to binary64.
conformance::Questions questions_of(const conformance::Recipe& recipe, const Asked& asked) {
    conformance::Questions some = rounded_to_binary64(recipe.questions);
    std::erase_if(some.list, [&](const conformance::Question& q) { return !asked.has(q.id); });
    asked.refuse_if_none(some.list.empty(), "a question");
    // A program that knows one profile is not shown the parameters of others.
    std::map<std::size_t, std::size_t> used;
    std::vector<conformance::AskedContact> contacts;
    for (conformance::Question& q : some.list) {
        const auto [found, is_new] = used.emplace(q.contact, contacts.size());
        if (is_new) {
            contacts.push_back(some.contacts[q.contact]);
        }
        q.contact = found->second;
    }
    some.contacts = std::move(contacts);
    return some;
}

/// The answers of a program are never bad input, only wrong.
conformance::Answers answers_of(const Asked& asked, const CheckCalls& calls) {
    const std::string file = asked.text("recipe");
    conformance::ProgramDriverOptions driver;
    driver.command = asked.text("command");
    if (driver.command.empty()) {
        const io::Csv csv = answers_in(asked);
        return file.empty() ? conformance::echoed_answers(csv)
                            : conformance::answers_to(
                                  questions_of(conformance::read_recipe(file), asked), csv);
    }
    const conformance::Recipe recipe = conformance::read_recipe(file);
    const conformance::Questions questions = questions_of(recipe, asked);
    driver.seconds = asked.number("seconds").value_or(driver.seconds);
    driver.batch =
        static_cast<std::size_t>(asked.number("batch").value_or(static_cast<double>(driver.batch)));
    driver.runs =
        static_cast<std::size_t>(asked.number("runs").value_or(static_cast<double>(driver.runs)));
    driver.progress = calls.answers;
    driver.said = calls.said;
    driver.write_csv = [&](const conformance::Questions& part) {
        return write_table(question_table(part, recipe.title), TableFormat::csv, {.notes = false});
    };
    return ask_program_in_batches(questions, driver);
}

} // namespace

Conformance checked_answers(const std::map<std::string, std::string, std::less<>>& options,
                            const CheckCalls& calls) {
    const Asked asked{options};
    Conformance found;
    found.target = {asked.number("digits"), asked.number("ulps"),
                    !asked.text("conditioned").empty()};
    conformance::ReferenceOptions reference;
    reference.threads = static_cast<unsigned>(asked.number("threads").value_or(0));
    reference.progress = calls.references;
    found.answers = answers_of(asked, calls);
    found.agreements = compare(found.answers, found.target, reference);
    found.conventions = infer_conventions(found.answers, found.agreements, reference);
    return found;
}

} // namespace edgeproof::report
