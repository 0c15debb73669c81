// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rational.hpp"

#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace edgeproof::certificate {

/// Thrown for a formula that this program cannot state in Coq. The message names the part.
class NotStated : public Error {
public:
    using Error::Error;
};

/// The names in a formula, and the Coq terms for them (atoms, or terms in parentheses).
using CoqNames = std::map<std::string, std::string, std::less<>>;

/// Returns the Coq term for a call or an integral that is not an elementary function; throws
/// NotStated.
using CoqCall = std::function<std::string(const formula::Expr&)>;

/// Returns a formula as a term of Coq's real numbers (R_scope), operation by operation. Powers are
/// x ^ n for whole n and Rpower, which needs a positive base, for other exponents. The gamma
/// function has the name that `names` give it. Throws NotStated for a name that is not in `names`,
/// for a function that Coq's library of real numbers does not have, and for integrals that `call`
/// does not translate.
[[nodiscard]] std::string coq_text(const formula::Expr& e, const CoqNames& names,
                                   const CoqCall& call = {});
/// Returns "3", "(1 / 2)" or "(- (1 / 2))".
[[nodiscard]] std::string coq_number(const Rational& q);

} // namespace edgeproof::certificate
