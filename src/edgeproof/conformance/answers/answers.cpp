// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/conformance/answers/answers.hpp"

#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/scene/input/scene_words.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>

namespace edgeproof::conformance {
namespace {

constexpr std::size_t longest_shown = 40;

/// Reads rows into questions; equal parameters make one contact.
class Echo {
public:
    Echo(const io::Csv& csv, Questions& questions) : csv_(csv), to_(questions) {
        for (const ParameterKey& key : parameter_keys()) {
            // P, M and alpha are parameters here; as quantities they are in the column quantity.
            if (const auto at = csv.column(key.name)) {
                keys_.emplace_back(std::string(key.name), *at);
            }
        }
    }
    [[nodiscard]] bool possible() const { return csv_.column("quantity") && !keys_.empty(); }

    [[nodiscard]] Question read(const io::Csv::Row& row, const std::string& id) {
        std::map<std::string, std::string> where;
        for (const char* const key : {"edge", "u", "body", "tolerance"}) {
            if (const std::string text = cell(row, key); !text.empty()) {
                where.emplace(key, text);
            }
        }
        where.emplace("at", cell(row, "x") + "," + cell(row, "z"));
        Question q = io::at_place(csv_.file, row.line, [&] {
            Question asked{scene::asked_value(cell(row, "quantity"), where, {}), id, 0, row.line};
            asked.place.reset();
            // A point outside the contact is a row without a reference, but not an error.
            asked.u = asked.at_point() ? std::optional(formula::Exact::parse(cell(row, "u")))
                                       : std::nullopt;
            return asked;
        });
        q.contact = contact_of(row);
        check_askable(to_.contacts[q.contact], q, csv_.file, row.line);
        return q;
    }

private:
    [[nodiscard]] std::size_t contact_of(const io::Csv::Row& row) {
        std::string all;
        for (const auto& [key, at] : keys_) {
            (all += row.cells[at]) += '\n';
        }
        const auto [found, is_new] = known_.emplace(std::move(all), to_.contacts.size());
        if (is_new) {
            std::vector<Parameter> parameters;
            for (const auto& [key, at] : keys_) {
                if (!row.cells[at].empty()) {
                    parameters.push_back({key, row.cells[at], row.line});
                }
            }
            to_.contacts.push_back(make_asked_contact(std::move(parameters), csv_.file, row.line));
        }
        return found->second;
    }
    /// The cell of a column; empty if there is no such column.
    [[nodiscard]] std::string cell(const io::Csv::Row& row, std::string_view name) const {
        const auto column = csv_.column(name);
        return column ? row.cells[*column] : "";
    }

