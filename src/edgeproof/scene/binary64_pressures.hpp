// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <memory>
#include <span>

namespace edgeproof::scene {

/// Many pressures of one scene as binary64: each is the binary64 nearest to the exact p (ties to
/// even). The contact is solved once; the scene's [ask] does not count.
///
/// Where p has a closed form every value is proved: it is the one number that all of an enclosure
/// rounds to. Elsewhere it is that of BatchPressure at 25 digits, whose error is an estimate. Where
/// such an error leaves open which of two numbers is the nearest, run_scene decides, in balls as
/// far as the scene has them.
class Binary64Pressures {
public:
    /// Throws InputError (with the line of the load) where no contact carries the load.
    explicit Binary64Pressures(const Scene& scene);
    ~Binary64Pressures();
    Binary64Pressures(Binary64Pressures&&) noexcept;
    Binary64Pressures& operator=(Binary64Pressures&&) noexcept;

    /// p at the distance u (exactly that binary64) inwards from an edge, in units of the contact
    /// modulus; 0 at the edges and outside the contact, infinite on a corner of the profile (also
    /// where 4096 bits do not tell the place from an edge or a corner that is no known number).
    /// Throws DomainError for NaN, BudgetError where no budget decides the last bit. One object
    /// belongs to one thread at a time.
    [[nodiscard]] double operator()(contact::Edge edge, double u) const;

    /// The same of many, in their order; `u` and `p` of one size. Throws Interrupted as well.
    void operator()(contact::Edge edge, std::span<const double> u, std::span<double> p) const;

    /// Whether all values are proved.
    [[nodiscard]] bool proved() const noexcept;

private:
    struct Contact;
    std::unique_ptr<Contact> contact_;
};

} // namespace edgeproof::scene
