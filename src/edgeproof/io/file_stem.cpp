// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/io/file_stem.hpp"

#include "edgeproof/io/sha256.hpp"

#include <algorithm>

namespace edgeproof::io {
namespace {

constexpr std::size_t hash_digits = 16;

bool is_file_name_character(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' ||
           c == '_' || c == '.';
}

bool begins_well(std::string_view name) {
    return !name.empty() && name.front() != '.' && name.front() != '-';
}

/// True for a text that ends like "-0123456789abcdef", the form of a changed name. Such an id is
/// changed, too, so that no id equals the name of another one.
bool ends_as_changed(std::string_view id) {
    if (id.size() <= hash_digits || id[id.size() - hash_digits - 1] != '-') {
        return false;
    }
    const std::string_view end = id.substr(id.size() - hash_digits);
    return end.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

} // namespace

FileStem::FileStem(std::string_view id) : text_(id) {
    if (id.size() <= most_bytes && begins_well(id) && !ends_as_changed(id) &&
        std::ranges::all_of(id, is_file_name_character)) {
        return;
    }
    text_.resize(std::min(text_.size(), most_bytes - hash_digits - 1));
    std::ranges::replace_if(
        text_, [](char c) { return !is_file_name_character(c); }, '-');
    if (!text_.empty() && !begins_well(text_)) {
        text_.front() = '_';
    }
    text_ = (text_.empty() ? "_" : text_) + '-' + sha256(id).substr(0, hash_digits);
}

} // namespace edgeproof::io
