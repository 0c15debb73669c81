// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

/// What a contact code needs of Edgeproof, without the headers of its numbers: scenes and their
/// values, and the checks of formulas, programs and meshes. Link with edgeproof::edgeproof.
///
/// p and q are 0 outside the contact. All functions throw InputError for input that makes no sense;
/// DomainError where there is no value (on a corner); BudgetError if no number of bits that is
/// tried gives the digits; UndecidedError where bounds do not answer a question. All four are
/// edgeproof::Error. Interrupted is thrown after request_interruption().
namespace edgeproof {

/// Thrown if the bounds of values do not answer a question; `advice` states what to do.
class UndecidedError : public Error {
public:
    UndecidedError(const std::string& problem, std::string advice)
        : Error(problem), advice_(std::move(advice)) {}
    [[nodiscard]] const std::string& advice() const noexcept { return advice_; }

private:
    std::string advice_;
};

/// A value of a scene as text, with the enclosure of the exact value behind it.
struct Value {
    std::string text;      ///< a decimal, correctly rounded to the digits asked for
    std::string bound;     ///< |text - exact| is at most this
    bool proved = false;   ///< false: the bound is the route's own estimate
    std::string route;     ///< how the value was found, such as "closed-form"
    unsigned digits = 0;   ///< asked for
    bool complete = false; ///< `text` has all of them
    bool exact = false;    ///< the value is a rational number that is known: the ends of interval()
    struct Enclosure;
    std::shared_ptr<const Enclosure> enclosure = {};

    /// A number as scenes write it ("0.4", "pi/16"), with the route "given".
    [[nodiscard]] static Value given(const std::string& number, unsigned digits);
    /// The text at another number of digits (2 to 100,000), rounded from the value itself.
    [[nodiscard]] std::string rounded(long to_digits) const;
    /// The binary64 nearest to the exact value. Throws UndecidedError if two may be the nearest.
    [[nodiscard]] double nearest() const;
    /// Both ends of the enclosure, exactly: quotients of whole numbers in hexadecimal digits.
    [[nodiscard]] std::pair<std::string, std::string> interval() const;
    /// The whole value as text, which from_state() reads.
    [[nodiscard]] std::string state() const;
    [[nodiscard]] static Value from_state(const std::string& state);
};

/// Enclosures of the results for all numbers in the enclosures of x and y, which are treated as
/// independent; proved if both are. The digits are those of the less precise of x and y, or fewer
/// if only these are certain. Throws UndecidedError for a divisor that may be 0, DomainError for 0.
[[nodiscard]] Value operator+(const Value& x, const Value& y);
[[nodiscard]] Value operator-(const Value& x, const Value& y);
[[nodiscard]] Value operator*(const Value& x, const Value& y);
[[nodiscard]] Value operator/(const Value& x, const Value& y);
[[nodiscard]] Value operator-(const Value& x);
[[nodiscard]] Value abs(const Value& x);
/// Returns -1, 0 or 1. Throws UndecidedError where the enclosures overlap.
[[nodiscard]] int compared(const Value& x, const Value& y);

/// Called with the number of items done and of all, from any thread.
using Progress = std::function<void(std::size_t done, std::size_t total)>;

/// The keys of a section of a scene's file with their values.
using Keys =
    std::vector<std::pair<std::string, std::variant<bool, std::string, std::vector<std::string>>>>;

/// A question for a scene.
struct Query {
    /// The symbol of a quantity: p, q, a, b, P, p_max, c_0, extent_2, sxx, ... and the columns of
    /// the commands' tables (docs/cpp-api.md).
    std::string quantity;
    /// Words: u= (the distance from the edge) or x=, edge=left, at=X,Z (in a body) with body=B,
    /// tolerance=5%, reference=. Places may be formulas in the names of the scene: "u=a/2".
    std::string where = {};
};

/// The stresses at points of a body. All arrays have the same size; `mises` may be empty, and must
/// be if the scene has no Poisson's ratio.
struct Stresses {
    std::span<double> sxx, szz, sxz, tau_max, mises;
    std::span<double> bound; ///< of the error of each value at the point, proved
};

/// A contact with its load; of [ask] only `part` is used. Copies share it; several threads may use
/// one at the same time.
class Scene {
public:
    /// Reads a scene: the name of a file, words such as "kind=hertz R=10 P=500 E=210e3 nu=0.3", or
    /// a file and words for what differs, "pad.toml P=200".
    explicit Scene(const std::string& words);
    /// Reads the text of a scene's file; errors name `file`.
    [[nodiscard]] static Scene from_text(const std::string& text,
                                         const std::string& file = "scene");
    /// Makes a scene of sections, such as {"profile", {{"kind", "hertz"}, {"R", "10"}}}.
    [[nodiscard]] static Scene from_keys(const std::vector<std::pair<std::string, Keys>>& sections,
                                         const std::string& title = "");

