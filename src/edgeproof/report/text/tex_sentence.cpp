// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/text/escape.hpp"
#include "edgeproof/report/text/tex_math.hpp"

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <boost/regex.hpp>

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <map>
#include <utility>

namespace edgeproof::report {
namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// Signs that have a TeX command in text.
std::string_view text_sign(std::string_view command) {
    return command == "\\textsection"       ? "§"
           : command == "\\textbackslash"   ? "\\"
           : command == "\\textasciitilde"  ? "~"
           : command == "\\textasciicircum" ? "^"
                                            : "";
}

/// Returns text between formulas: commands are evaluated, the rest is escaped.
std::string plain_html(std::string_view tex, const audit::PrintedSource& source) {
    const std::vector<std::string> tokens = tex_tokens(tex);
    std::string out;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const std::string& token = tokens[i];
        const auto group = [&] {
            std::string text;
            if (i + 1 < tokens.size() && tokens[i + 1] == "{") {
                for (i += 2; i < tokens.size() && tokens[i] != "}"; ++i) {
                    text += tokens[i];
                }
            }
            return text;
        };
        if (token == "\\ref" || token == "\\eqref") {
            const auto number = source.labels.find(group());
            out += number == source.labels.end() ? "?" : escape_html(number->second);
        } else if (token == "\\cite") {
            out += "[" + escape_html(group()) + "]";
        } else if (token == "\\label") {
            group();
        } else if (const auto sign = text_sign(token); !sign.empty()) {
            out += sign;
            i += i + 2 < tokens.size() && tokens[i + 1] == "{" && tokens[i + 2] == "}" ? 2 : 0;
        } else if (token.size() == 2 && token[0] == '\\' && !is_letter(token[1])) {
            out += token[1] == '\\' || token[1] == ',' ? " " : escape_html(token.substr(1));
        } else if (token[0] != '\\' && token != "{" && token != "}") {
            out += token == "~" ? " " : escape_html(token);
        }
    }
    boost::replace_all(out, "---", "—");
    boost::replace_all(out, "--", "–");
    boost::replace_all(out, "``", "“");
    boost::replace_all(out, "&#39;&#39;", "”");
    boost::replace_all(out, "`", "‘");
    return out;
}

} // namespace

std::string sentence_html(std::string_view tex, const audit::PrintedSource& source) {
    static constexpr std::string_view begin = "\\begin{equation}";
    static constexpr std::string_view end = "\\end{equation}";
    std::string out;
    while (!tex.empty()) {
        const std::size_t dollar = tex.find('$');
        const std::size_t display = tex.find(begin);
        const std::size_t at = std::min(dollar, display);
        out += plain_html(tex.substr(0, at), source);
        if (at == std::string_view::npos) {
            break;
        }
        const bool in_line = dollar < display;
        tex.remove_prefix(at + (in_line ? 1 : begin.size()));
        const std::size_t close = in_line ? tex.find('$') : tex.find(end);
        const MathNode math = math_of_tex(tex.substr(0, close), source);
        out += in_line ? inline_math(math) : " " + inline_math(math) + " ";
        if (close == std::string_view::npos) {
            break;
        }
        tex.remove_prefix(close + (in_line ? 1 : end.size()));
    }
    return out;
}

bool is_sentence(std::string_view tex) {
    if (tex.find('$') != std::string_view::npos) {
        return true;
    }
    // Three words separated only by spaces, the first neither a command nor in braces.
    static const boost::regex words("(^|[^\\\\{A-Za-z])[A-Za-z]{2,}([ ,\n]+[A-Za-z]{2,}){2}");
    return boost::regex_search(tex.begin(), tex.end(), words);
}

