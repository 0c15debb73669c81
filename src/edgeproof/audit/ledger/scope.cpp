// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/ledger/scope.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace edgeproof::audit {
namespace {

constexpr std::string_view below = "stress below the surface";
constexpr std::string_view point = "point contact";
constexpr std::string_view sliding = "friction";

struct Word {
    std::string_view name;
    bool prefix; ///< true: the name may continue with any characters
    std::string_view topic;
};
/// In lower case; the first match is used.
constexpr std::array words{Word{"sig0", false, ""},           Word{"sig", true, below},
                           Word{"tau", true, below},          Word{"sxx", false, below},
                           Word{"syy", false, below},         Word{"szz", false, below},
                           Word{"sxy", false, below},         Word{"sxz", false, below},
                           Word{"s_", true, below},           Word{"mises", true, below},
                           Word{"von_mises", true, below},    Word{"vonmises", true, below},
                           Word{"tresca", true, below},       Word{"j2", false, below},
                           Word{"y", false, below},           Word{"z", false, below},
                           Word{"depth", true, below},        Word{"sphere", true, point},
                           Word{"ball", true, point},         Word{"ellips", true, point},
                           Word{"ellipt", true, point},       Word{"circular", true, point},
                           Word{"cone", true, point},         Word{"parabol", true, point},
                           Word{"axisymmetric", true, point}, Word{"point", true, point},
                           Word{"mu", false, sliding},        Word{"mu_", true, sliding},
                           Word{"friction", true, sliding},   Word{"slip", true, sliding},
                           Word{"stick", true, sliding},      Word{"coulomb", true, sliding}};

} // namespace

std::optional<std::string_view> outside_of_scope(std::string_view name) {
    std::string small(name);
    std::transform(small.begin(), small.end(), small.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const Word& word : words) {
        if (small == word.name || (word.prefix && small.starts_with(word.name))) {
            return word.topic.empty() ? std::nullopt : std::optional(word.topic);
        }
    }
    return std::nullopt;
}

InputError with_scope(const InputError& error) {
    const std::string& problem = error.problem();
    for (const std::string_view start :
         {std::string_view("unknown name '"), std::string_view("unknown function '")}) {
        if (!problem.starts_with(start)) {
            continue;
        }
        const std::string name =
            problem.substr(start.size(), problem.find('\'', start.size()) - start.size());
        const auto topic = outside_of_scope(name);
        if (topic == sliding) {
            return InputError(problem + ": friction is a parameter of the family",
                              "add friction and Q to the parameters of the family, and write "
                              "friction, right.d, left.d, stick_a, stick_b; or define the name if "
                              "it is something else")
                .at(error.file(), error.line());
        }
        if (topic) {
            return InputError(problem + ": " + std::string(*topic) +
                                  " is outside what Edgeproof computes",
                              "it computes p(x) and q(x) of plane contacts, their "
                              "edges, forces and expansions at the edges; leave the claim out, or "
                              "define the name if it is something else")
                .at(error.file(), error.line());
        }
    }
    return error;
}

} // namespace edgeproof::audit
