// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/verdict.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace edgeproof::audit {

/// A proof that a claim fails, at one sample or for a part of it. It is made of enclosures only:
/// no value in `Real`, no exception and no limit of ours can be turned into one.
class Refutation {
public:
    /// The balls are finite and have no number in common.
    [[nodiscard]] static std::optional<Refutation> disjoint(const Ball& claimed, const Ball& found);
    /// `x < y` is proved.
    [[nodiscard]] static std::optional<Refutation> less(const Ball& x, const Ball& y);

private:
    Refutation() = default;
};

/// A proof that a claim holds, at one sample or for a part of it. It is made of enclosures only.
class Confirmation {
public:
    /// |claimed - found| <= 10^-digits * scale is proved, scale > 0; or both are exactly equal.
    [[nodiscard]] static std::optional<Confirmation>
    agreement(const Ball& claimed, const Ball& found, const Ball& scale, double digits);
    /// `x < y` is proved.
    [[nodiscard]] static std::optional<Confirmation> less(const Ball& x, const Ball& y);
    /// `lower <= x < upper` is proved.
    [[nodiscard]] static std::optional<Confirmation> within(const Ball& x, const Rational& lower,
                                                            const Rational& upper);

private:
    Confirmation() = default;
};

/// What enclosures decide at one sample, or for one part of a claim: nothing, that it holds, or
/// that it fails.
using Decision = std::variant<std::monostate, Confirmation, Refutation>;

[[nodiscard]] inline bool confirms(const Decision& d) {
    return std::holds_alternative<Confirmation>(d);
}
[[nodiscard]] inline bool refutes(const Decision& d) {
    return std::holds_alternative<Refutation>(d);
}
/// The refutation, if there is one; else the confirmation, if there is one; else nothing.
[[nodiscard]] Decision decision(const std::optional<Refutation>& fails,
                                const std::optional<Confirmation>& holds);

/// A verdict that rests on symbols, or that decides nothing.
enum class Undecided { undecided, underspecified };

/// A verdict as a check finds it. `refuted` is made of a Refutation only, `confirmed` and
/// `imprecise` of a Confirmation only.
class Judgement {
public:
    Judgement() = default;
    Judgement(Undecided verdict) // NOLINT: converts on purpose
        : verdict_(verdict == Undecided::undecided ? Verdict::undecided : Verdict::underspecified) {
    }
    explicit Judgement(const Refutation&) : verdict_(Verdict::refuted) {}
    explicit Judgement(const Confirmation&) : verdict_(Verdict::confirmed) {}
    explicit Judgement(const Decision& decision);

    /// Nothing in the claim has a value to check.
    [[nodiscard]] static Judgement definition() { return Judgement(Verdict::definition); }
    /// Equal by symbols.
    [[nodiscard]] static Judgement proved_by_symbols() { return Judgement(Verdict::proved); }
    /// True of less than is printed: off by one unit of the last quoted place, for instance.
    [[nodiscard]] static Judgement imprecise(const Confirmation&) {
        return Judgement(Verdict::imprecise);
    }
    /// All parts must hold; one that fails refutes. Undecided where there are none.
    [[nodiscard]] static Judgement of_all(const std::vector<Decision>& parts);
    /// What follows for a claim from its verdicts under several readings.
    [[nodiscard]] static Judgement of_readings(const std::vector<Judgement>& readings);

    operator Verdict() const noexcept { return verdict_; } // NOLINT: converts on purpose
    [[nodiscard]] Verdict verdict() const noexcept { return verdict_; }

private:
    explicit Judgement(Verdict verdict) : verdict_(verdict) {}
    Verdict verdict_ = Verdict::undecided;
};

/// Why a printed formula has no value at a sample: a fact about the formula.
struct NoValue {
    std::string why;
    bool proved = false; ///< by symbols or balls; else by an estimate
};

/// Why Edgeproof found no value at a sample: it says nothing about the formula.
struct OurLimit {
    std::string what;
};

/// The enclosure of a formula at a sample.
using EnclosedValue = std::variant<Ball, NoValue, OurLimit>;

} // namespace edgeproof::audit
