// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace edgeproof::cli {

/// Sees that no file that is opened later becomes a standard stream that the caller has closed:
/// such a stream is one on which every read or write fails. To be called first.
void open_standard_streams();

/// From here on SIGINT, SIGTERM and SIGHUP (unless it is ignored, as by nohup) end the program in
/// two seconds at most, whatever it does: they request an interruption, which the work notices at
/// its next look (precision/interruption.hpp). Where it does not come to a look within a second, or
/// at a second signal, the process ends without it: children are ended, temporary files removed,
/// and the exit status is 128 plus the signal's number either way. To be called before any thread
/// is started: the signals are blocked in all of them, and one thread waits for them.
void take_signals();

/// From here on an abort in a library (GMP without memory, MPFR, FLINT) and an exception that
/// nobody caught end the program with one line and exit status 2.
void take_aborts();

/// Writes the one line that says why the program ends, to standard error. Does not return where a
/// second signal has had its line written already and ends the process.
void say_at_the_end(const std::string& line);

/// The exit status of an interrupted program: 130 for SIGINT, 143 for SIGTERM.
[[nodiscard]] int interrupted_status();

} // namespace edgeproof::cli
