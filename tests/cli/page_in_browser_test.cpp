// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/inputs.hpp"
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <optional>
#include <string>

using namespace edgeproof::test;

namespace {

/// Returns Debian's Chromium, or no value.
std::optional<std::string> browser() {
    for (const char* program : {"/usr/bin/chromium", "/usr/bin/chromium-browser"}) {
        if (::access(program, X_OK) == 0) {
            return program;
        }
    }
    return std::nullopt;
}

/// Measures the layout of the page, and sends its findings, one on each line, to the page around
/// it.
const std::string measuring = R"js(<script>
addEventListener("load", () => {
  const found = [];
  const ids = [...document.querySelectorAll("[id]")].map((e) => e.id);
  for (const id of new Set(ids)) {
    if (ids.filter((other) => other === id).length > 1) found.push("id twice: " + id);
  }
  if (document.documentElement.scrollWidth > innerWidth) {
    found.push("wider than the window: " + document.documentElement.scrollWidth);
  }
  for (const svg of document.querySelectorAll(".panel svg")) {
    const panel = svg.parentElement.getBoundingClientRect().width;
    if (svg.getBoundingClientRect().width < 0.9 * panel) found.push("plot does not fill its panel");
    const scale = svg.getBoundingClientRect().width / svg.viewBox.baseVal.width;
    for (const text of svg.querySelectorAll("text")) {
      const shown = parseFloat(getComputedStyle(text).fontSize) * scale;
      if (text.textContent.trim() && shown < 11) found.push("text of " + shown.toFixed(1) + " px");
    }
  }
  for (const math of document.querySelectorAll("#errata math")) {
    const end = math.closest(".scroll, .panel, .erratum").getBoundingClientRect().right;
    if (math.getBoundingClientRect().right > end + 1) {
      found.push("formula cut off: " + math.closest(".erratum").id);
    }
  }
  for (const text of document.querySelectorAll(".panel svg text")) {
    const box = text.getBoundingClientRect(), panel = text.closest(".panel").getBoundingClientRect();
    if (box.left < panel.left - 1 || box.right > panel.right + 1) {
      found.push("text beyond its panel: " + text.textContent.trim());
    }
  }
  for (const claim of document.querySelectorAll("details.claim")) {
    if (claim.querySelector(".said").getBoundingClientRect().height < 8) {
      found.push("no sentence: " + claim.id);
    }
  }
  const walk = document.createTreeWalker(document.querySelector("main"), NodeFilter.SHOW_TEXT);
  for (let node = walk.nextNode(); node; node = walk.nextNode()) {
    if (node.parentElement.closest("code, pre, script, style")) continue;
    if (/[$\\]|\bEQ\d\d\b.* prints/.test(node.data)) found.push("raw TeX: " + node.data.trim().slice(0, 60));
  }
  parent.postMessage("width " + innerWidth + "\n" + [...new Set(found)].join("\n") + "\nend", "*");
});
</script>)js";

/// A page that shows the report in a frame of this width: a window of Chromium is at least 500
/// wide.
std::string framed(const std::string& width) {
    return "<!doctype html><iframe src=\"report.html\" style=\"height:900px; width:" + width +
           "px; border:0\"></iframe><pre id=\"measured\"></pre><script>onmessage = (sent) => {"
           " document.getElementById(\"measured\").textContent = sent.data; };</script>";
}

struct Opened {
    std::string page;     ///< the document after its scripts have run
    std::string messages; ///< the browser's messages, including its console
};

Opened open_page(const Folder& folder, const std::string& fragment, const std::string& more = "",
                 const std::string& file = "report.html") {
    const std::string command =
        "cd '" + folder.path().string() + "' && timeout 120 " + *browser() +
        " --headless --no-sandbox --disable-gpu --enable-logging=stderr --v=0" +
        " --user-data-dir='" + folder.path().string() + "/browser' " + more +
        " --dump-dom 'file://" + folder.path().string() + "/out/" + file + fragment +
        "' >page.txt 2>messages.txt </dev/null";
    REQUIRE(std::system(command.c_str()) == 0);
    return {file_text(folder.path() / "page.txt"), file_text(folder.path() / "messages.txt")};
}

