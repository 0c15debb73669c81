// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace edgeproof::parallel {

/// Processor time of this thread so far, in seconds.
[[nodiscard]] double thread_seconds();

} // namespace edgeproof::parallel
