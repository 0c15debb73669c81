// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/comparison/input/result_lines.hpp"

#include "edgeproof/io/foreign_text.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

namespace edgeproof::comparison {
namespace {

/// The text of a cell without brackets.
std::string_view without_brackets(const Cell& cell) {
    std::string_view text = cell.text;
    return text.size() > 2 && (text.front() == '[' || text.front() == '(')
               ? text.substr(1, text.size() - 2)
               : text;
}
bool is_unit(const Cell& cell) {
    const std::string_view text = without_brackets(cell);
    return scene::unit_named(text).has_value() || scene::resembles_unit(text);
}

bool all_units(const std::vector<Cell>& cells) {
    return std::ranges::any_of(cells, is_unit) && std::ranges::all_of(cells, [](const Cell& c) {
               return is_unit(c) || c.text.empty() || c.text == "-" || c.text == "[-]" ||
                      c.text == "1";
           });
}

/// Returns the text with a tab for two blanks or more: names may contain single ones.
std::string wide_gaps_as_tabs(const std::string& text) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find_first_not_of(' ', at), text.size());
        out += end - at > 1 ? "\t" : text.substr(at, std::max<std::size_t>(end - at, 1));
        at = std::max(end, at + 1);
    }
    return out;
}

/// The name of a column of one step: COMSOL writes "solid.Tn (Pa) @ t=0.5" for each time.
std::string_view without_step(std::string_view name) {
    return trimmed(name.substr(0, name.find('@')));
}
/// The number of that step: 0.5. Nothing for a name of another form.
std::optional<Rational> step_of(std::string_view name) {
    const std::size_t equals = name.rfind('=');
    if (name.find('@') > equals || equals == std::string_view::npos) {
        return {};
    }
    const std::string_view text = trimmed(name.substr(equals + 1));
    return io::read_number(text.substr(0, text.find(' ')));
}

class HeaderReader {
public:
    HeaderReader(const ResultText& text, const ResultReading& reading)
        : text_(text), reading_(reading) {}

    TableHeader read() {
        find_columns();
        return std::move(found_);
    }

private:
    [[nodiscard]] static std::string without_comment_mark(const ResultLine& line) {
        return line.comment ? line.text.substr(std::min(line.text.find_first_not_of("#%!/*\" \t"),
                                                        line.text.size()))
                            : line.text;
    }
    /// Returns the names in a line before the rows, separated as the rows are or in another way.
    [[nodiscard]] std::vector<Cell> names_in(const ResultLine& line) const {
        std::string text = without_comment_mark(line);
        for (std::size_t at = 0; (at = text.find_first_of("[(", at)) != std::string::npos; ++at) {
            while (at > 0 && (text[at - 1] == ' ' || text[at - 1] == '\t')) {
                text.erase(--at, 1); // "x [mm]" is one name
            }
        }
        return cells_in(text);
    }
    [[nodiscard]] std::vector<Cell> cells_in(const std::string& text) const {
        std::vector<Cell> cells = split_row(text, text_.separator);
        for (const char other : {',', ';', '\t', ' '}) {
            auto again = split_row(text, other);
            if (cells.size() != text_.size && again.size() == text_.size) {
                cells = std::move(again);
            }
        }
        if (text_.separator == ' ' && cells.size() != text_.size) {
            auto apart = split_row(wide_gaps_as_tabs(text), '\t');
            if (apart.size() == text_.size) {
                cells = std::move(apart);
            }
        }
        return cells;
    }

    struct Found {
        std::optional<std::size_t> index;
        std::optional<std::size_t> twin; ///< another column of the same rank
        int rank = 100;
        std::size_t steps = 1; ///< columns of the same name; `index` has the greatest step
    };
    [[nodiscard]] static std::map<ColumnRole, Found> roles_in(const std::vector<Cell>& names) {
        std::map<ColumnRole, Found> roles;
        for (std::size_t i = 0; i < names.size(); ++i) {
            const auto named = role_of(read_column_name(names[i].text).plain);
            if (!named) {
                continue;
            }
            Found& found = roles[named->role];
            if (named->rank < found.rank) {
                found = {i, {}, named->rank};
            } else if (named->rank == found.rank) {
                const std::string& other = names[*found.index].text;
                const auto step = step_of(names[i].text);
                const auto greatest = step_of(other);
                if (step && greatest && *step != *greatest &&
                    without_step(names[i].text) == without_step(other)) {
                    found.index = *step > *greatest ? i : *found.index;
                    ++found.steps;
                } else {
                    found.twin = i;
                }
            }
        }
        return roles;
    }

