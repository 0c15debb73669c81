// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string_view>

namespace edgeproof::audit {

/// True if `\name` is a command of LaTeX or amsmath for a formula or a line of text.
[[nodiscard]] bool is_math_command(std::string_view name);
/// The same for `\begin{name}`, and for a backslash followed by a sign.
[[nodiscard]] bool is_math_environment(std::string_view name);
[[nodiscard]] bool is_math_sign(char sign);

} // namespace edgeproof::audit
