// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/causes/convention.hpp"
#include "edgeproof/precision/real.hpp"

#include <cstddef>
#include <functional>
#include <optional>
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
};

/// Returns the references of the questions listed (by index) in that interpretation; nothing for
/// those that it does not change or that have no value other than 0.
[[nodiscard]] std::vector<std::optional<Real>>
values_read_otherwise(const Answers& answers, const Agreements& agreements, const Reading& reading,
                      const std::vector<std::size_t>& which, const ReferenceOptions& options);

/// Checks if the answers listed (by index) would be right with another interpretation of the
/// numbers in their questions: degrees for radians, a width for a half-width, a diameter for a
/// radius, x for u, the modulus of one body for the composite one, the constant of the gap for that
/// of the slope, the sign of a force; or a mean pressure given instead of a force. Each quantity is
/// checked separately.
[[nodiscard]] std::vector<Convention> infer_readings(const Answers& answers,
                                                     const Agreements& agreements,
                                                     const std::vector<std::size_t>& failing,
                                                     ReferenceOptions options);

/// Checks if answers that miss the target are in single precision, or were written with few digits.
/// Each quantity is checked separately.
[[nodiscard]] std::vector<Convention> infer_precision_loss(const Answers& answers,
                                                           const Agreements& agreements);

/// A failing row: the ratio of the answer to the reference, and to the reference at the other edge.
struct FailingRow {
    std::size_t question;
    Real ratio;
    std::optional<Real> mirrored;
};

/// Checks if the answers are the references, at the same or at the other edge, times one number
/// other than 1. The number is the median ratio; its scatter determines which named factors are
/// possible. The nearest of these is reported, and the others are listed. `named`: only a factor
/// with a name; else any.
[[nodiscard]] std::optional<Convention>
infer_factor(const std::string& of, const std::vector<FailingRow>& rows, bool named);

} // namespace edgeproof::conformance
