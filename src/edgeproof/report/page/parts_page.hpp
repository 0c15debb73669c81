// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::report {

/// share/edgeproof/report/cost.html when the program was built: the page of `cost`.
namespace cost_template {
extern const std::string_view cost_html;
} // namespace cost_template

/// A part of a self-contained page.
struct PagePart {
    std::string id;
    std::string title;
    std::string html;
    std::string listed; ///< its name in the table of contents; empty: it is not listed
};
/// Returns the page with its parts, all texts escaped. `about`: a line below the title; `labelled`:
/// each part refers to its title, for screen readers.
[[nodiscard]] std::string parts_page(const std::string& title, const std::string& about,
                                     const std::vector<PagePart>& parts, bool labelled,
                                     const std::string& footer);

} // namespace edgeproof::report
