// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cost/growth.hpp"

#include <algorithm>
#include <cmath>

namespace edgeproof::cost {
namespace {

constexpr unsigned digits_that_may_miss = 1; ///< a rounding of the last digit

bool useful(const CostCell& cell) { return cell.failed() < cell.points.size(); }

} // namespace

double Growth::ten_more() const { return std::pow(60.0 / 50.0, time.exponent); }

std::vector<Growth> growths(const std::vector<CostCell>& cells) {
    std::vector<Growth> all;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto same = [&](const CostCell& c) {
            return c.scene == cells[i].scene && c.route == cells[i].route &&
                   c.arithmetic == cells[i].arithmetic;
        };
        if (i > 0 && same(cells[i - 1])) {
            continue;
        }
        std::vector<std::pair<double, double>> times;
        std::vector<std::pair<double, double>> counts;
        for (std::size_t k = i; k < cells.size() && same(cells[k]); ++k) {
            if (useful(cells[k])) {
                times.emplace_back(cells[k].digits, cells[k].seconds().median);
                const auto evaluations = cells[k].evaluations();
                counts.emplace_back(cells[k].digits, evaluations ? evaluations->median : 0);
            }
        }
        if (const auto fit = roots::power_law_fit(times)) {
            all.push_back({cells[i].scene, cells[i].route, cells[i].arithmetic, *fit,
                           roots::power_law_fit(counts)});
        }
    }
    return all;
}

std::vector<BoundCost> bound_costs(const std::vector<CostCell>& cells) {
    std::vector<BoundCost> all;
    for (const CostCell& ball : cells) {
        if (!ball.proves || ball.route != "enclosure" || !useful(ball)) {
            continue;
        }
        BoundCost cost{ball.scene, ball.digits, "", 0, ball.seconds().median, 0};
        for (const CostCell& c : cells) {
            if (c.scene != ball.scene || c.digits != ball.digits || !useful(c)) {
                continue;
            }
            if (c.proves && c.route == "rounded") {
                cost.rounded_seconds = c.seconds().median;
            } else if (c.arithmetic == "MPFR" &&
                       c.right().least + digits_that_may_miss >= c.digits && c.failed() == 0 &&
                       (cost.bare.empty() || c.seconds().median < cost.bare_seconds)) {
                cost.bare = c.route;
                cost.bare_seconds = c.seconds().median;
            }
        }
        if (!cost.bare.empty() && cost.bare_seconds > 0) {
            all.push_back(std::move(cost));
        }
    }
    return all;
}

} // namespace edgeproof::cost
