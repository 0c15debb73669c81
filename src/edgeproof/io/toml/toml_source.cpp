// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/io/toml/toml_source.hpp"

#include "edgeproof/io/toml/toml_text.hpp"
#include "edgeproof/precision/error.hpp"

#include <memory>
#include <utility>

namespace edgeproof::io {
namespace {

/// Adds a value that is not parsed.
template <class Source, class Value>
toml::node& add_node(Source& source, toml::table& to, const std::string& key, std::size_t line,
                     Value&& value) {
    toml::source_region at;
    at.begin.line = static_cast<toml::source_index>(line);
    toml::node& node =
        to.insert_or_assign(toml::key(key, at), std::forward<Value>(value)).first->second;
    source.made[&node] = line;
    return node;
}

/// Adds a table to the list of the tables of that name.
template <class Source>
toml::node& add_listed(Source& source, const std::string& name, std::size_t line) {
    toml::node* list = source.root.get(name);
    if (list == nullptr) {
        list = &add_node(source, source.root, name, line, toml::array{});
    }
    list->as_array()->push_back(toml::table{});
    toml::node& node = list->as_array()->back();
    source.made[&node] = line;
    return node;
}

template <class Source> void check_characters(const toml::node& n, const Source& source) {
    const auto check = [&](std::string_view text, std::size_t line) {
        if (has_control(text)) {
            throw InputError("a control character in a key or a text", "leave it out")
                .at(source.file, line);
        }
    };
    if (const auto* table = n.as_table()) {
        for (const auto& [key, value] : *table) {
            check(key.str(), key.source().begin.line);
            check_characters(value, source);
        }
    } else if (const auto* array = n.as_array()) {
        for (const toml::node& element : *array) {
            check_characters(element, source);
        }
    } else if (const auto* text = n.as_string()) {
        check(text->get(), source.line_of(n));
    }
}

} // namespace

void TomlSection::Source::add(const TomlTable& table) {
    const bool listed = table.name.starts_with("[[");
    toml::node* const there = listed ? nullptr : root.get(table.name);
    toml::node& node =
        there != nullptr && there->is_table() ? *there
        : listed ? add_listed(*this, table.name.substr(2, table.name.size() - 4), table.line)
                 : add_node(*this, root, table.name, table.line, toml::table{});
    toml::table& to = *node.as_table();
    for (const TomlEntry& entry : table.entries) {
        to.erase(entry.key);
        if (const auto* list = std::get_if<std::vector<std::string>>(&entry.value)) {
            toml::array& items =
                *add_node(*this, to, entry.key, entry.line, toml::array{}).as_array();
            for (const std::string& item : *list) {
                items.push_back(item);
            }
            for (const toml::node& item : items) {
                made[&item] = entry.line;
            }
        } else if (const auto* flag = std::get_if<bool>(&entry.value)) {
            add_node(*this, to, entry.key, entry.line, *flag);
        } else if (const auto* range = std::get_if<TomlRange>(&entry.value)) {
            toml::node& ends = add_node(*this, to, entry.key, entry.line, toml::table{});
            add_node(*this, *ends.as_table(), "from", entry.line, range->from);
            add_node(*this, *ends.as_table(), "to", entry.line, range->to);
        } else if (!std::get<std::string>(entry.value).empty()) {
            add_node(*this, to, entry.key, entry.line, std::get<std::string>(entry.value));
        }
    }
}

TomlSection TomlSection::parse(std::string_view text, const std::string& file,
                               const std::vector<TomlTable>& instead) {
    if (text.starts_with("\xEF\xBB\xBF")) { // a byte order mark, which toml++ does not count
        text.remove_prefix(3);
    }
    check_toml_limits(text, file);
    auto source = std::make_shared<Source>();
    source->file = file;
    source->lines = split_lines(text);
    try {
        source->root = toml::parse(text, file);
    } catch (const toml::parse_error& error) {
        const std::string why(error.description());
        const bool large = why.find("not representable in 64 bits") != std::string::npos;
        throw InputError("not TOML: " + why,
                         large ? "quote the number: \"...\""
                               : "write key = \"value\" lines under [section] headers")
            .at(file, error.source().begin.line);
    }
    for (const TomlTable& table : instead) {
        source->add(table);
    }
    check_characters(source->root, *source);
    const void* top = &source->root;
    return {std::move(source), top};
}

} // namespace edgeproof::io
