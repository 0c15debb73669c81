// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/text/escape.hpp"
#include "edgeproof/report/text/filled_template.hpp"

#include "edgeproof/io/foreign_text.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/report/report.hpp"
#include "edgeproof/report/tables/table.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

namespace {

/// Texts that others may have written as a name, an id or a note.
const std::vector<std::string> hostile = {
    "two\nlines",
    "\r\n% \\input{/etc/passwd}",
    "\\input{x} \\write18{rm} $x$ #1 & ~ ^ _ {",
    "<script>alert(1)</script> <img src=x onerror=y>",
    "a | b `c` [text](javascript:x) ![i](u) [r][s]",
    "=1+1",
    "+SUM(A1)",
    "-2+3+cmd|' /C calc'!A0",
    "@x",
    "\x1b[31mred\x1b[0m \x07 \x9b 0",
    std::string("nul \0 here", 10),
    "bad \xff utf8",
    "\"quoted\", comma",
};

bool has_control(const std::string& text) {
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if ((byte < 0x20 && c != '\n') || byte == 0x7F) {
            return true;
        }
    }
    return false;
}

std::size_t lines(const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// Returns the backslash sequences of a LaTeX text, except those for single characters.
std::vector<std::string> commands(const std::string& latex) {
    std::vector<std::string> found;
    for (std::size_t at = latex.find('\\'); at != std::string::npos;) {
        std::size_t end = at + 1;
        while (end < latex.size() && std::isalpha(static_cast<unsigned char>(latex[end])) != 0) {
            ++end;
        }
        const std::string name = latex.substr(at + 1, end - at - 1);
        if (!name.empty() && name != "textbackslash" && name != "textasciitilde" &&
            name != "textasciicircum") {
            found.push_back(name);
        }
        at = latex.find('\\', std::max(end, at + 2));
    }
    return found;
}

/// Returns Markdown without its code spans, which contain no tags.
std::string without_code(const std::string& markdown) {
    std::string out;
    bool code = false;
    for (std::size_t i = 0; i < markdown.size(); ++i) {
        if (!code && markdown[i] == '\\') {
            ++i; // skips the escaped character
        } else if (markdown[i] == '`') {
            code = !code;
        } else if (!code) {
            out += markdown[i];
        }
    }
    return out;
}

Table hostile_table() {
    Table table;
    table.columns = {{"name", Column::Kind::text}, {"value"}};
    for (const std::string& text : hostile) {
        table.rows.push_back({text, "-0.5"});
    }
    return table;
}

AuditResult hostile_verdicts() {
    AuditResult result;
    for (const std::string& text : hostile) {
        ClaimResult r;
        r.claim.id = text;
        r.claim.printed = text;
        r.outcome.note = text;
        r.outcome.correct = text;
        r.outcome.computed = text;
        result.claims.push_back(r);
    }
    result.ledger = hostile[1];
    result.source = hostile[0];
    return result;
}

} // namespace

TEST_CASE("foreign text is one line of text in every format") {
    for (const std::string& text : hostile) {
        CAPTURE(text);
        for (const std::string& out :
             {printable(text), csv_cell(text), csv_text_cell(text), markdown_text(text),
              markdown_code(text), latex_text(text)}) {
            CHECK_FALSE(has_control(out));
            CHECK(lines(out) == 0);
        }
        CHECK(commands(latex_text(text)).empty());
        CHECK(markdown_text(text).find('<') == std::string::npos);
    }
}

TEST_CASE("a cell of text is no formula of a spreadsheet, and a number stays a number") {
    for (const char* const formula : {"=1+1", "+SUM(A1)", "-2+3+cmd|' /C calc'!A0", "@x", "-a*x"}) {
        CHECK(csv_text_cell(formula) == "'" + std::string(formula));
    }
    for (const char* const plain : {"-1/3", "+2.5e-7", "-0.25", "a - x", "", "1 = 1"}) {
        CHECK(csv_text_cell(plain) == plain);
    }
}

