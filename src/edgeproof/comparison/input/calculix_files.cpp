// SPDX-License-Identifier: GPL-3.0-or-later

#include "edgeproof/comparison/input/result_lines.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace edgeproof::comparison {
namespace {

constexpr std::string_view white_space = " \t\r";
constexpr std::string_view stress_title = "contact stress (slave node";
constexpr std::string_view gap_title = "relative contact displacement (slave node";
constexpr std::string_view face_title = "contact stress (slave element+face";

class Lines {
public:
    Lines(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}

    bool next() {
        if (at_ >= text_.size()) {
            return false;
        }
        if (++number_ % 4096 == 0) {
            check_interruption();
        }
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        line_ = text_.substr(at_, end - at_);
        line_.remove_suffix(line_.ends_with('\r') ? 1 : 0);
        at_ = end + 1;
        return true;
    }
    [[nodiscard]] std::string_view line() const { return line_; }
    [[nodiscard]] std::size_t number() const { return number_; }
    [[noreturn]] void reject(const std::string& problem, const std::string& instead) const {
        throw InputError(problem, instead).at(file_, number_);
    }
    /// A part of the line, without white_space; empty beyond its end.
    [[nodiscard]] std::string cell(std::size_t from, std::size_t size) const {
        return from < line_.size() ? std::string(trimmed(line_.substr(from, size), white_space))
                                   : std::string();
    }
    [[nodiscard]] const std::string& file() const { return file_; }
    /// Adds the row of a node. A second one in the same block is refused.
    void add(NodeTable& table, const std::string& node, NodeValues row) const {
        if (!table.emplace(node, std::move(row)).second) {
            reject("node " + printable(node) + " has two rows", "give one row for each node");
        }
    }

private:
    std::string_view text_;
    std::string file_;
    std::string_view line_;
    std::size_t at_ = 0;
    std::size_t number_ = 0;
};

/// An .frd file in text: lines of fixed columns, one for a node.
class FrdReader {
public:
    FrdReader(std::string_view text, const std::string& file) : lines_(text, file) {}

