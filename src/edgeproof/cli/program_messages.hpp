// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <string_view>

namespace edgeproof::cli {

/// What programs that are run say on their standard error, on ours as it comes, and no more than
/// most_bytes of it in all: then one line says that the rest is left out.
class ProgramMessages {
public:
    static constexpr std::size_t most_bytes = 65'536;
    void operator()(std::string_view text);

private:
    std::size_t shown_ = 0;
    bool cut_ = false;
};

} // namespace edgeproof::cli
