// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/cli.hpp"

#include <regex>
#include <string>
#include <utility>

namespace edgeproof::cli {
namespace {

/// Returns the name of the option for a key of a scene's file.
std::string option_of(std::string key) {
    for (char& c : key) {
        c = c == '_' ? '-' : c;
    }
    return "--" + key;
}

/// Replaces each match by what `written` makes of it.
template <class Written>
std::string replaced(const std::string& text, const std::regex& pattern, const Written& written) {
    std::string out;
    auto from = text.cbegin();
    for (std::sregex_iterator i(text.begin(), text.end(), pattern), end; i != end; ++i) {
        out.append(from, text.cbegin() + i->position());
        out += written(*i);
        from = text.cbegin() + i->position() + i->length();
    }
    return out.append(from, text.cend());
}

/// Returns a list of quoted numbers as separate words.
std::string words_of_list(const std::string& list) {
    return std::regex_replace(std::regex_replace(list, std::regex("\""), ""), std::regex(","), "");
}

std::string advice_for_options(const std::string& advice) {
    static const std::string long_key =
        "contact_modulus|bulk_tension|bulk_A|process_zone|flat_width|E1|E2|nu1|nu2|R1|R2";
    static const std::string word =
        long_key + "|geometry|m|C|R|t|phi|alpha|width|P|M|delta|nu|Q|friction|path|u|x|terms|"
                   "tolerance|digits|edges|quantities";
    static const std::string key = "(kind|a|points|" + word + ")";
    // [shear] as a whole stands for its options.
    std::string text = std::regex_replace(advice, std::regex("add \\[shear\\] with "), "add ");
    text = std::regex_replace(text, std::regex("leave \\[shear\\] out"),
                              "leave --Q, --bulk-tension and --friction out");
    text =
        std::regex_replace(text, std::regex(" (to|in|out of) \\[(profile|load|shear|ask)\\]"), "");
    // KEY = "VALUE", KEY = ["VALUE", ...], KEY = NUMBER
    const auto with_value = [](const std::smatch& match) {
        const std::string name = match[1];
        const std::string value = words_of_list(match[2]);
        const std::string option = name == "edges"        ? "edge"
                                   : name == "quantities" ? "quantity"
                                                          : name;
        return name == "kind" ? "--" + value : option_of(option) + " " + value;
    };
    text = replaced(text, std::regex("\\b" + key + " = \\[([^\\]\\[]*)\\]"), with_value);
    text = replaced(text, std::regex("\\b" + key + " = (\"[^\"]*\"|[0-9]+)"), with_value);
    // A key by its name alone: where no word of English is spelled in that way; else after a verb,
    // or in a list after an option. The name a is not the article.
    const auto alone = [](const std::smatch& match) {
        return std::string(match[1]) + option_of(match[2]);
    };
    text =
        replaced(text, std::regex("(^|[^A-Za-z0-9_-])(" + long_key + ")(?![A-Za-z0-9_])"), alone);
    static const std::regex listed("(\\b(?:add|give|leave|addition to|give one of) |"
                                   "--[A-Za-z0-9-]+(?: \\.\\.\\.)?(?:,|, or| or| and| with) )"
                                   "(a(?=$|,| >| and | or | \\()|(?:" +
                                   word + ")(?![A-Za-z0-9_-]))");
    for (std::string before; before != text;) {
        before = text;
        text = replaced(text, listed, alone);
    }
    // Two equal bodies have options of their own, which a scene's file has not.
    return std::regex_replace(text, std::regex(", or --E1, --nu1, --E2 and --nu2$"),
                              ", or --E and --nu of two equal bodies, or --E1, --nu1, --E2 and "
                              "--nu2");
}

} // namespace

InputError error_for_options(const InputError& error) {
    const InputError changed(
        std::regex_replace(error.problem(), std::regex("\\[shear\\]"), "shear load"),
        advice_for_options(error.instead()));
    return error.file().empty() ? changed : changed.at(error.file(), error.line());
}

} // namespace edgeproof::cli
