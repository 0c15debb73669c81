// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/arithmetic.hpp"

#include <exception>
#include <functional>
#include <optional>

/// Searches for edges within a bracket, for contacts where Newton's method from binary64 fails.
namespace edgeproof::contact {

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

} // namespace edgeproof::contact
