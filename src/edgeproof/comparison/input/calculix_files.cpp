// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/input/result_lines.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace edgeproof::comparison {
namespace {

constexpr std::string_view white_space = " \t\r";
constexpr std::string_view printed_title = "contact stress (slave ";

/// An .frd file in text: lines of fixed columns, one for a node.
class FrdReader {
public:
    FrdReader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

    CalculixContents read() {
        while (next_line()) {
            if (line_.starts_with("    2C")) {
                read_block(contents_.places, {0, 1, 2});
            } else if (line_.starts_with("  100C")) {
                read_result();
            }
        }
        return std::move(contents_);
    }

private:
    bool next_line() {
        if (at_ >= text_.size()) {
            return false;
        }
        if (++number_ % 4096 == 0) {
            check_interruption();
        }
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        line_ = text_.substr(at_, end - at_);
        at_ = end + 1;
        return true;
    }
    [[noreturn]] void reject(const std::string& problem, const std::string& instead) const {
        throw InputError(problem, instead).at(file_, number_);
    }
    /// A part of the line, without white space; empty beyond its end.
    [[nodiscard]] std::string cell(std::size_t from, std::size_t size) const {
        return from < line_.size() ? std::string(trimmed(line_.substr(from, size), white_space))
                                   : std::string();
    }
    /// Returns the width of the number of a node from the format in the head of a block.
    std::size_t node_width() {
        const std::size_t last = line_.find_last_not_of(white_space);
        const std::string format = last == std::string_view::npos ? "" : cell(last, 1);
        if (format != "0" && format != "1") {
            reject("the file is not an .frd file in text",
                   "let CalculiX write it in text (no OUTPUT=BINARY)");
        }
        return format == "0" ? 5 : 10;
    }
    void read_result() {
        const std::size_t width = node_width();
        std::string name;
        std::vector<std::string> components;
        while (next_line()) {
            const std::string key = cell(0, 3);
            if (key == "-4") {
                name = cell(5, 8);
            } else if (key == "-5") {
                components.push_back(cell(5, 8));
            } else {
                break;
            }
        }
        const auto indices = [&](std::initializer_list<const char*> wanted) {
            std::vector<std::size_t> found;
            for (const char* one : wanted) {
                const auto at = std::ranges::find(components, one);
                if (at == components.end()) {
                    reject(fmt::format("{} has no {}", name, one),
                           "give a file that CalculiX writes");
                }
                found.push_back(static_cast<std::size_t>(at - components.begin()));
            }
            return found;
        };
        NodeTable values;
        if (name == "CONTACT") {
            read_rows(values, width,
                      indices({"COPEN", "CSLIP1", "CSLIP2", "CPRESS", "CSHEAR1", "CSHEAR2"}));
            contents_.contact = std::move(values);
            ++contents_.steps;
        } else if (name == "STRESS") {
            read_rows(values, width, indices({"SXX", "SYY", "SZZ"}));
            contents_.stress = std::move(values);
        } else {
            read_rows(values, width, {});
        }
    }
    void read_block(NodeTable& table, const std::vector<std::size_t>& wanted) {
        const std::size_t width = node_width();
        if (next_line()) {
            read_rows(table, width, wanted);
        }
    }
    /// Reads the rows from the present line to the end of the block.
    void read_rows(NodeTable& table, std::size_t width, const std::vector<std::size_t>& wanted) {
        constexpr std::size_t value_width = 12;
        constexpr std::size_t values_of_line = 6;
        do {
            const std::string key = cell(0, 3);
            if (key == "-3") {
                return;
            }
            if (key != "-1" && key != "-2") {
                reject("a row of an .frd file begins with -1, -2 or -3",
                       "give the file as CalculiX writes it");
            }
            if (key == "-2" || wanted.empty()) {
                continue; // more components of the same node, which are not used
            }
            NodeValues row{{}, number_};
            for (const std::size_t index : wanted) {
                if (index >= values_of_line) {
                    reject("the row has too few values", "give the file as CalculiX writes it");
                }
                row.values.push_back(number_at(3 + width + value_width * index, value_width));
            }
            const std::string node = cell(3, width);
            if (!table.emplace(node, std::move(row)).second) {
                reject("node " + printable(node) + " has two rows", "give one row for each node");
            }
        } while (next_line());
        reject("the file ends inside a block", "give the whole file");
    }
    std::string number_at(std::size_t from, std::size_t size) const {
        std::string text = cell(from, size);
        if (!number_of({text}, Separator::blank)) {
            reject("'" + printable(text) + "' is no number", "give the file as CalculiX writes it");
        }
        return text;
    }

    std::string_view text_;
    const std::string& file_;
    std::string_view line_;
    std::size_t at_ = 0;
    std::size_t number_ = 0;
    CalculixContents contents_;
};

} // namespace

std::optional<CalculixContents> calculix_contents(std::string_view text, const std::string& file) {
    if (!text.starts_with("    1C") || text.find("\n    2C") == std::string_view::npos) {
        if (text.find(printed_title) != std::string_view::npos) {
            throw InputError("the contact output of a .dat file has no places of the nodes",
                             "give the .frd file, with *CONTACT FILE and CDIS, CSTR in the deck")
                .at(file, 0);
        }
        return {};
    }
    CalculixContents contents = FrdReader(text, file).read();
    if (contents.contact.empty()) {
        throw InputError("there is no contact output",
                         "add *CONTACT FILE with CDIS, CSTR to the deck")
            .at(file, 0);
    }
    for (const auto& [node, row] : contents.contact) {
        if (!contents.places.contains(node)) {
            throw InputError("node " + printable(node) + " has no place", "give the whole file")
                .at(file, row.line);
        }
    }
    return contents;
}

} // namespace edgeproof::comparison
