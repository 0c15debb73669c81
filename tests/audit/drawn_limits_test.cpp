// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/split_mix.hpp"
#include "tests/audit/small_ledger.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <vector>

using namespace edgeproof::small_ledger;

namespace {

/// A formula in s, its limit for s -> 0, which is known by construction, and numbers near its
/// values.
struct KnownLimit {
    std::string of;
    std::string limit;
    std::vector<std::string> others;
};

class DrawnLimits {
public:
    explicit DrawnLimits(std::uint64_t seed) : random_(seed) {}

    KnownLimit draw() {
        const std::string L = pick({"0", "1", "3/7", "(-2e5)", "1e-20", "sqrt(2)", "a"});
        const std::string k = pick({"1", "(-3)", "1e-9", "7e12", "a", "1/C"});
        const std::string p = pick({"1/3", "1/2", "1", "2", "5"});
        const std::string t =
            "1e-" + std::to_string(1 + random_.below(random_.below(2) == 0 ? 80 : 3000));
        const std::string near = "(" + L + "+" + pick({"1e-12", "1e-25", "(-1e-40)"}) + ")";
        switch (random_.below(9)) {
        case 0:
            return {L + "+" + k + "*s^(" + p + ")", L, {near, "infinity"}};
        case 1:
            return {pick({"1", "1e-9", "7e12", "1/C"}) + "*s^(-" + p + ")", "infinity", {L, near}};
        case 2:
            return {L + "+" + k + "*s^(" + p + ")*log(s)", L, {near, "infinity"}};
        case 3: // 5 if s is larger than t
            return {L + "+(5-" + L + ")*s/(s+" + t + ")", L, {"5", near, "infinity"}};
        case 4: // 0 if s is larger than t
            return {L + "*(" + t + "/(s+" + t + "))+s", L, {near, "infinity"}};
        case 5: // large if s is larger than t
            return {"1/(s+" + t + ")+" + L, "(1/" + t + "+" + L + ")", {L, "infinity"}};
        case 6:
            return {L + "+" + k + "*s*sin(1/s)", L, {near, "infinity"}};
        case 7:
            return {L + "+exp(-1/s)+" + k + "*(1-exp(-s/" + t + "))", L, {near, "infinity"}};
        default: // approaches its limit too slowly for a decision
            return {"1/log(1/s)", "0", {"1e-4", "infinity", "1e-30"}};
        }
    }

private:
    std::string pick(const std::vector<std::string>& from) {
        return from[random_.below(from.size())];
    }
    SplitMix64 random_;
};

std::string claim_of(const std::string& of, const std::string& limit) {
    return "kind = \"limit\"\nover = \"powers\"\nof = \"" + of + "\"\nlimit = \"" + limit +
           "\"\nalong = \"s\"\nvary = { s = [\"1/10\", \"1/100\", \"1e-4\", \"1e-8\"] }";
}

} // namespace

TEST_CASE("drawn limits: true ones are never refuted, false ones are never confirmed" *
          doctest::test_suite("slow")) {
    DrawnLimits drawn(20261);
    std::size_t claims = 0;
    std::size_t decided = 0;
    for (int i = 0; i < 250; ++i) {
        const KnownLimit known = drawn.draw();
        CAPTURE(known.of);
        const std::string of_true = verdict_of(claim_of(known.of, known.limit));
        CAPTURE(known.limit);
        CHECK(of_true != "refuted");
        decided += of_true == "confirmed" ? 1 : 0;
        ++claims;
        for (const std::string& other : known.others) {
            CAPTURE(other);
            const std::string of_false = verdict_of(claim_of(known.of, other));
            // The drawn limit may be equal to one of the other numbers.
            CHECK((of_false != "confirmed" || other == known.limit));
            decided += of_false == "refuted" ? 1 : 0;
            ++claims;
        }
    }
    CAPTURE(claims);
    CAPTURE(decided);
    CHECK(decided * 2 > claims);
}
