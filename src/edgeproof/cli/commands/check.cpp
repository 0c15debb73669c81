// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/run.hpp"
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/conformance/answers/answers.hpp"
#include "edgeproof/conformance/questions/question.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/report/tables/agreement_report.hpp"
#include "edgeproof/report/tables/reference_table.hpp"

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

struct CheckOptions {
    std::string answers;
    std::string recipe;
    std::string command;
    std::string ledger;
    std::string only = "*";
    std::string batch = "500";
    std::string runs = "200";
    std::string timeout = "600";
    std::string digits;
    std::string ulps;
    std::string errors = "5";
    std::string junit;
    std::string threads;
    bool conditioned = false;
    bool json = false;
    std::string format;
    std::string out;
};

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

conformance::Target target_of(const CheckOptions& o) {
    conformance::Target target;
    if (!o.digits.empty()) {
        target.digits = positive("--digits", o.digits, most_digits_of_a_check);
    }
    if (!o.ulps.empty()) {
        target.ulps = positive("--ulps", o.ulps, most_ulps);
    }
    target.conditioned = o.conditioned;
    return target;
}

void refuse_recipe(const CheckOptions& o) {
    if (o.command.empty() && std::filesystem::path(o.answers).extension() == ".toml") {
        throw InputError(
            "this is a TOML file, not answers (CSV)",
            "add --exec 'COMMAND' to ask a program the questions of a recipe, or give a "
            "ledger with --ledger")
            .at(o.answers, 0);
    }
}

void refuse_if_none(bool none, const CheckOptions& o, const std::string& what) {
    require(!none || o.only == "*", "--only " + o.only + ": no id of " + what + " matches",
            "write the begin of ids and a star, such as 'hertz:*'");
}

/// Reads the answers whose ids match --only. A note of the number of questions is then left out.
io::Csv read_answers(const CheckOptions& o) {
    io::Csv csv = io::parse_csv(io::read_text(o.answers, "file of answers (CSV)"),
                                io::input_name(o.answers), {.keep_faults = true});
    const auto id = csv.column("id");
    if (o.only != "*" && id) {
        std::erase_if(csv.rows, [&](const io::Csv::Row& row) {
            return row.cells.size() > *id && !audit::matches(o.only, row.cells[*id]);
        });
        refuse_if_none(csv.rows.empty(), o, "an answer");
        csv.notes.clear();
        csv.note_lines.clear();
    }
    return csv;
}

