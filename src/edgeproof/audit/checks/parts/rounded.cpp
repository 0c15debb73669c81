// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/parts/rounded.hpp"

#include "edgeproof/audit/enclosure/enclosed_sample.hpp"
#include "edgeproof/formula/exact/exact_ball.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>
#include <cctype>

namespace edgeproof::audit {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool begins_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }

constexpr std::size_t most_constants = 4;
constexpr int most_steps = 12;
constexpr unsigned spare = 15;        // digits beyond those of the run
constexpr unsigned most_digits = 100; // that a constant is found to

std::string name_of_constant(std::size_t k) { return "printed_decimal_" + std::to_string(k); }

/// The formula as a function of some of its decimals, at the samples of a claim, in balls.
class Fit {
public:
    Fit(const Claim& claim, const EvaluatedSamples& samples_at, const formula::Expr& exact,
        std::vector<PrintedDecimal> decimals, unsigned digits)
        : decimals_(std::move(decimals)), digits_(digits),
          bits_(formula::bits_for(2 * digits + 2 * spare)), exact_(exact) {
        std::string text = claim.text("says");
        Vocabulary vocabulary = claim.vocabulary;
        for (std::size_t k = decimals_.size(); k-- > 0;) {
            text.replace(decimals_[k].offset, decimals_[k].text.size(),
                         "(" + name_of_constant(k) + ")");
            vocabulary.symbols.add(name_of_constant(k));
        }
        formula_ = expand_definitions(parse_formula(text, vocabulary), vocabulary);
        for (const EvaluatedSample& sample_at : samples_at.all()) {
            samples_.emplace_back(sample_at.sample, bits_, digits + spare);
            targets_.push_back(samples_.back().evaluate(exact_));
        }
    }

    /// Newton's iteration from what is printed. False if it does not lead anywhere.
    [[nodiscard]] bool solve() {
        const std::size_t n = decimals_.size();
        const std::vector<std::size_t> at = spread_first(samples_.size(), n);
        for (const PrintedDecimal& d : decimals_) {
            constants_.push_back(from_rational<Real>(d.value));
        }
        const Real close = pow(Real(10), -static_cast<int>(digits_ + spare / 2));
        for (int step = 0; step < most_steps; ++step) {
            std::vector<std::vector<Real>> rows; // the Jacobian, and what is missing
            for (std::size_t i = 0; i < n; ++i) {
                const Real here = value(at[i], constants_).midpoint();
                std::vector<Real> row;
                for (std::size_t k = 0; k < n; ++k) {
                    std::vector<Real> moved = constants_;
                    moved[k] += moved[k] * pow(Real(10), -static_cast<int>(digits_ / 2));
                    row.push_back((value(at[i], moved).midpoint() - here) /
                                  (moved[k] - constants_[k]));
                }
                row.push_back(targets_[at[i]].midpoint() - here);
                rows.push_back(std::move(row));
            }
            const auto change = solved(std::move(rows));
            if (!change) {
                return false;
            }
            bool done = true;
            for (std::size_t k = 0; k < n; ++k) {
                constants_[k] += (*change)[k];
                done = done && abs((*change)[k]) <= close * abs(constants_[k]);
            }
            if (done) {
                return true;
            }
        }
        return false;
    }

    /// At every sample the exact value lies between those for each constant lowered and raised.
    [[nodiscard]] bool proved() {
        const Real off = pow(Real(10), -static_cast<int>(digits_));
        for (std::size_t k = 0; k < constants_.size(); ++k) {
            std::vector<Real> lowered = constants_;
            std::vector<Real> raised = constants_;
            lowered[k] -= abs(constants_[k]) * off;
            raised[k] += abs(constants_[k]) * off;
            for (std::size_t i = 0; i < samples_.size(); ++i) {
                const Ball low = value(i, lowered);
                const Ball high = value(i, raised);
                const Ball& target = targets_[i];
                if (!(certainly_less(low, target) && certainly_less(target, high)) &&
                    !(certainly_less(high, target) && certainly_less(target, low))) {
                    return false;
                }
            }
        }
        return true;
    }

    [[nodiscard]] const std::vector<PrintedDecimal>& decimals() const { return decimals_; }
    [[nodiscard]] const std::vector<Real>& constants() const { return constants_; }
    [[nodiscard]] std::size_t samples() const { return samples_.size(); }

private:
    [[nodiscard]] Ball value(std::size_t sample, const std::vector<Real>& constants) {
        for (std::size_t k = 0; k < constants.size(); ++k) {
            samples_[sample].set(name_of_constant(k), Ball(constants[k], bits_));
        }
        return samples_[sample].evaluate(formula_);
    }

