// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/enclosures.hpp"

#include "edgeproof/formula/exact/exact_ball.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace edgeproof::audit {
namespace {

constexpr std::size_t tries = 24; // samples at which a refutation is looked for in balls
/// The same where there are integrals, and how many samples these are enclosed at.
constexpr std::size_t tries_of_integrals = 4;
constexpr std::size_t worst_of_integrals = 4;
constexpr std::size_t others_of_integrals = 4;
constexpr unsigned spare_digits = 2;   // that integrals aim at
constexpr unsigned enough_digits = 20; // where parts of an integral cancel

/// What is held against what.
struct Formulas {
    const formula::Expr& printed;
    const formula::Expr& exact;
    const std::optional<formula::Expr>& scale;
    [[nodiscard]] bool have_integrals() const { return has_binder(printed) || has_binder(exact); }
};

/// One of the samples.
struct Sampled {
    const EvaluatedSamples& samples;
    std::size_t index;
};

struct Pair {
    std::optional<Ball> printed;
    std::optional<Ball> exact;
    std::optional<Ball> scale; ///< of a difference, where it is not the exact value
    std::string problem;
};

/// Digits to which two numbers in the balls certainly agree, relative to the scale, or the second.
std::optional<double> proved_digits(const Pair& pair) {
    const Ball& size = pair.scale ? *pair.scale : *pair.exact;
    if (contains_zero(size)) {
        return std::nullopt;
    }
    const Ball off = abs((*pair.printed - *pair.exact) / size);
    const Real most = off.upper();
    return most == 0 ? 1e6 : Real(-log10(most)).convert_to<double>();
}

/// Both formulas, and the scale, from one enclosed sample; false where there is no use in more
/// bits.
bool enclose(const Sampled& at, const Formulas& formulas, long bits, unsigned aim, Pair& pair) {
    try {
        const EnclosedSample& sample = at.samples.enclosed(at.index, bits, aim);
        Ball x = sample.evaluate(formulas.printed);
        Ball y = sample.evaluate(formulas.exact);
        std::optional<Ball> size;
        if (formulas.scale) {
            size = sample.evaluate(*formulas.scale);
        }
        if (!x.is_finite() || !y.is_finite() || (size && !size->is_finite())) {
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

/// At more and more bits.
Pair pair_at(const Sampled& at, const Formulas& formulas, unsigned digits) {
    Pair pair;
    const long needed = formula::bits_for(digits);
    const auto good = [&](const Ball& x) { return x.relative_accuracy_bits() >= needed; };
    for (long bits = 2 * needed; bits <= 8 * needed; bits *= 2) {
        if (!enclose(at, formulas, bits, digits, pair) ||
            (pair.printed && good(*pair.printed) && good(*pair.exact))) {
            break;
        }
    }
    return pair;
}

/// Integrals come out as wide as they are told to: twice the bits for what is not enclosed, and
/// once more digits where too many cancel.
Pair pair_of_integrals(const Sampled& at, const Formulas& formulas, unsigned digits) {
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
    const auto proved = proved_digits(pair);
    if (proved && *proved < std::min(enough_digits, digits - digits / 4)) {
        const auto missing = static_cast<unsigned>(std::clamp(aim - *proved, 0., 1. * digits));
        enclose(at, formulas, 4 * needed, aim + missing, pair);
    }
    return pair;
}

Pair pair_for(const Sampled& at, const Formulas& formulas, unsigned digits) {
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

/// Indices from the sample that agrees least on.
std::vector<std::size_t> by_digits(const Agreement& agreement) {
    std::vector<std::size_t> order(agreement.samples_at.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
        return agreement.samples_at[i].digits() < agreement.samples_at[j].digits();
    });
    return order;
}

void add_refutation(const Agreement& agreement, const EvaluatedSamples& samples_at,
                    const Formulas& formulas, unsigned digits, Outcome& outcome) {
    std::string problem = "the printed formula has no value at any sample";
    std::size_t tried = 0;
    const bool integrals = formulas.have_integrals();
    std::optional<Evidence> overlapping;
    for (const std::size_t i : by_digits(agreement)) {
        if (agreement.samples_at[i].values() == nullptr) {
            continue;
        }
        if (tried++ == (integrals ? tries_of_integrals : tries)) {
            break;
        }
        const Pair pair = pair_for({samples_at, i}, formulas, digits);
        if (!pair.printed || !pair.exact) {
            problem = pair.problem;
            continue;
        }
        Evidence e = both(pair, samples_at.all()[i].text, digits);
        if (disjoint(*pair.printed, *pair.exact)) {
            outcome.evidence.add("enclosures", std::move(e));
            return;
        }
        // An integral's balls may be wider than the difference, and then they say nothing.
        const auto proved = proved_digits(pair);
        if (integrals && proved && *proved < agreement.samples_at[i].digits() + 1) {
            problem = "the balls are wider than what the two differ by";
            continue;
        }
        overlapping = std::move(e);
    }
    if (overlapping && agreement.without_value() > 0) {
        outcome.verdict = NotRefuted::underspecified;
        return;
    }
    if (overlapping) {
        outcome.verdict = NotRefuted::undecided;
        outcome.note = "the estimates have it differ, the enclosures do not";
        outcome.evidence.add("enclosures", std::move(*overlapping));
        return;
    }
    outcome.evidence.add("enclosures", Evidence().add("none", problem));
}

/// The samples at which a confirmation is enclosed: all, or of integrals those that agree least and
/// some of the others.
std::vector<std::size_t> chosen(const Agreement& agreement, const Formulas& formulas) {
    std::vector<std::size_t> order = by_digits(agreement);
    if (!formulas.have_integrals() || order.size() <= worst_of_integrals + others_of_integrals) {
        std::sort(order.begin(), order.end());
        return order;
    }
    std::vector<std::size_t> some(order.begin(), order.begin() + worst_of_integrals);
    for (std::size_t k = 1; k <= others_of_integrals; ++k) {
        const std::size_t rest = order.size() - worst_of_integrals;
        some.push_back(order[worst_of_integrals + k * rest / others_of_integrals - 1]);
    }
    std::sort(some.begin(), some.end());
    return some;
}

void add_confirmation(const Agreement& agreement, const EvaluatedSamples& samples_at,
                      const Formulas& formulas, unsigned digits, Outcome& outcome) {
    std::size_t count = 0;
    double least = 1e6;
    std::optional<Evidence> worst;
    std::string problem = "the exact value is zero";
    for (const std::size_t i : chosen(agreement, formulas)) {
        const Pair pair = pair_for({samples_at, i}, formulas, digits);
        if (!pair.printed || !pair.exact) {
            problem = pair.problem;
            if (count == 0) {
                break; // what the first sample does not have, the others do not
            }
            continue;
        }
        if (disjoint(*pair.printed, *pair.exact)) {
            outcome.verdict = NotRefuted::undecided;
            outcome.note = "the estimates have it agree, the enclosures do not";
            outcome.evidence.add("enclosures", both(pair, samples_at.all()[i].text, digits));
            return;
        }
        if (const auto proved = proved_digits(pair)) {
            // What cancels to less than roundoff agrees with anything, as far as its terms tell.
            if (!formulas.have_integrals() && *proved < 1) {
                outcome.verdict = NotRefuted::undecided;
                outcome.note = "the enclosures, " + std::to_string(8 * formula::bits_for(digits)) +
                               " bits wide, do not bear out one digit";
                outcome.evidence.add("enclosures", both(pair, samples_at.all()[i].text, digits));
                return;
            }
            ++count;
            if (!worst || *proved < least) {
                least = *proved;
                worst = both(pair, samples_at.all()[i].text, digits);
            }
        }
    }
    if (!worst) {
        outcome.evidence.add("enclosures", Evidence().add("none", problem));
        return;
    }
    // Not rounded up, as it would be by the nearest tenth.
    const double tenths = std::floor(std::min(least, 1.0 * digits) * 10) / 10;
    worst->add("digits_proved", digits_text(tenths)).add("samples", count);
    outcome.evidence.add("enclosures", std::move(*worst));
}

bool has_disjoint(const Outcome& outcome) {
    const EvidenceItem* item = outcome.evidence.find("enclosures");
    const auto* pair = item == nullptr ? nullptr : std::get_if<Evidence>(&item->value());
    const EvidenceItem* apart = pair == nullptr ? nullptr : pair->find("disjoint");
    return apart != nullptr && std::get<bool>(apart->value());
}

/// Balls of what the verdict is about.
bool is_enclosed(const Outcome& outcome) {
    const EvidenceItem* item = outcome.evidence.find("enclosures");
    const auto* pair = item == nullptr ? nullptr : std::get_if<Evidence>(&item->value());
    return pair != nullptr && pair->find("none") == nullptr;
}

} // namespace

bool rests_on_enclosures(const ClaimResult& result) {
    if (result.readings.empty()) {
        return has_disjoint(result.outcome);
    }
    return std::all_of(result.readings.begin(), result.readings.end(), [](const auto& reading) {
        return reading.second.verdict != Verdict::refuted || has_disjoint(reading.second);
    });
}

std::string_view name_of(Basis basis) {
    static constexpr std::array<std::string_view, all_bases.size()> names{
        "theorem", "identity", "enclosures", "estimates", "text"};
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
    const bool enclosed =
        verdict == Verdict::refuted ? rests_on_enclosures(result)
        : result.readings.empty()
            ? is_enclosed(result.outcome)
            : std::all_of(result.readings.begin(), result.readings.end(),
                          [](const auto& reading) { return is_enclosed(reading.second); });
    return enclosed ? Basis::enclosures : Basis::estimates;
}

void add_enclosures(const Agreement& agreement, const EvaluatedSamples& samples_at,
                    const formula::Expr& printed, const formula::Expr& exact,
                    const std::optional<formula::Expr>& scale, unsigned digits, Outcome& outcome) {
    const Formulas formulas{printed, exact, scale};
    if (outcome.verdict == Verdict::refuted) {
        add_refutation(agreement, samples_at, formulas, digits, outcome);
    } else if (holds(outcome.verdict)) {
        add_confirmation(agreement, samples_at, formulas, digits, outcome);
    }
}

void add_pair(const std::string& first, const Enclosed& x, const std::string& second,
              const Enclosed& y, const std::string& at, unsigned digits, Outcome& outcome) {
    Evidence e;
    if (!x.ball || !y.ball) {
        e.add("none", x.ball ? y.problem : x.problem);
    } else {
        const bool apart = disjoint(*x.ball, *y.ball);
        e.add("at", at)
            .add(first, ball_text(*x.ball, digits))
            .add(second, ball_text(*y.ball, digits))
            .add("disjoint", apart);
        if (!apart && outcome.verdict == Verdict::refuted) {
            outcome.verdict = NotRefuted::undecided;
            outcome.note = "the estimates have it differ, the enclosures do not";
        }
    }
    outcome.evidence.add("enclosures", std::move(e));
}

} // namespace edgeproof::audit
