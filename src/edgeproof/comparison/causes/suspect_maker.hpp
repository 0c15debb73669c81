// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/causes/suspects.hpp"

namespace edgeproof::comparison {

/// Makes suspects of one scene at the nodes looked at. Keeps references to all that it is given.
class SuspectMaker {
public:
    SuspectMaker(const NodesLookedAt& nodes, SuspectContacts& contacts, const ExactContact& exact,
                 const TakeSuspect& take)
        : nodes_(nodes), contacts_(contacts), exact_(exact), take_(take) {}

    [[nodiscard]] const NodesLookedAt& nodes() const { return nodes_; }
    [[nodiscard]] const scene::Scene& scene() const { return contacts_.scene(); }
    [[nodiscard]] const ExactContact& exact() const { return exact_; }

    using Value = std::function<double(std::size_t)>;
    /// Its value at each node looked at, on the contact -b < x < a.
    void add(const std::string& name, const std::string& what, double a, double b,
             const Value& value) const;
    /// On the exact contact.
    void add(const std::string& name, const std::string& what, const Value& value) const;
    /// The pressure of the same scene with something else in it; nothing where that has no contact.
    void add_scene(const std::string& name, const std::string& what,
                   const std::function<void(scene::Scene&)>& change) const;
    /// The pressure of another contact; NaN on a corner.
    [[nodiscard]] static double pressure(const ExactContact& contact, double x);
    /// The exact pressure so many rows behind a node looked at; NaN where there is none.
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
void suspect_terms(const SuspectMaker& make);   ///< terms of an expansion in place of p

} // namespace edgeproof::comparison
