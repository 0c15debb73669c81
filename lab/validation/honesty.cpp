// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/validation/honesty.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "lab/validation/plain_tanh_sinh.hpp"
#include "lab/validation/value_routes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <sstream>
#include <utility>

namespace edgeproof::validation {
namespace {

constexpr unsigned log_digits = 40;

Claimed by_route(const HonestyPoint& p, contact::Route route, unsigned digits) {
    const contact::NormalContact contact(p.scene.profile.value(), p.scene.contact_modulus,
                                         p.scene.load, digits);
    const contact::Estimated e = contact.pressure(contact::Edge::right, p.u, route);
    const PrecisionScope scope(e.working_digits);
    return {e.value, Real(abs(e.value) * e.estimate)};
}

template <Arithmetic T> Claimed by_boost(const HonestyPoint& p, unsigned digits) {
    using std::acos;
    using std::pow;
    using std::sqrt;
    const PrecisionScope scope(digits);
    const auto& i = p.integral.value();
    const T a = i.a.to<T>();
    const T x = a - p.u.to<T>();
    const T K = i.K.to<T>();
    const T m = i.m.to<T>();
    const T t = i.t.to<T>();
    const T gamma = i.gamma.to<T>();
    const auto f = [&](const T& s) {
        const T rate = i.flat ? T(K * s * acos(T(t / s))) : T(K * pow(s, m));
        return T(rate / sqrt(T((s - x) * (x + gamma * s))));
    };
    const PlainIntegral<T> r = plain_tanh_sinh<T>(f, i.flat && x < t ? t : x, a);
    return {Real(T(r.value / pi<T>())), Real(T(r.error / pi<T>()))};
}

/// log10; a large negative number for 0.
double decades_of(const Real& x) {
    return x > 0 ? Real(log10(x)).convert_to<double>() : -static_cast<double>(most_digits_right);
}

void judge(HonestyRow& row, const Claimed* claimed, const Ball& exact) {
    ++row.points;
    if (claimed == nullptr || !isfinite(claimed->value)) {
        ++row.none;
        return;
    }
    const PrecisionScope scope(log_digits);
    const long bits = std::max<long>(
        exact.bits(), static_cast<long>(mpfr_get_prec(claimed->value.backend().data())));
    const Ball error = abs(Ball(Ball(claimed->value, bits) - exact));
    // An infinite or NaN error claims nothing.
    const bool counts = isfinite(claimed->error);
    const Real least = error.lower();
    if (counts && claimed->error < least) {
        ++row.understated;
    }
    const double ratio = counts ? decades_of(least) - decades_of(claimed->error)
                                : -static_cast<double>(most_digits_right);
    const unsigned right = digits_right(claimed->value, exact);
    // A claimed error of zero claims all digits.
    const Ball around =
        Ball::around(claimed->value, counts ? Real(abs(claimed->error)) : Real(1), bits);
    const unsigned said =
        counts && claimed->error == 0 ? most_digits_right : digits_right(claimed->value, around);
    if (row.points - row.none == 1 || ratio > row.worst_ratio) {
        row.worst_ratio = ratio;
        row.least_right = right;
        row.least_claimed = said;
    }
}

} // namespace

std::vector<HonestyRow> honesty(const std::vector<HonestyPoint>& points,
                                const std::vector<std::pair<std::string, ClaimedValues>>& others,
                                const HonestyOptions& options) {
    const unsigned digits = options.digits;
    using Way = std::function<std::optional<Claimed>(const HonestyPoint&)>;
    std::vector<std::pair<std::string, Way>> routes{
        {"Barber-Mossakovskii",
         [&](const HonestyPoint& p) {
             return by_route(p, contact::Route::barber_mossakovskii, digits);
         }},
        {"singular integral",
         [&](const HonestyPoint& p) {
             return by_route(p, contact::Route::singular_integral, digits);
         }},
        {"plain Boost, double", [&](const HonestyPoint& p) { return by_boost<double>(p, digits); }},
        {"plain Boost, MPFR", [&](const HonestyPoint& p) { return by_boost<Real>(p, digits); }},
    };
    for (const auto& other : others) {
        const auto& values = other.second;
        routes.emplace_back(
            other.first, [&values](const HonestyPoint& p) -> std::optional<Claimed> {
                const auto found = values.find(p.id);
                return found == values.end() ? std::nullopt : std::optional<Claimed>(found->second);
            });
    }
    std::vector<HonestyRow> rows;
    std::vector<Ball> exact;
    for (const HonestyPoint& p : points) {
        const scene::BoundedValue v =
            enclosed_value(p.scene, {.quantity = scene::Quantity::p, .u = p.u}, 2 * digits + 20);
        if (!v.proved) {
            throw BudgetError("no enclosure of p at u = " + p.u.text() + " of the " + p.profile);
        }
        exact.push_back(v.value);
    }
    std::size_t done = 0;
    for (std::size_t r = 0; r < routes.size(); ++r) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            const HonestyPoint& p = points[i];
            check_interruption();
            if (r > 1 && !p.integral) {
                continue;
            }
            std::optional<Claimed> claimed;
            try {
                claimed = routes[r].second(p);
            } catch (const std::exception&) {
                claimed.reset(); // it reported its failure
            }
            if (rows.empty() || rows.back().route != routes[r].first ||
                rows.back().profile != p.profile || rows.back().regime != p.regime) {
                rows.push_back({});
                rows.back().route = routes[r].first;
                rows.back().profile = p.profile;
                rows.back().regime = p.regime;
            }
            judge(rows.back(), claimed ? &*claimed : nullptr, exact[i]);
            if (options.progress) {
                options.progress(++done, routes.size() * points.size());
            }
        }
    }
    return rows;
}

