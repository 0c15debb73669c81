// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/questions/question.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::conformance {

/// The description of a reference table: contacts with grids of parameters, and the questions for
/// each.
///
///     title = "Wedge, Hertz and beyond"
///     digits = 50
///     rounding = "nearest"
///     [scenes.hertz]                    # any name: ids begin with it
///     edges = ["right", "left"]
///     u = ["1e-30", "0.1"]              # or { from, to, per_decade } or { from, to, points }
///     quantities = ["p", "c_0", "P"]    # p, q, c_k, s_k, a, b, P, M, alpha, extent_k, measure_k
///     tolerance = ["1%", "5%"]          # of extents
///     [scenes.hertz.profile]            # as in a scene, but a list or a range is a grid of values
///     kind = "power-law"
///     m = ["1", "2"]
///     C = "1"
///     [scenes.hertz.load]
///     a = "1"
///     contact_modulus = "1"
///
/// The id of a question consists of the scene's name, the parameters given as a grid, the edge, u
/// and the quantity ("hertz:m=2:right:u=0.1:p"); it does not change when the recipe grows. Order:
/// scenes as in the file; grids with the last key varying fastest; for each contact first the
/// quantities without an edge, then for each edge coefficients, extents by tolerance, and the
/// points; quantities as listed.
struct Recipe {
    std::string file;
    std::string title;
    scene::Digits digits; ///< with binary64
    Questions questions;
};

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

    /// Returns the recipe with the first contact of each scene only, and AskedList::sample() of its
    /// questions: enough to find the columns of the table.
    [[nodiscard]] Recipe sample() const;
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

/// Throws InputError with file and line for malformed input: unknown keys and names, empty grids,
/// ids that occur twice, a question that the contact cannot answer, more than a million questions
/// (recipe_grid.hpp allows more).
[[nodiscard]] Recipe read_recipe(const std::filesystem::path& file);
[[nodiscard]] Recipe parse_recipe(std::string_view text, const std::string& file);

} // namespace edgeproof::conformance
