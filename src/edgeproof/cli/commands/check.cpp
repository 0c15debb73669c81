// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/cli/scene_command.hpp"

#include <boost/algorithm/string/replace.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <map>

namespace edgeproof::cli {
namespace {

constexpr double most_digits_of_a_check = 10'000;
constexpr double most_ulps = 1e300;

/// Reads a number > 0 of an option, and returns it as binary64.
std::string number(const std::string& option, const std::string& text, double most) {
    double value = 0;
    try {
        value = parse_decimal(text).convert_to<double>();
    } catch (const InputError& error) {
        throw InputError(option + " " + text + ": " + error.problem(), "give a number > 0");
    }
    if (!(value > 0 && value <= most)) {
        throw InputError(option + " " + text + " is out of range", "give a number > 0, such as 10");
    }
    return fmt::format("{}", value);
}

/// The words of RECIPE -- PROGRAM ARGUMENTS as a command, each quoted, so that the shell reads none
/// of them and only finds the program.
std::string quoted_command(const std::vector<std::string>& words) {
    std::string command = "exec";
    for (const std::string& word : words) {
        command += " '" + boost::replace_all_copy(word, "'", "'\\''") + "'";
    }
    return command;
}

void refuse_recipe(const Options& o) {
    if (std::filesystem::path(o["answers"]).extension() == ".toml") {
        throw InputError(
            "this is a TOML file, not answers (CSV)",
            "add -- PROGRAM ARGUMENTS to ask a program the questions of a recipe, or give a "
            "ledger with --ledger")
            .at(o["answers"], 0);
    }
}

/// The options of report::checked_answers.
std::map<std::string, std::string, std::less<>> check_options(const Options& o) {
    std::map<std::string, std::string, std::less<>> asked{
        {"only", o["--only"]},
        {"conditioned", o.has("--conditioned") ? "yes" : ""},
        {"threads", std::to_string(threads_of(o["--threads"]))}};
    if (!o["--digits"].empty()) {
        asked["digits"] = number("--digits", o["--digits"], most_digits_of_a_check);
    }
    if (!o["--ulps"].empty()) {
        asked["ulps"] = number("--ulps", o["--ulps"], most_ulps);
    }
    const std::vector<std::string>& program = o.list("program");
    require(program.empty() || o["--exec"].empty(), "--exec is given with a program",
            "give one of the two");
    if (!program.empty() || !o["--exec"].empty()) {
        require(o["--recipe"].empty(), "--recipe is given with a program",
                "give the recipe alone, as the first");
        asked["recipe"] = o["answers"];
        asked["command"] = program.empty() ? o["--exec"] : quoted_command(program);
        asked["seconds"] = number("--timeout", o["--timeout"], 1e9);
        asked["batch"] = std::to_string(whole_number("--batch", o["--batch"], 1, 1'000'000));
        asked["runs"] = std::to_string(whole_number("--runs", o["--runs"], 1, 1'000'000));
    } else {
        refuse_recipe(o);
        asked["recipe"] = o["--recipe"];
        asked["answers"] = io::read_text(o["answers"], "file of answers (CSV)");
        asked["name"] = io::input_name(o["answers"]);
    }
    return asked;
}

} // namespace

int check(Options& o) {
    o.set("--ledger", file_or_shipped(o["--ledger"], shipped_ledgers));
    o.set("--recipe", file_or_shipped(o["--recipe"], shipped_recipes));
    o.set("answers", file_or_shipped(o["answers"], shipped_recipes));
    const bool json = text_or_json(o["--format"]) || o.has("--json");
    require(!json || o["--ledger"].empty(), "--json is for answers", "leave --json out");
    require(o["--only"] == "*" || o["--ledger"].empty(), "--only is for answers",
            "leave --only out");
    require(o["--out"].empty() || o["--ledger"].empty(), "--out is for answers", "leave --out out");
    if (!o["--ledger"].empty()) {
        return check_ledger(o["--ledger"], threads_of(o["--threads"]));
    }
    require(!o["answers"].empty(), "there is nothing to check",
            "give ANSWERS.csv, or RECIPE.toml -- PROGRAM, or --ledger FORMULAS.toml");
    io::check_output(o["--junit"]);
    io::check_output(o["--out"]);
    const std::size_t errors = whole_number("--errors", o["--errors"], 0, 1'000'000'000);
    const auto asked = check_options(o);
    ProgramMessages messages;
    Progress answers("answers");
    Progress references("references");
    const report::Conformance result = report::checked_answers(
        asked, {std::ref(answers), std::ref(references), std::ref(messages)});
    wipe_progress();
    if (!o["--junit"].empty()) {
        io::write_output(o["--junit"], conformance_junit(result));
    }
    io::write_output(o["--out"].empty() ? "-" : o["--out"],
                     json ? conformance_json(result)
                          : printable_lines(conformance_text(result, errors)));
    return result.pass() ? 0 : 1;
}

} // namespace edgeproof::cli
