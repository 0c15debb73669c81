// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/later_results.hpp"

#include "edgeproof/audit/agreement/samples.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>
#include <map>

namespace edgeproof::audit {
namespace {

constexpr unsigned later_digits = 100; // several orders cancel before the required one
constexpr unsigned result_digits = 6;

struct LaterFinding {
    std::string comes_to;
    bool as_printed = false;
};

/// Returns the first reading of the claim, or the claim itself if it has no readings.
const Claim& plain(const Claim& claim) {
    return claim.readings.empty() ? claim : claim.readings.front();
}

/// For a reach: computes the error at the quoted distance, in the first scene. The result is "as
/// printed" if the error rounds to the tolerance.
LaterFinding at_quoted_distance(const LaterResult& later, const Claim& claim,
                                const AuditContext& context) {
    const EvaluatedScene values(context.scenes(claim).front(), later_digits);
    const PrecisionScope scope(later_digits + 20);
    const std::string& quoted = claim.text("quoted");
    const Rational share = parse_decimal(quoted.substr(0, quoted.find(" %")));
    const Real u = values.evaluate(claim.formula("base")).value * from_rational<Real>(share) / 100;
    const Place place = values.place_at_u(claim.edge(), u);
    const Real error = values.evaluate(later.says, &place).value;
    const Real tolerance = formula::Exact::parse(claim.text("tolerance")).to<Real>();
    return {to_decimal(Real(error * 100), result_digits) + " %",
            error < tolerance * 3 / 2 && error * 2 > tolerance};
}

/// For a formula: compares its value at every sample with the printed later line.
LaterFinding at_samples(const LaterResult& later, const Claim& claim, const AuditContext& context) {
    const bool formula = claim.find_written("says") != nullptr;
    EvaluatedSamples samples(claim, context, later_digits, formula ? 0 : 3);
    const PrecisionScope scope(later_digits + 20);
    LaterFinding finding;
    finding.as_printed = true;
    bool any = false;
    for (const EvaluatedSample& sample : samples.all()) {
        Real value;
        try {
            value = sample.evaluate(later.says).value;
        } catch (const DomainError&) {
            continue;
        }
        if (!formula) { // a term that is stated to grow without bound
            if (abs(value) < pow(Real(10), -30)) {
                continue; // the term vanishes in this scene
            }
            finding.as_printed = finding.as_printed && abs(value) > 1000000;
        } else {
            const Real printed = sample.evaluate(claim.formula("says")).value;
            const Real size = std::max(Real(abs(value)), Real(abs(printed)));
            finding.as_printed =
                finding.as_printed && abs(value - printed) <= size * pow(Real(10), -12);
            if (printed != 0) {
                value = value / printed;
            }
        }
        if (finding.comes_to.empty() || !finding.as_printed) {
            finding.comes_to = to_decimal(value, result_digits) +
                               (formula ? " times what is printed" : "") + ", " + sample.text;
        }
        any = true;
        if (!finding.as_printed) {
            break;
        }
    }
    if (!any) {
        throw Error("no sample has a value that is not zero");
    }
    if (formula && finding.as_printed) {
        finding.comes_to = "what is printed, at every sample";
    }
    return finding;
}

void note_as_if(const std::string& id, const Evidence& evidence, const AuditResult& result,
                std::map<std::string, std::vector<EvidenceItem>>& found) {
    for (const auto& [key, item] : evidence.entries()) {
        const auto* nested = std::get_if<Evidence>(&item.value());
        if (nested == nullptr) {
            continue;
        }
        if (key != "as_if") {
            note_as_if(id, *nested, result, found);
            continue;
        }
        for (const auto& [words, outcome] : nested->entries()) {
            for (const ClaimResult& earlier : result.claims) {
                const std::string row = earlier.claim.id.substr(0, earlier.claim.id.find('.'));
                if (holds(earlier.outcome.verdict) || earlier.claim.id == id ||
                    words.find(row) == std::string::npos) {
                    continue;
                }
                Evidence one;
                one.add("claim", id)
                    .add("what", words)
                    .add("comes_to", outcome.text())
                    .add("as_printed", outcome.text() == "gives the printed line");
                found[earlier.claim.id].emplace_back(std::move(one));
            }
        }
    }
}

} // namespace

void add_later_results(AuditResult& result, const AuditContext& context) {
    std::map<std::string, std::vector<EvidenceItem>> found;
    const auto claim_of = [&](const std::string& id) -> ClaimResult* {
        const auto it =
            std::ranges::find(result.claims, id, [](const auto& r) { return r.claim.id; });
        return it == result.claims.end() ? nullptr : &*it;
    };
    for (const LaterResult& later : context.ledger().later) {
        const ClaimResult* from = claim_of(later.from);
        const ClaimResult* to = claim_of(later.claim);
        if (from == nullptr || to == nullptr || holds(from->outcome.verdict)) {
            continue;
        }
        check_interruption();
        Evidence one;
        one.add("claim", later.claim).add("what", later.words);
        try {
            const Claim& claim = plain(to->claim);
            const LaterFinding finding = claim.kind == "extent"
                                             ? at_quoted_distance(later, claim, context)
                                             : at_samples(later, claim, context);
            one.add("comes_to", finding.comes_to).add("as_printed", finding.as_printed);
        } catch (const Error& error) { // a limit of the program, not a result
            one.add("not_computed", error.what());
        }
        found[later.from].emplace_back(std::move(one));
    }
    for (const ClaimResult& r : result.claims) {
        note_as_if(r.claim.id, r.outcome.evidence, result, found);
    }
    for (auto& [id, list] : found) {
        if (ClaimResult* of = claim_of(id)) {
            of->outcome.evidence.add("later_results", std::move(list));
        }
    }
}

} // namespace edgeproof::audit
