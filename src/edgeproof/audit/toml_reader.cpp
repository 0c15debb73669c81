// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/toml_reader.hpp"

#include "edgeproof/precision/error.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <charconv>

namespace edgeproof {
namespace {

std::vector<std::string> lines_of(std::string_view text) {
    std::vector<std::string> lines;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        lines.emplace_back(text.substr(0, end));
        if (end == std::string_view::npos) {
            break;
        }
        text.remove_prefix(end + 1);
    }
    return lines;
}

std::size_t significant_digits(std::string_view number) {
    std::size_t digits = 0;
    for (const char c : number) {
        if (c == 'e' || c == 'E') {
            break;
        }
        if (c >= '0' && c <= '9' && (digits > 0 || c != '0')) {
            ++digits;
        }
    }
    return digits;
}

} // namespace

struct TomlTable::Node {
    struct Source {
        toml::table root;
        std::vector<std::string> lines;
        std::string file;
    };

    std::shared_ptr<const Source> source;
    const toml::table* table;

    [[nodiscard]] const toml::node* find(std::string_view key) const { return table->get(key); }
    [[noreturn]] void reject(std::size_t line, const std::string& problem,
                             const std::string& instead) const {
        throw InputError(problem, instead).at(source->file, line);
    }
    /// Text of a scalar; numbers as they stand in the file.
    [[nodiscard]] std::string scalar(const toml::node& node, std::string_view key) const {
        if (const auto* s = node.as_string()) {
            return s->get();
        }
        if (const auto* i = node.as_integer()) {
            return std::to_string(i->get());
        }
        if (const auto* b = node.as_boolean()) {
            return b->get() ? "true" : "false";
        }
        if (node.is_floating_point()) {
            const auto& where = node.source();
            const std::string& line = source->lines.at(where.begin.line - 1);
            std::string text =
                line.substr(where.begin.column - 1, where.end.column - where.begin.column);
            std::erase(text, '_');
            if (significant_digits(text) > 15) {
                reject(where.begin.line, "the number " + text + " is written as a float",
                       "quote it: " + std::string(key) + " = \"" + text + "\"");
            }
            return text;
        }
        reject(node.source().begin.line, std::string(key) + " is neither text nor a number",
               "write " + std::string(key) + " = \"...\"");
    }
    [[nodiscard]] std::vector<std::string> list(const toml::node& node,
                                                std::string_view key) const {
        const auto* array = node.as_array();
        if (array == nullptr) {
            return {scalar(node, key)};
        }
        std::vector<std::string> texts;
        for (const toml::node& element : *array) {
            texts.push_back(scalar(element, key));
        }
        return texts;
    }
};

namespace {

std::vector<std::pair<std::string, const toml::node*>> in_file_order(const toml::table& table) {
    std::vector<std::pair<std::string, const toml::node*>> entries;
    for (const auto& [key, node] : table) {
        entries.emplace_back(std::string(key.str()), &node);
    }
    std::stable_sort(entries.begin(), entries.end(), [](const auto& x, const auto& y) {
        const auto& p = x.second->source().begin;
        const auto& q = y.second->source().begin;
        return p.line != q.line ? p.line < q.line : p.column < q.column;
    });
    return entries;
}

} // namespace

void TomlTable::allow(const std::vector<std::string_view>& keys) const {
    for (const auto& [key, node] : in_file_order(*node_->table)) {
        if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
            std::string known;
            for (const std::string_view k : keys) {
                known += (known.empty() ? "" : ", ") + std::string(k);
            }
            node_->reject(line(key), "unknown key '" + key + "'", "write one of " + known);
        }
    }
}

bool TomlTable::has(std::string_view key) const { return node_->find(key) != nullptr; }

std::vector<std::string> TomlTable::keys() const {
    std::vector<std::string> keys;
    for (const auto& [key, node] : in_file_order(*node_->table)) {
        keys.push_back(key);
    }
    return keys;
}

std::size_t TomlTable::line() const { return node_->table->source().begin.line; }

