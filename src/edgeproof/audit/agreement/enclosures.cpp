// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/enclosures.hpp"

#include "edgeproof/audit/enclosure/sample_in_balls.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/rounding/text.hpp"

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

/// Both formulas in balls at one sample, and the scale of their difference.
struct Pair {
    std::optional<Ball> printed;
    std::optional<Ball> exact;
    std::optional<Ball> scale;
    std::string problem;

    [[nodiscard]] bool apart() const { return printed && disjoint(*printed, *exact); }
    [[nodiscard]] std::optional<Confirmation> agreement(double digits) const {
        return Confirmation::agreement(*printed, *exact, *scale, digits);
    }
    /// Returns the greatest relative difference that the balls prove; 0 if they overlap.
    [[nodiscard]] Real proved_difference() const {
        return apart() ? Real(abs(*printed - *exact).lower() / scale->upper()) : Real(0);
    }
    /// Returns the digits to which any two numbers in the balls agree, relative to the scale.
    [[nodiscard]] double proved_digits() const {
        const Real most = abs(*printed - *exact).upper();
        if (most == 0) {
            return every_digit;
        }
        return certainly_positive(*scale)
                   ? Real(-log10(Real(most / scale->lower()))).convert_to<double>()
                   : -every_digit;
    }
    [[nodiscard]] Evidence evidence(const std::string& at, unsigned digits) const {
        return pair_evidence(at, "printed", *printed, "exact", *exact, digits);
    }
};

/// A printed formula and the exact one, at any sample.
class PairAtSamples {
public:
    PairAtSamples(const Expr& printed, const SampledComparison& with)
        : printed_(printed), with_(with), integrals_(has_binder(printed) || has_binder(with.exact)),
          digits_(with.digits), needed_(formula::bits_for(digits_)) {}

    [[nodiscard]] bool have_integrals() const { return integrals_; }
    [[nodiscard]] Pair at(std::size_t sample) const {
        return integrals_ ? integrals_at(sample) : values_at(sample);
    }

private:
    /// Increases the bits until the balls prove all digits; or that the formulas differ, and
    /// whether by more than a confirmation allows.
    [[nodiscard]] Pair values_at(std::size_t sample) const {
        Pair pair;
        const double needed = AuditContext::digits_needed(digits_);
        const Real allowed = pow(Real(10), -needed);
        for (long bits = 2 * needed_; bits <= 8 * needed_; bits *= 2) {
            if (!enclose(sample, bits, digits_, pair) ||
                (pair.apart() && (pair.agreement(needed) || pair.proved_difference() > allowed)) ||
                (pair.printed && pair.proved_digits() >= digits_)) {
                break;
            }
        }
        return pair;
    }
    /// The width of an integral's ball depends on the digits it aims at. The bits are doubled if
    /// there is no enclosure, and the digits are increased once if too many cancel.
    [[nodiscard]] Pair integrals_at(std::size_t sample) const {
        Pair pair;
        const unsigned aim = digits_ + spare_digits;
        for (long bits = 2 * needed_; bits <= 4 * needed_ && !pair.printed; bits *= 2) {
            if (!enclose(sample, bits, aim, pair)) {
                return pair;
            }
        }
        if (!pair.printed || pair.apart()) {
            return pair;
        }
        const double proved = pair.proved_digits();
        if (proved < AuditContext::digits_needed(digits_)) {
            const auto missing = static_cast<unsigned>(std::clamp(aim - proved, 0., 1. * digits_));
            enclose(sample, 4 * needed_, aim + missing, pair);
        }
        return pair;
    }
    /// Returns false if more bits are not useful.
    bool enclose(std::size_t index, long bits, unsigned aim, Pair& pair) const {
        try {
            const EnclosedSample& sample = with_.samples_at.enclosed(index, bits, aim);
            Ball x = sample.evaluate(printed_);
            Ball y = sample.evaluate(with_.exact);
            Ball size = scale_at(sample, y);
            if (!x.is_finite() || !y.is_finite() || !size.is_finite()) {
                pair.problem = "the balls do not exclude a point where it is undefined";
                return true;
            }
            pair = {std::move(x), std::move(y), std::move(size), std::move(pair.problem)};
            return true;
        } catch (const BudgetError& error) {
            pair.problem = error.what();
            return true;
        } catch (const Error& error) {
            pair.problem = error.what();
            return false;
        }
    }
    [[nodiscard]] Ball scale_at(const EnclosedSample& sample, const Ball& exact) const {
        if (with_.scale) {
            return abs(sample.evaluate(*with_.scale));
        }
        if (!contains_zero(exact)) {
            return abs(exact);
        }
        try {
            return scale_of_terms(printed_, sample) + scale_of_terms(with_.exact, sample);
        } catch (const Error&) {
            return abs(exact); // no scale is known: only numbers that are exactly zero agree
        }
    }