    const io::Csv& csv_;
    Questions& to_;
    std::vector<std::pair<std::string, std::size_t>> keys_;
    std::map<std::string, std::size_t> known_; ///< by the cells of the parameters
};

std::string place(const io::Csv& csv, std::size_t line) {
    return csv.file + ":" + std::to_string(line) + ": ";
}

struct AnswerColumns {
    std::size_t id;
    std::size_t value;
};

AnswerColumns columns_of(const io::Csv& csv) {
    const auto id = csv.column("id");
    const auto value = csv.column("value");
    if (!id || !value) {
        throw InputError(std::string("there is no column ") + (id ? "value" : "id"),
                         "answer the questions of `edgeproof points` and add a column value; "
                         "commas, semicolons or tabs separate columns")
            .at(csv.file, csv.header.line);
    }
    std::set<std::string_view> names;
    for (const std::string& name : csv.header.cells) {
        if (!name.empty() && !names.insert(name).second) {
            throw InputError("two columns are called " + name.substr(0, longest_shown),
                             "give each column a name of its own")
                .at(csv.file, csv.header.line);
        }
    }
    return {*id, *value};
}

/// Returns the number of questions in a note "questions: N"; nothing for another note. Throws
/// InputError if N is not a whole number, since missing rows could then not be detected.
std::optional<std::size_t> asked_by_note(const io::Csv& csv, std::size_t i) {
    constexpr std::string_view begins = "questions:";
    const std::string& note = csv.notes[i];
    if (!note.starts_with(begins)) {
        return {};
    }
    const std::size_t from = std::min(note.find_first_not_of(" \t", begins.size()), note.size());
    const char* const end = note.data() + note.size();
    std::size_t asked = 0;
    const auto read = std::from_chars(note.data() + from, end, asked);
    if (read.ec != std::errc{} || read.ptr != end) {
        throw InputError("'# " + shortened(printable(note), longest_shown) +
                             "' gives no number of questions",
                         "write the line as `edgeproof points` does, such as # questions: 65")
            .at(csv.file, csv.note_lines[i]);
    }
    return asked;
}

/// True for a readable row with as many cells as the header; otherwise adds a fault.
bool whole(const io::Csv& csv, const io::Csv::Row& row, std::vector<std::string>& faults) {
    const std::size_t needed = csv.header.cells.size();
    if (row.fault.empty() && row.cells.size() == needed) {
        return true;
    }
    const bool commas = row.fault.empty() && csv.separator == ',' && row.cells.size() > needed;
    faults.push_back(place(csv, row.line) + "garbage: " +
                     (!row.fault.empty() ? row.fault
                                         : std::to_string(row.cells.size()) + " cells, not " +
                                               std::to_string(needed)) +
                     ": \"" + row.cells.front().substr(0, longest_shown) + "\"" +
                     (commas ? " (commas in numbers? write decimal points and no marks between "
                               "thousands, or separate by semicolons)"
                             : ""));
    return false;
}

/// Calls take(row, id, answer) for each whole row; it returns a fault, or an empty text. If the
/// separator is not a comma, decimal commas become points, except in ids.
template <class Take>
void read_rows(const io::Csv& csv, std::vector<std::string>& faults, const Take& take) {
    const AnswerColumns columns = columns_of(csv);
    for (io::Csv::Row row : csv.rows) {
        for (std::size_t i = 0; csv.separator != ',' && i < row.cells.size(); ++i) {
            if (i != columns.id) {
                row.cells[i] = io::with_decimal_point(row.cells[i]).value_or(row.cells[i]);
            }
        }
        if (!whole(csv, row, faults)) {
            continue;
        }
        Answer answer = read_answer(row.cells[columns.value]);
        answer.line = row.line;
        const std::string fault = take(row, row.cells[columns.id], std::move(answer));
        if (!fault.empty()) {
            faults.push_back(place(csv, row.line) + fault);
        }
    }
}

std::string answered_twice(const std::string& id, std::size_t first) {
    return id + " is answered twice, first in line " + std::to_string(first);
}

} // namespace

Answer read_answer(std::string_view given) {
    using enum Answer::State;
    io::WrittenNumber written = io::written_number(given);
    const Answer::State state = written.kind == io::WrittenNumber::Kind::number     ? number
                                : written.kind == io::WrittenNumber::Kind::nan      ? nan
                                : written.kind == io::WrittenNumber::Kind::infinite ? infinite
                                : given.empty()                                     ? missing
                                                                                    : garbage;
    return {state, std::move(written.value), std::string(given)};
}

Answers echoed_answers(const io::Csv& csv) {
    (void)columns_of(csv);
    Answers answers;
    answers.questions.file = csv.file;
    Echo echo(csv, answers.questions);
    if (!echo.possible()) {
        throw InputError("the answers do not state the questions that they answer",
                         "keep the columns of `edgeproof points`, or give --recipe RECIPE.toml")
            .at(csv.file, csv.header.line);
    }
    std::map<std::string, std::size_t> lines;
    read_rows(csv, answers.faults, [&](const auto& row, const auto& id, Answer answer) {
        const auto [first, is_new] = lines.emplace(id, row.line);
        if (!is_new) {
            return answered_twice(id, first->second);
        }
        answers.questions.list.push_back(echo.read(row, id));
        answers.given.push_back(std::move(answer));
        return std::string();
    });
    for (std::size_t i = 0; i < csv.notes.size(); ++i) {
        const auto asked = asked_by_note(csv, i);
        if (asked && *asked > lines.size()) {
            answers.faults.push_back(place(csv, csv.header.line) + std::to_string(*asked) +
                                     " questions were asked and " + std::to_string(lines.size()) +
                                     " are answered (--recipe lists those that are missing)");
        }
    }
    return answers;
}

Answers answers_to(const Questions& asked, const io::Csv& csv) {
    Answers answers{asked, {}, {}, 0};
    answers.given.resize(asked.list.size());
    answers.questions.file = csv.file;
    std::map<std::string_view, std::size_t> index;
    for (std::size_t i = 0; i < asked.list.size(); ++i) {
        index.emplace(asked.list[i].id, i);
    }
    std::size_t next = 0;
    read_rows(csv, answers.faults, [&](const auto&, const auto& id, Answer answer) {
        const auto found = index.find(id);
        if (found == index.end()) {
            return "'" + id.substr(0, longest_shown) + "' was not asked";
        }
        const std::size_t i = found->second;
        if (answers.given[i].line != 0) {
            return answered_twice(id, answers.given[i].line);
        }
        answers.out_of_order += i < next ? 1 : 0; // the id identifies the question
        next = std::max(next, i + 1);
        answers.given[i] = std::move(answer);
        return std::string();
    });
    return answers;
}

} // namespace edgeproof::conformance
