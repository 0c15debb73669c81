// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/samples.hpp"

#include "edgeproof/audit/enclosure/sample_in_balls.hpp"
#include "edgeproof/audit/sample/naive_integral.hpp"
#include "edgeproof/formula/magnitude.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace edgeproof::audit {
namespace {

constexpr double all_digits = 1e6;

double digits_of_ratio(const Real& difference, const Real& scale) {
    if (difference == 0) {
        return all_digits;
    }
    if (scale == 0) {
        return -all_digits;
    }
    return (-log10(Real(difference / scale))).convert_to<double>();
}

/// Returns the distance of a sample from a fifth of the contact's length, in decades.
double away_from(const Sample& sample) {
    return sample.fraction ? std::abs(std::log10(5 * sample.fraction->to<double>())) : 0;
}

constexpr unsigned condition_digits = 15;

bool certainly_holds(const Condition& where, const Sample& sample) {
    SampleInBalls in_balls(sample, condition_digits);
    return confirms(decide(where, in_balls, condition_digits));
}

/// Returns a key with everything on which the samples depend.
std::string sampling_key(const Claim& claim, unsigned digits, std::size_t most) {
    std::string key = fmt::format("samples/{}/{}/{}/{}/{}", digits, most, claim.text("over"),
                                  claim.text_or("edge", "right"), claim.text_or("points", ""));
    if (claim.has("where")) {
        for (const Relation& r : claim.condition("where")) {
            key += fmt::format("/{} {} {}", to_text(r.lhs), static_cast<int>(r.op), to_text(r.rhs));
        }
    }
    if (claim.has("vary")) {
        key += "/" + claim.id; // the drawn samples depend on the id
        for (const auto& [name, values] : claim.table("vary")) {
            key += fmt::format("/{} = {}", name, fmt::join(values, ", "));
        }
    }
    return key;
}

/// True if the values in Real differ by more than their errors: then balls must decide.
bool seems_different(const SampleAgreement& s, double digits_needed) {
    const ValuePair* v = s.values();
    return v != nullptr && v->digits < digits_needed && abs(v->printed - v->exact) > v->error;
}

} // namespace

double SampleAgreement::digits() const {
    const ValuePair* both = values();
    return both == nullptr ? -all_digits : both->digits;
}

std::string SampleAgreement::problem() const {
    if (const NoValue* none = no_value()) {
        return none->why;
    }
    return limit() != nullptr ? limit()->what : "";
}

bool Agreement::to(double digits) const {
    return !samples_at.empty() && std::ranges::all_of(samples_at, [&](const SampleAgreement& s) {
        return s.values() != nullptr && s.digits() >= digits;
    });
}

SampleUse Agreement::use(double digits_needed) const {
    SampleUse use;
    use.samples = samples_at.size();
    for (std::size_t i = 0; i < samples_at.size(); ++i) {
        if (seems_different(samples_at[i], digits_needed)) {
            use.first_refuting = use.refuting++ == 0 ? i + 1 : use.first_refuting;
        }
        const double digits = samples_at[i].digits();
        if (i == 0 || digits < use.digits) {
            use.worst = i + 1;
            use.digits = digits;
        }
        if (i < (samples_at.size() + 1) / 2) {
            use.first_half_digits = use.digits;
        }
    }
    return use;
}

std::size_t Agreement::without_value() const {
    return static_cast<std::size_t>(std::ranges::count_if(
        samples_at, [](const SampleAgreement& s) { return s.no_value() != nullptr; }));
}

bool Agreement::limited() const {
    return std::ranges::any_of(samples_at,
                               [](const SampleAgreement& s) { return s.limit() != nullptr; });
}

std::string Agreement::obstacle(double digits_needed) const {
    const auto first = [&](auto&& is) {
        const auto it = std::ranges::find_if(samples_at, is);
        return it == samples_at.end() ? nullptr : &*it;
    };
    if (const auto* none = first([](const auto& s) { return s.no_value() != nullptr; })) {
        const bool others_agree = std::ranges::all_of(samples_at, [&](const SampleAgreement& s) {
            return s.no_value() != nullptr || s.digits() >= digits_needed;
        });
        const std::size_t count = without_value();
        return (count == samples_at.size()
                    ? std::string("has no value as printed")
                    : fmt::format("has no value as printed at {} of {} samples", count,
                                  samples_at.size())) +
               (none->no_value()->proved ? ": " : ", by an estimate: ") + none->problem() +
               (count == samples_at.size() ? ""
                : others_agree             ? "; agrees at the others"
                                           : "; not decided at the others");
    }
    if (const auto* limit = first([](const auto& s) { return s.limit() != nullptr; })) {
        return "not evaluated here: " + limit->problem();
    }
    return "the values are not good enough to decide";
}

std::shared_ptr<EvaluatedSamples> EvaluatedSamples::of(const Claim& claim,
                                                       const AuditContext& context, unsigned digits,
                                                       std::size_t most, Effort effort) {
    return context.borrow<EvaluatedSamples>(
        sampling_key(claim, digits, most) + (effort == Effort::screening ? "/screening" : ""),
        [&] { return std::make_unique<EvaluatedSamples>(claim, context, digits, most, effort); });
}

