// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/questions/question.hpp"
#include "edgeproof/io/csv.hpp"

#include <cstddef>
#include <optional>
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

/// Reads answers that repeat the questions (the columns of `edgeproof points` and `value`): each
/// answers the question in its own row. Rows that cannot be read, and ids that occur twice, are
/// faults; so are missing answers, by the note `questions:`. If the separator is not a comma,
/// numbers may have a decimal comma. Throws InputError if there is no column id, value or quantity,
/// if two columns have the same name, and for a row whose parameters are not a valid contact.
[[nodiscard]] Answers echoed_answers(const io::Csv& csv);

/// Compares the answers with the questions: ids that were not asked, are missing or occur twice,
/// and rows that repeat a different question or contact are faults. Rows may have any order, and
/// may repeat the question or have only id and value.
[[nodiscard]] Answers answers_to(const Questions& asked, const io::Csv& csv);

} // namespace edgeproof::conformance