TEST_CASE("tables of hostile text keep their rows in every format") {
    const Table table = hostile_table();
    const std::string csv = write_table(table, TableFormat::csv);
    const Csv read = parse_csv(csv, "t.csv");
    REQUIRE(read.rows.size() == hostile.size());
    for (const Csv::Row& row : read.rows) {
        REQUIRE(row.cells.size() == 2);
        CHECK(row.cells[1] == "-0.5");
        CHECK(std::string("=+-@").find(row.cells[0].front()) == std::string::npos);
    }
    const std::string markdown = write_table(table, TableFormat::markdown);
    CHECK(lines(markdown) == hostile.size() + 4); // the program, a blank line, names, dashes
    CHECK(markdown.find('<') == std::string::npos);
    const std::string latex = write_table(table, TableFormat::latex);
    for (const std::string& command : commands(latex)) {
        CAPTURE(command);
        CHECK((command == "begin" || command == "end" || command == "toprule" ||
               command == "midrule" || command == "bottomrule"));
    }
    for (const std::string& text : {csv, markdown, latex}) {
        CHECK_FALSE(has_control(text));
    }
}

TEST_CASE("verdicts of hostile claims keep their rows in every format") {
    const AuditResult result = hostile_verdicts();
    const Csv read = parse_csv(verdicts_csv(result), "verdicts.csv");
    REQUIRE(read.rows.size() == hostile.size());
    for (const Csv::Row& row : read.rows) {
        REQUIRE(row.cells.size() == 9);
        for (const std::string& cell : row.cells) {
            CHECK((cell.empty() || std::string("=+-@").find(cell.front()) == std::string::npos));
        }
    }
    const std::string markdown = verdicts_markdown(result);
    CHECK(lines(markdown) == hostile.size() + 10);
    CHECK(without_code(markdown).find('<') == std::string::npos);
    const std::string latex = verdicts_latex(result);
    CHECK(lines(latex) == hostile.size() + 6);
    REQUIRE(latex.rfind("% ", 0) == 0); // the ledger's name is a comment of one line
    for (const std::string& command : commands(latex.substr(latex.find('\n')))) {
        CAPTURE(command);
        CHECK((command == "begin" || command == "end" || command == "hline" ||
               command == "endhead" || command == "textwidth" || command == "texttt" ||
               command == "footnotesize" || command == "raggedright" ||
               command == "tabularnewline" || command == "allowbreak" || command == "setlength" ||
               command == "tabcolsep"));
    }
    const std::string terminal = verdicts_terminal(result, 100, false);
    for (const std::string& text : {markdown, latex, terminal, verdicts_csv(result)}) {
        CHECK_FALSE(has_control(text));
    }
}

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
    const auto values =
        nlohmann::ordered_json::parse(R"({"x": "{{y}}", "y": 2, "h": "<b>", "no": [],
        "list": [{"y": 3, "in": ["p", "q"]}, {"in": []}], "one": {"h": "i"}})");
    for (const auto& row :
         {std::pair{"a {{x}} b {{x}}{{y}}", "a {{y}} b {{y}}2"},
          {"{{h}}{{&h}}", "&lt;b&gt;<b>"},
          {"{{#list}}[{{y}}{{#in}} {{.}}{{/in}}{{^in}}-{{/in}}]{{/list}}", "[3 p q][2-]"},
          {"{{#one}}{{h}}{{/one}}{{#no}}n{{/no}}{{^no}}none{{/no}}{{#z}}z{{/z}}", "inone"}}) {
        const std::string text = row.first;
        CAPTURE(text);
        CHECK(filled(text, values) == row.second);
    }
    for (const char* text : {"{{z}}", "{{h", "{{#h}}"}) {
        CHECK_THROWS_AS((void)filled(text, values), Error);
    }
}

TEST_CASE("the program contains the complete templates") {
    CHECK(report_template::page_html.starts_with("<!doctype html>"));
    CHECK(report_template::page_html.ends_with("</html>\n"));
    CHECK(report_template::page_css.find("@media print") != std::string_view::npos);
    CHECK(report_template::page_js.ends_with("})();\n"));
    // Proved and confirmed claims differ in mark and colour.
    for (const char* rule :
         {".proved { color: var(--good)", ".proved::before { content: \"✓ \"",
          ".confirmed { color: var(--near)", ".confirmed::before { content: \"≈ \""}) {
        CAPTURE(rule);
        CHECK(report_template::page_css.find(rule) != std::string_view::npos);
    }
}
