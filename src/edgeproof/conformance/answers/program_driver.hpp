// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/answers/answers.hpp"

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <string_view>

namespace edgeproof::conformance {

/// In what a program is spoken to, and answers: CSV with a header line, or a JSON object a line.
enum class Lines { csv, json };

struct ProgramDriverOptions {
    std::string command; ///< of the shell
    Lines lines = Lines::csv;
    double seconds = 600;    ///< that one run may take
    std::size_t batch = 500; ///< questions that one run is asked
    std::size_t runs = 200;  ///< the program is started at most so often
    /// Questions done with, of how many.
    std::function<void(std::size_t, std::size_t)> progress = {};
    /// The questions as text for Lines::csv.
    std::function<std::string(const Questions&)> write_csv = {};
    /// Is given what the program writes to its standard error.
    std::function<void(std::string_view)> said = {};
};

/// What a program answers, whatever it does; only id and value of each row are read. It is started
/// for each batch. Where a run ends badly, what it answered until then counts, but for a line that
/// it did not end, and the rest is asked again in smaller batches, down to one, whether or not its
/// answers had been written when it ended: so each question that ends the program is found, and is
/// State::died, and none of the others suffers. After three single questions that ended it where
/// none was ever answered it is given up, as it is after options.runs: what is left is missing, and
/// a fault says so. What is kept of a run is bounded by the questions it is asked. Throws
/// Interrupted; Error where no program can be started at all.
[[nodiscard]] Answers ask_program_in_batches(const Questions& asked,
                                             const ProgramDriverOptions& options);

/// The questions as JSON lines: an object each, every value a string, empty ones left out.
[[nodiscard]] std::string json_lines(const Questions& questions);
/// JSON lines as rows of id and value, numbers with every digit as written (and Python's NaN and
/// Infinity); what is no such object, or has an id or a value twice, is a row of one cell.
[[nodiscard]] io::Csv
parse_json_lines(std::string_view text, const std::string& file,
                 std::size_t most_rows = std::numeric_limits<std::size_t>::max());

} // namespace edgeproof::conformance
