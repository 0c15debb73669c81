// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/answers.hpp"
#include "edgeproof/conformance/reference.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof {

/// Where in the contact a question is asked. L = a + b.
enum class Regime {
    near_edge,   ///< within L/1000 of either edge
    apex,        ///< within L/100 of the minimum of the profile
    knot,        ///< within L/100 of another place where two pieces of g' meet
    interior,    ///< any other point
    coefficient, ///< c_k, s_k
    contact      ///< a, b, P, M, alpha
};
[[nodiscard]] std::string regime_name(Regime regime);

/// What is asked of the answers; both may be given, or neither: then only what is no number fails.
struct Target {
    std::optional<double> digits; ///< |answer/exact - 1| <= 10^-digits
    std::optional<double> ulps;   ///< |answer - exact| <= so many binary64 units in the last place
};

/// One answer held against its reference.
struct CaseAgreement {
    Regime regime = Regime::interior;
    double digits =
        0;           ///< -log10|answer/exact - 1|, 0 at least and as many as the reference at most
    double ulps = 0; ///< |answer - exact| in units in the last place of the binary64 of exact
    bool pass = false;
    std::string reference; ///< as printed, for the report
};

struct Agreements {
    std::vector<CaseAgreement> cases; ///< one a question
    std::vector<Reference> references;
    std::size_t estimates = 0; ///< references without a proved bound
    unsigned digits = 0;       ///< of the references
};

/// Digits that a reference needs so that a target is told apart from it.
[[nodiscard]] unsigned reference_digits(const Target& target);

/// Computes each reference at the numbers that the answer's row gives, exactly, and compares.
/// A reference that is zero is compared on the scale of P (a + b) for M, else of 1. Throws as
/// references() does.
[[nodiscard]] Agreements compare(const Answers& answers, const Target& target,
                                 ReferenceOptions options);

} // namespace edgeproof
