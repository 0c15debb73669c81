// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/self_test.hpp"

#include <string>

namespace edgeproof::report {

/// A table in Markdown, a row a mistake and a column a noise; then what was missed, and the sums.
[[nodiscard]] std::string self_test_text(const comparison::SelfTest& test);

} // namespace edgeproof::report
