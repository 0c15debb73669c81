// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/questions/question.hpp"
#include "edgeproof/io/csv.hpp"

#include <cstddef>
#include <functional>
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

/// Reads a number written by a program (io/number_text.hpp has the grammar): a decimal, with E or D
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

/// Assigns the answers to the questions by their ids, in any order; other columns are not read. Ids
/// that were not asked or occur twice are faults.
[[nodiscard]] Answers answers_to(const Questions& asked, const io::Csv& csv);

struct ProgramDriverOptions {
    std::string command;     ///< for the shell
    double seconds = 600;    ///< the longest time of one run
    std::size_t batch = 500; ///< questions per run
    std::size_t runs = 200;  ///< the most starts of the program
    /// Called with the number of finished questions, and their total.
    std::function<void(std::size_t, std::size_t)> progress = {};
    std::function<std::string(const Questions&)> write_csv = {};
    /// Called with the text that the program writes to its standard error.
    std::function<void(std::string_view)> said = {};
};

/// Returns the answers of a program, however it behaves; only id and value of each row are read.
/// The program is started for each batch. If a run fails, its answers so far are kept, except for
/// an incomplete last line. The remaining questions are asked again in smaller batches, down to
/// one, whether or not the program had written its answers when it ended. So each question that
/// crashes the program is found and becomes State::died, without loss of the other answers. The
/// driver gives up after three single questions that crashed it without any answer so far, and
/// after options.runs; the remaining answers are missing, and a fault reports it. If the program
/// answers nothing, a fault quotes the begin of its standard error. Output is bounded
/// by the number of questions of a run. Throws Interrupted; Error if no program can be started at
/// all.
[[nodiscard]] Answers ask_program_in_batches(const Questions& asked,
                                             const ProgramDriverOptions& options);

} // namespace edgeproof::conformance
