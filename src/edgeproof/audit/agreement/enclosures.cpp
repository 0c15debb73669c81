// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/agreement/enclosures.hpp"

#include "edgeproof/audit/enclosure/sample_in_balls.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace edgeproof::audit {
namespace {

constexpr std::size_t enclosed_integrals = 8; // samples with all digits for formulas with integrals
constexpr unsigned screening_digits = 12;     // at the other samples
constexpr unsigned spare_digits = 2;          // added to the aim of integrals
constexpr double every_digit = 1e6;           // for numbers that are exactly equal
constexpr unsigned condition_digits = 15;     // for `where`
constexpr long most_spread = 50'000;          // bits
constexpr long most_spread_of_integrals = 1500;

/// Returns the last term of a sum of terms; of an approximation a power as small as it.
std::optional<Expr> last_term(const Expr& e) {
    if (e.kind() == Expr::Kind::sum) {
        return substitute(e.arg(0), e.arg(1).name(), e.arg(3));
    }
    const auto name = [](const char* text) { return Expr::symbol(text); };
    if (e.name() == "right_local") {
        return pow((name("a") - e.arg(1)) / name("L"), e.arg(0));
    }
    return e.name() == "left_local"
               ? std::optional(pow((e.arg(1) + name("b")) / name("L"), e.arg(0)))
               : std::nullopt;
}

/// A printed formula and the exact one, at any sample.
class PairAtSamples {
public:
    PairAtSamples(const Expr& printed, const SampledComparison& with)
        : printed_(printed), with_(with), integrals_(has_binder(printed) || has_binder(with.exact)),
          digits_(with.digits), needed_(formula::bits_for(digits_)) {}

