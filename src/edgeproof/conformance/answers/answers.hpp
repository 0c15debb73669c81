// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/conformance/questions/question.hpp"
#include "edgeproof/io/foreign_text.hpp"

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

/// Reads a number written by a program (io/foreign_text.hpp has the grammar): a decimal, with E or
/// D for the exponent, or a hexadecimal float; "nan", "inf", nothing, or garbage. Never throws.
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

/// The position of a question in the contact. L = a + b.
enum class Regime {
    near_edge,   ///< within L/1000 of either edge
    apex,        ///< within L/100 of the minimum of the profile
    knot,        ///< within L/100 of another place where two pieces of g' meet
    far_field,   ///< any other point closer to the other edge than to its own
    interior,    ///< any other point
    coefficient, ///< c_k, s_k, extent_k, measure_k
    contact,     ///< a, b, P, M, alpha
    outside      ///< a point outside the contact, which has no reference
};
[[nodiscard]] std::string regime_name(Regime regime);

/// The accuracy required of answers; both may be given. Without a target, an answer needs 12
/// digits, or as many as the conditioning of its question allows in double precision, so that a
/// wrong number never passes.
struct Target {
    static constexpr double default_digits = 12;
    std::optional<double> digits; ///< |answer/exact - 1| <= 10^-digits
    std::optional<double> ulps;   ///< the largest |answer - exact|, in binary64 ulps
    bool conditioned = false;     ///< an error explained by the conditioning passes as well

    [[nodiscard]] bool stated() const { return digits || ulps; }
    [[nodiscard]] bool forgives() const { return conditioned || !stated(); }
};

/// The distances of the place of a question from places where differences of lengths cancel, over a
/// + b; 0: it has no such place.
struct Nearness {
    double edge = 0;         ///< of a point: u
    double other_edge = 0;   ///< of a point: a + b - u
    double apex = 0;         ///< of a point: the distance from the minimum of the profile
    double knot = 0;         ///< the same, or from the nearest knot if that is less
    double edge_to_knot = 0; ///< of another question: from an edge to the nearest knot
};

/// One answer compared with its reference.
struct CaseAgreement {
    Regime regime = Regime::interior;
    Nearness nearness = {};
    double scale = 0;    ///< of the errors, if the reference is zero
    double digits = 0;   ///< -log10|answer/exact - 1|, from 0 to the reference's digits
    double ulps = 0;     ///< |answer - exact| in units in the last place of the binary64 of exact
    double relative = 0; ///< |answer/exact - 1|
    bool within = false; ///< the target is met, without regard to conditioning
    bool pass = false;
    std::optional<Conditioning> conditioning = {};
    bool explained = false; ///< the error is at most 8 times the change due to the conditioning
    std::string reference;  ///< as printed in the report
    /// The reason why there is no reference; then nothing is compared, and the case does not pass.
    std::string no_reference = {};
};

struct Agreements {
    std::vector<CaseAgreement> cases;  ///< one per question
    std::vector<Reference> references; ///< one per question; empty if there is none
    std::size_t estimates = 0;         ///< references without a proved bound
    unsigned digits = 0;               ///< of the references
};

inline constexpr std::size_t most_conditioned = 5000;

/// Computes each reference exactly for the numbers in the answer's row, and compares. For a
/// reference that is zero, the scale of the error follows from P and L = a + b: P for a force, P L
/// for M, P/L for a traction, P/L^(k + 3/2) for c_k, and so on. The conditioning is computed for
/// every case if there are at most most_conditioned, otherwise only for those that miss the target.
/// A point outside the contact has no reference. If no case has a reference, or a contact is
/// invalid, throws as references() does.
[[nodiscard]] Agreements compare(const Answers& answers, const Target& target,
                                 ReferenceOptions options);

/// Compares other answers to the same questions, with the references of an earlier comparison. The
/// conditioning is that of the earlier one.
[[nodiscard]] Agreements compare_again(const Answers& answers, const Target& target,
                                       const Agreements& known);

} // namespace edgeproof::conformance
