// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>

namespace edgeproof::report {

/// Somebody else's text, to be shown in a line: control characters (C0, DEL, C1, line ends too) and
/// bytes that are no UTF-8 as \xNN, so that none of them acts on a terminal, ends a line or cuts a
/// text off.
[[nodiscard]] std::string visible_text(std::string_view text);

} // namespace edgeproof::report