    /// Gauss's elimination with pivots; nothing where the rows do not tell the unknowns apart.
    [[nodiscard]] static std::optional<std::vector<Real>>
    solved(std::vector<std::vector<Real>> rows) {
        const std::size_t n = rows.size();
        for (std::size_t k = 0; k < n; ++k) {
            const auto pivot = std::max_element(
                rows.begin() + static_cast<std::ptrdiff_t>(k), rows.end(),
                [&](const auto& x, const auto& y) { return abs(x[k]) < abs(y[k]); });
            if (!isfinite((*pivot)[k]) || (*pivot)[k] == 0) {
                return std::nullopt;
            }
            std::swap(rows[k], *pivot);
            for (std::size_t i = 0; i < n; ++i) {
                if (i != k) {
                    const Real factor = rows[i][k] / rows[k][k];
                    for (std::size_t j = k; j <= n; ++j) {
                        rows[i][j] -= factor * rows[k][j];
                    }
                }
            }
        }
        std::vector<Real> x;
        for (std::size_t k = 0; k < n; ++k) {
            x.push_back(rows[k][n] / rows[k][k]);
            if (!isfinite(x.back())) {
                return std::nullopt;
            }
        }
        return x;
    }

    std::vector<PrintedDecimal> decimals_;
    unsigned digits_;
    long bits_;
    formula::Expr exact_;
    formula::Expr formula_;
    std::vector<EnclosedSample> samples_;
    std::vector<Ball> targets_;
    std::vector<Real> constants_;
};

/// The constant rounded to the place of the printed one, as a decimal where that has no exponent.
std::string in_its_place(const PrintedDecimal& printed, const Real& exact) {
    const Real steps = floor(Real(exact / from_rational<Real>(printed.unit) + Real(1) / 2));
    if (printed.text.find_first_of("eE") == std::string::npos) {
        const std::size_t places = printed.text.size() - printed.text.find('.') - 1;
        return Real(steps * from_rational<Real>(printed.unit))
            .str(static_cast<std::streamsize>(places), std::ios_base::fixed);
    }
    return "(" + exact_text(Rational(steps.convert_to<Integer>()) * printed.unit) + ")";
}

std::optional<RoundedFormula> fitted(const Claim& claim, const EvaluatedSamples& samples_at,
                                     const formula::Expr& exact,
                                     std::vector<PrintedDecimal> decimals, unsigned digits) {
    if (samples_at.all().size() <= decimals.size()) {
        return std::nullopt; // as many constants as samples fit anything
    }
    try {
        Fit fit(claim, samples_at, exact, std::move(decimals), digits);
        if (!fit.solve() || !fit.proved()) {
            return std::nullopt;
        }
        RoundedFormula found;
        found.samples = fit.samples();
        found.digits = static_cast<int>(digits);
        found.with_them = claim.text("says");
        for (std::size_t k = fit.decimals().size(); k-- > 0;) {
            const PrintedDecimal& printed = fit.decimals()[k];
            const Real off = (fit.constants()[k] - from_rational<Real>(printed.value)) /
                             from_rational<Real>(printed.unit);
            // Half a unit, and not within what the constant is known to.
            const Real known = abs(fit.constants()[k] / from_rational<Real>(printed.unit)) *
                               pow(Real(10), -static_cast<int>(digits));
            found.constants.insert(found.constants.begin(), {printed, fit.constants()[k],
                                                             abs(off) + known <= Real(1) / 2, off});
            found.with_them.replace(printed.offset, printed.text.size(),
                                    in_its_place(printed, fit.constants()[k]));
        }
        return found;
    } catch (const Error&) {
        return std::nullopt; // no enclosure, or none for these constants
    }
}

} // namespace

namespace {

Evidence evidence_of(const RoundedFormula& found) {
    std::vector<EvidenceItem> list;
    for (const RoundedFormula::Constant& c : found.constants) {
        Evidence one;
        one.add("printed", c.printed.text)
            .add("stands_for", to_decimal(c.exact, static_cast<unsigned>(found.digits)))
            .add("units_off", to_decimal(c.units_off, 3))
            .add("rounds_to_it", c.rounds);
        list.emplace_back(std::move(one));
    }
    Evidence e;
    e.add("constants", std::move(list)).add("samples", found.samples).add("digits", found.digits);
    return e;
}

/// Digits of the number as printed, leading zeros not among them.
std::size_t significant_digits(const PrintedDecimal& d) {
    std::size_t count = 0;
    for (const char c : d.text.substr(0, d.text.find_first_of("eE"))) {
        count += is_digit(c) && (count > 0 || c != '0') ? 1 : 0;
    }
    return count;
}

} // namespace