namespace {

constexpr unsigned written_digits = 80;

struct Asked {
    const char* regime;
    std::array<const char*, 3> u; ///< in units of a = 1
};

/// A family of contacts with a = 1, E* = 1; the routes are those of docs/pressure.md.
struct Family {
    const char* name;
    scene::SceneEntries::Section profile;
    std::array<const char*, 3> near_knot; ///< u of points near the knot or the apex
    /// K, m, t, gamma; K empty: no integral.
    std::array<const char*, 4> integral;
};

const std::array<Family, 6> families{{
    {"Hertz",
     {{"kind", "power-law"}, {"m", "1"}, {"C", "1"}},
     {"1 - 1e-4", "1 - 1e-8", "1 - 1e-12"},
     {"pi/2", "1", "0", "1"}},
    {"power law, m = 1/2",
     {{"kind", "power-law"}, {"m", "1/2"}, {"C", "1"}},
     {"1 - 1e-4", "1 - 1e-8", "1 - 1e-12"},
     // (m + 1) C sqrt(pi)/2 gamma(5/4)/gamma(7/4)
     {"3/4*sqrt(pi)*gamma(5/4)/gamma(7/4)", "1/2", "0", "1"}},
    {"wedge",
     {{"kind", "power-law"}, {"m", "0"}, {"C", "1"}},
     {"1 - 1e-4", "1 - 1e-8", "1 - 1e-12"},
     {"1", "0", "0", "1"}},
    {"flat-and-rounded, t/a = 0.4",
     {{"kind", "flat-and-rounded"}, {"t", "0.4"}, {"R", "1"}},
     {"0.6 - 1e-4", "0.6 + 1e-8", "0.6 - 1e-12"},
     {"1", "0", "0.4", "1"}},
    {"tilted wedge",
     {{"kind", "tilted-wedge"}, {"phi", "pi/16"}, {"alpha", "pi/32"}},
     {"1 - 1e-4", "1 - 1e-8", "1 - 1e-12"},
     // The angle of the apex is h = 3 pi/4 (phi = 2 alpha), so that gamma = cot^2(3 pi/8).
     {"pi/16/tan(3*pi/8)", "0", "0", "1/tan(3*pi/8)^2"}},
    {"tilted flat-and-rounded",
     {{"kind", "tilted-flat-and-rounded"}, {"alpha", "1/10"}, {"t", "1/2"}, {"R", "2"}},
     {"6/5 - 1e-4", "6/5 + 1e-8", "6/5 - 1e-12"},
     {"", "", "", ""}},
}};

} // namespace

std::vector<HonestyPoint> honesty_points() {
    std::vector<HonestyPoint> points;
    for (const Family& f : families) {
        scene::Scene scene =
            scene::make_scene({"", f.profile, {{"a", "1"}, {"contact_modulus", "1"}}});
        scene.file = f.name;
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
