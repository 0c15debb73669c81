// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <concepts>
#include <string>
#include <string_view>

namespace edgeproof::io {

/// The name, without extension, of a file made for an id of the input. The name always stays in its
/// folder: only letters, digits, '-', '_' and '.', no '.' or '-' in front, and at most `most_bytes`
/// bytes. An id of this form is its own name. Any other id is changed to this form and ends with
/// '-' and 16 hexadecimal digits of its SHA-256, so that different ids have different names.
class FileStem {
public:
    static constexpr std::size_t most_bytes = 120;

    FileStem() : FileStem(std::string_view("unnamed")) {}
    template <std::convertible_to<std::string_view> Text>
    FileStem(const Text& id) // NOLINT(google-explicit-constructor): safe for every text
        : FileStem(std::string_view(id)) {}
    FileStem(std::string_view id); // NOLINT(google-explicit-constructor)

    [[nodiscard]] const std::string& text() const noexcept { return text_; }
    /// Returns, for example, "ID.svg".
    [[nodiscard]] std::string with(std::string_view ending) const {
        return text_ + std::string(ending);
    }
    friend bool operator==(const FileStem&, const FileStem&) = default;

private:
    std::string text_;
};

} // namespace edgeproof::io
