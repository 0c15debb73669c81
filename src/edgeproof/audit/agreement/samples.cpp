// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/samples.hpp"

#include "edgeproof/audit/enclosure/sample_in_balls.hpp"

#include <fmt/format.h>

#include <set>

namespace edgeproof::audit {
namespace {

constexpr double all_digits = 1e6;
constexpr unsigned condition_digits = 15;

} // namespace

bool is_admitted(const Claim& claim, const Sample& sample) {
    if (!claim.has("where")) {
        return true;
    }
    SampleInBalls in_balls(sample, condition_digits);
    return confirms(decide(claim.condition("where"), in_balls, condition_digits));
}

ClaimSamples::ClaimSamples(const Claim& claim, const AuditContext& context) {
    for (Sample& sample : context.samples(claim)) {
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
    if (digits >= all_digits) {
        return "all";
    }
    return digits <= -all_digits ? "none" : fmt::format("{:.1f}", digits);
}

std::string value_text(const Real& value, unsigned digits) {
    return value.str(static_cast<std::streamsize>(digits), std::ios_base::scientific);
}

} // namespace edgeproof::audit
