// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/routes/extent_scan.hpp"

#include "edgeproof/roots/extremum.hpp"

#include <algorithm>
#include <utility>

namespace edgeproof::contact {
namespace {

constexpr int per_decade = 12;        // geometric points of the scan
constexpr int decades_to_knot = 8;    // decades from a knot or the far edge at which the scan stops
constexpr int uniform_points = 32;    // between neighbouring landmarks
constexpr std::size_t look_ahead = 8; // omitted terms that determine the start of the scan

} // namespace

Real power_of_ten(int k) { return pow(Real(10), k); }

SignedError::SignedError(const NormalContact& contact, unsigned digits, Edge edge, std::size_t n)
    : contact_(Profile(contact.profile()), contact.contact_modulus(), contact.load(), digits),
      edge_(edge), c_(contact_.expansion(edge, n + look_ahead)), terms_(n),
      working_(contact_.a().precision()) {}

Real SignedError::operator()(const Real& u) const {
    const PrecisionScope scope(working_);
    ++pressures_;
    const Real local = approximation(u);
    return local / contact_.pressure(edge_, u).value - 1;
}

/// p_local, by Horner's rule (moore-hills EQ04).
Real SignedError::approximation(const Real& u) const {
    Real sum = c_[terms_ - 1];
    for (std::size_t k = terms_ - 1; k-- > 0;) {
        sum = sum * u + c_[k];
    }
    return sum * sqrt(u);
}

Real SignedError::safe_distance(const Real& tolerance) const {
    const PrecisionScope scope(working_);
    const Real radius = contact_.convergence_radius(edge_);
    Real u = radius * pow(tolerance < 1 ? tolerance : Real(1),
                          Real(1) / Real(static_cast<unsigned>(terms_ + look_ahead)));
    for (std::size_t k = terms_; k < c_.size(); ++k) {
        if (c_[k] != 0) {
            const Real reach =
                pow(Real(tolerance * c_[0] / abs(c_[k])), Real(1) / Real(static_cast<unsigned>(k)));
            u = reach < u ? reach : u;
        }
    }
    return u / 4;
}

std::vector<Landmark> landmarks(const NormalContact& contact, Edge edge) {
    const Real a = contact.a();
    const Real b = contact.b();
    std::vector<Landmark> marks{{Real(0), false}};
    const auto& knots = contact.profile().knots();
    for (std::size_t i = 0; i < knots.size(); ++i) {
        const Real knot = knots[i].to<Real>();
        const Real u = edge == Edge::right ? Real(a - knot) : Real(b + knot);
        if (u > 0 && u < a + b) {
            marks.push_back({u, contact.profile().has_corner(i)});
        }
    }
    marks.push_back({Real(a + b), true});
    std::sort(marks.begin(), marks.end(),
              [](const Landmark& x, const Landmark& y) { return x.u < y.u; });
    return marks;
}

ErrorScan::ErrorScan(const SignedError& error, const SignedError& fine,
                     const std::vector<Landmark>& marks, const formula::Exact& tolerance, Real from,
                     Real to)
    : error_(error), fine_(fine), exact_tolerance_(tolerance), tolerance_(tolerance.to<Real>()),
      from_(std::move(from)), to_(std::move(to)) {
    place(marks);
    seek_extrema();
}

void ErrorScan::place(const std::vector<Landmark>& marks) {
    std::vector<Real> u{from_, to_};
    const Real step = pow(Real(10), Real(-1) / per_decade);
    const Real first = error_.safe_distance(tolerance_);
    for (std::size_t i = 0; i + 1 < marks.size(); ++i) {
        const Real width = marks[i + 1].u - marks[i].u;
        const Real near = width * power_of_ten(-decades_to_knot);
        // Towards the edge itself the scan ends where the omitted terms are small.
        const Real least = i == 0 && first < near ? first : near;
        for (Real d = width / 2; d > least; d *= step) {
            u.push_back(marks[i].u + d);
        }
        if (i == 0) {
            u.push_back(first);
        }
        for (Real d = width / 2; d > near; d *= step) {
            u.push_back(marks[i + 1].u - d);
        }
        for (int k = 1; k < uniform_points; ++k) {
            u.push_back(marks[i].u + width * k / uniform_points);
        }
        if (!marks[i + 1].singular) {
            u.push_back(marks[i + 1].u);
        }
    }
    std::sort(u.begin(), u.end());
    u.erase(std::unique(u.begin(), u.end()), u.end());
    const Real end = marks.back().u;
    // A range's end within this distance of a corner counts as on the corner.
    const Real roundoff = end * power_of_ten(10 - static_cast<int>(error_.working()));
    const auto on_pole = [&](const Real& x) {
        return std::any_of(marks.begin(), marks.end(), [&](const Landmark& mark) {
            return mark.singular && abs(Real(mark.u - x)) < roundoff;
        });
    };
    for (const Real& x : u) {
        if (x > 0 && x < end && x >= from_ && x <= to_ && !on_pole(x)) {
            add(x);
        }
    }
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const Landmark& mark = marks[i];
        if (mark.singular && mark.u > from_ - roundoff && mark.u < to_ + roundoff) {
            const bool far_edge = mark.u == end;
            const Real local = error_.approximation(mark.u);
            const Real limit = !far_edge ? Real(-1) : local < 0 ? Real(-2) : Real(2);
            samples_.push_back({mark.u, limit, far_edge ? (local < 0 ? -1 : 1) : side(limit), i});
        }
    }
    in_order();
}

