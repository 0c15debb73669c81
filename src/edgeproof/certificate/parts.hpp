// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/certificate/certificate.hpp"
#include "edgeproof/certificate/theory/theory.hpp"

#include <string>
#include <vector>

namespace edgeproof::certificate {

/// Fill in theorems and text for claims of one kind. Throw NotStated.
void certify_identity(const audit::ClaimResult& result, const audit::Ledger& ledger,
                      Certificate& certificate);
void certify_value(const audit::ClaimResult& result, const audit::Ledger& ledger,
                   Certificate& certificate);
void certify_extent(const audit::ClaimResult& result, const audit::Ledger& ledger,
                    Certificate& certificate);
void certify_expansion(const audit::ClaimResult& result, const audit::Ledger& ledger,
                       Certificate& certificate);
void certify_monotone(const audit::ClaimResult& result, const audit::Ledger& ledger,
                      Certificate& certificate);
void certify_vanishing(const audit::ClaimResult& result, const audit::Ledger& ledger,
                       Certificate& certificate);
void certify_figure(const audit::ClaimResult& result, const audit::Ledger& ledger,
                    Certificate& certificate);
void certify_uniformity(const audit::ClaimResult& result, const audit::Ledger& ledger,
                        Certificate& certificate);

/// Text inside a comment of Coq: no comment opens, closes, or begins a string in it.
[[nodiscard]] std::string in_comment(std::string text);
/// What is printed where, as the comment that a file begins with.
[[nodiscard]] std::string file_comment(const audit::Claim& claim, const audit::Ledger& ledger);
/// What a file needs of Coq and of the files that it is stated in.
[[nodiscard]] std::string imports_text(const std::vector<std::string>& files);
/// Both.
[[nodiscard]] std::string file_head(const audit::Claim& claim, const audit::Ledger& ledger,
                                    const Theory& theory);
/// The profiles of a family, those of the members of a union in their order.
[[nodiscard]] std::vector<std::string> profiles_of(const audit::Ledger& ledger,
                                                   std::string_view family);

} // namespace edgeproof::certificate
