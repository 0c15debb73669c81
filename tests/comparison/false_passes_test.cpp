// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/comparison.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/comparison/hertz_data.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <utility>

using namespace edgeproof::hertz_data;

namespace {

/// Random meshes of one contact.
class DrawnMeshes {
public:
    DrawnMeshes(const ExactContact& contact, std::uint64_t seed) : exact_(contact), random_(seed) {}

    /// Draws a whole number in least ... most.
    int whole(int least, int most) { return std::uniform_int_distribution(least, most)(random_); }
    double number(double least, double most) {
        return std::uniform_real_distribution<double>(least, most)(random_);
    }
    bool coin() { return whole(0, 1) == 1; }

    /// Draws places from outside the left edge to outside the right one: even, graded towards both
    /// ends, or uneven; with 40 to 160 elements.
    std::vector<double> places() {
        const double outside = number(0.05, 0.4) * exact_.length();
        const double from = -exact_.b().value - outside;
        const double to = exact_.a().value + number(0.05, 0.4) * exact_.length();
        const int n = whole(40, 160);
        const int kind = whole(0, 2);
        std::vector<double> list;
        for (int i = 0; i <= n; ++i) {
            const double inner = i > 0 && i < n && kind == 1 ? number(-0.3, 0.3) : 0;
            const double t = (i + inner) / n;
            list.push_back(from + (to - from) * (kind == 2 ? t * t * (3 - 2 * t) : t));
        }
        return list;
    }

    /// Returns the exact pressure at random places.
    std::vector<std::pair<double, double>> right() {
        std::vector<std::pair<double, double>> rows;
        for (const double x : places()) {
            rows.emplace_back(x, exact_.pressure(x));
        }
        return rows;
    }

private:
    const ExactContact& exact_;
    std::mt19937_64 random_;
};

using Rows = std::vector<std::pair<double, double>>;

std::string text_of(const Rows& rows) {
    std::string text = "x,p\n";
    for (const auto& [x, p] : rows) {
        text += number(x) + "," + number(p) + "\n";
    }
    return text;
}

FileComparison judged(const std::string& text, const ExactContact& contact,
                      const Tolerances& tolerances = {}) {
    return compare_file(parse_result(text, "drawn.csv"), contact, tolerances, Rational(0));
}

ExactContact contact_of_text(const std::string& text) {
    return ExactContact(parse_scene(text, "drawn.toml"));
}

/// A wrong mesh, and a description of its error.
struct Wrong {
    const char* what;
    Rows rows;
};

/// Draws the part of a + b that is left out at an end. A part near one half is excluded, because
/// half of a symmetric contact is a permitted result.
double cut_off(DrawnMeshes& draw) {
    return draw.coin() ? draw.number(0.15, 0.4) : draw.number(0.6, 0.9);
}

std::vector<Wrong> wrong_meshes(DrawnMeshes& draw, const ExactContact& exact) {
    const double length = exact.length();
    const double a = exact.a().value;
    const double b = exact.b().value;
    std::vector<Wrong> list;
    const auto add = [&](const char* what, const auto& change) {
        Rows rows = draw.right();
        change(rows);
        list.push_back({what, std::move(rows)});
    };
    const auto keep = [](Rows& rows, const auto& test) {
        std::erase_if(rows, [&](const auto& row) { return !test(row.first); });
    };
    add("shifted", [&](Rows& rows) {
        const double shift = (draw.coin() ? 1 : -1) * draw.number(0.02, 0.3) * length;
        for (auto& [x, p] : rows) {
            x += shift;
        }
    });
    add("no right side", [&](Rows& rows) {
        const double end = a - cut_off(draw) * length;
        keep(rows, [&](double x) { return x < end; });
    });
    add("no left side", [&](Rows& rows) {
        const double end = -b + cut_off(draw) * length;
        keep(rows, [&](double x) { return x > end; });
    });
    add("the middle alone", [&](Rows& rows) {
        const double cut = draw.number(0.12, 0.35) * length;
        keep(rows, [&](double x) { return x > -b + cut && x < a - cut; });
    });
    add("a hole", [&](Rows& rows) {
        const double from = -b + draw.number(0.1, 0.3) * length;
        const double to = from + draw.number(0.3, 0.5) * length;
        keep(rows, [&](double x) { return x < from || x > to; });
    });
    add("three or four nodes", [&](Rows& rows) {
        rows.clear();
        const int n = draw.whole(3, 4);
        const double from = -b + draw.number(0.05, 0.6) * length;
        const double to = from + draw.number(0.01, 0.3) * length;
        for (int i = 0; i < n; ++i) {
            const double x = from + (to - from) * i / (n - 1);
            rows.emplace_back(x, exact.pressure(x));
        }
    });
    add("one node off", [&](Rows& rows) {
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (rows[i].first > -b) {
                rows[i].second += 0.05 * exact.scale().value;
                break;
            }
        }
    });
    add("a node twice, once off", [&](Rows& rows) {
        const auto i = rows.size() / 2;
        rows.insert(rows.begin() + static_cast<std::ptrdiff_t>(i),
                    {rows[i].first, rows[i].second + 0.05 * exact.scale().value});
    });
    add("no pressure", [](Rows& rows) {
        for (auto& [x, p] : rows) {
            p = 0;
        }
    });
    add("the mean everywhere", [&](Rows& rows) {
        for (auto& [x, p] : rows) {
            p = p > 0 ? exact.force().value / length : 0;
        }
    });
    add("larger by a twentieth", [](Rows& rows) {
        for (auto& [x, p] : rows) {
            p *= 1.05;
        }
    });
    add("pressure outside", [&](Rows& rows) { rows.front().second = 0.05 * exact.scale().value; });
    add("huge", [](Rows& rows) {
        for (auto& [x, p] : rows) {
            p *= 1e290;
        }
    });
    return list;
}

