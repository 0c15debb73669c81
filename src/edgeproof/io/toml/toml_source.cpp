// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/io/toml/toml_source.hpp"
#include "edgeproof/io/toml/toml_text.hpp"
#include "edgeproof/precision/error.hpp"

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>

#include <algorithm>
#include <memory>
#include <utility>

namespace edgeproof::io {

std::size_t significant_digits(std::string_view number) {
    std::size_t digits = 0;
    for (const char c : number.substr(0, number.find_first_of("eE"))) {
        digits += c >= '0' && c <= '9' && (digits > 0 || c != '0') ? 1 : 0;
    }
    return digits;
}

bool is_number_character(char c) {
    return (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.' || c == 'e' || c == 'E' ||
           c == '_';
}

std::size_t byte_of_column(std::string_view line, std::size_t column) {
    std::size_t at = 0;
    for (std::size_t before = 1; before < column && at < line.size(); ++before) {
        ++at;
        while (at < line.size() && (static_cast<unsigned char>(line[at]) & 0xC0U) == 0x80U) {
            ++at;
        }
    }
    return at;
}

bool has_control(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        const bool c1 = c == 0xC2U && i + 1 < text.size() &&
                        static_cast<unsigned char>(text[i + 1]) < 0xA0U; // U+0080 ... U+009F
        if ((c < 0x20U && c != '\t' && c != '\n' && c != '\r') || c == 0x7FU || c1) {
            return true;
        }
    }
    return false;
}

namespace {

/// The length of the string, on one line or several, with which the text begins.
std::size_t length_of_string(std::string_view text) {
    const char quote = text.front();
    const std::string three(3, quote);
    const bool lines = text.starts_with(three);
    std::size_t at = lines ? three.size() : 1;
    const auto ends = [&] {
        return lines ? text.substr(at).starts_with(three) : text[at] == quote || text[at] == '\n';
    };
    while (at < text.size() && !ends()) {
        at += quote == '"' && text[at] == '\\' ? 2 : 1;
    }
    // Of up to five quotes the last three end a string of several lines.
    for (std::size_t left = lines ? 5 : 1; left > 0 && at < text.size() && text[at] == quote;
         --left) {
        ++at;
    }
    return std::min(at, text.size());
}

} // namespace

void check_toml_limits(std::string_view text, const std::string& file) {
    if (text.size() > most_toml_bytes) {
        throw InputError("the file holds " + std::to_string(text.size()) + " bytes",
                         "write a TOML file of at most " + std::to_string(most_toml_bytes))
            .at(file, 1);
    }
    std::size_t line = 1;
    std::size_t dots = 0; // of the current key
    while (!text.empty()) {
        const char c = text.front();
        const std::size_t length = c == '"' || c == '\'' ? length_of_string(text)
                                   : c == '#'            ? std::min(text.find('\n'), text.size())
                                                         : 1;
        dots = std::string_view("\n[]{}=,").find(c) == std::string_view::npos ? dots : 0;
        if (c == '.' && ++dots >= most_toml_nesting) {
            throw InputError("a key joins names by dots, more than " +
                                 std::to_string(most_toml_nesting) + " levels deep",
                             "write key = \"value\" lines under [section] headers")
                .at(file, line);
        }
        line += static_cast<std::size_t>(std::ranges::count(text.substr(0, length), '\n'));
        text.remove_prefix(length);
    }
}

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
            if (range->points > 0) {
                add_node(*this, *ends.as_table(), "points", entry.line,
                         std::int64_t{range->points});
            }
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
    boost::split(source->lines, text, boost::is_any_of("\n"));
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
