// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <memory>
#include <span>

namespace edgeproof::scene {

/// Many pressures of one scene as binary64: each is the binary64 nearest to the exact p (ties to
/// even). The contact is solved once; the scene's [ask] is ignored.
///
/// Where p has a closed form, every value is proved: the whole enclosure of p rounds to it.
/// Elsewhere BatchPressure computes p at 25 digits with an estimated error. Where that error leaves
/// two candidates, run_scene decides, in balls as far as the scene allows.
class Binary64Pressures {
public:
    /// Throws InputError (with the line of the load) if no contact carries the load.
    explicit Binary64Pressures(const Scene& scene);
    ~Binary64Pressures();
    Binary64Pressures(Binary64Pressures&&) noexcept;
    Binary64Pressures& operator=(Binary64Pressures&&) noexcept;

    /// Returns p at the distance u (exactly that binary64) inwards from an edge, in units of the
    /// contact modulus; 0 at the edges and outside the contact; infinity on a corner of the profile
    /// (also where 4096 bits do not separate the place from an edge or from a corner that is not a
    /// known number). Throws DomainError for NaN, BudgetError if no budget decides the last bit.
    /// One object belongs to one thread at a time.
    [[nodiscard]] double operator()(contact::Edge edge, double u) const;

    /// Computes p for many distances, in their order; `u` and `p` have the same size. Also throws
    /// Interrupted.
    void operator()(contact::Edge edge, std::span<const double> u, std::span<double> p) const;

    [[nodiscard]] bool proved() const noexcept;

private:
    struct Contact;
    std::unique_ptr<Contact> contact_;
};

} // namespace edgeproof::scene
