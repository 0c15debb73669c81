// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/spots.hpp"

#include "edgeproof/audit/magnitude.hpp"
#include "edgeproof/audit/undefined.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace edgeproof {
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

/// How far, on the scale of logarithms, a sample is from a fifth of the contact's length.
double away_from(const Sample& sample) {
    return sample.fraction ? std::abs(std::log10(5 * sample.fraction->to<double>())) : 0;
}

/// All that the samples of a claim depend on.
std::string sampling_key(const Claim& claim, unsigned digits, std::size_t most) {
    std::string key = fmt::format("spots/{}/{}/{}/{}/{}", digits, most, claim.text("over"),
                                  claim.text_or("edge", "right"), claim.text_or("points", ""));
    if (claim.has("where")) {
        for (const Relation& r : claim.condition("where")) {
            key += fmt::format("/{} {} {}", to_text(r.lhs), static_cast<int>(r.op), to_text(r.rhs));
        }
    }
    if (claim.has("vary")) {
        key += "/" + claim.id; // what is drawn depends on it
        for (const auto& [name, values] : claim.table("vary")) {
            key += fmt::format("/{} = {}", name, fmt::join(values, ", "));
        }
    }
    return key;
}

} // namespace

bool Agreement::to(double digits) const {
    return !spots.empty() && std::all_of(spots.begin(), spots.end(), [&](const SpotAgreement& s) {
        return s.problem.empty() && s.digits >= digits;
    });
}

bool Agreement::undefined() const {
    const auto any = [&](Undefined why) {
        return std::any_of(spots.begin(), spots.end(),
                           [&](const SpotAgreement& s) { return s.undefined && s.why == why; });
    };
    if (any(Undefined::beyond_roundoff)) {
        return true;
    }
    constexpr double anything_like = 3;
    return !any(Undefined::by_roundoff) && any(Undefined::unknown) &&
           std::all_of(spots.begin(), spots.end(), [](const SpotAgreement& s) {
               return s.undefined || s.digits < anything_like;
           });
}

bool Agreement::differ(double digits_needed) const {
    // Three digits of margin: errors of quadratures are estimates.
    return std::any_of(spots.begin(), spots.end(), [&](const SpotAgreement& s) {
        return s.problem.empty() && s.digits < digits_needed && s.digits + 3 < s.good_digits;
    });
}

std::shared_ptr<Spots> Spots::of(const Claim& claim, const AuditContext& context, unsigned digits,
                                 std::size_t most, Effort effort) {
    return context.borrow<Spots>(
        sampling_key(claim, digits, most) + (effort == Effort::screening ? "/screening" : ""),
        [&] { return std::make_unique<Spots>(claim, context, digits, most, effort); });
}

Spots::Spots(const Claim& claim, const AuditContext& context, unsigned digits, std::size_t most,
             Effort effort)
    : digits_(digits), context_(context) {
    std::optional<Condition> where;
    if (claim.has("where")) {
        where = claim.condition("where");
    }
    std::vector<Sample> samples = context.samples(claim);
    if (effort == Effort::screening) {
        // Away from the edge first: there integrals converge soonest.
        std::stable_sort(samples.begin(), samples.end(), [](const Sample& x, const Sample& y) {
            return away_from(x) < away_from(y);
        });
    }
    std::map<std::string, const Setting*> of_scene;
    for (const std::size_t i : spread_first(samples.size(), effort == Effort::full ? most : 0)) {
        const Sample& sample = samples[i];
        if (most != 0 && spots_.size() >= most) {
            break;
        }
        const std::string scene = sample.scene.family + ": " + sample.scene.text();
        const Setting*& known = of_scene[scene];
        if (known == nullptr) {
            known = settings_.emplace_back(std::make_unique<Setting>(sample.scene, digits, effort))
                        .get();
        }
        const Setting& setting = *known;
        Spot spot{&setting, std::nullopt, {}, sample.scene.family + ": " + sample.text(), sample};
        if (sample.fraction) {
            spot.place = setting.place(sample.edge, *sample.fraction);
        }
        spot.variables = setting.values_of(sample.variables);
        if (where && !setting.holds(*where, spot.place ? &*spot.place : nullptr, spot.variables)) {
            ++left_out_;
            continue;
        }
        spots_.push_back(std::move(spot));
    }
    caches_.resize(spots_.size());
}

FormulaValue Spots::known(const Expr& e, std::size_t spot) {
    IntegralCache& cache = caches_[spot];
    if (const auto it = cache.find(e); it != cache.end()) {
        return it->second;
    }
    FormulaValue value = spots_[spot].evaluate(e, &cache);
    // Not emplace: an integral has been kept already on the way, without the digits of the whole.
    cache.insert_or_assign(e, value);
    return value;
}

Agreement Spots::compare(const Expr& printed, const Expr& exact, const std::optional<Expr>& scale) {
    Agreement agreement;
    bool beyond_roundoff = false;
    const PrecisionScope scope(digits_ + 20);
    for (std::size_t i = 0; i < spots_.size(); ++i) {
        check_interruption();
        SpotAgreement s;
        try {
            const FormulaValue x = known(exact, i);
            s.undefined = true; // if what comes next throws
            const FormulaValue y = value(printed, i);
            s.undefined = false;
            s.exact = x.value;
            s.printed = y.value;
            s.good_digits = std::min(x.digits, y.digits);
            if (!x.converged || !y.converged) {
                s.problem = "an integral did not converge";
            }
            const Real difference = abs(s.printed - s.exact);
            Real against = abs(s.exact);
            if (scale) {
                against = abs(known(*scale, i).value);
            } else if (difference != 0) {
                // Where the exact value is zero but for roundoff, hold it against its terms.
                const Real terms = magnitude(
                    printed, [&](const Expr& part) { return this->value(part, i).value; });
                if (against < terms * pow(Real(10), -static_cast<int>(digits_))) {
                    against = terms;
                }
            }
            s.digits = digits_of_ratio(difference, against);
        } catch (const DomainError& error) {
            s.problem = error.what();
            s.digits = -all_digits;
            if (s.undefined && !beyond_roundoff) { // once will do
                s.why = why_undefined(printed, spots_[i]);
                beyond_roundoff = s.why == Undefined::beyond_roundoff;
            }
        }
        agreement.spots.push_back(std::move(s));
        if (agreement.spots.back().digits < agreement.spots[agreement.worst].digits) {
            agreement.worst = agreement.spots.size() - 1;
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

} // namespace edgeproof
