// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/causes/soft_contact.hpp"
#include "edgeproof/comparison/input/result_table.hpp"
#include "edgeproof/comparison/measures/alignment.hpp"
#include "edgeproof/comparison/measures/data_edges.hpp"
#include "edgeproof/comparison/measures/exact_contact.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::comparison {

/// The contacts that programs with a known mistake would have solved instead of the scene's. Each
/// is solved once, on first use, for all data compared with the scene: solving them is nearly all
/// the work of a diagnosis. One object belongs to one thread.
class SuspectContacts {
public:
    explicit SuspectContacts(scene::Scene scene) : scene_(std::move(scene)) {}

    [[nodiscard]] const scene::Scene& scene() const { return scene_; }

    /// The contact of the changed scene; `mistake` is a unique name of the change. Null if no
    /// contact carries the load of the changed scene, so that no program could have computed it.
    [[nodiscard]] const ExactContact* with(const std::string& mistake,
                                           const std::function<void(scene::Scene&)>& change);

    /// The scene's contact with springs.
    [[nodiscard]] const SoftContact& soft(const ExactContact& exact);

private:
    scene::Scene scene_;
    std::map<std::string, std::optional<ExactContact>> solved_;
    std::optional<SoftContact> soft_;
};

/// The values that a program with one mistake would write at the nodes used.
struct Suspect {
    std::string name;
    std::string what;
    double a = 0; ///< its contact is -b < x < a
    double b = 0;
    std::vector<double> values; ///< at each of those nodes; NaN where there is no value
};

/// The nodes of data that are used: if there are many, only some of them at equal steps.
struct UsedNodes {
    const AlignedResult& data;
    std::vector<std::size_t> nodes; ///< indices, in their order

    [[nodiscard]] std::size_t size() const { return nodes.size(); }
    [[nodiscard]] const Node& operator[](std::size_t i) const { return data.nodes[nodes[i]]; }
};

/// Returns every mistake in the pressure that is possible for a scene: p or x times a number, other
/// materials, sizes, angles and loads, other places, means over elements, and terms of an expansion
/// instead of p. Mistakes whose contact cannot be solved are left out. Throws Interrupted.
[[nodiscard]] std::vector<Suspect>
pressure_suspects(const UsedNodes& nodes, SuspectContacts& contacts, const ExactContact& exact);
/// Returns the mistakes in the shear traction, if the pressure is right.
[[nodiscard]] std::vector<Suspect> shear_suspects(const UsedNodes& nodes, SuspectContacts& contacts,
                                                  const ExactContact& exact);

/// A mistake that explains wrong data.
struct Cause {
    std::string name;   ///< a fixed name: "e-for-e-star", "factor-2", ...
    std::string what;   ///< a description
    double factor = 1;  ///< data over exact pressure: the median over the nodes used
    double scatter = 0; ///< rms of the remaining error, relative to the largest pressure
    std::vector<std::string> equally_likely; ///< others that fit equally well
};

/// The ratio of the data to the exact values, with its standard error from their scatter.
struct CommonFactor {
    double value = 1;
    double error = 0;
    bool of_x = false; ///< of the places, not of the values
};

struct Diagnosis {
    /// The error without any cause, and the scatter of the data: rms, relative to the largest
    /// pressure, over nodes at least two elements and a fiftieth of the contact away from the
    /// edges.
    double unexplained = 0;
    double noise = 0;
    bool at_edges_only = false;  ///< those nodes agree to three thousandths, as in a correct mesh
                                 ///< solution: the error is not due to a mistake
    bool too_few = false;        ///< fewer than eight of those nodes lie in the exact contact
    bool largest_inside = false; ///< the largest error is at one of those nodes, not near an edge
    std::vector<Cause> causes;   ///< the most likely first
    /// If no cause is found: a factor of p, q or x that explains the data as a cause would.
    std::optional<CommonFactor> factor;
};

/// Compares data with the pressures that a program with each known mistake would compute
/// (pressure_suspects()), at nodes away from the edges, by diagnose/fit.hpp and choice.hpp. In
/// addition to noise, the mesh's own error `mesh_error` (measures/measures.hpp) is allowed, at most
/// three hundredths of the largest pressure. Data that carry too few digits, or are binary32, and
/// otherwise agree, have that cause. Data that none of these explains, but the scene under the
/// force that they carry, have the cause another-force. No cause is proved.
/// Throws Interrupted.
[[nodiscard]] Diagnosis diagnose_pressure(const ResultTable& table, const AlignedResult& data,
                                          const DataContact& contact, SuspectContacts& suspects,
                                          const ExactContact& exact, double mesh_error);
/// Diagnoses the shear traction, if the pressure is right.
[[nodiscard]] Diagnosis diagnose_shear(const AlignedResult& data, const DataContact& contact,
                                       SuspectContacts& suspects, const ExactContact& exact,
                                       double mesh_error);

/// Finds pressures that carry fewer digits than are written: rounded to a number of significant
/// digits or decimals, or numbers of binary32; accepted if the errors away from the edges (by a
/// fiftieth of the contact) are no larger than this rounding explains. For binary32, 16 units in
/// the last place of the largest pressure are allowed for a computation.
[[nodiscard]] std::optional<Cause>
cause_in_digits(const ResultTable& table, const AlignedResult& data, const ExactContact& exact);

} // namespace edgeproof::comparison
