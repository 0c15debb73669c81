// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/comparison/comparison.hpp"
#include "edgeproof/io/text_file.hpp"
#include "tests/comparison/hertz_data.hpp"
#include "tests/support/namespaces.hpp"
#include "tests/support/paths.hpp"

#include <doctest/doctest.h>

#include <sstream>

using namespace edgeproof::hertz_data;

namespace {

/// A Hertz contact with P = 1, a = 1: E*/R = 4/pi (Johnson, eq. 4.43), p_0 = 2/pi.
Diagnosed sheared(const std::string& shear) {
    return Diagnosed(scene_of_words("kind=hertz R=1 P=1 contact_modulus=4/pi " + shear));
}

const double unit_p0 = 2 / std::numbers::pi;
/// p under the force L, for which a = sqrt(L).
double p_under(double L, double x) { return x * x < L ? unit_p0 * std::sqrt(L - x * x) : 0; }
double unit_p(double x) { return p_under(1, x); }

/// Returns rows of x, p and q, which are 0 at the edges and outside.
std::string shear_rows(const std::function<double(double)>& q, double P = 1) {
    std::string text = "x,CPRESS,CSHEAR1\n";
    for (const double x : even_places(-1.2, 1.2, 96)) {
        text += number(x) + "," + number(p_under(P, x)) + "," +
                number(std::abs(x) < 1 - 1e-12 ? q(x) : 0) + "\n";
    }
    return text;
}

FileComparison shear_held(const std::string& shear, const std::string& rows,
                          const Tolerances& t = {}) {
    return sheared(shear).of(rows, t);
}

Tolerances shear_within(double tolerance) {
    Tolerances t;
    t.pressure = tolerance;
    t.zone = parse_edge_zone("0.001");
    return t;
}

} // namespace

TEST_CASE("shear: full stick by the textbook, in either direction of q; its errors at their size") {
    // q = (Q/pi + sigma_0 x/4)/sqrt(1 - x^2) with a = b = 1 (Johnson, eq. 7.22, with the signs of
    // src/edgeproof/contact/law/shear.hpp).
    const std::string shear = "Q=0.2 bulk_tension=0.1";
    const auto q = [](double x) {
        return (0.2 / std::numbers::pi + 0.1 * x / 4) / std::sqrt(1 - x * x);
    };
    const FileComparison right = shear_held(shear, shear_rows(q), shear_within(1e-10));
    CHECK_MESSAGE(right.passes(), right.failures[0]);
    REQUIRE(right.shear);
    CHECK(right.shear->local < 1e-11);
    REQUIRE(right.Q);
    CHECK(*right.Q == doctest::Approx(*right.Q_of_exact).epsilon(1e-12));
    CHECK(*right.Q == doctest::Approx(0.2).epsilon(0.1)); // q is infinite at the edges
    const FileComparison turned =
        shear_held(shear, shear_rows([&](double x) { return -q(x); }), shear_within(1e-10));
    CHECK(turned.passes());
    CHECK(has_finding(turned, "q has the opposite sign"));
    // An error of 0.01 at one node, relative to |Q|/2 + |sigma_0|/4 = 0.125.
    const FileComparison off = shear_held(
        shear, shear_rows([&](double x) { return q(x) + (std::abs(x) < 1e-9 ? 0.01 : 0); }),
        shear_within(0.079));
    CHECK_FALSE(off.passes());
    CHECK(off.shear->peak == doctest::Approx(0.08).epsilon(1e-9));
    CHECK(off.failures[0].find("the error of q, 8 %") != std::string::npos);
    Tolerances apart = shear_within(1e-10);
    apart.q = 0.081;
    CHECK(shear_held(shear,
                     shear_rows([&](double x) { return q(x) + (std::abs(x) < 1e-9 ? 0.01 : 0); }),
                     apart)
              .passes());
}

