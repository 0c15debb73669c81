// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/comparison/input/result_lines.hpp"
#include "edgeproof/io/foreign_text.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <utility>

namespace edgeproof::comparison {
namespace {

constexpr std::string_view white_space = " \t\r";

class FrdReader {
public:
    FrdReader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

    FrdContents read() {
        while (next_line()) {
            if (line_.starts_with("    2C")) {
                const std::size_t width = node_width();
                if (next_line()) {
                    read_rows(contents_.places, width, {0, 1, 2});
                }
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
    [[noreturn]] void
    reject(const std::string& problem,
           const std::string& instead = "give the file as CalculiX writes it") const {
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
        FrdRows rows;
        if (name == "CONTACT") {
            read_rows(rows, width,
                      indices({"COPEN", "CSLIP1", "CSLIP2", "CPRESS", "CSHEAR1", "CSHEAR2"}));
            contents_.contact = std::move(rows);
            ++contents_.steps;
        } else if (name == "STRESS") {
            read_rows(rows, width, indices({"SXX", "SYY", "SZZ"}));
            contents_.stress = std::move(rows);
        } else {
            read_rows(rows, width, {});
        }
    }
    /// Reads the rows from the present line to the end of the block.
    void read_rows(FrdRows& rows, std::size_t width, const std::vector<std::size_t>& wanted) {
        constexpr std::size_t value_width = 12;
        constexpr std::size_t values_of_line = 6;
        do {
            const std::string key = cell(0, 3);
            if (key == "-3") {
                return;
            }
            if (key != "-1" && key != "-2") {
                reject("a row of an .frd file begins with -1, -2 or -3");
            }
            if (key == "-2" || wanted.empty()) {
                continue; // more components of the same node, which are not used
            }
            FrdRow row{{}, number_};
            for (const std::size_t index : wanted) {
                if (index >= values_of_line) {
                    reject("the row has too few values");
                }
                row.values.push_back(number_at(3 + width + value_width * index, value_width));
            }
            const std::string node = cell(3, width);
            if (!rows.emplace(node, std::move(row)).second) {
                reject("node " + printable(node) + " has two rows", "give one row for each node");
            }
        } while (next_line());
        reject("the file ends inside a block", "give the whole file");
    }
    [[nodiscard]] FrdNumber number_at(std::size_t from, std::size_t size) const {
        const std::string text = cell(from, size);
        const auto number = number_of({text}, ' ');
        if (!number) {
            reject("'" + printable(text) + "' is no number");
        }
        return {text, io::read_number(*number).value().convert_to<double>()};
    }

    std::string_view text_;
    const std::string& file_;
    std::string_view line_;
    std::size_t at_ = 0;
    std::size_t number_ = 0;
    FrdContents contents_;
};

} // namespace

FrdContents read_frd(std::string_view text, const std::string& file) {
    return FrdReader(text, file).read();
}

} // namespace edgeproof::comparison
