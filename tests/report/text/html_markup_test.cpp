// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/text/html_markup.hpp"

#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

TEST_CASE("escaping: the characters of markup in a text are escaped") {
    CHECK(escape_html("<script>alert('x')</script>") ==
          "&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt;");
    CHECK(escape_html("a & b \"c\"") == "a &amp; b &quot;c&quot;");
    CHECK(escape_html("&lt;") == "&amp;lt;");
    CHECK(escape_html("π ≤ 3.2 — 𝜋") == "π ≤ 3.2 — 𝜋");
    CHECK(escape_html("line\nline\tend\x01\x7f") == "line\nline\tend  ");
}

TEST_CASE("escaping: bytes that are not UTF-8 are replaced by U+FFFD") {
    CHECK(escape_html("a\xFFz") == "a\xEF\xBF\xBDz");
    CHECK(escape_html("\xC3") == "\xEF\xBF\xBD");
    CHECK(escape_html("\xC0\xBC") == "\xEF\xBF\xBD\xEF\xBF\xBD"); // "<" in an overlong encoding
    CHECK(escape_html("\xED\xA0\x80").find('\xED') == std::string::npos);
}

TEST_CASE("a template is filled once, and an unknown name in it is an error") {
    CHECK(fill_template("a {{x}} b {{x}}{{y}}", {{"x", "{{y}}"}, {"y", "2"}}) ==
          "a {{y}} b {{y}}2");
    CHECK_THROWS_AS((void)fill_template("{{z}}", {}), Error);
    CHECK_THROWS_AS((void)fill_template("{{z", {{"z", ""}}), Error);
}

TEST_CASE("the program contains the complete templates") {
    CHECK(report_template::page_html.starts_with("<!doctype html>"));
    CHECK(report_template::page_html.ends_with("</html>\n"));
    CHECK(report_template::page_css.find("@media print") != std::string_view::npos);
    CHECK(report_template::page_js.ends_with("})();\n"));
    // A proved claim has its own mark; the button names the theme that a click selects.
    CHECK(report_template::page_css.find(".proved::before") != std::string_view::npos);
    CHECK(report_template::page_js.find("isDark() ? \"Light\" : \"Dark\"") !=
          std::string_view::npos);
}
