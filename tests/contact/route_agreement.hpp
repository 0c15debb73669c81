// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "tests/contact/scenes.hpp"

#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "tests/support/namespaces.hpp"

#include <future>
#include <string>
#include <vector>

namespace edgeproof::scenes {

struct Agreement {
    std::size_t points = 0;
    int worst_digits = 1000;
    std::string worst_place;
};

/// Returns distances from `edge`: geometric from 1e-30 of the contact to most of it, and 1e-20 of
/// the contact on both sides of each knot (including the apex).
inline std::vector<Real> points_of(const NormalContact& contact, Edge edge, int count) {
    const PrecisionScope scope(contact.digits() + 80);
    std::vector<Real> u;
    const Real length = contact.a() + contact.b();
    for (int k = 0; k < count; ++k) {
        u.push_back(Real(length * pow(Real(10), Real(-30 * k) / count) * Real(97) / 100));
    }
    for (const Exact& knot : contact.profile().knots()) {
        const Real at = knot.to<Real>();
        const Real from = edge == Edge::right ? Real(contact.a() - at) : Real(contact.b() + at);
        for (const char* offset : {"1e-20", "-1e-20"}) {
            const Real d = from + Real(offset) * length;
            if (d > 0 && d < length) {
                u.push_back(d);
            }
        }
    }
    return u;
}

inline int common_digits(const Real& x, const Real& y) {
    if (x == y) {
        return 1000;
    }
    return static_cast<int>(floor(-log10(abs(x - y) / abs(y))));
}

/// Compares routes at `count` points for each contact and edge, with two threads.
inline Agreement compare_routes(const std::vector<Contact>& contacts,
                                const std::vector<Route>& routes, unsigned digits, int count) {
    const auto job = [&](std::size_t parity) {
        Agreement found;
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            if (i % 2 != parity) {
                continue;
            }
            const Contact& c = contacts[i];
            const NormalContact contact(c.profile, c.modulus, c.load, digits);
            for (const Edge edge : {Edge::right, Edge::left}) {
                if (edge == Edge::left && c.profile.symmetric()) {
                    continue;
                }
                for (const Real& u : points_of(contact, edge, count)) {
                    const Real first = contact.pressure(edge, u, routes[0]).value;
                    for (std::size_t r = 1; r < routes.size(); ++r) {
                        if (routes[r] == Route::closed_form &&
                            !BallContact::has_closed_form(c.profile)) {
                            continue;
                        }
                        const PrecisionScope scope(digits + 20);
                        const int common =
                            common_digits(contact.pressure(edge, u, routes[r]).value, first);
                        if (common < found.worst_digits) {
                            found.worst_digits = common;
                            found.worst_place = c.name +
                                                (edge == Edge::right ? ", right" : ", left") +
                                                " u = " + u.str(8) + ", " + route_name(routes[r]);
                        }
                    }
                    ++found.points;
                }
            }
        }
        return found;
    };
    auto other = std::async(std::launch::async, job, 1);
    Agreement all = job(0);
    const Agreement second = other.get();
    all.points += second.points;
    if (second.worst_digits < all.worst_digits) {
        all.worst_digits = second.worst_digits;
        all.worst_place = second.worst_place;
    }
    return all;
}

} // namespace edgeproof::scenes
