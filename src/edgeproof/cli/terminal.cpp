// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/cli.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace edgeproof::cli {

Progress::Progress(std::string what)
    : what_(std::move(what)), terminal_(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (terminal_ && shown_ > 0) {
        std::fputs("\r\033[K", stderr);
    }
}

void Progress::operator()(std::size_t done, std::size_t total) {
    if (!terminal_) {
        return;
    }
    shown_ = done;
    std::fprintf(stderr, "\r\033[K%s %zu of %zu", what_.c_str(), done, total);
    std::fflush(stderr);
}

bool stdout_is_terminal() { return ::isatty(STDOUT_FILENO) == 1; }

std::size_t terminal_width() {
    winsize size{};
    if (stdout_is_terminal() && ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 &&
        size.ws_col >= 60) {
        return size.ws_col;
    }
    return 100;
}

} // namespace edgeproof::cli