void ErrorScan::add(const Real& u) {
    const Real f = error_(u);
    samples_.push_back({u, f, side(f)});
}

void ErrorScan::in_order() {
    std::sort(samples_.begin(), samples_.end(),
              [](const ErrorSample& x, const ErrorSample& y) { return x.u < y.u; });
}

void ErrorScan::seek_extrema() {
    std::vector<ErrorSample> found;
    for (std::size_t i = 1; i + 1 < samples_.size(); ++i) {
        const ErrorSample& l = samples_[i - 1];
        const ErrorSample& m = samples_[i];
        const ErrorSample& r = samples_[i + 1];
        if (l.pole || m.pole || r.pole || l.side != m.side || m.side != r.side ||
            abs(m.f) < tolerance_ / 1000) {
            continue;
        }
        const bool top = m.f >= l.f && m.f >= r.f;
        const bool bottom = m.f <= l.f && m.f <= r.f;
        if (top == bottom) {
            continue;
        }
        const Real left = abs(Real(m.f - l.f));
        const Real right = abs(Real(m.f - r.f));
        const Real reach = 4 * (left > right ? left : right);
        const Real threshold = m.side != 0 ? Real(m.side * tolerance_)
                               : top       ? tolerance_
                                           : Real(-tolerance_);
        // The extremum must lie towards the threshold, and may be near enough to reach it.
        const bool towards = (threshold > m.f) == top;
        if (towards && abs(Real(threshold - m.f)) <= reach) {
            found.push_back(extremum(l.u, r.u, top, threshold));
        }
    }
    samples_.insert(samples_.end(), found.begin(), found.end());
    in_order();
}

ErrorSample ErrorScan::extremum(const Real& lo, const Real& hi, bool top,
                                const Real& threshold) const {
    const Real u = least(error_, lo, hi, top, threshold, 40);
    const Real f = error_(u);
    if (abs(Real(f - threshold)) > abs(threshold) * power_of_ten(-12)) {
        return {u, f, side(f)};
    }
    // The extremum nearly touches the threshold: decide with all digits.
    const PrecisionScope scope(fine_.working());
    const Real tolerance = exact_tolerance_.to<Real>();
    const Real place = least(fine_, lo, hi, top, threshold > 0 ? tolerance : Real(-tolerance),
                             static_cast<int>(5 * fine_.working() / 2));
    const Real height = fine_(place);
    return {place, height, height >= tolerance ? 1 : height <= -tolerance ? -1 : 0};
}

Real ErrorScan::least(const SignedError& error, const Real& lo, const Real& hi, bool top,
                      const Real& threshold, int steps) {
    const auto depth = [&](const Real& u) { return top ? Real(-error(u)) : error(u); };
    const Real enough = top ? Real(-threshold) : threshold;
    return roots::place_of_minimum(depth, lo, hi, steps,
                                   [&](const Real& value) { return value < enough; });
}

} // namespace edgeproof::contact
