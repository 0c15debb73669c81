// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tests/cli/run_program.hpp"

/// Inputs of the program.
namespace edgeproof::test {

/// A user's ledger about the Hertz pressure E* C sqrt(a^2 - x^2)/2 of the textbooks.
inline const std::string hertz_head = [] {
    const std::string text = file_text(source_dir() / "tests" / "cli" / "files" / "ledger.toml");
    return text.substr(0, text.find("[[claim]]"));
}();

inline std::string hertz_claim(const std::string& id, const std::string& says,
                               const std::string& more = "") {
    return "[[claim]]\nid = \"" + id + "\"\nkind = \"compare\"\nlines = [1, 2]\nprinted = '''" +
           says + "'''\nover = \"hertz\"\nof = \"p(x)\"\nsays = \"" + says + "\"\n" + more;
}

inline const std::string hertz_right = hertz_claim("right", "Es*C/2*sqrt(a^2-x^2)");
inline const std::string hertz_wrong = hertz_claim("wrong", "Es*C/3*sqrt(a^2-x^2)");

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
