// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/cli.hpp"
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/conformance/program.hpp"
#include "edgeproof/conformance/recipe.hpp"
#include "edgeproof/conformance/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/text.hpp"
#include "edgeproof/report/agreement_report.hpp"
#include "edgeproof/report/files.hpp"
#include "edgeproof/report/reference_table.hpp"

#include <cstdio>
#include <iostream>
#include <iterator>
#include <memory>

namespace edgeproof::cli {
namespace {

constexpr double most_digits = 10'000;
constexpr double most_ulps = 1e300;

struct CheckOptions {
    std::string answers;
    std::string recipe;
    std::string command;
    std::string timeout = "600";
    std::string digits;
    std::string ulps;
    std::string errors = "20";
    std::string junit;
    std::string threads;
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

Target target_of(const CheckOptions& o) {
    Target target;
    if (!o.digits.empty()) {
        target.digits = positive("--digits", o.digits, most_digits);
    }
    if (!o.ulps.empty()) {
        target.ulps = positive("--ulps", o.ulps, most_ulps);
    }
    return target;
}

Csv read_answers(const CheckOptions& o) {
    if (o.answers != "-") {
        return parse_csv(read_text(o.answers, "file of answers (CSV)"), o.answers);
    }
    const std::string text{std::istreambuf_iterator<char>(std::cin), {}};
    return parse_csv(text, "stdin");
}

/// Asks a program; what it answers is never bad input, only wrong.
Answers ask_program(const CheckOptions& o) {
    if (!o.recipe.empty()) {
        throw InputError("--recipe is given with --exec", "give the recipe alone, as the first");
    }
    const double seconds = positive("--timeout", o.timeout, 1e9);
    const Recipe recipe = read_recipe(o.answers);
    const Questions asked = rounded_to_binary64(recipe.questions);
    const std::string text = write_table(question_table(asked, recipe.title), TableFormat::csv);
    return answers_of_program(asked, run_program(o.command, text, seconds, &interrupted()));
}

Answers answers_of(const CheckOptions& o) {
    if (!o.command.empty()) {
        return ask_program(o);
    }
    return o.recipe.empty()
               ? echoed_answers(read_answers(o))
               : answers_to(rounded_to_binary64(read_recipe(o.recipe).questions), read_answers(o));
}

int check(const CheckOptions& o) {
    Conformance result;
    result.target = target_of(o);
    const std::size_t errors = whole_number("--errors", o.errors, 0, 1'000'000'000);
    ReferenceOptions options;
    options.threads = o.threads.empty()
                          ? 0
                          : static_cast<unsigned>(whole_number("--threads", o.threads, 1, 1024));
    options.stop = &interrupted();
    result.answers = answers_of(o);
    {
        Progress progress("references");
        options.progress = [&](std::size_t done, std::size_t total) { progress(done, total); };
        result.agreements = compare(result.answers, result.target, options);
        result.conventions = infer_conventions(result.answers, result.agreements, options);
    }
    if (!o.junit.empty()) {
        write_whole(o.junit, conformance_junit(result));
    }
    std::fputs(conformance_text(result, errors).c_str(), stdout);
    return result.pass() ? 0 : 1;
}

} // namespace

void add_check(CLI::App& app, int& code) {
    CLI::App* sub = app.add_subcommand("check", "another program's answers, held to the reference");
    auto o = std::make_shared<CheckOptions>();
    sub->add_option("answers", o->answers,
                    "the questions of `edgeproof points` with a column value (CSV; - reads stdin); "
                    "with --exec the recipe")
        ->required();
    sub->add_option("--recipe", o->recipe,
                    "what was asked: names what is missing, twice, out of order; rows may then "
                    "hold id and value alone");
    sub->add_option("--exec", o->command,
                    "run this command: it reads the questions (CSV) and writes rows with id and "
                    "value");
    sub->add_option("--timeout", o->timeout, "with --exec: seconds after which it is stopped")
        ->capture_default_str();
    sub->add_option("--digits", o->digits, "pass with |value/exact - 1| <= 10^-D");
    sub->add_option("--ulps", o->ulps, "pass within N binary64 units in the last place");
    sub->add_option("--errors", o->errors, "show at most so many failures")->capture_default_str();
    sub->add_option("--junit", o->junit, "write JUnit XML to this file");
    sub->add_option("--threads", o->threads, "threads (default: one a processor)");
    sub->callback([o, &code] { code = check(*o); });
}

} // namespace edgeproof::cli
