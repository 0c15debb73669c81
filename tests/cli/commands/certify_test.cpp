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

/// Does what make does with a coqc that accepts every file, and writes the stamps with sha256sum.
void accept_all(const Folder& folder, const std::string& certificates) {
    const std::string command = "cd '" + (folder.path() / certificates).string() +
                                "' && for f in *.v; do echo \"compiled $f\" > \"${f%.v}.vo\"; done"
                                " && for f in *.v; do { echo 'Coq 8.16.1'; sha256sum \"$f\" *.vo; }"
                                " > \"${f%.v}.accepted\"; done";
    REQUIRE(std::system(command.c_str()) == 0);
}
void certify_and_accept(const Folder& folder, const std::string& certificates) {
    REQUIRE(run(folder, "certify own.toml --out " + certificates).code == 0);
    accept_all(folder, certificates);
    REQUIRE(run(folder, "certify own.toml --record --out " + certificates).code == 0);
}

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

    certify_and_accept(folder, "certificates");
    const auto with = verified_claim(folder);
    CHECK(with.at("verdict") == "refuted");
    CHECK(with.at("certificate") == "certificates/claim_c0.v");
    CHECK(with.at("rests_on") == "theorem");
    CHECK(run(folder, "verify own.toml --digits 20").out.find("claim_c0.v") != std::string::npos);
    CHECK(file_text(folder.path() / "out/verdicts.md").find("`certificates/claim_c0.v`") !=
          std::string::npos);

    folder.write("own.toml", wedge_ledger(wedge_right)); // the certificate is about another formula
    CHECK(verified_claim(folder).at("certificate").is_null());
    certify_and_accept(folder, "certificates");
    const auto confirmed = verified_claim(folder);
    CHECK(confirmed.at("certificate") == "certificates/claim_c0.v");
    CHECK(confirmed.at("rests_on") == "theorem");
}

TEST_CASE("verify shows no certificate that is stated in other definitions") {
    const Folder folder;
    folder.write("own.toml", wedge_ledger(wedge_wrong));
    certify_and_accept(folder, "elsewhere");
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
    certify_and_accept(folder, "proofs");
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

TEST_CASE("only theorems that Coq has accepted count") {
    const Folder folder;
    folder.write("own.toml", wedge_ledger(wedge_wrong));
    REQUIRE(run(folder, "certify own.toml --out certificates").code == 0);
    const std::string record = "certify own.toml --out certificates --record";
    const auto counts = [&] { return verified_claim(folder).at("rests_on") == "theorem"; };
    const auto without_blanks = [](std::string text) { // lines are broken at blanks
        std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
        return text;
    };
    const auto says = [&](const std::string& text) {
        return without_blanks(run(folder, "verify own.toml --digits 20").out)
                   .find(without_blanks(text)) != std::string::npos;
    };
    CHECK_FALSE(counts());
    CHECK(verified_claim(folder).at("certificate").is_null());
    CHECK(says("not recorded as a theorem: certificates/claim_c0.v"));
    CHECK(says("1 of the certificates do not count"));

    const Outcome unmade = run(folder, record);
    CHECK(unmade.code == 1);
    CHECK(unmade.out.find("claim_c0.v is not accepted: make has not compiled Contact.v") !=
          std::string::npos);
    CHECK_FALSE(counts());

    accept_all(folder, "certificates");
    std::filesystem::remove(folder.path() / "certificates/claim_c0.accepted"); // Coq refused it
    CHECK(run(folder, record).code == 1);
    CHECK_FALSE(counts());

    accept_all(folder, "certificates");
    CHECK(run(folder, record).out.find("2 theorems that Coq 8.16.1 accepts are recorded in") !=
          std::string::npos);
    CHECK(counts());
    CHECK_FALSE(says("do not count"));
    // The columns after theorem and file are what sha256sum prints.
    CHECK(std::system(("cd '" + (folder.path() / "certificates").string() +
                       "' && grep -q \"^claim_c0_refuted,claim_c0.v,$(sha256sum claim_c0.v |"
                       " cut -c 1-64),[0-9a-f]*,8.16.1$\" accepted.csv")
                          .c_str()) == 0);
}

TEST_CASE("a compiled file of another source is not recorded") {
    for (const std::string changed : {"claim_c0.vo", "Edges.vo", "Contact.accepted"}) {
        CAPTURE(changed);
        const Folder folder;
        folder.write("own.toml", wedge_ledger(wedge_wrong));
        REQUIRE(run(folder, "certify own.toml --out certificates").code == 0);
        accept_all(folder, "certificates");
        folder.write("certificates/" + changed, "Coq 8.16.1\n");
        const Outcome o = run(folder, "certify own.toml --out certificates --record");
        CHECK(o.code == 1);
        CHECK(o.out.find("has changed since make compiled") != std::string::npos);
        CHECK(verified_claim(folder).at("rests_on") == "enclosures");
    }
    // The theorem is recorded, then its formula changes, and certify writes another file.
    const Folder folder;
    folder.write("own.toml", wedge_ledger(wedge_wrong));
    certify_and_accept(folder, "certificates");
    CHECK(verified_claim(folder).at("rests_on") == "theorem");
    folder.write("own.toml", wedge_ledger("3*" + wedge_wrong));
    REQUIRE(run(folder, "certify own.toml --out certificates").code == 0);
    CHECK(verified_claim(folder).at("rests_on") == "enclosures");
    CHECK(run(folder, "certify own.toml --out certificates --record").code == 1);
    CHECK(verified_claim(folder).at("rests_on") == "enclosures");
}

TEST_CASE("errors of the record of theorems are one line") {
    const Folder folder;
    folder.write("own.toml", wedge_ledger(wedge_wrong));
    const Outcome none = run(folder, "certify own.toml --out certificates --record");
    CHECK(none.code == 2);
    CHECK(none.err.find("certificates, which is no folder") != std::string::npos);
    certify_and_accept(folder, "certificates");
    folder.write("certificates/accepted.csv", "theorem,file,sha256,imports_sha256,coq\none,two\n");
    const Outcome malformed = run(folder, "verify own.toml --digits 20 --out other");
    CHECK(malformed.code == 2);
    CHECK(malformed.err.find("accepted.csv:2: a row of 2 cells") != std::string::npos);
    CHECK_FALSE(std::filesystem::exists(folder.path() / "other"));
    folder.write("certificates/Edges.v", "");
    const Outcome other = run(folder, "certify own.toml --out certificates --record");
    CHECK(other.code == 2);
    CHECK(other.err.find("certificates/Edges.v: is missing, or is not the file") !=
          std::string::npos);
}

TEST_CASE("verify --certificates without a folder is an error in one line") {
    const Folder folder;
    folder.write("own.toml", wedge_ledger(wedge_wrong));
    const Outcome o = run(folder, "verify own.toml --certificates none");
    CHECK(o.code == 2);
    CHECK(o.err.find("--certificates none is no folder") != std::string::npos);
}
