// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/csv.hpp"

#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <utility>

namespace edgeproof {
namespace {

constexpr std::string_view blanks = " \t\r";

std::string trimmed(std::string_view text) {
    const std::size_t from = text.find_first_not_of(blanks);
    return from == std::string_view::npos
               ? std::string{}
               : std::string(text.substr(from, text.find_last_not_of(blanks) - from + 1));
}

class Parser {
public:
    Parser(std::string_view text, const std::string& file) : text_(text), file_(file) {}

    /// The next row that is no note and not blank.
    bool next(Csv::Row& row, std::vector<std::string>& notes) {
        while (at_ < text_.size()) {
            const std::size_t end = std::min(text_.find('\n', at_), text_.size());
            const std::string line = trimmed(text_.substr(at_, end - at_));
            if (!line.empty() && line.front() != '#') {
                read(row);
                return true;
            }
            if (!line.empty()) {
                notes.push_back(trimmed(std::string_view(line).substr(1)));
            }
            at_ = std::min(end + 1, text_.size());
            ++line_;
        }
        return false;
    }

private:
    void read(Csv::Row& row) {
        row = {line_, {}};
        do {
            row.cells.push_back(cell());
        } while (at_ < text_.size() && text_[at_] == ',' && ++at_ <= text_.size());
        at_ = std::min(text_.find('\n', at_), text_.size());
        at_ = std::min(at_ + 1, text_.size());
        ++line_;
    }
    std::string cell() {
        std::size_t from = at_;
        while (from < text_.size() && (text_[from] == ' ' || text_[from] == '\t')) {
            ++from;
        }
        if (from < text_.size() && text_[from] == '"') {
            at_ = from + 1;
            return quoted();
        }
        from = at_;
        at_ = std::min(text_.find_first_of(",\n", at_), text_.size());
        return trimmed(text_.substr(from, at_ - from));
    }
    std::string quoted() {
        const std::size_t begun = line_;
        std::string cell;
        while (at_ < text_.size()) {
            const char c = text_[at_++];
            if (c != '"') {
                cell += c;
                line_ += c == '\n' ? 1 : 0;
            } else if (at_ < text_.size() && text_[at_] == '"') {
                cell += text_[at_++];
            } else {
                at_ = std::min(text_.find_first_of(",\n", at_), text_.size());
                return cell;
            }
        }
        throw InputError("a quote begins here and does not end", "close it, or write \"\" for one")
            .at(file_, begun);
    }

    std::string_view text_;
    const std::string& file_;
    std::size_t at_ = 0;
    std::size_t line_ = 1;
};

} // namespace

std::optional<std::size_t> Csv::column(std::string_view name) const {
    const auto at = std::find(header.cells.begin(), header.cells.end(), name);
    return at == header.cells.end()
               ? std::nullopt
               : std::optional(static_cast<std::size_t>(at - header.cells.begin()));
}

Csv parse_csv(std::string_view text, const std::string& file) {
    Csv csv;
    csv.file = file;
    Parser parser(text, file);
    if (!parser.next(csv.header, csv.notes)) {
        throw InputError("there is no header line", "write the names of the columns first")
            .at(file, 1);
    }
    for (Csv::Row row; parser.next(row, csv.notes);) {
        csv.rows.push_back(std::move(row));
    }
    return csv;
}

} // namespace edgeproof