/// Returns the faults of the page in a window of this width; empty if there are none.
std::string faults_of(const Folder& folder, const std::string& width) {
    const auto page = folder.path() / "out" / "report.html";
    const std::string kept = file_text(page);
    (void)folder.write("out/report.html", kept + measuring);
    (void)folder.write("out/framed.html", framed(width));
    const Opened opened =
        open_page(folder, "", "--window-size=1400,900 --virtual-time-budget=20000", "framed.html");
    (void)folder.write("out/report.html", kept);
    const std::size_t at = opened.page.find("<pre id=\"measured\">");
    REQUIRE(at != std::string::npos);
    const std::size_t begin = opened.page.find('\n', at) + 1;
    CHECK(has(opened.page, ">width " + width + "\n"));
    return opened.page.substr(begin, opened.page.find("\nend", begin) - begin);
}

/// Returns the number of printed pages.
std::size_t pages_in_print(const Folder& folder) {
    open_page(folder, "", "--no-pdf-header-footer --print-to-pdf=page.pdf");
    const std::string pdf = file_text(folder.path() / "page.pdf");
    std::size_t pages = 0;
    for (std::size_t at = 0; (at = pdf.find("/Type /Page", at)) != std::string::npos; at += 11) {
        pages += pdf[at + 11] == 's' ? 0 : 1;
    }
    return pages;
}

/// Returns the start tag of the claim's element.
std::string tag_of(const std::string& page, const std::string& id) {
    const std::size_t at = page.find("id=\"" + id + "\"");
    REQUIRE(at != std::string::npos);
    const std::size_t begin = page.rfind('<', at);
    return page.substr(begin, page.find('>', at) - begin);
}

const std::string page_ledger = hertz_head + R"toml([[claim]]
id = "good"
kind = "compare"
lines = [1, 2]
printed = "p"
over = "hertz"
of = "p(x)"
says = "Es*C/2*sqrt(a^2-x^2)"
[[claim]]
id = "bad.one"
kind = "compare"
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
        CHECK(whole.page.find(">Use dark colours</button>") != std::string::npos);
        const Opened dark = open_page(folder, "", "--force-dark-mode");
        CHECK(dark.page.find(">Use light colours</button>") != std::string::npos);
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

    TEST_CASE("the paper's page: no raw TeX, no text cut off, a short print, errata that compile") {
        if (!browser()) {
            MESSAGE("skipped: no Chromium here");
            return;
        }
        const Folder folder;
        const Outcome verified =
            run(folder,
                "verify '" + (source_dir() / "verify/moore-hills.toml").string() + "' --out out");
        REQUIRE(verified.code == 0);
        for (const char* width : {"1280", "688", "390"}) { // 688: A4 without its margins
            CAPTURE(width);
            CHECK(faults_of(folder, width) == "");
        }
        const std::size_t pages = pages_in_print(folder);
        CHECK(pages > 2);
        CHECK(pages < 20);
        CHECK(file_text(folder.path() / "page.pdf").find("/MediaBox [0 0 594.95996 841.91998]") !=
              std::string::npos); // A4 in points
        const std::string page = file_text(folder.path() / "out/report.html");
        for (const char* shown : {"Eq. (39)", "Section 2.1.1, line 164", "class=\"side printed\"",
                                  "To check by hand", "What rests on it", "SHA-256"}) {
            CAPTURE(shown);
            CHECK(page.find(shown) != std::string::npos);
        }
        if (std::system("command -v pdflatex >/dev/null") != 0) {
            MESSAGE("errata.tex was not compiled: no pdflatex here");
            return;
        }
        const std::string compile = "cd '" + (folder.path() / "out").string() +
                                    "' && pdflatex -interaction=nonstopmode -halt-on-error "
                                    "errata.tex >errata.said";
        CHECK(std::system(compile.c_str()) == 0);
        CHECK(file_text(folder.path() / "out/errata.log").find("(1 page,") != std::string::npos);
    }
}
