// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/routes/normal_contact.hpp"
#include "edgeproof/contact/routes/power_law_closed_form.hpp"

#include <memory>
#include <optional>

namespace edgeproof::contact {

inline constexpr unsigned guard_digits = 20;
/// A point given exactly is separated from a knot down to this many decades below roundoff.
inline constexpr unsigned knot_decades = 400;

/// The contact solved at one working precision. The mirrored law serves points left of the origin.
struct NormalContact::Solved {
    Solved(const Profile& profile, const formula::Exact& modulus, const Load& load, unsigned target)
        : target_digits(target), roundoff(pow(Real(10), -static_cast<int>(target))),
          law(profile, modulus.to<Real>(), target), extent{} {
        const Real value = load.value.to<Real>();
        extent = law.extent(load.kind == Load::Kind::right_edge ? value
                                                                : law.right_edge_for_force(value));
    }
    /// The marks of the knots (kernels.hpp), computed at the first use.
    Marks<Real, Real>& marks() {
        if (!known_marks) {
            known_marks.emplace(extent, law.slope().knots());
        }
        return *known_marks;
    }
    PowerLawPressure& power_law(const formula::Exact& m) {
        if (!known_power_law) {
            known_power_law.emplace(m, law, extent, target_digits);
        }
        return *known_power_law;
    }
    const ContactLaw<Real>& mirrored(const Profile& profile, const formula::Exact& modulus) {
        if (!mirror) {
            mirror = std::make_unique<ContactLaw<Real>>(profile.reflected(), modulus.to<Real>(),
                                                        target_digits);
        }
        return *mirror;
    }
    /// The smallest positive distance of an edge from a knot, which determines the cancellation in
    /// a - knot and b + knot.
    [[nodiscard]] Real smallest_gap() const {
        Real gap = extent.length();
        for (const Real& knot : law.slope().knots()) {
            for (const Real& d : {Real(abs(extent.a - knot)), Real(abs(extent.b + knot))}) {
                if (d > 0 && d < gap) {
                    gap = d;
                }
            }
        }
        return gap;
    }

    unsigned target_digits;
    Real roundoff; ///< the relative roundoff of all values computed with it
    ContactLaw<Real> law;
    Extent<Real> extent;
    std::unique_ptr<ContactLaw<Real>> mirror;
    std::optional<Marks<Real, Real>> known_marks;
    std::optional<PowerLawPressure> known_power_law;
};

} // namespace edgeproof::contact
