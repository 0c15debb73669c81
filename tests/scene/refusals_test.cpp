// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/design/design_file.hpp"
#include "tests/scene/scene_words.hpp"

#include <doctest/doctest.h>

#include <cctype>

using namespace edgeproof::scenes;

namespace {

/// "12: words" is the line 12 and the words.
std::pair<std::size_t, std::string> line_and_words(const std::string& cell) {
    const std::size_t colon = cell.find(": ");
    return std::isdigit(static_cast<unsigned char>(cell.front())) != 0 && colon != std::string::npos
               ? std::pair{std::stoul(cell), cell.substr(colon + 2)}
               : std::pair{std::size_t{0}, cell};
}

void check_refusal(const TableRow& row, const InputError& error) {
    const std::string message = error.what();
    CAPTURE(message);
    CHECK((error.file().empty() || error.file() == "scene.toml"));
    CHECK(message.find('\n') == std::string::npos);
    CHECK(message.size() < 500);
    CHECK_FALSE(error.instead().empty());
    for (const std::string& cell : row.cells) {
        const auto [line, words] = line_and_words(cell);
        CAPTURE(cell);
        CHECK(message.find(words) != std::string::npos);
        CHECK((line == 0 || error.line() == line));
    }
}

} // namespace

TEST_CASE("scenes that are refused, with the line, and those that are not") {
    for (const TableRow& row : rows_of("scene/refusals.txt")) {
        CAPTURE(row.at);
        CAPTURE(row.scene);
        const std::string& first = row.cells.front();
        const bool good = first == "accepted" || first == "runs";
        try {
            if (row.scene.find(" design.") != std::string::npos) {
                (void)parse_design(toml_of(row.scene), "scene.toml");
            } else if (const Scene s = made(row.scene); first != "accepted") {
                (void)run_scene(s);
            }
            CHECK_MESSAGE(good, "not refused");
        } catch (const InputError& error) {
            CHECK_MESSAGE(!good, error.what());
            if (!good) {
                check_refusal(row, error);
            }
        }
    }
}
