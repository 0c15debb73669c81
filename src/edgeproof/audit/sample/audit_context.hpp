// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/audit/ledger/family.hpp"
#include "edgeproof/audit/ledger/judgement.hpp"
#include "edgeproof/audit/ledger/ledger.hpp"
#include "edgeproof/contact/profile/edge.hpp"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::audit {

/// One sample of a claim: a scene, a place in it, and values for the names of `vary`.
struct Sample {
    SceneSpec scene;
    std::optional<Exact> fraction; ///< u as a fraction of the contact's length
    Edge edge = Edge::right;
    std::map<std::string, Exact, std::less<>> variables;
    std::shared_ptr<const Sample> next = {}; ///< at the next value of a sweep, for next(f)
    [[nodiscard]] std::string text() const;
};

/// Returns 0, 1, ..., n - 1 with `first` evenly spread indices, including both ends, before all
/// others (all of them if there are no more).
[[nodiscard]] std::vector<std::size_t> spread_first(std::size_t n, std::size_t first);

/// The data, in addition to the claim, that a check uses.
class AuditContext {
public:
    AuditContext(const Ledger& ledger, unsigned digits) : ledger_(ledger), digits_(digits) {}

    [[nodiscard]] const Ledger& ledger() const noexcept { return ledger_; }
    /// D: the requested digits.
    [[nodiscard]] unsigned digits() const noexcept { return digits_; }
    /// The digits of agreement required to confirm a claim to so many digits.
    [[nodiscard]] static unsigned digits_needed(unsigned of) noexcept { return of - 5; }
    /// Returns the scenes of the family in the claim's `over`.
    [[nodiscard]] std::vector<SceneSpec> scenes(const Claim& claim) const;
    /// Combines scenes, places (from the claim's `edge`; `points` in each scene) and values of
    /// `vary`.
    [[nodiscard]] std::vector<Sample> samples(const Claim& claim) const;
    /// The same without the samples that a family of few values draws again.
    [[nodiscard]] std::vector<Sample> different_samples(const Claim& claim) const;

private:
    const Ledger& ledger_;
    unsigned digits_;
};

/// Returns the families of a ledger (without its claims) with one parameter of a family fixed.
/// Parameters that depend on it change, too.
[[nodiscard]] Ledger with_parameter(const Ledger& ledger, const std::string& family,
                                    const std::string& parameter, const Expr& value);

/// The samples of a claim that is a table: the row i has the value i of each list of the family and
/// of `vary`; a list of one value is that of all rows. Throws InputError for other lists.
[[nodiscard]] std::vector<Sample> rows_of(const Claim& claim, const AuditContext& context,
                                          std::size_t rows);

/// The samples of a claim at every listed value of the name in `along`, a parameter of the family
/// or a name of `vary`. Each sample except the last has the next one as its `next`.
struct Sweep {
    std::vector<std::string> values;
    std::vector<std::vector<Sample>> samples; ///< at each value
};
[[nodiscard]] Sweep sweep_of(const Claim& claim, const AuditContext& context);

} // namespace edgeproof::audit
