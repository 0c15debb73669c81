// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/run.hpp"
#include "edgeproof/audit/agreement/enclosures.hpp"
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <boost/algorithm/string/join.hpp>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <fnmatch.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <optional>

namespace edgeproof::audit {
namespace {

Outcome check_one(const Claim& claim, const AuditContext& context) {
    try {
        return claim.check->check(claim, context);
    } catch (const InputError& error) { // such as a scene of a sweep in which the contact slides
        throw error.file().empty() ? error.at(claim.file, claim.line) : error;
    } catch (const Error& e) { // the budget is spent, or the method does not apply
        Outcome o;
        o.note = e.what();
        return o;
    }
}

/// Checks a claim about a contact whose size is not given at each of the sizes listed.
Outcome check_sizes(const Claim& claim, const AuditContext& context) {
    if (!claim.has("sizes")) {
        return check_one(claim, context);
    }
    Outcome all;
    std::vector<Judgement> verdicts;
    std::vector<std::string> holding;
    Evidence each = Evidence::object();
    for (const std::string& size : claim.list("sizes")) {
        const Ledger sized = with_parameter(context.ledger(), claim.text("over"), "a",
                                            parse_formula(size, claim.vocabulary));
        const Outcome one = check_one(claim, AuditContext(sized, context.digits()));
        verdicts.push_back(one.verdict);
        each["a = " + size] =
            std::string(name_of(one.verdict)) + ": " + one.computed.value_or(one.note);
        if (holds(one.verdict)) {
            holding.push_back(size);
        }
    }
    const std::string sizes = std::to_string(verdicts.size()) + " sizes";
    all.evidence["sizes"] = each;
    all.evidence["holds_for_a"] = holding;
    if (std::ranges::count(verdicts, Verdict::undecided) > 0) {
        all.note = "the enclosures do not decide at some of " + sizes;
    } else if (holding.empty()) {
        all.note = "it holds at none of " + sizes + ", which does not decide between them";
    } else if (holding.size() < verdicts.size()) {
        all.verdict = Judgement::underspecified();
        all.note = "the size is not given; of " + sizes +
                   ", it would hold for a = " + boost::algorithm::join(holding, ", ");
    } else {
        all.verdict = Judgement::of_readings(verdicts);
        all.note = "the size is not given, and it holds at each of " + sizes;
    }
    return all;
}

/// Combines the outcomes under several readings; `undefined` lists the names not defined in print.
Outcome combined(const Claim& claim, const std::vector<std::pair<std::string, Outcome>>& readings) {
    Outcome all;
    std::vector<Judgement> verdicts;
    std::vector<std::string> holding;
    std::vector<std::string> failing;
    Evidence each = Evidence::object();
    for (const auto& [text, outcome] : readings) {
        verdicts.push_back(outcome.verdict);
        (holds(outcome.verdict) ? holding : failing).push_back(text);
        Evidence one;
        one["verdict"] = name_of(outcome.verdict);
        if (!outcome.note.empty()) {
            one["note"] = outcome.note;
        }
        if (outcome.computed) {
            one["computed"] = *outcome.computed;
        }
        if (outcome.correct) {
            one["correct"] = *outcome.correct;
        }
        one.update(outcome.evidence);
        each[text] = one;
        if (!all.computed && outcome.computed) {
            all.computed = outcome.computed;
        }
        if (!holds(outcome.verdict) && !all.correct && outcome.correct) {
            all.correct = outcome.correct;
        }
    }
    all.verdict = Judgement::of_readings(verdicts);
    if (!claim.undefined.empty()) {
        all.verdict = Judgement::underspecified();
        all.note = "not defined in print: " + boost::algorithm::join(claim.undefined, ", ") + "; " +
                   (holding.empty() ? "holds under none of the readings tried"
                                    : "would hold for: " + boost::algorithm::join(holding, "; "));
    } else if (all.verdict == Verdict::imprecise && !holding.empty()) {
        all.note = "holds for: " + boost::algorithm::join(holding, "; ") +
                   ". Not for: " + boost::algorithm::join(failing, "; ");
    } else if (!readings.empty()) {
        all.note = readings.front().second.note;
    }
    all.evidence["readings"] = each;
    return all;
}

} // namespace

bool matches(const std::string& pattern, const std::string& text) {
    return ::fnmatch(pattern.c_str(), text.c_str(), FNM_NOESCAPE) == 0;
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
            r.outcome = check_sizes(claim, context);
        } else {
            for (const Claim& reading : claim.readings) {
                r.readings.emplace_back(reading.reading, check_sizes(reading, context));
            }
            r.outcome = combined(claim, r.readings);
        }
        if (auto clearest = clearest_counterexample(r, context)) {
            r.outcome.evidence["clearest"] = std::move(*clearest);
        }
    };
    const auto run_claim = [&](std::size_t i) {
        check_interruption();
        try {
            judge(*chosen[i], result.claims[i]);
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
    std::ranges::stable_sort(errors, [](const ClaimError& x, const ClaimError& y) {
        return x.error.line() < y.error.line();
    });
    result.errors = std::move(errors);
    add_later_results(result, context);
    return result;
}

namespace {

constexpr long later_bits = 400; // several orders cancel before the required one
constexpr unsigned result_digits = 6;

struct LaterFinding {
    std::string comes_to;
    bool as_printed = false;
};

/// For a reach: computes the error at the quoted distance, in the first scene. The result is "as
/// printed" if the error rounds to the tolerance.
LaterFinding at_quoted_distance(const LaterResult& later, const Claim& claim,
                                const QuotedReach& reach, const AuditContext& context) {
    EnclosedSample at({context.scenes(claim).front(), std::nullopt, claim.edge(), {}}, later_bits);
    const Ball share(quoted_number(claim.text("quoted")), later_bits);
    at.set_place(claim.edge(), at.evaluate(reach.base) * share);
    const PrecisionScope scope(2 * result_digits);
    const Real error = at.finite(later.says).midpoint();
    const Real tolerance = Exact(reach.tolerance).to<Real>();
    return {to_decimal(Real(error * 100), result_digits) + " %",
            error < tolerance * 3 / 2 && error * 2 > tolerance};
}

/// For a formula: compares its value at every sample with the printed later line.
LaterFinding at_samples(const LaterResult& later, const Claim& claim, const AuditContext& context) {
    const bool formula = claim.find_written("says") != nullptr;
    const ClaimSamples samples(claim, context);
    const PrecisionScope scope(40);
    LaterFinding finding;
    finding.as_printed = true;
    for (const Sample& sample : samples.all()) {
        Real value;
        Real printed;
        try {
            const EnclosedSample at(sample, later_bits);
            value = at_working_precision(at.finite(later.says).midpoint());
            printed = formula ? at_working_precision(at.finite(claim.formula("says")).midpoint())
                              : Real(1);
        } catch (const BudgetError&) {
            continue;
        }
        if (!formula) { // a term that is stated to grow without bound
            if (abs(value) < pow(Real(10), -30)) {
                continue; // the term vanishes in this scene
            }
            finding.as_printed = finding.as_printed && abs(value) > 1000000;
        } else {
            const Real size = std::max(Real(abs(value)), Real(abs(printed)));
            finding.as_printed =
                finding.as_printed && abs(value - printed) <= size * pow(Real(10), -12);
            if (printed != 0) {
                value = value / printed;
            }
        }
        if (finding.comes_to.empty() || !finding.as_printed) {
            finding.comes_to = to_decimal(value, result_digits) +
                               (formula ? " times what is printed" : "") + ", " + full_text(sample);
        }
        if (!finding.as_printed) {
            break;
        }
    }
    if (finding.comes_to.empty()) {
        throw Error("no sample has a value that is not zero");
    }
    if (formula && finding.as_printed) {
        finding.comes_to = "what is printed, at every sample";
    }
    return finding;
}

using LaterResults = std::map<std::string, std::vector<Evidence>>;

void note_as_if(const std::string& id, const Outcome& outcome, const AuditResult& result,
                LaterResults& found) {
    for (const Hypothesis& hypothesis : outcome.as_if) {
        for (const ClaimResult& earlier : result.claims) {
            const std::string row = earlier.claim.id.substr(0, earlier.claim.id.find('.'));
            if (holds(earlier.outcome.verdict) || earlier.claim.id == id ||
                hypothesis.words.find(row) == std::string::npos) {
                continue;
            }
            found[earlier.claim.id].push_back({{"claim", id},
                                               {"what", hypothesis.words},
                                               {"comes_to", hypothesis.text()},
                                               {"as_printed", hypothesis.gives_the_line}});
        }
    }
}

} // namespace

void add_later_results(AuditResult& result, const AuditContext& context) {
    LaterResults found;
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
        Evidence one{{"claim", later.claim}, {"what", later.words}};
        try {
            const Claim& claim =
                to->claim.readings.empty() ? to->claim : to->claim.readings.front();
            const auto reach = quoted_reach(claim);
            const LaterFinding finding = reach ? at_quoted_distance(later, claim, *reach, context)
                                               : at_samples(later, claim, context);
            one.update({{"comes_to", finding.comes_to}, {"as_printed", finding.as_printed}});
        } catch (const Error& error) { // a limit of the program, not a result
            one["not_computed"] = error.what();
        }
        found[later.from].emplace_back(std::move(one));
    }
    for (const ClaimResult& r : result.claims) {
        note_as_if(r.claim.id, r.outcome, result, found);
        for (const auto& [words, outcome] : r.readings) {
            note_as_if(r.claim.id, outcome, result, found);
        }
    }
    for (auto& [id, list] : found) {
        if (ClaimResult* of = claim_of(id)) {
            of->outcome.evidence["later_results"] = std::move(list);
        }
    }
}

} // namespace edgeproof::audit
