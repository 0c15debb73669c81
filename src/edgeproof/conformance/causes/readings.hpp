// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/causes/wrong_rows.hpp"
#include "edgeproof/diagnose/mistakes.hpp"
#include "edgeproof/precision/real.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::conformance {

/// Another interpretation of questions.
struct Reading {
    using Mistakes = std::vector<diagnose::Mistake>; ///< of a contact

    std::string name; ///< of the cause (diagnose/mistakes.hpp)
    std::string relation;
    std::string hint;
    /// Changes the contact to that interpretation; false if this does not change it. Null: the
    /// contact is as in the question.
    std::function<bool(scene::Scene&, const Mistakes&)> contact = {};
    /// Changes the place of a question of that contact. Null: places are as in the question.
    std::function<bool(Question&, const scene::Scene&)> place = {};
    /// Changes the value. Null: it stays.
    std::function<std::optional<Real>(const Real&)> value = {};
    std::string only = {}; ///< the profiles that it is restricted to
};

/// The interpretations that change a question about the contacts of failing rows: the mistakes of
/// the catalogue, x for u, another edge, terms of the expansion for the pressure, the constant of
/// the gap for that of the slope, and the decimal logarithm of the value. Each value is computed
/// once.
class Readings {
public:
    Readings(const Answers& answers, const Agreements& agreements,
             const std::vector<std::size_t>& failing, ReferenceOptions options,
             KnownReadings& known);

    [[nodiscard]] const std::vector<Reading>& list() const { return list_; }
    /// The references of the questions in an interpretation; nothing for those that it does not
    /// change or that have no value other than 0.
    [[nodiscard]] Values values(std::size_t reading, const std::vector<std::size_t>& questions);
    /// True if a reading of the contact would have made a quantity wrong that is right, by more
    /// than `most`.
    [[nodiscard]] bool contradicted(std::size_t reading, double most);

private:
    void find(const std::vector<std::size_t>& contacts);
    [[nodiscard]] Values found(const Reading& reading, const std::vector<std::size_t>& which);
    [[nodiscard]] const Reading::Mistakes& mistakes_in(std::size_t contact);

    const Answers& answers_;
    const Agreements& agreements_;
    ReferenceOptions options_;
    KnownReadings& known_;
    std::vector<Reading> list_;
    std::map<std::size_t, Reading::Mistakes> mistakes_;
    std::vector<std::vector<std::size_t>> right_; ///< some right rows of each quantity
};

/// Searches rows with wrong values for questions interpreted differently and for
/// factors, as infer_conventions() describes. `known`: as there.
[[nodiscard]] std::vector<Convention> causes_of_wrong_rows(const Answers& answers,
                                                           const Agreements& agreements,
                                                           const std::vector<std::size_t>& failing,
                                                           const ReferenceOptions& options,
                                                           KnownReadings& known);

} // namespace edgeproof::conformance
