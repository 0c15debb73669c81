// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/audit/ledger/printed_source.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::report {

struct MathNode {
    std::string tag = "mrow";
    std::string text = {}; ///< of a leaf
    std::vector<MathNode> children = {};
    std::string attributes = {};
    bool changed = false; ///< differs from the other formula (mark_changes)
};

/// Parses TeX mathematics into a tree: fractions, roots, scripts, fences, cases, accents,
/// integrals, Greek, and the source's own macros. Alignment marks and labels are dropped; a
/// reference becomes the printed number. An unknown command is shown by its name; no input is
/// refused.
[[nodiscard]] MathNode math_of_tex(std::string_view tex, const audit::PrintedSource& source);

/// Marks the differences between two formulas in both: the leaves (and roots) outside their longest
/// common subsequence.
void mark_changes(MathNode& printed, MathNode& corrected);

/// Returns `<math>` with the tree: within a line of text, or as a block with a name for screen
/// readers.
[[nodiscard]] std::string inline_math(const MathNode& node);
[[nodiscard]] std::string block_math(const MathNode& node, std::string_view name);

/// Returns a sentence of the source as HTML: $...$ and displays are typeset, references and
/// citations resolved, dashes and quotation marks converted.
[[nodiscard]] std::string sentence_html(std::string_view tex, const audit::PrintedSource& source);

/// True if a printed text is a sentence rather than a formula.
[[nodiscard]] bool is_sentence(std::string_view tex);

/// Returns the part of a printed formula left of the first "=", without alignment; may be empty.
[[nodiscard]] std::string left_side(std::string_view tex);

/// Splits TeX into tokens: commands with their backslash, whole numbers and decimals, single
/// characters (a non-ASCII letter is one token). Runs of white space become one " ".
[[nodiscard]] std::vector<std::string> tex_tokens(std::string_view tex);

/// The element of MathML for a command: an operator (mo), a letter (mi), or a space (mspace) and
/// its width, which is empty for a command that shows nothing.
struct TexSymbol {
    const char* tag;
    std::string_view text;
};
/// Returns nothing for other commands. The command is given without its backslash.
[[nodiscard]] std::optional<TexSymbol> tex_symbol(std::string_view command);

} // namespace edgeproof::report
