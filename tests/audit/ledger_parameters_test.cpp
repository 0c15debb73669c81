// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/run.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>

namespace {

/// Returns a ledger of one family; its parameters begin at line 7 (piecewise: 9).
std::string one_family(const std::string& profile, const std::map<std::string, std::string>& keys,
                       const std::string& claim = "") {
    std::string text = "[ledger]\nname = \"one\"\n[[family]]\nname = \"own\"\nprofile = \"" +
                       profile + "\"\n[family.parameters]\n";
    for (const auto& [key, value] : keys) {
        text += key + " = [\"" + value + "\"]\n";
    }
    if (profile.starts_with("piecewise")) {
        text.insert(text.find("[family.parameters]"), "knots = []\nslopes = [\"x\"]\n");
    }
    return text + "[[claim]]\nid = \"A\"\nkind = \"value\"\nover = \"own\"\nof = \"P\"\nsays = \"" +
           (claim.empty() ? "P" : claim) + "\"\n";
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
    std::set<std::string> keys{"Q",        "sig0",
                               "friction", "f",
                               "mu",       "bulk_tension",
                               "nu",       "E1",
                               "P",        "M",
                               "b",        "gam",
                               "k",        "L",
                               "x",        "u",
                               "P1",       "b2",
                               "right_d",  "stick_a",
                               "right_c0", "contact_modulus",
                               "together", "path",
                               "slope",    "count"};
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

TEST_CASE("a parameter has an effect through another one, a formula or a definition") {
    auto keys = keys_of("power-law");
    keys["C"] = "1/R";
    keys["R"] = "2*half";
    keys["half"] = "5";
    CHECK(refusal_of(one_family("power-law", keys)) == "");
    keys = keys_of("power-law");
    keys["nu"] = "1/3";
    CHECK(refusal_of(one_family("power-law", keys, "P*(1 - nu^2)/(1 - nu^2)")) == "");
    const std::string defined = "[define]\nlam = \"1 - nu^2\"\n";
    CHECK(refusal_of(one_family("power-law", keys, "P*lam/lam") + defined) == "");
    CHECK(refusal_of(one_family("power-law", keys) + defined).find("nu") != std::string::npos);
    // Two parameters that use only each other have no effect.
    keys = keys_of("power-law");
    keys["one"] = "1";
    keys["two"] = "2*one";
    CHECK(refusal_of(one_family("power-law", keys)).find("has no effect") != std::string::npos);
}

TEST_CASE("shear takes Q and sig0, friction takes Q") {
    auto keys = keys_of("power-law");
    keys["Q"] = "1/10";
    CHECK(refusal_of(one_family("power-law", keys)).find("add sig0") != std::string::npos);
    keys["sig0"] = "0";
    CHECK(refusal_of(one_family("power-law", keys)) == "");
    keys["friction"] = "1/2";
    CHECK(refusal_of(one_family("power-law", keys)) == "");
    keys.erase("sig0");
    CHECK(refusal_of(one_family("power-law", keys)) == "");
    keys.erase("Q");
    CHECK(refusal_of(one_family("power-law", keys)).find("no Q") != std::string::npos);
    CHECK(refusal_of(one_family("power-law",
                                {{"m", "1"}, {"C", "1"}, {"a", "1"}, {"Es", "1"}, {"mu", "1"}}))
              .find("write friction") != std::string::npos);
}

// P = pi/4: f P = 0.3927 for f = 1/2.
TEST_CASE("a scene with friction and without partial slip is refused at the line of friction") {
    auto keys = keys_of("power-law");
    keys["friction"] = "1/2";
    const auto refused = [&](const std::string& Q, const std::string& sig0,
                             const std::string& friction = "1/2") {
        keys["Q"] = Q;
        keys["sig0"] = sig0;
        keys["friction"] = friction;
        const std::string refusal = refusal_of(one_family("power-law", keys));
        CHECK((refusal.empty() || refusal.starts_with("one.toml:11: ")));
        return refusal;
    };
    CHECK(refused("39/100", "0") == "");
    CHECK(refused("-39/100", "0") == "");
    CHECK(refused("2/5", "0").find("slides") != std::string::npos);
    CHECK(refused("-2/5", "0").find("slides") != std::string::npos);
    CHECK(refused("pi/8", "0").find("|Q| may be friction*P") != std::string::npos);
    CHECK(refused("0", "0").find("Q = 0") != std::string::npos);
    CHECK(refused("1/10", "0", "0").find("not positive") != std::string::npos);
    CHECK(refused("1/10", "0", "-1/2").find("not positive") != std::string::npos);
    // |sig0| < 4 f p_0 (1 - sqrt(1 - tau)), p_0 = 1/2: 0.1366 for Q = 1/10.
    CHECK(refused("1/10", "136/1000") == "");
    CHECK(refused("1/10", "-136/1000") == "");
    CHECK(refused("1/10", "137/1000").find("beyond the left edge") != std::string::npos);
    CHECK(refused("1/10", "-137/1000").find("beyond the right edge") != std::string::npos);
    CHECK(refused("-1/10", "-137/1000").find("give a sig0 between") != std::string::npos);
}

TEST_CASE("names of full stick and of partial slip are refused where they have no meaning") {
    auto keys = keys_of("power-law");
    keys["Q"] = "1/10";
    keys["sig0"] = "0";
    const std::string stick = one_family("power-law", keys, "right.d");
    CHECK(refusal_of(stick).find("has no friction") != std::string::npos);
    CHECK(refusal_of(one_family("power-law", keys, "stick_a")).find("has no friction") !=
          std::string::npos);
    CHECK(refusal_of(one_family("power-law", keys, "right.s0")) == "");
    keys["friction"] = "1/2";
    for (const char* name : {"right.s0", "left.s0", "right.s3"}) {
        CHECK(refusal_of(one_family("power-law", keys, name)).find("full stick") !=
              std::string::npos);
    }
    for (const char* name : {"right.d", "left.d", "stick_a", "stick_b", "friction", "q(a/2)"}) {
        CHECK(refusal_of(one_family("power-law", keys, name)) == "");
    }
    // The same through a definition.
    CHECK(refusal_of(one_family("power-law", keys, "K") + "[define]\nK = \"right.s0\"\n")
              .find("full stick") != std::string::npos);
    // A name defined by the ledger keeps its meaning.
    keys.erase("friction");
    CHECK(refusal_of(one_family("power-law", keys, "stick_a") + "[define]\nstick_a = \"a/2\"\n") ==
          "");
}

TEST_CASE(
    "values of a family's parameter in vary, and knots without a piecewise profile, are refused") {
    const std::string ledger = one_family("power-law", keys_of("power-law"));
    CHECK(refusal_of(ledger + "vary = { a = [\"1\", \"2\"] }\n").find("is a parameter of family") !=
          std::string::npos);
    std::string knots = ledger;
    knots.insert(knots.find("[family.parameters]"), "knots = [\"1/2\"]\n");
    CHECK(refusal_of(knots).find("knots have no effect") != std::string::npos);
}
