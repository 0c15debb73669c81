// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"

#include <mutex>
#include <string_view>
#include <vector>

namespace GiNaC {
class ex;
} // namespace GiNaC

/// Between our expressions and GiNaC's. GiNaC is not thread-safe, so whoever calls these holds
/// `hold()`; its own order of terms changes from run to run, so what comes back is put in an order
/// of ours.
namespace edgeproof::audit::ginac {

[[nodiscard]] std::unique_lock<std::recursive_mutex> hold();

/// A symbol by its name, always the same. All are real; lengths, moduli and the like positive.
[[nodiscard]] GiNaC::ex symbol(std::string_view name);
/// Functions that GiNaC does not have, and integrals, become symbols that know what they stand for.
[[nodiscard]] GiNaC::ex from_expr(const formula::Expr& e);
/// Whether a name stands inside of what becomes a symbol there: no derivative by it is then right.
[[nodiscard]] bool hides(const formula::Expr& e, std::string_view name);
[[nodiscard]] formula::Expr to_expr(const GiNaC::ex& e);

/// True if e vanishes identically, half-integer powers and powers to symbols taken into account
/// (bases positive). False means only that this was not shown.
[[nodiscard]] bool is_zero(const GiNaC::ex& e);
/// q_0, q_1, ... with e = (q_0 + q_1 s + ...)/sqrt(hi - s). Throws DomainError if e is not so.
[[nodiscard]] std::vector<GiNaC::ex> polynomial_over_root(const GiNaC::ex& e, const GiNaC::ex& s,
                                                          const GiNaC::ex& hi);
/// One fraction, its factors apart, sums collected by derivatives of P.
[[nodiscard]] formula::Expr tidy(const GiNaC::ex& e);

} // namespace edgeproof::audit::ginac
