// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/scene/scene_text.hpp"

#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
using namespace edgeproof::scenes;

namespace {

const char* const points = "u = [\"1e-6\", \"0.01\", \"0.1\"]\n";
const char* const both = "edges = [\"right\", \"left\"]\n";
const char* const shear = "[shear]\nQ = \"0.3\"\nbulk_tension = \"-0.1\"\n";
const char* const together = "[shear]\nQ = \"0.3\"\npath = \"together\"\n";

std::string quantities(const std::string& list) { return "quantities = [" + list + "]\n"; }

/// A scene and its work, counted by hand.
struct Counted {
    std::string name;
    std::string text;
    Counts counts;
};

std::vector<Counted> counted() {
    const std::string punch = "[profile]\nkind = \"tilted-wedge\"\nphi = \"0.1\"\n[load]\n"
                              "P = \"0.1\"\nM = \"0.01\"\ncontact_modulus = \"1\"\n[ask]\n";
    const std::string own = "[profile]\nkind = \"piecewise\"\nsymmetric = true\nknots = [\"1/2\"]\n"
                            "slopes = [\"x/10\", \"x/10 + (x - 1/2)^3\"]\n[load]\na = \"3/4\"\n"
                            "contact_modulus = \"1\"\n[ask]\ndigits = 15\n";
    std::string by_force = hertz("1", points);
    by_force.replace(by_force.find("a = "), 1, "P");
    return {
        {"symmetric, one edge", hertz("1", points), {.closed_forms = 3}},
        {"symmetric, both edges: one is the other's image",
         hertz("1", std::string(points) + both),
         {.closed_forms = 3}},
        {"with approximations",
         hertz("1", std::string(points) + both + "terms = [1, 2]\n"),
         {.expansions = 1, .closed_forms = 3}},
        {"coefficients only: no pressure",
         hertz("1", "terms = 3\n" + quantities("\"coefficients\"")),
         {.expansions = 1}},
        {"the size from P", by_force, {.load_inversions = 1, .closed_forms = 3}},
        {"P and M too",
         hertz("1", points + quantities("\"pressure\", \"contact\"")),
         {.closed_forms = 3, .resultants = 2}},
        {"not symmetric, one edge",
         tilted_wedge("", points),
         {.consistency = 1, .closed_forms = 3}},
        {"not symmetric, both edges",
         tilted_wedge("", std::string(points) + both + "terms = 2\n"),
         {.consistency = 1, .expansions = 2, .closed_forms = 6}},
        {"shear",
         tilted_wedge(shear, std::string(points) + both),
         {.consistency = 1, .closed_forms = 6, .shear_points = 6}},
        {"shear that is there and not asked for",
         tilted_wedge(shear, points + quantities("\"pressure\"")),
         {.consistency = 1, .closed_forms = 3}},
        {"shear alone: no pressure",
         tilted_wedge(shear, std::string(points) + both + "terms = 1\n" + quantities("\"shear\"")),
         {.consistency = 1, .shear_points = 6, .shear_expansions = 2}},
        {"coefficients of p and q",
         tilted_wedge(shear, std::string(both) + "terms = 4\n" + quantities("\"coefficients\"")),
         {.consistency = 1, .expansions = 2, .shear_expansions = 2}},
        {"P and Q in proportion: the shear is p's",
         tilted_wedge(together, points + quantities("\"shear\"")),
         {.consistency = 1, .closed_forms = 3, .shear_points = 3, .resultants = 1}},
        {"a quadrature asked for",
         tilted_wedge("", std::string(points) + "route = \"singular-integral\"\ndigits = 15\n"),
         {.consistency = 1, .quadratures = 3}},
        {"a quadrature needed", own + points + "terms = 1\n", {.expansions = 1, .quadratures = 3}},
        {"the tilt from P and M",
         punch + points + "digits = 15\n",
         {.tilts = 1, .load_inversions = 1, .consistency = 1, .closed_forms = 3}},
        {"a point asked for twice", hertz("1", "u = [\"0.1\", \"0.1\"]\n"), {.closed_forms = 2}},
        {"p and a similar q at a point asked for twice",
         tilted_wedge(together, "u = [\"0.1\", \"0.1\"]\n"),
         {.consistency = 1, .closed_forms = 2, .shear_points = 2, .resultants = 1}},
        {"extents",
         hertz("1", std::string(both) + "terms = [1, 2]\ntolerance = \"1%\"\ndigits = 15\n"),
         {.extents = 2}},
    };
}

/// Returns the number of coefficients at one of the edges.
std::ptrdiff_t count_of(const SceneResult& r, std::size_t edge, Quantity quantity) {
    return std::ranges::count_if(r.at_edges(QuantityGroup::coefficients).at(edge),
                                 [&](const Row& row) { return row.asked.quantity == quantity; });
}

std::string all_text(const SceneResult& r, const Digits& digits) {
    std::string text;
    const auto add = [&](const BoundedValue& v) {
        const PrintedValue p = printed(v, digits);
        text += p.text + " +- " + p.bound + " " + v.how() + "\n";
    };
    for (const RowsAt& row : r.points()) {
        text += edge_name(row.edge()) + " " + row.row(Quantity::x).asked.u->text() + "\n";
        add(row.at(Quantity::x));
        add(row.at(Quantity::p));
    }
    return text;
}

} // namespace

