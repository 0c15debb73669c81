// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/routes/extent.hpp"

#include "edgeproof/contact/routes/extent_scan.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/require.hpp"
#include "edgeproof/roots/bracketed_root.hpp"

#include <algorithm>
#include <string>

namespace edgeproof::contact {
namespace {

struct Crossing {
    Real u;
    Real estimate; ///< relative error
};

/// Finds the place where f = level between two samples (docs/extents.md, "Sampled"), first at the
/// digits of the scan, then at full digits.
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
                         const formula::Exact& tolerance, const ExtentRange& range) {
    require(tolerance.sign() > 0, "a tolerance of " + tolerance.text() + " is never reached",
            "give a tolerance > 0, such as 1/100");
    require(n > 0, "an approximation of 0 terms", "ask for 1 term or more");
    require(range.from.sign() >= 0 &&
                formula::Exact(range.to.expr() - range.from.expr()).sign() > 0 &&
                formula::Exact(formula::Expr::number(1) - range.to.expr()).sign() >= 0,
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

} // namespace edgeproof::contact
