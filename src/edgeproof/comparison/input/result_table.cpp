// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/comparison/input/result_table.hpp"

#include "edgeproof/comparison/input/result_lines.hpp"
#include "edgeproof/io/foreign_text.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

namespace edgeproof::comparison {
namespace {

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

/// The number of a step: 2 for "2" and "Step-2".
std::optional<Rational> step_number(std::string_view text) {
    const std::size_t digit = std::min(text.find_first_of("0123456789"), text.size());
    for (const std::string_view part : {text, text.substr(digit)}) {
        if (auto number = io::read_number(part)) {
            return number;
        }
    }
    return {};
}

class TableReader {
public:
    TableReader(ResultText text, const ResultReading& reading)
        : text_(std::move(text)), header_(read_header(text_, reading)) {
        table_.file = text_.file;
        required_ = {{"x", header_.x.index}, {"p", header_.p.index}};
        if (header_.q) {
            required_.push_back({"q", header_.q->index});
        }
        table_.findings = std::move(text_.findings);
        std::ranges::move(header_.findings, std::back_inserter(table_.findings));
    }

    ResultTable read() {
        const auto first = text_.cells(text_.lines[text_.first_row]);
        numbered_ = text_.is_number(first[0]);
        check_before_first_row();
        for (std::size_t i = text_.first_row; i < text_.lines.size(); ++i) {
            if (i % 1024 == 0) {
                check_interruption();
            }
            read_line(text_.lines[i]);
        }
        finish();
        return std::move(table_);
    }

private:
    /// A column that has a number in each row.
    struct Required {
        const char* name;
        std::size_t index;
    };
    /// The numbers of a row as texts.
    struct Texts {
        std::string x;
        std::string p;
        std::string q;
        std::vector<std::string> steps; ///< in each of header_.steps
    };

    /// Refuses rows before the first complete one: one of x and p is a number, or both begin like
    /// one.
    void check_before_first_row() {
        for (std::size_t i = 0; i < text_.first_row; ++i) {
            const ResultLine& line = text_.lines[i];
            const auto cells = text_.cells(line);
            if (line.number <= header_.line || line.comment || cells.size() != text_.size) {
                continue;
            }
            const Cell& x = cells[header_.x.index];
            const Cell& p = cells[header_.p.index];
            if ((header_.line > 0 && text_.is_number(x) != text_.is_number(p)) ||
                (begins_like_number(x) && begins_like_number(p))) {
                read_line(line);
            }
        }
    }
    void skip(const ResultLine& line) {
        ++skipped_;
        first_skipped_ = first_skipped_ == 0 ? line.number : first_skipped_;
    }
    void read_line(const ResultLine& line) {
        if (line.comment) {
            return;
        }
        const auto cells = text_.cells(line);
        if (cells.empty() || (numbered_ && is_summary(cells[0]))) {
            skip(line);
            return;
        }
        const auto bad = std::ranges::find_if(required_, [&](const Required& column) {
            return column.index >= cells.size() || !text_.is_number(cells[column.index]);
        });
        if (bad == required_.end()) {
            if (cells.size() > text_.size) {
                text_.reject(line.number,
                             fmt::format("the row has {} cells and the others have {}",
                                         cells.size(), text_.size),
                             "write all rows alike");
            }
            if (numbered_ && !cells[0].text.empty() && !text_.is_number(cells[0]) &&
                !is_nan_or_infinite(cells[0])) {
                text_.reject(line.number, shown_cell(cells[0].text) + " of column 1 is no number",
                             "number all rows, or take the row out if it is none of a node");
            }
            keep(line, cells);
            return;
        }
        for (const Cell& cell : cells) {
            if (is_nan_or_infinite(cell)) {
                text_.reject(line.number,
                             "the row holds " + shown_cell(cell.text) + ", which is no number",
                             "leave out places where the program has no value");
            }
        }
        if (is_text(cells)) {
            skip(line);
            return;
        }
        if (cells.size() <= std::ranges::max(required_, {}, &Required::index).index) {
            text_.reject(
                line.number,
                fmt::format("the row is cut off: it has {} of {} cells", cells.size(), text_.size),
                "write all rows alike, or take the row out");
        }
        text_.reject(
            line.number,
            fmt::format("{} of {} is no number", shown_cell(cells[bad->index].text), bad->name),
            "write a decimal such as 1.5e-3, without marks between thousands, or take the "
            "row out");
    }

