// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/tables/agreement_report.hpp"

#include "edgeproof/conformance/answers/number_text.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/report/text/escape.hpp"
#include "edgeproof/report/text/program_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace edgeproof::report {
namespace {

constexpr std::size_t longest_value = 30;

/// Rounded down: digits that are not there are not shown.
std::string digits_text(double digits, unsigned most) {
    return digits >= most ? fmt::format("{}+", most)
                          : fmt::format("{:.1f}", std::floor(digits * 10) / 10);
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

/// What is wrong with an answer, in a few words.
std::string complaint(const Conformance& c, std::size_t i) {
    const conformance::Answer& answer = c.answers.given[i];
    const conformance::CaseAgreement& held = c.agreements.cases[i];
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
        return "garbage: \"" + shortened(answer.text) + "\"" +
               (conformance::with_decimal_point(answer.text) ? " (a decimal comma; write a point)"
                                                             : "");
    case conformance::Answer::State::died:
        return "the program " + answer.text;
    case conformance::Answer::State::number:
        break;
    }
    std::string why;
    if (held.conditioning) {
        why = fmt::format(" (condition number {:.2g}: {})", held.conditioning->number(),
                          held.explained ? "which explains it" : "which does not explain it");
    }
    return fmt::format("{} digits, {} ulps: {} for {}{}",
                       digits_text(held.digits, c.agreements.digits), ulps_text(held.ulps),
                       shortened(answer.text), held.reference, why);
}

std::string placed(const Conformance& c, std::size_t i) {
    const std::size_t line = c.answers.given[i].line;
    return line == 0 ? c.answers.questions.file + ": "
                     : fmt::format("{}:{}: ", c.answers.questions.file, line);
}

struct Tally {
    std::size_t rows = 0;
    std::size_t failed = 0;
    std::size_t explained = 0; ///< short of the target's digits, by what the conditioning explains
    std::optional<std::size_t> worst; ///< of the answers that are numbers
    std::vector<double> digits;
};

std::map<conformance::Regime, Tally> tallies_of(const Conformance& c) {
    std::map<conformance::Regime, Tally> tallies;
    for (std::size_t i = 0; i < c.agreements.cases.size(); ++i) {
        const conformance::CaseAgreement& held = c.agreements.cases[i];
        Tally& t = tallies[held.regime];
        ++t.rows;
        t.failed += c.failed(i) ? 1 : 0;
        if (c.answers.given[i].state != conformance::Answer::State::number ||
            !held.no_reference.empty()) {
            continue;
        }
        t.digits.push_back(held.digits);
        t.explained += held.explained && !held.within ? 1 : 0;
        if (!t.worst || held.digits < c.agreements.cases[*t.worst].digits) {
            t.worst = i;
        }
    }
    return tallies;
}

std::string regimes_text(const Conformance& c) {
    std::string out =
        fmt::format("{:<12}{:>7}{:>8}{:>11}{:>9}{:>8}{:>11}{:>9}  {}\n", "regime", "rows", "failed",
                    "explained", "median", "worst", "ulps", "cond", "worst case");
    for (auto& [regime, t] : tallies_of(c)) {
        out += fmt::format("{:<12}{:>7}{:>8}{:>11}", regime_name(regime), t.rows, t.failed,
                           t.explained);
        if (t.worst) {
            std::vector<double> digits = t.digits;
            const auto middle = digits.begin() + static_cast<long>(digits.size() / 2);
            std::nth_element(digits.begin(), middle, digits.end());
            const conformance::CaseAgreement& worst = c.agreements.cases[*t.worst];
            out += fmt::format(
                "{:>9}{:>8}{:>11}{:>9}  {}", digits_text(*middle, c.agreements.digits),
                digits_text(worst.digits, c.agreements.digits), ulps_text(worst.ulps),
                worst.conditioning ? fmt::format("{:.2g}", worst.conditioning->number()) : "-",
                printable(c.answers.questions.list[*t.worst].id));
        }
        out += "\n";
    }
    return out;
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
    std::string text =
        fmt::format("{}: yours are {}, to {} digits in {} of {} failing rows: {}", k.of, k.relation,
                    digits_text(k.digits, 40), k.rows, k.failing, k.hint);
    for (std::size_t i = 0; i < k.also.size(); ++i) {
        text += (i == 0 ? "; as well: " : ", or ") + k.also[i];
    }
    return text;
}

std::string counted(std::size_t n, const char* one, const char* many) {
    return fmt::format("{} {}", n, n == 1 ? one : many);
}

/// Every question is in one of the first four; the faults are of the rows as a whole.
struct AnswerCounts {
    std::size_t failures = 0; ///< answers that are not within the target
    std::size_t missing = 0;
    std::size_t ended = 0; ///< questions that ended the program
    std::size_t nothing_to_compare_with = 0;
    std::size_t answers = 0; ///< rows to questions, whatever stands in them
};
AnswerCounts counts_of(const Conformance& c) {
    AnswerCounts n;
    for (std::size_t i = 0; i < c.agreements.cases.size(); ++i) {
        const conformance::Answer& answer = c.answers.given[i];
        if (answer.state == conformance::Answer::State::died) {
            ++n.ended;
        } else if (answer.line == 0) {
            ++n.missing;
        } else {
            ++n.answers;
            const bool comparable = c.agreements.cases[i].no_reference.empty();
            n.nothing_to_compare_with += comparable ? 0 : 1;
            n.failures += comparable && c.failed(i) ? 1 : 0;
        }
    }
    return n;
}

std::string outcome_text(const Conformance& c) {
    const AnswerCounts n = counts_of(c);
    std::string text = fmt::format("{}: {}, {}", c.pass() ? "pass" : "FAIL",
                                   counted(n.answers, "answer", "answers"),
                                   counted(n.failures, "failure", "failures"));
    if (n.missing > 0) {
        text += fmt::format(", {} missing", n.missing);
    }
    if (n.ended > 0) {
        text += ", " + counted(n.ended, "question that ended the program",
                               "questions that ended the program");
    }
    if (n.nothing_to_compare_with > 0) {
        text += fmt::format(", {} without a reference", n.nothing_to_compare_with);
    }
    if (!c.answers.faults.empty()) {
        text += ", " + counted(c.answers.faults.size(), "fault of the rows or the program",
                               "faults of the rows or the program");
    }
    return text;
}

} // namespace