TEST_CASE("a run does no more than the scene needs") {
    for (const Counted& c : counted()) {
        CAPTURE(c.name);
        const Scene scene = parsed(c.text);
        CHECK(run_scene(scene).work.counts == c.counts);
    }
}

TEST_CASE("all values of the examples are proved") {
    const auto files = examples();
    REQUIRE(files.size() >= 12);
    for (const auto& file : files) {
        CAPTURE(file.filename().string());
        Scene scene = read_scene(file);
        scene.ask.digits.count = 12;
        const SceneResult result = run_scene(scene);
        for (const Row& row : result.rows) {
            CHECK((!row.value || row.value->proved));
        }
        CHECK(result.points().size() == result.plan.points * result.plan.edges.size());
        for (const RowsAt& row : result.points()) {
            if (row.find(Quantity::p) != nullptr) {
                CHECK(printed(row.at(Quantity::p), scene.ask.digits).complete);
            }
        }
    }
}

TEST_CASE("the omission of an effect changes no digit of the others") {
    const std::string asked = std::string(points) + both;
    for (const std::string& load : {std::string(shear), std::string(together)}) {
        const Scene whole =
            parsed(tilted_wedge(load, asked + "terms = [1, 5]\ntolerance = \"1%\"\n" +
                                          quantities("\"pressure\", \"shear\", \"coefficients\", "
                                                     "\"extent\", \"contact\"")));
        const SceneResult all = run_scene(whole);
        const std::string expected = all_text(all, whole.ask.digits);
        // The same scene without shear, terms, extents, resultants and coefficients.
        const SceneResult bare = run_scene(parsed(tilted_wedge("", asked)));
        CHECK(all_text(bare, whole.ask.digits) == expected);
        // The same with one edge at a time.
        std::string in_turn;
        for (const char* edge : {"right", "left"}) {
            const SceneResult one = run_scene(parsed(tilted_wedge(
                load, std::string(points) + "edges = [\"" + edge + "\"]\nterms = 2\n")));
            in_turn += all_text(one, whole.ask.digits);
        }
        CHECK(in_turn == expected);
        // Fewer terms have the same coefficients.
        const SceneResult few = run_scene(parsed(tilted_wedge(
            load, std::string(both) + "terms = 2\n" + quantities("\"coefficients\""))));
        for (std::size_t e = 0; e < 2; ++e) {
            CHECK(count_of(few, e, Quantity::c) == 2);
            CHECK(count_of(few, e, Quantity::s) == 2);
            CHECK(count_of(all, e, Quantity::c) == 5);
            for (std::size_t k = 0; k < 2; ++k) {
                CHECK(printed(few.at_edges(QuantityGroup::coefficients)[e].at(Quantity::c, k),
                              whole.ask.digits)
                          .text ==
                      printed(all.at_edges(QuantityGroup::coefficients)[e].at(Quantity::c, k),
                              whole.ask.digits)
                          .text);
                CHECK(printed(few.at_edges(QuantityGroup::coefficients)[e].at(Quantity::s, k),
                              whole.ask.digits)
                          .text ==
                      printed(all.at_edges(QuantityGroup::coefficients)[e].at(Quantity::s, k),
                              whole.ask.digits)
                          .text);
            }
        }
    }
}

TEST_CASE("a plan that cannot be carried out is refused with the line") {
    const auto refused = [](const std::string& text, const std::string& part) {
        try {
            (void)make_plan(parsed(text));
            FAIL("accepted");
        } catch (const InputError& error) {
            CHECK(std::string(error.what()).find(part) != std::string::npos);
            CHECK(error.line() > 0);
        }
    };
    refused(hertz("1", quantities("\"pressure\"")), "no points");
    refused(hertz("1", quantities("\"coefficients\"")), "no number of terms");
    refused(hertz("1", "terms = 1\n" + quantities("\"extent\"")), "tolerance");
}
