// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/error.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace edgeproof::audit {

/// For a name that is not available in formulas: its usual meaning in the literature, if that is a
/// part of mechanics which Edgeproof does not cover: "stress below the surface" for tau_max,
/// "friction" for mu, a "point contact" for sphere. Nothing for any other name.
[[nodiscard]] std::optional<std::string_view> outside_of_scope(std::string_view name);

/// Returns the same error; for an unknown name outside the scope, it adds what is computed.
[[nodiscard]] InputError with_scope(const InputError& error);

} // namespace edgeproof::audit
