// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/samples.hpp"

#include "edgeproof/audit/enclosure/sample_in_balls.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

namespace edgeproof::audit {
namespace {

constexpr double all_digits = 1e6;
constexpr unsigned condition_digits = 15;

/// Returns a key with everything on which the samples depend.
std::string sampling_key(const Claim& claim, std::size_t most) {
    std::string key = fmt::format("samples/{}/{}/{}/{}", most, claim.text("over"),
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

} // namespace

bool is_admitted(const Claim& claim, const Sample& sample) {
    if (!claim.has("where")) {
        return true;
    }
    SampleInBalls in_balls(sample, condition_digits);
    return confirms(decide(claim.condition("where"), in_balls, condition_digits));
}

std::shared_ptr<ClaimSamples> ClaimSamples::of(const Claim& claim, const AuditContext& context,
                                               std::size_t most) {
    return context.borrow<ClaimSamples>(sampling_key(claim, most), [&] {
        return std::make_unique<ClaimSamples>(claim, context, most);
    });
}

ClaimSamples::ClaimSamples(const Claim& claim, const AuditContext& context, std::size_t most) {
    const std::vector<Sample> samples = context.samples(claim);
    for (const std::size_t i : spread_first(samples.size(), most)) {
        if (most != 0 && samples_.size() >= most) {
            break;
        }
        // A sample on the boundary of the condition does not decide and is left out.
        if (is_admitted(claim, samples[i])) {
            samples_.push_back(samples[i]);
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
                                             unsigned integral_digits) {
    const std::tuple key(sample, bits, integral_digits);
    const auto it = enclosed_.find(key);
    return it != enclosed_.end()
               ? it->second
               : enclosed_.emplace(key, EnclosedSample(samples_[sample], bits, integral_digits))
                     .first->second;
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
