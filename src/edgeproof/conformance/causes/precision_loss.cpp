// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/causes/unit_mistake.hpp"

#include "edgeproof/conformance/causes/convention_rule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

namespace edgeproof::conformance {
namespace {

constexpr double least_digits_kept = 5.5;
constexpr unsigned binary32_digits = 9; // identify every binary32
constexpr unsigned full_digits = 15;

/// Counts the significant digits of a decimal as written; 0 for any other text.
unsigned digits_written(const std::string& text) {
    unsigned digits = 0;
    for (const char c : text) {
        if (c == 'e' || c == 'E' || c == 'd' || c == 'D') {
            break;
        }
        if (c == 'x' || c == 'X') {
            return 0;
        }
        digits += std::isdigit(static_cast<unsigned char>(c)) != 0 && (digits > 0 || c != '0');
    }
    return digits;
}

/// True if the answer is a binary32, or one written with the few digits that identify it.
bool is_single(const Answer& answer) {
    const auto near = answer.value.convert_to<float>();
    if (static_cast<double>(near) == answer.value.convert_to<double>()) {
        // A short decimal such as 0.5 is no evidence.
        return digits_written(answer.text) == 0 || digits_written(answer.text) > 4;
    }
    const unsigned digits = digits_written(answer.text);
    const std::string text = fmt::format("{:.{}e}", static_cast<double>(near), binary32_digits - 1);
    return digits > 0 && digits <= binary32_digits && read_answer(text).value == answer.value;
}

/// True if the reference, rounded to the number of digits of the answer, is the answer.
bool is_cut(const Answer& answer, const Reference& reference, unsigned digits) {
    const Rounded rounded = round_ball(reference.value.value, digits);
    return rounded.complete && read_answer(rounded.text).value == answer.value;
}

struct Tally {
    std::size_t failing = 0;
    std::size_t single = 0;
    std::size_t cut = 0;
    unsigned written = 0;
    double digits = 40;
};

} // namespace

std::vector<Convention> infer_precision_loss(const Answers& answers, const Agreements& agreements) {
    std::map<std::string, Tally> families;
    for (std::size_t i = 0; i < agreements.cases.size(); ++i) {
        const Answer& answer = answers.given[i];
        const CaseAgreement& held = agreements.cases[i];
        const bool number =
            answer.state == Answer::State::number && answer.value != 0 && held.no_reference.empty();
        const unsigned written = number ? digits_written(answer.text) : 0;
        const bool cut = number && written > 0 && written < full_digits && !held.pass &&
                         is_cut(answer, agreements.references[i], written);
        if (!number || held.pass || (held.digits < least_digits_kept && !cut)) {
            continue;
        }
        Tally& t = families[family_of(answers.questions.list[i])];
        ++t.failing;
        t.single += is_single(answer) ? 1 : 0;
        t.cut += cut ? 1 : 0;
        t.written = std::max(t.written, written);
        t.digits = std::min(t.digits, held.digits);
    }
    std::vector<Convention> found;
    for (const auto& [family, t] : families) {
        const auto most = [&, failing = t.failing](std::size_t n) {
            return convention_rule::enough(n, failing);
        };
        if (most(t.cut)) {
            found.push_back({family,
                             fmt::format("right, and cut to {} digits when written", t.written),
                             t.digits, t.cut, t.failing,
                             "write all 17 digits of a double (%.17g), or state what you write "
                             "with --digits"});
        } else if (most(t.single)) {
            found.push_back({family, "in single precision (binary32)", t.digits, t.single,
                             t.failing, "compute and write in double precision"});
        }
    }
    return found;
}

} // namespace edgeproof::conformance
