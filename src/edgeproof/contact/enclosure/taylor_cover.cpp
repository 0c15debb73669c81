// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/enclosure/taylor_cover.hpp"

#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/rigorous_integral.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace edgeproof::contact {
namespace {

constexpr int most_radii = 60; ///< tried, each two thirds of the one before
constexpr std::size_t most_disks = 1000;
constexpr long steepest = 16; ///< a smaller disk is taken if the bound falls by more
constexpr long bits_of_ranges = 64;
constexpr std::size_t terms_a_step = 16; ///< so that few orders share a disk
constexpr long bits_below_width = 16;

} // namespace

Ball greatest_on_disk(const std::function<Box(const Box& z)>& f, const Ball& centre,
                      const Ball& rho) {
    constexpr long across = 6; // boxes from -rho to rho
    const Ball half = rho / across;
    Ball most(0, centre.bits());
    for (long i = 0; i < across; ++i) {
        for (long j = 0; 2 * j < across; ++j) {
            const Ball here = abs(f(Box(centre + half * (2 * i + 1 - across) + up_to(half),
                                        half * (2 * j + 1) + up_to(half))));
            if (!here.is_finite()) {
                return unknown_ball(centre.bits());
            }
            most = max(most, upper_end(here));
        }
    }
    return most;
}

bool TaylorCover::Disk::holds(const Box& z) const {
    return certainly_positive(radius) && certainly_less(abs(z - centre) * 2, radius);
}

TaylorCover::Disk TaylorCover::disk_about(const Function& f, const Ball& centre, const Ball& widest,
                                          std::size_t terms) const {
    Ball radius = lower_end(widest.with_bits(32));
    Ball most = unknown_ball(bits_);
    for (int k = 0; k < most_radii; ++k) {
        const Ball smaller = lower_end(Ball(radius * 2 / 3).with_bits(32));
        const Ball next = greatest_on_disk(f, centre, smaller);
        if (most.is_finite() && !certainly_less(next * steepest, most)) {
            break;
        }
        radius = smaller;
        most = next;
    }
    if (!most.is_finite()) {
        return {centre, Ball(0, bits_), {}, {}};
    }
    const long bits = std::min(bits_, static_cast<long>(terms));
    Disk disk{centre, radius, Magnitude(most), {}};
    for (const Ball& c :
         taylor_on_circle([&](const Box& z) { return f(z + centre); }, upper_end(most),
                          radius.with_bits(bits), Rational(1, 2), terms)) {
        disk.coefficients.emplace_back(c);
    }
    return disk;
}

std::vector<Box> TaylorCover::at(const Function& f, const Box& z, std::size_t order,
                                 const Ball& widest) {
    // A series that serves ranges only needs few terms.
    const auto terms = static_cast<std::size_t>(is_narrow(z) ? bits_ : bits_of_ranges) +
                       terms_a_step * ((order - 1) / terms_a_step + 1);
    auto found = std::ranges::find_if(disks_, [&](const Disk& disk) {
        return disk.holds(z) && disk.coefficients.size() >= terms;
    });
    if (found == disks_.end()) {
        const Ball centre = middle(z.real());
        // A disk about a place that is well within another one would be about as small.
        const bool tried = std::ranges::any_of(disks_, [&](const Disk& disk) {
            return !certainly_less(disk.radius, abs(disk.centre - centre) * 4) &&
                   (disk.coefficients.empty() || disk.coefficients.size() >= terms);
        });
        const Ball breadth = abs(z - centre) * 2;
        if (tried || disks_.size() >= most_disks || !certainly_less(breadth, widest)) {
            return {};
        }
        disks_.push_back(disk_about(f, centre, widest, terms));
        found = disks_.end() - 1;
        if (!found->holds(z)) {
            return {};
        }
    }
    // Terms below the width of z do not matter.
    const Box off = z - found->centre;
    const double fall = -std::log2(approximate(upper_end(abs(off) / found->radius)));
    const auto known = static_cast<double>(
        std::clamp<slong>(acb_rel_accuracy_bits(off.get()), 0, bits_) + bits_below_width);
    const std::size_t useful = order + static_cast<std::size_t>(std::max(4.0, known / fall));
    const std::vector<Box>& c = found->coefficients;
    return taylor_at(
        {c.begin(), c.begin() + static_cast<std::ptrdiff_t>(std::min(c.size(), useful))},
        found->radius, found->bound, off, order);
}

} // namespace edgeproof::contact
