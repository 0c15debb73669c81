// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"

#include <map>
#include <string>

namespace edgeproof::test {

/// Names with values in balls, for formula::evaluate.
struct BallValues : formula::BallConstants {
    std::map<std::string, Ball, std::less<>> values{};
    [[nodiscard]] Ball symbol(std::string_view name) const {
        const auto it = values.find(name);
        return it != values.end() ? it->second : BallConstants::symbol(name);
    }
};

} // namespace edgeproof::test
