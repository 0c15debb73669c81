// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/law/kernels.hpp"

namespace edgeproof::contact {

/// The mark of v, clamped to the contact: distances from the edges that may be negative count as
/// 0 ... their upper end, so that a ball of b that straddles a knot needs no case of its own.
[[nodiscard]] Mark<Ball> clamped_mark(const Extent<Ball>& e, const Ball& v);

/// max(x, 0), as a ball.
[[nodiscard]] Ball clamped(const Ball& x);

/// G(x, v) = ln((sqrt p + sqrt q)^2/(D |v - x|)), p = right_v left_x, q = right_x left_v, and
/// (v - x) G, which is enclosed also where the ball of v - x holds zero, and is 0 where it is zero.
struct BallGreen {
    Ball value;
    Ball moment;
    Ball least; ///< below G everywhere in the balls, and finite where the value is not
};
[[nodiscard]] BallGreen ball_green(const Mark<Ball>& v, const Ball& right_x, const Ball& left_x,
                                   const Ball& D, const Ball& offset);
/// The same where w_x = sqrt(right_x left_x) is known: no root is left to take.
[[nodiscard]] BallGreen ball_green(const Mark<Ball>& v, const Ball& right_x, const Ball& left_x,
                                   const Ball& w_x, const Ball& D, const Ball& offset);

} // namespace edgeproof::contact
