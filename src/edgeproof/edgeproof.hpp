// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/error.hpp"

#include <memory>
#include <span>
#include <string>
#include <vector>

/// What a contact code needs of Edgeproof, without the headers of its numbers: scenes and their
/// values, and the checks of formulas, programs and meshes. Link with edgeproof::edgeproof.
///
/// p and q are 0 outside the contact. All functions throw InputError for input that makes no sense;
/// DomainError where there is no value (on a corner); BudgetError if no number of bits that is
/// tried gives the digits. All three are edgeproof::Error.
namespace edgeproof {

/// A value of a scene, as text.
struct Value {
    std::string text;    ///< a decimal, correctly rounded to the digits asked for
    std::string bound;   ///< |text - exact| is at most this
    bool proved = false; ///< false: the bound is the route's own estimate
    std::string route;   ///< how the value was found, such as "closed-form"
};

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

private:
    friend struct Outcome compare(const Scene&, const std::vector<std::string>&,
                                  const std::string&);
    struct Solved;
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

} // namespace edgeproof
