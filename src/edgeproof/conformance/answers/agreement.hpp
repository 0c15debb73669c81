// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/answers/answers.hpp"
#include "edgeproof/conformance/questions/conditioning.hpp"
#include "edgeproof/conformance/questions/reference.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::conformance {

/// Where in the contact a question is asked. L = a + b.
enum class Regime {
    near_edge,   ///< within L/1000 of either edge
    apex,        ///< within L/100 of the minimum of the profile
    knot,        ///< within L/100 of another place where two pieces of g' meet
    far_field,   ///< any other point nearer to the other edge than to its own
    interior,    ///< any other point
    coefficient, ///< c_k, s_k, extent_k, measure_k
    contact,     ///< a, b, P, M, alpha
    outside      ///< a point outside the contact: there is nothing to compare with
};
[[nodiscard]] std::string regime_name(Regime regime);

/// What is asked of the answers; both may be given. With neither an answer must have 12 digits, or
/// as many as the conditioning of its question leaves a program in double precision: a wrong number
/// never passes for want of a target.
struct Target {
    static constexpr double default_digits = 12;
    std::optional<double> digits; ///< |answer/exact - 1| <= 10^-digits
    std::optional<double> ulps;   ///< |answer - exact| <= so many binary64 units in the last place
    bool conditioned = false;     ///< an error that the conditioning explains passes as well

    [[nodiscard]] bool stated() const { return digits || ulps; }
    [[nodiscard]] bool forgives() const { return conditioned || !stated(); }
};

/// One answer held against its reference.
struct CaseAgreement {
    Regime regime = Regime::interior;
    double digits =
        0;           ///< -log10|answer/exact - 1|, 0 at least and as many as the reference at most
    double ulps = 0; ///< |answer - exact| in units in the last place of the binary64 of exact
    double relative = 0; ///< |answer/exact - 1|
    bool within = false; ///< the target, conditioning aside
    bool pass = false;
    std::optional<Conditioning> conditioning = {};
    bool explained = false; ///< by the conditioning: off by at most 8 times what that moves
    std::string reference;  ///< as printed, for the report
    /// Why there is no reference, where there is none: then nothing is compared, and nothing
    /// passes.
    std::string no_reference = {};
};

struct Agreements {
    std::vector<CaseAgreement> cases;  ///< one a question
    std::vector<Reference> references; ///< one a question; empty where there is none
    std::size_t estimates = 0;         ///< references without a proved bound
    unsigned digits = 0;               ///< of the references
};

inline constexpr std::size_t most_conditioned = 5000;

/// Digits that a reference needs so that a target is told apart from it.
[[nodiscard]] unsigned reference_digits(const Target& target);

/// Computes each reference at the numbers that the answer's row gives, exactly, and compares.
/// A reference that is zero is compared on the scale that P and L = a + b give it: P for a force, P
/// L for M, P/L for a traction, P/L^(k + 3/2) for c_k, and so on. The conditioning is computed for
/// every case while they are at most most_conditioned, beyond that for those that miss the target.
/// A point outside the contact has no reference; where none has one, and for a contact that is
/// none, it throws as references() does.
[[nodiscard]] Agreements compare(const Answers& answers, const Target& target,
                                 ReferenceOptions options);

/// The same of a block of more answers: the conditioning is computed for those that miss the target
/// only, and nothing is thrown where none has a reference.
[[nodiscard]] Agreements compare_block(const Answers& answers, const Target& target,
                                       ReferenceOptions options);

} // namespace edgeproof::conformance
