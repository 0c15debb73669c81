// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/questions/question.hpp"
#include "edgeproof/io/csv.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgeproof::conformance {

/// One answer as it was given.
struct Answer {
    enum class State { number, missing, nan, infinite, garbage, died };
    State state = State::missing;
    Rational value;       ///< exactly what is written, for State::number
    std::string text;     ///< as written; for State::died how the program ended when asked it
    std::size_t line = 0; ///< of the answers; 0: there is no row
};

/// What a program wrote for a number (number_text.hpp has the grammar): a decimal, with E or D for
/// the exponent, or a hexadecimal float; "nan", "inf", nothing, or garbage. Never throws.
[[nodiscard]] Answer read_answer(std::string_view given);

/// Answers beside the questions that they answer, and what is wrong with them as a whole.
struct Answers {
    Questions questions;
    std::vector<Answer> given; ///< one a question
    /// Rows that answer nothing, or twice, a sentence each with file and line.
    std::vector<std::string> faults;
    std::size_t out_of_order = 0; ///< rows behind one that was asked later; no fault
};

/// The columns that every file of answers has.
struct AnswerColumns {
    std::size_t id;
    std::size_t value;
};

/// Answers that repeat the questions (the columns of `edgeproof points` and `value`), block by
/// block: each is taken to answer what its own row says. Rows that cannot be read are faults. Where
/// commas do not separate, numbers may have a decimal comma. Of what was read nothing is kept but
/// 16 bytes a row, by which ids that occur twice are found.
class AnswerReader {
public:
    /// `head`: header and notes, to which `next_row` may add; it gives the next row, if there is
    /// one. `known_twice`: lines among which an id occurs twice, as an earlier reading found.
    /// Throws InputError where there is no column id, value or quantity, and where two have one
    /// name.
    AnswerReader(const io::Csv& head, std::function<bool(io::Csv::Row&)> next_row,
                 std::set<std::size_t> known_twice = {});
    /// The next answers, `most` of them unless the file ends; false behind the last. What is
    /// missing by the note `questions:` is a fault of the last block. Throws InputError for a row
    /// whose parameters make no contact.
    [[nodiscard]] bool next(Answers& block, std::size_t most);
    [[nodiscard]] bool ended() const { return done_; }
    /// Lines of the rows read whose ids are, all but certainly, those of others: where there are
    /// any, read again with these known, and the rows behind the first of an id are faults.
    [[nodiscard]] std::set<std::size_t> maybe_twice();

private:
    [[nodiscard]] bool is_first(const std::string& id, std::size_t line,
                                std::vector<std::string>& faults);
    void add_missing(std::vector<std::string>& faults) const;

    const io::Csv& head_;
    std::function<bool(io::Csv::Row&)> next_row_;
    AnswerColumns columns_;
    std::set<std::size_t> known_twice_;
    std::map<std::string, std::size_t> lines_;               ///< of ids in those
    std::vector<std::pair<std::uint64_t, std::size_t>> ids_; ///< hash and line of the others
    io::Csv::Row row_;
    std::size_t answered_ = 0;
    bool done_ = false;
};

/// All of them at once.
[[nodiscard]] Answers echoed_answers(const io::Csv& csv);

/// The same held against what was asked: ids that were not asked, that are missing or twice, and
/// rows that repeat another question or contact than was asked are faults. Rows may stand in any
/// order, and repeat the question, or give id and value alone.
[[nodiscard]] Answers answers_to(const Questions& asked, const io::Csv& csv);

} // namespace edgeproof::conformance
