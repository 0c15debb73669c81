// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/enclosures.hpp"

#include "edgeproof/audit/enclosure/sample_in_balls.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace edgeproof::audit {
namespace {

constexpr std::size_t tries = 24; // samples at which a refutation by balls is tried
/// The same for formulas with integrals, and the numbers of samples with enclosures for them.
constexpr std::size_t tries_of_integrals = 4;
constexpr std::size_t worst_of_integrals = 4;
constexpr std::size_t others_of_integrals = 4;
constexpr unsigned spare_digits = 2; // added to the aim of integrals
constexpr double every_digit = 1e6;  // for numbers that are exactly equal

struct Sampled {
    const EvaluatedSamples& samples;
    std::size_t index;
};

/// Both formulas in balls at one sample, and the scale of their difference.
struct Pair {
    std::optional<Ball> printed;
    std::optional<Ball> exact;
    std::optional<Ball> scale;
    std::string problem;
};

/// Returns the digits to which any two numbers in the balls agree, relative to the scale.
double proved_digits(const Pair& pair) {
    const Real most = abs(*pair.printed - *pair.exact).upper();
    if (most == 0) {
        return every_digit;
    }
    if (!certainly_positive(*pair.scale)) {
        return -every_digit;
    }
    return Real(-log10(Real(most / pair.scale->lower()))).convert_to<double>();
}

Ball scale_at(const EnclosedSample& sample, const ComparedFormulas& formulas, const Ball& exact) {
    if (formulas.scale) {
        return abs(sample.evaluate(*formulas.scale));
    }
    if (!contains_zero(exact)) {
        return abs(exact);
    }
    try {
        return scale_of_terms(formulas.printed, sample) + scale_of_terms(formulas.exact, sample);
    } catch (const Error&) {
        return abs(exact); // no scale is known: only numbers that are exactly zero agree
    }
}

/// Returns false if more bits are not useful.
bool enclose(const Sampled& at, const ComparedFormulas& formulas, long bits, unsigned aim,
             Pair& pair) {
    try {
        const EnclosedSample& sample = at.samples.enclosed(at.index, bits, aim);
        Ball x = sample.evaluate(formulas.printed);
        Ball y = sample.evaluate(formulas.exact);
        Ball size = scale_at(sample, formulas, y);
        if (!x.is_finite() || !y.is_finite() || !size.is_finite()) {
            pair.problem = "the balls do not exclude a point where it is undefined";
            return true;
        }
        pair.printed = std::move(x);
        pair.exact = std::move(y);
        pair.scale = std::move(size);
        return true;
    } catch (const BudgetError& error) {
        pair.problem = error.what();
        return true;
    } catch (const Error& error) {
        pair.problem = error.what();
        return false;
    }
}

/// Increases the bits until the balls are disjoint or prove `digits` digits.
Pair pair_at(const Sampled& at, const ComparedFormulas& formulas, unsigned digits) {
    Pair pair;
    const long needed = formula::bits_for(digits);
    for (long bits = 2 * needed; bits <= 8 * needed; bits *= 2) {
        if (!enclose(at, formulas, bits, digits, pair) ||
            (pair.printed &&
             (disjoint(*pair.printed, *pair.exact) || proved_digits(pair) >= digits))) {
            break;
        }
    }
    return pair;
}

/// The width of an integral's ball depends on the digits it aims at. The bits are doubled if there
/// is no enclosure, and the digits are increased once if too many cancel.
Pair pair_of_integrals(const Sampled& at, const ComparedFormulas& formulas, unsigned digits) {
    Pair pair;
    const long needed = formula::bits_for(digits);
    const unsigned aim = digits + spare_digits;
    for (long bits = 2 * needed; bits <= 4 * needed && !pair.printed; bits *= 2) {
        if (!enclose(at, formulas, bits, aim, pair)) {
            return pair;
        }
    }
    if (!pair.printed || disjoint(*pair.printed, *pair.exact)) {
        return pair;
    }
    const double proved = proved_digits(pair);
    if (proved < AuditContext::digits_needed(digits)) {
        const auto missing = static_cast<unsigned>(std::clamp(aim - proved, 0., 1. * digits));
        enclose(at, formulas, 4 * needed, aim + missing, pair);
    }
    return pair;
}

Pair pair_for(const Sampled& at, const ComparedFormulas& formulas, unsigned digits) {
    return formulas.have_integrals() ? pair_of_integrals(at, formulas, digits)
                                     : pair_at(at, formulas, digits);
}

Evidence both(const Pair& pair, const std::string& at, unsigned digits) {
    Evidence e;
    e.add("at", at)
        .add("printed", ball_text(*pair.printed, digits))
        .add("exact", ball_text(*pair.exact, digits))
        .add("disjoint", disjoint(*pair.printed, *pair.exact));
    return e;
}

/// Returns the indices, beginning with the sample of least agreement.
std::vector<std::size_t> by_digits(const Agreement& agreement) {
    std::vector<std::size_t> order(agreement.samples_at.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
        return agreement.samples_at[i].digits() < agreement.samples_at[j].digits();
    });
    return order;
}

/// Searches for a refutation at the samples where the values in Real differ most.
std::optional<Refutation> find_refutation(const Agreement& agreement,
                                          const EvaluatedSamples& samples_at,
                                          const ComparedFormulas& formulas, unsigned digits,
                                          Evidence& evidence) {
    std::size_t tried = 0;
    for (const std::size_t i : by_digits(agreement)) {
        const SampleAgreement& there = agreement.samples_at[i];
        if (there.no_value() != nullptr) {
            continue;
        }
        if (there.digits() >= AuditContext::digits_needed(digits) ||
            tried++ == (formulas.have_integrals() ? tries_of_integrals : tries)) {
            break;
        }
        const Pair pair = pair_for({samples_at, i}, formulas, digits);
        if (!pair.printed) {
            continue;
        }
        if (const auto found = Refutation::disjoint(*pair.printed, *pair.exact)) {
            evidence.add("enclosures", both(pair, samples_at.all()[i].text, digits));
            return found;
        }
    }
    return std::nullopt;
}

