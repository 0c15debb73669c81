// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/scene/input/quantity.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace edgeproof::scene {

/// A quantity at places that are binary64 numbers.
struct Binary64Question {
    Quantity quantity = Quantity::p; ///< p, q, local (n terms of p) or rel
    std::size_t n = 0;               ///< number of terms of local and rel
    bool from_origin = false;        ///< the places are coordinates x, else distances from an edge
};

/// Many values of a quantity of one scene as binary64: each is the nearest to the exact value (ties
/// to even) at exactly that place, in units of the contact modulus (rel: a number). The contact is
/// solved once; the scene's [ask] is ignored.
///
/// The values are proved. Double words decide most pressures of contacts with a formula in double
/// words (about 0.1 us a value); balls decide the others and the other quantities. For curved
/// slopes each value is an integral (about 1 ms).
class Binary64Values {
public:
    /// Throws InputError for a load that no contact carries, and if the scene or the question lacks
    /// the data for the quantity.
    explicit Binary64Values(const Scene& scene, const Binary64Question& question = {});
    ~Binary64Values();
    Binary64Values(Binary64Values&&) noexcept;
    Binary64Values& operator=(Binary64Values&&) noexcept;

    /// Returns the value at a place. p and q are 0 outside the contact. p is infinite on a corner
    /// of the profile (also where no number of bits tried separates the place from a corner).
    /// Throws InputError for places outside the contact (local, rel), at an edge (q under full
    /// stick, local, rel) and at a corner (q); DomainError for NaN; BudgetError if no budget
    /// decides the last bit. One object belongs to one thread at a time.
    /// @param edge the edge of local and rel, and from which a distance is measured
    /// @param place the coordinate x, or the distance inwards from the edge (length)
    [[nodiscard]] double operator()(Edge edge, double place) const;

    /// Computes the values at many places, in their order; `places` and `values` have the same
    /// size. Also throws Interrupted.
    void operator()(Edge edge, std::span<const double> places, std::span<double> values) const;

private:
    class Contact;
    std::unique_ptr<Contact> contact_;
};

/// The stresses that are computed as arrays.
inline constexpr std::array binary64_stresses{Quantity::sxx, Quantity::szz, Quantity::sxz,
                                              Quantity::tau_max, Quantity::mises};

/// The stresses at many points of a body, in units of the contact modulus. All arrays have the same
/// size; that of mises is empty if the scene has no Poisson's ratio.
struct Binary64Stresses {
    std::array<std::span<double>, binary64_stresses.size()> of;
    std::span<double> bound; ///< of the error of each value at the point
};

/// Computes the stresses at the places x and the depths z, which are exactly these binary64. The
/// bounds are proved and at most 1e-12 of the mean pressure, or 2^-52 of the value itself where it
/// is large: binary64 with bounds decide most points of piecewise linear slopes, run_scene computes
/// the others. The scene's [ask] is ignored.
///
/// Throws InputError for z < 0, for points at which a stress is infinite, and if the stresses of
/// the scene are not computed; DomainError for numbers that are not finite; Interrupted.
/// @param scene the contact
/// @param body the body in which the points are
/// @param x places (length)
/// @param z depths (length), as many
/// @param stresses receives the values
/// @param threads 0: the processors available
void compute_binary64(const Scene& scene, Body body, std::span<const double> x,
                      std::span<const double> z, const Binary64Stresses& stresses,
                      unsigned threads = 0);

/// A stress at many points of a body, for a picture.
struct PictureStresses {
    std::vector<double> values; ///< in units of the contact modulus
    bool estimates = false;     ///< else within the bounds of compute_binary64()
};

/// Computes sxx, szz, sxz, tau_max or mises at the places x and the depths z > 0. Plane piecewise
/// linear slopes are computed by compute_binary64(). Otherwise the values are estimates
/// (docs/stress.md, "Pictures"): straight lines replace g', or the rate h' of a body of revolution.
/// The greatest value, and values at other places, are compared with proved ones; where one differs
/// by more than 2e-4 of the greatest, compute_binary64() computes all. Throws as that does.
[[nodiscard]] PictureStresses picture_stresses(const Scene& scene, Quantity quantity, Body body,
                                               std::span<const double> x,
                                               std::span<const double> z);

} // namespace edgeproof::scene
