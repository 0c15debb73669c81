// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/double_word/double_word.hpp"

namespace edgeproof {

/// A double word whose numbers are those of the ball, and more: unknown where the ball is not
/// finite, or its middle is not 0 and not between 2^-900 and 2^900 in size.
[[nodiscard]] DoubleWord to_double_word(const Ball& x);

} // namespace edgeproof
