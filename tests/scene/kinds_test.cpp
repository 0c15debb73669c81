// SPDX-License-Identifier: BSD-3-Clause
// Every kind of profile is asked for every quantity. What is refused is listed, with a reason from
// mechanics.
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/input/scene_words.hpp"
#include "tests/scene/scene_words.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <set>

using namespace edgeproof::scenes;

namespace {

using Words = std::vector<std::string>;

const Words plane{"hertz R=1",
                  "power-law m=3 C=1",
                  "power-law m=3/2 C=1",
                  "wedge phi=0.1",
                  "flat-and-rounded R=1 t=1/3",
                  "tilted-wedge phi=0.2 alpha=0.05",
                  "tilted-flat-and-rounded R=1 t=1/3 alpha=1/20",
                  "piecewise symmetric knots=1/2 slopes=x;1/2+2*(x-1/2)"};
const Words plane_curved{"piecewise symmetric slopes=x+x^3", "piecewise knots=0 slopes=x;x+x^2"};
const Words of_revolution{"hertz R=1",
                          "power-law m=3 C=1",
                          "power-law m=3/2 C=1",
                          "wedge phi=0.1",
                          "flat-and-rounded R=1 t=1/3",
                          "piecewise symmetric knots=1/2 slopes=x;1/2+2*(x-1/2)"};
const Words curved_of_revolution{"piecewise symmetric slopes=x/sqrt(4-x^2)",
                                 "piecewise symmetric knots=1/3 slopes=0;(x-1/3)+(x-1/3)^2"};

/// The words of a question: its symbol, its place, and "greatest" for one in the body.
const Words without_friction{
    "p u=1/10",       "c_2 edge=left",   "extent_1 tolerance=5% edge=right",
    "p_max",          "gap x=3/2",       "sxx at=1/10,1/5",
    "greatest mises", "greatest tau_max"};
const Words of_planes{"ux x=3/10 reference=2"};
const Words of_bodies{"delta", "stiffness"};
const Words with_friction{"q u=1/10", "d edge=right", "slip_displacement x=9999/10000*a",
                          "cycle_energy"};

/// Kinds that begin with the first words are refused the second, for the reason in the message.
struct Refusal {
    std::string kind;
    std::string question;
    std::string reason;
};
const std::array refusals{
    Refusal{"wedge", "p_max", "infinite at the corner"},
    Refusal{"tilted-wedge", "p_max", "infinite at the corner"},
    Refusal{"wedge", "greatest", "no finite limit"},
    Refusal{"tilted-wedge", "greatest", "no finite limit"},
    Refusal{"axisymmetric wedge", "p_max", "infinite at the corner"},
    Refusal{"axisymmetric wedge", "greatest", "infinite at the apex"},
};

/// Asks a scene; throws Error where it is refused.
BoundedValue answer(const Scene& scene, const std::string& question) {
    const Words words = words_of(question);
    if (words[0] == "greatest") {
        return greatest_value(scene, greatest_of(words[1]), Body::A).value;
    }
    std::map<std::string, std::string> place;
    for (const std::string& word : Words(words.begin() + 1, words.end())) {
        place[word.substr(0, word.find('='))] = word.substr(word.find('=') + 1);
    }
    const AskedValue asked = asked_value(words[0], place, {});
    const Digits six{6};
    SceneValues values(scene, {asked}, six);
    return row_of(asked.quantity).searched && asked.quantity != Quantity::extent
               ? values.searched(asked).value.value()
               : values.value(asked);
}

std::size_t questions_asked = 0;
std::set<const Refusal*> met;

void ask(const std::string& kind, const std::string& load, const Words& questions) {
    for (const std::string& question : questions) {
        CAPTURE(kind);
        CAPTURE(load);
        CAPTURE(question);
        const auto refusal = std::ranges::find_if(refusals, [&](const Refusal& r) {
            return kind.starts_with(r.kind) && question.starts_with(r.question);
        });
        ++questions_asked;
        try {
            Scene scene = made(kind + load);
            scene.ask.digits = {6};
            const BoundedValue found = answer(scene, question);
            CHECK(found.proved);
            CHECK(found.value.relative_accuracy_bits() >= 15);
            CHECK(refusal == refusals.end());
        } catch (const Error& error) {
            const std::string message = error.what();
            REQUIRE_MESSAGE(refusal != refusals.end(), message);
            CHECK_MESSAGE(message.find(refusal->reason) != std::string::npos, message);
            met.insert(&*refusal);
        }
    }
}

void ask_all(const Words& kinds, bool axisymmetric) {
    for (const std::string load : {" a=1", " P=1/20"}) {
        const std::string moduli = load + " E1=2 nu1=3/10 E2=2 nu2=3/10";
        const std::string friction = moduli + " friction=1/2 Q=1/200";
        for (const std::string& kind : kinds) {
            const std::string words = (axisymmetric ? "axisymmetric " : "") + kind;
            ask(words, moduli, without_friction);
            ask(words, moduli, axisymmetric ? of_bodies : of_planes);
            ask(words, friction, with_friction);
            if (!axisymmetric) {
                ask(words, friction + " bulk_tension=1/100000", {"d edge=right"});
            }
        }
    }
    MESSAGE(questions_asked, " questions");
}

} // namespace

TEST_CASE("every kind of profile answers every quantity, but for reasons from mechanics") {
    ask_all(plane, false);
    ask_all(of_revolution, true);
    CHECK(met.size() == refusals.size());
}

TEST_CASE("curved profiles answer every quantity" * doctest::test_suite("slow")) {
    ask_all(plane_curved, false);
    ask_all(curved_of_revolution, true);
}
