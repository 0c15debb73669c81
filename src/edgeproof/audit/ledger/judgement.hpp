// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/verdict.hpp"
#include "edgeproof/precision/arithmetic.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/real.hpp"

#include <optional>
#include <string>
#include <variant>

namespace edgeproof::audit {

/// A difference that was computed between what is claimed and what is so. It is made of values
/// that were found and of nothing else; no refutation can be written without one (Judgement).
class Difference {
public:
    /// The balls have no number in common: proved. Nothing where one is not finite.
    [[nodiscard]] static std::optional<Difference> of(const Ball& claimed, const Ball& found);
    /// |claimed - found| > error, both finite; `error` is an estimate of what both may be off by.
    [[nodiscard]] static std::optional<Difference> of(const Real& claimed, const Real& found,
                                                      const Real& error);
    /// The claim has `found` above `bound`; it is not, both finite.
    [[nodiscard]] static std::optional<Difference> not_above(const Real& bound, const Real& found);
    [[nodiscard]] static std::optional<Difference> not_above(const Float128& bound,
                                                             const Float128& found);

private:
    Difference() = default;
};

/// A verdict that needs no difference: all but one.
enum class NotRefuted { proved, confirmed, imprecise, underspecified, undecided, definition };

/// A verdict as a check finds it. `refuted` is made of a Difference only, so that no exception, no
/// limit and no value that is missing can become one: there is nothing to make it of.
class Judgement {
public:
    Judgement() = default;
    Judgement(NotRefuted verdict); // NOLINT: converts on purpose
    explicit Judgement(const Difference&) : verdict_(Verdict::refuted) {}
    /// Refuted, if there is a difference, else undecided.
    explicit Judgement(const std::optional<Difference>& difference)
        : verdict_(difference ? Verdict::refuted : Verdict::undecided) {}

    operator Verdict() const noexcept { return verdict_; } // NOLINT: converts on purpose
    [[nodiscard]] Verdict verdict() const noexcept { return verdict_; }

private:
    Verdict verdict_ = Verdict::undecided;
};

/// Why a printed formula has no value at a sample: a fact about the formula.
struct NoValue {
    std::string why;
    bool proved = false; ///< by symbols or balls; else an estimate says so
};

/// Why Edgeproof found no value at a sample: says nothing about the formula.
struct OurLimit {
    std::string what;
};

/// What a formula comes to at a sample in ball arithmetic.
using EnclosedValue = std::variant<Ball, NoValue, OurLimit>;

} // namespace edgeproof::audit