/// Returns the samples at which a confirmation is enclosed: all; for integrals, those that agree
/// least (including all that do not agree in Real) and some of the others.
std::vector<std::size_t> chosen(const Agreement& agreement, const ComparedFormulas& formulas,
                                unsigned digits) {
    std::vector<std::size_t> order = by_digits(agreement);
    const auto doubtful =
        static_cast<std::size_t>(std::count_if(order.begin(), order.end(), [&](std::size_t i) {
            return agreement.samples_at[i].digits() < AuditContext::digits_needed(digits);
        }));
    const std::size_t first = std::max(worst_of_integrals, doubtful);
    if (!formulas.have_integrals() || order.size() <= first + others_of_integrals) {
        std::sort(order.begin(), order.end());
        return order;
    }
    std::vector<std::size_t> some(order.begin(),
                                  order.begin() + static_cast<std::ptrdiff_t>(first));
    for (std::size_t k = 1; k <= others_of_integrals; ++k) {
        const std::size_t rest = order.size() - first;
        some.push_back(order[first + k * rest / others_of_integrals - 1]);
    }
    std::sort(some.begin(), some.end());
    return some;
}

} // namespace

std::string_view name_of(Basis basis) {
    static constexpr std::array<std::string_view, all_bases.size()> names{
        "theorem", "identity", "enclosures", "text", "none"};
    return names.at(static_cast<std::size_t>(basis));
}

Basis basis_of(const ClaimResult& result) {
    const Verdict verdict = result.outcome.verdict;
    if (result.certificate && result.certificate->whole_verdict) {
        return Basis::theorem;
    }
    if (verdict == Verdict::proved) {
        return Basis::identity;
    }
    if (verdict == Verdict::definition || verdict == Verdict::underspecified) {
        return Basis::text;
    }
    // A Judgement of any other verdict except `undecided` is made of balls only.
    return verdict == Verdict::undecided ? Basis::none : Basis::enclosures;
}

Decision compare_by_enclosures(const Agreement& agreement, const EvaluatedSamples& samples_at,
                               const ComparedFormulas& formulas, unsigned digits,
                               Outcome& outcome) {
    const double needed = AuditContext::digits_needed(digits);
    std::optional<Confirmation> all;
    std::size_t count = 0;
    double least = every_digit;
    std::optional<Evidence> worst;
    for (const std::size_t i : chosen(agreement, formulas, digits)) {
        check_interruption();
        const Pair pair = pair_for({samples_at, i}, formulas, digits);
        const std::string& at = samples_at.all()[i].text;
        if (!pair.printed) {
            outcome.note = "no enclosure: " + pair.problem;
            outcome.evidence.add("enclosures", Evidence().add("none", pair.problem));
            return {};
        }
        if (const auto apart = Refutation::disjoint(*pair.printed, *pair.exact)) {
            outcome.evidence.add("enclosures", both(pair, at, digits));
            return *apart;
        }
        const auto holds = Confirmation::agreement(*pair.printed, *pair.exact, *pair.scale, needed);
        if (!holds) {
            outcome.note = "the enclosures prove " + digits_text(proved_digits(pair)) + " of " +
                           digits_text(needed) + " digits at " + at;
            outcome.evidence.add("enclosures", both(pair, at, digits));
            return {};
        }
        all = holds;
        ++count;
        const double proved = proved_digits(pair);
        if (!worst || proved < least) {
            least = proved;
            worst = both(pair, at, digits);
        }
    }
    if (worst) {
        // The digits are rounded down to a tenth.
        const double tenths = std::floor(std::min(least, 1.0 * digits) * 10) / 10;
        worst->add("digits_proved", digits_text(tenths)).add("samples", count);
        outcome.evidence.add("enclosures", std::move(*worst));
    }
    return decision(std::nullopt, all);
}

Judgement judge_by_enclosures(const Agreement& agreement, const EvaluatedSamples& samples_at,
                              const ExactFormula& printed, const formula::Expr& exact,
                              const std::optional<formula::Expr>& scale, unsigned digits,
                              Outcome& outcome) {
    const ComparedFormulas formulas{printed.expr(), exact, scale};
    if (const auto fails =
            find_refutation(agreement, samples_at, formulas, digits, outcome.evidence)) {
        return Judgement(*fails);
    }
    if (agreement.without_value() > 0) {
        outcome.note = agreement.obstacle(AuditContext::digits_needed(digits));
        return Undecided::underspecified;
    }
    return Judgement(compare_by_enclosures(agreement, samples_at, formulas, digits, outcome));
}

void add_pair(const ComparedNumbers& numbers, unsigned digits, Evidence& evidence) {
    Evidence e;
    if (!numbers.first.ball || !numbers.second.ball) {
        e.add("none", numbers.first.ball ? numbers.second.problem : numbers.first.problem);
    } else {
        e.add("at", numbers.at)
            .add(numbers.first_name, ball_text(*numbers.first.ball, digits))
            .add(numbers.second_name, ball_text(*numbers.second.ball, digits))
            .add("disjoint", disjoint(*numbers.first.ball, *numbers.second.ball));
    }
    evidence.add("enclosures", std::move(e));
}

} // namespace edgeproof::audit
