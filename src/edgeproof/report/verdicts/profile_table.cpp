// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/verdicts/verdict_writers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace edgeproof::report {
namespace {

/// The use of the samples, which shows if fewer would suffice.
std::string samples_text(const audit::ClaimResult& r, double most) {
    if (!r.outcome.sample_use) {
        return "-";
    }
    const audit::SampleUse& use = *r.outcome.sample_use;
    const auto digits = [most](double d) {
        return d < 0 ? std::string("no value") : fmt::format("{:.1f} digits", std::min(d, most));
    };
    if (use.refuting > 0) {
        return fmt::format("refuted at {} of {}, first at {}", use.refuting, use.samples,
                           use.first_refuting);
    }
    return fmt::format("worst at {} of {}: {}; in the first half {}", use.worst, use.samples,
                       digits(use.digits), digits(use.first_half_digits));
}

} // namespace

std::string profile_table(const audit::AuditResult& result) {
    std::vector<const audit::ClaimResult*> claims;
    std::size_t widest = std::string_view("claim").size();
    double all = 0;
    for (const audit::ClaimResult& r : result.claims) {
        if (r.seconds) {
            claims.push_back(&r);
            widest = std::max(widest, r.claim.id.size());
            all += *r.seconds;
        }
    }
    std::stable_sort(claims.begin(), claims.end(),
                     [](const auto* x, const auto* y) { return *x->seconds > *y->seconds; });
    std::string text = fmt::format("{:<{}}  {:<14}  {:<14}  {:>8}  {:>6}  samples\n", "claim",
                                   widest, "kind", "verdict", "seconds", "share");
    for (const audit::ClaimResult* r : claims) {
        text += fmt::format("{:<{}}  {:<14}  {:<14}  {:>8.3f}  {:>5.1f}%  {}\n", r->claim.id,
                            widest, r->claim.kind, name_of(r->outcome.verdict), *r->seconds,
                            all > 0 ? 100 * *r->seconds / all : 0, samples_text(*r, result.digits));
    }
    return text + fmt::format("{:<{}}  {:<14}  {:<14}  {:>8.3f}\n", "all", widest, "", "", all);
}

} // namespace edgeproof::report
