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

struct Answer {
    enum class State { number, missing, nan, infinite, garbage, died };
    State state = State::missing;
    Rational value;       ///< the exact value of the text, for State::number
    std::string text;     ///< as written; for State::died how the program ended on this question
    std::size_t line = 0; ///< in the file of answers; 0: there is no row
};

/// Reads a number written by a program (number_text.hpp has the grammar): a decimal, with E or D
/// for the exponent, or a hexadecimal float; "nan", "inf", nothing, or garbage. Never throws.
[[nodiscard]] Answer read_answer(std::string_view given);

/// Answers with their questions, and the faults of the whole set.
struct Answers {
    Questions questions;
    std::vector<Answer> given; ///< one per question
    /// Rows without a question, or answered twice: one sentence each, with file and line.
    std::vector<std::string> faults;
    std::size_t out_of_order = 0; ///< rows after one that was asked later; not a fault
};

/// The columns of every file of answers.
struct AnswerColumns {
    std::size_t id;
    std::size_t value;
};

/// Reads answers that repeat the questions (the columns of `edgeproof points` and `value`), block
/// by block: each answers the question in its own row. Rows that cannot be read are faults. If the
/// separator is not a comma, numbers may have a decimal comma. Only 16 bytes per row are kept, to
/// find ids that occur twice.
class AnswerReader {
public:
    /// `head`: header and notes, to which `next_row` may add; `next_row` returns the next row, if
    /// there is one. `known_twice`: lines of ids that occur twice, found in an earlier reading.
    /// Throws InputError if there is no column id, value or quantity, and if two columns have the
    /// same name.
    AnswerReader(const io::Csv& head, std::function<bool(io::Csv::Row&)> next_row,
                 std::set<std::size_t> known_twice = {});
    /// Reads the next answers, `most` of them unless the file ends; returns false after the last.
    /// If answers are missing according to the note `questions:`, the last block has a fault.
    /// Throws InputError for a row whose parameters are not a valid contact.
    [[nodiscard]] bool next(Answers& block, std::size_t most);
    [[nodiscard]] bool ended() const { return done_; }
    /// Lines whose ids (almost certainly) occur more than once. If there are any, the file is read
    /// again with them as `known_twice`; then the rows after the first of an id are faults.
    [[nodiscard]] std::set<std::size_t> maybe_twice();

private:
    [[nodiscard]] bool is_first(const std::string& id, std::size_t line,
                                std::vector<std::string>& faults);
    void add_missing(std::vector<std::string>& faults) const;

    const io::Csv& head_;
    std::function<bool(io::Csv::Row&)> next_row_;
    AnswerColumns columns_;
    std::set<std::size_t> known_twice_;
    std::map<std::string, std::size_t> lines_;               ///< of the ids in known_twice_
    std::vector<std::pair<std::uint64_t, std::size_t>> ids_; ///< hash and line of the other ids
    io::Csv::Row row_;
    std::size_t answered_ = 0;
    bool done_ = false;
};

[[nodiscard]] Answers echoed_answers(const io::Csv& csv);

/// Compares the answers with the questions: ids that were not asked, are missing or occur twice,
/// and rows that repeat a different question or contact are faults. Rows may have any order, and
/// may repeat the question or have only id and value.
[[nodiscard]] Answers answers_to(const Questions& asked, const io::Csv& csv);

} // namespace edgeproof::conformance
