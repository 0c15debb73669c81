// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/run.hpp"

#include "edgeproof/audit/counterexample.hpp"
#include "edgeproof/audit/later_results.hpp"
#include "edgeproof/audit/ledger/claim_kind.hpp"
#include "edgeproof/parallel/thread_seconds.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <optional>

namespace edgeproof::audit {
namespace {

Outcome check_one(const Claim& claim, const AuditContext& context) {
    const CheckKind* kind = find_check_kind(claim.kind);
    if (kind == nullptr) {
        throw Error("no kind of check is called " + claim.kind);
    }
    try {
        return kind->check(claim, context);
    } catch (const InputError& error) { // such as a scene of a sweep in which the contact slides
        throw error.file().empty() ? error.at(claim.file, claim.line) : error;
    } catch (const Error& e) { // the budget is spent, or the method does not apply
        Outcome o;
        o.note = e.what();
        return o;
    }
}

std::string join(const std::vector<std::string>& parts, const std::string& between) {
    std::string text;
    for (const std::string& part : parts) {
        text += (text.empty() ? "" : between) + part;
    }
    return text;
}

/// Combines the outcomes under several readings; `undefined` lists the names not defined in print.
Outcome combined(const Claim& claim, const std::vector<std::pair<std::string, Outcome>>& readings) {
    Outcome all;
    std::vector<Judgement> verdicts;
    std::vector<std::string> holding;
    std::vector<std::string> failing;
    Evidence each;
    for (const auto& [text, outcome] : readings) {
        verdicts.push_back(outcome.verdict);
        (holds(outcome.verdict) ? holding : failing).push_back(text);
        Evidence one;
        one.add("verdict", name_of(outcome.verdict));
        if (!outcome.note.empty()) {
            one.add("note", outcome.note);
        }
        if (outcome.computed) {
            one.add("computed", *outcome.computed);
        }
        if (outcome.correct) {
            one.add("correct", *outcome.correct);
        }
        for (const auto& [key, item] : outcome.evidence.entries()) {
            one.add(key, item);
        }
        each.add(text, one);
        if (!all.computed && outcome.computed) {
            all.computed = outcome.computed;
        }
        if (!holds(outcome.verdict) && !all.correct && outcome.correct) {
            all.correct = outcome.correct;
        }
    }
    all.verdict = Judgement::of_readings(verdicts);
    if (!claim.undefined.empty()) {
        all.verdict = Undecided::underspecified;
        all.note = "not defined in print: " + join(claim.undefined, ", ") + "; " +
                   (holding.empty() ? "holds under none of the readings tried"
                                    : "would hold for: " + join(holding, "; "));
    } else if (all.verdict == Verdict::imprecise && !holding.empty()) {
        all.note = "holds for: " + join(holding, "; ") + ". Not for: " + join(failing, "; ");
    } else if (!readings.empty()) {
        all.note = readings.front().second.note;
    }
    all.evidence.add("readings", each);
    return all;
}

} // namespace

bool matches(std::string_view pattern, std::string_view text) {
    if (pattern.empty()) {
        return text.empty();
    }
    if (pattern[0] == '*') {
        return matches(pattern.substr(1), text) ||
               (!text.empty() && matches(pattern, text.substr(1)));
    }
    return !text.empty() && (pattern[0] == '?' || pattern[0] == text[0]) &&
           matches(pattern.substr(1), text.substr(1));
}

AuditResult run_audit(const Ledger& ledger, const AuditOptions& options) {
    std::vector<const Claim*> chosen;
    for (const Claim& claim : ledger.claims) {
        if (matches(options.only, claim.id)) {
            chosen.push_back(&claim);
        }
    }
    std::vector<ClaimError> errors;
    for (const ClaimError& e : ledger.errors) {
        if (matches(options.only, e.id)) {
            errors.push_back(e);
        }
    }
    if (chosen.empty() && errors.empty()) {
        throw InputError("no claim of " + ledger.file + " has an id like '" + options.only + "'",
                         "give a pattern such as 'EQ2*' or 'S1*'");
    }
    const AuditContext context(ledger, options.digits);
    AuditResult result;
    result.ledger = ledger.name;
    result.source = ledger.source;
    result.digits = options.digits;
    result.claims.resize(chosen.size());
    std::vector<std::optional<InputError>> failed(chosen.size());
    std::atomic<std::size_t> done{0};
    const auto judge = [&](const Claim& claim, ClaimResult& r) {
        r.claim = claim;
        if (claim.readings.empty() && claim.undefined.empty()) {
            r.outcome = check_one(claim, context);
        } else {
            for (const Claim& reading : claim.readings) {
                r.readings.emplace_back(reading.reading, check_one(reading, context));
            }
            r.outcome = combined(claim, r.readings);
        }
        if (auto clearest = clearest_counterexample(r, context)) {
            r.outcome.evidence.add("clearest", std::move(*clearest));
        }
    };
    const auto run_claim = [&](std::size_t i) {
        check_interruption();
        const double begun = parallel::thread_seconds();
        try {
            judge(*chosen[i], result.claims[i]);
            if (options.timed) {
                result.claims[i].seconds = parallel::thread_seconds() - begun;
            }
        } catch (const InputError& error) {
            if (options.errors == ClaimErrors::thrown) {
                throw;
            }
            failed[i] = error;
        }
        check_interruption(); // the interruption may have come during the check
        const std::size_t now = ++done;
        if (options.progress) {
            options.progress(now, chosen.size());
        }
    };
    tbb::task_arena arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic);
    arena.execute([&] {
        // Each claim is a task of its own, as their costs differ by a factor of up to 1000.
        tbb::parallel_for(std::size_t{0}, chosen.size(), run_claim, tbb::simple_partitioner());
    });
    std::vector<ClaimResult> judged;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        if (failed[i]) {
            errors.push_back({chosen[i]->id, *failed[i]});
        } else {
            judged.push_back(std::move(result.claims[i]));
        }
    }
    result.claims = std::move(judged);
    std::stable_sort(errors.begin(), errors.end(), [](const ClaimError& x, const ClaimError& y) {
        return x.error.line() < y.error.line();
    });
    result.errors = std::move(errors);
    add_later_results(result, context);
    return result;
}

} // namespace edgeproof::audit
