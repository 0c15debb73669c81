// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/questions/question.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace edgeproof::conformance {

/// A parameter of a recipe's scene and its values.
struct GridAxis {
    std::string key;
    std::vector<std::string> values;
    std::size_t line = 0;
    bool grid = false; ///< part of the id
};

/// A scene of a recipe; every contact of its grid has the same questions.
struct GridScene {
    std::string name;
    std::size_t line = 0;
    std::vector<GridAxis> axes;
    std::vector<Question> asked; ///< for one contact; their ids lack the part of the contact
    std::size_t asked_line = 0;  ///< of the quantities
};

/// The questions of all scenes. Throws InputError for ids that may coincide, for a question that a
/// contact cannot answer, and for more than a million questions.
[[nodiscard]] Questions questions_of(const std::vector<GridScene>& scenes, const std::string& file);

} // namespace edgeproof::conformance
