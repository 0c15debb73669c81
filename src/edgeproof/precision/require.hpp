// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/error.hpp"

#include <string>

namespace edgeproof {

/// What a caller gave holds, or is refused with a line that says what to give instead.
inline void require(bool holds, const std::string& problem, const std::string& instead) {
    if (!holds) {
        throw InputError(problem, instead);
    }
}

} // namespace edgeproof
