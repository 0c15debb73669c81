// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/formula/exact/exact.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace edgeproof::io {

/// The value { from = "...", to = "..." }, with `points = N` for N > 0.
struct TomlRange {
    std::string from;
    std::string to;
    long points = 0;
};
/// A key of a table made in memory.
struct TomlEntry {
    std::string key;
    std::variant<std::string, std::vector<std::string>, bool, TomlRange> value;
    std::size_t line = 0; ///< the line in errors
};
struct TomlTable {
    std::string name; ///< "[[step]]": one of several tables with the name step
    std::size_t line = 0;
    std::vector<TomlEntry> entries;
};

/// A table of a TOML file, read strictly. Errors throw InputError with the file, the line, the
/// problem and what to write instead.
///
/// A number means exactly what is written: integers and floats are read from the text of the file,
/// never from a double. A float of more than 15 significant digits is refused with the hint to
/// quote it, since other readers of the file would cut it off.
class TomlSection {
public:
    /// Returns the top level of a file. `file` is the name in errors. Refuses a text beyond the
    /// limits of check_toml_limits(), and control characters other than tab and newline in a key or
    /// a text. `instead`: keys that replace or add to those of the file; an empty text removes a
    /// key.
    [[nodiscard]] static TomlSection parse(std::string_view text, const std::string& file,
                                           const std::vector<TomlTable>& instead = {});

    /// Returns the top level of a file with these tables; there is no text.
    [[nodiscard]] static TomlSection made(const std::vector<TomlTable>& tables,
                                          const std::string& file) {
        return parse("", file, tables);
    }

    /// The new text of a value of a section. `text` is the present one as written in the file; for
    /// a table in braces it is null. Returns nothing if the value stays as it is.
    using Change = std::function<std::optional<std::string>(
        std::string_view section, std::string_view key, const std::string* text)>;
    /// Returns the top level of a file like this one, with the same lines, in which values of the
    /// sections `names`, also those in lists, are changed. Other sections are left out.
    [[nodiscard]] TomlSection changed(const std::vector<std::string_view>& names,
                                      const Change& change) const;

    /// Refuses all other keys.
    void allow(const std::vector<std::string_view>& keys) const;
    /// The keys in the order of the file.
    [[nodiscard]] std::vector<std::string> keys() const;
    [[nodiscard]] bool has(std::string_view key) const;
    [[nodiscard]] bool is_table(std::string_view key) const;
    [[nodiscard]] bool is_list(std::string_view key) const;
    /// The line of the table's own header.
    [[nodiscard]] std::size_t line() const;
    /// The line of the key, or of the table if there is no such key.
    [[nodiscard]] std::size_t line(std::string_view key) const;
    [[nodiscard]] const std::string& file() const;

    [[nodiscard]] TomlSection section(std::string_view key) const;
    /// The tables of [[key]] headers, or of a list of inline tables.
    [[nodiscard]] std::vector<TomlSection> sections(std::string_view key) const;
    /// Like sections(); empty if there is no such key.
    [[nodiscard]] std::vector<TomlSection> sections_or_none(std::string_view key) const;
    /// Returns a quoted text.
    [[nodiscard]] std::string text(std::string_view key) const;
    [[nodiscard]] std::vector<std::string> texts(std::string_view key) const;
    /// Returns a quoted text, "true" or "false", or a number as written in the file.
    [[nodiscard]] std::string written(std::string_view key) const;
    [[nodiscard]] std::string written_or(std::string_view key, std::string_view otherwise) const;
    /// Returns a list of such texts; a single value is a list of one.
    [[nodiscard]] std::vector<std::string> written_list(std::string_view key) const;
    /// Returns an exact constant: quoted ("pi/16") or a number.
    [[nodiscard]] formula::Exact exact(std::string_view key) const;
    struct Item {
        formula::Exact value;
        std::size_t line;
    };
    /// Returns a list of exact constants; a single value is a list of one.
    [[nodiscard]] std::vector<Item> exacts(std::string_view key) const;
    /// The text of a constant, not evaluated.
    struct Written {
        std::string text;
        std::size_t line;
    };
    [[nodiscard]] std::vector<Written> numbers_written(std::string_view key) const;
    /// Returns a list of pairs of exact constants, such as [["0", "1/2"], [1, 2]].
    [[nodiscard]] std::vector<std::array<Item, 2>> pairs(std::string_view key) const;
    [[nodiscard]] std::vector<std::array<Written, 2>> pairs_written(std::string_view key) const;
    /// Returns whole numbers in least ... most; a single value is a list of one.
    [[nodiscard]] std::vector<std::size_t> counts(std::string_view key, long least,
                                                  long most) const;
    [[nodiscard]] std::size_t count(std::string_view key, long least, long most) const;
    [[nodiscard]] bool flag(std::string_view key) const;

    [[noreturn]] void reject(std::size_t at, const std::string& problem,
                             const std::string& instead) const;
    [[noreturn]] void reject(std::string_view key, const std::string& problem,
                             const std::string& instead) const;
    /// Rejects the value of a key, or one at a line, if a requirement on it does not hold.
    void require(bool holds, const auto& where, const std::string& problem,
                 const std::string& instead) const {
        if (!holds) {
            reject(where, problem, instead);
        }
    }

private:
    struct Source;
    struct Access;
    TomlSection(std::shared_ptr<const Source> source, const void* table)
        : source_(std::move(source)), table_(table) {}
    std::shared_ptr<const Source> source_;
    const void* table_; ///< toml::table; toml++ is not included in this header
};

} // namespace edgeproof::io
