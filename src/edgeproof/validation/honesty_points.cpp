// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/validation/honesty.hpp"

#include <array>
#include <sstream>

namespace edgeproof::validation {
namespace {

constexpr unsigned written_digits = 80;

struct Asked {
    const char* regime;
    std::array<const char*, 3> u; ///< in units of a = 1
};

/// A family of contacts with a = 1, E* = 1.
struct Family {
    const char* name;
    const char* profile;
    std::array<const char*, 3> near_knot; ///< u of points near the knot or the apex
    /// K, m, t, gamma; K empty: no integral.
    std::array<const char*, 4> integral;
};

const std::array<Family, 6> families{{
    {"Hertz",
     "kind = \"power-law\"\nm = \"1\"\nC = \"1\"",
     {"1 - 1e-4", "1 - 1e-8", "1 - 1e-12"},
     {"pi/2", "1", "0", "1"}},
    {"power law, m = 1/2",
     "kind = \"power-law\"\nm = \"1/2\"\nC = \"1\"",
     {"1 - 1e-4", "1 - 1e-8", "1 - 1e-12"},
     // (m + 1) C sqrt(pi)/2 gamma(5/4)/gamma(7/4)
     {"3/4*sqrt(pi)*gamma(5/4)/gamma(7/4)", "1/2", "0", "1"}},
    {"wedge",
     "kind = \"power-law\"\nm = \"0\"\nC = \"1\"",
     {"1 - 1e-4", "1 - 1e-8", "1 - 1e-12"},
     {"1", "0", "0", "1"}},
    {"flat-and-rounded, t/a = 0.4",
     "kind = \"flat-and-rounded\"\nt = \"0.4\"\nR = \"1\"",
     {"0.6 - 1e-4", "0.6 + 1e-8", "0.6 - 1e-12"},
     {"1", "0", "0.4", "1"}},
    {"tilted wedge",
     "kind = \"tilted-wedge\"\nphi = \"pi/16\"\nalpha = \"pi/32\"",
     {"1 - 1e-4", "1 - 1e-8", "1 - 1e-12"},
     // The angle of the apex is h = 3 pi/4 (phi = 2 alpha), so that gamma = cot^2(3 pi/8).
     {"pi/16/tan(3*pi/8)", "0", "0", "1/tan(3*pi/8)^2"}},
    {"tilted flat-and-rounded",
     "kind = \"tilted-flat-and-rounded\"\nalpha = \"1/10\"\nt = \"1/2\"\nR = \"2\"",
     {"6/5 - 1e-4", "6/5 + 1e-8", "6/5 - 1e-12"},
     {"", "", "", ""}},
}};

} // namespace

std::vector<HonestyPoint> honesty_points() {
    std::vector<HonestyPoint> points;
    for (const Family& f : families) {
        const scene::Scene scene =
            scene::parse_scene("[profile]\n" + std::string(f.profile) +
                                   "\n[load]\na = \"1\"\ncontact_modulus = \"1\"\n",
                               f.name);
        const std::array<Asked, 4> asked{{{"u < 1e-12 a", {"1e-30", "1e-20", "1e-13"}},
                                          {"u < 1e-3 a", {"1e-9", "1e-6", "1e-4"}},
                                          {"u < a", {"1/20", "1/5", "1/2"}},
                                          {"by a knot or the apex", f.near_knot}}};
        for (const Asked& a : asked) {
            for (const char* u : a.u) {
                HonestyPoint p;
                p.id = std::to_string(points.size());
                p.profile = f.name;
                p.regime = a.regime;
                p.scene = scene;
                p.u = formula::Exact::parse(u);
                if (f.integral[0][0] != '\0') {
                    p.integral = HonestyPoint::Integral{
                        f.integral[2] != std::string("0"),    formula::Exact::parse("1"),
                        formula::Exact::parse(f.integral[0]), formula::Exact::parse(f.integral[1]),
                        formula::Exact::parse(f.integral[2]), formula::Exact::parse(f.integral[3])};
                }
                points.push_back(std::move(p));
            }
        }
    }
    return points;
}

std::string integral_questions(const std::vector<HonestyPoint>& points, unsigned digits) {
    const PrecisionScope scope(written_digits + 20);
    const auto decimal = [](const formula::Exact& x) {
        return to_decimal(x.to<Real>(), written_digits);
    };
    std::string text;
    for (const HonestyPoint& p : points) {
        if (p.integral) {
            const auto& i = *p.integral;
            text += p.id + " " + std::to_string(digits) + (i.flat ? " flat" : " power");
            for (const formula::Exact* x : {&i.a, &p.u, &i.K, &i.m, &i.t, &i.gamma}) {
                text += " " + decimal(*x);
            }
            text += "\n";
        }
    }
    return text;
}

ClaimedValues integral_answers(std::string_view text) {
    const PrecisionScope scope(written_digits);
    const auto real = [](const std::string& word) {
        Real x;
        const bool good = mpfr_set_str(x.backend().data(), word.c_str(), 10, MPFR_RNDN) == 0;
        return good ? std::optional<Real>(x) : std::nullopt;
    };
    ClaimedValues answers;
    std::istringstream in{std::string(text)};
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string id;
        std::string value;
        std::string error;
        std::string more;
        if (!(words >> id >> value >> error) || words >> more) {
            continue;
        }
        const auto x = real(value);
        const auto e = real(error);
        if (x && e) {
            answers[id] = {*x, *e};
        }
    }
    return answers;
}

} // namespace edgeproof::validation
