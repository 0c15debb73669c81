// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/sample/audit_context.hpp"

#include <string>
#include <vector>

/// What the kinds share that follow a quantity while one name takes one value after another.
namespace edgeproof::audit {

/// The families of a ledger (its claims left out), one parameter of a family fixed. Other
/// parameters that are written in terms of it follow.
[[nodiscard]] Ledger with_parameter(const Ledger& ledger, const std::string& family,
                                    const std::string& parameter, const formula::Expr& value);

/// A sample of a sweep, and its text.
struct SweptSample {
    Sample sample;
    std::string text;
};

/// A claim's samples, each at every value of the name that `along` gives: a parameter of the
/// family, or a name of `vary`. The values are those listed there, in the order listed. Refers to
/// the claim and to the context.
class ParameterSweep {
public:
    ParameterSweep(const Claim& claim, const AuditContext& context);

    [[nodiscard]] const std::string& name() const noexcept { return name_; }
    [[nodiscard]] const std::vector<std::string>& values() const noexcept { return values_; }
    /// Samples at one value.
    [[nodiscard]] std::size_t samples() const noexcept { return steps_.front().size(); }
    [[nodiscard]] const SweptSample& sample_at(std::size_t value, std::size_t sample) const {
        return steps_[value][sample];
    }
    /// The value of the name there.
    [[nodiscard]] const formula::Exact& value_at(std::size_t value, std::size_t sample) const;
    /// The same sample at a value that is not listed. Throws Error for one that the family does not
    /// admit.
    [[nodiscard]] Sample sample_with(const formula::Exact& value, std::size_t sample) const;

private:
    const Claim& claim_;
    const AuditContext& context_;
    std::string name_;
    bool of_family_ = false; ///< else a name of `vary`
    std::vector<std::string> values_;
    std::vector<std::vector<SweptSample>> steps_;
};

} // namespace edgeproof::audit