const char* const drawn_scenes[] = {
    "[profile]\nkind = \"hertz\"\nR = \"2\"\n[load]\na = \"1.5\"\ncontact_modulus = \"3\"\n",
    "[profile]\nkind = \"flat-and-rounded\"\nt = \"0.5\"\nR = \"1\"\n[load]\na = \"1\"\n"
    "contact_modulus = \"1\"\n",
    "[profile]\nkind = \"tilted-wedge\"\nphi = \"0.1\"\nalpha = \"0.04\"\n[load]\na = \"1\"\n"
    "contact_modulus = \"1\"\n",
    "[profile]\nkind = \"power-law\"\nm = \"3\"\nC = \"0.2\"\n[load]\na = \"0.3\"\n"
    "contact_modulus = \"70000\"\n",
};

} // namespace

TEST_CASE("no wrong mesh passes: shifts, parts, holes, few nodes, nodes that are off") {
    std::uint64_t seed = 1;
    for (const char* const scene : drawn_scenes) {
        const ExactContact contact = contact_of_text(scene);
        for (int round = 0; round < 8; ++round) {
            DrawnMeshes draw(contact, ++seed);
            for (const Wrong& wrong : wrong_meshes(draw, contact)) {
                CAPTURE(std::string(scene));
                CAPTURE(seed);
                CAPTURE(std::string(wrong.what));
                if (wrong.rows.size() < 2) {
                    continue;
                }
                const std::string text = text_of(wrong.rows);
                CHECK_FALSE(judged(text, contact).passes());
            }
        }
    }
}

