// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/cli/scene_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace edgeproof::cli {
namespace {

constexpr std::size_t most_digits_of_a_formula = 10000;

/// The number of claims that do not hold.
std::size_t failing_claims(const audit::AuditResult& result) {
    return static_cast<std::size_t>(std::ranges::count_if(
        result.claims, [](const audit::ClaimResult& r) { return !holds(r.outcome.verdict); }));
}

/// Judges the claims of a ledger, and shows their number as `what` on stderr. Claims that cannot be
/// judged are among the result's errors.
audit::AuditResult judged_ledger(const audit::Ledger& ledger, audit::AuditOptions options,
                                 const std::string& what = "claims") {
    options.errors = audit::ClaimErrors::kept;
    return with_progress(what, options.progress, [&] { return run_audit(ledger, options); });
}

/// Writes a line on stderr for each claim of a ledger that could not be read or judged. Returns the
/// exit status: 2, or 0 if there are none.
int report_claim_errors(const std::vector<audit::ClaimError>& errors) {
    std::fflush(stdout);
    for (const audit::ClaimError& e : errors) {
        std::fprintf(stderr, "%s\n", e.error.what());
    }
    return errors.empty() ? 0 : 2;
}

/// Returns the command for the report. The output folder is left out, so that the report is the
/// same everywhere.
std::string command_text(const Options& o) {
    const std::string what = o["--says"].empty()
                                 ? o["ledger"]
                                 : fmt::format("--says '{}' --of '{}' {}", o["--says"], o["--of"],
                                               fmt::join(o.list("ledger"), " "));
    return "edgeproof verify " + what + " --digits " + o["--digits"] +
           (o["--only"] == "*" ? "" : " --only '" + o["--only"] + "'");
}

std::string toml_text(const std::string& text) {
    using Json = nlohmann::json; // whose texts are texts of TOML, too
    return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Returns the ledger of one formula. The given values are drawn, and, of lengths, loads and moduli
/// that have one value, two multiples of it: with one contact, P and 10*R would be the same.
audit::Ledger ledger_of_formula(const Options& o) {
    static constexpr std::string_view varied = " R R1 R2 C P Es E E1 E2 ";
    require(!o["--of"].empty(), "--says has no quantity to compare the formula with",
            "add --of, such as --of \"p(0)\"");
    std::string profile;
    std::string family;
    std::string parameters;
    for (const std::string& word : o.list("ledger")) {
        const std::size_t equals = word.find('=');
        const std::string key = equals == std::string::npos ? "kind" : word.substr(0, equals);
        const std::string value = equals == std::string::npos ? word : word.substr(equals + 1);
        if (key == "kind" || key == "geometry") {
            family += (key == "kind" ? "profile" : key) + " = " + toml_text(value) + "\n";
            profile += key == "kind" ? value : "";
            continue;
        }
        std::vector<std::string> values = parts_of(value);
        if (values.size() == 1 && varied.find(' ' + key + ' ') != std::string_view::npos) {
            values.push_back("7/5*(" + value + ")");
            values.push_back("9/4*(" + value + ")");
        }
        std::string list;
        for (const std::string& one : values) {
            list += (list.empty() ? "" : ", ") + toml_text(one);
        }
        (key == "knots" || key == "slopes" || key == "u" ? family : parameters) +=
            toml_text(key) + " = [" + list + "]\n";
    }
    require(!profile.empty(), "--says has no contact for the formula",
            "write a kind of profile and values of its keys: hertz R=10 P=100 Es=1");
    return audit::parse_ledger(
        "[ledger]\nname = \"formula\"\n[[family]]\nname = \"contact\"\n" + family +
            "[family.parameters]\n" + parameters +
            "[[claim]]\nid = \"formula\"\nkind = \"compare\"\nover = \"contact\"\nsays = " +
            toml_text(o["--says"]) + "\nof = " + toml_text(o["--of"]) + "\n",
        "command line", audit::ClaimErrors::kept);
}

void write_files(const audit::AuditResult& result, const audit::Ledger& ledger,
                 const report::FiguresOfSource& figures, const Options& o) {
    io::write_folder(o["--out"], [&](const std::filesystem::path& out) {
        io::write_whole(out / "verdicts.json", report::verdicts_json(result));
        io::write_whole(out / "verdicts.csv", report::verdicts_csv(result));
        io::write_whole(out / "verdicts.md", report::verdicts_markdown(result));
        io::write_whole(out / "verdicts.tex", report::verdicts_latex(result));
        report::write_html_report(result, ledger, figures, out,
                                  static_cast<int>(threads_of(o["--threads"])), command_text(o));
    });
}

} // namespace

int verify(Options& o) {
    const bool formula = !o["--says"].empty();
    if (!formula) {
        require(o.list("ledger").size() == 1 && o["--of"].empty(), "verify takes one ledger",
                "give its file, or a formula with --says and --of");
        o.set("ledger", file_or_shipped(o.list("ledger").front(), shipped_ledgers));
    }
    const std::size_t digits =
        whole_number("--digits", o["--digits"], 10, most_digits_of_a_formula);
    const bool record = o.has("--record");
    require(!record || o["--only"] == "*", "--record with --only would forget the other claims",
            "record all of them");
    require(!record || (o["ledger"] != "-" && !formula),
            "--record needs a ledger's name to store the record next to it", "give its file");
    const audit::Ledger ledger =
        formula ? ledger_of_formula(o) : read_ledger(o["ledger"], audit::ClaimErrors::kept);
    if (ledger.claims.empty() && !ledger.errors.empty()) {
        return report_claim_errors(ledger.errors);
    }
    report::FiguresOfSource figures;
    if (!o["--out"].empty()) { // fails before minutes of work, not after them
        figures = report::figures_of_source(ledger.file);
        io::check_folder(o["--out"]);
        for (const char* name : {"verdicts.json", "verdicts.csv", "verdicts.md", "verdicts.tex",
                                 "report.html", "errata.tex"}) {
            io::check_output(std::filesystem::path(o["--out"]) / name);
        }
    }
    audit::AuditResult result =
        judged_ledger(ledger, {.digits = static_cast<unsigned>(digits),
                               .threads = static_cast<int>(threads_of(o["--threads"])),
                               .only = o["--only"]});
    certificate::attach_certificates(
        result, ledger, std::filesystem::path(o["ledger"]).parent_path() / "certificates",
        "certificates");
    if (!o["--out"].empty()) {
        write_files(result, ledger, figures, o);
    }
    std::fputs(report::verdicts_terminal(result, terminal_width(), stdout_takes_colour()).c_str(),
               stdout);
    if (!result.errors.empty()) {
        std::printf("%zu of %zu claims could not be judged\n", result.errors.size(),
                    result.errors.size() + result.claims.size());
        return report_claim_errors(result.errors); // without a record or a comparison
    }
    const int failing = o.has("--strict") && failing_claims(result) > 0 ? 1 : 0;
    const std::filesystem::path golden = report::golden_file(o["ledger"]);
    if (record) {
        io::write_whole(golden, report::golden_text(result));
        std::printf("recorded in %s\n", golden.string().c_str());
        return failing;
    }
    if (formula || !report::has_golden_file(o["ledger"])) {
        return failing;
    }
    const std::vector<std::string> differences =
        report::golden_differences(result, golden, o["--only"]);
    for (const std::string& line : differences) {
        std::printf("differs from the record: %s\n", line.c_str());
    }
    if (differences.empty()) {
        std::printf("as recorded in %s\n", golden.filename().string().c_str());
    }
    return differences.empty() ? failing : 1;
}

int check_ledger(const std::string& ledger, unsigned threads) {
    const audit::Ledger formulas = read_ledger(ledger, audit::ClaimErrors::kept);
    if (formulas.claims.empty() && !formulas.errors.empty()) {
        return report_claim_errors(formulas.errors);
    }
    const audit::AuditResult result =
        judged_ledger(formulas, {.threads = static_cast<int>(threads)}, "formulas");
    std::fputs(report::verdicts_terminal(result, terminal_width(), stdout_takes_colour()).c_str(),
               stdout);
    const auto wrong = failing_claims(result);
    const bool passes = wrong == 0 && result.errors.empty();
    std::printf("%s: %zu formulas, %zu do not hold", passes ? "pass" : "FAIL", result.claims.size(),
                wrong);
    if (!result.errors.empty()) {
        std::printf("; %zu more could not be judged", result.errors.size());
    }
    std::printf("\n");
    const int bad = report_claim_errors(result.errors);
    return bad != 0 ? bad : wrong == 0 ? 0 : 1;
}

} // namespace edgeproof::cli
