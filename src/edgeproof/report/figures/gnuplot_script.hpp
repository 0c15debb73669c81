// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <fmt/format.h>

#include <concepts>
#include <string>
#include <string_view>
#include <type_traits>

namespace edgeproof::report {

/// A text as a single-quoted string of gnuplot. gnuplot executes nothing in such a string: neither
/// commands in backquotes, nor macros, nor escapes. Quotes and backquotes become typographic ones,
/// line breaks become spaces, control characters become `\x1b` and so on, and the middle of a long
/// text is left out. (Commands that use the string turn off the markup of enhanced text by
/// `noenhanced`.)
class GnuplotText {
public:
    explicit GnuplotText(std::string_view text);
    [[nodiscard]] const std::string& quoted() const noexcept { return quoted_; }

private:
    std::string quoted_;
};

/// A decimal number as text. Throws Error for any other text.
class GnuplotNumber {
public:
    explicit GnuplotNumber(std::string_view number);
    [[nodiscard]] const std::string& text() const noexcept { return text_; }

private:
    std::string text_;
};

/// One or more words of gnuplot's language, fixed at compile time.
class GnuplotWords {
public:
    explicit consteval GnuplotWords(const char* words) : words_(words) {}
    [[nodiscard]] const char* text() const noexcept { return words_; }

private:
    const char* words_;
};

/// The types that may be inserted into a command. std::string is not one of them, so that input
/// text can reach gnuplot only as a GnuplotText.
template <class T>
concept GnuplotValue = std::integral<T> || std::floating_point<T> || std::same_as<T, GnuplotText> ||
    std::same_as<T, GnuplotNumber> || std::same_as<T, GnuplotWords>;

/// A script for gnuplot: commands fixed at compile time, with inserted values.
class GnuplotScript {
public:
    template <class... Values>
    requires(GnuplotValue<std::remove_cvref_t<Values>>&&...) void add(
        fmt::format_string<Values...> commands, Values&&... values) {
        text_ += fmt::vformat(commands, fmt::make_format_args(values...));
    }
    [[nodiscard]] const std::string& text() const noexcept { return text_; }

private:
    std::string text_;
};

} // namespace edgeproof::report

template <>
struct fmt::formatter<edgeproof::report::GnuplotText> : fmt::formatter<std::string_view> {
    template <class Context>
    auto format(const edgeproof::report::GnuplotText& value, Context& context) const {
        return fmt::formatter<std::string_view>::format(value.quoted(), context);
    }
};
template <>
struct fmt::formatter<edgeproof::report::GnuplotNumber> : fmt::formatter<std::string_view> {
    template <class Context>
    auto format(const edgeproof::report::GnuplotNumber& value, Context& context) const {
        return fmt::formatter<std::string_view>::format(value.text(), context);
    }
};
template <>
struct fmt::formatter<edgeproof::report::GnuplotWords> : fmt::formatter<std::string_view> {
    template <class Context>
    auto format(const edgeproof::report::GnuplotWords& value, Context& context) const {
        return fmt::formatter<std::string_view>::format(value.text(), context);
    }
};
