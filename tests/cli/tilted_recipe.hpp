// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/namespaces.hpp"
#pragma once
#include <string>

namespace edgeproof::test {

/// Returns a recipe of contacts with an unknown left edge, each of which takes a few milliseconds.
inline std::string tilted_recipe(int contacts, int digits) {
    std::string grid;
    for (int i = 1; i <= contacts; ++i) {
        grid += (i == 1 ? "\"" : ", \"") + std::to_string(i) + "/7\"";
    }
    return "digits = " + std::to_string(digits) +
           "\n[scenes.w]\nedges = [\"right\", \"left\"]\nu = [\"1e-9\", \"1/9\"]\n"
           "quantities = [\"p\", \"c_0\", \"c_1\", \"P\", \"M\", \"b\"]\n[scenes.w.profile]\n"
           "kind = \"tilted-flat-and-rounded\"\nalpha = \"pi/64\"\nt = \"1/10\"\nR = \"1\"\n"
           "[scenes.w.load]\na = [" +
           grid + "]\ncontact_modulus = \"1\"\n";
}

} // namespace edgeproof::test
