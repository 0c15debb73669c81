// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/scene/scene.hpp"
#include "tests/support/namespaces.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

/// Scenes in words, and the tables of this folder.
namespace edgeproof::scenes {

[[nodiscard]] std::vector<std::string> words_of(const std::string& text);

/// Returns the scene file of "axisymmetric piecewise symmetric knots=1/2 slopes=x;1/2 a=6/5 E=7/3
/// friction=1/2 [P=1] [Q=1/10,cycles=2] u=0.1;0.2". A word without "=" is the kind of the profile,
/// or one of axisymmetric, symmetric and [shear]; E is the contact modulus, 1 unless moduli are
/// given; [..] is a step; ";" separates the elements of a list; a value after "==" is TOML. The
/// section of a key follows from its name, or is written: units.length=mm, design.terms==2. Each
/// key has a line, under its section. A key that is given again has the last value; an empty value
/// leaves it out.
[[nodiscard]] std::string toml_of(const std::string& words);
/// Returns the scene in words, or the scene "@FILE" of the repository.
[[nodiscard]] Scene made(const std::string& words);

/// Returns a value of a scene, rounded to binary64.
[[nodiscard]] inline double number_of(const Scene& of, const scene::AskedValue& asked) {
    scene::SceneValues values(of, {asked}, {40});
    return values.value(asked).value.midpoint().convert_to<double>();
}

/// A row "SCENE | CELL | CELL ..." of a table.
struct TableRow {
    std::string at; ///< FILE:LINE
    std::string scene;
    std::vector<std::string> cells;
    bool slow = false;
    bool continues = false; ///< the row above
};

/// Reads a table, relative to the folder tests. A line "NAME := WORDS" gives a scene a name, which
/// may begin the words of others; a row without a scene continues the row above it; the rows after
/// the line "slow" belong to the slow tests.
[[nodiscard]] std::vector<TableRow> rows_of(const std::string& table);

} // namespace edgeproof::scenes
