// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/parts/margin_scan.hpp"

#include "edgeproof/roots/extremum.hpp"

#include <algorithm>

namespace edgeproof::audit {
namespace {

constexpr int places_per_decade = 3;
constexpr int even_places = 24;
constexpr int search_steps = 80;     // each shrinks the interval by 0.618
constexpr unsigned scan_digits = 40; // of the fractions themselves

bool smaller(const MarginAt& x, const MarginAt& y) { return x.margin.value < y.margin.value; }

} // namespace

MarginScan::MarginScan(const ConditionInScene& condition, const Real& nearest)
    : condition_(condition) {
    const PrecisionScope scope(scan_digits);
    std::vector<Real> marks{Real(0)};
    for (const Real& knot : condition.knots()) {
        marks.push_back(knot);
    }
    marks.emplace_back(1);
    std::vector<Real> fractions;
    const Real step = pow(Real(10), Real(-1) / places_per_decade);
    for (std::size_t i = 0; i + 1 < marks.size(); ++i) {
        const Real width = marks[i + 1] - marks[i];
        for (Real d = width / 2; d > width * nearest; d *= step) {
            fractions.push_back(marks[i] + d);
            fractions.push_back(marks[i + 1] - d);
        }
        for (int k = 1; k < even_places; ++k) {
            fractions.push_back(marks[i] + width * k / even_places);
        }
        if (i > 0) {
            fractions.push_back(marks[i]);
        }
    }
    std::sort(fractions.begin(), fractions.end());
    fractions.erase(std::unique(fractions.begin(), fractions.end()), fractions.end());
    for (const Real& fraction : fractions) {
        look(fraction);
    }
    seek_extrema();
}

void MarginScan::look(const Real& fraction) {
    if (const auto margin = condition_.at(fraction)) {
        places_.push_back({fraction, *margin});
    }
}

void MarginScan::in_order() {
    std::sort(places_.begin(), places_.end(),
              [](const MarginAt& x, const MarginAt& y) { return x.fraction < y.fraction; });
}

void MarginScan::seek_extrema() {
    const PrecisionScope scope(scan_digits);
    const auto reaches_zero = [](const Real& height) { return height <= 0; };
    std::vector<Real> found;
    for (std::size_t i = 1; i + 1 < places_.size(); ++i) {
        const Real& l = places_[i - 1].margin.difference;
        const Real& m = places_[i].margin.difference;
        const Real& r = places_[i + 1].margin.difference;
        const bool dip = m > 0 && m <= l && m <= r;
        const bool bump = m < 0 && m >= l && m >= r;
        const Real reach = 4 * std::max(Real(abs(m - l)), Real(abs(m - r)));
        if (dip == bump || abs(m) > reach) {
            continue; // no extremum, or one too flat to reach zero
        }
        const auto height = [&](const Real& x) {
            const auto margin = condition_.at(x);
            return !margin ? Real(2 * abs(m))
                   : dip   ? margin->difference
                           : Real(-margin->difference);
        };
        found.push_back(roots::place_of_minimum(
            height, places_[i - 1].fraction, places_[i + 1].fraction, search_steps, reaches_zero));
    }
    for (const Real& fraction : found) {
        look(fraction);
    }
    in_order();
}

const MarginAt* MarginScan::least() const {
    const auto it = std::min_element(places_.begin(), places_.end(), smaller);
    return it == places_.end() ? nullptr : &*it;
}

const MarginAt* MarginScan::most() const {
    const auto it = std::max_element(places_.begin(), places_.end(), smaller);
    return it == places_.end() ? nullptr : &*it;
}

std::size_t MarginScan::unclear() const {
    return static_cast<std::size_t>(std::count_if(
        places_.begin(), places_.end(), [](const MarginAt& p) { return !p.margin.clear; }));
}

bool MarginScan::nearly_changes(bool holding) const {
    const Real negligible = pow(Real(10), -14); // the search ends within 2e-17 of an interval
    const Real equal = holding ? condition_.counts_as_equal() : Real(0);
    const int sign = holding ? 1 : -1; // so that the condition changes where a value reaches zero
    for (std::size_t i = 1; i + 1 < places_.size(); ++i) {
        const Real l = sign * places_[i - 1].margin.difference;
        const Real m = sign * places_[i].margin.difference;
        const Real r = sign * places_[i + 1].margin.difference;
        const Real nearby = std::max(Real(abs(l)), Real(abs(r)));
        const bool counts_as_equal = equal > 0 && abs(m) <= equal * nearby;
        if (m <= l && m <= r && abs(m) <= negligible * nearby && !counts_as_equal) {
            return true;
        }
    }
    return false;
}

Real MarginScan::change_between(Real lo, Real hi, bool holds_at_lo) const {
    for (int k = 0; k < 45; ++k) {
        const Real middle = (lo + hi) / 2;
        const auto margin = condition_.at(middle);
        if (!margin) {
            break;
        }
        ((margin->value > 0) == holds_at_lo ? lo : hi) = middle;
    }
    return hi;
}

std::vector<std::pair<Real, Real>> MarginScan::intervals(bool holding) const {
    const PrecisionScope scope(scan_digits);
    std::vector<std::pair<Real, Real>> found;
    bool inside = false;
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const bool here = (places_[i].margin.value > 0) == holding;
        if (here && !inside) {
            const Real from =
                i == 0 ? places_[i].fraction
                       : change_between(places_[i - 1].fraction, places_[i].fraction, !holding);
            found.emplace_back(from, places_[i].fraction);
        } else if (!here && inside) {
            found.back().second =
                change_between(places_[i - 1].fraction, places_[i].fraction, holding);
        }
        if (here) {
            found.back().second = places_[i].fraction;
        }
        inside = here;
    }
    return found;
}

} // namespace edgeproof::audit
