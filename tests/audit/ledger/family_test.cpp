// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/run.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"
#include "tests/support/table.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>

namespace {

/// Returns a ledger of one family; its parameters begin at line 7 (piecewise: 9).
std::string one_family(const std::string& profile, const std::map<std::string, std::string>& keys) {
    std::string text = "[ledger]\nname = \"one\"\n[[family]]\nname = \"own\"\nprofile = \"" +
                       profile + "\"\n[family.parameters]\n";
    for (const auto& [key, value] : keys) {
        text += key + " = [\"" + value + "\"]\n";
    }
    if (profile.starts_with("piecewise")) {
        text.insert(text.find("[family.parameters]"), "knots = []\nslopes = [\"x\"]\n");
    }
    return text +
           "[[claim]]\nid = \"A\"\nkind = \"compare\"\nover = \"own\"\nof = \"P\"\nsays = \"P\"\n";
}

std::string refusal_of(const std::string& ledger) {
    try {
        static_cast<void>(parse_ledger(ledger, "one.toml"));
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

const std::map<std::string, std::map<std::string, std::string>> own_keys{
    {"power-law", {{"m", "1"}, {"C", "1"}}},
    {"flat-and-rounded", {{"t", "1/2"}, {"R", "1"}}},
    {"tilted-wedge", {{"phi", "1/2"}, {"alpha", "1/10"}}},
    {"tilted-flat-and-rounded", {{"alpha", "1/10"}, {"t", "1/4"}, {"R", "1"}}},
    {"piecewise", {}},
    {"piecewise-symmetric", {}},
};

std::map<std::string, std::string> keys_of(const std::string& profile) {
    std::map<std::string, std::string> keys = own_keys.at(profile);
    keys.insert({{"a", "1"}, {"Es", "1"}});
    return keys;
}

std::set<std::string> all_keys() {
    const auto others = test::items(R"ITEMS(
        Q   sig0   friction   f   mu   bulk_tension   nu   E1   P   M   b   gam   k   L   x   u
        P1   b2   right_d   stick_a   right_c0   contact_modulus   together   path   slope   count
    )ITEMS");
    std::set<std::string> keys(others.begin(), others.end());
    for (const auto& [profile, own] : own_keys) {
        for (const auto& [key, value] : own) {
            keys.insert(key);
        }
    }
    return keys;
}

} // namespace

TEST_CASE("every parameter that a family does not use is refused at its line") {
    for (const auto& each : own_keys) {
        const auto& profile = each.first;
        const auto& own = each.second;
        CAPTURE(profile);
        CHECK(refusal_of(one_family(profile, keys_of(profile))) == "");
        for (const std::string& key : all_keys()) {
            CAPTURE(key);
            if (own.contains(key)) {
                continue;
            }
            std::map<std::string, std::string> keys = keys_of(profile);
            keys.emplace(key, "1/100");
            const std::string ledger = one_family(profile, keys);
            const auto line =
                1 + std::count(ledger.begin(),
                               ledger.begin() + static_cast<std::ptrdiff_t>(
                                                    ledger.find("\n" + key + " = [") + 1),
                               '\n');
            const std::string refusal = refusal_of(ledger);
            CHECK(refusal.starts_with("one.toml:" + std::to_string(line) + ": "));
            CHECK(refusal.find(key) != std::string::npos);
            CHECK(refusal.find("; ") != std::string::npos);
        }
    }
}
