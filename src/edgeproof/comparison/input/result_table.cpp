// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/input/result_table.hpp"

#include "edgeproof/comparison/input/result_header.hpp"
#include "edgeproof/comparison/input/result_lines.hpp"
#include "edgeproof/conformance/answers/number_text.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/exact_rational.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace edgeproof::comparison {
namespace {

constexpr std::size_t longest_shown_cell = 40;

std::string shown_cell(std::string_view text) {
    return "'" + shortened(printable(text), longest_shown_cell) + "'";
}

/// Sums and differences of numbers up to this limit are finite in double precision.
const Rational& largest_number() {
    static const Rational most(Integer(pow(Integer(10), 300U)));
    return most;
}

/// Infinite beyond the range of a double.
double scaled_rounding(double rounding, const Rational& factor) {
    const Rational product =
        std::isfinite(rounding) ? exact_rational(rounding) * factor : Rational(0);
    return std::isfinite(rounding) && product <= largest_number()
               ? product.convert_to<double>()
               : std::numeric_limits<double>::infinity();
}

class TableReader {
public:
    TableReader(std::string_view text, const std::string& file, const ResultReading& reading)
        : file_(file), reading_(reading), lines_(result_lines(text, file)) {
        if (lines_.empty()) {
            throw InputError("the file is empty", "give a table of places x and pressures p")
                .at(file, 0);
        }
        separator_ = find_separator(lines_, file);
        table_.file = file;
    }

    ResultTable read() {
        find_first_row();
        TableHeader header = read_header(lines_, {file_, separator_, size_, first_row_}, reading_);
        x_ = header.x;
        p_ = header.p;
        q_ = header.q;
        x_factor_ = header.x_factor;
        p_factor_ = header.p_factor;
        table_.findings = std::move(header.findings);
        numbered_ = is_number(split_row(lines_[first_row_].text, separator_)[0]);
        for (std::size_t i = first_row_; i < lines_.size(); ++i) {
            if (i % 1024 == 0) {
                check_interruption();
            }
            read_line(lines_[i]);
        }
        finish();
        return std::move(table_);
    }

private:
    [[noreturn]] void reject(std::size_t line, const std::string& problem,
                             const std::string& instead) const {
        throw InputError(problem, instead).at(file_, line);
    }
    [[nodiscard]] bool is_number(const Cell& cell) const {
        return number_of(cell, separator_).has_value();
    }

    /// If rows have several lengths, the most frequent one of the first hundred is used.
    void find_first_row() {
        std::map<std::size_t, std::size_t> sizes;
        std::size_t seen = 0;
        for (const ResultLine& line : lines_) {
            const auto cells = split_row(line.text, separator_);
            if (!line.comment && seen < 100 && numbers_in(cells) >= 2) {
                ++sizes[cells.size()];
                ++seen;
            }
        }
        std::size_t most = 0;
        for (const auto& [size, count] : sizes) {
            if (count > most) {
                most = count;
                size_ = size;
            }
        }
        while (first_row_ < lines_.size() &&
               (lines_[first_row_].comment ||
                numbers_in(split_row(lines_[first_row_].text, separator_)) < 2 ||
                split_row(lines_[first_row_].text, separator_).size() != size_)) {
            ++first_row_;
        }
    }
    [[nodiscard]] std::size_t numbers_in(const std::vector<Cell>& cells) const {
        return static_cast<std::size_t>(
            std::ranges::count_if(cells, [this](const Cell& c) { return is_number(c); }));
    }

