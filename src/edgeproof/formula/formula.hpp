// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
/// Exact expressions, as users and ledgers write them; they are rounded only when digits are
/// requested.
///   builtin.hpp                 the functions that every formula may use
///   expr.hpp                    Expr: the tree; text and TeX of it; substitution; edits by path
///   parse.hpp                   text -> Expr, with a strict table of names; FormulaError
///   exact/exact.hpp             Exact: a constant such as "pi/16", and its value at any precision
///   evaluation/evaluate.hpp     the value of an Expr in any number type
///   evaluation/program.hpp      Program: an Expr compiled for integrals
#include "edgeproof/formula/builtin.hpp"
#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/formula/evaluation/program.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/formula/parse.hpp"
