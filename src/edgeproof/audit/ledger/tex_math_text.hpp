// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace edgeproof::audit {

/// The bodies of a source's macros without arguments, by name without the backslash.
using TexMacros = std::map<std::string, std::string, std::less<>>;

/// A fault in a text, and what to write instead.
struct TexFault {
    std::string problem;
    std::string instead;
};

/// Checks a text of a ledger, which is written to a file that the user compiles with LaTeX. It may
/// therefore contain only the commands of mathematics and of plain text (LaTeX's, amsmath's, and
/// `macros`), environments of formulas, and characters that LaTeX prints as they are. Commands that
/// read or write files or change how TeX reads, `%`, `#`, `^^` and control characters are faults.
/// Braces and `$` must be balanced, and the end of an environment needs its beginning (a sentence
/// may stop within an environment). Returns nothing for a text without a fault.
[[nodiscard]] std::optional<TexFault> tex_fault(std::string_view tex, const TexMacros& macros);

/// Checks a macro: its name must consist of letters, and its body must have no fault and must not
/// use the macro itself, directly or through other macros.
[[nodiscard]] std::optional<TexFault> macro_fault(const std::string& name, const TexMacros& macros);

/// Returns the text with its macros replaced by their bodies, as TeX does. The macros must have no
/// fault.
[[nodiscard]] std::string without_macros(std::string_view tex, const TexMacros& macros);

/// True if `\name` is a command of LaTeX or amsmath for a formula or a line of text.
[[nodiscard]] bool is_math_command(std::string_view name);
/// The same for `\begin{name}`, and for a backslash followed by a sign.
[[nodiscard]] bool is_math_environment(std::string_view name);
[[nodiscard]] bool is_math_sign(char sign);

} // namespace edgeproof::audit
