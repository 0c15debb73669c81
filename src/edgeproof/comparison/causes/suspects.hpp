// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/measures/alignment.hpp"
#include "edgeproof/comparison/measures/exact_contact.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
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

private:
    scene::Scene scene_;
    std::map<std::string, std::unique_ptr<ExactContact>> solved_;
};

/// The values that a program with one mistake would write at the nodes used.
struct Suspect {
    std::string name;
    std::string what;
    double a = 0; ///< its contact is -b < x < a
    double b = 0;
    std::vector<double> values; ///< at each of those nodes; NaN where there is no value
};
using TakeSuspect = std::function<void(const Suspect&)>;

/// The nodes of data that are used: if there are many, only some of them at equal steps.
struct NodesLookedAt {
    const AlignedResult& data;
    std::vector<std::size_t> nodes; ///< indices, in their order

    [[nodiscard]] std::size_t size() const { return nodes.size(); }
    [[nodiscard]] const Node& operator[](std::size_t i) const { return data.nodes[nodes[i]]; }
};

/// Calls `take` with every mistake in the pressure that is possible for a scene, one after another.
/// Mistakes whose contact cannot be solved are left out.
void for_each_suspect(const NodesLookedAt& nodes, SuspectContacts& contacts,
                      const ExactContact& exact, const TakeSuspect& take);
/// Calls `take` with the mistakes in the shear traction, if the pressure is right.
void for_each_shear_suspect(const NodesLookedAt& nodes, SuspectContacts& contacts,
                            const ExactContact& exact, const TakeSuspect& take);

/// Makes suspects of one scene at the nodes used. Keeps references to all arguments.
class SuspectMaker {
public:
    SuspectMaker(const NodesLookedAt& nodes, SuspectContacts& contacts, const ExactContact& exact,
                 const TakeSuspect& take)
        : nodes_(nodes), contacts_(contacts), exact_(exact), take_(take) {}

    [[nodiscard]] const NodesLookedAt& nodes() const { return nodes_; }
    [[nodiscard]] const scene::Scene& scene() const { return contacts_.scene(); }
    [[nodiscard]] const ExactContact& exact() const { return exact_; }

    using Value = std::function<double(std::size_t)>;
    /// Adds a suspect with `value` at each node used, on the contact -b < x < a.
    void add(const std::string& name, const std::string& what, double a, double b,
             const Value& value) const;
    /// Adds a suspect on the exact contact.
    void add(const std::string& name, const std::string& what, const Value& value) const;
    /// Adds the pressure of the changed scene, if that has a contact.
    void add_scene(const std::string& name, const std::string& what,
                   const std::function<void(scene::Scene&)>& change) const;
    /// The pressure of another contact; NaN on a corner.
    [[nodiscard]] static double pressure(const ExactContact& contact, double x);
    /// The exact pressure `rows` rows after a node used; NaN if there is no such row.
    [[nodiscard]] double exact_pressure(std::size_t i, std::ptrdiff_t rows = 0) const;

private:
    const NodesLookedAt& nodes_;
    SuspectContacts& contacts_;
    const ExactContact& exact_;
    const TakeSuspect& take_;
};

void suspect_factors(const SuspectMaker& make); ///< p or x times a number
void suspect_scenes(const SuspectMaker& make);  ///< other materials, sizes, angles, loads
void suspect_places(const SuspectMaker& make);  ///< other places, means over elements
void suspect_terms(const SuspectMaker& make);   ///< terms of an expansion instead of p

} // namespace edgeproof::comparison