TEST_CASE("shear: partial slip by Cattaneo and Mindlin, with a tension by Nowell and Hills") {
    // f = 0.5, Q = 0.315: c^2 = 1 - Q/(f P) = 0.37. A tension moves the stick zone by sigma_0 a/(4
    // f p_0) (D. A. Hills, D. Nowell, Mechanics of Fretting Fatigue, section 4.4). A positive one
    // moves it to the left, because it pulls the right edge in the direction of Q, so that more
    // slips there.
    const double f = 0.5;
    const double c = std::sqrt(0.37);
    for (const double tension : {0.0, 0.06, -0.03}) {
        CAPTURE(tension);
        const double e = -tension / (4 * f * unit_p0);
        const auto q = [&](double x) {
            const double y = (x - e) / c;
            return f * (unit_p(x) - (std::abs(y) < 1 ? unit_p0 * c * std::sqrt(1 - y * y) : 0));
        };
        const std::string shear = "Q=0.315 friction=0.5 bulk_tension=" + number(tension);
        const FileComparison file = shear_held(shear, shear_rows(q), shear_within(1e-8));
        CHECK_MESSAGE(file.passes(), file.failures[0]);
        REQUIRE(file.shear);
        CHECK(file.shear->nodes > 75);
        CHECK(file.shear->peak < 1e-9);
        CHECK(*file.Q == doctest::Approx(0.315).epsilon(0.01));
        // The mirrored traction differs if there is a tension.
        const FileComparison mirrored =
            shear_held(shear, shear_rows([&](double x) { return q(-x); }), shear_within(1e-8));
        CHECK(mirrored.passes() == (tension == 0));
    }
}

TEST_CASE("shear: loads that grow together; q without shear, and shear without q") {
    const FileComparison together =
        shear_held("Q=0.3 path=together", shear_rows([](double x) { return 0.3 * unit_p(x); }),
                   shear_within(1e-10));
    CHECK(together.passes());
    CHECK(together.shear->nodes > 80);
    const FileComparison none =
        shear_held("Q=0.3", table(even_places(-1.2, 1.2, 96), unit_p), shear_within(1e-10));
    CHECK(none.passes());
    CHECK_FALSE(none.shear);
    CHECK(has_finding(none, "the data have no q"));
    Tolerances asked;
    asked.q = 1e-3;
    CHECK_FALSE(shear_held("Q=0.3", table(even_places(-1.2, 1.2, 96), unit_p), asked).passes());
    const FileComparison no_shear = compared(table(even_places(-2, 2, 96), p), asked);
    CHECK_FALSE(no_shear.passes());
    CHECK(no_shear.failures.front() == "q is not compared: the scene has no [shear]");
    const FileComparison unasked =
        compared("x,p,q\n-2,0,0\n-1,0.8385254915624212,1\n0,1.125,1\n1,0.8385254915624212,1\n");
    CHECK_FALSE(unasked.shear);
    CHECK(has_finding(unasked, "the scene has no [shear]"));
}

