// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/tables/agreement_report.hpp"

#include "edgeproof/io/foreign_text.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/report/text/escape.hpp"
#include "edgeproof/report/text/program_line.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>

namespace edgeproof::report {
namespace {

constexpr std::size_t longest_value = 30;

/// Rounded down, so that no missing digit is shown.
long tenths_of(double digits) { return static_cast<long>(std::floor(digits * 10)); }
std::string tenths_text(long tenths, unsigned most) {
    return tenths >= 10 * static_cast<long>(most)
               ? fmt::format("{}+", most)
               : fmt::format("{:.1f}", static_cast<double>(tenths) / 10);
}
std::string digits_text(double digits, unsigned most) {
    return tenths_text(tenths_of(digits), most);
}

/// Returns the upper one of two medians.
long median_of(std::vector<long> list) {
    const auto middle = list.begin() + static_cast<std::ptrdiff_t>(list.size() / 2);
    std::ranges::nth_element(list, middle);
    return *middle;
}

std::string ulps_text(double ulps) {
    return !std::isfinite(ulps) ? "-"
           : ulps < 1000        ? fmt::format("{:.2f}", ulps)
                                : fmt::format("{:.1e}", ulps);
}

std::string shortened(const std::string& text) {
    return text.size() <= longest_value ? text
                                        : fmt::format("{}...", text.substr(0, longest_value));
}

/// Returns what to write in place of a text that is no number, in parentheses.
std::string remedy(const std::string& text) {
    return (text.find_first_of(",' _") != std::string::npos || text.find('.') != text.rfind('.')) &&
                   text.find_first_of("0123456789") != std::string::npos &&
                   text.find_first_not_of("0123456789+-eE,.' _") == std::string::npos
               ? " (write a decimal point, and no marks between thousands)"
               : "";
}

/// Returns the fault of an answer, in a few words.
std::string complaint(const conformance::Answer& answer, const conformance::CaseAgreement& held,
                      unsigned digits) {
    if (!held.no_reference.empty() && answer.line != 0) {
        return "nothing to compare with: " + held.no_reference;
    }
    switch (answer.state) {
    case conformance::Answer::State::missing:
        return answer.line == 0 ? "missing" : "missing: the value is empty";
    case conformance::Answer::State::nan:
        return "nan";
    case conformance::Answer::State::infinite:
        return "inf";
    case conformance::Answer::State::garbage:
        return "garbage: \"" + shortened(answer.text) + "\"" + remedy(answer.text);
    case conformance::Answer::State::died:
        return "the program " + answer.text;
    case conformance::Answer::State::number:
        break;
    }
    std::string why;
    if (held.conditioning) {
        why = fmt::format(" (condition number {:.3g}: {})", held.conditioning->number(),
                          held.explained ? "which explains it" : "which does not explain it");
    }
    return fmt::format("{} digits, {} ulps: {} for {}{}", digits_text(held.digits, digits),
                       ulps_text(held.ulps), shortened(answer.text), held.reference, why);
}

std::string placed(const conformance::Answers& answers, std::size_t i) {
    const std::size_t line = answers.given[i].line;
    return line == 0 ? answers.questions.file + ": "
                     : fmt::format("{}:{}: ", answers.questions.file, line);
}

std::string target_text(const conformance::Target& target) {
    std::string text = target.digits ? fmt::format("{:g} digits", *target.digits) : "";
    if (target.ulps) {
        text += (text.empty() ? "" : " and ") + fmt::format("{:g} ulps", *target.ulps);
    }
    if (!target.stated()) {
        return fmt::format("{:g} digits, or an error that the conditioning explains (none is "
                           "stated: --digits or --ulps)",
                           conformance::Target::default_digits);
    }
    return text + (target.conditioned ? ", or an error that the conditioning explains" : "");
}

std::string convention_text(const conformance::Convention& k) {
    const std::string to = k.without_digits ? "," : ", to " + digits_text(k.digits, 40) + " digits";
    std::string text = fmt::format("{}: yours are {}{} in {} of {} failing rows: {}", k.of,
                                   k.relation, to, k.rows, k.failing, k.hint);
    if (k.remains > 1e-4) {
        text += fmt::format("; {:.1g} % remain, which is something else", 100 * k.remains);
    }
    for (std::size_t i = 0; i < k.also.size(); ++i) {
        text += (i == 0 ? "; as well: " : ", or ") + k.also[i];
    }
    return text;
}

std::string counted(std::size_t n, const char* one, const char* many) {
    return fmt::format("{} {}", n, n == 1 ? one : many);
}

/// The causes, with that of most rows first.
std::vector<conformance::Convention> most_likely_first(const Conformance& c) {
    std::vector<conformance::Convention> by_rows = c.conventions;
    std::ranges::stable_sort(by_rows, std::greater(), &conformance::Convention::rows);
    return by_rows;
}

std::string regimes_text(const Conformance& c) {
    const auto& cases = c.agreements.cases;
    std::map<conformance::Regime, std::vector<std::size_t>> regimes;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        regimes[cases[i].regime].push_back(i);
    }
    const unsigned most = c.agreements.digits;
    std::string out =
        fmt::format("{:<12}{:>7}{:>8}{:>11}{:>9}{:>8}{:>11}{:>9}  {}\n", "regime", "rows", "failed",
                    "explained", "median", "worst", "ulps", "cond", "worst case");
    for (const auto& [regime, rows] : regimes) {
        std::size_t failed = 0;
        std::size_t explained = 0; // below the target, but by the conditioning
        std::vector<long> tenths;  // the digits of the answers that are numbers, as shown
        std::optional<std::size_t> worst;
        for (const std::size_t i : rows) {
            failed += c.failed(i) ? 1 : 0;
            if (c.answers.given[i].state == conformance::Answer::State::number &&
                cases[i].no_reference.empty()) {
                tenths.push_back(tenths_of(cases[i].digits));
                explained += cases[i].explained && !cases[i].within ? 1 : 0;
                worst = !worst || cases[i].digits < cases[*worst].digits ? i : worst;
            }
        }
        out += fmt::format("{:<12}{:>7}{:>8}{:>11}", regime_name(regime), rows.size(), failed,
                           explained);
        if (worst) {
            const conformance::CaseAgreement& held = cases[*worst];
            out += fmt::format(
                "{:>9}{:>8}{:>11}{:>9}  {}", tenths_text(median_of(tenths), most),
                digits_text(held.digits, most), ulps_text(held.ulps),
                held.conditioning ? fmt::format("{:.2g}", held.conditioning->number()) : "-",
                printable(c.answers.questions.list[*worst].id));
        }
        out += "\n";
    }
    return out;
}

/// Each question is in one of these counts.
struct Counts {
    std::size_t wrong = 0; ///< answers outside the target
    std::size_t right = 0;
    std::size_t missing = 0;
    std::size_t ended = 0; ///< questions that ended the program
    std::size_t without_reference = 0;

