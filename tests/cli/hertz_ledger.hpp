// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/namespaces.hpp"
#pragma once
#include <string>

/// A user's ledger about the Hertz pressure E* C sqrt(a^2 - x^2)/2 of the textbooks.
namespace edgeproof::test {

inline const std::string hertz_head = R"toml([ledger]
name = "own"
source = "a test"
[[family]]
name = "hertz"
profile = "power-law"
count = 3
points = 2
u = ["1e-12", "1/20", "1/5", "3/7"]
[family.parameters]
m = ["1"]
C = ["3/7", "1e-6"]
a = ["3/2", "0.02"]
Es = ["7/3"]
)toml";

inline std::string hertz_claim(const std::string& id, const std::string& says,
                               const std::string& more = "") {
    return "[[claim]]\nid = \"" + id + "\"\nkind = \"compare\"\nlines = [1, 2]\nprinted = '''" +
           says + "'''\nover = \"hertz\"\nof = \"p(x)\"\nsays = \"" + says + "\"\n" + more;
}

inline const std::string hertz_right = hertz_claim("right", "Es*C/2*sqrt(a^2-x^2)");
inline const std::string hertz_wrong = hertz_claim("wrong", "Es*C/3*sqrt(a^2-x^2)");

} // namespace edgeproof::test
