// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/sample/naive_integral.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/quadrature/near_singularity.hpp"

#include <algorithm>
#include <optional>

namespace edgeproof::audit {
namespace {

/// The marks that split an interval [lo, hi], and the distances from its ends to points beyond them
/// where f is not analytic.
struct Split {
    std::vector<Real> marks; ///< lo, cuts inside, hi
    Real beyond_lo;          ///< 0: none is known
    Real beyond_hi;
};

Split split_at(const Real& lo, const Real& hi, std::vector<Real> cuts) {
    std::ranges::sort(cuts);
    Split split{{lo}, Real(0), Real(0)};
    // Cuts that differ by less than about the working precision are merged.
    const Real same = (hi - lo) * pow(Real(10), -static_cast<int>(working_digits() * 9 / 10));
    for (const Real& cut : cuts) {
        if (cut < lo - same) {
            split.beyond_lo = lo - cut;
        } else if (cut > hi + same) {
            split.beyond_hi = cut - hi;
            break;
        } else if (cut > split.marks.back() + same && cut < hi - same) {
            split.marks.push_back(cut);
        }
    }
    split.marks.push_back(hi);
    return split;
}

/// Returns the number of decades by which y is less than x > 0.
long decades_below(const Real& x, const Real& y) {
    if (y == 0) {
        return 0;
    }
    const auto bits = mpfr_get_exp(x.backend().data()) - mpfr_get_exp(y.backend().data());
    return bits * 30103L / 100000 + 1;
}

/// Returns f at the working precision of the caller, evaluated with the digits that its distance
/// from an end needs. If f has no value very near to an end or a cut (a logarithm at a corner), the
/// value is 0: for an integrable f, this has no effect on the digits kept.
Real evaluated(const NaiveIntegrand& f, const NaivePrecision& precision, const Real& base,
               const Real& distance, bool upwards, const Real& length) {
    Real value;
    try {
        const PrecisionScope scope(precision.at(decades_below(precision.scale, distance)));
        const Real x = upwards ? Real(base + distance) : Real(base - distance);
        value = f(at_working_precision(x));
    } catch (const DomainError&) {
        if (distance > length * pow(Real(10), -static_cast<int>(precision.nodes))) {
            throw;
        }
        return Real(0);
    }
    return at_working_precision(value);
}

/// True if |f| grows towards an end at least like one over the distance, so that the integral
/// diverges. Estimated from its slope in logarithmic coordinates over two ranges of many decades.
bool grows_beyond_bounds(const NaiveIntegrand& f, const NaivePrecision& precision, const Real& end,
                         bool upwards, const Real& length) {
    std::vector<double> logarithms;
    const int stretch = static_cast<int>(precision.nodes / 4);
    for (int k = 1; k <= 3; ++k) {
        const Real distance = length * pow(Real(10), -k * stretch);
        const Real value = abs(evaluated(f, precision, end, distance, upwards, length));
        if (value == 0 || !isfinite(value)) {
            return false;
        }
        logarithms.push_back(log10(value).convert_to<double>());
    }
    constexpr double nearly_one = 0.999;
    return logarithms[1] - logarithms[0] > nearly_one * stretch &&
           logarithms[2] - logarithms[1] > nearly_one * stretch;
}

void require_a_value(const NaiveIntegrand& f, const Split& split, const NaivePrecision& precision) {
    for (std::size_t i = 0; i + 1 < split.marks.size(); ++i) {
        const Real length = split.marks[i + 1] - split.marks[i];
        if (grows_beyond_bounds(f, precision, split.marks[i], true, length) ||
            grows_beyond_bounds(f, precision, split.marks[i + 1], false, length)) {
            throw DivergentIntegral("an integral has no finite value: its integrand grows like one "
                                    "over the distance from an end, or faster");
        }
    }
}

/// Integrates over an interval without a cut inside: with few nodes if the ends are roots, as in
/// most printed integrals; otherwise by the tanh-sinh rule.
quadrature::QuadratureResult<Real> between_cuts(const quadrature::IntegrandRef<Real, Real>& f,
                                                const Real& length, const Real& beyond_lo,
                                                const Real& beyond_hi,
                                                const NaivePrecision& precision) {
    if (precision.roots) {
        if (auto found = integrate_root_ends(f, length, beyond_lo, beyond_hi)) {
            return std::move(*found);
        }
    }
    return integrate_near<Real>(
        f, length, beyond_lo, beyond_hi,
        {.last_level = precision.last_level, .gives_up = true, .foresees = true});
}

NaiveIntegral pieces(const NaiveIntegrand& f, const Split& split, NaivePrecision precision) {
    std::vector<Real> lengths;
    for (std::size_t i = 0; i + 1 < split.marks.size(); ++i) {
        lengths.push_back(split.marks[i + 1] - split.marks[i]);
    }
    const PrecisionScope scope(precision.nodes);
    quadrature::QuadratureResult<Real> result{Real(0), Real(0), 0, true};
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        const auto at = [&](const Real& from_lo, const Real& from_hi) {
            return from_lo < from_hi
                       ? evaluated(f, precision, split.marks[i], from_lo, true, lengths[i])
                       : evaluated(f, precision, split.marks[i + 1], from_hi, false, lengths[i]);
        };
        result.add(between_cuts(quadrature::IntegrandRef<Real, Real>(at), lengths[i],
                                i > 0 ? lengths[i - 1] : split.beyond_lo,
                                i + 1 < lengths.size() ? lengths[i + 1] : split.beyond_hi,
                                precision));
    }
    if (!result.converged) {
        require_a_value(f, split, precision);
    }
    return {result.value, result.estimate, result.converged};
}

NaivePrecision with_scale(NaivePrecision precision, const Real& lo, const Real& hi) {
    precision.scale = std::max({precision.scale, Real(abs(lo)), Real(abs(hi)), Real(hi - lo)});
    return precision;
}

} // namespace

