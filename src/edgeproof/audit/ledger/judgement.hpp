// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace edgeproof::audit {

/// The verdict on a claim; always computed, never written in a ledger.
enum class Verdict {
    proved,         ///< by a symbolic identity: printed minus derived is zero
    confirmed,      ///< agrees to the digits needed at every sample, or rounds to what is quoted
    imprecise,      ///< off by one unit in the last quoted place, or true under one reading only
    refuted,        ///< proved wrong by enclosures
    underspecified, ///< cannot be evaluated as printed
    undecided,      ///< the evidence at the budget given does not decide
    definition,     ///< nothing to check
};

inline constexpr std::array all_verdicts{
    Verdict::proved,         Verdict::confirmed, Verdict::imprecise, Verdict::refuted,
    Verdict::underspecified, Verdict::undecided, Verdict::definition};

[[nodiscard]] std::string_view name_of(Verdict verdict);

/// True if the claim is right as it stands.
[[nodiscard]] constexpr bool holds(Verdict verdict) {
    return verdict == Verdict::proved || verdict == Verdict::confirmed ||
           verdict == Verdict::definition;
}

/// A proof that a claim fails, at one sample or in one part. It can be made only from enclosures,
/// never from a value in `Real`, an exception or a limit of the program.
class Refutation {
public:
    /// Made if the balls are finite and disjoint.
    [[nodiscard]] static std::optional<Refutation> disjoint(const Ball& claimed, const Ball& found);
    /// Made if `x < y` is proved, or with `or_equal` `x <= y`.
    [[nodiscard]] static std::optional<Refutation> less(const Ball& x, const Ball& y,
                                                        bool or_equal = false);

private:
    Refutation() = default;
};

/// A proof that a claim holds, at one sample or in one part. It can be made only from enclosures.
class Confirmation {
public:
    /// Made if |claimed - found| <= 10^-digits * scale, scale > 0, or exact equality is proved.
    [[nodiscard]] static std::optional<Confirmation>
    agreement(const Ball& claimed, const Ball& found, const Ball& scale, double digits);
    /// Made if `x < y` is proved, or with `or_equal` `x <= y`.
    [[nodiscard]] static std::optional<Confirmation> less(const Ball& x, const Ball& y,
                                                          bool or_equal = false);
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
/// True if the enclosures decide nothing.
[[nodiscard]] inline bool is_open(const Decision& d) {
    return std::holds_alternative<std::monostate>(d);
}
/// Returns the refutation if there is one, else the confirmation if there is one, else nothing.
[[nodiscard]] Decision decision(const std::optional<Refutation>& fails,
                                const std::optional<Confirmation>& holds);

/// Whether two values that should be equal agree to the digits, relative to the scale, as in
/// Confirmation::agreement; else they fail if they differ by more. Without a scale they fail if
/// they are not equal.
[[nodiscard]] Decision equality(const Ball& claimed, const Ball& found,
                                const std::optional<Ball>& scale, double digits);

/// The verdict of a check. `refuted` can be made only from a Refutation; `confirmed` and
/// `imprecise` only from a Confirmation.
class Judgement {
public:
    Judgement() = default;
    explicit Judgement(const Decision& decision);

    /// For a claim that cannot be evaluated as printed.
    [[nodiscard]] static Judgement underspecified() { return Judgement(Verdict::underspecified); }
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

/// The reasons for a verdict: keys with texts, integers, Booleans, lists or nested evidence, in the
/// order in which they were added, which JSON and the tables keep. Computed numbers are stored as
/// text, already rounded.
using Evidence = nlohmann::ordered_json;

/// A coefficient of a printed expansion, and the right one.
struct WrongCoefficient {
    std::string of; ///< the power
    formula::Expr printed;
    formula::Expr correct;
};

/// Whether a printed expansion follows from another formula, which is given in words.
struct Hypothesis {
    std::string words;
    bool gives_the_line = false;
    [[nodiscard]] std::string text() const {
        return gives_the_line ? "gives the printed line" : "does not give the printed line";
    }
};

/// The result of a check.
struct Outcome {
    Judgement verdict;
    std::string note;                    ///< one line for the table
    std::optional<std::string> correct;  ///< the corrected formula, itself confirmed or proved
    std::optional<std::string> computed; ///< the computed figure or formula
    Evidence evidence = Evidence::object();
    std::optional<WrongCoefficient> wrong_coefficient; ///< the first of an expansion
    std::vector<Hypothesis> as_if;
};

/// Confirmed as a rounded formula: right to the printed digits of its decimals.
[[nodiscard]] inline bool is_rounded(const Outcome& outcome) {
    return outcome.verdict == Verdict::confirmed && outcome.evidence.contains("rounded");
}

} // namespace edgeproof::audit
