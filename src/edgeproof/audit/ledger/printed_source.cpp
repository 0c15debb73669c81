// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/ledger/printed_source.hpp"

#include "edgeproof/io/toml/toml_section.hpp"

#include <algorithm>
#include <charconv>

namespace edgeproof::audit {
namespace {

constexpr std::size_t most_macros = 1000;

std::string underscored(std::string_view name) {
    std::string plain(name);
    std::ranges::replace(plain, '.', '_');
    return plain;
}

std::string text_at(const PrintedSource::Texts& texts, std::string_view key) {
    const auto it = texts.find(key);
    return it == texts.end() ? "" : it->second;
}

PrintedSource::Texts texts_of(const io::TomlSection& top, std::string_view key) {
    PrintedSource::Texts texts;
    if (top.has(key)) {
        const io::TomlSection table = top.section(key);
        for (const std::string& name : table.keys()) {
            texts.emplace(name, table.text(name));
        }
    }
    return texts;
}

std::size_t line_number(const io::TomlSection& table, const std::string& key) {
    std::size_t line = 0;
    const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), line);
    if (error != std::errc() || end != key.data() + key.size() || line == 0) {
        table.reject(key, "'" + key + "' is not a line number of the source",
                     "write \"LINE\" = \"2.1 Title\"");
    }
    return line;
}

void refuse(const std::optional<TexFault>& fault, const io::TomlSection& table,
            const std::string& key) {
    if (fault) {
        table.reject(key, "the TeX of '" + key + "' cannot be used: " + fault->problem,
                     fault->instead);
    }
}

} // namespace

std::string PrintedSource::number_of(std::string_view id) const { return text_at(numbers, id); }

std::string PrintedSource::section_of(std::size_t line) const {
    const auto next = std::ranges::upper_bound(sections, line, {},
                                               [](const auto& section) { return section.first; });
    return next == sections.begin() ? "" : std::prev(next)->second;
}

std::string PrintedSource::notation_of(std::string_view name, std::string_view family) const {
    if (const auto over = notation_over.find(family); over != notation_over.end()) {
        if (std::string tex = text_at(over->second, underscored(name)); !tex.empty()) {
            return tex;
        }
    }
    return text_at(notation, underscored(name));
}

PrintedSource read_printed_source(const io::TomlSection& top) {
    PrintedSource source;
    const io::TomlSection head = top.section("ledger");
    source.doi = head.written_or("doi", "");
    source.arxiv = head.written_or("arxiv", "");
    source.version = head.written_or("version", "");
    if (top.has("print")) {
        const io::TomlSection print = top.section("print");
        print.allow({"sections", "labels", "numbers", "macros"});
        if (print.has("sections")) {
            const io::TomlSection sections = print.section("sections");
            for (const std::string& key : sections.keys()) {
                source.sections.emplace_back(line_number(sections, key), sections.text(key));
            }
            std::ranges::sort(source.sections);
        }
        source.labels = texts_of(print, "labels");
        source.numbers = texts_of(print, "numbers");
        source.macros = texts_of(print, "macros");
        if (source.macros.size() > most_macros) {
            print.reject("macros",
                         "[print.macros] has more than " + std::to_string(most_macros) + " macros",
                         "give the macros that are used");
        }
        for (const auto& [name, body] : source.macros) {
            refuse(macro_fault(name, source.macros), print.section("macros"), name);
        }
    }
    if (top.has("notation")) {
        const io::TomlSection notation = top.section("notation");
        for (const std::string& name : notation.keys()) {
            if (!notation.is_table(name)) {
                source.notation.emplace(underscored(name), notation.text(name));
                refuse(tex_fault(notation.text(name), source.macros), notation, name);
                continue;
            }
            for (const auto& [symbol, tex] : texts_of(notation, name)) {
                source.notation_over[name].emplace(underscored(symbol), tex);
                refuse(tex_fault(tex, source.macros), notation.section(name), symbol);
            }
        }
    }
    return source;
}

} // namespace edgeproof::audit
