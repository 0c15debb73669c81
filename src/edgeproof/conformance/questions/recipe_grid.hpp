// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/questions/question.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
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
    AskedList asked;            ///< for one contact
    std::size_t asked_line = 0; ///< of the quantities
};

/// A recipe whose grids are not expanded: the number of a row determines its content, so that
/// memory grows with the text of the recipe, but not with the number of rows.
///
/// The rows are divided into pieces that are computed one by one: some questions of one contact, or
/// several contacts with few questions each. The division does not depend on the number of threads
/// or processes.
class RecipeGrid {
public:
    /// Throws InputError with file and line as read_recipe() does. Every value of a grid is tested
    /// once; combinations of them are not.
    [[nodiscard]] static RecipeGrid read(const std::filesystem::path& file);
    [[nodiscard]] static RecipeGrid parse(std::string_view text, const std::string& file);

    [[nodiscard]] const std::string& file() const { return file_; }
    [[nodiscard]] const std::string& title() const { return title_; }
    [[nodiscard]] const scene::Digits& digits() const { return digits_; } ///< with binary64
    [[nodiscard]] std::size_t rows() const { return rows_; }
    [[nodiscard]] std::size_t pieces() const { return pieces_; }

    struct Piece {
        Questions questions;
        std::vector<std::size_t> rows; ///< ascending
    };
    /// Throws InputError if a combination of parameters is not a valid contact.
    [[nodiscard]] Piece piece(std::size_t number) const;
    [[nodiscard]] std::size_t piece_of(std::size_t row) const;
    /// Returns all questions. Throws InputError for more than a million.
    [[nodiscard]] Questions questions() const;

    /// The same as in Questions.
    [[nodiscard]] std::vector<std::string> columns() const;
    [[nodiscard]] bool has_tolerances() const;
    [[nodiscard]] std::set<scene::Quantity> quantities() const;
    /// Identifies the questions and their number of digits.
    [[nodiscard]] std::uint64_t fingerprint() const;

private:
    struct Part {
        GridScene scene;
        std::size_t contacts = 0;
        std::size_t first_row = 0;
        std::size_t first_piece = 0;
        std::size_t contacts_in_a_piece = 0;       ///< 0: a contact has several pieces
        std::vector<std::vector<std::size_t>> cut; ///< of the questions of one contact
        std::vector<std::size_t> piece_of;         ///< the inverse of `cut`
    };
    void add(GridScene scene);
    void check_names(const GridScene& scene) const;
    void check_values(const GridScene& scene) const;
    [[nodiscard]] const Part& part_of_row(std::size_t row) const;
    void ask(const Part& part, std::size_t contact, const std::vector<std::size_t>& which,
             Questions& to) const;

    [[nodiscard]] std::shared_ptr<const AskedContact> contact(const Part& part,
                                                              std::size_t number) const;

    /// The last contact used: its pieces follow one another.
    struct LastContact {
        std::mutex mutex;
        std::size_t row = 0; ///< its first row
        std::shared_ptr<const AskedContact> contact;
    };
    std::string file_;
    std::string title_;
    scene::Digits digits_;
    std::vector<Part> parts_;
    std::shared_ptr<LastContact> last_ = std::make_shared<LastContact>();
    std::size_t rows_ = 0;
    std::size_t pieces_ = 0;
};

struct RecipeText {
    std::string title;
    scene::Digits digits;
    std::vector<GridScene> scenes;
};
[[nodiscard]] RecipeText parse_recipe_text(std::string_view text, const std::string& file);

} // namespace edgeproof::conformance
