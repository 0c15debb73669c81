// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string_view>

namespace edgeproof::audit {

/// Whether `\name` is a command of LaTeX or amsmath for a formula or a line of text.
[[nodiscard]] bool is_math_command(std::string_view name);
/// The same of `\begin{name}`, and of a backslash with a character that is no letter.
[[nodiscard]] bool is_math_environment(std::string_view name);
[[nodiscard]] bool is_math_sign(char sign);

} // namespace edgeproof::audit
