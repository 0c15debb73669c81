// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/tables/agreement_report.hpp"

#include "edgeproof/conformance/answers/number_text.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/report/text/escape.hpp"
#include "edgeproof/report/text/program_line.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

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
long median_of(const std::map<long, std::size_t>& counts) {
    std::size_t all = 0;
    for (const auto& [value, n] : counts) {
        all += n;
    }
    std::size_t before = 0;
    for (const auto& [value, n] : counts) {
        before += n;
        if (before > all / 2) {
            return value;
        }
    }
    return 0;
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
    return text.find_first_of(",.' _") != std::string::npos &&
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

bool fails(const conformance::Answer& answer, const conformance::CaseAgreement& held) {
    return answer.state != conformance::Answer::State::number || !held.pass;
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

} // namespace

bool Conformance::failed(std::size_t i) const {
    return fails(answers.given[i], agreements.cases[i]);
}

bool Conformance::pass() const { return summary_of(*this, 0).pass(); }

void ConformanceSummary::complain(Complaints& to, const std::string& line) const {
    if (to.count++ < errors_) {
        to.shown.push_back(printable(line));
    }
}

void ConformanceSummary::add(const conformance::Answers& answers,
                             const conformance::Agreements& agreements) {
    digits_ = agreements.digits;
    estimates_ += agreements.estimates;
    out_of_order_ += answers.out_of_order;
    cases_ += agreements.cases.size();
    for (const std::string& fault : answers.faults) {
        complain(faults_, fault);
    }
    for (std::size_t i = 0; i < agreements.cases.size(); ++i) {
        const conformance::Answer& answer = answers.given[i];
        const conformance::CaseAgreement& held = agreements.cases[i];
        const std::string& id = answers.questions.list[i].id;
        const bool failed = fails(answer, held);
        const bool comparable = held.no_reference.empty();
        if (failed) {
            complain(failures_, placed(answers, i) + id + ": " + complaint(answer, held, digits_));
        }
        if (answer.state == conformance::Answer::State::died) {
            ++counts_.ended;
        } else if (answer.line == 0) {
            ++counts_.missing;
        } else {
            ++counts_.answers;
            counts_.nothing_to_compare_with += comparable ? 0 : 1;
            counts_.failures += comparable && failed ? 1 : 0;
        }
        Tally& t = tallies_[held.regime];
        ++t.rows;
        t.failed += failed ? 1 : 0;
        if (answer.state != conformance::Answer::State::number || !comparable) {
            continue;
        }
        ++t.tenths[tenths_of(held.digits)];
        t.explained += held.explained && !held.within ? 1 : 0;
        if (!t.worst || held.digits < t.worst->held.digits) {
            t.worst = Worst{held, id};
        }
    }
}

void ConformanceSummary::add(const std::vector<conformance::Convention>& conventions,
                             const std::vector<std::string>& unexplained) {
    conventions_.insert(conventions_.end(), conventions.begin(), conventions.end());
    if (!unexplained.empty()) {
        note(fmt::format("{}: no known mistake explains the errors", fmt::join(unexplained, "; ")));
    }
}

bool ConformanceSummary::pass() const {
    return faults_.count == 0 && failures_.count == 0 && conventions_.empty() && cases_ > 0;
}

std::string ConformanceSummary::regimes_text() const {
    std::string out =
        fmt::format("{:<12}{:>7}{:>8}{:>11}{:>9}{:>8}{:>11}{:>9}  {}\n", "regime", "rows", "failed",
                    "explained", "median", "worst", "ulps", "cond", "worst case");
    for (const auto& [regime, t] : tallies_) {
        out += fmt::format("{:<12}{:>7}{:>8}{:>11}", regime_name(regime), t.rows, t.failed,
                           t.explained);
        if (t.worst) {
            const conformance::CaseAgreement& worst = t.worst->held;
            out += fmt::format(
                "{:>9}{:>8}{:>11}{:>9}  {}", tenths_text(median_of(t.tenths), digits_),
                digits_text(worst.digits, digits_), ulps_text(worst.ulps),
                worst.conditioning ? fmt::format("{:.2g}", worst.conditioning->number()) : "-",
                printable(t.worst->id));
        }
        out += "\n";
    }
    return out;
}

std::string ConformanceSummary::outcome_text() const {
    std::string text = fmt::format("{}: {}, {}", pass() ? "pass" : "FAIL",
                                   counted(counts_.answers, "answer", "answers"),
                                   counted(counts_.failures, "failure", "failures"));
    if (counts_.missing > 0) {
        text += fmt::format(", {} missing", counts_.missing);
    }
    if (counts_.ended > 0) {
        text += ", " + counted(counts_.ended, "question that ended the program",
                               "questions that ended the program");
    }
    if (counts_.nothing_to_compare_with > 0) {
        text += fmt::format(", {} without a reference", counts_.nothing_to_compare_with);
    }
    if (faults_.count > 0) {
        text += ", " + counted(faults_.count, "fault of the rows or the program",
                               "faults of the rows or the program");
    }
    return text;
}

std::string ConformanceSummary::text() const {
    std::string out = outcome_text() + "\n";
    for (const conformance::Convention* convention : most_likely_first()) {
        out += convention_text(*convention) + "\n";
    }
    for (const std::string& line : notes_) {
        out += line + "\n";
    }
    if (counts_.missing > 0 && counts_.answers > 0) {
        out += "--only 'PATTERN' compares only the questions whose id matches, such as 'hertz:*'\n";
    }
    if (estimates_ > 0) {
        out +=
            fmt::format("{} of the references are estimates, without a proved bound\n", estimates_);
    }
    if (out_of_order_ > 0) {
        out +=
            fmt::format("{} not in the order of the questions: their ids state what they answer\n",
                        counted(out_of_order_, "row is", "rows are"));
    }
    out += "\n";
    std::size_t shown = 0;
    for (const Complaints* complaints : {&faults_, &failures_}) {
        for (const std::string& line : complaints->shown) {
            if (shown < errors_) {
                ++shown;
                out += line + "\n";
            }
        }
    }
    const std::size_t hidden = faults_.count + failures_.count - shown;
    if (hidden > 0) {
        out += fmt::format("{}{} more (--errors shows more of them)\n", shown > 0 ? "and " : "",
                           hidden);
    }
    out += shown + hidden > 0 ? "\n" : "";
    return out + regimes_text() +
           fmt::format("\nprogram: {}\ntarget: {}\n", program_line(), target_text(target_));
}

std::vector<const conformance::Convention*> ConformanceSummary::most_likely_first() const {
    std::vector<const conformance::Convention*> by_rows;
    for (const conformance::Convention& c : conventions_) {
        by_rows.push_back(&c);
    }
    std::ranges::stable_sort(by_rows, std::greater(), &conformance::Convention::rows);
    return by_rows;
}

std::string ConformanceSummary::json() const {
    nlohmann::ordered_json causes = nlohmann::ordered_json::array();
    for (const conformance::Convention* c : most_likely_first()) {
        std::vector<std::string> others;
        for (const std::string& name : c->equally_likely) {
            if (name != c->name && std::ranges::find(others, name) == others.end()) {
                others.push_back(name);
            }
        }
        causes.push_back({{"name", c->name},
                          {"factor", c->factor},
                          {"rows", c->rows},
                          {"equally_likely", others},
                          {"remainder", std::pow(10.0, -c->held)},
                          {"of", c->of},
                          {"relation", c->relation}});
    }
    const nlohmann::ordered_json all{
        {"passes", pass()},
        {"rows", cases_},
        {"failures", failures_.count},
        {"causes", causes},
        {"program", program_line()},
    };
    return all.dump(2) + "\n";
}

ConformanceSummary summary_of(const Conformance& c, std::size_t errors) {
    ConformanceSummary summary(c.target, errors);
    summary.add(c.answers, c.agreements);
    summary.add(c.conventions, unexplained(c.answers, c.agreements, c.conventions));
    const auto failing =
        std::ranges::count(c.agreements.cases, false, &conformance::CaseAgreement::pass);
    if (static_cast<std::size_t>(failing) > conformance::most_failing) {
        summary.note(fmt::format("conventions are looked for in the first {} of {} rows that fail",
                                 conformance::most_failing, failing));
    }
    return summary;
}

std::string conformance_text(const Conformance& c, std::size_t errors) {
    return summary_of(c, errors).text();
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
