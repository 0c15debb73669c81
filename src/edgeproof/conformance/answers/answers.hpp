// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/questions/question.hpp"
#include "edgeproof/io/csv.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
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

/// Answers that repeat the questions (the columns of `edgeproof points` and `value`): each is taken
/// to answer what its own row says. Questions that are missing are told by the note `questions:`.
/// Rows that cannot be read are faults. Where commas do not separate, numbers may have a decimal
/// comma. Throws InputError where there is no column id, value or quantity, where two have one
/// name, and for a row whose parameters make no contact.
[[nodiscard]] Answers echoed_answers(const io::Csv& csv);

/// The same held against what was asked: ids that were not asked, that are missing or twice, and
/// rows that repeat another question or contact than was asked are faults. Rows may stand in any
/// order, and repeat the question, or give id and value alone.
[[nodiscard]] Answers answers_to(const Questions& asked, const io::Csv& csv);

} // namespace edgeproof::conformance
