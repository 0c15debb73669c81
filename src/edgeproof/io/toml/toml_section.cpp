// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/io/toml/toml_source.hpp"
#include "edgeproof/io/toml/toml_text.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"

#include <algorithm>
#include <charconv>
#include <functional>
#include <utility>

namespace edgeproof::io {
namespace {

constexpr std::size_t most_float_digits = 15;

} // namespace

/// Functions that need types of toml++.
struct TomlSection::Access {
    const TomlSection& self;

    [[nodiscard]] const toml::table& table() const {
        return *static_cast<const toml::table*>(self.table_);
    }
    [[nodiscard]] const toml::node& node(std::string_view key) const {
        const toml::node* found = table().get(key);
        self.require(found != nullptr, self.line(), "there is no " + std::string(key),
                     "add " + std::string(key) + " = \"...\"");
        return *found;
    }
    [[nodiscard]] std::size_t line_of(const toml::node& n) const {
        return self.source_->line_of(n);
    }

    /// Returns the text of the float in the file. It must read as the double that toml++ made of
    /// it: otherwise the position in the line was wrong, and no number is better than a wrong one.
    [[nodiscard]] std::string float_text(const toml::node& n, std::string_view key) const {
        const std::string& line = self.source_->lines.at(line_of(n) - 1);
        const std::size_t from = byte_of_column(line, n.source().begin.column);
        std::size_t to = from;
        while (to < line.size() && is_number_character(line[to])) {
            ++to;
        }
        std::string text = line.substr(from, to - from);
        std::erase(text, '_');
        if (!text.empty() && text.front() == '+') {
            text.erase(0, 1);
        }
        const double read = n.as_floating_point()->get();
        self.require(read - read == 0, line_of(n), std::string(key) + " is not a finite number",
                     "write a finite number, or a quoted expression");
        double again = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), again);
        if (end != text.data() + text.size() || text.empty() ||
            (error == std::errc{} && again != read)) {
            self.reject(line_of(n), std::string(key) + " is a number that cannot be read exactly",
                        "quote it: \"...\"");
        }
        self.require(significant_digits(text) <= most_float_digits, line_of(n),
                     std::string(key) + " = " + text +
                         " has more than 15 significant digits as a float",
                     "quote it: \"" + text + "\"");
        return text;
    }
    [[nodiscard]] std::string scalar(const toml::node& n, std::string_view key) const {
        if (const auto* s = n.as_string()) {
            return s->get();
        }
        if (const auto* i = n.as_integer()) {
            return std::to_string(i->get());
        }
        self.require(n.is_floating_point(), line_of(n), std::string(key) + " is not a number",
                     "write a number or a quoted expression such as \"3/2\"");
        return float_text(n, key);
    }
    [[nodiscard]] std::string written(const toml::node& n, std::string_view key) const {
        if (const auto* b = n.as_boolean()) {
            return b->get() ? "true" : "false";
        }
        return scalar(n, key);
    }
    [[nodiscard]] std::vector<TomlSection> tables(const toml::node& n, std::string_view key) const {
        std::vector<TomlSection> list;
        const auto* array = n.as_array();
        if (array == nullptr || !std::all_of(array->begin(), array->end(),
                                             [](const toml::node& e) { return e.is_table(); })) {
            self.reject(key, std::string(key) + " is no list of sections",
                        "write [[" + std::string(key) + "]]");
        }
        for (const toml::node& element : *array) {
            list.push_back({self.source_, element.as_table()});
        }
        return list;
    }
    [[nodiscard]] formula::Exact exact(const toml::node& n, std::string_view key) const {
        const std::string text = scalar(n, key);
        try {
            return formula::Exact::parse(text);
        } catch (const InputError& error) {
            throw InputError(std::string(key) + " = \"" + text + "\": " + error.problem(),
                             error.instead())
                .at(self.source_->file, line_of(n));
        }
    }
    [[nodiscard]] std::string text(const toml::node& n, std::string_view key) const {
        const auto* s = n.as_string();
        self.require(s != nullptr, line_of(n), std::string(key) + " is not a quoted text",
                     "write " + std::string(key) + " = \"...\"");
        return s->get();
    }
    [[nodiscard]] std::size_t count(const toml::node& n, std::string_view key, long least,
                                    long most) const {
        const std::string range =
            "write a whole number from " + std::to_string(least) + " to " + std::to_string(most);
        std::string text;
        if (const auto* i = n.as_integer()) {
            text = std::to_string(i->get());
        } else if (const auto* s = n.as_string()) {
            text = s->get();
        } else {
            self.reject(line_of(n), std::string(key) + " is not a whole number", range);
        }
        const auto value = read_whole<long>(text);
        self.require(value && *value >= least && *value <= most, line_of(n),
                     std::string(key) + " = " + text + " is out of range", range);
        return static_cast<std::size_t>(*value);
    }
    /// Returns read(x, key) for both elements x of each pair in a list.
    template <class Read> [[nodiscard]] auto pairs(std::string_view key, const Read& read) const {
        const toml::array* list = node(key).as_array();
        const auto is_pair = [](const toml::node& n) {
            return n.is_array() && n.as_array()->size() == 2;
        };
        self.require(list != nullptr && !list->empty() &&
                         std::all_of(list->begin(), list->end(), is_pair),
                     key, std::string(key) + " is no list of pairs",
                     "write " + std::string(key) + " = [[\"0\", \"1/2\"], [\"1\", \"2\"]]");
        std::vector<std::array<decltype(std::invoke(read, *this, node(key), key)), 2>> pairs;
        for (const toml::node& n : *list) {
            pairs.push_back({std::invoke(read, *this, *n.as_array()->get(0), key),
                             std::invoke(read, *this, *n.as_array()->get(1), key)});
        }
        return pairs;
    }
    [[nodiscard]] Item item(const toml::node& n, std::string_view key) const {
        return {exact(n, key), line_of(n)};
    }
    [[nodiscard]] Written written_item(const toml::node& n, std::string_view key) const {
        return {scalar(n, key), line_of(n)};
    }
    /// Returns read(x, key) for the elements x of a list, or for a single value.
    template <class Read> [[nodiscard]] auto list(std::string_view key, const Read& read) const {
        const toml::node& n = node(key);
        std::vector<decltype(std::invoke(read, *this, n, key))> list;
        if (const auto* array = n.as_array()) {
            for (const toml::node& element : *array) {
                list.push_back(std::invoke(read, *this, element, key));
            }
        } else {
            list.push_back(std::invoke(read, *this, n, key));
        }
        return list;
    }
};

