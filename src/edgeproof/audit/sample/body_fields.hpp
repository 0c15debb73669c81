// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/family.hpp"
#include "edgeproof/contact/axisymmetric/axisymmetric_contact.hpp"
#include "edgeproof/contact/curved/proved_slip.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/contact/stress/surface_gap.hpp"
#include "edgeproof/precision/error.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace edgeproof::audit {

/// Returns k of a name such as P2 or right_c1: one digit after the stem.
[[nodiscard]] inline std::optional<std::size_t> order_behind(std::string_view name,
                                                             std::string_view stem) {
    if (!name.starts_with(stem) || name.size() != stem.size() + 1 || name.back() < '0' ||
        name.back() > '9') {
        return std::nullopt;
    }
    return static_cast<std::size_t>(name.back() - '0');
}

/// Returns c_0 sqrt(u) + ... + c_{n-1} u^(n-1/2) by Horner's rule.
[[nodiscard]] inline Ball sum_of_terms(std::span<const Ball> c, const Ball& u) {
    Ball sum(0, u.bits());
    for (std::size_t k = c.size(); k-- > 0;) {
        sum = sum * u + c[k];
    }
    return sum * sqrt(u);
}

/// Returns the gap (length) at the place x (length) outside the contact.
[[nodiscard]] inline Ball gap_at(const contact::BallContact& contact, bool axisymmetric,
                                 const Ball& x) {
    const Ball beyond = x - contact.a();
    if (!certainly_positive(beyond) && (axisymmetric || !certainly_positive(-x - contact.b()))) {
        throw DomainError("the gap at a place that may be inside the contact");
    }
    return axisymmetric ? axisymmetric_gap(contact, beyond) : contact::gap_at(contact, x);
}

/// The partial slip of a scene, the stresses in body A, on which Q acts and which has no bulk
/// stress, and the slip, in balls of one precision (docs/stress.md).
class BodyFields {
public:
    /// Throws BudgetError or DomainError where the bits do not isolate the zones.
    /// @param scene a plane scene
    /// @param load Q and sig0, if the scene has them
    /// @param friction its coefficient of friction, if it has one
    /// @param bits working precision
    BodyFields(const SceneSpec& scene, const std::optional<contact::ShearLoad<Ball>>& load,
               const std::optional<Ball>& friction, long bits);

    /// For a scene with friction. Throws Error if the slip is proved not to be partial.
    [[nodiscard]] const contact::ProvedSlip& partial_slip() const;
    /// Returns sxx, szz or sxz (stress), tension positive, at the place x and the depth z >= 0
    /// (length). Throws DomainError if z may be negative.
    [[nodiscard]] Ball stress(std::string_view name, const Ball& x, const Ball& z) const;
    /// Returns u_A - u_B (length) at the place x in the contact of a scene with friction. Throws
    /// DomainError outside, and Error for slopes without closed forms.
    [[nodiscard]] Ball slip(const Ball& x) const;
    [[nodiscard]] const contact::ProvedContact& contact() const {
        return slip_ ? slip_->contact() : *contact_;
    }

private:
    std::optional<contact::ShearLoad<Ball>> load_;
    std::unique_ptr<contact::ProvedContact> contact_; ///< of scenes without friction
    std::unique_ptr<contact::ProvedSlip> slip_;
    std::optional<contact::TractionParts> parts_;
};

} // namespace edgeproof::audit
