// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/tex_math_text.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgeproof::io {
class TomlSection;
}

namespace edgeproof::audit {

/// How the source of a ledger is cited, numbered and written: what a page needs to speak of it as
/// its readers do. Nothing here decides a verdict.
struct PrintedSource {
    using Texts = TexMacros;
    std::string doi;
    std::string arxiv;
    std::string version;
    /// First line in the TeX source, and "2.1 Title"; in ascending order of the lines.
    std::vector<std::pair<std::size_t, std::string>> sections;
    Texts labels;   ///< the number that a label stands for
    Texts numbers;  ///< of equations, by the ids of claims
    Texts macros;   ///< of its TeX, without the backslash: "ve" = "\\varepsilon"
    Texts notation; ///< how names of formulas are written: "right.c0" = "L_{I}"
    /// The same over one family, before the general ones.
    std::map<std::string, Texts, std::less<>> notation_over;

    /// The number in print, or an empty text.
    [[nodiscard]] std::string number_of(std::string_view id) const;
    /// "2.1 Title", or an empty text where the sections are not known.
    [[nodiscard]] std::string section_of(std::size_t line) const;
    /// TeX of a name (dots or underscores) of a formula over `family`; an empty text if the source
    /// does not say.
    [[nodiscard]] std::string notation_of(std::string_view name, std::string_view family) const;
};

/// The keys of [ledger], [print] and [notation] that are about the source. Throws InputError with
/// the file and the line.
[[nodiscard]] PrintedSource read_printed_source(const io::TomlSection& top);

} // namespace edgeproof::audit