    static bool begins_like_number(const Cell& cell) {
        const std::size_t digit = cell.text.find_first_of("0123456789");
        return digit != std::string::npos && cell.text.find_first_not_of("+-.,") == digit;
    }
    /// True for the first cell of a line after the rows, with their total or mean.
    static bool is_summary(const Cell& cell) {
        constexpr std::string_view words =
            "total sum minimum maximum min max mean average at summe mittelwert somme moyenne";
        const auto all = io::split_words(words);
        const std::string lower = lower_case(cell.text);
        return std::ranges::find(all, lower.substr(0, lower.find_first_of(" :"))) != all.end();
    }
    /// True for a line of text: a title, a repeated header. A row with text in a cell is none.
    [[nodiscard]] bool is_text(const std::vector<Cell>& cells) const {
        const auto like_number = [&](std::size_t i) {
            return i < cells.size() && begins_like_number(cells[i]);
        };
        const bool alike = cells.size() == text_.size;
        if (numbered_ ? like_number(0) : !alike && like_number(header_.x.index)) {
            return false;
        }
        return alike ? !like_number(header_.x.index) && !like_number(header_.p.index)
                     : text_.numbers_in(cells) == 0 || has_new_text(cells);
    }

    /// True if there is text where the rows have numbers.
    [[nodiscard]] bool has_new_text(const std::vector<Cell>& cells) const {
        const auto row = text_.cells(text_.lines[text_.first_row]);
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if (!cells[i].text.empty() && !text_.is_number(cells[i]) &&
                (i >= row.size() || text_.is_number(row[i]))) {
                return true;
            }
        }
        return false;
    }

    [[nodiscard]] Rational value(const ResultLine& line, const std::string& text,
                                 const Rational& factor) const {
        const auto written = io::read_number(text);
        if (!written || abs(*written) > largest_number()) {
            text_.reject(line.number, shown_cell(text) + " is beyond the range of a double",
                         "write a number that a result can have");
        }
        Rational scaled = *written * factor;
        if (abs(scaled) > largest_number()) {
            text_.reject(line.number,
                         shown_cell(text) + " times its scale is beyond the range of a double",
                         "give a smaller factor to --scale");
        }
        return scaled;
    }
    void keep(const ResultLine& line, const std::vector<Cell>& cells) {
        ResultRow row;
        row.line = line.number;
        Texts& texts = texts_.emplace_back();
        cells_[0].push_back(cells[header_.x.index].text);
        cells_[1].push_back(cells[header_.p.index].text);
        texts.x = *number_of(cells[header_.x.index], text_.separator);
        texts.p = *number_of(cells[header_.p.index], text_.separator);
        row.x = value(line, texts.x, header_.x.factor);
        row.p = value(line, texts.p, header_.p.factor);
        row.p_text = texts.p;
        if (header_.q) {
            texts.q = *number_of(cells[header_.q->index], text_.separator);
            row.q = value(line, texts.q, header_.p.factor);
        }
        for (std::size_t k = 0; k < row.surface.size(); ++k) {
            const auto& column = header_.surface[k];
            if (column && column->index < cells.size() && !cells[column->index].text.empty()) {
                const auto number = number_of(cells[column->index], text_.separator);
                row.surface[k] = number ? value(line, *number, column->factor).convert_to<double>()
                                        : std::numeric_limits<double>::quiet_NaN();
            }
        }
        for (const UsedColumn& column : header_.steps) {
            const Cell cell = column.index < cells.size() ? cells[column.index] : Cell{};
            texts.steps.push_back(number_of(cell, text_.separator).value_or(cell.text));
        }
        table_.rows.push_back(std::move(row));
    }

    /// Of several load steps with the same places, keeps the last one. They are compared as
    /// numbers: of steps, then of their increments. If no place occurs twice, they do not divide
    /// the rows.
    void keep_last_step() {
        auto& rows = table_.rows;
        std::set<Rational> places;
        std::ranges::for_each(rows, [&](const ResultRow& row) { places.insert(row.x); });
        if (std::ranges::adjacent_find(texts_, std::not_equal_to(), &Texts::steps) ==
                texts_.end() ||
            places.size() == rows.size()) {
            return;
        }
        std::vector<std::vector<Rational>> numbers(rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            for (const std::string& step : texts_[i].steps) {
                const auto number = step_number(step);
                if (!number) {
                    text_.reject(rows[i].line,
                                 shown_cell(step) +
                                     " is no number of a step, and places are repeated",
                                 "number the steps, or give the rows of one step only");
                }
                numbers[i].push_back(*number);
            }
        }
        const std::size_t count = std::set(numbers.begin(), numbers.end()).size();
        if (count == 1) {
            return;
        }
        const auto greatest = std::ranges::max_element(numbers);
        const std::string shown = shown_cell(fmt::format(
            "{}",
            fmt::join(texts_[static_cast<std::size_t>(greatest - numbers.begin())].steps, ", ")));
        std::vector<ResultRow> last;
        std::vector<Texts> texts_of_last;
        places.clear();
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (numbers[i] == *greatest) {
                places.insert(rows[i].x);
                last.push_back(rows[i]);
                texts_of_last.push_back(texts_[i]);
            }
        }
        const auto alone = std::ranges::find_if(
            rows, [&](const ResultRow& row) { return !places.contains(row.x); });
        if (alone != rows.end()) {
            text_.reject(alone->line,
                         "the steps are mixed: the last one, " + shown +
                             ", has no row at this place",
                         "give the rows of one step only");
        }
        rows = std::move(last);
        texts_ = std::move(texts_of_last);
        table_.findings.push_back(fmt::format("column {} has {} steps: the last, {}, is compared",
                                              header_.steps.front().index + 1, count, shown));
    }

