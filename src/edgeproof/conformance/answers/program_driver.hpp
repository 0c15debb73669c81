// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/answers/answers.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace edgeproof::conformance {

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
