// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/mutation/mutants.hpp"
#include "edgeproof/audit/checks/parts/comparison.hpp"
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/audit/symbolic/symbolic.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <mutex>
#include <random>
#include <string_view>
#include <unordered_set>
#include <utility>

namespace edgeproof::audit {
namespace {

using Kind = formula::Expr::Kind;

class Breaker {
public:
    explicit Breaker(const formula::Expr& formula) : formula_(formula) {}

    std::vector<Mutant> operator()() {
        for (const formula::Path& path : paths(formula_)) {
            path_ = path;
            break_at(at(formula_, path));
        }
        return std::move(mutants_);
    }

private:
    void put(const char* kind, const formula::Expr& value) {
        formula::Expr mutated = replace(formula_, path_, value);
        if (seen_.insert(mutated).second) {
            mutants_.push_back({kind, std::move(mutated)});
        }
    }
    [[nodiscard]] bool is_exponent() const {
        if (path_.empty() || path_.back() != 1) {
            return false;
        }
        return at(formula_, formula::Path(path_.begin(), path_.end() - 1)).kind() == Kind::pow;
    }

    void break_at(const formula::Expr& node) {
        switch (node.kind()) {
        case Kind::add:
            put("sign", node.arg(0) - node.arg(1));
            break;
        case Kind::sub:
            put("sign", node.arg(0) + node.arg(1));
            break;
        case Kind::neg:
            put("sign", node.arg(0));
            break;
        case Kind::number:
            number(node);
            break;
        case Kind::mul:
            put("factor", node.arg(0));
            put("factor", node.arg(1));
            break;
        case Kind::div:
            put("factor", node.arg(0));
            break;
        case Kind::symbol:
            symbol(node.name());
            break;
        case Kind::call:
            call(node);
            break;
        default:
            break;
        }
    }

    void number(const formula::Expr& node) {
        const Rational& n = node.number();
        if (is_exponent()) {
            put("exponent", formula::Expr::number(Rational(n + Rational(1, 2))));
            put("exponent", formula::Expr::number(Rational(n - Rational(1, 2))));
            return;
        }
        // Change the number by one unit in its last written digit.
        Rational unit(1);
        while (denominator(Rational(n / unit)) != 1) {
            unit /= 10;
        }
        put("coefficient", formula::Expr::number(Rational(n + unit)));
        if (n != unit) {
            put("coefficient", formula::Expr::number(Rational(n - unit)));
        }
    }

    void symbol(const std::string& name) {
        if (name == "a" || name == "b") {
            put("a for b", formula::Expr::symbol(name == "a" ? "b" : "a"));
        }
        // P1, P2, ... and b1, b2, ... denote derivatives.
        if (name == "P") {
            put("prime", formula::Expr::symbol("P1"));
        }
        if (name.size() == 2 && (name[0] == 'P' || name[0] == 'b') && name[1] >= '1' &&
            name[1] < '9') {
            put("prime",
                formula::Expr::symbol(std::string{name[0], static_cast<char>(name[1] + 1)}));
        }
        const bool right = name.starts_with("right_");
        if (right || name.starts_with("left_")) {
            const std::string rest = name.substr(name.find('_'));
            put("left for right", formula::Expr::symbol((right ? "left" : "right") + rest));
        }
    }

    void call(const formula::Expr& node) {
        if (node.builtin() == formula::Builtin::sqrt) {
            put("root", node.arg(0));
        }
        if (node.name() == "right_local" || node.name() == "left_local") {
            put("left for right",
                formula::Expr::call(
                    node.name() == "right_local" ? "left_local" : "right_local",
                    std::vector<formula::Expr>(node.args().begin(), node.args().end())));
        }
    }

    const formula::Expr& formula_;
    formula::Path path_;
    std::vector<Mutant> mutants_;
    std::unordered_set<formula::Expr, formula::ExprHash> seen_{formula_};
};

} // namespace

const std::vector<std::string>& mutation_kinds() {
    static const std::vector<std::string> kinds{"sign",  "coefficient", "exponent",       "a for b",
                                                "prime", "factor",      "left for right", "root"};
    return kinds;
}

std::vector<Mutant> mutants_of(const formula::Expr& formula) { return Breaker(formula)(); }

namespace {

struct Target {
    const Claim* claim;
    std::vector<Mutant> mutants;
};

bool is_formula_claim(const Claim& claim) {
    return (claim.kind == "value" || claim.kind == "identity") && claim.readings.empty() &&
           claim.undefined.empty();
}

/// Shuffles the mutants of a claim in an order given by the seed and the claim's id.
void shuffle(std::vector<Mutant>& mutants, std::uint64_t seed, const std::string& id) {
    std::uint64_t mixed = seed;
    for (const char c : id) {
        mixed = mixed * 1099511628211U + static_cast<unsigned char>(c);
    }
    // Do not replace this by SplitMix64: recorded seeds must keep drawing the same mutants.
    std::mt19937_64 random(mixed);
    // std::shuffle is not used, because its result depends on the standard library.
    for (std::size_t k = mutants.size(); k > 1; --k) {
        std::swap(mutants[k - 1], mutants[random() % k]);
    }
}

Claim broken(const Claim& claim, const formula::Expr& formula) {
    Claim mutant = claim;
    mutant.replace_formula("says", to_text(formula));
    // Its fractions are written as decimals here, but they are exact.
    mutant.fields.insert_or_assign("decimals", Field{std::string("exact"), mutant.line});
    return mutant;
}

Outcome outcome_of(const Claim& claim, const Mutant& mutant, const AuditContext& context) {
    try {
        return find_check_kind(claim.kind)->check(broken(claim, mutant.formula), context);
    } catch (const Error& e) {
        Outcome o;
        o.note = e.what();
        return o;
    }
}

MutantFate fate_of(const Claim& claim, const Mutant& mutant, const AuditContext& context) {
    MutantFate fate;
    fate.claim = claim.id;
    fate.kind = mutant.kind;
    const formula::Expr& original = claim.written("says");
    fate.original = to_text(original);
    fate.mutated = to_text(mutant.formula);
    const Outcome outcome = outcome_of(claim, mutant, context);
    fate.verdict = outcome.verdict;
    fate.note = outcome.note;
    const auto same_as_original = [&](const formula::Expr& e) {
        return surely_equal(expand_definitions(e, claim.vocabulary), claim.formula("says"),
                            symbolic_case(claim, context));
    };
    if (!fate.caught()) {
        fate.equivalent = same_as_original(mutant.formula);
    } else if (outcome.verdict == Verdict::refuted && outcome.correct &&
               !outcome.evidence.find("derived_instead")) {
        // The diagnosis named the error if its correction is the original formula.
        fate.named = same_as_original(parse_formula(*outcome.correct, claim.vocabulary));
    }
    return fate;
}

/// The fates found so far, saved every few seconds.
class Fates {
public:
    Fates(const MutationOptions& options, std::size_t size)
        : options_(options), fates_(size), found_(size, false) {
        for (const MutantFate& f : options.known) {
            known_.emplace(key(f.claim, f.mutated), &f);
        }
    }