    /// Finds the line closest above the rows that names their columns.
    void find_header() {
        for (std::size_t i = text_.first_row; i-- > 0;) {
            auto names = names_in(text_.lines[i]);
            if (names.empty() || text_.numbers_in(names) > 0) {
                continue;
            }
            const auto roles = roles_in(names);
            const bool both =
                roles.contains(ColumnRole::place) && roles.contains(ColumnRole::pressure);
            if (names.size() == text_.size && (both || names_chosen(names))) {
                header_line_ = text_.lines[i].number;
                found_.line = header_line_;
                header_ = std::move(names);
                return;
            }
            const bool blanks = text_.separator == ' ';
            const bool chosen_columns =
                blanks && reading_.columns.contains("x") && reading_.columns.contains("p");
            if (both && !text_.lines[i].comment && names.size() > 1 && !chosen_columns) {
                text_.reject(
                    text_.lines[i].number,
                    fmt::format("the header names {} columns, and the rows have {}", names.size(),
                                text_.size),
                    blanks ? "write each name as one word (Node_Label) or in quotes, or give "
                             "the columns by number: --columns x=1,p=2"
                           : "name every column once, and write no decimal commas where commas "
                             "separate");
            }
            if (names.size() == text_.size && !near_header_ && !text_.lines[i].comment &&
                !all_units(names)) {
                near_header_ = i;
            }
        }
    }
    [[nodiscard]] bool names_chosen(const std::vector<Cell>& names) const {
        return std::ranges::any_of(reading_.columns, [&](const auto& chosen) {
            return std::ranges::find(names, chosen.second, &Cell::text) != names.end();
        });
    }

    void find_columns() {
        find_header();
        if (header_.empty() && near_header_) {
            header_line_ = text_.lines[*near_header_].number;
            header_ = names_in(text_.lines[*near_header_]);
        }
        const auto roles = roles_in(header_);
        found_.x = column(ColumnRole::place, "x", roles, 0);
        found_.p = column(ColumnRole::pressure, "p", roles, 1);
        const auto q = roles.find(ColumnRole::shear);
        if (reading_.columns.contains("q") || (q != roles.end() && !q->second.twin)) {
            found_.q = column(ColumnRole::shear, "q", roles, 2);
        }
        if (found_.x.index == found_.p.index || (found_.q && (found_.q->index == found_.x.index ||
                                                              found_.q->index == found_.p.index))) {
            text_.reject(header_line_, "one column is taken for two quantities",
                         "name them by --columns x=1,p=2");
        }
        for (std::size_t i = 0; i < header_.size(); ++i) {
            if (step_rank(read_column_name(header_[i].text).plain)) {
                found_.steps.push_back(at_column(i));
            }
        }
        std::ranges::stable_sort(found_.steps, {}, [](const UsedColumn& column) {
            return step_rank(column.name.plain);
        });
        find_units();
        find_surface(roles);
        found_.findings.push_back(fmt::format("columns: x is {}, p is {}{}; {} separate them",
                                              column_text(found_.x), column_text(found_.p),
                                              found_.q ? ", q is " + column_text(*found_.q) : "",
                                              separator_name(text_.separator)));
    }
    /// A column without a unit has that of x or p.
    void find_surface(const std::map<ColumnRole, Found>& roles) {
        for (std::size_t k = 0; k < surface_roles.size(); ++k) {
            const auto found = roles.find(surface_roles[k]);
            if (found == roles.end()) {
                continue;
            }
            if (found->second.twin) {
                found_.findings.push_back(
                    fmt::format("{} is not compared: columns {} and {} may both be it",
                                printable(header_[*found->second.index].text),
                                *found->second.index + 1, *found->second.twin + 1));
                continue;
            }
            UsedColumn& c = found_.surface[k].emplace(at_column(*found->second.index));
            const bool length = surface_roles[k] != ColumnRole::sxx;
            if (!c.name.unit && c.name.unread.empty()) {
                c.factor = (length ? found_.x : found_.p).factor;
                continue;
            }
            convert(c, length, header_[c.index].text);
        }
    }
    [[nodiscard]] std::string column_text(const UsedColumn& c) const {
        return fmt::format("column {}", c.index + 1) +
               (c.index < header_.size() ? " (" + printable(header_[c.index].text) + ")" : "");
    }