/// Reads the questions of a recipe whose ids match --only, rounded to binary64.
conformance::Questions questions_of(const conformance::Recipe& recipe, const CheckOptions& o) {
    conformance::Questions asked = rounded_to_binary64(recipe.questions);
    std::erase_if(asked.list,
                  [&](const conformance::Question& q) { return !audit::matches(o.only, q.id); });
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
conformance::Answers ask_program(const CheckOptions& o) {
    require(o.recipe.empty(), "--recipe is given with --exec",
            "give the recipe alone, as the first");
    conformance::ProgramDriverOptions options;
    options.command = o.command;
    options.seconds = positive("--timeout", o.timeout, 1e9);
    options.batch = whole_number("--batch", o.batch, 1, 1'000'000);
    options.runs = whole_number("--runs", o.runs, 1, 1'000'000);
    ProgramMessages messages;
    options.said = std::ref(messages);
    const conformance::Recipe recipe = conformance::read_recipe(o.answers);
    const conformance::Questions asked = questions_of(recipe, o);
    options.write_csv = [&](const conformance::Questions& part) {
        return write_table(report::question_table(part, recipe.title), report::TableFormat::csv,
                           {.notes = false});
    };
    return with_progress("answers", options.progress,
                         [&] { return ask_program_in_batches(asked, options); });
}

conformance::Answers answers_of(const CheckOptions& o) {
    if (!o.command.empty()) {
        return ask_program(o);
    }
    return o.recipe.empty()
               ? conformance::echoed_answers(read_answers(o))
               : conformance::answers_to(questions_of(conformance::read_recipe(o.recipe), o),
                                         read_answers(o));
}

int check(CheckOptions& o) {
    o.ledger = file_or_shipped(o.ledger, shipped_ledgers);
    o.recipe = file_or_shipped(o.recipe, shipped_recipes);
    o.answers = file_or_shipped(o.answers, shipped_recipes);
    o.json = text_or_json(o.format) || o.json;
    require(!o.json || o.ledger.empty(), "--json is for answers", "leave --json out");
    require(o.only == "*" || o.ledger.empty(), "--only is for answers", "leave --only out");
    require(o.out.empty() || o.ledger.empty(), "--out is for answers", "leave --out out");
    if (!o.ledger.empty()) {
        return check_ledger(o.ledger, threads_of(o.threads));
    }
    require(!o.answers.empty(), "there is nothing to check",
            "give ANSWERS.csv, or RECIPE.toml with --exec, or --ledger FORMULAS.toml");
    io::check_output(o.junit);
    io::check_output(o.out);
    report::Conformance result;
    result.target = target_of(o);
    const std::size_t errors = whole_number("--errors", o.errors, 0, 1'000'000'000);
    conformance::ReferenceOptions options;
    options.threads = threads_of(o.threads);
    refuse_recipe(o);
    result.answers = answers_of(o);
    with_progress("references", options.progress, [&] {
        result.agreements = compare(result.answers, result.target, options);
        result.conventions = infer_conventions(result.answers, result.agreements, options);
    });
    if (!o.junit.empty()) {
        io::write_output(o.junit, conformance_junit(result));
    }
    io::write_output(o.out.empty() ? "-" : o.out,
                     o.json ? conformance_json(result)
                            : printable_lines(conformance_text(result, errors)));
    return result.pass() ? 0 : 1;
}

} // namespace

void add_check(CLI::App& app, int& code) {
    auto [sub, o] = add_command<CheckOptions>(
        app, code, "check", "compare another program's answers with reference values", check);
    sub.add_option("answers", o.answers,
                   "the questions of `edgeproof points` with a column value (CSV; - reads stdin); "
                   "with --exec the recipe");
    sub.add_option(
        "--recipe", o.recipe,
        "what was asked: names what is missing or twice; rows may then stand in any "
        "order and hold id and value alone; the inputs are those of `points`, in binary64");
    sub.add_option("--exec", o.command,
                   "run this command: it reads the questions and writes rows with id and value");
    sub.add_option("--only", o.only,
                   "questions whose id matches, such as 'hertz:*', for a program that knows one "
                   "profile");
    sub.add_option("--batch", o.batch, "with --exec: questions that one run is asked")
        ->capture_default_str();
    sub.add_option("--runs", o.runs, "with --exec: start it at most so often")
        ->capture_default_str();
    sub.add_option("--timeout", o.timeout, "with --exec: seconds after which a run is stopped")
        ->capture_default_str();
    sub.add_option("--digits", o.digits, "pass with |value/exact - 1| <= 10^-D");
    sub.add_option("--ulps", o.ulps, "pass within N binary64 units in the last place");
    sub.add_flag("--conditioned", o.conditioned,
                 "let errors pass that the rounding of the inputs explains");
    sub.add_option("--errors", o.errors, "show at most this number of failures")
        ->capture_default_str();
    sub.add_flag("--json", o.json, "as --format json");
    sub.add_option("--format", o.format,
                   "json: the outcome and the causes; default: text, the report")
        ->type_name("text|json");
    sub.add_option("--out", o.out, "write it to this file (-: standard output)");
    sub.add_option("--junit", o.junit, "write JUnit XML to this file");
    sub.add_option("--ledger", o.ledger, "verify the formulas of this ledger instead");
    add_threads_option(sub, o.threads);
}

} // namespace edgeproof::cli
