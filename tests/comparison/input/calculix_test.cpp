// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/comparison/comparison.hpp"
#include "edgeproof/comparison/input/result_lines.hpp"
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/comparison/hertz_data.hpp"
#include "tests/support/namespaces.hpp"
#include "tests/support/paths.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

namespace {

/// A run of CalculiX 2.20 with the deck of examples/third-party/solvers/calculix.py (24 elements, 4
/// mm) and output of contact and stresses. Of the nodes and elements of the .frd file, only those
/// of the results are kept, and two others.
std::filesystem::path run_of_calculix() {
    return test::source_dir() / "tests" / "comparison" / "calculix" / "cylinder.frd";
}

std::string calculix_text() { return io::read_text(run_of_calculix(), "result"); }

std::string refusal_of_calculix(const std::string& text) {
    try {
        (void)parse_result(text, "r.frd");
    } catch (const InputError& error) {
        CHECK(std::string(error.what()).find('\n') == std::string::npos);
        return error.what();
    }
    FAIL("accepted");
    return {};
}

std::string changed_text(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

FileComparison compared_run(const Tolerances& tolerances) {
    const Scene scene =
        read_scene(test::source_dir() / "examples" / "third-party" / "solvers" / "hertz.toml");
    const ExactContact exact(scene);
    FileComparison file =
        compare_file(read_result(run_of_calculix()), exact, tolerances, Rational(0));
    compare_surface(file, scene, exact, tolerances);
    return file;
}

} // namespace

TEST_CASE("CalculiX: the nodes of an .frd file, joined with their places") {
    const ResultTable frd = read_result(run_of_calculix());
    REQUIRE(frd.rows.size() == 25); // one of the two planes of nodes
    for (std::size_t i = 0; i < 25; ++i) {
        const double x = -1.5 + 0.125 * static_cast<double>(i); // 24 elements over 3 mm
        CHECK(frd.rows[i].x.convert_to<double>() == doctest::Approx(x));
        CHECK(frd.rows[i].surface[2].has_value());
    }
    // The row of node 390 (x = 0) as it stands in the file.
    CHECK(frd.rows[12].p.convert_to<double>() == doctest::Approx(10.1044));
    CHECK(frd.rows[12].line == 160);
}

TEST_CASE("CalculiX: gap and sxx are compared with the textbook's") {
    Tolerances tolerances;
    tolerances.zone = parse_edge_zone("2e");
    const FileComparison file = compared_run(tolerances);
    CHECK(file.passes());
    REQUIRE(file.surface.size() == 2);
    const SurfaceErrors& gap = file.surface[0];
    const SurfaceErrors& sxx = file.surface[1];
    CHECK(gap.name == "gap");
    CHECK(sxx.name == "sxx");
    // Johnson, eq. 4.43: a^2 = 4 P R/(pi E*); the gap outside is p_0 a/E* (t sqrt(t^2 - 1) -
    // arcosh t) with t = |x|/a, from its slope (x sqrt(1 - a^2/x^2))/R.
    const double a = std::sqrt(4 * 16 * 10e3 / (std::numbers::pi * 200e3));
    const double p0 = 2 * 16 / (std::numbers::pi * a);
    const auto gap_at = [&](double x) {
        const double t = std::abs(x) / a;
        return t > 1 ? p0 * a / 200e3 * (t * std::sqrt(t * t - 1) - std::acosh(t)) : 0;
    };
    CHECK(gap.scale == doctest::Approx(gap_at(1.5)).epsilon(1e-10));
    CHECK(gap.exact == doctest::Approx(gap_at(file.data.nodes[gap.worst].x)).epsilon(1e-10));
    CHECK(gap.peak > 1e-4); // a real mesh has an error,
    CHECK(gap.peak < 0.03); // but no large one
    CHECK(sxx.scale == doctest::Approx(p0).epsilon(1e-6));
    // Without shear sxx = -p on the surface (eq. 2.25b).
    const double at = file.data.nodes[sxx.worst].x;
    CHECK(sxx.exact ==
          doctest::Approx(-p0 * std::sqrt(std::max(0.0, 1 - at * at / (a * a)))).epsilon(1e-10));
    CHECK(sxx.peak > 1e-3);
    CHECK(sxx.peak < 0.2); // stresses are extrapolated to the nodes of the surface
    tolerances.surface = gap.peak / 2;
    const FileComparison failing = compared_run(tolerances);
    CHECK_FALSE(failing.passes());
    CHECK(failing.failures.size() == 2);
    CHECK(failing.failures[0].find("the error of gap") == 0);
    tolerances.surface = 2 * std::max(gap.peak, sxx.peak);
    CHECK(compared_run(tolerances).passes());
}

TEST_CASE("CalculiX: c_0 of 60 elements has an honest spread") {
    // calculix.py hertz.toml --elements 60, in |x| <= 1; c_0 = p_0 sqrt(2/a) (Johnson, eq. 4.45).
    const Scene scene =
        read_scene(test::source_dir() / "examples" / "third-party" / "solvers" / "hertz.toml");
    const auto file = test::source_dir() / "tests" / "comparison" / "calculix" / "hertz-60.csv";
    const FileComparison compared =
        compare_file(read_result(file), ExactContact(scene), {}, Rational(0));
    const double a = std::sqrt(4 * 16 * 10e3 / (std::numbers::pi * 200e3));
    const double c0 = 2 * 16 / (std::numbers::pi * a) * std::sqrt(2 / a);
    for (const auto& fit : compared.fits) {
        REQUIRE(fit);
        const double off = std::abs(fit->c0.value - c0);
        CHECK(off > 0.005 * c0); // the mesh is off by more than its nodes scatter,
        CHECK(off < 2 * fit->c0.spread);
        CHECK(fit->c0.spread < 0.03 * c0); // and the spread is no excuse
    }
}

TEST_CASE("CalculiX: the last of several steps is compared") {
    const std::string text = calculix_text();
    const std::size_t end = text.rfind(" 9999");
    const std::string contact = text.substr(text.rfind("  100CL", end), end);
    const std::string at = " 390-5.55188E-09 0.00000E+00 0.00000E+00"; // the middle node
    const ResultTable table = parse_result(
        text.substr(0, end) + changed_text(contact, at + " 1.01044E+01", at + " 9.91044E+01"),
        "r.frd");
    CHECK(table.rows[12].p.convert_to<double>() > 90);
    CHECK(table.findings.front().find("2 times: the last is compared") != std::string::npos);
}

TEST_CASE("CalculiX: a file that is cut, binary, or without places is refused in one line") {
    const std::string frd = calculix_text();
    const std::string head(frd.substr(0, frd.find("\n    2C")));
    const std::size_t row = frd.find(" -1       378", frd.find("-4  CONTACT"));
    const std::string line = frd.substr(row, frd.find('\n', row) + 1 - row);
    for (const auto& given : {
             std::pair{frd.substr(0, frd.find('\n', frd.find("-4  CONTACT") + 1500)),
                       "ends inside a block"},
             {head + "\n    2C      828          2\n", "in text"},
             {changed_text(frd, " -4  CONTACT", " -4  OTHERS "), "no contact output"},
             {changed_text(frd, " -5  CPRESS", " -5  CPRISS"), "CONTACT has no CPRESS"},
             {changed_text(frd, " -1       378-1.5", " -1       999-1.5"), "node 378 has no place"},
             {changed_text(frd, " -1       378-1.5", " -1       378-x.5"), "is no number"},
             {std::string(frd).insert(row, line), "node 378 has two rows"},
         }) {
        const std::string reason = given.second;
        CAPTURE(reason);
        CHECK(refusal_of_calculix(given.first).find(reason) != std::string::npos);
    }
}

TEST_CASE("slip: partial slip of a cylinder by the textbook, in either direction") {
    // Mindlin: q = f p_0 (sqrt(1 - x^2/a^2) - c/a sqrt(1 - x^2/c^2)), c/a = sqrt(1 - Q/(f P)). The
    // slope of the relative displacement of an elliptical pressure outside its zone is
    // 2 p_0/(E* a) sqrt(x^2 - c^2) (Johnson, section 4.2), so the slip at x > c is its integral.
    const Scene scene = hertz_data::scene_of_words( // a = 1, p_0 = 2/pi, c = 0.6
        "kind=hertz R=1 P=1 contact_modulus=4/pi Q=0.32 friction=0.5");
    const ExactContact exact(scene);
    const double c = 0.6;
    const double rate = 0.5 * (2 / std::numbers::pi) / (4 / std::numbers::pi) * 2;
    const auto slip_at = [&](double x) {
        const double s = std::abs(x);
        return s > c ? rate / 2 * (s * std::sqrt(s * s - c * c) - c * c * std::acosh(s / c)) : 0;
    };
    for (const double sign : {1.0, -1.0}) {
        std::string rows = "x,CPRESS,CSLIP1\n";
        for (int i = -48; i <= 48; ++i) {
            const double x = i / 40.0;
            const double p = std::abs(x) < 1 ? 2 / std::numbers::pi * std::sqrt(1 - x * x) : 0;
            rows += fmt::format("{:.12g},{:.12g},{:.12g}\n", x, p,
                                std::abs(x) < 1 ? sign * slip_at(x) : 0.0);
        }
        FileComparison file = compare_file(parse_result(rows, "r.csv"), exact, {}, Rational(0));
        compare_surface(file, scene, exact, {});
        REQUIRE(file.surface.size() == 1);
        CHECK(file.surface[0].name == "slip");
        CHECK(file.surface[0].peak < 1e-9);
        CHECK(file.surface[0].scale == doctest::Approx(slip_at(0.975)).epsilon(1e-9));
    }
}

namespace {

/// An .frd file as CalculiX writes it for contact from surface to surface: each node of the model
/// has a row, of zeros if it is in no face in contact. The surface is y = -x^2/100, there are nodes
/// below it and of another body above it; the second tangential direction lies along x. There are
/// `planes` of nodes in z, 1/2 apart. `order`: the coordinates of the file, such as "xyz".
std::string frd_of_surface_to_surface(const std::string& order, int planes) {
    std::string nodes;
    std::string contact;
    int number = 0;
    for (int i = -8; i <= 8; ++i) {
        const double x = 0.25 * i;
        const double surface = -x * x / 100;
        for (int plane = 0; plane < planes; ++plane) {
            int row = 0;
            for (const double y : {surface, surface - 0.25, surface - 0.5, 0.0}) {
                ++number;
                nodes += fmt::format(" -1{:10d}", number);
                for (const char axis : order) {
                    nodes += fmt::format("{:12.5E}", axis == 'x'   ? x
                                                     : axis == 'y' ? y
                                                                   : 0.5 * plane);
                }
                nodes += "\n";
                const double p = row++ == 0 && std::abs(x) <= 1 ? 10 - 9 * x * x : 0;
                contact +=
                    fmt::format(" -1{:10d}{:12.5E}{:12.5E}{:12.5E}{:12.5E}{:12.5E}{:12.5E}\n",
                                number, -p / 1e6, 0.0, p / 1e7, p, 0.0, -p / 10);
            }
        }
    }
    std::string components;
    for (const char* name : {"COPEN", "CSLIP1", "CSLIP2", "CPRESS", "CSHEAR1", "CSHEAR2"}) {
        components += fmt::format(" -5  {:<8}    1    4    1    1\n", name);
    }
    return fmt::format("    1C\n    2C  {:10d}  {:37d}\n", number, 1) + nodes + " -3\n" +
           fmt::format("  100CL  101 1.000000000{:12d}                     0    1           1\n",
                       number) +
           " -4  CONTACT     6    1\n" + components + contact + " -3\n 9999\n";
}

} // namespace

TEST_CASE(
    "CalculiX: contact from surface to surface writes zeros at all other nodes; it may lie along "
    "each coordinate, and the normal too") {
    for (const std::string order : {"xyz", "xzy", "yxz", "zxy", "yzx", "zyx"}) {
        for (const int planes : {1, 3}) {
            CAPTURE(order);
            CAPTURE(planes);
            const ResultTable table =
                parse_result(frd_of_surface_to_surface(order, planes), "r.frd");
            REQUIRE(table.rows.size() == 15); // 9 in contact, and 3 further on each side
            for (std::size_t i = 0; i < table.rows.size(); ++i) {
                const ResultRow& row = table.rows[i];
                const double x = -1.75 + 0.25 * static_cast<double>(i);
                const double p = std::abs(x) <= 1 ? 10 - 9 * x * x : 0;
                CHECK(row.x.convert_to<double>() == doctest::Approx(x));
                CHECK(row.p.convert_to<double>() == doctest::Approx(p));
                CHECK(row.q->convert_to<double>() == doctest::Approx(-p / 10));
                CHECK(row.surface[0].has_value() == (p > 0));
                CHECK(row.surface[1].has_value() == (p > 0));
            }
            CHECK(table.findings.front().find("CSHEAR2 and CSLIP2 are compared") == 0);
            const auto says = [&](const std::string& words) {
                return std::ranges::any_of(table.findings, [&](const std::string& finding) {
                    return finding.find(words) != std::string::npos;
                });
            };
            const std::size_t along = order.find('x');
            CHECK(says(fmt::format("x is COORD{}, along which", along + 1)) == (along != 0));
            CHECK(says(fmt::format("lie in 3 planes: those at COORD{} = 0", order.find('z') + 1)) ==
                  (planes == 3));
        }
    }
}

TEST_CASE("CalculiX: stress along a contact that does not lie along x is SYY or SZZ") {
    const auto replaced = [](std::string text, const std::string& from, const std::string& to) {
        for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
            text.replace(at, from.size(), to);
        }
        return text;
    };
    // The places of the nodes with the first two coordinates exchanged, and the stresses too.
    std::string turned;
    bool nodes = false;
    const std::string text = calculix_text();
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        std::string line = text.substr(at, end - at);
        nodes = line.starts_with("    2C") || (nodes && !line.starts_with(" -3"));
        if (nodes && line.starts_with(" -1")) {
            line = line.substr(0, 13) + line.substr(25, 12) + line.substr(13, 12) + line.substr(37);
        }
        turned += line + "\n";
        at = end + 1;
    }
    turned = replaced(replaced(replaced(turned, "-5  SXX", "-5  S**"), "-5  SYY", "-5  SXX"),
                      "-5  S**", "-5  SYY");
    const ResultTable as_it_is = parse_result(text, "r.frd");
    const ResultTable along_y = parse_result(turned, "r.frd");
    REQUIRE(along_y.rows.size() == as_it_is.rows.size());
    for (std::size_t i = 0; i < along_y.rows.size(); ++i) {
        CHECK(along_y.rows[i].x == as_it_is.rows[i].x);
        CHECK(along_y.rows[i].p == as_it_is.rows[i].p);
        CHECK(along_y.rows[i].surface[2] == as_it_is.rows[i].surface[2]);
    }
}

TEST_CASE("CalculiX: a .dat file, without places, is refused with what to write") {
    for (const char* const title :
         {" contact stress (slave element+face,press,tang1,tang2) for all contact elements",
          " contact stress (slave node,press,tang1,tang2) for all contact elements"}) {
        CHECK(refusal_of_calculix(std::string(title) +
                                  " and time 0.1000000E+01\n\n"
                                  "      1217  5.308512E+00 -4.030666E-01  0.000000E+00\n")
                  .find("give the .frd file") != std::string::npos);
    }
}
