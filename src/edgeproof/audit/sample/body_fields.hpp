// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/family.hpp"
#include "edgeproof/contact/curved/proved_slip.hpp"

#include <memory>
#include <optional>
#include <string_view>

namespace edgeproof::audit {

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