    void skip(const ResultLine& line) {
        ++skipped_;
        first_skipped_ = first_skipped_ == 0 ? line.number : first_skipped_;
    }
    void read_line(const ResultLine& line) {
        if (line.comment) {
            return;
        }
        const auto cells = split_row(line.text, separator_);
        const std::size_t last = std::max({x_.index, p_.index, q_ ? q_->index : 0});
        const std::size_t numbers = numbers_in(cells);
        const auto unusable = [&](const UsedColumn& c) {
            return c.index >= cells.size() || !is_number(cells[c.index]);
        };
        if (numbered_ && !cells.empty() && !cells[0].text.empty() && !is_number(cells[0]) &&
            !is_nan_or_infinite(cells[0]) && x_.index != 0 && p_.index != 0) {
            skip(line); // "Total", "Minimum" instead of a node's number
            return;
        }
        if (!unusable(x_) && !unusable(p_) && !(q_ && unusable(*q_))) {
            if (cells.size() != size_ && cells.size() > size_) {
                reject(
                    line.number,
                    fmt::format("the row has {} cells and the others have {}", cells.size(), size_),
                    "write all rows alike");
            }
            keep(line, cells);
            return;
        }
        for (const Cell& cell : cells) {
            if (is_nan_or_infinite(cell)) {
                reject(line.number,
                       "the row holds " + shown_cell(cell.text) + ", which is no number",
                       "leave out places where the program has no value");
            }
        }
        // A line of text: a title, a repeated header, a total.
        if (numbers == 0 || (cells.size() != size_ && has_new_text(cells))) {
            skip(line);
            return;
        }
        if (cells.size() <= last) {
            reject(line.number,
                   fmt::format("the row is cut off: it has {} of {} cells", cells.size(), size_),
                   "write all rows alike, or take the row out");
        }
        const UsedColumn& bad = unusable(x_) ? x_ : unusable(p_) ? p_ : *q_;
        reject(line.number,
               fmt::format("{} of {} is no number", shown_cell(cells[bad.index].text),
                           unusable(x_)   ? "x"
                           : unusable(p_) ? "p"
                                          : "q"),
               "write a decimal such as 1.5e-3, or take the row out");
    }

    /// True if there is text where the rows have numbers.
    [[nodiscard]] bool has_new_text(const std::vector<Cell>& cells) const {
        const auto row = split_row(lines_[first_row_].text, separator_);
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if (!cells[i].text.empty() && !is_number(cells[i]) &&
                (i >= row.size() || is_number(row[i]))) {
                return true;
            }
        }
        return false;
    }

    [[nodiscard]] Rational value(const ResultLine& line, const std::string& text,
                                 const Rational& factor) const {
        const auto written = conformance::written_number(text);
        if (written.kind != conformance::WrittenNumber::Kind::number ||
            abs(written.value) > largest_number()) {
            reject(line.number, shown_cell(text) + " is beyond the range of a double",
                   "write a number that a result can have");
        }
        Rational scaled = written.value * factor;
        if (abs(scaled) > largest_number()) {
            reject(line.number,
                   shown_cell(text) + " times its scale is beyond the range of a double",
                   "give a smaller factor to --scale");
        }
        return scaled;
    }
    void keep(const ResultLine& line, const std::vector<Cell>& cells) {
        ResultRow row;
        row.line = line.number;
        x_texts_.push_back(*number_of(cells[x_.index], separator_));
        p_texts_.push_back(*number_of(cells[p_.index], separator_));
        row.x = value(line, x_texts_.back(), x_factor_);
        row.p = value(line, p_texts_.back(), p_factor_);
        if (q_) {
            q_texts_.push_back(*number_of(cells[q_->index], separator_));
            row.q = value(line, q_texts_.back(), p_factor_);
        }
        table_.rows.push_back(std::move(row));
    }

    [[nodiscard]] bool is_even() const {
        const auto& rows = table_.rows;
        for (std::size_t i = 2; i < rows.size(); ++i) {
            if (rows[i].x - rows[i - 1].x != rows[1].x - rows[0].x) {
                return false;
            }
        }
        return true;
    }

