// SPDX-License-Identifier: BSD-3-Clause

#include "edgeproof/contact/axisymmetric/axisymmetric_contact.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/stress/binary64_stress.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/parallel/parallel_for.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/real.hpp"
#include "edgeproof/scene/binary64_values.hpp"
#include "edgeproof/scene/run_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <functional>
#include <numbers>
#include <optional>
#include <utility>

namespace edgeproof::scene {
namespace {

constexpr long estimate_bits = contact::Binary64Stress::field_bits;
using contact::approximate;

constexpr std::size_t lines[] = {96, 192, 384}; ///< numbers of straight lines between two knots
constexpr double most_difference = 2e-4;        ///< of the greatest value
constexpr std::size_t places_checked = 6;
constexpr std::size_t points_together = 512;

struct Components {
    double sxx;
    double szz;
    double sxz;
    double across;
    bool plane_strain;
};
using Estimate = std::function<Components(double x, double z)>;

double value_of(const Components& s, Quantity quantity) {
    const double in_plane = std::hypot((s.sxx - s.szz) / 2, s.sxz);
    switch (quantity) {
    case Quantity::sxx:
        return s.sxx;
    case Quantity::szz:
        return s.szz;
    case Quantity::sxz:
        return s.sxz;
    case Quantity::mises:
        return std::hypot(std::sqrt(3.0) * in_plane, (s.sxx + s.szz) / 2 - s.across);
    default: // tau_max, as StressState::tau_max()
        return s.plane_strain
                   ? in_plane
                   : std::max(in_plane, (std::fabs((s.sxx + s.szz) / 2 - s.across) + in_plane) / 2);
    }
}

/// Places between two knots, closer to each other near the first one, the more the greater `power`.
std::vector<double> places_between(double from, double to, std::size_t count, double power = 2) {
    std::vector<double> places;
    for (std::size_t k = 1; k < count; ++k) {
        const double t = static_cast<double>(k) / static_cast<double>(count);
        places.push_back(from + (to - from) * std::pow(t, power));
    }
    return places;
}

/// Straight lines in place of g' on one side of the origin, outwards: the knots between them, and
/// their formulas. The last line goes on beyond the edge.
struct Lines {
    std::vector<Exact> knots;
    std::vector<Expr> slopes;
};

Lines lines_of(const contact::Profile& profile, bool right, double edge, std::size_t count) {
    struct Place {
        double at;     ///< the distance from the origin
        double before; ///< the size of g' before it and after it; it does not decrease
        double after;
    };
    const auto& knots = profile.knots();
    const int sign = right ? 1 : -1;
    std::vector<Place> side;
    const auto slope = [&](std::size_t piece, double x) {
        const Expr at =
            substitute(profile.pieces()[piece].slope, "x", Expr::number(exact_rational(sign * x)));
        return approximate(formula::enclosed_constant(at, estimate_bits)) * sign;
    };
    const auto add = [&](double x, double before, double after) {
        before = std::max(before, side.empty() ? 0 : side.back().after);
        side.push_back({x, before, std::max(after, before)});
    };
    for (std::size_t i = profile.origin(); i < knots.size(); i += right ? 1 : -1) {
        const double from = std::fabs(knots[i].to<double>());
        if (from >= edge) {
            break;
        }
        const std::size_t piece = right ? i + 1 : i;
        const double after = slope(piece, from);
        const bool corner = profile.has_corner(i);
        add(from,
            i == profile.origin() ? 0
            : corner              ? slope(right ? i : i + 1, from)
                                  : after,
            i == profile.origin() && !corner ? 0 : after);
        const std::size_t next = right ? i + 1 : i - 1;
        const double to =
            next < knots.size() ? std::min(std::fabs(knots[next].to<double>()), edge) : edge;
        for (const double x : places_between(from, to, count)) {
            const double g = slope(piece, x);
            add(x, g, g);
        }
    }
    const Place& last = side.back();
    const Place& inner = side[side.size() - 2];
    const double end =
        last.after + (last.before - inner.after) / (last.at - inner.at) * (edge - last.at);
    side.push_back({edge, end, end});
    Lines found;
    for (std::size_t k = 0; k + 1 < side.size(); ++k) {
        const Rational x = exact_rational(side[k].at);
        const Rational g = exact_rational(side[k].after);
        const Rational rate =
            (exact_rational(side[k + 1].before) - g) / (exact_rational(side[k + 1].at) - x);
        if (k > 0) {
            found.knots.push_back(Exact::of(Rational(sign * x)));
        }
        found.slopes.push_back(Expr::number(Rational(sign * (g - rate * x))) +
                               Expr::number(rate) * Expr::symbol("x"));
    }
    return found;
}

/// The slope by straight lines.
contact::Profile by_lines(const contact::Profile& profile, double a, double b, std::size_t count) {
    const Lines right = lines_of(profile, true, a, count);
    const Lines left = lines_of(profile, false, b, count);
    std::vector<Exact> knots(left.knots.rbegin(), left.knots.rend());
    std::vector<Expr> slopes(left.slopes.rbegin(), left.slopes.rend());
    knots.push_back(Exact());
    knots.insert(knots.end(), right.knots.begin(), right.knots.end());
    slopes.insert(slopes.end(), right.slopes.begin(), right.slopes.end());
    return contact::Profile::piecewise(knots, slopes);
}

/// The estimate of a plane contact; nothing if its edges are not enclosed.
std::optional<Estimate> plane_estimate(Scene scene, const BallLevel& level, Body body,
                                       std::size_t count) {
    scene.profile = by_lines(*scene.profile, approximate(level.a()), approximate(level.b()), count);
    BallLevel by_line(scene, estimate_bits);
    const auto field = by_line.stress_field(body);
    if (!field) {
        return {};
    }
    const auto poisson = scene.poisson(body);
    const double nu = poisson ? poisson->to<double>() : 0;
    return [stress = contact::Binary64Stress(*field, full_stick_load(scene, body, estimate_bits)),
            nu](double x, double z) -> Components {
        const contact::Binary64StressState s = stress.at(x, z);
        return {s.sxx.middle, s.szz.middle, s.sxz.middle, nu * (s.sxx.middle + s.szz.middle), true};
    };
}

/// A place at which the rate h' of a body of revolution is given; between two of them it is a
/// straight line. They ascend, twice the same radius where h' jumps.
struct RateNode {
    double s; ///< radius (length)
    double rate;
};

using Complex64 = std::complex<double>;

/// The integrals over tau of 1/R, 1/R^3, tau/R^3, 1/(R (R + tau)) and 1/(R + tau), and of the same
/// times tau, without the factor 1/r^2 of the textbook forms: (R - tau) (R + tau) = r^2.
std::array<std::array<Complex64, 2>, 5> integrals(const Complex64& tau, double r) {
    const Complex64 R = std::sqrt(tau + Complex64(0, r)) * std::sqrt(tau - Complex64(0, r));
    const Complex64 sum = R + tau;
    const Complex64 logarithm = std::log(sum);
    const Complex64 part = tau / (sum * 2.0);
    return {{{logarithm, R},
             {-1.0 / (R * sum), -1.0 / R},
             {-1.0 / R, logarithm - tau / R},
             {-1.0 / sum, logarithm / 2.0 - part},
             {logarithm / 2.0 + part, (R * R + R * tau + tau * tau) / (sum * 3.0)}}};
}

/// The stresses at the place x and the depth z > 0 (lengths), for `scale` = E*/pi: the integrals of
/// docs/axisymmetric.md, "Inside the body", have closed forms over each line. With tau = z + i s a
/// line h' = p + q s is (p + i q z) - i q tau, and ds = -i dtau.
Components below_revolution(const std::vector<RateNode>& nodes, double scale, double poisson,
                            double x, double z) {
    const double r = std::fabs(x);
    std::array<double, 5> of{};
    auto before = integrals({z, nodes.front().s}, r);
    for (std::size_t k = 1; k < nodes.size(); ++k) {
        const auto& [from, rate] = nodes[k - 1];
        const auto here = integrals({z, nodes[k].s}, r);
        const double q = nodes[k].s > from ? (nodes[k].rate - rate) / (nodes[k].s - from) : 0;
        const Complex64 constant(rate - q * from, q * z);
        for (std::size_t n = 0; n < of.size(); ++n) {
            const Complex64 over = constant * (here[n][0] - before[n][0]) +
                                   Complex64(0, -q) * (here[n][1] - before[n][1]);
            of[n] -= over.real(); // Im(-i x) = -Re(x)
        }
        before = here;
    }
    const double I = of[0];
    const double K = z * of[2];
    const double L = z * of[3];
    const double M = (1 - 2 * poisson) * of[4];
    return {scale * (I - K + L - M), scale * (I + K), scale * z * x * of[1],
            scale * (2 * poisson * I - L + M), false};
}

std::optional<Estimate> revolution_estimate(const Scene& scene, const BallLevel& level, Body body,
                                            std::size_t count) {
    const double a = approximate(level.a());
    const BallContact* const law = level.contact().closed_form(); // with the same pressure
    const auto rate = [&](double s) {
        if (law == nullptr) {
            return approximate(dynamic_cast<const contact::AxisymmetricContact&>(level.contact())
                                   .approach_rate_at(Ball(exact_rational(s), estimate_bits)));
        }
        const double exponent = law->power_law() ? approximate(law->power_law()->exponent)
                                : law->slope().has_corner(0) ? 0
                                                             : 1;
        return approximate(law->force_rate() / law->modulus()) * std::pow(s / a, exponent);
    };
    const auto& knots = scene.profile->knots();
    std::vector<RateNode> nodes;
    for (std::size_t i = scene.profile->origin(); i < knots.size(); ++i) {
        const double from = knots[i].to<double>();
        if (from >= a) {
            break;
        }
        const double to = i + 1 < knots.size() ? std::min(knots[i + 1].to<double>(), a) : a;
        // beyond a corner h' is like (s - from)^(-1/2)
        const bool corner = scene.profile->has_corner(i) && from > 0;
        const std::vector<double> places = places_between(from, to, count, corner ? 3 : 2);
        if (corner) {
            nodes.push_back({from, nodes.empty() ? 0 : rate(std::nextafter(from, 0.0))});
        }
        nodes.push_back(
            {from, corner ? 3 * rate(places.front()) : rate(from)}); // the same integral
        for (const double s : places) {
            nodes.push_back({s, rate(s)});
        }
    }
    nodes.push_back({a, rate(a)});
    const double scale = approximate(level.contact().modulus()) / std::numbers::pi;
    return [nodes, scale, poisson = scene.poisson(body)->to<double>()](double x, double z) {
        return below_revolution(nodes, scale, poisson, x, z);
    };
}

/// The proved values at some of the points.
std::vector<double> proved_at(const Scene& scene, Quantity quantity, Body body,
                              std::span<const double> x, std::span<const double> z) {
    std::vector<double> wanted(x.size());
    std::vector<double> others(x.size());
    Binary64Stresses all{{}, others};
    for (std::size_t k = 0; k < all.of.size(); ++k) {
        all.of[k] = binary64_stresses[k] == quantity ? wanted : others;
    }
    if (!scene.poisson(body)) {
        all.of.back() = {};
    }
    compute_binary64(scene, body, x, z, all);
    return wanted;
}

} // namespace

PictureStresses picture_stresses(const Scene& scene, Quantity quantity, Body body,
                                 std::span<const double> x, std::span<const double> z) {
    Scene asked = asking(scene, {AskedValue{Quantity::sxx}}, {20, Rounding::nearest, true});
    asked.ask.in_bodies.clear();
    (void)make_plan(asked); // refuses stresses that are not computed
    if (!scene.profile || (!scene.round && scene.profile->piecewise_linear())) {
        return {proved_at(scene, quantity, body, x, z), false};
    }
    BallLevel level(asked, estimate_bits);
    for (const std::size_t count : lines) {
        const auto estimate = scene.round ? revolution_estimate(scene, level, body, count)
                                          : plane_estimate(asked, level, body, count);
        if (!estimate) {
            break;
        }
        PictureStresses found{std::vector<double>(x.size()), true};
        const std::size_t pieces = (x.size() + points_together - 1) / points_together;
        parallel::parallel_for(pieces, 0, [&](std::size_t piece) {
            check_interruption();
            const std::size_t end = std::min(x.size(), (piece + 1) * points_together);
            for (std::size_t i = piece * points_together; i < end; ++i) {
                found.values[i] = value_of((*estimate)(x[i], z[i]), quantity);
            }
        });
        const auto greatest = std::ranges::max_element(
            found.values, [](double s, double t) { return std::fabs(s) < std::fabs(t); });
        std::vector<std::size_t> checked{static_cast<std::size_t>(greatest - found.values.begin())};
        for (std::size_t k = 1; k < places_checked; ++k) {
            checked.push_back((checked.back() + x.size() * 5 / 13 + 7) % x.size());
        }
        std::vector<double> across;
        std::vector<double> depths;
        for (const std::size_t i : checked) {
            across.push_back(x[i]);
            depths.push_back(z[i]);
        }
        const std::vector<double> exact = proved_at(scene, quantity, body, across, depths);
        bool agrees = true;
        for (std::size_t k = 0; k < checked.size(); ++k) {
            const double off = std::fabs(found.values[checked[k]] - exact[k]);
            agrees = agrees && off <= most_difference * std::fabs(exact.front());
            found.values[checked[k]] = exact[k];
        }
        if (agrees) {
            return found;
        }
    }
    return {proved_at(scene, quantity, body, x, z), false};
}

} // namespace edgeproof::scene
