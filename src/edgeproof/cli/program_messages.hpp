// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <string_view>

namespace edgeproof::cli {

/// Copies the standard error of programs that are run to ours as it arrives, up to most_bytes in
/// all; then one line states that the rest is left out.
class ProgramMessages {
public:
    static constexpr std::size_t most_bytes = 65'536;
    void operator()(std::string_view text);

private:
    std::size_t shown_ = 0;
    bool cut_ = false;
};

} // namespace edgeproof::cli
