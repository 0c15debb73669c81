// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/measures/alignment.hpp"

#include "edgeproof/comparison/measures/origin.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace edgeproof::comparison {
namespace {

class Aligner {
public:
    Aligner(const ResultTable& table, const ExactContact& exact) : table_(table), exact_(exact) {
        for (const ResultRow& row : table.rows) {
            points_.push_back({row.x.convert_to<double>(), row.p.convert_to<double>()});
        }
        find_sign();
    }

    AlignedResult align(const std::optional<Rational>& given) {
        const auto support = support_of(points_);
        find_half(support);
        if (given) {
            result_.origin = given->convert_to<double>();
            exact_origin_ = Real(*given);
        } else if (support) {
            find_origin(*support);
        }
        if (result_.origin != 0 && given) {
            result_.findings.push_back(
                fmt::format("x is measured from {:.6g} of the data, as given", result_.origin));
        }
        lay_over();
        return std::move(result_);
    }

private:
    void find_sign() {
        double force = 0;
        double most = 0;
        for (std::size_t i = 1; i < points_.size(); ++i) {
            force += 0.5 * (points_[i].x - points_[i - 1].x) * (points_[i].p + points_[i - 1].p);
        }
        for (const RoughPoint& point : points_) {
            most = std::max(most, std::abs(point.p));
        }
        if (most == 0) {
            result_.findings.emplace_back("every pressure of the data is zero");
        }
        result_.sign = force < 0 ? -1 : 1;
        if (result_.sign < 0) {
            result_.findings.emplace_back("compression is negative in the data");
            for (RoughPoint& point : points_) {
                point.p = -point.p;
            }
        }
    }

    /// A mesh of half of a symmetric contact ends where p is high.
    void find_half(const std::optional<Support>& support) {
        if (!support || !exact_.symmetric() || support->left_falls == support->right_falls) {
            return;
        }
        result_.half = support->right_falls ? contact::Edge::right : contact::Edge::left;
        result_.findings.push_back(
            fmt::format("the data contain the {} half of a symmetric contact: P is doubled",
                        scene::edge_name(*result_.half)));
    }

    void find_origin(const Support& support) {
        const auto found = origin_of(points_, support, result_.half, exact_);
        if (!found) {
            return;
        }
        exact_origin_ = found->exact;
        origin_uncertainty_ = found->uncertainty;
        result_.origin = exact_origin_.convert_to<double>();
        result_.origin_found = true;
        result_.findings.push_back(
            fmt::format("the origin of the scene lies at x = {:.10g} of the data, found from the "
                        "data as --origin auto requests{}",
                        result_.origin, found->what));
    }

    void lay_over() {
        const PrecisionScope scope(ExactContact::place_digits);
        for (std::size_t i = 0; i < table_.rows.size(); ++i) {
            check_interruption();
            const ResultRow& row = table_.rows[i];
            const Real x = Real(row.x) - exact_origin_;
            Node node;
            node.line = row.line;
            node.x = x.convert_to<double>();
            node.p = points_[i].p;
            node.exact = exact_.at(x);
            node.rounding = row.p_rounding;
            if (node.exact.p) {
                const Real p = Real(row.p) * Real(result_.sign);
                node.error = Real(p - node.exact.exact_p).convert_to<double>();
                node.rounding += moved_by_rounding(
                    i, x, node.exact, [](const Real&, const auto& place) { return place.p; });
            }
            if (row.q && exact_.shear() != nullptr) {
                NodeShear shear;
                shear.q = row.q->convert_to<double>();
                shear.exact = exact_.traction(x, node.exact);
                shear.rounding = row.q_rounding;
                if (shear.exact && node.exact.inside()) {
                    shear.rounding += moved_by_rounding(i, x, node.exact,
                                                        [this](const Real& at, const auto& place) {
                                                            return exact_.traction(at, place);
                                                        });
                }
                node.shear = shear;
            }
            result_.nodes.push_back(std::move(node));
        }
        find_shear_sign();
    }

    /// Programs write q of either body: the direction with the better agreement is chosen.
    void find_shear_sign() {
        double agreement = 0;
        for (const Node& node : result_.nodes) {
            agreement += node.shear && node.shear->exact ? node.shear->q * *node.shear->exact : 0.0;
        }
        if (agreement < 0) {
            result_.shear_sign = -1;
            result_.findings.emplace_back("q has the opposite sign in the data");
        }
        for (Node& node : result_.nodes) {
            if (node.shear) {
                node.shear->q *= result_.shear_sign;
                node.shear->error = node.shear->exact ? node.shear->q - *node.shear->exact : 0;
            }
        }
    }

    /// The change of an exact value when x changes by half a unit of its last digit. A grid of few
    /// decimals is taken to be exact: its step is not a rounding error.
    template <class Value>
    [[nodiscard]] double moved_by_rounding(std::size_t i, const Real& x,
                                           const ExactContact::Place& here,
                                           const Value& value) const {
        const double half = table_.rows[i].x_rounding + origin_uncertainty_;
        const double gap =
            std::min(i > 0 ? points_[i].x - points_[i - 1].x : exact_.length(),
                     i + 1 < points_.size() ? points_[i + 1].x - points_[i].x : exact_.length());
        constexpr double small = 0.02;
        constexpr double negligible = 1e-12;
        if (half > small * gap || half < negligible * std::abs(here.u())) {
            return 0;
        }
        const Real step = here.nearer() == contact::Edge::right ? Real(half) : Real(-half);
        const double value_here = *value(x, here);
        double most = 0;
        for (const Real& neighbour : {Real(x + step), Real(x - step)}) {
            const auto moved = value(neighbour, exact_.at(neighbour));
            most = std::max(most, moved ? std::abs(*moved - value_here) : 0.0);
        }
        return most;
    }

    const ResultTable& table_;
    const ExactContact& exact_;
    std::vector<RoughPoint> points_;
    Real exact_origin_ = Real(0);
    double origin_uncertainty_ = 0;
    AlignedResult result_;
};

} // namespace

AlignedResult align(const ResultTable& table, const ExactContact& exact,
                    const std::optional<Rational>& origin) {
    const PrecisionScope scope(ExactContact::place_digits);
    return Aligner(table, exact).align(origin);
}

} // namespace edgeproof::comparison
