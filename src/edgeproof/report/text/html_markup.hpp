// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <map>
#include <string>
#include <string_view>

namespace edgeproof::report {

/// Text as it may stand in HTML, between tags or inside a quoted attribute. Control characters that
/// HTML does not admit become spaces; bytes that are no UTF-8 become U+FFFD.
[[nodiscard]] std::string escape_html(std::string_view text);

/// `{{name}}` in a template replaced by `values[name]`, once and not inside what was put in.
/// Throws Error for a name without a value.
[[nodiscard]] std::string
fill_template(std::string_view text, const std::map<std::string, std::string, std::less<>>& values);

/// The files of share/edgeproof/report, as they were when the program was built.
namespace report_template {
extern const std::string_view page_html;
extern const std::string_view page_css;
extern const std::string_view page_js;
} // namespace report_template

} // namespace edgeproof::report