void judge_rounded(const Claim& claim, const EvaluatedSamples& samples_at,
                   const formula::Expr& exact, unsigned digits, Outcome& outcome) {
    if (outcome.verdict != Verdict::refuted || claim.text_or("decimals", "rounded") == "exact") {
        return;
    }
    const auto found = find_rounded(claim, samples_at, exact, std::min(digits, most_digits));
    if (!found) {
        return;
    }
    outcome.evidence.add("rounded", evidence_of(*found));
    bool all_round = true;
    bool all_near = true;
    std::string right;
    std::string off;
    for (const RoundedFormula::Constant& c : found->constants) {
        all_round = all_round && c.rounds;
        all_near = all_near && abs(c.units_off) <= Real(3) / 2;
        const std::size_t known = significant_digits(c.printed);
        const std::string exactly = to_decimal(c.exact, static_cast<unsigned>(known) + 5);
        if (c.rounds) {
            right += (right.empty() ? "" : ", ") + std::to_string(known) + " printed digits of " +
                     c.printed.text + " (exactly " + exactly + "...)";
        } else {
            off += (off.empty() ? "" : ", ") + c.printed.text + " should be " +
                   in_its_place(c.printed, c.exact) + " (exactly " + exactly + "...)";
        }
    }
    if (all_round) {
        outcome.verdict = NotRefuted::confirmed;
        outcome.note = "right to the " + right + ", at " + std::to_string(found->samples) +
                       " samples; a rounded formula";
        return;
    }
    outcome.correct = found->with_them;
    outcome.note = off + (right.empty() ? "" : "; right to the " + right);
    if (all_near) {
        outcome.verdict = NotRefuted::imprecise;
    }
}

bool is_rounded(const Outcome& outcome) {
    return outcome.verdict == Verdict::confirmed && outcome.evidence.find("rounded") != nullptr;
}

std::vector<PrintedDecimal> printed_decimals(std::string_view formula) {
    std::vector<PrintedDecimal> all;
    for (std::size_t i = 0; i < formula.size();) {
        std::size_t end = i;
        if (begins_name(formula[i])) { // dots within names: "right.c0"
            while (end < formula.size() &&
                   (begins_name(formula[end]) || is_digit(formula[end]) || formula[end] == '.')) {
                ++end;
            }
            i = end;
            continue;
        }
        while (end < formula.size() && (is_digit(formula[end]) || formula[end] == '.')) {
            ++end;
        }
        if (end == i) {
            ++i;
            continue;
        }
        const std::size_t point = formula.substr(i, end - i).find('.');
        const std::size_t mantissa = end;
        if (end + 1 < formula.size() && (formula[end] == 'e' || formula[end] == 'E')) {
            std::size_t e = end + 1;
            e += formula[e] == '+' || formula[e] == '-' ? 1 : 0;
            if (e < formula.size() && is_digit(formula[e])) {
                while (e < formula.size() && is_digit(formula[e])) {
                    ++e;
                }
                end = e;
            }
        }
        if (point != std::string_view::npos) {
            PrintedDecimal d{std::string(formula.substr(i, end - i)), i, {}, {}};
            d.value = parse_decimal(d.text);
            const std::size_t places = mantissa - i - point - 1;
            d.unit = parse_decimal("1e-" + std::to_string(places));
            if (end > mantissa) {
                d.unit *=
                    parse_decimal("1" + std::string(formula.substr(mantissa, end - mantissa)));
            }
            if (d.value != 0) {
                all.push_back(std::move(d));
            }
        }
        i = end;
    }
    return all;
}

std::optional<RoundedFormula> find_rounded(const Claim& claim, const EvaluatedSamples& samples_at,
                                           const formula::Expr& exact, unsigned digits) {
    const std::vector<PrintedDecimal> all = printed_decimals(claim.text("says"));
    if (all.empty() || all.size() > most_constants) {
        return std::nullopt;
    }
    const PrecisionScope scope(2 * digits + 2 * spare);
    std::optional<RoundedFormula> any;
    for (const PrintedDecimal& d : all) {
        if (auto found = fitted(claim, samples_at, exact, {d}, digits)) {
            if (found->constants.front().rounds) {
                return found;
            }
            any = any ? any : std::move(found);
        }
    }
    if (!any && all.size() > 1) {
        any = fitted(claim, samples_at, exact, all, digits);
    }
    return any;
}

} // namespace edgeproof::audit
