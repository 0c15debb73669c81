// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/enclosures.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/exact_ball.hpp"

#include <algorithm>
#include <numeric>

namespace edgeproof {
namespace {

constexpr std::size_t tries = 24; // samples at which a refutation is looked for in balls

struct Pair {
    std::optional<Ball> printed;
    std::optional<Ball> exact;
    std::string problem;
};

/// Both formulas from one enclosed sample, at more and more bits.
Pair pair_at(const Spot& spot, const Expr& printed, const Expr& exact, unsigned digits) {
    Pair pair;
    const long needed = bits_for(digits);
    const auto good = [&](const Ball& x) {
        return x.is_finite() && x.relative_accuracy_bits() >= needed;
    };
    for (long bits = 2 * needed; bits <= 8 * needed; bits *= 2) {
        try {
            const EnclosedSample sample(spot.sample, bits);
            Ball x = sample.evaluate(printed);
            Ball y = sample.evaluate(exact);
            if (!x.is_finite() || !y.is_finite()) {
                pair.problem = "the balls do not exclude a point where it is undefined";
                continue;
            }
            const bool enough = good(x) && good(y);
            pair.printed = std::move(x);
            pair.exact = std::move(y);
            if (enough) {
                break;
            }
        } catch (const BudgetError& error) {
            pair.problem = error.what();
        } catch (const Error& error) {
            pair.problem = error.what();
            break;
        }
    }
    return pair;
}

/// Digits to which two numbers in the balls certainly agree, relative to the second.
std::optional<double> proved_digits(const Ball& x, const Ball& y) {
    if (contains_zero(y)) {
        return std::nullopt;
    }
    const Ball off = abs((x - y) / y);
    const Real most = off.upper();
    return most == 0 ? 1e6 : Real(-log10(most)).convert_to<double>();
}

Evidence both(const Pair& pair, const std::string& at, unsigned digits) {
    Evidence e;
    e.add("at", at)
        .add("printed", ball_text(*pair.printed, digits))
        .add("exact", ball_text(*pair.exact, digits))
        .add("disjoint", disjoint(*pair.printed, *pair.exact));
    return e;
}

/// Indices from the spot that agrees least on.
std::vector<std::size_t> by_digits(const Agreement& agreement) {
    std::vector<std::size_t> order(agreement.spots.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
        return agreement.spots[i].digits < agreement.spots[j].digits;
    });
    return order;
}

void add_refutation(const Agreement& agreement, const Spots& spots, const Expr& printed,
                    const Expr& exact, unsigned digits, Outcome& outcome) {
    std::string problem = "the printed formula has no value at any sample";
    std::size_t tried = 0;
    std::optional<Evidence> overlapping;
    for (const std::size_t i : by_digits(agreement)) {
        if (!agreement.spots[i].problem.empty()) {
            continue;
        }
        if (tried++ == tries) {
            break;
        }
        const Pair pair = pair_at(spots.all()[i], printed, exact, digits);
        if (!pair.printed || !pair.exact) {
            problem = pair.problem;
            continue;
        }
        Evidence e = both(pair, spots.all()[i].text, digits);
        if (disjoint(*pair.printed, *pair.exact)) {
            outcome.evidence.add("enclosures", std::move(e));
            return;
        }
        overlapping = std::move(e);
    }
    if (overlapping && agreement.undefined()) {
        // Refuted by having no value where it should have one, which no pair of balls shows.
        problem = "the printed formula has no value at a sample";
    } else if (overlapping) {
        outcome.verdict = Verdict::undecided;
        outcome.note = "the estimates have it differ, the enclosures do not";
        outcome.evidence.add("enclosures", std::move(*overlapping));
        return;
    }
    outcome.evidence.add("enclosures", Evidence().add("none", problem));
}

void add_confirmation(const Agreement& agreement, const Spots& spots, const Expr& printed,
                      const Expr& exact, unsigned digits, Outcome& outcome) {
    std::size_t count = 0;
    double least = 1e6;
    std::optional<Evidence> worst;
    std::string problem = "the exact value is zero";
    for (std::size_t i = 0; i < agreement.spots.size(); ++i) {
        const Pair pair = pair_at(spots.all()[i], printed, exact, digits);
        if (!pair.printed || !pair.exact) {
            problem = pair.problem;
            if (count == 0) {
                break; // what the first sample does not have, the others do not
            }
            continue;
        }
        if (const auto proved = proved_digits(*pair.printed, *pair.exact)) {
            ++count;
            if (!worst || *proved < least) {
                least = *proved;
                worst = both(pair, spots.all()[i].text, digits);
            }
        }
    }
    if (!worst) {
        outcome.evidence.add("enclosures", Evidence().add("none", problem));
        return;
    }
    worst->add("digits_proved", digits_text(std::min(least, 1.0 * digits))).add("samples", count);
    outcome.evidence.add("enclosures", std::move(*worst));
}

bool has_disjoint(const Outcome& outcome) {
    const EvidenceItem* item = outcome.evidence.find("enclosures");
    const auto* pair = item == nullptr ? nullptr : std::get_if<Evidence>(&item->value());
    const EvidenceItem* apart = pair == nullptr ? nullptr : pair->find("disjoint");
    return apart != nullptr && std::get<bool>(apart->value());
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

void add_enclosures(const Agreement& agreement, const Spots& spots, const Expr& printed,
                    const Expr& exact, unsigned digits, Outcome& outcome) {
    if (outcome.verdict == Verdict::refuted) {
        add_refutation(agreement, spots, printed, exact, digits, outcome);
    } else if (holds(outcome.verdict)) {
        add_confirmation(agreement, spots, printed, exact, digits, outcome);
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
            outcome.verdict = Verdict::undecided;
            outcome.note = "the estimates have it differ, the enclosures do not";
        }
    }
    outcome.evidence.add("enclosures", std::move(e));
}

} // namespace edgeproof
