// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/scene_options.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace edgeproof::cli {

void refuse_whole_tolerance(const std::string& option, const std::string& text) {
    if (text.empty() || text.back() == '%' ||
        text.find_first_not_of("0123456789.") != std::string::npos) {
        return;
    }
    const Rational given = parse_decimal(text);
    if (given >= 1) {
        throw InputError(option + " " + text + " is " + exact_text(Rational(given * 100)) + " %",
                         "write " + text + "% or " + exact_text(Rational(given / 100)));
    }
}

std::vector<std::string> parts_of(const std::string& text) {
    std::vector<std::string> parts;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t comma = std::min(text.find(',', at), text.size());
        parts.push_back(text.substr(at, comma - at));
        at = comma + 1;
    }
    return parts;
}

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