    [[nodiscard]] std::size_t answers() const { return wrong + right + without_reference; }
};

Counts counts_of(const Conformance& c) {
    Counts counts;
    for (std::size_t i = 0; i < c.agreements.cases.size(); ++i) {
        const conformance::Answer& answer = c.answers.given[i];
        ++(answer.state == conformance::Answer::State::died ? counts.ended
           : answer.line == 0                               ? counts.missing
           : !c.agreements.cases[i].no_reference.empty()    ? counts.without_reference
           : c.failed(i)                                    ? counts.wrong
                                                            : counts.right);
    }
    return counts;
}

/// The first line of the report.
std::string outcome_text(const Conformance& c, const Counts& counts) {
    std::string text = fmt::format("{}: {}, {}", c.pass() ? "pass" : "FAIL",
                                   counted(counts.answers(), "answer", "answers"),
                                   counted(counts.wrong, "failure", "failures"));
    const auto add = [&](std::size_t n, const std::string& words) {
        text += n > 0 ? ", " + words : "";
    };
    add(counts.missing, fmt::format("{} missing", counts.missing));
    add(counts.ended, counted(counts.ended, "question that ended the program",
                              "questions that ended the program"));
    add(counts.without_reference, fmt::format("{} without a reference", counts.without_reference));
    const std::size_t faults = c.answers.faults.size();
    add(faults,
        counted(faults, "fault of the rows or the program", "faults of the rows or the program"));
    return text + "\n";
}

/// What is to be said about the answers as a whole: a line each.
std::string notes_text(const Conformance& c) {
    std::string out;
    for (const conformance::Convention& convention : most_likely_first(c)) {
        out += convention_text(convention) + "\n";
    }
    const auto left = unexplained(c.answers, c.agreements, c.conventions);
    if (!left.empty()) {
        out += fmt::format("{}: no known mistake explains the errors\n", fmt::join(left, "; "));
    }
    const auto failing =
        std::ranges::count(c.agreements.cases, false, &conformance::CaseAgreement::pass);
    if (static_cast<std::size_t>(failing) > conformance::most_failing) {
        out += fmt::format("conventions are looked for in the first {} of {} rows that fail\n",
                           conformance::most_failing, failing);
    }
    return out;
}

std::string complaints_text(const Conformance& c, std::size_t errors) {
    std::vector<std::string> lines = c.answers.faults;
    for (std::size_t i = 0; i < c.agreements.cases.size() && lines.size() < errors; ++i) {
        if (c.failed(i)) {
            lines.push_back(
                placed(c.answers, i) + c.answers.questions.list[i].id + ": " +
                complaint(c.answers.given[i], c.agreements.cases[i], c.agreements.digits));
        }
    }
    std::string out;
    const std::size_t all = c.answers.faults.size() + c.failures();
    const std::size_t shown = std::min(lines.size(), errors);
    for (std::size_t i = 0; i < shown; ++i) {
        out += printable(lines[i]) + "\n";
    }
    if (all > shown) {
        out += fmt::format("{}{} more (--errors shows more of them)\n", shown > 0 ? "and " : "",
                           all - shown);
    }
    return all > 0 ? out + "\n" : out;
}

} // namespace

