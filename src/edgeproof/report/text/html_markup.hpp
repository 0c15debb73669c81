// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <map>
#include <string>
#include <string_view>

namespace edgeproof::report {

/// Escapes text for HTML, between tags or in a quoted attribute. Control characters not allowed in
/// HTML become spaces; bytes that are not UTF-8 become U+FFFD.
[[nodiscard]] std::string escape_html(std::string_view text);

/// Replaces `{{name}}` in a template by `values[name]`, once and not in the inserted text. Throws
/// Error for a name without a value.
[[nodiscard]] std::string
fill_template(std::string_view text, const std::map<std::string, std::string, std::less<>>& values);

/// The files of share/edgeproof/report when the program was built.
namespace report_template {
extern const std::string_view page_html;
extern const std::string_view page_css;
extern const std::string_view page_js;
} // namespace report_template

} // namespace edgeproof::report
