// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

using namespace edgeproof::test;

namespace {

// c0 of a wedge is 2 calP sqrt(gam)/(Pi sqrt(1 + gam) sqrt(a)); `says` is right or wrong.
std::string wedge_ledger(const std::string& says) {
    return "[ledger]\nname = \"own\"\n[[family]]\nname = \"wedges\"\nprofile = \"tilted-wedge\"\n"
           "count = 2\n[family.parameters]\ngam = [\"1/3\", \"1/2\"]\nphi = [\"1/50\"]\n"
           "alpha = [\"2*phi/pi*asin((1-gam)/(1+gam))\"]\na = [\"3/2\"]\nEs = [\"7/3\"]\n"
           "[[claim]]\nid = \"c0\"\nkind = \"value\"\nprinted = \"L\"\nover = \"wedges\"\n"
           "of = \"right.c0\"\nsays = \"" +
           says + "\"\n";
}
const std::string wedge_wrong = "2*Es*phi/(Pi*sqrt(1+gam)*sqrt(a))";
const std::string wedge_right = "2*Es*phi*sqrt(gam)/(Pi*sqrt(1+gam)*sqrt(a))";

/// Returns the claim in verdicts.json.
nlohmann::json verified_claim(const Folder& folder, const std::string& more = "") {
    REQUIRE(run(folder, "verify own.toml --digits 20 --out out" + more).code == 0);
    return nlohmann::json::parse(file_text(folder.path() / "out/verdicts.json")).at("claims").at(0);
}

} // namespace

TEST_CASE("verify names the certificate of a verdict, and what the verdict rests on") {
    const Folder folder;
    folder.write("own.toml", wedge_ledger(wedge_wrong));
    const auto before = verified_claim(folder);
    CHECK(before.at("certificate").is_null());
    CHECK(before.at("rests_on") == "enclosures");

    REQUIRE(run(folder, "certify own.toml --out certificates").code == 0);
    const auto with = verified_claim(folder);
    CHECK(with.at("verdict") == "refuted");
    CHECK(with.at("certificate") == "certificates/claim_c0.v");
    CHECK(with.at("rests_on") == "theorem");
    CHECK(run(folder, "verify own.toml --digits 20").out.find("claim_c0.v") != std::string::npos);
    CHECK(file_text(folder.path() / "out/verdicts.md").find("`certificates/claim_c0.v`") !=
          std::string::npos);

    folder.write("own.toml", wedge_ledger(wedge_right)); // the certificate is about another formula
    CHECK(verified_claim(folder).at("certificate").is_null());
    REQUIRE(run(folder, "certify own.toml --out certificates").code == 0);
    const auto confirmed = verified_claim(folder);
    CHECK(confirmed.at("certificate") == "certificates/claim_c0.v");
    CHECK(confirmed.at("rests_on") == "enclosures"); // a theorem about one contact
}

TEST_CASE("verify shows no certificate that is stated in other definitions") {
    const Folder folder;
    folder.write("own.toml", wedge_ledger(wedge_wrong));
    REQUIRE(run(folder, "certify own.toml --out elsewhere").code == 0);
    CHECK(verified_claim(folder).at("certificate").is_null());
    CHECK(verified_claim(folder, " --certificates elsewhere").at("certificate") ==
          "elsewhere/claim_c0.v");
    const auto theory = folder.path() / "elsewhere/Edges.v";
    folder.write("elsewhere/Edges.v", file_text(theory) + "\n");
    CHECK(verified_claim(folder, " --certificates elsewhere").at("certificate").is_null());
}

// A page that is mailed has no other files: the statement itself must be in it.
TEST_CASE("the page contains the theorem's statement, without its proof and without a link") {
    const Folder folder;
    folder.write("own.toml", wedge_ledger(wedge_wrong));
    REQUIRE(run(folder, "certify own.toml --out proofs").code == 0);
    REQUIRE(run(folder, "verify own.toml --digits 20 --certificates proofs --out out").code == 0);
    const std::string page = file_text(folder.path() / "out" / "report.html");
    const std::string file = file_text(folder.path() / "proofs/claim_c0.v");
    CHECK(page.find("href=\"#theorem-c0\"") != std::string::npos);
    const std::size_t begin = page.find("id=\"theorem-c0\"");
    REQUIRE(begin != std::string::npos);
    const std::string shown = page.substr(begin, page.find("</details>", begin) - begin);
    std::size_t theorems = 0;
    for (std::size_t at = 0; (at = file.find("\nTheorem ", at)) != std::string::npos; ++theorems) {
        const std::size_t end = file.find(' ', at + 9);
        const std::string head = file.substr(at + 1, end - at - 1); // "Theorem NAME"
        CAPTURE(head);
        CHECK(shown.find(head) != std::string::npos);
        at = end;
    }
    CHECK(theorems > 0);
    CHECK(shown.find("proofs/claim_c0.v") != std::string::npos);
    CHECK(shown.find("Proof") == std::string::npos);
    CHECK(shown.find("Qed") == std::string::npos);
    CHECK(page.find(".v\">") == std::string::npos);
    folder.write("own.toml", wedge_ledger(wedge_right)); // the certificate is about another formula
    REQUIRE(run(folder, "verify own.toml --digits 20 --certificates proofs --out out").code == 0);
    CHECK(file_text(folder.path() / "out/report.html").find("theorem-c0") == std::string::npos);
}

TEST_CASE("verify --certificates without a folder is an error in one line") {
    const Folder folder;
    folder.write("own.toml", wedge_ledger(wedge_wrong));
    const Outcome o = run(folder, "verify own.toml --certificates none");
    CHECK(o.code == 2);
    CHECK(o.err.find("--certificates none is no folder") != std::string::npos);
}
