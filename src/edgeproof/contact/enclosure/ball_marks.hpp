// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/ball.hpp"

namespace edgeproof::contact {

/// A point v of the contact in balls, clamped to it: distances from the edges that may be negative
/// count as 0 ... their upper end.
struct BallMark {
    Ball right;           ///< a - v
    Ball left;            ///< v + b
    Ball y;               ///< v - c
    Ball w;               ///< sqrt((a - v)(v + b))
    Ball h;               ///< 2 atan sqrt((a - v)/(v + b))
    bool outside = false; ///< certainly not inside the contact

    [[nodiscard]] static BallMark at(const Ball& a, const Ball& b, const Ball& v);
    [[nodiscard]] static BallMark right_end(const Ball& a, const Ball& b);
    [[nodiscard]] static BallMark left_end(const Ball& a, const Ball& b);
};

/// max(x, 0), as a ball.
[[nodiscard]] Ball clamped(const Ball& x);
/// The root of a number that is known not to be negative although its ball may reach below zero.
[[nodiscard]] Ball root(const Ball& x);

/// G(x, v) = ln((sqrt p + sqrt q)^2/(D |v - x|)), p = right_v left_x, q = right_x left_v, and
/// (v - x) G, which is enclosed also where the ball of v - x holds zero, and is 0 where it is zero.
struct BallGreen {
    Ball value;
    Ball moment;
    Ball least; ///< below G everywhere in the balls, and finite where the value is not
};
[[nodiscard]] BallGreen ball_green(const BallMark& v, const Ball& right_x, const Ball& left_x,
                                   const Ball& D, const Ball& offset);
/// The same where w_x = sqrt(right_x left_x) is known: no root is left to take.
[[nodiscard]] BallGreen ball_green(const BallMark& v, const Ball& right_x, const Ball& left_x,
                                   const Ball& w_x, const Ball& D, const Ball& offset);

} // namespace edgeproof::contact
