// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/exact/exact.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace edgeproof::io {

/// A key of a table that is made in memory.
struct TomlEntry {
    std::string key;
    std::variant<std::string, std::vector<std::string>, bool> value;
    std::size_t line = 0; ///< that errors name
};
/// Such a table.
struct TomlTable {
    std::string name;
    std::size_t line = 0;
    std::vector<TomlEntry> entries;
};

/// A table of a TOML file, read strictly. Whatever is not as it should be throws InputError with
/// the file, the line, what is wrong and what to write instead.
///
/// A number means exactly what is written: integers and floats are taken from the text of the
/// file, never from a double. A float of more than 15 significant digits is refused with the hint
/// to quote it, since other readers of the file would cut it off.
class TomlSection {
public:
    /// The top of a file. `file` is what errors name. Also refused: a text beyond the limits of
    /// toml_limits.hpp, and control characters other than tab and newline in a key or a text.
    [[nodiscard]] static TomlSection parse(std::string_view text, const std::string& file);

    /// The top of a file that holds these tables, without the text of one.
    [[nodiscard]] static TomlSection made(const std::vector<TomlTable>& tables,
                                          const std::string& file);

    /// Refuses any other key.
    void allow(const std::vector<std::string_view>& keys) const;
    /// In the order of the file.
    [[nodiscard]] std::vector<std::string> keys() const;
    [[nodiscard]] bool has(std::string_view key) const;
    [[nodiscard]] bool is_table(std::string_view key) const;
    [[nodiscard]] bool is_list(std::string_view key) const;
    /// Of the table's own header.
    [[nodiscard]] std::size_t line() const;
    /// Of the key, or of the table where there is no such key.
    [[nodiscard]] std::size_t line(std::string_view key) const;
    [[nodiscard]] const std::string& file() const;

    [[nodiscard]] TomlSection section(std::string_view key) const;
    /// The tables of [[key]] headers, or of a list of inline tables.
    [[nodiscard]] std::vector<TomlSection> sections(std::string_view key) const;
    /// None where there is no such key.
    [[nodiscard]] std::vector<TomlSection> sections_or_none(std::string_view key) const;
    /// A quoted text.
    [[nodiscard]] std::string text(std::string_view key) const;
    [[nodiscard]] std::vector<std::string> texts(std::string_view key) const;
    /// A quoted text, true or false, or a number as it stands in the file.
    [[nodiscard]] std::string written(std::string_view key) const;
    [[nodiscard]] std::string written_or(std::string_view key, std::string_view otherwise) const;
    /// A list of such; one alone is a list of one.
    [[nodiscard]] std::vector<std::string> written_list(std::string_view key) const;
    /// An exact constant: quoted ("pi/16") or a number.
    [[nodiscard]] formula::Exact exact(std::string_view key) const;
    /// One of a list, with the line that it stands on.
    struct Item {
        formula::Exact value;
        std::size_t line;
    };
    /// A list of exact constants; one alone is a list of one.
    [[nodiscard]] std::vector<Item> exacts(std::string_view key) const;
    /// The same as they are written, not read yet.
    struct Written {
        std::string text;
        std::size_t line;
    };
    [[nodiscard]] std::vector<Written> numbers_written(std::string_view key) const;
    /// Whole numbers in least ... most; one alone is a list of one.
    [[nodiscard]] std::vector<std::size_t> counts(std::string_view key, long least,
                                                  long most) const;
    [[nodiscard]] std::size_t count(std::string_view key, long least, long most) const;
    [[nodiscard]] bool flag(std::string_view key) const;

    [[noreturn]] void reject(std::size_t at, const std::string& problem,
                             const std::string& instead) const;
    [[noreturn]] void reject(std::string_view key, const std::string& problem,
                             const std::string& instead) const;

private:
    struct Source;
    struct Access;
    TomlSection(std::shared_ptr<const Source> source, const void* table)
        : source_(std::move(source)), table_(table) {}
    std::shared_ptr<const Source> source_;
    const void* table_; ///< toml::table; toml++ stays out of this header
};

} // namespace edgeproof::io