bool Conformance::failed(std::size_t i) const {
    return answers.given[i].state != conformance::Answer::State::number ||
           !agreements.cases[i].pass;
}

bool Conformance::pass() const {
    if (!answers.faults.empty() || !conventions.empty() || agreements.cases.empty()) {
        return false;
    }
    for (std::size_t i = 0; i < agreements.cases.size(); ++i) {
        if (failed(i)) {
            return false;
        }
    }
    return true;
}

std::string conformance_text(const Conformance& c, std::size_t errors) {
    std::string out;
    std::size_t shown = 0;
    std::size_t hidden = 0;
    const auto complain = [&](const std::string& line) {
        if (shown < errors) {
            ++shown;
            out += printable(line) + "\n";
        } else {
            ++hidden;
        }
    };
    for (const std::string& fault : c.answers.faults) {
        complain(fault);
    }
    for (std::size_t i = 0; i < c.agreements.cases.size(); ++i) {
        if (c.failed(i)) {
            complain(placed(c, i) + c.answers.questions.list[i].id + ": " + complaint(c, i));
        }
    }
    if (hidden > 0) {
        out += fmt::format("and {} more (--errors shows more of them)\n", hidden);
    }
    out += (out.empty() ? "" : "\n") + regimes_text(c) + "\n";
    for (const conformance::Convention& convention : c.conventions) {
        out += convention_text(convention) + "\n";
    }
    if (const auto names = unexplained(c.answers, c.agreements, c.conventions); !names.empty()) {
        out += fmt::format("{}: no mistake that is known explains what is off\n",
                           fmt::join(names, "; "));
    }
    if (c.agreements.estimates > 0) {
        out += fmt::format("{} of the references are estimates, without a proved bound\n",
                           c.agreements.estimates);
    }
    if (c.answers.out_of_order > 0) {
        out += fmt::format("{} in another order than asked: their ids tell what they answer\n",
                           counted(c.answers.out_of_order, "row stands", "rows stand"));
    }
    out += fmt::format("program: {}\ntarget: {}\n", program_line(), target_text(c.target));
    return out + outcome_text(c) + "\n";
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
                                 xml_text(complaint(c, i)));
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