    const Expr& printed_;
    const SampledComparison& with_;
    bool integrals_;
    unsigned digits_;
    long needed_; ///< bits
};

/// Returns the indices, beginning with the sample of least agreement.
std::vector<std::size_t> by_digits(const Agreement& agreement) {
    std::vector<std::size_t> order(agreement.samples_at.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [&](std::size_t i, std::size_t j) {
        return agreement.samples_at[i].digits() < agreement.samples_at[j].digits();
    });
    return order;
}

/// Searches for a refutation at the samples where the values in Real differ most.
std::optional<Refutation> find_refutation(const PairAtSamples& pairs, const SampledComparison& with,
                                          Evidence& evidence) {
    std::size_t tried = 0;
    for (const std::size_t i : by_digits(with.agreement)) {
        const SampleAgreement& there = with.agreement.samples_at[i];
        if (there.no_value() != nullptr) {
            continue;
        }
        if (there.digits() >= AuditContext::digits_needed(with.digits) ||
            tried++ == (pairs.have_integrals() ? tries_of_integrals : tries)) {
            break;
        }
        const Pair pair = pairs.at(i);
        if (!pair.printed || pair.agreement(AuditContext::digits_needed(with.digits))) {
            continue;
        }
        if (const auto found = Refutation::disjoint(*pair.printed, *pair.exact)) {
            evidence.add("enclosures", pair.evidence(with.samples_at.all()[i].text, with.digits));
            return found;
        }
    }
    return std::nullopt;
}

/// Returns the samples at which a confirmation is enclosed: all; for integrals, those that agree
/// least (including all that do not agree in Real) and some of the others.
std::vector<std::size_t> chosen(const SampledComparison& with, bool have_integrals) {
    std::vector<std::size_t> order = by_digits(with.agreement);
    const auto doubtful = static_cast<std::size_t>(std::ranges::count_if(order, [&](std::size_t i) {
        return with.agreement.samples_at[i].digits() < AuditContext::digits_needed(with.digits);
    }));
    const std::size_t first = std::max(worst_of_integrals, doubtful);
    if (have_integrals && order.size() > first + others_of_integrals) {
        const std::size_t rest = order.size() - first;
        for (std::size_t k = 1; k <= others_of_integrals; ++k) {
            order[first + k - 1] = order[first + k * rest / others_of_integrals - 1];
        }
        order.resize(first + others_of_integrals);
    }
    std::ranges::sort(order);
    return order;
}

} // namespace

std::string_view name_of(Basis basis) {
    static constexpr std::array<std::string_view, all_bases.size()> names{
        "theorem", "identity", "enclosures", "text", "none"};
    return names.at(static_cast<std::size_t>(basis));
}

