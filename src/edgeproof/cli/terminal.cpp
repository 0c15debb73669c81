// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/cli/cli.hpp"

#include <fmt/format.h>

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace edgeproof::cli {

namespace {
constexpr std::chrono::milliseconds shown_every{100};
constexpr std::chrono::milliseconds shown_after{500};
std::atomic<bool> progress_on_screen{false};

/// The width of a terminal in columns; 0 if it is not known.
std::size_t columns_of(int file) {
    winsize size{};
    return ::isatty(file) == 1 && ::ioctl(file, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

/// True if the terminal obeys escape sequences.
bool obeys_escapes(int file) {
    const char* kind = std::getenv("TERM");
    return ::isatty(file) == 1 && kind != nullptr && *kind != '\0' &&
           std::string_view(kind) != "dumb";
}
} // namespace

Progress::Progress(std::string what)
    : what_(std::move(what)), terminal_(obeys_escapes(STDERR_FILENO)) {}

Progress::~Progress() { wipe_progress(); }

void wipe_progress() {
    if (progress_on_screen.exchange(false)) {
        std::fputs("\r\033[K", stderr);
        std::fflush(stderr);
    }
}

void Progress::operator()(std::size_t done, std::size_t total) {
    if (!terminal_) {
        return;
    }
    const std::lock_guard lock(showing_);
    const auto now = std::chrono::steady_clock::now();
    if (!called_) {
        called_ = true;
        begun_ = now;
        first_ = done;
    }
    if (now - begun_ < shown_after || (done < total && now - last_ < shown_every)) {
        return;
    }
    last_ = now;
    std::string line = fmt::format("{} {} of {}", what_, done, total);
    const double seconds = std::chrono::duration<double>(now - begun_).count();
    if (seconds > 1 && done > first_) {
        const double rate = static_cast<double>(done - first_) / seconds;
        line += fmt::format(", {:.3g} a second, {:.0f} s left", rate,
                            static_cast<double>(total - done) / rate);
    }
    // A line that is wrapped could not be wiped.
    const std::size_t columns = columns_of(STDERR_FILENO);
    if (columns > 0 && line.size() >= columns) {
        line.resize(columns - 1);
    }
    progress_on_screen = true;
    std::fprintf(stderr, "\r\033[K%s", line.c_str());
    std::fflush(stderr);
}

bool stdout_takes_colour() {
    const char* refused = std::getenv("NO_COLOR");
    return obeys_escapes(STDOUT_FILENO) && (refused == nullptr || *refused == '\0');
}

std::size_t terminal_width() {
    const std::size_t columns = columns_of(STDOUT_FILENO);
    return columns >= 60 ? columns : 100;
}

std::size_t width_to_wrap_at() { return ::isatty(STDOUT_FILENO) == 1 ? terminal_width() : 0; }

void ProgramMessages::operator()(std::string_view text) {
    const std::string_view now = text.substr(0, std::min(text.size(), most_bytes - shown_));
    std::fwrite(now.data(), 1, now.size(), stderr);
    shown_ += now.size();
    if (now.size() < text.size() && !cut_) {
        cut_ = true;
        std::fprintf(stderr, "\nedgeproof: the program's messages beyond %zu bytes are left out\n",
                     most_bytes);
    }
    std::fflush(stderr);
}

} // namespace edgeproof::cli
