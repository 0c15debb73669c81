// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/precision/error.hpp"
#include "tests/scene/scene_words.hpp"
#include "tests/support/paths.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>

using namespace edgeproof::scenes;

namespace {

const std::string two_edges = " edges=right;left";
const std::string three = " u=1e-6;0.01;0.1";
const std::string cylinder = "power-law m=1 C=1 a=1";
const std::string wedge = "tilted-wedge phi=0.1 alpha=0.02 a=2";
const std::string stuck = wedge + " Q=0.3 bulk_tension=-0.1";
const std::string together = wedge + " Q=0.3 path=together";

std::string all_text(const SceneResult& r) {
    std::string text;
    for (const RowsAt& row : r.points()) {
        text += edge_name(row.edge()) + " " + row.row(Quantity::x).asked.u->text() + "\n";
        for (const Quantity quantity : {Quantity::x, Quantity::p}) {
            const PrintedValue p = printed(row.at(quantity), {});
            text += p.text + " +- " + p.bound + " " + row.at(quantity).how() + "\n";
        }
    }
    return text;
}

} // namespace

TEST_CASE("all values of the examples are proved") {
    std::vector<std::filesystem::path> files;
    for (const auto& entry :
         std::filesystem::directory_iterator(test::source_dir() / "examples" / "scenes")) {
        files.push_back(entry.path());
    }
    std::erase_if(files, [](const auto& file) { return file.extension() != ".toml"; });
    REQUIRE(files.size() >= 12);
    for (const auto& file : files) {
        CAPTURE(file.filename().string());
        Scene scene = read_scene(file);
        scene.ask.digits.count = 12;
        const SceneResult result = run_scene(scene);
        for (const Row& row : result.rows) {
            CHECK((!row.value || row.value->proved));
        }
        CHECK(result.points().size() == result.plan.points * scene.ask.edges.size());
        for (const RowsAt& row : result.points()) {
            if (row.find(Quantity::p) != nullptr) {
                CHECK(printed(row.at(Quantity::p), scene.ask.digits).complete);
            }
        }
    }
}

TEST_CASE("the omission of an effect changes no digit of the others") {
    const std::string asked = three + two_edges;
    for (const std::string& sheared : {stuck, together}) {
        const SceneResult all = run_scene(made(sheared + asked +
                                               " terms=1;5 tolerance=1% quantities=pressure;shear;"
                                               "coefficients;extent;contact"));
        const std::string expected = all_text(all);
        CHECK(all_text(run_scene(made(wedge + asked))) == expected);
        std::string in_turn;
        for (const std::string edge : {"right", "left"}) {
            in_turn += all_text(run_scene(made(sheared + three + " terms=2 edges=" + edge)));
        }
        CHECK(in_turn == expected);
        // Fewer terms have the same coefficients.
        const SceneResult few =
            run_scene(made(sheared + two_edges + " terms=2 quantities=coefficients"));
        for (std::size_t e = 0; e < 2; ++e) {
            const RowsAt of_few = few.at_edges(QuantityGroup::coefficients).at(e);
            const RowsAt of_all = all.at_edges(QuantityGroup::coefficients).at(e);
            for (const Quantity quantity : {Quantity::c, Quantity::s}) {
                CHECK(of_few.find(quantity, 2) == nullptr);
                CHECK(of_all.find(quantity, 4) != nullptr);
                CHECK(of_all.find(quantity, 5) == nullptr);
                for (std::size_t k = 0; k < 2; ++k) {
                    CHECK(printed(of_few.at(quantity, k), {}).text ==
                          printed(of_all.at(quantity, k), {}).text);
                }
            }
        }
    }
}

TEST_CASE("extents of the same number of terms twice, at both edges: as many rows as asked for") {
    const SceneResult result = run_scene(made(cylinder + two_edges + " terms=1;1 tolerance=1%"));
    for (const RowsAt& edge : result.at_edges(QuantityGroup::extent)) {
        CHECK(std::ranges::count_if(edge, [](const Row& row) {
                  return row.asked.quantity == Quantity::extent;
              }) == 2);
    }
}
