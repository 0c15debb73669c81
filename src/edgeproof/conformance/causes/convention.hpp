// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/conformance/answers/answers.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::conformance {

/// A different convention that would explain failures; they still fail, but can be corrected.
struct Convention {
    std::string of;       ///< the quantities explained: "p", "p, left edge", "c_1", "p; P"
    std::string relation; ///< "2 times ours"
    double digits = 0;    ///< the digits of the relation in the worst of the rows explained
    std::size_t rows = 0; ///< rows explained
    std::size_t failing = 0;
    std::string hint; ///< the possible cause and its correction
    /// Other relations that fit equally well: the answers do not distinguish them.
    std::vector<std::string> also = {};
    double held = 0; ///< the digits of the relation in nine of ten rows
    /// The name of the cause, as in `edgeproof compare` (diagnose/diagnose.hpp); "factor" for a
    /// constant without a name, "varying-factor" for one that is no constant, near named ones.
    std::string name = {};
    double factor = 1;                            ///< of the answers, where the relation has one
    std::vector<std::string> equally_likely = {}; ///< the names of the relations in `also`
    /// The relative error that nine of ten rows do not exceed after the correction. Not 0 only if
    /// the error does not scatter as noise does, so that there is another cause.
    double remains = 0;
    bool without_digits = false;         ///< `relation` holds for no number of digits
    std::vector<std::size_t> which = {}; ///< the questions explained, if they are not a whole group
};

inline constexpr std::size_t most_failing = 10'000;

/// The values of questions (by index) under other interpretations, by the name of the
/// interpretation; nothing where there is none.
using KnownReadings = std::map<std::string, std::map<std::size_t, std::optional<Real>>>;

/// Searches the failing rows for numbers of few digits, for a loss of digits that follows a
/// distance, for questions interpreted differently (readings.hpp), and for a uniform factor (2,
/// 1/2, pi, units of other systems, ... or any other), a sign, and exchanged edges: for each
/// quantity at both edges, else at one. A cause is accepted if at least 3 failing rows, and 9 of
/// 10, follow it within their own scatter, this scatter is below 12 %, and it leaves less than a
/// quarter of the error (diagnose/diagnose.hpp). Causes that the scatter does not distinguish are
/// listed together; of these the cause is reported that explains most rows of all quantities, once
/// for all that it explains. Causes that would have made right answers wrong are left out if others
/// remain. A factor without a name, of the values, the load, x or u, is fitted to answers that no
/// cause with a name explains, and is reported only if the remaining errors scatter from point to
/// point: then it is constant to the accuracy of the answers. If a quantity has no cause, and its
/// answers are a factor with a name times ours to a tenth, this interval of factors is reported.
///
/// Of more than `most_failing` rows with wrong values, the first ones are used.
///
/// `known`: the values of other interpretations; those missing are added. It may be used again for
/// other answers to the same questions.
[[nodiscard]] std::vector<Convention> infer_conventions(const Answers& answers,
                                                        const Agreements& agreements,
                                                        const ReferenceOptions& options,
                                                        KnownReadings* known = nullptr);

/// Checks if answers that miss the target are in single precision, or were written with few digits.
/// Each quantity is checked separately.
[[nodiscard]] std::vector<Convention> infer_precision_loss(const Answers& answers,
                                                           const Agreements& agreements);

/// Checks if answers lose digits as a distance decreases: u, the distance from the other edge, from
/// a knot, or of an edge from a knot. The digits of nearly all rows of a quantity must follow a
/// line whose value at the distance a + b is the number of digits of binary64 or binary32, and the
/// errors must scatter as those of rounding do. The rows explained are in `which`.
[[nodiscard]] std::vector<Convention> infer_cancellation(const Answers& answers,
                                                         const Agreements& agreements);

/// Returns the quantities with three or more failing rows that none of the conventions explains.
[[nodiscard]] std::vector<std::string> unexplained(const Answers& answers,
                                                   const Agreements& agreements,
                                                   const std::vector<Convention>& conventions);

} // namespace edgeproof::conformance
