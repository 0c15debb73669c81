// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>

namespace edgeproof::io {

/// Returns SHA-256 (FIPS 180-4) in lower-case hexadecimal, as `sha256sum` prints it.
[[nodiscard]] std::string sha256(std::string_view text);

} // namespace edgeproof::io
