// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/comparison/input/result_table.hpp"
#include "edgeproof/comparison/measures/exact_contact.hpp"
#include "edgeproof/comparison/measures/measures.hpp"
#include "edgeproof/diagnose/diagnose.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgeproof::comparison {

/// g at the middles of elements of equal width, the first of which is `first`, up to a constant.
[[nodiscard]] std::vector<double> gap_of(const scene::Scene& scene, const ExactContact& exact,
                                         double first, double width, std::size_t elements);

/// The contact as a program with a penalty solves it: p = k times the penetration, so that a layer
/// of springs with the compliance 1/k lies between the bodies. Where p > 0,
///     u(x) + g(x) + p(x)/k = delta + phi x,
/// with the displacement u of the half-plane, or of the half-space, under p. The contact is longer,
/// p is lower, and p vanishes like u, not like u^(1/2), at its edges. P is that of the scene; so is
/// M where the scene gives it, and phi = 0 otherwise.
///
/// Boundary elements (rings, if axisymmetric) of constant p, of equal width, with the active
/// elements found by iteration (johnson1985, section 4.3, has the springs alone). All values are
/// estimates.
class SoftContact {
public:
    /// `scene`: that of `exact`. Keeps no reference to them.
    SoftContact(const scene::Scene& scene, const ExactContact& exact);

    struct Solution {
        double softness = 0; ///< E*/(k (a + b)) with the exact a and b; 0 for rigid springs
        double a = 0;        ///< p > 0 for -b < x < a
        double b = 0;
        std::vector<double> p; ///< of the elements
    };
    /// Returns nothing if the contact extends beyond the elements, by a third of a + b on each
    /// side.
    [[nodiscard]] std::optional<Solution> solve(double softness) const;
    /// Returns the solution for which `left`, a sum of squares, is least; nothing if none halves
    /// that of rigid springs.
    [[nodiscard]] std::optional<Solution>
    fitted(const std::function<double(const Solution&)>& left) const;
    /// The change of p at x by the springs, between elements by interpolation: the error of the
    /// elements themselves nearly cancels in it. NaN near an exact edge or a corner, where it does
    /// not.
    [[nodiscard]] double change(const Solution& soft, double x) const;
    /// k in units of E*/(a + b), times this number, is k in pressure per length.
    [[nodiscard]] double stiffness_unit() const { return modulus_ / length_; }

private:
    void find_influences();

    bool round_ = false;
    double modulus_ = 0; ///< E*
    double length_ = 0;  ///< a + b
    double width_ = 0;   ///< of an element
    double force_ = 0;
    std::optional<double> moment_;
    std::vector<double> special_;        ///< the exact edges, and the corners
    std::vector<double> x_;              ///< the middles of the elements
    std::vector<double> gap_;            ///< g there, up to a constant
    std::vector<std::vector<double>> u_; ///< at an element, under a unit pressure on another
    Solution rigid_;
    std::vector<Solution> soft_; ///< by softness, from springs that are nearly rigid
};

/// The values that a program with one mistake would write at the nodes used.
struct Suspect {
    std::string name;
    std::string what;
    double a = 0; ///< its contact is -b < x < a
    double b = 0;
    std::vector<double> values; ///< at each of those nodes; NaN where there is no value
};

/// Where the largest error is: near an edge of the exact contact (by two elements or a fiftieth of
/// the contact) or a corner, or elsewhere inside or outside it.
enum class Worst { near_edge, inside, outside };

/// The errors that a suspect leaves.
struct Left {
    /// Relative to the value of the node, or to a tenth of the largest one.
    diagnose::Remainders rows;
    double rms = 0;    ///< relative to the largest value
    double inside = 0; ///< the same, over the nodes in the suspect's contact
    double noise = 0;  ///< the rms scatter from node to node, relative to it
    Worst worst = Worst::near_edge;
};

/// Values of p or q that are diagnosed, and the exact ones.
struct Observed {
    const AlignedResult& data;
    std::vector<std::size_t> nodes; ///< indices of those used, in their order
    std::vector<double> values;
    Suspect right;
    double element = 0;          ///< the widest at an edge
    std::vector<double> corners; ///< where p is infinite

    [[nodiscard]] std::size_t size() const { return nodes.size(); }
    [[nodiscard]] const Node& operator[](std::size_t i) const { return data.nodes[nodes[i]]; }

    /// False at nodes within two elements, or a fiftieth of the suspect's contact, of one of its
    /// edges or of a corner.
    [[nodiscard]] bool counts(const Suspect& suspect, std::size_t i) const;
    [[nodiscard]] bool inside(const Suspect& suspect, std::size_t i) const;
    /// The data over the values of a suspect that are not 0.
    [[nodiscard]] std::vector<double> ratios(const Suspect& to) const;
    /// Every node of one parity, or without it every second of the means over three neighbours with
    /// weights 1/4, 1/2 and 1/4.
    [[nodiscard]] Observed part(std::optional<std::size_t> parity) const;
    /// A suspect on the contact -b < x < a with the values value(i) at the nodes.
    [[nodiscard]] Suspect suspect(std::string_view name, std::string what, double a, double b,
                                  const std::function<double(std::size_t)>& value) const;
    /// Returns nothing if fewer than eight nodes lie inside the suspect's contact.
    [[nodiscard]] std::optional<Left> left_by(const Suspect& suspect) const;
};
/// All nodes, or some at equal steps if there are many.
[[nodiscard]] Observed observed_in(const AlignedResult& data, const DataContact& contact,
                                   const ExactContact& exact, TractionOf of);

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

/// Returns every mistake in the pressure that is possible for a scene: p or x times a number, other
/// materials, sizes, angles and loads, other places, means over elements, and terms of an expansion
/// instead of p. Mistakes whose contact cannot be solved are left out. Throws Interrupted.
[[nodiscard]] std::vector<Suspect>
pressure_suspects(const Observed& data, SuspectContacts& contacts, const ExactContact& exact);
/// Returns the mistakes in the shear traction, if the pressure is right.
[[nodiscard]] std::vector<Suspect> shear_suspects(const Observed& data, SuspectContacts& contacts,
                                                  const ExactContact& exact);

/// A mistake that explains wrong data.
struct Cause {
    std::string name;   ///< a fixed name: "e-for-e-star", "factor-2", ...
    std::string what;   ///< a description
    double factor = 1;  ///< data over exact pressure: the median over the nodes used
    double scatter = 0; ///< rms of the remaining error, relative to the largest pressure
    std::vector<std::string> equally_likely = {}; ///< others that fit equally well
};

/// The ratio of the data to the exact values.
struct CommonFactor : diagnose::FittedFactor {
    bool of_x = false; ///< of the places, not of the values
};

struct Diagnosis {
    /// The error without any cause, and the scatter of the data: rms, relative to the largest
    /// pressure, over nodes at least two elements and a fiftieth of the contact away from the
    /// edges.
    double unexplained = 0;
    double inside = 0; ///< the same, over those of the nodes that lie in the exact contact
    double noise = 0;
    bool at_edges_only = false; ///< those nodes agree to three thousandths, as in a correct mesh
                                ///< solution: the error is not due to a mistake
    bool too_few = false;       ///< fewer than eight of those nodes lie in the exact contact
    Worst worst = Worst::near_edge;
    std::vector<Cause> causes; ///< the most likely first
    /// If no cause is found: a factor of p, q or x that explains the data as a cause would.
    std::optional<CommonFactor> factor;
};

/// Compares data with the pressures that a program with each known mistake would compute
/// (pressure_suspects()), at nodes away from the edges, by diagnose/diagnose.hpp. In
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

} // namespace edgeproof::comparison
