// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/comparison/measures/exact_contact.hpp"
#include "tests/support/injected_keys.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// Mistakes of users, in the text of a scene and in its written pressures, to test the diagnosis,
/// which has its own suspects.
namespace edgeproof::comparison {

using test::SceneKeys;

using test::TestedContact;
[[nodiscard]] const std::vector<TestedContact>& tested_contacts();

struct ComputedRow {
    double x = 0;
    double p = 0;
    std::optional<double> q = {};
};

/// A simulated program: its contact and its output.
struct Program {
    SceneKeys keys;
    /// The x that the program writes for a place x.
    std::function<double(double)> written_x = {};
    /// p at a place, instead of the contact's own.
    std::function<double(const ExactContact&, double)> p = {};
    /// Changes the rows before they are written.
    std::function<void(std::vector<ComputedRow>&)> rows = {};
    /// Significant digits of p if they are few; -1: binary32; 0: all.
    int digits = 0;
};

struct InjectedMistake {
    std::string name; ///< the name that the diagnosis should give; empty: no mistake
    bool of_shear = false;
    /// Makes the program with the mistake; nothing if the mistake is not possible in the contact.
    std::function<std::optional<Program>(const SceneKeys&)> make;
};
[[nodiscard]] const std::vector<InjectedMistake>& injected_mistakes();

/// Injects each mistake into each contact where it is possible, writes the data of 120 elements
/// with noise, reads and compares them. `contacts`: names of tested_contacts, all if empty.
[[nodiscard]] test::MistakeCounts count_named(std::uint64_t seed,
                                              const std::vector<std::string>& contacts = {});

/// The pressure of a simulated program with a penalty, to test the diagnosis
/// (causes/causes.hpp describes the problem). It shares with the diagnosis the gap alone: p
/// is linear between nodes (constant on rings, whose influence is integrated from that of a point
/// on the surface, if the contact is axisymmetric), and the contact is found by conjugate gradients
/// (polonsky-keer1999).
class SpringBed {
public:
    SpringBed(const scene::Scene& scene, const ExactContact& exact, double softness);
    [[nodiscard]] double pressure(double x) const;

private:
    using Values = std::vector<double>;
    [[nodiscard]] double influence(std::size_t at, std::size_t of) const;
    [[nodiscard]] Values displacement(const Values& p) const;
    [[nodiscard]] double total(const Values& one, const Values& other) const;
    void solve(double force, double tilt);

    bool round_;
    double softness_; ///< 1/k
    double modulus_;
    double width_;
    Values x_;
    Values gap_;
    Values weight_; ///< the force of a unit pressure
    std::vector<Values> u_;
    Values p_;
};

} // namespace edgeproof::comparison
