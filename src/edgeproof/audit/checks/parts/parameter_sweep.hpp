// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/agreement/samples.hpp"

#include <memory>
#include <string>
#include <vector>

/// What the kinds share that follow a quantity while one name takes one value after another.
namespace edgeproof::audit {

/// The families of a ledger (its claims left out), one parameter of a family fixed. Other
/// parameters that are written in terms of it follow.
[[nodiscard]] Ledger with_parameter(const Ledger& ledger, const std::string& family,
                                    const std::string& parameter, const formula::Expr& value);

/// A claim's samples, each at every value of the name that `along` gives: a parameter of the
/// family, or a name of `vary`. The values are those listed there, in the order listed.
class ParameterSweep {
public:
    ParameterSweep(const Claim& claim, const AuditContext& context, unsigned digits);

    [[nodiscard]] const std::string& name() const noexcept { return name_; }
    [[nodiscard]] const std::vector<std::string>& values() const noexcept { return values_; }
    /// Samples at one value.
    [[nodiscard]] std::size_t samples() const noexcept { return steps_.front()->all().size(); }
    [[nodiscard]] const EvaluatedSample& sample_at(std::size_t value, std::size_t sample) const {
        return steps_[value]->all()[sample];
    }

private:
    std::string name_;
    std::vector<std::string> values_;
    std::vector<std::unique_ptr<EvaluatedSamples>> steps_;
};

} // namespace edgeproof::audit
