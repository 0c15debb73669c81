// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/hertz_ledger.hpp"
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <optional>
#include <string>

using namespace edgeproof::test;

namespace {

/// Debian's Chromium, or nothing.
std::optional<std::string> browser() {
    for (const char* program : {"/usr/bin/chromium", "/usr/bin/chromium-browser"}) {
        if (::access(program, X_OK) == 0) {
            return program;
        }
    }
    return std::nullopt;
}

struct Opened {
    std::string page;     ///< the document once its scripts have run
    std::string messages; ///< what the browser said, its console among it
};

Opened open_page(const Folder& folder, const std::string& fragment, const std::string& more = "") {
    const std::string command =
        "cd '" + folder.path().string() + "' && timeout 120 " + *browser() +
        " --headless --no-sandbox --disable-gpu --enable-logging=stderr --v=0" +
        " --user-data-dir='" + folder.path().string() + "/browser' " + more +
        " --dump-dom 'file://" + folder.path().string() + "/out/report.html" + fragment +
        "' >page.txt 2>messages.txt </dev/null";
    REQUIRE(std::system(command.c_str()) == 0);
    return {file_text(folder.path() / "page.txt"), file_text(folder.path() / "messages.txt")};
}

/// The start tag of the claim's element.
std::string tag_of(const std::string& page, const std::string& id) {
    const std::size_t at = page.find("id=\"" + id + "\"");
    REQUIRE(at != std::string::npos);
    const std::size_t begin = page.rfind('<', at);
    return page.substr(begin, page.find('>', at) - begin);
}

const std::string page_ledger = hertz_head + R"toml([[claim]]
id = "good"
kind = "value"
lines = [1, 2]
printed = "p"
over = "hertz"
of = "p(x)"
says = "Es*C/2*sqrt(a^2-x^2)"
[[claim]]
id = "bad.one"
kind = "value"
lines = [3, 4]
printed = "c_0 <&> 'quoted'"
over = "hertz"
of = "right.c0"
says = "Es*C/3*sqrt(2*a)"
)toml";

} // namespace

TEST_SUITE("slow") {
    TEST_CASE("the page in a browser: no errors, the errata on it, the filter, a picture") {
        if (!browser()) {
            MESSAGE("skipped: no Chromium here");
            return;
        }
        const Folder folder;
        folder.write("own.toml", page_ledger);
        REQUIRE(run(folder, "verify own.toml --out out").code == 0);

        const Opened whole = open_page(folder, "");
        CHECK(whole.messages.find("CONSOLE") == std::string::npos);
        CHECK(whole.page.find("id=\"erratum-bad.one\"") != std::string::npos);
        CHECK(whole.page.find("2 of 2 claims") != std::string::npos);
        CHECK(tag_of(whole.page, "good").find("hidden") == std::string::npos);

        const Opened filtered = open_page(folder, "#verdict=refuted");
        CHECK(filtered.messages.find("CONSOLE") == std::string::npos);
        CHECK(filtered.page.find("1 of 2 claims") != std::string::npos);
        CHECK(tag_of(filtered.page, "good").find("hidden") != std::string::npos);
        CHECK(tag_of(filtered.page, "bad.one").find("hidden") == std::string::npos);

        const Opened linked = open_page(folder, "#bad.one");
        CHECK(tag_of(linked.page, "bad.one").find("open") != std::string::npos);
        CHECK(tag_of(linked.page, "good").find("open") == std::string::npos);

        open_page(folder, "", "--window-size=400,800 --screenshot=picture.png");
        CHECK(std::filesystem::file_size(folder.path() / "picture.png") > 10000);
    }

    TEST_CASE("without gnuplot the audit runs, and the page says what is missing") {
        const Folder folder;
        folder.write("own.toml", page_ledger);
        const std::string command = "cd '" + folder.path().string() + "' && PATH= '" +
                                    program().string() +
                                    "' verify own.toml --out out >said.txt 2>&1";
        CHECK(std::system(command.c_str()) == 0);
        const std::string page = file_text(folder.path() / "out" / "report.html");
        CHECK(page.find("gnuplot was not found") != std::string::npos);
        CHECK(page.find("id=\"erratum-bad.one\"") != std::string::npos);
    }
}