TomlSection TomlSection::changed(const std::vector<std::string_view>& names,
                                 const Change& change) const {
    std::vector<TomlTable> tables;
    for (const std::string_view name : names) {
        if (!has(name)) {
            continue;
        }
        const TomlSection from = section(name);
        TomlTable to{std::string(name), from.line(), {}};
        for (const std::string& key : from.keys()) {
            const auto text_of = [&](const std::string& text) {
                return change(name, key, &text).value_or(text);
            };
            TomlEntry entry{key, {}, from.line(key)};
            const toml::node& value = Access{from}.node(key);
            if (value.is_table()) {
                if (auto text = change(name, key, nullptr)) {
                    entry.value = std::move(*text);
                    to.entries.push_back(std::move(entry));
                }
                continue;
            }
            if (const auto* flag = value.as_boolean()) {
                entry.value = flag->get();
            } else if (value.is_array()) {
                std::vector<std::string> list;
                for (const std::string& text : from.written_list(key)) {
                    list.push_back(text_of(text));
                }
                entry.value = std::move(list);
            } else {
                entry.value = text_of(from.written(key));
            }
            to.entries.push_back(std::move(entry));
        }
        tables.push_back(std::move(to));
    }
    return made(tables, file());
}

void TomlSection::allow(const std::vector<std::string_view>& keys) const {
    // Finds the unknown key that comes first in the file.
    const toml::key* unknown = nullptr;
    for (const auto& [key, node] : Access{*this}.table()) {
        const bool known = std::find(keys.begin(), keys.end(), key.str()) != keys.end();
        if (!known &&
            (unknown == nullptr || key.source().begin.line < unknown->source().begin.line)) {
            unknown = &key;
        }
    }
    if (unknown != nullptr) {
        reject(unknown->source().begin.line, "unknown key '" + std::string(unknown->str()) + "'",
               one_of(unknown->str(), keys));
    }
}

