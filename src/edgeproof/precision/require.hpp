// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/error.hpp"

#include <string>

namespace edgeproof {

/// Throws InputError if a requirement on the input does not hold; `instead` states what to give.
inline void require(bool holds, const std::string& problem, const std::string& instead) {
    if (!holds) {
        throw InputError(problem, instead);
    }
}

} // namespace edgeproof