NaiveIntegral integrate_naively(const NaiveIntegrand& f, const Real& lo, const Real& hi,
                                std::vector<Real> cuts, const NaivePrecision& precision) {
    const PrecisionScope scope(precision.integrand());
    if (lo == hi) {
        return {Real(0), Real(0), true};
    }
    if (hi < lo) {
        NaiveIntegral result = integrate_naively(f, hi, lo, std::move(cuts), precision);
        result.value = -result.value;
        return result;
    }
    return pieces(f, split_at(lo, hi, std::move(cuts)), with_scale(precision, lo, hi));
}

NaiveIntegral principal_value_naively(const NaiveIntegrand& f, const Real& lo, const Real& hi,
                                      const Real& pole, std::vector<Real> cuts,
                                      NaivePrecision precision) {
    const PrecisionScope scope(precision.integrand());
    if (hi < lo) {
        NaiveIntegral result =
            principal_value_naively(f, hi, lo, pole, std::move(cuts), std::move(precision));
        result.value = -result.value;
        return result;
    }
    const Real near =
        Real(abs(lo) + abs(hi)) * pow(Real(10), -static_cast<int>(precision.integrand() / 2));
    if (lo == hi || pole < lo - near || pole > hi + near) {
        // The pole is outside: the integral is an ordinary one.
        return integrate_naively(f, lo, hi, std::move(cuts), precision);
    }
    if (!(lo < pole) || !(pole < hi)) {
        throw DomainError("the pole of a principal value is at an end of its interval");
    }
    Real h = std::min(Real(pole - lo), Real(hi - pole));
    for (const Real& cut : cuts) {
        const Real d = abs(cut - pole);
        if (d > 0 && d < h) {
            h = d;
        }
    }
    precision = with_scale(std::move(precision), lo, hi);
    const Real left = pole - h;
    const Real right = pole + h;
    NaiveIntegral sum{};
    {
        const PrecisionScope nodes(precision.nodes);
        const auto folded = [&](const Real& r, const Real& rest) {
            return r < rest ? Real(evaluated(f, precision, pole, r, true, h) +
                                   evaluated(f, precision, pole, r, false, h))
                            : Real(evaluated(f, precision, right, rest, false, h) +
                                   evaluated(f, precision, left, rest, true, h));
        };
        const auto fold = between_cuts(quadrature::IntegrandRef<Real, Real>(folded), h, Real(0),
                                       Real(0), precision);
        sum = {fold.value, fold.estimate, fold.converged};
    }
    cuts.push_back(pole);
    const auto add = [&](const Real& from, const Real& to) {
        // If h reached an end, only roundoff is left beyond it.
        if (!(to - from > h * pow(Real(10), -static_cast<int>(precision.integrand() / 2)))) {
            return;
        }
        const NaiveIntegral part = integrate_naively(f, from, to, cuts, precision);
        sum.value += part.value;
        sum.estimate = std::max(sum.estimate, part.estimate);
        sum.converged = sum.converged && part.converged;
    };
    add(lo, left);
    add(right, hi);
    return sum;
}

} // namespace edgeproof::audit
