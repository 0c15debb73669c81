// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/error.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace edgeproof::audit {

/// What a name that no formula may use here stands for in the literature, where that is mechanics
/// which Edgeproof does not hold: "stress below the surface" for tau_max, "friction" for mu, a
/// "point contact" for sphere. Nothing for any other name.
[[nodiscard]] std::optional<std::string_view> outside_of_scope(std::string_view name);

/// The same error; where it is of an unknown name outside of the scope, it says so, and what is
/// computed.
[[nodiscard]] InputError with_scope(const InputError& error);

} // namespace edgeproof::audit
