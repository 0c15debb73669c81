// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/measures/exact_contact.hpp"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// Mistakes as a user makes them, in the text of a scene and in what is written of its pressures:
/// the diagnosis, which holds data against its own suspects, is tried on them.
namespace edgeproof::comparison {

/// "profile.R" -> "2": the keys of a scene file.
using SceneKeys = std::map<std::string, std::string>;
[[nodiscard]] std::string scene_text(const SceneKeys& keys);

struct TestedContact {
    std::string name;
    SceneKeys keys;
};
[[nodiscard]] const std::vector<TestedContact>& tested_contacts();

/// A row of a result: what a program computed there.
struct ComputedRow {
    double x = 0;
    double p = 0;
    std::optional<double> q = {};
};

/// A program's contact and what it makes of it.
struct Program {
    SceneKeys keys;
    /// x as the program writes it, of its own place.
    std::function<double(double)> written_x = {};
    /// p at a place, in place of the contact's own.
    std::function<double(const ExactContact&, double)> p = {};
    /// What is done with the rows before they are written.
    std::function<void(std::vector<ComputedRow>&)> rows = {};
    /// Significant digits of p where they are few; -1: binary32.
    int digits = 0;
};

struct InjectedMistake {
    std::string name; ///< that the diagnosis should give it; empty: nothing is wrong
    bool of_shear = false;
    /// The program with the mistake; nothing where the contact has no place for it.
    std::function<std::optional<Program>(const SceneKeys&)> make;
};
[[nodiscard]] const std::vector<InjectedMistake>& injected_mistakes();

} // namespace edgeproof::comparison