    [[nodiscard]] bool have_integrals() const { return integrals_; }
    [[nodiscard]] Pair at(std::size_t sample) const {
        Pair pair;
        pair.sample = sample;
        enclose(pair);
        if (!pair.printed && pair.exact) {
            pair.no_value = no_value_of(printed_, with_.samples.all()[sample], 2 * needed_);
        }
        return pair;
    }
    /// The pair with so many bits that the smallest parts of the formulas count; nothing if they
    /// count in the first balls.
    [[nodiscard]] std::optional<Pair> closer(std::size_t sample) const {
        const EnclosedSample& first = with_.samples.enclosed(sample, 2 * needed_, aim());
        const long spread =
            std::max(spread_of_parts(printed_, first), spread_of_parts(with_.exact, first));
        if (spread <= needed_) {
            return {};
        }
        Pair pair;
        pair.sample = sample;
        const long bits = 2 * (needed_ + spread);
        const auto digits = static_cast<unsigned>(
            integrals_ ? std::min(spread, most_spread_of_integrals) * 3 / 10 : 0);
        pair.problem = look_closer(
            [&](long enough) {
                enclose(enough, aim() + digits, pair);
                return true;
            },
            {bits, bits});
        return pair;
    }

private:
    [[nodiscard]] unsigned aim() const { return digits_ + (integrals_ ? spare_digits : 0); }
    /// Increases the bits until the balls prove all digits; or that the formulas differ, and
    /// whether by more than a confirmation allows. The width of an integral's ball depends on the
    /// digits it aims at: the bits are doubled if there is no enclosure, and the digits are
    /// increased once if too many cancel.
    void enclose(Pair& pair) const {
        const double needed = AuditContext::digits_needed(digits_);
        const Real allowed = pow(Real(10), -needed);
        const auto decided = [&](long bits) {
            enclose(bits, aim(), pair);
            return integrals_ || pair.digits() >= digits_ ||
                   (pair.apart() && (pair.agreement(needed) || pair.proved_difference() > allowed));
        };
        pair.problem = look_closer(decided, {2 * needed_, (integrals_ ? 4 : 8) * needed_});
        const double proved = pair.digits();
        if (integrals_ && pair.printed && !pair.apart() && proved < needed) {
            const auto missing =
                static_cast<unsigned>(std::clamp(aim() - proved, 0., 1. * digits_));
            try {
                enclose(4 * needed_, aim() + missing, pair);
            } catch (const BudgetError& error) {
                pair.problem = error.what();
            }
        }
    }
    /// Throws Error if there is no enclosure.
    void enclose(long bits, unsigned aim, Pair& pair) const {
        const EnclosedSample& sample = with_.samples.enclosed(pair.sample, bits, aim);
        Ball y = sample.finite(with_.exact);
        pair.exact = pair.printed ? pair.exact : std::optional(y);
        Ball x = sample.finite(printed_);
        Ball size = scale_at(sample, y);
        if (!size.is_finite()) {
            throw BudgetError("the scale is not enclosed");
        }
        pair.printed = std::move(x);
        pair.exact = std::move(y);
        pair.scale = std::move(size);
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

/// Returns the order in which samples are enclosed, and the number of them that are enclosed with
/// all digits in any case.
std::pair<std::vector<std::size_t>, std::size_t> order_of(std::size_t samples, bool integrals) {
    const std::size_t first = integrals ? std::min(samples, enclosed_integrals) : samples;
    return {spread_first(samples, first), first};
}

} // namespace

long spread_of_parts(const Expr& e, const EnclosedSample& at) {
    long least = 0;
    long most = 0;
    static_cast<void>(any_part(e, [&](const Expr& part) {
        if (const Rational* q = part.rational()) { // 1 + 1e-300 has a denominator of 300 digits
            least = std::min(least, -static_cast<long>(msb(denominator(*q))));
            most = std::max(most, *q == 0 ? 0L : static_cast<long>(msb(abs(numerator(*q)))));
        }
        const Expr there = last_term(part).value_or(part);
        if (there.is_binder() || holds_function(there)) {
            return false;
        }
        try {
            const Ball x = at.evaluate(there);
            if (x.is_finite() && !contains_zero(x)) {
                const long size = arf_abs_bound_lt_2exp_si(arb_midref(x.data()));
                least = std::min(least, size);
                most = std::max(most, size);
            }
        } catch (const Error&) { // it has the variable of an integral, or no value
        }
        return false;
    }));
    return std::min(most - least, most_spread);
}

bool is_admitted(const Claim& claim, const Sample& sample) {
    if (!claim.has("where")) {
        return true;
    }
    SampleInBalls in_balls(sample, condition_digits);
    return confirms(decide(claim.condition("where"), in_balls, condition_digits));
}

ClaimSamples::ClaimSamples(const Claim& claim, const AuditContext& context) {
    for (Sample& sample : context.different_samples(claim)) {
        // A sample on the boundary of the condition does not decide and is left out.
        if (is_admitted(claim, sample)) {
            samples_.push_back(std::move(sample));
        } else {
            ++left_out_;
        }
    }
}

std::size_t ClaimSamples::scenes() const {
    std::set<std::string> texts;
    for (const Sample& sample : samples_) {
        texts.insert(full_text(sample.scene));
    }
    return texts.size();
}

const EnclosedSample& ClaimSamples::enclosed(std::size_t sample, long bits,
                                             unsigned integral_digits) const {
    const std::tuple key(sample, bits, integral_digits);
    const auto it = enclosed_.find(key);
    return it != enclosed_.end()
               ? it->second
               : enclosed_.emplace(key, EnclosedSample(samples_[sample], bits, integral_digits))
                     .first->second;
}

std::string digits_text(double digits) {
    if (digits >= every_digit) {
        return "all";
    }
    return digits <= -every_digit ? "none" : fmt::format("{:.1f}", digits);
}

std::string value_text(const Real& value, unsigned digits) {
    return value.str(static_cast<std::streamsize>(digits), std::ios_base::scientific);
}

std::optional<Confirmation> Pair::agreement(double digits) const {
    return printed ? Confirmation::agreement(*printed, *exact, *scale, digits) : std::nullopt;
}

std::optional<Refutation> Pair::refutation(double digits) const {
    return apart() && !agreement(digits) ? Refutation::disjoint(*printed, *exact) : std::nullopt;
}

Real Pair::proved_difference() const {
    return apart() ? Real(abs(*printed - *exact).lower() / scale->upper()) : Real(0);
}

double Pair::digits() const {
    if (!printed) {
        return -every_digit;
    }
    const Real most = abs(*printed - *exact).upper();
    if (most == 0) {
        return every_digit;
    }
    return certainly_positive(*scale)
               ? Real(-log10(Real(most / scale->lower()))).convert_to<double>()
               : -every_digit;
}

Agreement::Agreement(const Expr& printed, const SampledComparison& with)
    : printed_(printed), with_(with) {
    const PrecisionScope scope(with_.digits + 20);
    const PairAtSamples at(printed, with);
    const auto [order, first] = order_of(with_.samples.all().size(), at.have_integrals());
    const double needed = AuditContext::digits_needed(with_.digits);
    SampledComparison few = with;
    few.digits = screening_digits;
    const PairAtSamples screening(printed, few);
    for (std::size_t k = 0; k < order.size(); ++k) {
        check_interruption();
        if (k >= first &&
            screening.at(order[k]).agreement(AuditContext::digits_needed(few.digits))) {
            ++screened_;
            continue;
        }
        pairs_.push_back(at.at(order[k]));
        if (k >= first && pairs_.back().refutation(needed)) {
            break; // one is enough
        }
    }
    std::ranges::sort(pairs_, {}, &Pair::sample);
}

const Pair& Agreement::worst() const {
    return *std::ranges::min_element(pairs_, {}, &Pair::digits);
}

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
    const bool quoted = result.claim.kind == "compare" && result.claim.has("quoted");
    const bool at_samples = result.outcome.verdict == Verdict::confirmed &&
                            basis_of(result) == Basis::enclosures && !quoted;
    return std::string(name_of(result.outcome.verdict)) + (at_samples ? " at the samples" : "");
}

Evidence Agreement::evidence(const Pair& pair) const {
    return pair_evidence(full_text(with_.samples.all()[pair.sample]), "printed", *pair.printed,
                         "exact", *pair.exact, with_.digits);
}

Decision Agreement::decide(Outcome& outcome) const {
    const double needed = AuditContext::digits_needed(with_.digits);
    const auto refuted = std::ranges::find_if(
        pairs_, [&](const Pair& pair) { return pair.refutation(needed).has_value(); });
    if (refuted != pairs_.end()) {
        const auto most = std::ranges::min_element(pairs_, {}, [&](const Pair& pair) {
            return pair.refutation(needed) ? pair.digits() : 2 * every_digit;
        });
        outcome.evidence["enclosures"] = evidence(*most);
        return *most->refutation(needed);
    }
    std::optional<Confirmation> all;
    const Pair* differing = nullptr;
    for (const Pair& pair : pairs_) {
        if (!pair.printed) {
            outcome.note = "no enclosure: " + pair.problem;
            outcome.evidence["enclosures"]["none"] = pair.problem;
            return {};
        }
        all = pair.agreement(needed);
        if (!all) {
            outcome.note = "the enclosures prove " + digits_text(pair.digits()) + " of " +
                           digits_text(needed) + " digits at " +
                           full_text(with_.samples.all()[pair.sample]);
            outcome.evidence["enclosures"] = evidence(pair);
            return {};
        }
        if (pair.apart() &&
            (differing == nullptr || differing->proved_difference() < pair.proved_difference())) {
            differing = &pair;
        }
    }
    std::optional<Pair> closer;
    for (std::size_t k = 0; k < pairs_.size() && differing == nullptr && !with_.identical; ++k) {
        closer = PairAtSamples(printed_, with_).closer(pairs_[k].sample);
        differing = closer && closer->apart() ? &*closer : nullptr;
    }
    if (!pairs_.empty()) {
        // The digits are rounded down to a tenth.
        const double tenths = std::floor(std::min(worst().digits(), 1.0 * with_.digits) * 10) / 10;
        Evidence& enclosures = outcome.evidence["enclosures"] = evidence(worst());
        enclosures["digits_proved"] = digits_text(tenths);
        enclosures["samples"] = pairs_.size();
        outcome.note = "agrees at " + std::to_string(pairs_.size()) +
                       (pairs_.size() == 1 ? " sample" : " samples");
    }
    if (differing != nullptr) {
        outcome.note += "; not identical: differs by " +
                        to_decimal(differing->proved_difference(), 2) + " of the value, " +
                        full_text(with_.samples.all()[differing->sample]);
    }
    return decision(std::nullopt, all);
}

std::string Agreement::without_value() const {
    const auto has_none = [](const Pair& pair) { return pair.no_value.has_value(); };
    const auto count = static_cast<std::size_t>(std::ranges::count_if(pairs_, has_none));
    if (count == 0) {
        return {};
    }
    const std::string& why = *std::ranges::find_if(pairs_, has_none)->no_value;
    if (count == pairs_.size()) {
        return "has no value as printed: " + why;
    }
    const bool others_agree = std::ranges::all_of(pairs_, [&](const Pair& pair) {
        return pair.no_value || pair.agreement(AuditContext::digits_needed(with_.digits));
    });
    return fmt::format("has no value as printed at {} of {} samples: {}; {} at the others", count,
                       pairs_.size(), why, others_agree ? "agrees" : "not decided");
}

Judgement Agreement::judge(Outcome& outcome) const {
    const Decision found = decide(outcome);
    if (const std::string none = without_value(); !none.empty() && !refutes(found)) {
        outcome.note = none;
        return Judgement::underspecified();
    }
    return Judgement(found);
}

bool provably_different(const Expr& made, SampledComparison with) {
    if (!has_binder(made) && !has_binder(with.exact)) { // integrals would take too long
        with.digits *= 2;
    }
    const PairAtSamples pairs(made, with);
    const auto [order, first] = order_of(with.samples.all().size(), pairs.have_integrals());
    return std::any_of(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(first),
                       [&](std::size_t i) { return pairs.at(i).apart(); });
}

Evidence pair_evidence(const std::string& at, std::string_view first_name, const Ball& first,
                       std::string_view second_name, const Ball& second, unsigned digits) {
    return {{"at", at},
            {first_name, ball_text(first, digits)},
            {second_name, ball_text(second, digits)},
            {"disjoint", disjoint(first, second)}};
}

} // namespace edgeproof::audit
