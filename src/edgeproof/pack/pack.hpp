// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgeproof::pack {

/// A frozen set of questions and correctly rounded answers, with which a contact code can be tested
/// without this program: tables, and drivers in C, C++, Fortran, Python and Octave.
struct PackFile {
    std::string name;
    std::string text;
};

/// The number of the set; it changes with any question or tolerance.
inline constexpr int pack_version = 1;

struct PackOptions {
    unsigned threads = 0; ///< 0: as many as the machine has
    std::function<void(std::size_t, std::size_t)> progress = {};
};

/// Returns all files but the manifest, in their order; identical in every byte on any number of
/// threads. Throws Interrupted.
[[nodiscard]] std::vector<PackFile> make_pack(const PackOptions& options);

/// MANIFEST: the origin of the pack, and the SHA-256 of each file as `sha256sum -c` reads it.
struct Origin {
    std::string program; ///< "edgeproof 0.2.0"
    std::string commit;
    std::string date; ///< the day, ISO 8601
    std::string command;
};
[[nodiscard]] std::string manifest(const std::vector<PackFile>& files, const Origin& origin);
inline constexpr const char* manifest_name = "MANIFEST";

/// The rows of a table: questions rounded to binary64, with their answers. Answers without a proved
/// value whose rounding is decided, zero answers, and answers of unknown conditioning are left out.
struct PackRows {
    std::size_t left_out = 0;
    std::size_t rows = 0;
    std::string text; ///< CSV, without a header
};
[[nodiscard]] std::string pack_columns();
/// `with_scale`: each row has the largest exact pressure (the mean one, if that is infinite).
[[nodiscard]] PackRows recipe_rows(std::string_view recipe, const std::string& file,
                                   bool with_scale, const PackOptions& options);
/// Returns the hard cases that are pressures, tractions, coefficients, loads and left edges of
/// contacts that the columns can describe, each with its reason in a comment above.
[[nodiscard]] PackRows hard_case_rows(std::string_view cases, const std::string& file,
                                      const PackOptions& options);

/// The names and texts of pack.toml, level-a.toml, hard-cases.toml, and the files of the pack that
/// are not tables, when the program was built.
extern const std::span<const std::pair<std::string_view, std::string_view>> shipped_files;

} // namespace edgeproof::pack