TEST_CASE("right meshes pass: exact values, means over elements, noise of three thousandths") {
    std::uint64_t seed = 100;
    for (const char* const scene : drawn_scenes) {
        const ExactContact contact = contact_of_text(scene);
        for (int round = 0; round < 8; ++round) {
            CAPTURE(std::string(scene));
            CAPTURE(seed);
            DrawnMeshes draw(contact, ++seed);
            Rows rows = draw.right();
            CHECK(judged(text_of(rows), contact).passes());
            for (auto& [x, p] : rows) {
                p *= 1 + draw.number(-0.003, 0.003);
            }
            CHECK(judged(text_of(rows), contact).passes());
        }
    }
    // The means of p over elements, at their middles, without two elements at each edge.
    Tolerances zone;
    zone.zone = parse_edge_zone("2e");
    for (const int n : {16, 20, 25, 32, 47, 64, 101, 200}) {
        CAPTURE(n);
        const double h = 4.0 / n;
        std::vector<double> middles;
        for (int i = 0; i < n; ++i) {
            middles.push_back(-2 + (i + 0.5) * h);
        }
        CHECK(judged(table(middles, [=](double x) { return smeared(x, h); }), exact(), zone)
                  .passes());
    }
}

TEST_CASE("pressures outside count relative to the peak, rows of one x with equal weights") {
    const std::vector<double> places = even_places(-2, 2, 64);
    const auto outside = table(places, [](double x) { return std::abs(x) < a ? p(x) : 0.1 * p0; });
    std::string between = "x,p\n"; // a wrong row between two right ones
    for (const double x : places) {
        for (const double value : {p(x), 2 * p(x), p(x)}) {
            between += number(x) + "," + number(value) + "\n";
        }
    }
    Tolerances t;
    t.of = Norm::local;
    const FileComparison local = judged(outside, exact(), t);
    CHECK(local.errors.local == doctest::Approx(0.1).epsilon(1e-9));
    CHECK(local.failures.front().find("10 % of the peak") != std::string::npos);
    t.of = Norm::l2;
    const FileComparison l2 = judged(between, exact(), t);
    CHECK(l2.errors.l2 == doctest::Approx(std::sqrt(1.0 / 3)).epsilon(1e-9));
    CHECK_FALSE(l2.passes());
}

TEST_CASE("a tolerance of gap, slip and sxx without data fails, with the reason") {
    const Scene scene = parse_scene(edgeproof::hertz_data::scene_text, "hertz.toml");
    // Johnson, eq. 4.43: the gap from its slope; without shear sxx = -p on the surface.
    const auto gap = [](double x) {
        const double t = std::max(1.0, std::abs(x) / a);
        return p0 * a / 3 * (t * std::sqrt(t * t - 1) - std::acosh(t));
    };
    const auto judged_with = [&](const char* name, const std::function<std::string(double)>& cell) {
        std::string text = std::string("x,") + name + ",p\n";
        for (const double x : even_places(-2, 2, 64)) {
            text += number(x) + "," + cell(x) + "," + number(p(x)) + "\n";
        }
        Tolerances t;
        t.surface = 0.03;
        t.partial = true;
        FileComparison file = judged(text, exact(), t);
        compare_surface(file, scene, exact(), t);
        return file.passes() ? "passes" : file.failures.front();
    };
    const auto right = [&](double x) { return number(gap(x)); };
    CHECK(judged_with("gap", right) == "passes");
    CHECK(judged_with("sxx", [](double x) { return number(-p(x)); }) == "passes");
    struct Case {
        const char* name;
        std::function<std::string(double)> cell;
        const char* reason;
    };
    const Case cases[] = {
        {"other", right, "neither gap nor slip nor sxx is compared"},
        {"gap", [](double) { return ""; }, "neither gap nor slip nor sxx is compared"},
        {"gap", [&](double x) { return x < 1.9 ? "" : right(x); }, "2 of the nodes outside"},
        {"gap", [&](double x) { return std::abs(x) < a ? right(x) : ""; }, "0 of the nodes"},
        {"gap", [&](double x) { return x < 1.9 ? right(x) : "nan"; }, "its cell in line 65"},
        {"gap", [&](double x) { return x > -2 ? right(x) : "open"; }, "its cell in line 2"},
        {"slip", right, "slip is not compared: the scene has no friction"},
        {"slip", [](double) { return "0"; }, "neither gap nor slip nor sxx is compared"},
        {"sxx", [](double x) { return x == 0 ? "-1.125" : ""; }, "1 of the nodes outside the edge"},
    };
    for (const Case& one : cases) {
        CAPTURE(std::string(one.reason));
        const std::string found = judged_with(one.name, one.cell);
        CHECK_MESSAGE(found.find(one.reason) != std::string::npos, found);
    }
}

