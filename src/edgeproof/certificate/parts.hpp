// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/certificate/certificate.hpp"
#include "edgeproof/certificate/theory/theory.hpp"

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgeproof::certificate {

using audit::Condition;
using audit::Evidence;
using audit::EvidenceItem;
using audit::Family;
using audit::Outcome;
using audit::Relation;
using audit::Verdict;
using audit::Vocabulary;

/// The Coq files that certificates import, from share/edgeproof/coq.
struct TheoryFile {
    std::string_view name; ///< without .v
    std::string_view content;
    std::string_view needs; ///< in Makefile syntax: "Contact.vo Edges.vo"
};
/// Returns the files in the order in which they are compiled.
[[nodiscard]] const std::vector<TheoryFile>& theory_files();
/// Returns the text of a file of that folder. Certificates of stresses contain "Stress".
[[nodiscard]] std::string_view theory_text(std::string_view name);

namespace coq_files {
/// The name and the text of each file, made by CMake.
extern const std::span<const std::pair<std::string_view, std::string_view>> embedded;
} // namespace coq_files

/// Each of these functions adds the theorems and the text for claims of one kind. They throw
/// NotStated.
using Certify = void(const ClaimResult& result, const Ledger& ledger, Certificate& certificate);
Certify certify_identity;
Certify certify_value;
Certify certify_extent;
Certify certify_expansion;
Certify certify_monotone;
Certify certify_vanishing;
Certify certify_figure;
Certify certify_uniformity;
Certify certify_superposition;
Certify certify_relation;

/// Adds the theorem of a claim for which the Coq files have a theorem of its own, and returns true;
/// returns false for all other claims.
[[nodiscard]] bool certify_listed(const ClaimResult& result, const Ledger& ledger,
                                  Certificate& certificate);

/// Returns an item of what the audit found; throws NotStated if there is none.
[[nodiscard]] const EvidenceItem& item(const Evidence& evidence, std::string_view key);
/// Throws NotStated if the contacts of the claim have friction or are bodies of revolution, if a
/// name of the contact or one of its parameters has another meaning in the claim, or if a reading
/// is about another family or edge.
void require_usual_meaning(const Claim& claim, const Ledger& ledger);
/// Whether a formula or a condition of the claim is, with all definitions put in, the tree of this
/// text. The text may use the names of the contact, the family's parameters, and gp(x), the slope
/// of a tilted punch.
[[nodiscard]] bool is_formula(const Claim& claim, std::string_view key, std::string_view text);
[[nodiscard]] bool is_condition(const Claim& claim, std::string_view key, std::string_view text);

/// Returns the text changed so that it can stand inside a Coq comment: it opens and closes no
/// comment and begins no string.
[[nodiscard]] std::string in_comment(std::string text);
/// The assumption of theorems about all contacts.
inline constexpr std::string_view smoothness = "the load and the left edge are taken to be smooth "
                                               "functions of the right edge, as the expansion "
                                               "needs";
/// Returns the hypothesis, for theorems about all contacts, that the punch is convex: its slope
/// does not decrease, and rises at a place y within the contact (for the left edge: z, mirrored).
[[nodiscard]] std::string convex_hypothesis(bool symmetric);
/// Returns the comment at the beginning of a file: the claim, its place in the source, its text.
[[nodiscard]] std::string file_comment(const Claim& claim, const Ledger& ledger);
/// Returns the commands that import Coq's libraries and `files`.
[[nodiscard]] std::string imports_text(const std::vector<std::string>& files);
/// Returns the comment, then the imports.
[[nodiscard]] std::string file_head(const Claim& claim, const Ledger& ledger, const Theory& theory);
/// Whether two formulas are proved to be equal for any values of the coefficients, the load and the
/// edges in them. A theorem that they are equal is then not about a contact.
[[nodiscard]] bool is_same_for_all(const Expr& x, const Expr& y, Edge edge);
/// Returns the profiles of a family; for a union, those of its members in their order.
[[nodiscard]] std::vector<std::string> profiles_of(const Ledger& ledger, std::string_view family);
/// Whether all punches of these profiles are symmetric.
[[nodiscard]] bool is_symmetric(const std::vector<std::string>& profiles);

} // namespace edgeproof::certificate
