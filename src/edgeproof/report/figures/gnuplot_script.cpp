// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/figures/gnuplot_script.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"

#include <regex>

namespace edgeproof::report {
namespace {

constexpr std::size_t longest_gnuplot_text = 300;
constexpr std::size_t longest_gnuplot_number = 400;

} // namespace

GnuplotText::GnuplotText(std::string_view text) {
    quoted_ = '\'';
    for (const char c : printable(shortened(text, longest_gnuplot_text))) {
        // gnuplot 5.4 does not accept a doubled quote at the beginning of a string.
        quoted_ += c == '\'' ? "’" : c == '`' ? "‘" : std::string(1, c);
    }
    quoted_ += '\'';
}

GnuplotNumber::GnuplotNumber(std::string_view number) : text_(number) {
    static const std::regex form(R"([+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?)");
    if (number.size() > longest_gnuplot_number || !std::regex_match(text_, form)) {
        throw Error("'" + printable(shortened(number, 40)) + "' is no number for gnuplot");
    }
}

} // namespace edgeproof::report
