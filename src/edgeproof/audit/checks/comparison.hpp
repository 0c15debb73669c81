// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/diagnosis.hpp"
#include "edgeproof/audit/enclosures.hpp"
#include "edgeproof/audit/ratio.hpp"
#include "edgeproof/audit/spots.hpp"
#include "edgeproof/audit/symbolic.hpp"

#include <memory>
#include <optional>

/// What the kinds value, identity and expansion share.
namespace edgeproof {

/// b = a for a family of symmetric contacts; P(a), b(a) where `given` names them.
[[nodiscard]] SymbolicCase symbolic_case(const Claim& claim, const AuditContext& context);

/// Digits, samples and the worst of them, into the evidence.
void report_agreement(const Agreement& agreement, const Spots& spots, unsigned digits,
                      Evidence& evidence);

/// By what the samples say, of so many digits that are needed: confirmed, refuted (by a difference
/// of values), underspecified (no value in print at some), undecided.
[[nodiscard]] Judgement judge_samples(const Agreement& agreement, double needed);

/// printed/exact at all spots, recognised; also puts the ratio's range into the evidence.
[[nodiscard]] std::optional<Expr> ratio_by_samples(const Agreement& agreement, const Spots& spots,
                                                   Evidence& evidence);

/// A test of candidates at a few spots, to a few digits; expressions as written in the claim.
class QuickSamples {
public:
    QuickSamples(const Claim& claim, const AuditContext& context, const Expr& exact);
    [[nodiscard]] bool looks_right(const Expr& written);

private:
    static constexpr unsigned digits = 10;
    static constexpr std::size_t most_spots = 4;
    const Claim& claim_;
    std::shared_ptr<Spots> spots_;
    std::vector<std::pair<std::size_t, Real>> targets_;
};

} // namespace edgeproof
