// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/text/tex_tokens.hpp"

#include <cctype>
#include <map>

namespace edgeproof::report {
namespace {

using CommandTable = std::map<std::string_view, std::string_view>;

std::optional<std::string_view> command_in(const CommandTable& table, std::string_view key) {
    const auto it = table.find(key);
    return it == table.end() ? std::nullopt : std::optional(it->second);
}
bool of_kind(int (*test)(int), char c) { return test(static_cast<unsigned char>(c)) != 0; }

} // namespace

std::vector<std::string> tex_tokens(std::string_view tex) {
    std::vector<std::string> tokens;
    std::size_t i = 0;
    const auto take = [&](std::size_t n) {
        tokens.emplace_back(tex.substr(i, n));
        i += tokens.back().size();
    };
    while (i < tex.size()) {
        std::size_t n = 1;
        if (tex[i] == '\\') {
            ++n;
            if (i + 1 < tex.size() && of_kind(std::isalpha, tex[i + 1])) {
                while (i + n < tex.size() && of_kind(std::isalpha, tex[i + n])) {
                    ++n;
                }
            }
            take(n);
        } else if (of_kind(std::isspace, tex[i])) {
            while (i < tex.size() && of_kind(std::isspace, tex[i])) {
                ++i;
            }
            tokens.emplace_back(" ");
        } else if (of_kind(std::isdigit, tex[i])) {
            while (i + n < tex.size() && (of_kind(std::isdigit, tex[i + n]) ||
                                          (tex[i + n] == '.' && i + n + 1 < tex.size() &&
                                           of_kind(std::isdigit, tex[i + n + 1])))) {
                ++n;
            }
            take(n);
        } else {
            while (i + n < tex.size() && (static_cast<unsigned char>(tex[i]) & 0x80U) != 0 &&
                   (static_cast<unsigned char>(tex[i + n]) & 0xC0U) == 0x80U) {
                ++n;
            }
            take(n);
        }
    }
    return tokens;
}

std::optional<std::string_view> tex_operator(std::string_view command) {
    static const CommandTable operators{
        {"int", "∫"},     {"fint", "⨍"},       {"sum", "∑"},   {"pm", "±"},     {"mp", "∓"},
        {"cdot", "·"},    {"times", "×"},      {"leq", "≤"},   {"le", "≤"},     {"geq", "≥"},
        {"ge", "≥"},      {"ll", "≪"},         {"gg", "≫"},    {"approx", "≈"}, {"sim", "∼"},
        {"neq", "≠"},     {"rightarrow", "→"}, {"to", "→"},    {"in", "∈"},     {"dots", "…"},
        {"ldots", "…"},   {"cdots", "⋯"},      {"prime", "′"}, {"{", "{"},      {"}", "}"},
        {"partial", "∂"}, {"propto", "∝"},     {"%", "%"}};
    return command_in(operators, command);
}

std::optional<std::string_view> tex_letter(std::string_view command) {
    static const CommandTable letters{
        {"alpha", "α"}, {"beta", "β"},   {"gamma", "γ"}, {"delta", "δ"}, {"epsilon", "ϵ"},
        {"zeta", "ζ"},  {"eta", "η"},    {"theta", "θ"}, {"kappa", "κ"}, {"varepsilon", "ε"},
        {"mu", "μ"},    {"nu", "ν"},     {"xi", "ξ"},    {"pi", "π"},    {"lambda", "λ"},
        {"rho", "ρ"},   {"sigma", "σ"},  {"tau", "τ"},   {"phi", "φ"},   {"varphi", "φ"},
        {"chi", "χ"},   {"psi", "ψ"},    {"omega", "ω"}, {"Gamma", "Γ"}, {"Delta", "Δ"},
        {"Theta", "Θ"}, {"Lambda", "Λ"}, {"Sigma", "Σ"}, {"Phi", "Φ"},   {"Psi", "Ψ"},
        {"Omega", "Ω"}, {"infty", "∞"},  {"ell", "ℓ"}};
    return command_in(letters, command);
}

std::optional<std::string_view> tex_space(std::string_view command) {
    static const CommandTable spaces{{",", "0.17em"},   {";", "0.28em"},  {":", "0.22em"},
                                     {" ", "0.28em"},   {"quad", "1em"},  {"qquad", "2em"},
                                     {"!", ""},         {"nonumber", ""}, {"displaystyle", ""},
                                     {"textstyle", ""}, {"bigg", ""},     {"Bigg", ""},
                                     {"big", ""},       {"Big", ""},      {"limits", ""},
                                     {"notag", ""},     {"right", ""}};
    return command_in(spaces, command);
}

} // namespace edgeproof::report
