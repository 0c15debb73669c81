// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/law/kernels.hpp"

namespace edgeproof::contact {

/// The mark of v, limited to the contact: a distance from an edge that may be negative is replaced
/// by the interval from 0 to its upper end, so that a ball of b that contains a knot needs no
/// special case.
[[nodiscard]] Mark<Ball> clamped_mark(const Extent<Ball>& e, const Ball& v);

/// max(x, 0) as a ball.
[[nodiscard]] Ball clamped(const Ball& x);

/// G(x, v) = ln((sqrt p + sqrt q)^2/(D |v - x|)), p = right_v left_x, q = right_x left_v
/// (docs/pressure.md, "Closed form: piecewise linear slopes"), and (v - x) G. The latter is also
/// enclosed if the ball of v - x contains zero, and is 0 if v = x. `right_x`, `left_x`: distances
/// of x from the edges; w_x = sqrt(right_x left_x); D = a + b; `offset` = v - x; all are lengths.
struct BallGreen {
    Ball value;
    Ball moment;
    Ball least; ///< a lower bound of G over the balls, finite even if the value is not
};
[[nodiscard]] BallGreen ball_green(const Mark<Ball>& v, const Ball& right_x, const Ball& left_x,
                                   const Ball& w_x, const Ball& D, const Ball& offset);
/// Encloses (v - x) G where the ball of v - x contains zero, from p, q, D and the offset v - x. Not
/// finite if the ball is too wide.
[[nodiscard]] Ball moment_across(const Ball& p, const Ball& q, const Ball& D, const Ball& offset);

} // namespace edgeproof::contact
