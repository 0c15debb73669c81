// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/enclosure/ball_extent.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "tests/contact/scenes.hpp"

#include <map>
#include <memory>
#include <string>

/// Extents by enclosures.
namespace edgeproof::scenes {

struct AskedExtent {
    Contact contact;
    Edge edge;
    std::size_t n;
    std::string tolerance;
    ExtentRange range = {};
};

template <class C>
[[nodiscard]] EnclosedExtents enclosed(const AskedExtent& asked, long bits = 400) {
    std::map<long, std::unique_ptr<C>> made;
    BallExtentSearch search(
        [&](long b) -> const ProvedContact& {
            auto& slot = made[b];
            if (!slot) {
                slot = std::make_unique<C>(asked.contact.profile, asked.contact.modulus,
                                           asked.contact.load, b);
            }
            return *slot;
        },
        asked.edge, asked.n, exact(asked.tolerance), asked.range);
    return search.at(bits);
}

} // namespace edgeproof::scenes
