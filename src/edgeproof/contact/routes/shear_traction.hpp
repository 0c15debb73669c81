// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/shear.hpp"
#include "edgeproof/contact/routes/normal_contact.hpp"

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace edgeproof::contact {

/// The order in which the normal load and the shear load are applied.
enum class LoadingPath {
    normal_first, ///< P is held, then Q and sigma_0 are applied (shear.hpp)
    together      ///< P and Q grow in proportion, without bulk tension: q = (Q/P) p
};

/// The shear load of a contact as exact numbers; signs as in shear.hpp.
struct ShearSpec {
    Exact Q;            ///< force per unit length
    Exact bulk_tension; ///< sigma_0, a stress
    LoadingPath path = LoadingPath::normal_first;
    /// The coefficient of friction; without one nothing slips.
    std::optional<Exact> friction = {};
    /// The bulk stress of body A; that of body B is bulk_A + bulk_tension. Only stresses depend on
    /// it.
    Exact bulk_A = {};
};

/// A value with its absolute error, estimated from the digits that cancelled; not a proved bound.
struct EstimatedTraction {
    Real value;
    Real error;
    unsigned working_digits = 0;
};

/// q of a contact under full stick, to the digits of the contact. Where Q and sigma_0 cancel, up to
/// 400 more digits are used. A value that they do not distinguish from zero is 0, with the
/// remaining error.
///
/// `together`: q = (Q/P) p on either side of any contact (docs/shear.md, "P and Q in proportion";
/// moore-hills S54). While the contact grows by da without slip, dQ adds dQ/(pi sqrt((a-x)(x+b)))
/// to q (moore-hills EQ34 with sigma_0 = 0), and dP adds dP/(pi sqrt((a-x)(x+b))) to p (the flat
/// punch of moore-hills EQ21).
class ShearTraction {
public:
    /// Keeps references to `contact` and `work` (the counts of work done). Throws InputError for a
    /// bulk tension on the path `together`, where q = (Q/P) p holds only without one.
    ShearTraction(const NormalContact& contact, ShearSpec spec, Work* work = nullptr);

    /// q (a stress) at the distance u from an edge. Throws DomainError for u outside (0, a + b), as
    /// NormalContact::pressure does.
    [[nodiscard]] EstimatedTraction traction(Edge edge, const Exact& u) const;
    [[nodiscard]] EstimatedTraction traction(Edge edge, const Real& u) const;
    /// The coefficients of u^(k-1/2) (normal_first) or u^(k+1/2) (together), k < terms, in
    /// stress/length^(k-1/2) or stress/length^(k+1/2).
    [[nodiscard]] std::vector<EstimatedTraction> expansion(Edge edge, std::size_t terms) const;
    /// The same on the path `together`, from a known pressure or known coefficients of p.
    [[nodiscard]] EstimatedTraction similar_to(const Estimated& pressure) const;
    [[nodiscard]] std::vector<EstimatedTraction> similar_to(const std::vector<Real>& c) const;

private:
    [[nodiscard]] const Real& force() const;
    /// The contact with `extra` more digits.
    [[nodiscard]] const NormalContact& finer(unsigned extra) const;
    template <class At> [[nodiscard]] EstimatedTraction escalated(const At& at) const;

    const NormalContact& contact_;
    ShearSpec spec_;
    Work* work_;
    mutable std::optional<Real> force_;
    mutable std::map<unsigned, std::unique_ptr<NormalContact>> finer_;
};

} // namespace edgeproof::contact
