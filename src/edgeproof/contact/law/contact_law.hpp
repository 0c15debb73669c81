// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/kernels.hpp"
#include "edgeproof/contact/law/measure.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/precision/arithmetic.hpp"

#include <cstddef>
#include <exception>
#include <functional>
#include <memory>
#include <optional>

namespace edgeproof::contact {

/// The searches within a bracket serve contacts where Newton's method from binary64 fails.

/// The imbalance at a trial edge (positive if the edge must lie further out) and Newton's step
/// (length).
template <class T> struct EdgeStep {
    T value;
    T step;
};

/// The edge (its distance from the origin, a length) at which `imbalance` is zero. `imbalance` is
/// positive at places nearer to the origin, and so is the value that `newton` returns. The search
/// begins at `start` > 0. Throws DomainError if no edge is in balance. A DomainError or BudgetError
/// of the two functions means that the trial edge is too far out.
template <Arithmetic T>
[[nodiscard]] T search_edge(const T& start, const std::function<T(const T&)>& imbalance,
                            const std::function<EdgeStep<T>(const T&)>& newton);

/// P of a contact (force per unit length), and dP/da.
template <class T> struct ForceAt {
    T force;
    T rate;
};
/// Returns nothing if no contact ends at a: its other edge may need the slope beyond the place
/// where the slope ends. The reason is then stored in `failure`.
template <class T>
using ForceOf = std::function<std::optional<ForceAt<T>>(const T& a, std::exception_ptr& failure)>;

/// The right edge (length) of the contact under the normal force P per unit length, at `least` or
/// beyond. If `least` is 0, the search begins at `first`. Throws BudgetError if the search does not
/// end, and the stored reason if no contact carries this force.
template <Arithmetic T>
[[nodiscard]] T search_right_edge(const T& P, const T& least, const T& first,
                                  const ForceOf<T>& force_at);

/// P'(a + z) and b(a + z) as truncated series in z, the input of an edge expansion. Units of the
/// coefficients of z^k: force per unit length over length^(k+1), and length^(1-k).
template <class T> struct LawSeries {
    series::Series<T> force_rate; ///< dP/da, the total derivative along the family of contacts
    series::Series<T> b;          ///< b(a + z); a + z itself for a symmetric contact
};

/// The load and the other edge as functions of one edge: moore-hills EQ20 and EQ22 (EQ02 for
/// b = a), in the form of docs/mechanics.md, "One measure, six kernels".
/// Units: lengths in one unit, forces per unit length in the unit of contact_modulus times length.
/// Values have the working precision of the thread that constructed the object, less a few digits
/// of roundoff; they are not proved bounds.
template <Arithmetic T> class ContactLaw {
public:
    /// `contact_modulus` is E* of both bodies, 1/E* = (1-nu_1^2)/E_1 + (1-nu_2^2)/E_2, a stress.
    /// `target_digits`: the digits to which quadratures over pieces of g' that are not linear are
    /// computed (0: to roundoff).
    ContactLaw(const Profile& profile, T contact_modulus, unsigned target_digits = 0);

    [[nodiscard]] const SlopeIn<T>& slope() const noexcept { return slope_; }
    [[nodiscard]] const T& contact_modulus() const noexcept { return modulus_; }
    [[nodiscard]] bool symmetric() const noexcept { return symmetric_; }
    /// The closed form, if g' is a power law that is not linear. For m near 0 a quadrature of g''
    /// would not converge in practice.
    [[nodiscard]] const std::optional<PowerLaw<T>>& power_law() const noexcept { return power_; }

    /// b(a) by the consistency condition; a itself for a symmetric profile, without solving.
    /// Throws DomainError for a <= 0, or if no b is in balance with a.
    [[nodiscard]] T left_edge(const T& a) const;
    /// a(b), the inverse of left_edge.
    [[nodiscard]] T right_edge(const T& b) const;
    /// The right edge a for the normal force P > 0 per unit length.
    [[nodiscard]] T right_edge_for_force(const T& P) const;

    [[nodiscard]] Extent<T> extent(const T& a) const { return {a, left_edge(a)}; }
    /// The normal force P per unit length.
    [[nodiscard]] T force(const Extent<T>& e) const;
    /// The moment of p about the origin (a force), positive when it presses the right side down.
    [[nodiscard]] T moment(const Extent<T>& e) const;
    /// dP/da along the family of contacts (a stress).
    [[nodiscard]] T force_rate(const Extent<T>& e) const;
    /// dP/db along the family of contacts (a stress).
    [[nodiscard]] T left_force_rate(const Extent<T>& e) const;
    /// The residual of the consistency condition (moore-hills EQ20), scaled to be dimensionless.
    [[nodiscard]] T imbalance(const Extent<T>& e) const;

    /// The series of the law about e, `order` terms. If an edge lies on a knot, the derivatives are
    /// those from inside the contact; right_edge_on_knot() and left_edge_on_knot() report this
    /// case.
    [[nodiscard]] LawSeries<T> series(const Extent<T>& e, std::size_t order) const;
    [[nodiscard]] bool right_edge_on_knot(const Extent<T>& e) const;
    [[nodiscard]] bool left_edge_on_knot(const Extent<T>& e) const;

    /// The number of evaluations of integrands so far (only pieces of g' that are not linear need
    /// any).
    [[nodiscard]] std::size_t evaluations() const noexcept { return evaluations_; }

private:
    template <class Kernel, class U>
    [[nodiscard]] U over_measure(Marks<T, U>& marks, Part part = Part::all) const {
        return integrate_measure<T, U>(measure_kernel<T, U, Kernel>(), slope_, marks, part,
                                       symmetric_, target_digits_, &evaluations_);
    }
    template <class Kernel, class U> [[nodiscard]] U over_measure(const Extent<U>& e) const {
        Marks<T, U> marks(e, slope_.knots());
        return over_measure<Kernel>(marks);
    }
    [[nodiscard]] EdgeStep<T> edge_step(const T& known, const T& unknown, bool solve_left) const;
    [[nodiscard]] std::optional<ForceAt<T>> force_at(const T& a, std::exception_ptr& failure) const;
    [[nodiscard]] std::optional<T> refined_from_guess(const T& P) const;
    [[nodiscard]] T solve_edge(const T& known, bool solve_left) const;
    /// The start of Newton's iteration; nullopt if neither binary64 nor fewer digits give one.
    [[nodiscard]] std::optional<T> guessed_edge(const T& known, bool solve_left) const;
    [[nodiscard]] T search_edge(const T& known, const T& start, bool solve_left) const;
    [[nodiscard]] Extent<T> extent_with(const T& known, const T& unknown, bool solve_left) const;

    SlopeIn<T> slope_;
    T modulus_;
    bool symmetric_;
    unsigned target_digits_;
    std::optional<PowerLaw<T>> power_;
    std::shared_ptr<const ContactLaw<double>> guess_; ///< only starts Newton's iteration
    /// The same law with fewer digits, which gives a closer start; null where guess_ is enough.
    std::shared_ptr<const ContactLaw> coarser_;
    unsigned coarser_digits_ = 0;
    mutable std::size_t evaluations_ = 0;
};

#define EDGEPROOF_CONTACT_LAW(T) extern template class ContactLaw<T>;
EDGEPROOF_FOR_EACH_ARITHMETIC(EDGEPROOF_CONTACT_LAW)
#undef EDGEPROOF_CONTACT_LAW

} // namespace edgeproof::contact