TEST_CASE("shear: the zone left out at the edges is left out at those of the stick zone, too") {
    // Mindlin: q = f p_0 (sqrt(1 - x^2) - c sqrt(1 - x^2/c^2)), c = sqrt(1 - Q/(f P)) = 0.6.
    const std::string shear = "Q=0.32 friction=0.5";
    const double c = 0.6;
    // A mesh is wrong next to c, where the slope of q is infinite.
    const auto wrong_at = [&](double place, double by) {
        return shear_rows([=](double x) {
            const double stuck = std::abs(x) < c ? c * std::sqrt(1 - x * x / (c * c)) : 0;
            const double q = 0.5 * unit_p0 * (std::sqrt(1 - x * x) - stuck);
            return q + (std::abs(std::abs(x) - place) < 1e-9 ? by : 0);
        });
    };
    Tolerances none;
    none.pressure = 1e-8;
    CHECK_FALSE(shear_held(shear, wrong_at(0.6, 0.05), none).passes());
    const FileComparison in_zone = shear_held(shear, wrong_at(0.6, 0.05), shear_within(1e-8));
    CHECK_MESSAGE(in_zone.passes(), in_zone.failures[0]);
    CHECK_FALSE(shear_held(shear, wrong_at(0.575, 0.05), shear_within(1e-8)).passes());
    CHECK_FALSE(shear_held(shear, wrong_at(0.625, 0.05), shear_within(1e-8)).passes());
    // Data of which the zones leave no node are not right.
    Tolerances wide = none;
    wide.zone = parse_edge_zone("0.65");
    const FileComparison nothing = shear_held(shear, wrong_at(0.6, 0.05), wide);
    REQUIRE(nothing.shear);
    CHECK(nothing.shear->nodes == 0);
    CHECK_FALSE(nothing.passes());
    // A q outside the contact counts relative to the scale of q.
    Tolerances local = shear_within(0.03);
    local.of = Norm::local;
    CHECK(shear_held(shear, wrong_at(0.6, 0), local).passes());
    const FileComparison outside = shear_held(shear, wrong_at(0.6, 0) + "1.11,0,0.05\n", local);
    CHECK(outside.shear->local == doctest::Approx(0.05 / 0.16).epsilon(1e-9)); // |Q|/(a + b)
    CHECK_FALSE(outside.passes());
}

TEST_CASE("shear: q that is written with too few digits hides its errors, and does not pass") {
    const auto zero = [](double) { return 0.0; };
    const FileComparison file =
        shear_held("Q=0.2 friction=0.6", shear_rows(zero), shear_within(0.03));
    REQUIRE_FALSE(file.passes());
    CHECK(file.failures.back().starts_with("q is written with too few digits: they hide errors"));
}

namespace {

/// A Hertz contact with f = 0.5 and a = 1 under P = 1 (E*/R = 4/pi, Johnson, eq. 4.43). Q grows to
/// 0.315, then reverses to -0.1; at last P falls to 0.64, so that a = 0.8.
const std::string steps_scene = R"([profile]
kind = "hertz"
R = "1"
[load]
contact_modulus = "4/pi"
[shear]
friction = "0.5"
[[step]]
P = "1"
[[step]]
Q = "0.315"
[[step]]
Q = "-0.1"
[[step]]
P = "0.64"
Q = "0"
)";

/// After Q = 0.315: f (p - p(L_s)) with f (1 - L_s) = 0.315 (Johnson, section 7.2).
double q_after_2(double x) { return 0.5 * (p_under(1, x) - p_under(0.37, x)); }
/// After Q = -0.1: the reversal adds -2 f (p - p(L_r)) with 2 f (1 - L_r) = 0.415 (Mindlin and
/// Deresiewicz; Johnson, section 7.4).
double q_after_3(double x) { return q_after_2(x) - (p_under(1, x) - p_under(0.585, x)); }
/// After P = 0.64, Q = 0: the layers above 0.64 are gone; -0.5 from 0.585 to 0.64, 0.5 from 0.37 to
/// 0.585. The force -0.5 * 0.055 + 0.5 * 0.215 = 0.08 is too large: the zone outside L_s slips,
/// with -0.5 from L_s, 0.5 from 0.37: L_s - 0.37 = 0.64 - L_s.
double q_after_4(double x) {
    return 0.5 * (2 * p_under(0.505, x) - p_under(0.37, x) - p_under(0.64, x));
}

FileComparison after_step(std::size_t step, const std::string& rows) {
    Scene scene = parse_scene(steps_scene, "s.toml");
    set_step(scene, step);
    return Diagnosed(scene).of(rows, shear_within(1e-8));
}

} // namespace

TEST_CASE("steps: the shear traction of Hertz by superposition, after each step") {
    const auto right = [](std::size_t step, double P, const std::function<double(double)>& q) {
        CAPTURE(step);
        const FileComparison file = after_step(step, shear_rows(q, P));
        CHECK_MESSAGE(file.passes(), file.failures[0]);
        REQUIRE(file.shear);
        CHECK(file.shear->nodes > 60);
        CHECK(file.shear->peak < 1e-9);
    };
    right(2, 1, q_after_2);
    right(3, 1, q_after_3);
    right(4, 0.64, q_after_4);
}

