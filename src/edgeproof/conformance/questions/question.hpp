// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/input/quantity.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgeproof::conformance {

/// One entry of [profile], [load] or [shear] of a scene file, as text: exact, and the same in a
/// recipe, in a question and in an answer. The items of a list (knots, slopes) are joined by "; ".
struct Parameter {
    std::string key;
    std::string text;
    std::size_t line = 0; ///< in the file that it was read from

    /// The items of a list, or the text itself.
    [[nodiscard]] std::vector<std::string> items() const;
    void set_items(const std::vector<std::string>& items);
    /// True for kind, slopes and others: not a number, and the same for every program.
    [[nodiscard]] bool is_word() const;
    [[nodiscard]] bool is_list() const {
        return key == "knots" || key == "slopes" || key.starts_with("step_");
    }
};

/// The allowed keys of parameters with their sections, in the order of columns.
struct ParameterKey {
    std::string_view name;
    std::string_view section; ///< "profile", "load", "shear" or "steps"
};
[[nodiscard]] const std::vector<ParameterKey>& parameter_keys();

/// A profile under a load, the subject of questions. Contacts with the same parameters are equal.
struct AskedContact {
    std::vector<Parameter> parameters; ///< in the order of parameter_keys()
    scene::Scene scene;                ///< `ask` empty
};

/// Reads the parameters as in a scene file. Throws InputError with the parameter's own line of
/// `file`, or else with `line`.
[[nodiscard]] AskedContact make_asked_contact(std::vector<Parameter> parameters,
                                              const std::string& file, std::size_t line);

/// Returns the parameters with every number replaced by the exact text of the nearest binary64.
[[nodiscard]] std::vector<Parameter> rounded_to_binary64(std::vector<Parameter> parameters);
[[nodiscard]] formula::Exact rounded_to_binary64(const formula::Exact& x);

/// A value requested for a contact (scene/input/quantity.hpp).
struct Question : scene::AskedValue {
    std::string id;
    std::size_t contact = 0; ///< index into Questions::contacts
    std::size_t line = 0;    ///< in the file of the question

    [[nodiscard]] bool at_point() const { return row_of(quantity).at_point(); }
    [[nodiscard]] bool at_edge() const { return row_of(quantity).at_edge(); }
    [[nodiscard]] bool to_a_tolerance() const { return row_of(quantity).tolerance; }
};

struct Questions {
    std::string file;
    std::vector<AskedContact> contacts;
    std::vector<Question> list;

    /// The keys of parameters that occur in any contact.
    [[nodiscard]] std::vector<std::string> columns() const;
    [[nodiscard]] bool has_tolerances() const;
    [[nodiscard]] bool has_body_points() const;
    [[nodiscard]] std::set<scene::Quantity> quantities() const;
};

/// The text of a parameter; empty if the contact does not have it.
[[nodiscard]] std::string parameter_text(const AskedContact& contact, std::string_view key);

/// Returns the same questions with every number rounded to binary64, so that a program in binary64
/// can read them exactly.
[[nodiscard]] Questions rounded_to_binary64(const Questions& questions);

/// Throws InputError if the contact does not have the quantity: q or s without shear, alpha if the
/// tilt is given.
void check_askable(const AskedContact& contact, const scene::AskedValue& asked,
                   const std::string& file, std::size_t line);

/// The description of a reference table: contacts with grids of parameters, and the questions for
/// each.
///
///     title = "Wedge, Hertz and beyond"
///     digits = 50
///     rounding = "nearest"
///     [scenes.hertz]                    # any name: ids begin with it
///     edges = ["right", "left"]
///     u = ["1e-30", "a/2"]              # or x; or a range: { from, to, points }
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

/// Throws InputError with file and line for malformed input: unknown keys and names, empty grids,
/// ids that occur twice, a question that the contact cannot answer, more than a million questions.
[[nodiscard]] Recipe read_recipe(const std::filesystem::path& file);
[[nodiscard]] Recipe parse_recipe(std::string_view text, const std::string& file);

/// The reference for an answer: the value with its bound, and the coordinate x of a point.
struct Reference {
    scene::BoundedValue value;
    std::optional<scene::BoundedValue> x;
};

struct ReferenceOptions {
    scene::Digits digits;
    unsigned threads = 0; ///< 0: as many as the machine has
    /// Called with the number of values done, and their total; from any thread.
    std::function<void(std::size_t, std::size_t)> progress = {};
};

/// Returns the answer to each question, in order, independent of the number of threads. Throws
/// InputError, with the line of the question, for a point outside the contact or on a corner and
/// for a load that no contact carries; of several such errors, always the same one. Throws
/// BudgetError if a quadrature does not reach its digits; Interrupted.
[[nodiscard]] std::vector<Reference> references(const Questions& questions,
                                                const ReferenceOptions& options);

struct ReferenceOrWhy {
    std::optional<Reference> reference;
    std::string why; ///< a point outside the contact, or an exhausted budget
};
/// Like references, with a reason for each missing answer. With `strict`, throws as references()
/// does for an invalid contact; without it, such questions have no answer either. Throws
/// Interrupted.
[[nodiscard]] std::vector<ReferenceOrWhy>
references_or_why(const Questions& questions, const ReferenceOptions& options, bool strict = true);

/// A question (by index) asked in another way, by its number.
using Way = std::pair<std::size_t, std::size_t>;
/// Returns the values of questions asked in other ways, where they have one. `change` changes the
/// contact, once for all questions about it that are asked in the same way; `place` the question.
/// Both may return false, or throw Error, for a way that is none.
[[nodiscard]] std::map<Way, Ball>
values_otherwise(const Questions& questions, const std::vector<Way>& ways,
                 const std::function<bool(const Way&, AskedContact&)>& change,
                 const std::function<bool(const Way&, Question&, const scene::Scene&)>& place,
                 const ReferenceOptions& options);

/// The dependence of a value on the numbers of its question.
struct Conditioning {
    /// The relative change of the value when each number of the question (parameters, u, tolerance)
    /// changes by half a unit in the last place of its binary64: the sum over the numbers. A
    /// correct program that rounds its inputs once may have this error.
    double moved = 0;
    /// The relative condition number: `moved` in units of 2^-53.
    [[nodiscard]] double number() const { return moved * 0x1p53; }
};

/// An error of up to this multiple of `moved` is attributed to the conditioning: a correct program
/// rounds more than once.
inline constexpr double explained_by_conditioning = 8;

/// Computes the conditioning of the questions listed (by index) from the references at the two
/// neighbours half a unit away (at the upper one, or at the lower one if there is no contact
/// above), at 34 digits. Zeros are exact and are not changed. Returns nothing if neither neighbour
/// has a value, or if the value is zero.
[[nodiscard]] std::vector<std::optional<Conditioning>>
conditioning(const Questions& questions, const std::vector<Reference>& references,
             const std::vector<std::size_t>& which, ReferenceOptions options);

} // namespace edgeproof::conformance