std::string left_side(std::string_view tex) {
    int depth = 0;
    std::string left;
    for (std::size_t i = 0; i < tex.size(); ++i) {
        const char c = tex[i];
        depth += c == '{' ? 1 : c == '}' ? -1 : 0;
        if (c == '=' && depth == 0) {
            for (const std::string_view spacing : {"\\,", "\\;", "&"}) {
                boost::replace_all(left, spacing, "");
            }
            return boost::trim_copy_if(left, boost::is_any_of(" \n"));
        }
        left += c;
    }
    return "";
}

std::vector<std::string> tex_tokens(std::string_view tex) {
    static const boost::regex token(
        R"(\\[A-Za-z]+|\\[\s\S]?|\s+|[0-9]+(?:\.[0-9]+)*|[^\x01-\x7F][\x80-\xBF]*|[\s\S])");
    std::vector<std::string> tokens;
    using Tokens = boost::regex_iterator<std::string_view::iterator>;
    for (Tokens one(tex.begin(), tex.end(), token); one != Tokens(); ++one) {
        const std::string text = one->str();
        tokens.push_back(std::isspace(static_cast<unsigned char>(text.front())) != 0 ? " " : text);
    }
    return tokens;
}

std::optional<TexSymbol> tex_symbol(std::string_view command) {
    using CommandTable = std::map<std::string_view, std::string_view>;
    static const CommandTable operators{
        {"int", "∫"},     {"fint", "⨍"},       {"sum", "∑"},   {"pm", "±"},     {"mp", "∓"},
        {"cdot", "·"},    {"times", "×"},      {"leq", "≤"},   {"le", "≤"},     {"geq", "≥"},
        {"ge", "≥"},      {"ll", "≪"},         {"gg", "≫"},    {"approx", "≈"}, {"sim", "∼"},
        {"neq", "≠"},     {"rightarrow", "→"}, {"to", "→"},    {"in", "∈"},     {"dots", "…"},
        {"ldots", "…"},   {"cdots", "⋯"},      {"prime", "′"}, {"{", "{"},      {"}", "}"},
        {"partial", "∂"}, {"propto", "∝"},     {"%", "%"}};
    static const CommandTable letters{
        {"alpha", "α"}, {"beta", "β"},   {"gamma", "γ"}, {"delta", "δ"}, {"epsilon", "ϵ"},
        {"zeta", "ζ"},  {"eta", "η"},    {"theta", "θ"}, {"kappa", "κ"}, {"varepsilon", "ε"},
        {"mu", "μ"},    {"nu", "ν"},     {"xi", "ξ"},    {"pi", "π"},    {"lambda", "λ"},
        {"rho", "ρ"},   {"sigma", "σ"},  {"tau", "τ"},   {"phi", "φ"},   {"varphi", "φ"},
        {"chi", "χ"},   {"psi", "ψ"},    {"omega", "ω"}, {"Gamma", "Γ"}, {"Delta", "Δ"},
        {"Theta", "Θ"}, {"Lambda", "Λ"}, {"Sigma", "Σ"}, {"Phi", "Φ"},   {"Psi", "Ψ"},
        {"Omega", "Ω"}, {"infty", "∞"},  {"ell", "ℓ"}};
    static const CommandTable spaces{{",", "0.17em"},   {";", "0.28em"},  {":", "0.22em"},
                                     {" ", "0.28em"},   {"quad", "1em"},  {"qquad", "2em"},
                                     {"!", ""},         {"nonumber", ""}, {"displaystyle", ""},
                                     {"textstyle", ""}, {"bigg", ""},     {"Bigg", ""},
                                     {"big", ""},       {"Big", ""},      {"limits", ""},
                                     {"notag", ""},     {"right", ""}};
    using Tagged = std::initializer_list<std::pair<const char*, const CommandTable*>>;
    for (const auto& [tag, table] :
         Tagged{{"mo", &operators}, {"mi", &letters}, {"mspace", &spaces}}) {
        if (const auto it = table->find(command); it != table->end()) {
            return TexSymbol{tag, it->second};
        }
    }
    return std::nullopt;
}

} // namespace edgeproof::report
