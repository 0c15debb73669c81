// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/claim.hpp"

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof {

class TomlDocument;

/// A table of a TOML file, read strictly: every reader throws InputError with the file and the
/// line. A number in a file is text: integers and floats come out as they were written, and a
/// float of more than 15 significant digits is refused with the hint to quote it.
class TomlTable {
public:
    /// Throws for the first key (in the order of the file) that is not among these.
    void allow(const std::vector<std::string_view>& keys) const;
    [[nodiscard]] bool has(std::string_view key) const;
    /// In the order of the file.
    [[nodiscard]] std::vector<std::string> keys() const;
    [[nodiscard]] std::size_t line() const;
    [[nodiscard]] std::size_t line(std::string_view key) const;

    [[nodiscard]] std::string text(std::string_view key) const;
    [[nodiscard]] std::string text_or(std::string_view key, std::string_view otherwise) const;
    /// A list; one text alone is a list of one.
    [[nodiscard]] std::vector<std::string> texts(std::string_view key) const;
    [[nodiscard]] std::size_t count(std::string_view key, std::size_t least,
                                    std::size_t most) const;
    [[nodiscard]] std::size_t count_in(std::string_view key, const std::string& text) const;
    [[nodiscard]] TomlTable table(std::string_view key) const;
    /// An array of tables.
    [[nodiscard]] std::vector<TomlTable> tables(std::string_view key) const;
    [[nodiscard]] std::vector<TomlTable> tables_or_none(std::string_view key) const;
    [[nodiscard]] Field field(std::string_view key) const;

    [[noreturn]] void reject(std::string_view key, const std::string& problem,
                             const std::string& instead) const;

private:
    friend TomlDocument parse_toml(std::string_view text, const std::string& file);
    struct Node;
    explicit TomlTable(std::shared_ptr<const Node> node) : node_(std::move(node)) {}
    std::shared_ptr<const Node> node_;
};

/// A TOML file, parsed.
class TomlDocument {
public:
    TomlDocument() = default;
    [[nodiscard]] const TomlTable& top() const;

private:
    friend TomlDocument parse_toml(std::string_view text, const std::string& file);
    std::shared_ptr<const TomlTable> top_;
};

/// Throws InputError for text that is not TOML.
[[nodiscard]] TomlDocument parse_toml(std::string_view text, const std::string& file);

} // namespace edgeproof