Basis basis_of(const ClaimResult& result) {
    const Verdict verdict = result.outcome.verdict;
    if (result.certificate && result.certificate->whole_verdict && result.certificate->accepted) {
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

std::string verdict_text(const ClaimResult& result) {
    const CheckKind* kind = find_check_kind(result.claim.kind);
    const bool at_samples = result.outcome.verdict == Verdict::confirmed &&
                            basis_of(result) == Basis::enclosures &&
                            (kind == nullptr || kind->sampled);
    return std::string(name_of(result.outcome.verdict)) + (at_samples ? " at the samples" : "");
}

Decision compare_by_enclosures(const Expr& printed, const SampledComparison& with,
                               Outcome& outcome) {
    const PairAtSamples pairs(printed, with);
    const double needed = AuditContext::digits_needed(with.digits);
    std::optional<Confirmation> all;
    std::size_t count = 0;
    double least = every_digit;
    std::optional<Evidence> worst;
    Real difference = 0; // the greatest that is proved
    std::string where;
    for (const std::size_t i : chosen(with, pairs.have_integrals())) {
        check_interruption();
        const Pair pair = pairs.at(i);
        const std::string& at = with.samples_at.all()[i].text;
        if (!pair.printed) {
            outcome.note = "no enclosure: " + pair.problem;
            outcome.evidence.add("enclosures", Evidence().add("none", pair.problem));
            return {};
        }
        const auto holds = pair.agreement(needed);
        const auto apart = Refutation::disjoint(*pair.printed, *pair.exact);
        if (apart && !holds) {
            outcome.evidence.add("enclosures", pair.evidence(at, with.digits));
            return *apart;
        }
        const double proved = pair.proved_digits();
        if (!holds) {
            outcome.note = "the enclosures prove " + digits_text(proved) + " of " +
                           digits_text(needed) + " digits at " + at;
            outcome.evidence.add("enclosures", pair.evidence(at, with.digits));
            return {};
        }
        all = holds;
        ++count;
        if (pair.proved_difference() > difference) {
            difference = pair.proved_difference();
            where = at;
        }
        if (!worst || proved < least) {
            least = proved;
            worst = pair.evidence(at, with.digits);
        }
    }
    if (worst) {
        // The digits are rounded down to a tenth.
        const double tenths = std::floor(std::min(least, 1.0 * with.digits) * 10) / 10;
        worst->add("digits_proved", digits_text(tenths)).add("samples", count);
        outcome.evidence.add("enclosures", std::move(*worst));
        outcome.note = "agrees at " + std::to_string(count) + (count == 1 ? " sample" : " samples");
    }
    if (difference > 0) {
        outcome.note +=
            "; not identical: differs by " + to_decimal(difference, 2) + " of the value, " + where;
    }
    return decision(std::nullopt, all);
}

bool provably_different(const Expr& made, SampledComparison with) {
    if (!has_binder(made) && !has_binder(with.exact)) { // integrals would take too long
        with.digits *= 2;
    }
    const PairAtSamples pairs(made, with);
    return std::ranges::any_of(chosen(with, pairs.have_integrals()),
                               [&](std::size_t i) { return pairs.at(i).apart(); });
}

Judgement judge_by_enclosures(const ExactFormula& printed, const SampledComparison& with,
                              Outcome& outcome) {
    const PairAtSamples pairs(printed.expr(), with);
    if (const auto fails = find_refutation(pairs, with, outcome.evidence)) {
        return Judgement(*fails);
    }
    if (with.agreement.without_value() > 0) {
        outcome.note = with.agreement.obstacle(AuditContext::digits_needed(with.digits));
        return Undecided::underspecified;
    }
    return Judgement(compare_by_enclosures(printed.expr(), with, outcome));
}

Evidence pair_evidence(const std::string& at, std::string_view first_name, const Ball& first,
                       std::string_view second_name, const Ball& second, unsigned digits) {
    return Evidence()
        .add("at", at)
        .add(first_name, ball_text(first, digits))
        .add(second_name, ball_text(second, digits))
        .add("disjoint", disjoint(first, second));
}

Evidence pair_evidence(const std::string& at, std::string_view first_name, const Enclosed& first,
                       std::string_view second_name, const Enclosed& second, unsigned digits) {
    if (!first.ball || !second.ball) {
        return Evidence().add("none", first.ball ? second.problem : first.problem);
    }
    return pair_evidence(at, first_name, *first.ball, second_name, *second.ball, digits);
}

} // namespace edgeproof::audit
