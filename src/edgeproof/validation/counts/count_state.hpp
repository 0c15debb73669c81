// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/validation/counts/count.hpp"

#include <string>
#include <string_view>

namespace edgeproof::validation {

/// Writes the contacts without findings, one line each; those with findings are left out, so that
/// they are repeated.
[[nodiscard]] std::string write_count_state(const CountState& state);
/// Throws InputError with the line for a text that is not such a state, or one of another seed,
/// number of values or digits than `wanted`.
[[nodiscard]] CountState parse_count_state(std::string_view text, const std::string& file,
                                           const CountState& wanted);

} // namespace edgeproof::validation
