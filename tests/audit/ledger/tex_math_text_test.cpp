// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/ledger/printed_source.hpp"

#include "edgeproof/audit/ledger/ledger.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"
#include "tests/support/table.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace {

bool is_allowed(const std::string& tex, const TexMacros& macros = {}) {
    return !tex_fault(tex, macros).has_value();
}

const std::string ledger_text = R"([ledger]
name = "small"
[[family]]
name = "hertz"
profile = "power-law"
count = 1
[family.parameters]
m = ["1"]
C = ["1"]
a = ["1"]
Es = ["1"]
[[claim]]
id = "C"
kind = "compare"
over = "hertz"
of = "P"
says = "P"
printed = '''PRINTED'''
[notation]
eps = '''NOTATION'''
[print.macros]
own = '''MACRO'''
)";

/// Returns the error of a ledger in which one word is replaced by a text and the others by harmless
/// ones.
std::string error_with(const std::string& word, const std::string& tex) {
    std::string text = test::replaced(ledger_text, word, tex);
    for (const char* other : {"PRINTED", "NOTATION", "MACRO"}) {
        if (word != other) {
            text = test::replaced(text, other, "x");
        }
    }
    try {
        (void)parse_ledger(text, "L.toml");
        return "";
    } catch (const InputError& error) {
        return error.what();
    }
}

const std::vector<std::string> hostile_tex = [] {
    std::vector<std::string> all = test::items(R"ITEMS(
        \write18{touch x}   \immediate\write18{touch x}   \input{/etc/passwd}   \input|"touch x"
        \include{x}   \openout1=x   \openin1=x   \read1 to\x   \catcode`\@=11
        \csname input\endcsname x   \expandafter\x   \def\x{y}   \let\x\input   \newcommand{\x}{y}
        \usepackage{x}   \verbatiminput{x}   \lstinputlisting{x}   \includegraphics{x}
        \special{x}   \directlua{os.execute("x")}   \ShellEscape{x}   \url{x}   \href{x}{y}
        \end{document}   \begin{filecontents}{x}y\end{filecontents}
        \begin{verbatim}\end{verbatim}   \frac{1}{2}\loop\repeat   \frac{1}{2   \frac{1}2}
        x\end{cases}   \begin{cases}\begin{array}{l}x\end{cases}\end{array}   \@input{x}   \
        ^^5cinput{x}   ^^5c^^69nput x   }{   x % a comment   #1   $x
    )ITEMS");
    all.insert(all.end(), {"x\x1b[2J", "x\xff"});
    return all;
}();

} // namespace

TEST_CASE("TeX of a ledger: commands of mathematics are accepted") {
    for (
        const std::string tex :
        {"", "x", R"(M_{I} = \frac{2\sqrt{2}}{3a^{3/2}\pi}\left(\frac{5P'(a)}{8} - aP''(a)\right))",
         R"(p(x) & \, = && \frac{1}{\pi}\int_{x}^{a} \frac{P'(s)}{\sqrt{s^{2}-x^{2}}}\,\mbox{d}s \\)",
         R"(\left[ x \right. \nonumber \\ \label{eqn:a_b-1})",
         R"(\begin{cases} 0 & \mbox{for} \; 0<a<t \\[2mm] x & \text{else} \end{cases})",
         R"(an error of 10\,\% at $u = 0.1a$, see \ref{eqn:x} and \cite{Barber_1})",
         R"(\operatorname{sgn}(x)\,\mathrm{d}x \in \mathbb{R}, \boldsymbol{\sigma} \otimes \hat{n})",
         R"(\sum_{k=0}^{\infty} \binom{n}{k} \leq \lim_{x\to 0} \sup |x| \ll \varepsilon)",
         R"(\begin{equation} \begin{pmatrix} a & b \\ c & d \end{pmatrix} \end{equation})",
         R"(\{x : x \neq 0\} \cup \varnothing \, \$5 \& \# \_ na\"{\i}ve Schr\"odinger)",
         R"(\underbrace{x}_{\text{small}} \overline{y} \dfrac{1}{2} \Bigl( z \Bigr))",
         "γ ≤ δ² — “text”"}) {
        CAPTURE(tex);
        CHECK(is_allowed(tex));
    }
    CHECK(is_allowed(R"(\ve X)", {{"ve", R"(\varepsilon)"}}));
    CHECK_FALSE(is_allowed(R"(\ve X)"));
}

TEST_CASE(
    "TeX of a ledger: commands that read or write files, or change how TeX reads, are refused") {
    for (const std::string& tex : hostile_tex) {
        CAPTURE(tex);
        CHECK_FALSE(is_allowed(tex));
        const TexMacros macros{{"own", tex}};
        CHECK(macro_fault("own", macros).has_value());
    }
}

TEST_CASE("TeX of a ledger: the error names the line, and what to write") {
    CHECK(error_with("PRINTED", "x^2").empty());
    for (const std::string& tex : hostile_tex) {
        if (tex.find('\x1b') != std::string::npos || tex.find('\xff') != std::string::npos) {
            continue; // refused by the TOML reader
        }
        CAPTURE(tex);
        CHECK(
            error_with("PRINTED", tex).starts_with("L.toml:18: printed of claim C cannot be used"));
        CHECK(
            error_with("NOTATION", tex).starts_with("L.toml:20: the TeX of 'eps' cannot be used"));
        CHECK(error_with("MACRO", tex).starts_with("L.toml:22: the TeX of 'own' cannot be used"));
    }
    CHECK(error_with("PRINTED", R"(\write18{x})").find("\\write, which is not a command") !=
          std::string::npos);
    CHECK(error_with("PRINTED", "10 %").find("; write \\%") != std::string::npos);
}

TEST_CASE("macros are expanded as in TeX, and replace LaTeX commands of the same name") {
    const TexMacros macros{{"ve", R"(\varepsilon)"}, {"sgn", R"(\operatorname{sgn})"},
                           {"two", R"(\ve\sgn)"},    {"letters", "ab"},
                           {"input", "I"},           {"none", ""}};
    for (const auto& [name, body] : macros) {
        CHECK_FALSE(macro_fault(name, macros).has_value());
    }
    CHECK(without_macros(R"(\ve X + \vec{x}\\ve)", macros) == R"(\varepsilon X + \vec{x}\\ve)");
    CHECK(without_macros(R"(\two(x))", macros) == R"(\varepsilon\operatorname{sgn}(x))");
    CHECK(without_macros(R"(\alpha\letters)", macros) == R"(\alpha ab)");
    CHECK(without_macros(R"(\input{x}\none y)", macros) == R"(I{x} y)");
}

TEST_CASE("macros: names with other characters, circular and endless macros are refused") {
    for (const std::string name : {"", "a1", "a b", "input}{}\\write", "a\\b"}) {
        CAPTURE(name);
        CHECK(macro_fault(name, {{name, "x"}}).has_value());
    }
    CHECK(macro_fault("a", {{"a", R"(\a)"}}).has_value());
    CHECK(macro_fault("a", {{"a", R"(\b)"}, {"b", R"(x\a)"}}).has_value());
    CHECK_FALSE(macro_fault("a", {{"a", R"(\b)"}, {"b", "x"}}).has_value());
    for (const std::string last : {"x", ""}) { // 2^25 macros
        TexMacros macros{{"a", last}};
        for (char c = 'b'; c <= 'z'; ++c) {
            const std::string before = "\\" + std::string(1, static_cast<char>(c - 1));
            macros[std::string(1, c)] = before + before;
        }
        CHECK_FALSE(is_allowed(R"(\z)", macros));
        CHECK(is_allowed(R"(\c)", macros));
    }
}
