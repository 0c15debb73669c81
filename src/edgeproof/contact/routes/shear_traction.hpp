// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/shear.hpp"
#include "edgeproof/contact/routes/normal_contact.hpp"

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace edgeproof::contact {

/// How the shear comes to the contact.
enum class LoadingPath {
    normal_first, ///< P is held, then Q and sigma_0 are applied (shear.hpp)
    together      ///< P and Q grow in proportion, without bulk tension: q = (Q/P) p
};

/// The shear of a contact, exactly as given; signs as in shear.hpp.
struct ShearSpec {
    formula::Exact Q;            ///< force per unit length
    formula::Exact bulk_tension; ///< sigma_0
    LoadingPath path = LoadingPath::normal_first;
    /// The coefficient of friction; none: nothing slips.
    std::optional<formula::Exact> friction = {};
};

/// A value with its absolute error as estimated from the digits that cancelled; no proved bound.
struct EstimatedTraction {
    Real value;
    Real error;
    unsigned working_digits = 0;
};

/// q of a contact under full stick, to the digits of the contact: where Q and sigma_0 cancel, more
/// are worked with, up to 400. A value that they do not tell from zero is 0, with the error that
/// they leave.
///
/// `together`: while the contact grows by da, without slip, dQ adds dq = dQ/(pi sqrt((a-x)(x+b)))
/// (eqn:Shear_Adhered with sigma_0 = 0, whatever is locked in beneath), as dP adds dp = dP/(pi
/// sqrt((a-x)(x+b))) (the flat punch of eqn:ContactPressure_NonSym). With dQ = (Q/P) dP both sums
/// run alike, so q = (Q/P) p, on either side of any contact (moore-hills.tex, line 413, which
/// cites Hills2011 for it).
class ShearTraction {
public:
    /// Keeps references to `contact` and `work` (where what is done is counted). Throws InputError
    /// for a bulk tension on the path `together`: the similarity holds without one only.
    ShearTraction(const NormalContact& contact, ShearSpec spec, Work* work = nullptr);

    [[nodiscard]] const ShearSpec& spec() const noexcept { return spec_; }
    /// Throws DomainError for u outside (0, a + b), as NormalContact::pressure does.
    [[nodiscard]] EstimatedTraction traction(Edge edge, const formula::Exact& u) const;
    [[nodiscard]] EstimatedTraction traction(Edge edge, const Real& u) const;
    /// The coefficients of u^(k-1/2) (normal_first) or u^(k+1/2) (together), k < terms.
    [[nodiscard]] std::vector<EstimatedTraction> expansion(Edge edge, std::size_t terms) const;
    /// On the path `together`, from a pressure or coefficients of p that are known already.
    [[nodiscard]] EstimatedTraction similar_to(const Estimated& pressure) const;
    [[nodiscard]] std::vector<EstimatedTraction> similar_to(const std::vector<Real>& c) const;
    /// Twice the power of u that the expansion starts with: -1 or 1.
    [[nodiscard]] int leading_half_powers() const noexcept {
        return spec_.path == LoadingPath::together ? 1 : -1;
    }

private:
    [[nodiscard]] const Real& force() const;
    /// The contact with so many digits more.
    [[nodiscard]] const NormalContact& finer(unsigned extra) const;
    template <class At> [[nodiscard]] EstimatedTraction escalated(const At& at) const;

    const NormalContact& contact_;
    ShearSpec spec_;
    Work* work_;
    mutable std::optional<Real> force_;
    mutable std::map<unsigned, std::unique_ptr<NormalContact>> finer_;
};

} // namespace edgeproof::contact
