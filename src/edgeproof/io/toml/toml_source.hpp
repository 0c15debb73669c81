// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/io/toml/toml_section.hpp"

#include <toml++/toml.h>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace edgeproof::io {

/// The tree of a file, and the lines of its nodes. Only for the files of this folder: other files
/// do not include toml++.
struct TomlSection::Source {
    toml::table root;
    std::vector<std::string> lines;
    std::string file;
    std::map<const toml::node*, std::size_t> made; ///< lines of nodes that were not parsed

    [[nodiscard]] std::size_t line_of(const toml::node& n) const {
        const auto found = made.find(&n);
        return found == made.end() ? n.source().begin.line : found->second;
    }
    /// Adds a table that is not parsed, or its entries to the table of that name.
    void add(const TomlTable& table);
};

} // namespace edgeproof::io