    [[nodiscard]] std::vector<std::string_view> column(std::string Texts::*text) const {
        std::vector<std::string_view> all;
        std::ranges::transform(texts_, std::back_inserter(all), text);
        return all;
    }
    void set_rounding(double ResultRow::*rounding, std::string Texts::*text,
                      const Rational& factor) {
        const auto half = column_rounding(column(text));
        for (std::size_t i = 0; i < half.size(); ++i) {
            table_.rows[i].*rounding = scaled_rounding(half[i], factor);
        }
    }

    [[nodiscard]] bool is_even() const {
        const auto& rows = table_.rows;
        const auto uneven = [step = Rational(rows[1].x - rows[0].x)](const auto& s, const auto& t) {
            return t.x - s.x != step;
        };
        return std::ranges::adjacent_find(rows, uneven) == rows.end();
    }

    void finish() {
        auto& rows = table_.rows;
        if (const auto at = ambiguous_mark(cells_)) {
            const std::string& number = cells_[at->first][at->second];
            std::string whole = number;
            std::erase_if(whole, [](char c) { return c == ',' || c == '.'; });
            text_.reject(rows[at->second].line,
                         fmt::format("{} may be {}, or a decimal", shown_cell(number), whole),
                         "use one decimal mark, and no mark between thousands");
        }
        keep_last_step();
        if (rows.size() < 2) {
            text_.reject(
                rows.empty() ? 0 : rows.front().line,
                fmt::format("there {} of numbers", rows.empty() ? "is no row" : "is one row"),
                "give the whole contact: one row for each node");
        }
        if (std::ranges::all_of(rows, [&](const ResultRow& r) { return r.x == rows[0].x; })) {
            text_.reject(rows.front().line, "every row has the same x",
                         "name the right column by --columns x=1,p=2");
        }
        if (skipped_ > 0) {
            table_.findings.push_back(fmt::format(
                "{} of text between or after the rows {} not read; the first is line {}",
                skipped_ == 1 ? "1 line" : fmt::format("{} lines", skipped_),
                skipped_ == 1 ? "is" : "are", first_skipped_));
        }
        table_.p_factor = header_.p.factor.convert_to<double>();
        set_rounding(&ResultRow::x_rounding, &Texts::x, header_.x.factor);
        set_rounding(&ResultRow::p_rounding, &Texts::p, header_.p.factor);
        if (header_.q) {
            set_rounding(&ResultRow::q_rounding, &Texts::q, header_.p.factor);
        }
        if (!std::ranges::is_sorted(rows, {}, &ResultRow::x)) {
            const bool falling = std::ranges::is_sorted(rows, std::greater(), &ResultRow::x);
            table_.findings.emplace_back(falling ? "the rows are ordered from right to left"
                                                 : "the rows are not in the order of x");
            std::ranges::stable_sort(rows, {}, &ResultRow::x);
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

    ResultText text_;
    TableHeader header_;
    ResultTable table_;
    std::vector<Required> required_;
    bool numbered_ = false; ///< the first cell of the first row is a number
    std::vector<std::vector<std::string>> cells_{2}; ///< of x and p, as written
    std::vector<Texts> texts_;                       ///< of each row
    std::size_t skipped_ = 0;
    std::size_t first_skipped_ = 0;
};

} // namespace

ResultTable parse_result(std::string_view text, const std::string& file,
                         const ResultReading& reading) {
    auto calculix = calculix_table(text, file);
    return TableReader(calculix ? std::move(*calculix) : result_text(text, file), reading).read();
}

ResultTable read_result(const std::filesystem::path& file, const ResultReading& reading) {
    return parse_result(io::read_text(file, "result (a table of x and p)"), file.string(), reading);
}

} // namespace edgeproof::comparison
