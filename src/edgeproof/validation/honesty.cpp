// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/validation/honesty.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/rounding/digits_right.hpp"
#include "edgeproof/validation/enclosed_value.hpp"
#include "edgeproof/validation/plain_tanh_sinh.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
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

} // namespace edgeproof::validation
