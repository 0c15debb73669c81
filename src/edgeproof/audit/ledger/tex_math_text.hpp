// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace edgeproof::audit {

/// Macros of a source without arguments: by the name, without the backslash.
using TexMacros = std::map<std::string, std::string, std::less<>>;

/// What is wrong with a text, and what to write instead.
struct TexFault {
    std::string problem;
    std::string instead;
};

/// A text of a ledger reaches a file that the user compiles with LaTeX. It may therefore hold the
/// commands of mathematics and of plain text only (LaTeX's and amsmath's, and `macros`),
/// environments of formulas, and characters that LaTeX reads as they stand: no command that reads
/// or writes files or changes how TeX reads, no `%`, `#` or `^^`, no control characters; braces
/// and `$` are balanced, and an \end has its \begin (a sentence may stop within an environment).
/// Nothing if the text is such a text.
[[nodiscard]] std::optional<TexFault> tex_fault(std::string_view tex, const TexMacros& macros);

/// The same of a macro: its name is letters, its body a text as above that does not use the macro
/// itself, nor does any macro in it.
[[nodiscard]] std::optional<TexFault> macro_fault(const std::string& name, const TexMacros& macros);

/// The text with its macros replaced by their bodies, as TeX would do. Of macros without a fault.
[[nodiscard]] std::string without_macros(std::string_view tex, const TexMacros& macros);

} // namespace edgeproof::audit
