// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
/// Truncated power series over any field; Edgeproof differentiates with them.
///   truncated.hpp   Series<T>: arithmetic, derivative, antiderivative
///   functions.hpp   sqrt, pow, exp, log, atan, asin, ... of a series
///   truncated.hpp   composition and the inverse function
///   polynomial.hpp  series in u with coefficients that are polynomials in sigma
///   divided_difference.hpp  (f(s) - f(x))/(s - x) without cancellation
#include "edgeproof/series/divided_difference.hpp"
#include "edgeproof/series/functions.hpp"
#include "edgeproof/series/polynomial.hpp"
#include "edgeproof/series/truncated.hpp"