    [[nodiscard]] UsedColumn column(ColumnRole role, const char* key,
                                    const std::map<ColumnRole, Found>& roles, std::size_t usual) {
        if (const auto choice = reading_.columns.find(key); choice != reading_.columns.end()) {
            return chosen(choice->second, key);
        }
        const auto found = roles.find(role);
        if (found != roles.end()) {
            if (found->second.twin) {
                text_.reject(header_line_,
                             fmt::format("columns {} and {} may both be {}",
                                         *found->second.index + 1, *found->second.twin + 1, key),
                             fmt::format("name the right one: --columns {0}={1} or {0}={2}", key,
                                         *found->second.index + 1, *found->second.twin + 1));
            }
            if (found->second.steps > 1) {
                found_.findings.push_back(
                    fmt::format("{} has {} steps: the last is compared", key, found->second.steps));
            }
            return at_column(*found->second.index);
        }
        if (text_.size == 2) {
            // The other column may be named, or chosen.
            const auto other =
                roles.find(role == ColumnRole::place ? ColumnRole::pressure : ColumnRole::place);
            std::size_t index = usual;
            if (other != roles.end() && other->second.index) {
                index = 1 - *other->second.index;
            }
            found_.findings.push_back(fmt::format(
                "{} is taken to be column {}, because no column has its name", key, index + 1));
            return at_column(index);
        }
        text_.reject(
            header_line_,
            header_.empty()
                ? fmt::format("the rows have {} columns and no header names them", text_.size)
                : fmt::format("no column has the name {} or a usual name for it", key),
            header_.empty() ? "name the columns by --columns x=1,p=2" : proposal(key));
    }
    /// The columns of the header, to choose from.
    [[nodiscard]] std::string proposal(const char* key) const {
        constexpr std::size_t most = 12;
        std::string list;
        for (std::size_t i = 0; i < std::min(header_.size(), most); ++i) {
            list += fmt::format("{}{} ({})", i > 0 ? ", " : "", i + 1, printable(header_[i].text));
        }
        return fmt::format("give its number by --columns {}=N, one of {}{}", key, list,
                           header_.size() > most ? ", ..." : "");
    }
    [[nodiscard]] UsedColumn at_column(std::size_t index) const {
        return {index,
                index < header_.size() ? read_column_name(header_[index].text) : ColumnName{}};
    }
    [[nodiscard]] UsedColumn chosen(const std::string& choice, const char* key) const {
        const auto named = std::ranges::find(header_, choice, &Cell::text);
        if (named != header_.end()) {
            return at_column(static_cast<std::size_t>(named - header_.begin()));
        }
        const bool digits = choice.find_first_not_of("0123456789") == std::string::npos;
        const std::size_t number = digits && choice.size() < 6 ? std::stoul(choice) : 0;
        if (number >= 1 && number <= text_.size) {
            return at_column(number - 1);
        }
        for (std::size_t i = 0; i < header_.size(); ++i) {
            if (read_column_name(header_[i].text).plain == read_column_name(choice).plain) {
                return at_column(i);
            }
        }
        throw InputError(
            fmt::format("--columns {}={}: {} has no such column", key, choice, text_.file),
            fmt::format("give a number from 1 to {}, or a name of its header", text_.size));
    }

    /// Finds units after names, or in a row of their own.
    void find_units() {
        for (std::size_t i = 0; i < text_.first_row; ++i) {
            const std::string line = without_comment_mark(text_.lines[i]);
            const auto cells = cells_in(line);
            if (text_.lines[i].comment && lower_case(line).find("unit") != std::string::npos) {
                found_.findings.push_back(fmt::format(
                    "line {} is a comment: units in it are not read; write them after the names",
                    text_.lines[i].number));
            }
            if (cells.size() == text_.size && all_units(cells)) {
                for (UsedColumn* c : {&found_.x, &found_.p}) {
                    const std::string_view text = without_brackets(cells[c->index]);
                    c->name.unit = c->name.unit ? c->name.unit : scene::unit_named(text);
                    c->name.unread = scene::resembles_unit(text) ? text : c->name.unread;
                }
            }
        }
        convert(found_.x, true, "x");
        convert(found_.p, false, "p");
    }
    /// `length`: the column has lengths, else pressures.
    void convert(UsedColumn& c, bool length, const std::string& key) {
        const scene::Units units = reading_.units.value_or(scene::Units{});
        const auto& wanted = length ? units.length : units.pressure;
        const auto& scale = length ? reading_.x_scale : reading_.p_scale;
        const auto& unit = c.name.unit;
        if (scale) {
            c.factor = *scale;
            found_.findings.push_back(fmt::format("{} is multiplied by {}, as --scale states", key,
                                                  exact_text(c.factor)));
            return;
        }
        if (!c.name.unread.empty() && wanted) {
            text_.reject(
                header_line_,
                fmt::format("'{}', the unit of {}, is not known", printable(c.name.unread), key),
                fmt::format("write one such as mm, um or in, kPa, MPa, psi or N/mm^2, or give the "
                            "factor to the unit of the scene: --scale {}",
                            length ? "x=25.4" : "p=1000"));
        }
        if (!c.name.unread.empty()) {
            found_.findings.push_back(fmt::format(
                "'{}' after the name of {} is not a known unit: its numbers are used unchanged",
                printable(c.name.unread), key));
        }
        if (!unit) {
            return;
        }
        if (unit->dimension !=
            (length ? scene::Unit::Dimension::length : scene::Unit::Dimension::pressure)) {
            text_.reject(header_line_,
                         fmt::format("{} is in {}, which is not a unit of it", key, unit->name),
                         "name the right column by --columns, or the factor by --scale");
        }
        if (!wanted) {
            found_.findings.push_back(fmt::format("the file has {} in {}, and the scene states no "
                                                  "units: its numbers are used unchanged",
                                                  key, unit->name));
            return;
        }
        c.factor = unit->factor / wanted->factor;
        if (c.factor != 1) {
            found_.findings.push_back(
                fmt::format("{} is converted from {} to {}", key, unit->name, wanted->name));
        }
    }

    const ResultText& text_;
    const ResultReading& reading_;
    TableHeader found_;
    std::vector<Cell> header_;
    std::size_t header_line_ = 0;
    std::optional<std::size_t> near_header_; ///< as many cells, but unknown names
};

} // namespace

TableHeader read_header(const ResultText& text, const ResultReading& reading) {
    return HeaderReader(text, reading).read();
}

} // namespace edgeproof::comparison