std::size_t TomlTable::line(std::string_view key) const {
    for (const auto& [name, node] : *node_->table) {
        if (name.str() == key) {
            return name.source().begin.line;
        }
    }
    return line();
}

std::string TomlTable::text(std::string_view key) const {
    const toml::node* node = node_->find(key);
    if (node == nullptr) {
        reject(key, "there is no " + std::string(key), "add " + std::string(key) + " = \"...\"");
    }
    return node_->scalar(*node, key);
}

std::string TomlTable::text_or(std::string_view key, std::string_view otherwise) const {
    return has(key) ? text(key) : std::string(otherwise);
}

std::vector<std::string> TomlTable::texts(std::string_view key) const {
    const toml::node* node = node_->find(key);
    if (node == nullptr) {
        reject(key, "there is no " + std::string(key), "add " + std::string(key) + " = [\"...\"]");
    }
    return node_->list(*node, key);
}

std::size_t TomlTable::count_in(std::string_view key, const std::string& text) const {
    std::size_t n = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
    if (error != std::errc{} || end != text.data() + text.size()) {
        reject(key, std::string(key) + " = " + text + " is no whole number",
               "write a number such as 12");
    }
    return n;
}

std::size_t TomlTable::count(std::string_view key, std::size_t least, std::size_t most) const {
    const std::size_t n = count_in(key, text(key));
    if (n < least || n > most) {
        reject(key, std::string(key) + " = " + std::to_string(n) + " is out of range",
               "write a number from " + std::to_string(least) + " to " + std::to_string(most));
    }
    return n;
}

TomlTable TomlTable::table(std::string_view key) const {
    const toml::node* node = node_->find(key);
    if (node == nullptr || !node->is_table()) {
        reject(key, "there is no table " + std::string(key), "add [" + std::string(key) + "]");
    }
    return TomlTable(std::make_shared<const Node>(Node{node_->source, node->as_table()}));
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) const {
    if (!has(key)) {
        reject(key, "there is no " + std::string(key), "add [[" + std::string(key) + "]]");
    }
    return tables_or_none(key);
}

std::vector<TomlTable> TomlTable::tables_or_none(std::string_view key) const {
    const toml::node* node = node_->find(key);
    std::vector<TomlTable> tables;
    if (node == nullptr) {
        return tables;
    }
    const auto* array = node->as_array();
    if (array == nullptr) {
        reject(key, std::string(key) + " is no array of tables",
               "write [[" + std::string(key) + "]]");
    }
    for (const toml::node& element : *array) {
        if (!element.is_table()) {
            reject(key, std::string(key) + " is no array of tables",
                   "write [[" + std::string(key) + "]]");
        }
        tables.push_back(
            TomlTable(std::make_shared<const Node>(Node{node_->source, element.as_table()})));
    }
    return tables;
}

Field TomlTable::field(std::string_view key) const {
    const toml::node& node = *node_->find(key);
    Field field;
    field.line = line(key);
    if (node.is_array()) {
        field.value = node_->list(node, key);
    } else if (const auto* table = node.as_table()) {
        Field::Table entries;
        for (const auto& [name, value] : in_file_order(*table)) {
            entries.emplace_back(name, node_->list(*value, name));
        }
        field.value = std::move(entries);
    } else {
        field.value = node_->scalar(node, key);
    }
    return field;
}

void TomlTable::reject(std::string_view key, const std::string& problem,
                       const std::string& instead) const {
    node_->reject(line(key), problem, instead);
}

const TomlTable& TomlDocument::top() const { return *top_; }

TomlDocument parse_toml(std::string_view text, const std::string& file) {
    auto source = std::make_shared<TomlTable::Node::Source>();
    source->file = file;
    source->lines = lines_of(text);
    try {
        source->root = toml::parse(text, file);
    } catch (const toml::parse_error& error) {
        throw InputError(std::string(error.description()), "write it as TOML")
            .at(file, error.source().begin.line);
    }
    TomlDocument document;
    document.top_ = std::make_shared<const TomlTable>(
        TomlTable(std::make_shared<const TomlTable::Node>(TomlTable::Node{source, &source->root})));
    return document;
}

} // namespace edgeproof
