// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgeproof::io {
class TomlSection;
}

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

/// The citation, numbering and notation of a ledger's source, used in reports. It has no effect on
/// a verdict.
struct PrintedSource {
    using Texts = TexMacros;
    std::string doi;
    std::string arxiv;
    std::string version;
    /// The first line in the TeX source and the heading ("2.1 Title"), in ascending order.
    std::vector<std::pair<std::size_t, std::string>> sections;
    Texts labels;   ///< the number for each label
    Texts numbers;  ///< the equation numbers by the ids of claims
    Texts macros;   ///< TeX macros, without the backslash: "ve" = "\\varepsilon"
    Texts notation; ///< the TeX form of names in formulas: "right.c0" = "L_{I}"
    /// The notation for one family, which has priority over `notation`.
    std::map<std::string, Texts, std::less<>> notation_over;

    /// Returns the number in print, or an empty text.
    [[nodiscard]] std::string number_of(std::string_view id) const;
    /// Returns "2.1 Title", or an empty text if the section is not known.
    [[nodiscard]] std::string section_of(std::size_t line) const;
    /// Returns the TeX form of a name (with dots or underscores) in a formula over `family`; an
    /// empty text if the ledger gives none.
    [[nodiscard]] std::string notation_of(std::string_view name, std::string_view family) const;
};

/// Reads the keys of [ledger], [print] and [notation] that describe the source. Throws InputError
/// with the file and the line.
[[nodiscard]] PrintedSource read_printed_source(const io::TomlSection& top);

} // namespace edgeproof::audit
