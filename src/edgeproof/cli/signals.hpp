// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace edgeproof::cli {

/// Replaces standard streams that the caller has closed, so that no file opened later takes their
/// place: reads and writes on such a stream fail. Must be called first.
void open_standard_streams();

/// After this call SIGINT, SIGTERM and SIGHUP (unless it is ignored, as by nohup) end the program
/// in at most two seconds. They request an interruption, which the work notices at its next check
/// (precision/interruption.hpp). If there is no check within a second, or at a second signal, the
/// process ends at once. In both cases child processes are ended, temporary files are removed, and
/// the exit status is 128 plus the signal's number. Must be called before any thread is started:
/// the signals are blocked in all threads, and one thread waits for them.
void take_signals();

/// After this call an abort in a library (GMP without memory, MPFR, FLINT) or an uncaught exception
/// ends the program with one line and exit status 2.
void take_aborts();

/// Writes the line with the reason for the program's end to standard error. Does not return if a
/// second signal has already written its own line and ends the process.
void say_at_the_end(const std::string& line);

/// Returns the exit status of an interrupted program: 130 for SIGINT, 143 for SIGTERM.
[[nodiscard]] int interrupted_status();

} // namespace edgeproof::cli
