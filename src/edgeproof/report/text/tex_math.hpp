// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/printed_source.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::report {

/// An element of presentation MathML.
struct MathNode {
    std::string tag = "mrow";
    std::string text = {}; ///< of a leaf
    std::vector<MathNode> children = {};
    std::string attributes = {};
    bool changed = false; ///< differs from what it was held against (mark_changes)
};

/// TeX mathematics as a tree: fractions, roots, scripts, fences, cases, accents, integrals, Greek,
/// and the source's own macros. Alignment marks and labels leave nothing; a reference gives the
/// number in print. A command that is not known is set as its name; nothing is refused.
[[nodiscard]] MathNode math_of_tex(std::string_view tex, const audit::PrintedSource& source);

/// Marks what differs between two formulas, in both: the leaves (and roots) outside their longest
/// common sequence.
void mark_changes(MathNode& printed, MathNode& corrected);

/// `<math>` with the tree: in a line of text, or as a block with a name for screen readers.
[[nodiscard]] std::string inline_math(const MathNode& node);
[[nodiscard]] std::string block_math(const MathNode& node, std::string_view name);

/// A sentence of the source as HTML: $...$ and displays typeset, references and citations resolved,
/// dashes and quotation marks set.
[[nodiscard]] std::string sentence_html(std::string_view tex, const audit::PrintedSource& source);

/// Whether a printed text is a sentence and not a formula.
[[nodiscard]] bool is_sentence(std::string_view tex);

/// What stands left of the first "=" of a printed formula, without alignment; empty if nothing
/// does.
[[nodiscard]] std::string left_side(std::string_view tex);

} // namespace edgeproof::report
