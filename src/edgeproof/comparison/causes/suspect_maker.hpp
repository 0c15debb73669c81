// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/causes/suspects.hpp"

namespace edgeproof::comparison {

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
