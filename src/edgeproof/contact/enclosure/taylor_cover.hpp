// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/precision/ball/complex_box.hpp"
#include "edgeproof/precision/ball/magnitude.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace edgeproof::contact {

/// A bound of |f(centre + z)| for |z| <= rho, by boxes that cover half of the disk: f is real on
/// the real axis. Not finite where f may not be holomorphic.
[[nodiscard]] Ball greatest_on_disk(const std::function<Box(const Box& z)>& f, const Ball& centre,
                                    const Ball& rho);

/// The Taylor series of a function about places of the real axis, each computed when it is first
/// needed: for a function whose single values are expensive (docs/axisymmetric.md, "Curved
/// slopes").
class TaylorCover {
public:
    /// f encloses the values over a box; it is real on the real axis, and not finite where it may
    /// not be holomorphic. All calls have the same f.
    using Function = std::function<Box(const Box& z)>;

    explicit TaylorCover(long bits) : bits_(bits) {}
    /// Returns f(z + t) in powers of t, `order` coefficients, for every z of a box; empty if no
    /// series serves it. `widest`: a radius that no disk needs to exceed.
    [[nodiscard]] std::vector<Box> at(const Function& f, const Box& z, std::size_t order,
                                      const Ball& widest);

private:
    struct Disk {
        Ball centre;
        Ball radius; ///< 0: no disk was found
        Magnitude bound;
        std::vector<Box> coefficients;
        [[nodiscard]] bool holds(const Box& z) const;
    };
    [[nodiscard]] Disk disk_about(const Function& f, const Ball& centre, const Ball& widest,
                                  std::size_t terms) const;

    long bits_;
    std::vector<Disk> disks_;
};

} // namespace edgeproof::contact
