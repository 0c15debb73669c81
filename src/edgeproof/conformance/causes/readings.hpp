// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/causes/convention.hpp"
#include "edgeproof/precision/real.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace edgeproof::conformance {

/// Another interpretation of questions.
struct Reading {
    std::string name; ///< of the cause (scene_mistakes.hpp)
    std::string relation;
    std::string hint;
    /// Changes the contact to that interpretation; false if this does not change it. Null: the
    /// contact is as in the question.
    std::function<bool(scene::Scene&)> contact = {};
    /// Changes the place of a question of that contact. Null: places are as in the question.
    std::function<bool(Question&, const scene::Scene&)> place = {};
    int length_power = 0; ///< the value is multiplied by this power of a + b
    /// Changes the value. Null: it stays.
    std::function<std::optional<Real>(const Real&)> value = {};
    std::string only = {}; ///< the profiles that it is restricted to
};

/// Returns a name that no other reading of the same questions has.
[[nodiscard]] std::string key_of(const Reading& reading);

/// Returns the references of the questions listed (by index) in that interpretation; nothing for
/// those that it does not change or that have no value other than 0.
[[nodiscard]] std::vector<std::optional<Real>>
values_read_otherwise(const Answers& answers, const Agreements& agreements, const Reading& reading,
                      const std::vector<std::size_t>& which, const ReferenceOptions& options);

/// Returns the interpretations of which at least one changes a question about one of these contacts
/// (by index): the mistakes of the catalogue (scene/mistakes), x for u, another edge, terms of the
/// expansion for the pressure, the constant of the gap for that of the slope, and functions of the
/// value.
[[nodiscard]] std::vector<Reading> readings_of(const Questions& questions,
                                               const std::set<std::size_t>& contacts);

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

/// A factor with a cause: 2, pi, units of other systems, -1, ...
struct NamedFactor {
    Real value;
    std::string words; ///< "2 times ", "minus "
    const char* hint;
    const char* name;
    bool common; ///< more likely than a mistake in the data of a scene
};
[[nodiscard]] std::vector<NamedFactor> named_factors();

} // namespace edgeproof::conformance
