// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/routes/extent.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/roots/bracketed_root.hpp"

#include <algorithm>
#include <utility>

namespace edgeproof::contact {
namespace {

struct Crossing {
    Real u;
    Real estimate; ///< relative error
};

/// Finds the place where f = level between two samples (docs/expansions.md, "Extents"), first at
/// the digits of the scan, then at full digits.
class Refiner {
public:
    Refiner(const SignedError& coarse, const SignedError& fine, std::vector<Landmark> marks,
            unsigned digits)
        : coarse_(coarse), fine_(fine), marks_(std::move(marks)), digits_(digits) {}

    [[nodiscard]] Crossing crossing(const ErrorSample& l, const ErrorSample& r,
                                    const Real& level) const {
        if (l.pole || r.pole) {
            return l.pole ? near_pole(*l.pole, r.u, true, level)
                          : near_pole(*r.pole, l.u, false, level);
        }
        const auto rough = root(coarse_, l.u, l.f, r.u, r.f, level, 12);
        const PrecisionScope scope(fine_.working());
        // A bracket around the rough root, if f - level changes its sign there; otherwise the whole
        // interval.
        const Real slack = rough.x * power_of_ten(-10);
        Real lo = rough.x - slack > l.u ? Real(rough.x - slack) : l.u;
        Real hi = rough.x + slack < r.u ? Real(rough.x + slack) : r.u;
        Real f_lo = fine_(lo);
        Real f_hi = fine_(hi);
        if ((f_lo > level) == (f_hi > level)) {
            lo = l.u;
            hi = r.u;
            f_lo = fine_(lo);
            f_hi = fine_(hi);
        }
        const Real slope = abs(Real((f_hi - f_lo) / (hi - lo)));
        const auto exact = root(fine_, lo, f_lo, hi, f_hi, level, digits_ + 5);
        const Real noise = power_of_ten(-static_cast<int>(fine_.contact().digits()));
        return {exact.x, slope > 0 ? Real((exact.width + noise / slope) / exact.x) : Real(1)};
    }

private:
    static roots::BracketedRoot<Real> root(const SignedError& f, const Real& lo, const Real& f_lo,
                                           const Real& hi, const Real& f_hi, const Real& level,
                                           unsigned digits) {
        const PrecisionScope scope(f.working());
        return roots::bracketed_root<Real>([&](const Real& u) { return Real(f(u) - level); }, lo,
                                           Real(f_lo - level), hi, Real(f_hi - level),
                                           power_of_ten(-static_cast<int>(digits)));
    }
    /// A crossing near a corner or the far edge, where f behaves like a logarithm or a root of the
    /// distance d: the search is in log d. If the crossing is nearer than the digits show, it is
    /// the corner or edge itself.
    [[nodiscard]] Crossing near_pole(std::size_t pole, const Real& other, bool to_its_right,
                                     const Real& level) const {
        const PrecisionScope scope(fine_.working());
        const Real at = marks_.at(pole).u;
        const Real bounded_value = power_of_ten(-static_cast<int>(digits_));
        const auto place = [&](const Real& log_d) {
            return to_its_right ? Real(at + exp(log_d)) : Real(at - exp(log_d));
        };
        const auto f = [&](const Real& log_d) { return Real(fine_(place(log_d)) - level); };
        const Real start = log(Real(abs(Real(other - at))));
        const Real end = log(Real(at * bounded_value / 100000));
        const Real f_start = f(start);
        const Real f_end = f(end);
        if ((f_start > 0) == (f_end > 0)) {
            return {at, bounded_value};
        }
        const auto found = roots::bracketed_root<Real>(f, start, f_start, end, f_end,
                                                       Real(bounded_value / 100000 / (1 - end)));
        return {place(found.x), bounded_value};
    }

    const SignedError& coarse_;
    const SignedError& fine_;
    std::vector<Landmark> marks_;
    unsigned digits_;
};

} // namespace

Extents within_tolerance(const NormalContact& contact, Edge edge, std::size_t n,
                         const Exact& tolerance, const ExtentRange& range) {
    require(tolerance.sign() > 0, "a tolerance of " + tolerance.text() + " is never reached",
            "give a tolerance > 0, such as 1/100");
    require(n > 0, "an approximation of 0 terms", "ask for 1 term or more");
    require(range.from.sign() >= 0 && Exact(range.to.expr() - range.from.expr()).sign() > 0 &&
                Exact(Expr::number(1) - range.to.expr()).sign() >= 0,
            "the range " + range.from.text() + " ... " + range.to.text() +
                " of the contact does not ascend within 0 ... 1",
            "give 0 <= from < to <= 1");
    // f = p_local/p - 1 loses as many digits as the tolerance is small; u loses the same number
    // again.
    const unsigned small = [&] {
        const PrecisionScope scope(30);
        const Real decades = -log10(tolerance.to<Real>());
        return decades > 0 ? static_cast<unsigned>(ceil(decades)) : 0U;
    }();
    const SignedError coarse(contact, 20 + small, edge, n);
    const SignedError fine(contact, contact.digits() + small + 10, edge, n);

    const ErrorScan scan = [&] {
        const PrecisionScope scope(coarse.working());
        const auto marks = landmarks(coarse.contact(), edge);
        return ErrorScan(coarse, fine, marks, tolerance, range.from.to<Real>() * marks.back().u,
                         range.to.to<Real>() * marks.back().u);
    }();

    const PrecisionScope scope(fine.working());
    std::vector<Landmark> marks = landmarks(fine.contact(), edge);
    Extents found;
    found.length = marks.back().u;
    found.range_from = range.from.to<Real>() * found.length;
    found.range_to = range.to.to<Real>() * found.length;
    found.estimate = 0;
    found.samples = scan.samples().size();
    const Refiner refiner(coarse, fine, std::move(marks), contact.digits());
    const Real level = tolerance.to<Real>();

    found.measure = 0;
    found.leaves = false;
    Real entered = found.range_from;
    bool within = scan.samples().front().side == 0;
    const auto leave = [&](const Real& u) {
        found.measure += u - entered;
        if (!found.leaves) {
            found.leaves = true;
            found.first_exit = u;
        }
    };
    if (!within) {
        found.leaves = true;
        found.first_exit = found.range_from;
    }
    for (std::size_t i = 0; i + 1 < scan.samples().size(); ++i) {
        const ErrorSample& l = scan.samples()[i];
        const ErrorSample& r = scan.samples()[i + 1];
        if (l.side == r.side) {
            continue;
        }
        // A step from beyond one limit to beyond the other crosses both.
        for (int side : {l.side, r.side}) {
            if (side == 0) {
                continue;
            }
            const Crossing crossing = refiner.crossing(l, r, side > 0 ? level : Real(-level));
            found.crossings.push_back(crossing.u);
            found.estimate = std::max(found.estimate, crossing.estimate);
            within = !within;
            if (within) {
                entered = crossing.u;
            } else {
                leave(crossing.u);
            }
        }
    }
    if (within) {
        found.measure += found.range_to - entered;
    }
    if (!found.leaves) {
        found.first_exit = found.range_to;
    }
    found.pressures = coarse.pressures() + fine.pressures();
    return found;
}

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
                     const std::vector<Landmark>& marks, const Exact& tolerance, Real from, Real to)
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
