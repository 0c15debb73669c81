// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/answers/answers.hpp"
#include "edgeproof/conformance/questions/reference.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::conformance {

/// The position of a question in the contact. L = a + b.
enum class Regime {
    near_edge,   ///< within L/1000 of either edge
    apex,        ///< within L/100 of the minimum of the profile
    knot,        ///< within L/100 of another place where two pieces of g' meet
    far_field,   ///< any other point closer to the other edge than to its own
    interior,    ///< any other point
    coefficient, ///< c_k, s_k, extent_k, measure_k
    contact,     ///< a, b, P, M, alpha
    outside      ///< a point outside the contact, which has no reference
};
[[nodiscard]] std::string regime_name(Regime regime);

/// The accuracy required of answers; both may be given. Without a target, an answer needs 12
/// digits, or as many as the conditioning of its question allows in double precision, so that a
/// wrong number never passes.
struct Target {
    static constexpr double default_digits = 12;
    std::optional<double> digits; ///< |answer/exact - 1| <= 10^-digits
    std::optional<double> ulps;   ///< the largest |answer - exact|, in binary64 ulps
    bool conditioned = false;     ///< an error explained by the conditioning passes as well

    [[nodiscard]] bool stated() const { return digits || ulps; }
    [[nodiscard]] bool forgives() const { return conditioned || !stated(); }
};

/// The distances of the place of a question from places where differences of lengths cancel, over a
/// + b; 0: it has no such place.
struct Nearness {
    double edge = 0;         ///< of a point: u
    double other_edge = 0;   ///< of a point: a + b - u
    double apex = 0;         ///< of a point: the distance from the minimum of the profile
    double knot = 0;         ///< the same, or from the nearest knot if that is less
    double edge_to_knot = 0; ///< of another question: from an edge to the nearest knot
};

/// One answer compared with its reference.
struct CaseAgreement {
    Regime regime = Regime::interior;
    Nearness nearness = {};
    double scale = 0;    ///< of the errors, if the reference is zero
    double digits = 0;   ///< -log10|answer/exact - 1|, from 0 to the reference's digits
    double ulps = 0;     ///< |answer - exact| in units in the last place of the binary64 of exact
    double relative = 0; ///< |answer/exact - 1|
    bool within = false; ///< the target is met, without regard to conditioning
    bool pass = false;
    std::optional<Conditioning> conditioning = {};
    bool explained = false; ///< the error is at most 8 times the change due to the conditioning
    std::string reference;  ///< as printed in the report
    /// The reason why there is no reference; then nothing is compared, and the case does not pass.
    std::string no_reference = {};
};

struct Agreements {
    std::vector<CaseAgreement> cases;  ///< one per question
    std::vector<Reference> references; ///< one per question; empty if there is none
    std::size_t estimates = 0;         ///< references without a proved bound
    unsigned digits = 0;               ///< of the references
};

inline constexpr std::size_t most_conditioned = 5000;

/// Computes each reference exactly for the numbers in the answer's row, and compares. For a
/// reference that is zero, the scale of the error follows from P and L = a + b: P for a force, P L
/// for M, P/L for a traction, P/L^(k + 3/2) for c_k, and so on. The conditioning is computed for
/// every case if there are at most most_conditioned, otherwise only for those that miss the target.
/// A point outside the contact has no reference. If no case has a reference, or a contact is
/// invalid, throws as references() does.
[[nodiscard]] Agreements compare(const Answers& answers, const Target& target,
                                 ReferenceOptions options);

/// Compares other answers to the same questions, with the references of an earlier comparison. The
/// conditioning is that of the earlier one.
[[nodiscard]] Agreements compare_again(const Answers& answers, const Target& target,
                                       const Agreements& known);

} // namespace edgeproof::conformance
