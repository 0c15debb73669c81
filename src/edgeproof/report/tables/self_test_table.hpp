// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/self_test.hpp"

#include <string>

namespace edgeproof::report {

/// A Markdown table with a row per mistake and a column per noise level; then the misses and the
/// sums.
[[nodiscard]] std::string self_test_text(const comparison::SelfTest& test);

} // namespace edgeproof::report