EvaluatedSamples::EvaluatedSamples(const Claim& claim, const AuditContext& context, unsigned digits,
                                   std::size_t most, Effort effort)
    : digits_(digits), context_(context) {
    std::optional<Condition> where;
    if (claim.has("where")) {
        where = claim.condition("where");
    }
    std::vector<Sample> samples = context.samples(claim);
    if (effort == Effort::screening) {
        // Samples far from the edge come first, as integrals converge fastest there.
        std::ranges::stable_sort(
            samples, [](const Sample& x, const Sample& y) { return away_from(x) < away_from(y); });
    }
    std::map<std::string, const EvaluatedScene*> of_scene;
    for (const std::size_t i : spread_first(samples.size(), effort == Effort::full ? most : 0)) {
        const Sample& sample = samples[i];
        if (most != 0 && samples_at_.size() >= most) {
            break;
        }
        const std::string scene = full_text(sample.scene);
        const EvaluatedScene*& known = of_scene[scene];
        if (known == nullptr) {
            known =
                scene_values_
                    .emplace_back(std::make_unique<EvaluatedScene>(sample.scene, digits, effort))
                    .get();
        }
        const EvaluatedScene& scene_values = *known;
        EvaluatedSample sample_at{&scene_values, std::nullopt, {}, full_text(sample), sample};
        if (sample.fraction) {
            sample_at.place = scene_values.place(sample.edge, *sample.fraction);
        }
        sample_at.variables = scene_values.values_of(sample.variables);
        // A sample on the boundary of the condition does not decide and is left out.
        if (where && (!scene_values.holds(*where, sample_at.place ? &*sample_at.place : nullptr,
                                          sample_at.variables) ||
                      !certainly_holds(*where, sample))) {
            ++left_out_;
            continue;
        }
        samples_at_.push_back(std::move(sample_at));
    }
    caches_.resize(samples_at_.size());
}

FormulaValue EvaluatedSamples::known(const Expr& e, std::size_t sample_at) {
    IntegralCache& cache = caches_[sample_at];
    if (const auto it = cache.find(e); it != cache.end()) {
        return it->second;
    }
    FormulaValue value = samples_at_[sample_at].evaluate(e, &cache);
    // An integral may have an entry from evaluate, without digits; replace it.
    cache.insert_or_assign(e, value);
    return value;
}

const EnclosedSample& EvaluatedSamples::enclosed(std::size_t sample_at, long bits,
                                                 unsigned integral_digits) const {
    const std::tuple key(sample_at, bits, integral_digits);
    const auto it = enclosed_.find(key);
    return it != enclosed_.end() ? it->second
                                 : enclosed_
                                       .emplace(key, EnclosedSample(samples_at_[sample_at].sample,
                                                                    bits, integral_digits))
                                       .first->second;
}

SampleAgreement EvaluatedSamples::compare_at(std::size_t i, const Expr& printed, const Expr& exact,
                                             const std::optional<Expr>& scale) {
    bool have_exact = false;
    try {
        const FormulaValue x = known(exact, i);
        have_exact = true;
        const FormulaValue y = value(printed, i);
        if (!isfinite(x.value) || !isfinite(y.value)) {
            return OurLimit{"a number beyond the range of the arithmetic"};
        }
        if (!x.converged || !y.converged) {
            return OurLimit{"an integral did not converge"};
        }
        const Real difference = abs(y.value - x.value);
        Real against = abs(x.value);
        if (scale) {
            against = abs(known(*scale, i).value);
        } else if (difference != 0) {
            // If the exact value is zero except for roundoff, compare with the terms.
            const Real terms =
                magnitude(printed, [&](const Expr& part) { return this->value(part, i).value; });
            if (against < terms * pow(Real(10), -static_cast<int>(digits_))) {
                against = terms;
            }
        }
        if (!isfinite(against)) {
            return OurLimit{"a number beyond the range of the arithmetic"};
        }
        // Three digits of margin are used, because errors of quadratures are estimates.
        const int good = static_cast<int>(std::min(x.digits, y.digits));
        return ValuePair{y.value, x.value, digits_of_ratio(difference, against),
                         Real(against * pow(Real(10), 3 - good))};
    } catch (const DivergentIntegral& error) {
        return have_exact ? SampleAgreement(NoValue{error.what(), false})
                          : SampleAgreement(OurLimit{error.what()});
    } catch (const DomainError& error) {
        if (have_exact) {
            if (auto none = no_value_of(printed, samples_at_[i])) {
                return std::move(*none);
            }
        }
        return OurLimit{error.what()};
    } catch (const BudgetError& error) {
        return OurLimit{error.what()};
    }
}

Agreement EvaluatedSamples::compare(const Expr& printed, const Expr& exact,
                                    const std::optional<Expr>& scale) {
    Agreement agreement;
    const PrecisionScope scope(digits_ + 20);
    for (std::size_t i = 0; i < samples_at_.size(); ++i) {
        check_interruption();
        agreement.samples_at.push_back(compare_at(i, printed, exact, scale));
        if (agreement.samples_at.back().digits() < agreement.samples_at[agreement.worst].digits()) {
            agreement.worst = agreement.samples_at.size() - 1;
        }
    }
    return agreement;
}

std::string digits_text(double digits) {
    if (digits >= all_digits) {
        return "all";
    }
    return digits <= -all_digits ? "none" : fmt::format("{:.1f}", digits);
}

std::string value_text(const Real& value, unsigned digits) {
    return value.str(static_cast<std::streamsize>(digits), std::ios_base::scientific);
}

} // namespace edgeproof::audit
