// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/sample/audit_context.hpp"

#include <string>
#include <vector>

/// Shared by the kinds that follow a quantity while one name takes successive values.
namespace edgeproof::audit {

/// Returns the families of a ledger (without its claims) with one parameter of a family fixed.
/// Parameters that depend on it change, too.
[[nodiscard]] Ledger with_parameter(const Ledger& ledger, const std::string& family,
                                    const std::string& parameter, const formula::Expr& value);

/// The samples of a claim, each at every listed value of the name in `along`: a parameter of the
/// family, or a name of `vary`. Refers to the claim and to the context.
class ParameterSweep {
public:
    ParameterSweep(const Claim& claim, const AuditContext& context);

    [[nodiscard]] const std::string& name() const noexcept { return name_; }
    [[nodiscard]] const std::vector<std::string>& values() const noexcept { return values_; }
    /// The number of samples at each value.
    [[nodiscard]] std::size_t samples() const noexcept { return steps_.front().size(); }
    [[nodiscard]] const Sample& sample_at(std::size_t value, std::size_t sample) const {
        return steps_[value][sample];
    }
    [[nodiscard]] const Sample& last_sample(std::size_t sample) const {
        return steps_.back()[sample];
    }
    /// The value of the name in that sample.
    [[nodiscard]] const formula::Exact& value_at(std::size_t value, std::size_t sample) const;
    /// Returns the same sample at a value that is not listed. Throws Error if the family does not
    /// admit the value.
    [[nodiscard]] Sample sample_with(const formula::Exact& value, std::size_t sample) const;

private:
    [[nodiscard]] std::vector<Sample> samples_with(const formula::Expr& value) const;
    void add_step(std::string value, std::vector<Sample> samples);

    const Claim& claim_;
    const AuditContext& context_;
    std::string name_;
    bool of_family_ = false; ///< false: a name of `vary`
    std::vector<std::string> values_;
    std::vector<std::vector<Sample>> steps_;
};

} // namespace edgeproof::audit
