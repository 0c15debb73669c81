// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/verdict.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace edgeproof::audit {

/// A proof that a claim fails, at one sample or in one part. It can be made only from enclosures,
/// never from a value in `Real`, an exception or a limit of the program.
class Refutation {
public:
    /// Made if the balls are finite and disjoint.
    [[nodiscard]] static std::optional<Refutation> disjoint(const Ball& claimed, const Ball& found);
    /// Made if `x < y` is proved.
    [[nodiscard]] static std::optional<Refutation> less(const Ball& x, const Ball& y);

private:
    Refutation() = default;
};

/// A proof that a claim holds, at one sample or in one part. It can be made only from enclosures.
class Confirmation {
public:
    /// Made if |claimed - found| <= 10^-digits * scale, scale > 0, or exact equality is proved.
    [[nodiscard]] static std::optional<Confirmation>
    agreement(const Ball& claimed, const Ball& found, const Ball& scale, double digits);
    /// Made if `x < y` is proved.
    [[nodiscard]] static std::optional<Confirmation> less(const Ball& x, const Ball& y);
    /// Made if `lower <= x < upper` is proved.
    [[nodiscard]] static std::optional<Confirmation> within(const Ball& x, const Rational& lower,
                                                            const Rational& upper);

private:
    Confirmation() = default;
};

/// The decision by enclosures at one sample, or for one part of a claim: undecided, proved to hold,
/// or proved to fail.
using Decision = std::variant<std::monostate, Confirmation, Refutation>;

[[nodiscard]] inline bool confirms(const Decision& d) {
    return std::holds_alternative<Confirmation>(d);
}
[[nodiscard]] inline bool refutes(const Decision& d) {
    return std::holds_alternative<Refutation>(d);
}
/// Returns the refutation if there is one, else the confirmation if there is one, else nothing.
[[nodiscard]] Decision decision(const std::optional<Refutation>& fails,
                                const std::optional<Confirmation>& holds);

/// The two verdicts that need no enclosure.
enum class Undecided { undecided, underspecified };

/// The verdict of a check. `refuted` can be made only from a Refutation; `confirmed` and
/// `imprecise` only from a Confirmation.
class Judgement {
public:
    Judgement() = default;
    Judgement(Undecided verdict) // NOLINT: converts on purpose
        : verdict_(verdict == Undecided::undecided ? Verdict::undecided : Verdict::underspecified) {
    }
    explicit Judgement(const Refutation&) : verdict_(Verdict::refuted) {}
    explicit Judgement(const Confirmation&) : verdict_(Verdict::confirmed) {}
    explicit Judgement(const Decision& decision);

    /// For a claim without a value to check.
    [[nodiscard]] static Judgement definition() { return Judgement(Verdict::definition); }
    /// For formulas that are equal by symbols.
    [[nodiscard]] static Judgement proved_by_symbols() { return Judgement(Verdict::proved); }
    /// For a claim that is nearly right, such as a figure off by one unit of the last place.
    [[nodiscard]] static Judgement imprecise(const Confirmation&) {
        return Judgement(Verdict::imprecise);
    }
    /// All parts must hold; one part that fails refutes the claim. Undecided for an empty list.
    [[nodiscard]] static Judgement of_all(const std::vector<Decision>& parts);
    /// Combines the verdicts under several readings.
    [[nodiscard]] static Judgement of_readings(const std::vector<Judgement>& readings);

    operator Verdict() const noexcept { return verdict_; } // NOLINT: converts on purpose
    [[nodiscard]] Verdict verdict() const noexcept { return verdict_; }

private:
    explicit Judgement(Verdict verdict) : verdict_(verdict) {}
    Verdict verdict_ = Verdict::undecided;
};

/// The reason why a printed formula has no value at a sample: a fact about the formula.
struct NoValue {
    std::string why;
    bool proved = false; ///< true if proved by symbols or balls, false if estimated
};

/// The reason why Edgeproof found no value at a sample: a limit of the program, not of the formula.
struct OurLimit {
    std::string what;
};

/// The enclosure of a formula at a sample.
using EnclosedValue = std::variant<Ball, NoValue, OurLimit>;

} // namespace edgeproof::audit
