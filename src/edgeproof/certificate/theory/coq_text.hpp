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

/// What a formula says cannot be said in Coq by this program; the message says what of it.
class NotStated : public Error {
public:
    using Error::Error;
};

/// Names of a formula, and the Coq terms (atoms, or in parentheses) that stand for them.
using CoqNames = std::map<std::string, std::string, std::less<>>;

/// Says the Coq term for a call or an integral that is no elementary function; throws NotStated.
using CoqCall = std::function<std::string(const formula::Expr&)>;

/// A formula as a term of Coq's real numbers (R_scope), operation by operation as it is written.
/// Powers: x ^ n for whole n, Rpower for other rational exponents, whose base is then positive.
/// Throws NotStated for a name that is not in `names`, for a function that Coq's library of real
/// numbers does not have, and for integrals unless `call` says them.
[[nodiscard]] std::string coq_text(const formula::Expr& e, const CoqNames& names,
                                   const CoqCall& call = {});
/// "3", "(1 / 2)", "(- (1 / 2))".
[[nodiscard]] std::string coq_number(const Rational& q);

} // namespace edgeproof::certificate