TEST_CASE("steps: the mistakes in a load history are named") {
    const auto named = [](const std::string& cause, const std::function<double(double)>& q) {
        CAPTURE(cause);
        const FileComparison file = after_step(3, shear_rows(q));
        CHECK_FALSE(file.passes());
        CHECK(is_named(file.shear_diagnosis, cause));
    };
    named("another-step", q_after_2);
    // P = 1, then Q = -0.1 at once: f (1 - L_s) = 0.1.
    named("no-history", [](double x) { return -0.5 * (p_under(1, x) - p_under(0.8, x)); });
    // Half of each Q: f (1 - L_s) = 0.1575, then 2 f (1 - L_r) = 0.2075.
    named("half-shear-force", [](double x) {
        return 0.5 * (p_under(1, x) - p_under(0.685, x)) - (p_under(1, x) - p_under(0.7925, x));
    });
}

TEST_CASE("samples of a line through a mesh are not its elements") {
    const auto through = [](double element) {
        return [element](double x) {
            const double left = element * std::floor(x / element);
            return p(left) + (p(left + element) - p(left)) * (x - left) / element;
        };
    };
    struct Case {
        double element; ///< 0: none, the curve itself
        double step;
    };
    for (const Case& c : {Case{0.1, 0.02}, Case{0.1, 0.0171}, Case{0.25, 0.05}, Case{0.05, 0.025},
                          Case{0, 0.02}, Case{0, 0.0003}}) {
        const double element = c.element;
        const double step = c.step;
        CAPTURE(element);
        CAPTURE(step);
        const int n = static_cast<int>(4 / step);
        const auto places = even_places(-n * step / 2, n * step / 2, n);
        const FileComparison file =
            compared(element > 0 ? table(places, through(element)) : table(places, p), within(0.2));
        const double right = element > 0 ? element : step;
        CHECK(file.contact.mean_element == doctest::Approx(right).epsilon(0.1));
        CHECK(file.contact.element[0] == doctest::Approx(right).epsilon(0.2));
        CHECK(has_finding(file, "samples of a line") == (element > 0));
    }
}

TEST_CASE("meshes that smear the edge: orders") {
    std::vector<FileComparison> files;
    for (const int n : {32, 64, 128, 256}) {
        const double h = 4.0 / n;
        Tolerances t;
        t.zone = parse_edge_zone("2e");
        files.push_back(
            compared(table(even_places(-2, 2, n), [h](double x) { return smeared(x, h); }), t));
        CHECK(files.back().passes());
    }
    const auto list = convergence_of(files, exact());
    const auto of = [&](const std::string& name) {
        for (const Convergence& c : list) {
            if (c.quantity == name) {
                return c;
            }
        }
        return Convergence{};
    };
    // In the middle, the error of a mean over h is h^2 p''/24.
    CHECK(of("p_max").order.value() == doctest::Approx(2).epsilon(0.01));
    REQUIRE(of("l2").order);
    CHECK(*of("l2").order > 0.5);
}

TEST_CASE("the allowance for a mesh is that of the committed runs of CalculiX") {
    std::istringstream rows(io::read_text(
        test::source_dir() / "examples" / "third-party" / "solvers" / "mesh-errors.csv", "table"));
    double greatest = 0;
    std::size_t count = 0;
    for (std::string line; std::getline(rows, line);) {
        if (!line.starts_with('#') && !line.starts_with("contact")) {
            greatest = std::max(greatest, std::stod(line.substr(line.rfind(',') + 1)));
            ++count;
        }
    }
    CHECK(count >= 8);
    CHECK(greatest <= mesh_error_times_elements);
    CHECK(greatest > 0.75 * mesh_error_times_elements); // and not much more
}