    /// The text of the scene's file; empty for a scene of a file and words.
    [[nodiscard]] const std::string& text() const;
    /// What the scene has, as JSON: {"file", "title", "symmetric", "has_shear", "slips",
    /// "integrated", "mises": [of A, of B], "asked": {"quantities", "edges", "terms", "u",
    /// "tolerance", "digits"}}.
    [[nodiscard]] std::string facts() const;

    /// The value of a quantity, with this number of significant digits.
    [[nodiscard]] Value value(const std::string& quantity, const std::string& where = "",
                              unsigned digits = 50) const;
    /// The values of several questions, in their order. The contact is solved once for those
    /// without a tolerance or a reference.
    [[nodiscard]] std::vector<Value> values(const std::vector<Query>& queries,
                                            unsigned digits = 50) const;

    /// The pressures, and the shear tractions, at places x, as the nearest binary64: proved, 0
    /// outside the contact. Throws Error if the two arrays differ in size.
    void pressures(std::span<const double> x, std::span<double> p) const;
    void shears(std::span<const double> x, std::span<double> q) const;
    /// The stresses at places x and depths z >= 0 of body A (on which Q acts) or B. Bounds are at
    /// most 1e-12 of the mean pressure, or 2^-52 of a value that is larger.
    void stresses(std::span<const double> x, std::span<const double> z, const Stresses& at,
                  bool body_B = false) const;
    /// The values of p, q, the sum of the first n terms of p (`local`), or its relative error
    /// (`rel`) at coordinates x, or at distances from an edge ("right", "left"), as pressures().
    void binary64(const std::string& quantity, long n, const std::string& edge, bool by_x,
                  std::span<const double> places, std::span<double> values) const;

    /// The answers to the questions of the scene's [ask], with these keys in place of its own;
    /// points_x, points_z and `body` are the points of a body. As JSON: {"rows": [[quantity, order
    /// or number of terms, index, kind of place, edge, index of the place, u, state of the value
    /// (Value::from_state), reached, "stick" or "slip", covers the process zone]], "points",
    /// "places", "s_half_powers", "in_proportion", "proved"}.
    [[nodiscard]] std::string run(const Keys& asked) const;
    /// The panels of `edgeproof plot` as JSON: [{"title", "x": [label, logarithmic, range], "y",
    /// "curves": [[title, colour, dash, point, width, [x], [y], index of the curve that it marks]],
    /// "level"}]; of a stress `field` one panel that has "field": {"x", "z", "values", "title",
    /// "signed", "contact", "stick", "unbounded"} in their place.
    [[nodiscard]] std::string pictures(const Keys& asked, const std::string& field = "",
                                       bool body_B = false) const;
    /// The greatest mises or tau_max in a body (of revolution: on its axis, which
    /// is all of the body for a sphere), or sxx on its surface,
    /// as JSON: {"value", "x", "z": states of values, "notes"}.
    [[nodiscard]] std::string greatest(const std::string& quantity, bool body_B,
                                       unsigned digits) const;
    /// The coefficients of sxx, szz and sxz along a ray at an angle (degrees) to the contact, with
    /// the edges and terms of `asked`, as JSON: [[edge, halves (of r^(halves/2)), three states]].
    [[nodiscard]] std::string stress_terms(const Keys& asked, const std::string& angle,
                                           bool body_B) const;

