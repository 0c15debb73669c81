// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/scene_options.hpp"

#include "edgeproof/precision/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace edgeproof::cli {

std::size_t whole_number(const std::string& option, const std::string& text, std::size_t least,
                         std::size_t most) {
    std::size_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || stop != end || value < least || value > most) {
        throw InputError(option + " " + text + " is out of range",
                         fmt::format("give a whole number from {} to {}", least, most));
    }
    return value;
}

unsigned digits_of(const std::string& text, std::size_t most) {
    return static_cast<unsigned>(whole_number("--digits", text, 2, most));
}

unsigned threads_of(const std::string& text) {
    return text.empty() ? 0
                        : static_cast<unsigned>(whole_number("--threads", text, 0, most_threads));
}

report::TableFormat format_of(const std::string& name) {
    const auto format = report::table_format(name.empty() ? "csv" : name);
    if (!format) {
        throw InputError("--format " + name + " is no format", "write csv, json, md, tex or text");
    }
    return *format;
}

bool text_or_json(const std::string& format) {
    if (!format.empty() && format != "text" && format != "json") {
        throw InputError("--format " + format + " is no format", "write text or json");
    }
    return format == "json";
}

} // namespace edgeproof::cli