TEST_CASE("half of a contact must begin in its middle, and --partial compares p alone") {
    CHECK(judged(table(even_places(0, 2, 32), p), exact()).passes());
    const auto late = table(even_places(0.3, 2, 32), p);
    CHECK_FALSE(judged(late, exact()).passes());
    Tolerances part;
    part.partial = true;
    CHECK(judged(late, exact(), part).passes());
    part.force = 0.01; // these data do not determine the force
    CHECK_FALSE(judged(late, exact(), part).passes());
    const auto middle = table(even_places(-0.03, 0.03, 3), p); // the four nodes of a false pass
    part = {};
    const FileComparison four = judged(middle, exact(), part);
    CHECK(four.undetermined.size() == 3); // a, b and P
    part.partial = true;
    CHECK(judged(middle, exact(), part).passes());
    part.edges = 0.01;
    CHECK(judged(middle, exact(), part).failures.size() == 2);
}

TEST_CASE("a mesh that misses the peak of a sharp punch does not determine it") {
    const ExactContact sharp = contact_of_text(
        "[profile]\nkind = \"flat-and-rounded\"\nt = \"0.99\"\nR = \"1\"\n[load]\na = \"1\"\n"
        "contact_modulus = \"1\"\n");
    const auto text = [&](int n) {
        return table(even_places(-1.05, 1.05, n), [&](double x) { return sharp.pressure(x); });
    };
    const FileComparison coarse = judged(text(21), sharp);
    CHECK_FALSE(coarse.passes());
    CHECK(coarse.failures.front().find("the largest p is not determined") != std::string::npos);
    CHECK(judged(text(2100), sharp).passes());
}

TEST_CASE("digits that hide more than the tolerance, and numbers that overflow, do not pass") {
    // The values 0 and 1 for a pressure up to 9/8: half a unit of the last digit is 44 % of the
    // peak.
    const auto whole = [](double x) { return std::round(p(x)); };
    std::string text = "x,p\n";
    for (const double x : even_places(-2, 2, 64)) {
        text += number(x) + "," + std::to_string(static_cast<int>(whole(x))) + "\n";
    }
    const FileComparison file = judged(text, exact());
    CHECK_FALSE(file.passes());
    CHECK(file.failures.front().find("too few digits") != std::string::npos);
    for (const char* const cell : {"nan", "inf", "-inf", "1e309", "1e400", "NaN", "1.#INF", "****",
                                   "-1.#IND", "--", "n/a"}) {
        CAPTURE(std::string(cell));
        CHECK_THROWS_AS((void)parse_result("x,p\n-1,0\n0," + std::string(cell) + "\n1,0\n", "r"),
                        InputError);
        CHECK_THROWS_AS((void)parse_result("x,p\n-1,0\n" + std::string(cell) + ",1\n1,0\n", "r"),
                        InputError);
    }
    ResultReading reading;
    parse_scale("p=1e309", reading);
    try {
        (void)parse_result("x,p\n-1,0\n0,1\n1,0\n", "r.csv", reading);
        FAIL("a pressure of 1e309 is read");
    } catch (const InputError& error) {
        CHECK(std::string(error.what()).starts_with("r.csv:3: '1' times its scale"));
    }
    CHECK_FALSE(compare_file(parse_result("x,p\n-2,0\n-1,0\n0,0\n1,0\n2,0\n", "r.csv", reading),
                             exact(), {}, Rational(0))
                    .passes());
}
