// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/arithmetic.hpp"

#include <exception>
#include <functional>
#include <optional>

/// Searches with a bracket, for what Newton's method from binary64 does not find.
namespace edgeproof::contact {

/// The imbalance at a trial edge, positive when the edge lies further out, and Newton's step.
template <class T> struct EdgeStep {
    T value;
    T step;
};

/// The edge at which `imbalance` is zero: it is positive at places nearer to the origin, as
/// `newton`'s value is. Begins at `start` > 0. Throws DomainError where no edge balances; what the
/// two functions throw counts as too far out.
template <Arithmetic T>
[[nodiscard]] T search_edge(const T& start, const std::function<T(const T&)>& imbalance,
                            const std::function<EdgeStep<T>(const T&)>& newton);

/// P of a contact, and dP/da.
template <class T> struct ForceAt {
    T force;
    T rate;
};
/// Nothing where no contact ends at a: its balance may ask for more of the slope on the other side
/// than there is; the reason is kept in `failure`.
template <class T>
using ForceOf = std::function<std::optional<ForceAt<T>>(const T& a, std::exception_ptr& failure)>;

/// The right edge of the contact that carries P, not nearer than `least`; `first` is tried first,
/// where `least` is 0. Throws BudgetError where the search does not end, and what was kept as the
/// reason where no contact carries so much.
template <Arithmetic T>
[[nodiscard]] T search_right_edge(const T& P, const T& least, const T& first,
                                  const ForceOf<T>& force_at);

} // namespace edgeproof::contact