    CalculixContents read() {
        while (lines_.next()) {
            const std::string_view line = lines_.line();
            if (line.starts_with("    2C")) {
                read_block(contents_.places, {0, 1, 2});
            } else if (line.starts_with("  100C")) {
                read_result();
            }
        }
        return std::move(contents_);
    }

private:
    /// Returns the width of the number of a node from the format in the head of a block.
    std::size_t node_width() {
        const std::string format(trimmed(lines_.line().substr(
            std::min(lines_.line().find_last_not_of(white_space), lines_.line().size()))));
        if (format != "0" && format != "1") {
            lines_.reject("the file is not an .frd file in text",
                          "let CalculiX write it in text (no OUTPUT=BINARY)");
        }
        return format == "0" ? 5 : 10;
    }
    void read_result() {
        const std::size_t width = node_width();
        std::string name;
        std::vector<std::string> components;
        while (lines_.next()) {
            const std::string key = lines_.cell(0, 3);
            if (key == "-4") {
                name = lines_.cell(5, 8);
            } else if (key == "-5") {
                components.push_back(lines_.cell(5, 8));
            } else {
                break;
            }
        }
        const auto indices = [&](std::initializer_list<const char*> wanted) {
            std::vector<std::size_t> found;
            for (const char* one : wanted) {
                const auto at = std::ranges::find(components, one);
                if (at == components.end()) {
                    lines_.reject(fmt::format("{} has no {}", name, one),
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
        if (lines_.next()) {
            read_rows(table, width, wanted);
        }
    }
    /// Reads the rows from the present line to the end of the block.
    void read_rows(NodeTable& table, std::size_t width, const std::vector<std::size_t>& wanted) {
        constexpr std::size_t value_width = 12;
        constexpr std::size_t values_of_line = 6;
        do {
            const std::string key = lines_.cell(0, 3);
            if (key == "-3") {
                return;
            }
            if (key != "-1" && key != "-2") {
                lines_.reject("a row of an .frd file begins with -1, -2 or -3",
                              "give the file as CalculiX writes it");
            }
            if (key == "-2" || wanted.empty()) {
                continue; // more components of the same node, which are not used
            }
            NodeValues row{{}, lines_.number()};
            for (const std::size_t index : wanted) {
                if (index >= values_of_line) {
                    lines_.reject("the row has too few values",
                                  "give the file as CalculiX writes it");
                }
                row.values.push_back(number_at(3 + width + value_width * index, value_width));
            }
            lines_.add(table, lines_.cell(3, width), std::move(row));
        } while (lines_.next());
        lines_.reject("the file ends inside a block", "give the whole file");
    }
    std::string number_at(std::size_t from, std::size_t size) const {
        std::string text = lines_.cell(from, size);
        if (!number_of({text}, Separator::blank)) {
            lines_.reject("'" + printable(text) + "' is no number",
                          "give the file as CalculiX writes it");
        }
        return text;
    }

    Lines lines_;
    CalculixContents contents_;
};

std::vector<std::string> words_of(std::string_view line) {
    std::vector<std::string> words;
    for (Cell& cell : split_row(line, Separator::blank)) {
        words.push_back(std::move(cell.text));
    }
    return words;
}

/// A .dat file: titles, each followed by rows of a node and its values.
CalculixContents read_dat(std::string_view text, const std::string& file) {
    CalculixContents contents;
    NodeTable gaps;
    NodeTable* table = nullptr;
    Lines lines(text, file);
    while (lines.next()) {
        const std::vector<std::string> words = words_of(lines.line());
        if (words.empty()) {
            continue;
        }
        if (!number_of({words[0]}, Separator::blank)) { // a title
            const bool stress = lines.line().find(stress_title) != std::string_view::npos;
            const bool gap = lines.line().find(gap_title) != std::string_view::npos;
            table = stress ? &contents.contact : gap ? &gaps : nullptr;
            contents.steps += stress ? 1 : 0;
            if (table != nullptr) {
                table->clear();
            }
        } else if (table != nullptr) {
            if (words.size() != 4 || !std::ranges::all_of(words, [](const std::string& word) {
                    return number_of({word}, Separator::blank).has_value();
                })) {
                lines.reject("a row of contact output has a node and three numbers",
                             "give the file as CalculiX writes it");
            }
            lines.add(*table, words[0], {{words.begin() + 1, words.end()}, lines.number()});
        }
    }
    for (auto& [node, row] : contents.contact) {
        const auto gap = gaps.find(node);
        std::vector<std::string> values =
            gap != gaps.end() ? gap->second.values : std::vector<std::string>(cpress);
        values.insert(values.end(), row.values.begin(), row.values.end());
        row.values = std::move(values);
    }
    return contents;
}

/// The nodes of a deck: the rows after *NODE.
NodeTable nodes_of_deck(std::string_view text, const std::string& file) {
    NodeTable nodes;
    bool in_nodes = false;
    Lines lines(text, file);
    while (lines.next()) {
        const std::string_view line = trimmed(lines.line(), white_space);
        if (line.empty() || line.starts_with("**")) {
            continue;
        }
        if (line.starts_with('*')) {
            const std::string keyword = lower_case(line.substr(0, line.find(',')));
            in_nodes = trimmed(keyword, white_space) == "*node";
        } else if (in_nodes) {
            std::vector<std::string> values;
            for (const Cell& cell : split_row(line, Separator::comma)) {
                values.push_back(cell.text);
            }
            const std::string node = values.empty() ? "" : values.front();
            values.erase(values.begin(), values.begin() + (values.empty() ? 0 : 1));
            values.resize(3, "0");
            for (const std::string& value : values) {
                if (!number_of({value}, Separator::comma)) {
                    lines.reject("'" + printable(value) + "' is no coordinate of a node",
                                 "write number, x, y, z");
                }
            }
            lines.add(nodes, node, {std::move(values), lines.number()});
        }
    }
    return nodes;
}

/// The places of the nodes from the file of the same name next to a .dat file.
NodeTable places_next_to(const std::string& file) {
    namespace fs = std::filesystem;
    for (const char* ending : {".frd", ".inp"}) {
        const fs::path other = fs::path(file).replace_extension(ending);
        if (!fs::is_regular_file(other)) {
            continue;
        }
        const std::string text = io::read_text(other, "file of CalculiX");
        return ending == std::string_view(".frd") ? FrdReader(text, other.string()).read().places
                                                  : nodes_of_deck(text, other.string());
    }
    throw InputError("the contact output has no places of the nodes",
                     "put the .frd or .inp file of the same name next to it")
        .at(file, 0);
}

} // namespace

std::optional<CalculixContents> calculix_contents(std::string_view text, const std::string& file) {
    const bool frd = text.starts_with("    1C") && text.find("\n    2C") != std::string_view::npos;
    if (!frd && text.find(stress_title) == std::string_view::npos) {
        if (text.find(face_title) != std::string_view::npos) {
            throw InputError(
                "the contact output is that of points inside the faces, without places",
                "give the .frd file, with *CONTACT FILE and CDIS, CSTR in the deck")
                .at(file, 0);
        }
        return {};
    }
    CalculixContents contents = frd ? FrdReader(text, file).read() : read_dat(text, file);
    if (contents.contact.empty()) {
        throw InputError("there is no contact output",
                         "add *CONTACT FILE with CDIS, CSTR to the deck")
            .at(file, 0);
    }
    if (!frd) {
        contents.places = places_next_to(file);
    }
    for (const auto& [node, row] : contents.contact) {
        if (!contents.places.contains(node)) {
            throw InputError("node " + printable(node) + " has no place",
                             "give the .frd or .inp file that belongs to this file")
                .at(file, row.line);
        }
    }
    return contents;
}

} // namespace edgeproof::comparison