    void finish() {
        auto& rows = table_.rows;
        if (rows.size() < 2) {
            reject(rows.empty() ? 0 : rows.front().line,
                   fmt::format("there {} of numbers", rows.empty() ? "is no row" : "is one row"),
                   "give the whole contact: one row for each node");
        }
        if (std::ranges::all_of(rows, [&](const ResultRow& r) { return r.x == rows[0].x; })) {
            reject(rows.front().line, "every row has the same x",
                   "name the right column by --columns x=1,p=2");
        }
        if (skipped_ > 0) {
            table_.findings.push_back(fmt::format(
                "{} of text between or after the rows {} not read; the first is line {}",
                skipped_ == 1 ? "1 line" : fmt::format("{} lines", skipped_),
                skipped_ == 1 ? "is" : "are", first_skipped_));
        }
        const auto rounding = [](const std::vector<std::string>& texts) {
            return column_rounding({texts.begin(), texts.end()});
        };
        table_.p_digits = carried_digits({p_texts_.begin(), p_texts_.end()});
        table_.p_factor = p_factor_.convert_to<double>();
        const auto x_half = rounding(x_texts_);
        const auto p_half = rounding(p_texts_);
        const auto q_half = rounding(q_texts_);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            rows[i].x_rounding = scaled_rounding(x_half[i], x_factor_);
            rows[i].p_rounding = scaled_rounding(p_half[i], p_factor_);
            rows[i].q_rounding = q_ ? scaled_rounding(q_half[i], p_factor_) : 0;
        }
        const auto by_x = [](const ResultRow& s, const ResultRow& t) { return s.x < t.x; };
        if (!std::ranges::is_sorted(rows, by_x)) {
            const bool falling = std::ranges::is_sorted(
                rows, [](const ResultRow& s, const ResultRow& t) { return s.x > t.x; });
            table_.findings.emplace_back(falling ? "the rows are ordered from right to left"
                                                 : "the rows are not in the order of x");
            std::ranges::stable_sort(rows, by_x);
        }
        if (is_even()) { // a grid of few decimals is exact, without rounding
            for (ResultRow& row : rows) {
                row.x_rounding = 0;
            }
        }
        std::size_t repeated = 0;
        for (std::size_t i = 1; i < rows.size(); ++i) {
            repeated += rows[i].x == rows[i - 1].x ? 1 : 0;
        }
        if (repeated > 0) {
            table_.findings.push_back(fmt::format(
                "{} of the rows repeat the x of another; each is compared with the exact pressure",
                repeated));
        }
    }

    std::string file_;
    const ResultReading& reading_;
    std::vector<ResultLine> lines_;
    Separator separator_ = Separator::comma;
    ResultTable table_;
    std::size_t size_ = 0; ///< cells of a row
    std::size_t first_row_ = 0;
    bool numbered_ = false; ///< the first cell of the first row is a number
    UsedColumn x_;
    UsedColumn p_;
    std::optional<UsedColumn> q_;
    Rational x_factor_ = 1;
    Rational p_factor_ = 1;
    std::vector<std::string> x_texts_;
    std::vector<std::string> p_texts_;
    std::vector<std::string> q_texts_;
    std::size_t skipped_ = 0;
    std::size_t first_skipped_ = 0;
};

} // namespace

ResultTable parse_result(std::string_view text, const std::string& file,
                         const ResultReading& reading) {
    return TableReader(text, file, reading).read();
}

ResultTable read_result(const std::filesystem::path& file, const ResultReading& reading) {
    return parse_result(io::read_text(file, "result (a table of x and p)"), file.string(), reading);
}

void parse_scale(std::string_view text, ResultReading& reading) {
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t comma = std::min(text.find(',', at), text.size());
        const std::string_view part = text.substr(at, comma - at);
        const std::size_t equals = std::min(part.find('='), part.size());
        const std::string_view key = part.substr(0, equals);
        const auto factor = conformance::written_number(
            equals < part.size() ? part.substr(equals + 1) : std::string_view{});
        if ((key != "x" && key != "p") || factor.kind != conformance::WrittenNumber::Kind::number ||
            !(factor.value > 0)) {
            throw InputError("--scale " + std::string(text) + ": '" + std::string(part) +
                                 "' is no factor of x or p",
                             "write it as x=1e-3,p=1e6, with positive factors");
        }
        (key == "x" ? reading.x_scale : reading.p_scale) = factor.value;
        at = comma + 1;
    }
}

} // namespace edgeproof::comparison
