// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/scene_command.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace edgeproof::cli {
namespace {

constexpr double most_digits_of_a_check = 10'000;
constexpr double most_ulps = 1e300;

double positive(const std::string& option, const std::string& text, double most) {
    double value = 0;
    try {
        value = parse_decimal(text).convert_to<double>();
    } catch (const InputError& error) {
        throw InputError(option + " " + text + ": " + error.problem(), "give a number > 0");
    }
    if (!(value > 0 && value <= most)) {
        throw InputError(option + " " + text + " is out of range", "give a number > 0, such as 10");
    }
    return value;
}

conformance::Target target_of(const Options& o) {
    conformance::Target target;
    if (!o["--digits"].empty()) {
        target.digits = positive("--digits", o["--digits"], most_digits_of_a_check);
    }
    if (!o["--ulps"].empty()) {
        target.ulps = positive("--ulps", o["--ulps"], most_ulps);
    }
    target.conditioned = o.has("--conditioned");
    return target;
}

void refuse_recipe(const Options& o) {
    if (o["--exec"].empty() && std::filesystem::path(o["answers"]).extension() == ".toml") {
        throw InputError(
            "this is a TOML file, not answers (CSV)",
            "add --exec 'COMMAND' to ask a program the questions of a recipe, or give a "
            "ledger with --ledger")
            .at(o["answers"], 0);
    }
}

void refuse_if_none(bool none, const Options& o, const std::string& what) {
    require(!none || o["--only"] == "*",
            "--only " + o["--only"] + ": no id of " + what + " matches",
            "write the begin of ids and a star, such as 'hertz:*'");
}

/// Reads the answers whose ids match --only. A note of the number of questions is then left out.
io::Csv read_answers(const Options& o) {
    io::Csv csv = io::parse_csv(io::read_text(o["answers"], "file of answers (CSV)"),
                                io::input_name(o["answers"]), {.keep_faults = true});
    const auto id = csv.column("id");
    if (o["--only"] != "*" && id) {
        std::erase_if(csv.rows, [&](const io::Csv::Row& row) {
            return row.cells.size() > *id && !audit::matches(o["--only"], row.cells[*id]);
        });
        refuse_if_none(csv.rows.empty(), o, "an answer");
        csv.notes.clear();
        csv.note_lines.clear();
    }
    return csv;
}

/// Reads the questions of a recipe whose ids match --only, rounded to binary64.
conformance::Questions questions_of(const conformance::Recipe& recipe, const Options& o) {
    conformance::Questions asked = rounded_to_binary64(recipe.questions);
    std::erase_if(asked.list, [&](const conformance::Question& q) {
        return !audit::matches(o["--only"], q.id);
    });
    refuse_if_none(asked.list.empty(), o, "a question");
    // A program that knows one profile is not shown the parameters of others.
    std::map<std::size_t, std::size_t> used;
    std::vector<conformance::AskedContact> contacts;
    for (conformance::Question& q : asked.list) {
        const auto [found, is_new] = used.emplace(q.contact, contacts.size());
        if (is_new) {
            contacts.push_back(asked.contacts[q.contact]);
        }
        q.contact = found->second;
    }
    asked.contacts = std::move(contacts);
    return asked;
}

/// Runs a program. Its answers are never bad input, only wrong.
conformance::Answers ask_program(const Options& o) {
    require(o["--recipe"].empty(), "--recipe is given with --exec",
            "give the recipe alone, as the first");
    conformance::ProgramDriverOptions options;
    options.command = o["--exec"];
    options.seconds = positive("--timeout", o["--timeout"], 1e9);
    options.batch = whole_number("--batch", o["--batch"], 1, 1'000'000);
    options.runs = whole_number("--runs", o["--runs"], 1, 1'000'000);
    ProgramMessages messages;
    options.said = std::ref(messages);
    const conformance::Recipe recipe = conformance::read_recipe(o["answers"]);
    const conformance::Questions asked = questions_of(recipe, o);
    options.write_csv = [&](const conformance::Questions& part) {
        return write_table(report::question_table(part, recipe.title), report::TableFormat::csv,
                           {.notes = false});
    };
    return with_progress("answers", options.progress,
                         [&] { return ask_program_in_batches(asked, options); });
}

conformance::Answers answers_of(const Options& o) {
    if (!o["--exec"].empty()) {
        return ask_program(o);
    }
    return o["--recipe"].empty()
               ? conformance::echoed_answers(read_answers(o))
               : conformance::answers_to(questions_of(conformance::read_recipe(o["--recipe"]), o),
                                         read_answers(o));
}

} // namespace

int check(Options& o) {
    o["--ledger"] = file_or_shipped(o["--ledger"], shipped_ledgers);
    o["--recipe"] = file_or_shipped(o["--recipe"], shipped_recipes);
    o["answers"] = file_or_shipped(o["answers"], shipped_recipes);
    const bool json = text_or_json(o["--format"]) || o.has("--json");
    require(!json || o["--ledger"].empty(), "--json is for answers", "leave --json out");
    require(o["--only"] == "*" || o["--ledger"].empty(), "--only is for answers",
            "leave --only out");
    require(o["--out"].empty() || o["--ledger"].empty(), "--out is for answers", "leave --out out");
    if (!o["--ledger"].empty()) {
        return check_ledger(o["--ledger"], threads_of(o["--threads"]));
    }
    require(!o["answers"].empty(), "there is nothing to check",
            "give ANSWERS.csv, or RECIPE.toml with --exec, or --ledger FORMULAS.toml");
    io::check_output(o["--junit"]);
    io::check_output(o["--out"]);
    report::Conformance result;
    result.target = target_of(o);
    const std::size_t errors = whole_number("--errors", o["--errors"], 0, 1'000'000'000);
    conformance::ReferenceOptions options;
    options.threads = threads_of(o["--threads"]);
    refuse_recipe(o);
    result.answers = answers_of(o);
    with_progress("references", options.progress, [&] {
        result.agreements = compare(result.answers, result.target, options);
        result.conventions = infer_conventions(result.answers, result.agreements, options);
    });
    if (!o["--junit"].empty()) {
        io::write_output(o["--junit"], conformance_junit(result));
    }
    io::write_output(o["--out"].empty() ? "-" : o["--out"],
                     json ? conformance_json(result)
                          : printable_lines(conformance_text(result, errors)));
    return result.pass() ? 0 : 1;
}

} // namespace edgeproof::cli
