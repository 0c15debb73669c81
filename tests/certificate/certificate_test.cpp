// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/certificate/certificate.hpp"

#include "edgeproof/audit/run.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>

namespace {

std::string ledger_text(const std::string& says, const std::string& factor = "2",
                        const std::string& a = "1") {
    return "[ledger]\nname = \"own\"\n[define]\nk = \"" + factor +
           "\"\nunused = \"7\"\n[[family]]\nname = \"hertz\"\nprofile = \"power-law\"\ncount = 1\n"
           "[family.parameters]\nm = [\"1\"]\nC = [\"1\"]\na = [\"" +
           a +
           "\"]\nEs = [\"1\"]\n[[claim]]\nid = \"own\"\nkind = \"compare\"\nprinted = \"p\"\n"
           "over = \"hertz\"\nsays = \"" +
           says + "\"\nof = \"P\"\n";
}

audit::AuditResult judged(const std::string& text) {
    audit::AuditOptions options;
    options.digits = 20;
    return audit::run_audit(audit::parse_ledger(text, "own.toml"), options);
}

std::string hash_of(const std::string& text) {
    const audit::Ledger ledger = audit::parse_ledger(text, "own.toml");
    return certificate::fields_sha256(ledger.claims.at(0), ledger);
}

constexpr const char* index_head =
    "claim,verdict,file,theorem,states,leaves_out,whole,fields_sha256\n";
const std::string right = "k*Pi*Es/8*a^2";

struct Theorems {
    edgeproof::test::Folder folder;
    std::string definitions = io::sha256(io::sha256("mechanics") + "  Mechanics.v\n");

    /// Writes the folder as it is after Coq has accepted the theorem.
    Theorems() {
        folder.write("Mechanics.v", "mechanics");
        folder.write("own.v", "a theorem");
        write_index("confirmed", hash_of(ledger_text(right)));
        write_record(io::sha256("a theorem"), definitions);
    }
    void write_index(const std::string& verdict, const std::string& hash) const {
        folder.write("index.csv",
                     index_head + ("own," + verdict + ",own.v,own_agrees,,,whole," + hash + "\n"));
    }
    void write_record(const std::string& file, const std::string& imports) const {
        folder.write("accepted.csv", "theorem,file,sha256,imports_sha256,coq\nown_agrees,own.v," +
                                         file + "," + imports + ",8.16.1\n");
    }
    [[nodiscard]] std::optional<audit::TheoremFile> attached(const std::string& text) const {
        audit::AuditResult result = judged(text);
        certificate::attach_certificates(result, audit::parse_ledger(text, "own.toml"),
                                         folder.path(), "shown");
        return result.claims.at(0).certificate;
    }
};

} // namespace

TEST_CASE("certificates: a theorem counts for the claim that it is about, and for no other") {
    const Theorems theorems;
    const auto counted = theorems.attached(ledger_text(right));
    REQUIRE(counted);
    CHECK(counted->accepted);
    CHECK(counted->whole_verdict);
    CHECK(counted->path == "shown/own.v");
    // An equal formula in other words, a used definition, the family: each is another claim.
    for (const std::string& other :
         {ledger_text("Pi*Es*a^2/4"), ledger_text(right, "4/2"), ledger_text(right, "2", "3")}) {
        const auto lost = theorems.attached(other);
        REQUIRE(lost);
        CHECK_FALSE(lost->accepted);
        CHECK(lost->problem == "it is about another text of the claim");
    }
    theorems.write_index("proved", hash_of(ledger_text(right)));
    CHECK(theorems.attached(ledger_text(right))->problem == "it is about the verdict proved");
}

TEST_CASE("certificates: a file that has changed since Coq accepted it does not count") {
    const std::string problem = "it is not recorded that Coq accepts it as it is";
    const auto check = [&](const auto& change) {
        const Theorems theorems;
        change(theorems);
        const auto found = theorems.attached(ledger_text(right));
        REQUIRE(found);
        CHECK_FALSE(found->accepted);
        CHECK(found->problem == problem);
    };
    check([](const Theorems& t) { t.folder.write("own.v", "another theorem"); });
    check([](const Theorems& t) { t.folder.write("Mechanics.v", "other mechanics"); });
    check([](const Theorems& t) { t.folder.write("More.v", "more mechanics"); });
    check([](const Theorems& t) { std::filesystem::remove(t.folder.path() / "accepted.csv"); });
    check([](const Theorems& t) { std::filesystem::remove(t.folder.path() / "own.v"); });
    check([](const Theorems& t) { t.write_record(io::sha256("a"), t.definitions); });
}

TEST_CASE("certificates: a malformed table is refused, a folder without tables has no theorems") {
    const Theorems theorems;
    std::filesystem::remove(theorems.folder.path() / "accepted.csv");
    for (const std::string& rows :
         {std::string("claim,verdict\n"),
          index_head + std::string("own,confirmed,../own.v,t,,,whole,\n"),
          index_head + std::string("own,confirmed,own.v,t,,,all,\n"),
          index_head + std::string("own,confirmed,own.v\n"),
          index_head +
              std::string("own,confirmed,own.v,t,,,whole,x\nown,confirmed,own.v,s,,,part,x\n")}) {
        CAPTURE(rows);
        theorems.folder.write("index.csv", rows);
        CHECK_THROWS_AS((void)theorems.attached(ledger_text(right)), InputError);
    }
    std::filesystem::remove(theorems.folder.path() / "index.csv");
    CHECK_FALSE(theorems.attached(ledger_text(right)));
}