    /// Takes the fate of mutant i from an earlier run; returns false if there is none.
    [[nodiscard]] bool take_known(std::size_t i, const Claim& claim, const Mutant& mutant) {
        const auto it = known_.find(key(claim.id, to_text(mutant.formula)));
        if (it == known_.end()) {
            return false;
        }
        found(i, *it->second);
        return true;
    }

    void found(std::size_t i, MutantFate fate) {
        const std::lock_guard lock(mutex_);
        fates_[i] = std::move(fate);
        found_[i] = true;
        ++done_;
        if (options_.audit.progress) {
            options_.audit.progress(done_, fates_.size());
        }
        const auto now = std::chrono::steady_clock::now();
        if (now - saved_at_ > std::chrono::seconds(5)) {
            save();
            saved_at_ = now;
        }
    }

    void save() const {
        if (!options_.checkpoint) {
            return;
        }
        std::vector<MutantFate> some;
        for (std::size_t i = 0; i < fates_.size(); ++i) {
            if (found_[i]) {
                some.push_back(fates_[i]);
            }
        }
        options_.checkpoint(some);
    }

    [[nodiscard]] std::vector<MutantFate> all() { return std::move(fates_); }

private:
    static std::string key(const std::string& claim, const std::string& mutated) {
        return claim + "\n" + mutated;
    }

    const MutationOptions& options_;
    std::map<std::string, const MutantFate*> known_;
    std::vector<MutantFate> fates_;
    std::vector<bool> found_;
    std::size_t done_ = 0;
    std::chrono::steady_clock::time_point saved_at_ = std::chrono::steady_clock::now();
    std::mutex mutex_;
};

} // namespace

MutationRun run_mutants(const Ledger& ledger, const MutationOptions& options) {
    MutationRun run;
    run.seed = options.seed;
    Ledger formulas = ledger;
    std::erase_if(formulas.claims, [&](const Claim& c) {
        return !is_formula_claim(c) || !matches(options.audit.only, c.id);
    });
    if (formulas.claims.empty() && formulas.errors.empty()) {
        throw InputError("no formula of " + ledger.file + " has an id like '" + options.audit.only +
                             "'",
                         "mutate changes claims of the kinds value and identity");
    }
    AuditOptions quiet = options.audit;
    quiet.progress = nullptr;
    run.originals = run_audit(formulas, quiet);

    std::vector<Target> targets;
    for (const ClaimResult& r : run.originals.claims) {
        if (r.outcome.verdict == Verdict::confirmed || r.outcome.verdict == Verdict::proved) {
            Target target{&r.claim, mutants_of(r.claim.written("says"))};
            shuffle(target.mutants, options.seed, r.claim.id);
            run.possible += target.mutants.size();
            targets.push_back(std::move(target));
        }
    }
    run.claims = targets.size();
    // One mutant of each claim in turn, so that long formulas do not displace short ones.
    std::vector<std::pair<const Claim*, const Mutant*>> chosen;
    for (std::size_t k = 0; chosen.size() < std::min(options.mutants, run.possible); ++k) {
        for (const Target& target : targets) {
            if (k < target.mutants.size() && chosen.size() < options.mutants) {
                chosen.emplace_back(target.claim, &target.mutants[k]);
            }
        }
    }
    const AuditContext context(ledger, options.audit.digits);
    Fates fates(options, chosen.size());
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        if (!fates.take_known(i, *chosen[i].first, *chosen[i].second)) {
            open.push_back(i);
        }
    }
    tbb::task_arena arena(options.audit.threads > 0 ? options.audit.threads
                                                    : tbb::task_arena::automatic);
    try {
        arena.execute([&] {
            tbb::parallel_for(
                std::size_t{0}, open.size(),
                [&](std::size_t k) {
                    check_interruption();
                    const auto& [claim, mutant] = chosen[open[k]];
                    fates.found(open[k], fate_of(*claim, *mutant, context));
                },
                tbb::simple_partitioner());
        });
    } catch (const Interrupted&) {
        fates.save();
        throw;
    }
    fates.save();
    run.fates = fates.all();
    return run;
}

} // namespace edgeproof::audit