bool Conformance::failed(std::size_t i) const {
    return answers.given[i].state != conformance::Answer::State::number ||
           !agreements.cases[i].pass;
}

std::size_t Conformance::failures() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < agreements.cases.size(); ++i) {
        count += failed(i) ? 1 : 0;
    }
    return count;
}

bool Conformance::pass() const {
    return answers.faults.empty() && conventions.empty() && !agreements.cases.empty() &&
           failures() == 0;
}

std::string conformance_text(const Conformance& c, std::size_t errors) {
    const Counts counts = counts_of(c);
    std::string out = outcome_text(c, counts) + notes_text(c);
    if (counts.missing > 0 && counts.answers() > 0) {
        out += "--only 'PATTERN' compares only the questions whose id matches, such as 'hertz:*'\n";
    }
    if (c.agreements.estimates > 0) {
        out += fmt::format("{} of the references are estimates, without a proved bound\n",
                           c.agreements.estimates);
    }
    if (c.answers.out_of_order > 0) {
        out +=
            fmt::format("{} not in the order of the questions: their ids state what they answer\n",
                        counted(c.answers.out_of_order, "row is", "rows are"));
    }
    return out + "\n" + complaints_text(c, errors) + regimes_text(c) +
           fmt::format("\nprogram: {}\ntarget: {}\n", program_line(), target_text(c.target));
}

std::string conformance_json(const Conformance& c) {
    nlohmann::ordered_json causes = nlohmann::ordered_json::array();
    for (const conformance::Convention& k : most_likely_first(c)) {
        std::vector<std::string> others;
        for (const std::string& name : k.equally_likely) {
            if (name != k.name && std::ranges::find(others, name) == others.end()) {
                others.push_back(name);
            }
        }
        causes.push_back({{"name", k.name},
                          {"factor", k.factor},
                          {"rows", k.rows},
                          {"equally_likely", others},
                          {"remainder", std::pow(10.0, -k.held)},
                          {"of", k.of},
                          {"relation", k.relation}});
    }
    const nlohmann::ordered_json all{
        {"passes", c.pass()}, {"rows", c.agreements.cases.size()}, {"failures", c.failures()},
        {"causes", causes},   {"program", program_line()},
    };
    return all.dump(2) + "\n";
}

std::string conformance_junit(const Conformance& c) {
    std::size_t failures = c.answers.faults.empty() ? 0 : 1;
    std::string cases;
    for (std::size_t i = 0; i < c.agreements.cases.size(); ++i) {
        cases += fmt::format("  <testcase classname=\"{}\" name=\"{}\"",
                             xml_text(regime_name(c.agreements.cases[i].regime)),
                             xml_text(c.answers.questions.list[i].id));
        if (c.failed(i)) {
            ++failures;
            cases += fmt::format(">\n    <failure message=\"{}\"/>\n  </testcase>\n",
                                 xml_text(complaint(c.answers.given[i], c.agreements.cases[i],
                                                    c.agreements.digits)));
        } else {
            cases += "/>\n";
        }
    }
    std::string faults;
    for (const std::string& fault : c.answers.faults) {
        faults += xml_text(fault) + "\n";
    }
    for (const conformance::Convention& convention : c.conventions) {
        faults += xml_text(convention_text(convention)) + "\n";
    }
    failures += c.answers.faults.empty() && !c.conventions.empty() ? 1 : 0;
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<testsuite name=\"edgeproof check\" tests=\"{}\" failures=\"{}\">\n"
        "  <properties><property name=\"program\" value=\"{}\"/></properties>\n"
        "  <testcase classname=\"answers\" name=\"as a whole\"{}\n{}</testsuite>\n",
        c.agreements.cases.size() + 1, failures, xml_text(program_line()),
        faults.empty() ? "/>" : ">\n    <failure message=\"" + faults + "\"/>\n  </testcase>",
        cases);
}

} // namespace edgeproof::report
