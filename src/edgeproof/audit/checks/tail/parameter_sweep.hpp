// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"
#include "edgeproof/audit/sample/audit_context.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// Shared by the kinds that follow a quantity while one name takes successive values.
namespace edgeproof::audit {

/// Returns the families of a ledger (without its claims) with one parameter of a family fixed.
/// Parameters that depend on it change, too.
[[nodiscard]] Ledger with_parameter(const Ledger& ledger, const std::string& family,
                                    const std::string& parameter, const Expr& value);

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
    [[nodiscard]] const Exact& value_at(std::size_t value, std::size_t sample) const;
    /// Returns the same sample at a value that is not listed. Throws Error if the family does not
    /// admit the value.
    [[nodiscard]] Sample sample_with(const Exact& value, std::size_t sample) const;

private:
    [[nodiscard]] std::vector<Sample> samples_with(const Expr& value) const;
    void add_step(std::string value, std::vector<Sample> samples);

    const Claim& claim_;
    const AuditContext& context_;
    std::string name_;
    bool of_family_ = false; ///< false: a name of `vary`
    std::vector<std::string> values_;
    std::vector<std::vector<Sample>> steps_;
};

/// The limit of the values in `along`, as far as the list shows it.
class SweepTarget {
public:
    /// Returns 0 if each value is at most half of the previous one, and infinity if each is at
    /// least twice it. Otherwise returns the simplest number (a multiple of one of `units`, of 1 or
    /// of pi) from which the distance decreases at least by half at each step. Returns nothing if
    /// no number fits, or if two do.
    [[nodiscard]] static std::optional<SweepTarget> of(const std::vector<Exact>& listed,
                                                       const std::vector<Exact>& units);

    [[nodiscard]] bool is_infinite() const { return kind_ == Kind::infinity; }
    /// Returns "0", "infinity", "3/7", ...
    [[nodiscard]] std::string text() const;
    /// Returns a value 10^decades times as near to the target as the last listed one, times a
    /// factor between 1/2 and 1 chosen by `which`, as formulas such as sin(Pi/s) are special at
    /// powers of ten.
    [[nodiscard]] Exact beyond(unsigned decades, std::size_t which) const;
    /// The distance of the last listed value from the target is 10^-decades; if the target is
    /// infinity, the value is 10^decades.
    [[nodiscard]] double decades() const { return decades_; }

private:
    enum class Kind { zero, infinity, finite };
    SweepTarget(Kind kind, Expr at, const Exact& last);
    Kind kind_;
    Expr at_; ///< for a finite target
    Exact last_;
    double decades_ = 0;
};

/// Returns log10 |x|; nothing if x contains zero or is not finite. Used only to choose where to
/// evaluate.
[[nodiscard]] std::optional<double> decades_of(const Ball& x);

/// Two samples of a sweep, in balls; the second is nearer to its end.
struct SweptPair {
    const EnclosedSample& before;
    const EnclosedSample& after;
};

/// Returns the number of decades that a formula may hide: the ratios of the terms of its sums at
/// the first sample, the digits of its numbers, the distance of a place from its edge. A small term
/// may dominate only beyond this number of decades; therefore a formula is followed until it has
/// changed by more. Infinite if a name has no value.
[[nodiscard]] double hidden_decades(const Expr& e, const SweptPair& at);

/// True if each sum of the formula (difference, maximum, minimum) has reached its final form: one
/// of the two terms dominates by a factor of at least 1000, and by more at the second sample than
/// at the first, or their ratio no longer changes. Otherwise the limit is not yet visible:
/// log(log(m)) - 9 is negative at m = 1e1000 and grows without bound. This test can only keep a
/// claim undecided.
[[nodiscard]] bool sums_are_steady(const Expr& e, const SweptPair& at);

} // namespace edgeproof::audit
