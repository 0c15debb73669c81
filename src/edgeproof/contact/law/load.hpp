// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/rational.hpp"

#include <utility>

namespace edgeproof::contact {

/// The load: the right edge a (length), or the normal force P per unit length; for an axisymmetric
/// contact the radius a, the total force P, or the approach delta (length).
struct Load {
    enum class Kind { right_edge, force, approach };
    Kind kind = Kind::right_edge;
    formula::Exact value;
    [[nodiscard]] static Load right_edge(formula::Exact a) {
        return {Kind::right_edge, std::move(a)};
    }
    [[nodiscard]] static Load force(formula::Exact P) { return {Kind::force, std::move(P)}; }
    [[nodiscard]] static Load approach(formula::Exact delta) {
        return {Kind::approach, std::move(delta)};
    }
};

/// The part of the contact that is examined, as fractions of its length a + b from the edge. For a
/// symmetric contact from the edge to the middle, `to` is 1/2.
struct ExtentRange {
    formula::Exact from = formula::Exact::of(Rational(0));
    formula::Exact to = formula::Exact::of(Rational(1));
};

} // namespace edgeproof::contact
