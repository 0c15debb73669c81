// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/design/best_reach.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>
#include <cmath>

namespace edgeproof::contact {
namespace {

/// A grid over a box, ends included: the best of it, and the cells around it.
struct GridSearch {
    std::vector<double> lo;
    std::vector<double> hi;

    void refine(const std::function<double(const std::vector<double>&)>& score, int points,
                SampledBest& best) {
        std::vector<int> at(lo.size(), 0);
        best.width.clear();
        for (std::size_t i = 0; i < lo.size(); ++i) {
            best.width.push_back((hi[i] - lo[i]) / points);
        }
        const auto value = [&](std::size_t i, int k) {
            return k == points ? hi[i] : lo[i] + (hi[i] - lo[i]) * k / points;
        };
        for (;;) {
            check_interruption();
            std::vector<double> x;
            for (std::size_t i = 0; i < at.size(); ++i) {
                x.push_back(value(i, at[i]));
            }
            const double s = score(x);
            if (!std::isnan(s) && (best.value.empty() || s > best.score)) {
                best.value = x;
                best.score = s;
            }
            std::size_t i = 0;
            while (i < at.size() && at[i] == points) {
                at[i++] = 0;
            }
            if (i == at.size()) {
                break;
            }
            ++at[i];
        }
        if (best.value.empty()) {
            return;
        }
        for (std::size_t i = 0; i < lo.size(); ++i) {
            lo[i] = std::max(lo[i], best.value[i] - best.width[i]);
            hi[i] = std::min(hi[i], best.value[i] + best.width[i]);
        }
    }
};

} // namespace

SampledBest sampled_best(const std::function<double(const std::vector<double>&)>& score,
                         const std::vector<ParameterRange>& ranges, const SampleGrid& samples) {
    GridSearch grid;
    for (const ParameterRange& r : ranges) {
        grid.lo.push_back(r.from.convert_to<double>());
        grid.hi.push_back(r.to.convert_to<double>());
    }
    SampledBest best;
    try {
        grid.refine(score, samples.first, best);
        for (int k = 0; k < samples.rounds && !best.value.empty(); ++k) {
            grid.refine(score, samples.later, best);
        }
    } catch (const BudgetError&) { // the best of those tried
    }
    return best;
}

} // namespace edgeproof::contact
