// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace edgeproof::report {

/// Fills a template of HTML, a file of share/edgeproof/report. {{name}} becomes a value as text,
/// escaped, and {{&name}} a value that is HTML. {{\#name}} ... {{/name}} is repeated for each
/// element of a list, and shown once for another value that is not empty, false or null; names in
/// it are those of the element, else those outside, and `.` is the element itself. {{^name}} ...
/// {{/name}} is shown where {{\#name}} is not. Throws Error for a name without a value and for a
/// section without an end.
[[nodiscard]] std::string filled(std::string_view text, const nlohmann::ordered_json& values);

/// The templates when the program was built.
namespace report_template {
extern const std::string_view page_html;
extern const std::string_view page_css;
extern const std::string_view page_js;
extern const std::string_view figures_html;
extern const std::string_view sides_html;
} // namespace report_template

} // namespace edgeproof::report