    struct Solved;
    [[nodiscard]] const Solved& solved() const { return *solved_; }

private:
    explicit Scene(std::shared_ptr<const Solved> solved) : solved_(std::move(solved)) {}
    std::shared_ptr<const Solved> solved_;
};

/// The verdict on a printed formula or sentence.
struct Verdict {
    std::string id;
    std::string verdict; ///< "proved", "confirmed", "imprecise", "refuted", ...
    std::string correct; ///< the correct formula, if one was found
    std::string note;
};

/// Judges the claims of a ledger (docs/guide/checks.md).
[[nodiscard]] std::vector<Verdict> verify(const std::string& ledger, unsigned digits = 50);

/// What a check found.
struct Outcome {
    bool passes = false;
    std::string text; ///< the report
    std::string json; ///< the same as `edgeproof check --json` and `compare --json` print
};

/// Compares the answers of a program (CSV with the columns id and value) to the questions of a
/// recipe with reference values, with an error of at most 10^-digits.
[[nodiscard]] Outcome check(const std::string& recipe, const std::string& answers, double digits);

/// Compares results of meshes (tables of x and p) with the exact contact. `tolerance`: of p,
/// relative to the greatest pressure, such as "3%".
[[nodiscard]] Outcome compare(const Scene& scene, const std::vector<std::string>& results,
                              const std::string& tolerance = "3%");

/// The commands for other languages: answers are JSON, as the commands print it.
namespace json {

using Options = std::map<std::string, std::string, std::less<>>;

/// The text of an input. Throws InputError that calls it `what` if it cannot be read.
[[nodiscard]] std::string read_text(const std::string& file, const std::string& what);

/// verdicts.json with "source", "counts" (a line), and "differences" from the recorded verdicts
/// (null if there are none). `only`: a pattern of ids. `threads` 0: as many as the machine has.
[[nodiscard]] std::string verify(const Progress& progress, const std::string& ledger, long digits,
                                 const std::string& only, long threads);

/// The questions of a recipe with their numbers in binary64: an object for each.
[[nodiscard]] std::string questions(const std::string& recipe);

/// Compares answers with the references. Options: `answers`, the text of a file, with its `name` in
/// errors, and perhaps the `recipe`; or `command`, a program that answers the recipe, with
/// `seconds` for a run; digits, ulps, conditioned, threads. {"passed", "text", "faults", "cases":
/// [{"id", "quantity", "regime", "value", "state", "reference", "digits", "ulps", "relative",
/// "passed", "explained", "no_reference"}], "conventions": [{"of", "relation", "digits", "rows",
/// "failing", "hint", "also"}], "estimates"}; errors and digits are texts, as they may be infinite.
[[nodiscard]] std::string check(const Progress& progress, const Options& options);

/// Compares texts of results, each with its name. Options: columns, scale, origin, tolerance, of,
/// edge_zone, tolerance_a, tolerance_P, tolerance_c0, partial (docs/compare.md).
[[nodiscard]] Outcome compare(const Progress& progress, const Scene& scene, const std::string& name,
                              const std::vector<std::pair<std::string, std::string>>& results,
                              const Options& options);

/// The best parameter of a scene with a range: the table of `edgeproof design`, and values as
/// states. Options: gap, digits, and maximise, tolerance, edge, terms of [design].
[[nodiscard]] std::string design(const Progress& progress, const std::string& text,
                                 const std::string& file, const Options& options);

/// The relations between quantities; `given`: names that are not free, as formulas.
[[nodiscard]] std::string relations(const std::vector<std::string>& quantities, long degree,
                                    bool symmetric,
                                    const std::vector<std::pair<std::string, std::string>>& given,
                                    const std::vector<std::string>& free);

} // namespace json

} // namespace edgeproof
