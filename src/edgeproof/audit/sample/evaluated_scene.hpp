// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/family.hpp"
#include "edgeproof/contact/routes/normal_contact.hpp"
#include "edgeproof/formula/expr.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace edgeproof::audit {

struct Relation;
struct EvaluatedSceneState;

/// A place in a contact: the distance u inwards from an edge, and x.
struct Place {
    Edge edge = Edge::right;
    Real u;
    Real x;
    std::string text; ///< "u = 1e-3 of the length, from the right edge"
};

/// Returns such a text for the fraction u of the length.
[[nodiscard]] std::string place_text(Edge edge, const Exact& fraction);

/// Values for names that a sample adds to its scene.
using Variables = std::map<std::string, Real, std::less<>>;

/// The value of a formula, and the error estimates of its quadratures.
struct FormulaValue {
    Real value;
    Real estimate;         ///< relative error of the worst integral in it; 0 without integrals
    bool converged = true; ///< true if every integral converged
    /// The digits that are right according to this estimate and the working precision.
    unsigned digits = 0;
};

/// Values of integrals that occur in many variants of one formula, at one place and for one set of
/// variables.
using IntegralCache = std::unordered_map<Expr, FormulaValue, formula::ExprHash>;

/// The effort for an integral: a screening, which distinguishes many wrong formulas from a right
/// one, stops early for integrals that do not converge.
enum class Effort { screening, full };

/// A scene in numbers, right to `digits` digits, in which the formulas of a ledger are evaluated.
///
/// Symbols: every parameter of the scene (m, C, t, R, phi, alpha, Es, ...), a, b, P, M, L = a + b,
/// P1, P2, ... (P'(a), P''(a), ...), b1, b2, ..., right_c0, ..., left_c0, ... (the coefficients of
/// the expansions: "right.c0" in a ledger), u and x of the place, `edge` (+1 right, -1 left).
/// Functions: p(x), g1(x) the slope, Pof(s), P1of(s), bof(s), binv(y) along the family of contacts,
/// right_local(n, x), left_local(n, x), the n-term approximations, and q(x), the shear traction
/// under full stick if the scene has Q and sig0; right_s0, left_s0, ... are its coefficients. With
/// `friction` as well, q(x) is that of partial slip, right_d and left_d are the sizes of the slip
/// zones, stick_a and stick_b the edges of the stick zone, and slip(x) is u_A - u_B. sxx(x, z),
/// szz(x, z), sxz(x, z) are the stresses in body A, without a bulk stress of A.
/// integral(f, s, lo, hi) and pv(f, s, lo, hi, x) are evaluated as printed, with a precision that
/// is sufficient at their end points. Not thread-safe: one thread may use an object at a time.
class EvaluatedScene {
public:
    explicit EvaluatedScene(SceneSpec spec, unsigned digits, Effort effort = Effort::full);
    ~EvaluatedScene();
    EvaluatedScene(EvaluatedScene&&) noexcept;

    [[nodiscard]] const SceneSpec& spec() const noexcept;
    [[nodiscard]] unsigned digits() const noexcept;
    /// The exact contact, which gives `p`, the coefficients and the derivatives.
    [[nodiscard]] const contact::NormalContact& contact() const;
    [[nodiscard]] Real a() const;
    [[nodiscard]] Real b() const;
    [[nodiscard]] Real length() const;
    /// Returns a parameter of the scene with the working precision of formulas.
    [[nodiscard]] Real parameter(std::string_view name) const;

    /// Returns the place at a fraction of the length a + b.
    [[nodiscard]] Place place(Edge edge, const Exact& fraction) const;
    [[nodiscard]] Place place_at_u(Edge edge, const Real& u) const;

    /// Returns the exact pressure at u from an edge, by any of its routes.
    [[nodiscard]] Real pressure(Edge edge, const Real& u,
                                contact::Route route = contact::Route::automatic) const;
    /// Returns c_0 ... c_{terms-1}; computed once, and extended if more terms are needed.
    [[nodiscard]] std::vector<Real> expansion(Edge edge, std::size_t terms) const;
    /// Returns the sum of the first n terms at u.
    [[nodiscard]] Real local(Edge edge, std::size_t n, const Real& u) const;

    /// Returns the value of a formula (definitions put in). Throws DomainError if it is undefined,
    /// and Error for a name that the scene does not have.
    [[nodiscard]] FormulaValue evaluate(const Expr& e, const Place* place = nullptr,
                                        const Variables& variables = {},
                                        IntegralCache* cache = nullptr) const;
    /// Returns exact values of variables with the working precision of formulas.
    [[nodiscard]] Variables
    values_of(const std::map<std::string, Exact, std::less<>>& variables) const;
    [[nodiscard]] bool holds(const std::vector<Relation>& condition, const Place* place = nullptr,
                             const Variables& variables = {}) const;

private:
    std::unique_ptr<EvaluatedSceneState> state_;
};

} // namespace edgeproof::audit