std::vector<std::string> TomlSection::keys() const {
    std::vector<std::pair<std::pair<std::size_t, std::size_t>, std::string>> placed;
    for (const auto& [key, node] : Access{*this}.table()) {
        const auto& at = key.source().begin;
        placed.push_back({{at.line, at.column}, std::string(key.str())});
    }
    std::sort(placed.begin(), placed.end());
    std::vector<std::string> list;
    list.reserve(placed.size());
    for (auto& [at, key] : placed) {
        list.push_back(std::move(key));
    }
    return list;
}
bool TomlSection::has(std::string_view key) const { return Access{*this}.table().contains(key); }
bool TomlSection::is_table(std::string_view key) const {
    return has(key) && Access{*this}.node(key).is_table();
}
bool TomlSection::is_list(std::string_view key) const {
    return has(key) && Access{*this}.node(key).is_array();
}
std::size_t TomlSection::line() const {
    const Access access{*this};
    return access.line_of(access.table());
}
std::size_t TomlSection::line(std::string_view key) const {
    const toml::table& table = Access{*this}.table();
    const auto found = table.find(key);
    return found == table.end() ? line() : found->first.source().begin.line;
}
const std::string& TomlSection::file() const { return source_->file; }

TomlSection TomlSection::section(std::string_view key) const {
    const Access access{*this};
    const toml::node* found = access.table().get(key);
    if (found == nullptr) {
        reject(line(), "there is no section [" + std::string(key) + "]",
               "add [" + std::string(key) + "]");
    }
    if (!found->is_table()) {
        reject(key, std::string(key) + " is not a section", "write [" + std::string(key) + "]");
    }
    return {source_, found->as_table()};
}
std::vector<TomlSection> TomlSection::sections(std::string_view key) const {
    if (!has(key)) {
        reject(line(), "there is no [[" + std::string(key) + "]]",
               "add [[" + std::string(key) + "]]");
    }
    return sections_or_none(key);
}
std::vector<TomlSection> TomlSection::sections_or_none(std::string_view key) const {
    const Access access{*this};
    const toml::node* found = access.table().get(key);
    return found == nullptr ? std::vector<TomlSection>{} : access.tables(*found, key);
}
std::string TomlSection::text(std::string_view key) const {
    const Access access{*this};
    return access.text(access.node(key), key);
}
std::vector<std::string> TomlSection::texts(std::string_view key) const {
    return Access{*this}.list(key, &Access::text);
}
std::string TomlSection::written(std::string_view key) const {
    const Access access{*this};
    return access.written(access.node(key), key);
}
std::string TomlSection::written_or(std::string_view key, std::string_view otherwise) const {
    return has(key) ? written(key) : std::string(otherwise);
}
std::vector<std::string> TomlSection::written_list(std::string_view key) const {
    return Access{*this}.list(key, &Access::written);
}
formula::Exact TomlSection::exact(std::string_view key) const {
    const Access access{*this};
    return access.exact(access.node(key), key);
}
std::vector<TomlSection::Item> TomlSection::exacts(std::string_view key) const {
    return Access{*this}.list(key, &Access::item);
}
std::vector<TomlSection::Written> TomlSection::numbers_written(std::string_view key) const {
    return Access{*this}.list(key, &Access::written_item);
}
std::vector<std::array<TomlSection::Item, 2>> TomlSection::pairs(std::string_view key) const {
    return Access{*this}.pairs(key, &Access::item);
}
std::vector<std::array<TomlSection::Written, 2>>
TomlSection::pairs_written(std::string_view key) const {
    return Access{*this}.pairs(key, &Access::written_item);
}
std::vector<std::size_t> TomlSection::counts(std::string_view key, long least, long most) const {
    return Access{*this}.list(key, [&](const Access& access, const toml::node& n, auto name) {
        return access.count(n, name, least, most);
    });
}
std::size_t TomlSection::count(std::string_view key, long least, long most) const {
    const Access access{*this};
    return access.count(access.node(key), key, least, most);
}
bool TomlSection::flag(std::string_view key) const {
    const Access access{*this};
    const toml::node& n = access.node(key);
    const auto* b = n.as_boolean();
    if (b == nullptr) {
        reject(key, std::string(key) + " is neither true nor false",
               "write " + std::string(key) + " = true");
    }
    return b->get();
}

void TomlSection::reject(std::size_t at, const std::string& problem,
                         const std::string& instead) const {
    throw InputError(problem, instead).at(source_->file, at);
}
void TomlSection::reject(std::string_view key, const std::string& problem,
                         const std::string& instead) const {
    reject(line(key), problem, instead);
}

} // namespace edgeproof::io
