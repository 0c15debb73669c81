// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/answers.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/text.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>

namespace edgeproof {
namespace {

constexpr std::size_t longest_shown = 40;

std::string lower(std::string_view text) {
    std::string out(text);
    std::transform(out.begin(), out.end(), out.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return out;
}

bool is_hexadecimal(const std::string& text) {
    const std::size_t at = text.starts_with('-') ? 1 : 0;
    return text.compare(at, 2, "0x") == 0 &&
           text.find_first_not_of("0123456789abcdef.px+-", at) == std::string::npos;
}

/// Reads rows into questions; equal parameters make one contact.
class Echo {
public:
    Echo(const Csv& csv, Questions& questions) : csv_(csv), to_(questions) {
        for (const std::string_view key : parameter_keys()) {
            // P, M and alpha are parameters here; as quantities they stand in their own column.
            if (const auto at = csv.column(key)) {
                keys_.emplace_back(std::string(key), *at);
            }
        }
        quantity_ = csv.column("quantity");
        edge_ = csv.column("edge");
        u_ = csv.column("u");
        tolerance_ = csv.column("tolerance");
    }
    [[nodiscard]] bool possible() const { return quantity_ && !keys_.empty(); }

    [[nodiscard]] Question read(const Csv::Row& row, const std::string& id) {
        Question q;
        q.id = id;
        q.line = row.line;
        const auto wanted = wanted_named(row.cells[*quantity_]);
        if (!wanted) {
            reject(row, "unknown quantity '" + row.cells[*quantity_] + "'",
                   "keep the question's cells as they are and add the value");
        }
        q.wanted = *wanted;
        q.contact = contact_of(row);
        check_askable(to_.contacts[q.contact], q.wanted, csv_.file, row.line);
        if (q.wanted.at_edge()) {
            const std::string edge = edge_ ? row.cells[*edge_] : "";
            if (edge != "right" && edge != "left") {
                reject(row, "there is no edge '" + edge + "'", "write right or left");
            }
            q.edge = edge == "right" ? Edge::right : Edge::left;
        }
        if (q.wanted.at_point()) {
            q.u = point_of(row);
        }
        if (q.wanted.of_terms()) {
            try {
                q.tolerance = parse_tolerance(tolerance_ ? row.cells[*tolerance_] : "");
            } catch (const InputError& error) {
                reject(row, error.problem(), "repeat the tolerance of the question");
            }
        }
        return q;
    }

private:
    [[noreturn]] void reject(const Csv::Row& row, const std::string& problem,
                             const std::string& instead) const {
        throw InputError(problem, instead).at(csv_.file, row.line);
    }
    [[nodiscard]] std::size_t contact_of(const Csv::Row& row) {
        std::string all;
        std::vector<Parameter> parameters;
        for (const auto& [key, at] : keys_) {
            all += row.cells[at] + "\n";
            if (!row.cells[at].empty()) {
                parameters.push_back({key, row.cells[at], row.line});
            }
        }
        const auto [found, is_new] = known_.emplace(all, to_.contacts.size());
        if (is_new) {
            to_.contacts.push_back(make_asked_contact(std::move(parameters), csv_.file, row.line));
        }
        return found->second;
    }
    [[nodiscard]] Exact point_of(const Csv::Row& row) const {
        const std::string text = u_ ? row.cells[*u_] : "";
        try {
            Exact u = Exact::parse(text);
            if (u.sign() > 0) {
                return u;
            }
        } catch (const Error& error) {
            reject(row, "u = '" + text + "' is no number", "repeat the u of the question");
        }
        reject(row, "u = " + text + " is not inside the contact",
               "give distances from the edge, 0 < u < a + b");
    }

    const Csv& csv_;
    Questions& to_;
    std::vector<std::pair<std::string, std::size_t>> keys_;
    std::optional<std::size_t> quantity_;
    std::optional<std::size_t> edge_;
    std::optional<std::size_t> u_;
    std::optional<std::size_t> tolerance_;
    std::map<std::string, std::size_t> known_;
};

std::string place(const Csv& csv, std::size_t line) {
    return csv.file + ":" + std::to_string(line) + ": ";
}

/// The columns that every file of answers has.
struct Columns {
    std::size_t id;
    std::size_t value;
};
Columns columns_of(const Csv& csv) {
    const auto id = csv.column("id");
    const auto value = csv.column("value");
    if (!id || !value) {
        throw InputError(std::string("there is no column ") + (id ? "value" : "id"),
                         "answer the questions of `edgeproof points` and add a column value")
            .at(csv.file, csv.header.line);
    }
    return {*id, *value};
}

/// A row of as many cells as the header has, or a fault.
bool whole(const Csv& csv, const Csv::Row& row, std::vector<std::string>& faults) {
    const std::size_t needed = csv.header.cells.size();
    if (row.cells.size() == needed) {
        return true;
    }
    const std::string begins = row.cells.front().substr(0, longest_shown);
    faults.push_back(place(csv, row.line) + "garbage: " + std::to_string(row.cells.size()) +
                     " cells, not " + std::to_string(needed) + ": \"" + begins + "\"");
    return false;
}

/// But for the rounding of u, in single precision at worst.
bool same_question(const Question& echoed, const Question& asked) {
    constexpr double rounding = 1e-6;
    const double u = asked.u ? asked.u->to<double>() : 0;
    return echoed.wanted == asked.wanted && echoed.edge == asked.edge &&
           (u == 0 || std::abs(echoed.u->to<double>() / u - 1) <= rounding);
}

} // namespace

Answer read_answer(std::string_view given) {
    Answer answer;
    answer.text = std::string(given);
    std::string text = lower(given);
    if (text.starts_with('+')) {
        text.erase(0, 1);
    }
    const std::string unsigned_text = text.starts_with('-') ? text.substr(1) : text;
    if (text.empty()) {
        answer.state = Answer::State::missing;
    } else if (unsigned_text.starts_with("nan")) {
        answer.state = Answer::State::nan;
    } else if (unsigned_text == "inf" || unsigned_text == "infinity") {
        answer.state = Answer::State::infinite;
    } else if (is_hexadecimal(text)) {
        char* end = nullptr;
        const double x = std::strtod(text.c_str(), &end);
        const bool read = *end == '\0' && std::isfinite(x);
        answer.state = read ? Answer::State::number : Answer::State::garbage;
        answer.value = read ? Rational(x) : Rational(0);
    } else {
        std::replace(text.begin(), text.end(), 'd', 'e');
        answer.state = Answer::State::garbage;
        try {
            if (text.find('/') == std::string::npos) {
                answer.value = parse_decimal(text);
                answer.state = Answer::State::number;
            }
        } catch (const InputError&) { // garbage then
        }
    }
    return answer;
}

Answers echoed_answers(const Csv& csv) {
    const Columns columns = columns_of(csv);
    Answers answers;
    answers.questions.file = csv.file;
    Echo echo(csv, answers.questions);
    if (!echo.possible()) {
        throw InputError("the answers do not say what they answer",
                         "keep the columns of `edgeproof points`, or give --recipe RECIPE.toml")
            .at(csv.file, csv.header.line);
    }
    std::map<std::string, std::size_t> lines;
    for (const Csv::Row& row : csv.rows) {
        if (!whole(csv, row, answers.faults)) {
            continue;
        }
        const std::string& id = row.cells[columns.id];
        const auto [first, is_new] = lines.emplace(id, row.line);
        if (!is_new) {
            answers.faults.push_back(place(csv, row.line) + id +
                                     " is answered twice, first in line " +
                                     std::to_string(first->second));
            continue;
        }
        answers.questions.list.push_back(echo.read(row, id));
        answers.given.push_back(read_answer(row.cells[columns.value]));
        answers.given.back().line = row.line;
    }
    constexpr std::string_view note_begins = "questions: ";
    for (const std::string& note : csv.notes) {
        std::size_t asked = 0;
        const char* const end = note.data() + note.size();
        if (note.starts_with(note_begins) &&
            std::from_chars(note.data() + note_begins.size(), end, asked).ec == std::errc{} &&
            asked > lines.size()) {
            answers.faults.push_back(place(csv, csv.header.line) + std::to_string(asked) +
                                     " questions were asked and " + std::to_string(lines.size()) +
                                     " are answered (--recipe says which are missing)");
        }
    }
    return answers;
}

Answers answers_to(const Questions& asked, const Csv& csv) {
    const Columns columns = columns_of(csv);
    Answers answers;
    answers.questions = asked;
    answers.given.resize(asked.list.size());
    answers.questions.file = csv.file;
    Echo echo(csv, answers.questions);
    std::map<std::string_view, std::size_t> index;
    for (std::size_t i = 0; i < asked.list.size(); ++i) {
        index.emplace(asked.list[i].id, i);
    }
    std::size_t next = 0;
    for (const Csv::Row& row : csv.rows) {
        if (!whole(csv, row, answers.faults)) {
            continue;
        }
        const std::string& id = row.cells[columns.id];
        const auto found = index.find(id);
        if (found == index.end()) {
            answers.faults.push_back(place(csv, row.line) + "'" + id.substr(0, longest_shown) +
                                     "' was not asked");
            continue;
        }
        const std::size_t i = found->second;
        Answer& answer = answers.given[i];
        if (answer.line != 0) {
            answers.faults.push_back(place(csv, row.line) + id +
                                     " is answered twice, first in line " +
                                     std::to_string(answer.line));
            continue;
        }
        if (i < next) {
            answers.faults.push_back(place(csv, row.line) + id + " is out of order");
        }
        next = std::max(next, i + 1);
        answer = read_answer(row.cells[columns.value]);
        answer.line = row.line;
        if (echo.possible()) {
            answers.questions.list[i] = echo.read(row, id);
            if (!same_question(answers.questions.list[i], asked.list[i])) {
                answers.faults.push_back(place(csv, row.line) + id +
                                         " repeats another quantity, edge or u than was asked");
            }
        }
    }
    return answers;
}

} // namespace edgeproof
