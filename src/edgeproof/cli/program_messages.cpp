// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/program_messages.hpp"

#include <algorithm>
#include <cstdio>

namespace edgeproof::cli {

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
