// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/comparison.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/rational.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/scene/run_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace edgeproof::comparison {
namespace {

constexpr unsigned surface_digits = 12;

class SurfaceComparison {
public:
    SurfaceComparison(FileComparison& file, const scene::Scene& scene, const ExactContact& exact,
                      const Tolerances& tolerances)
        : file_(file), scene_(scene), exact_(exact), tolerances_(tolerances) {}

    void compare_all() {
        if (usable(0, "gap")) {
            keep(compare(0, "gap", scene::Quantity::gap));
        }
        slip();
        if (usable(2, "sxx")) {
            sxx();
        }
        if (tolerances_.surface && !any_column_) {
            file_.failures.emplace_back("neither gap nor slip nor sxx is compared: the data have "
                                        "no values of them (COPEN, CSLIP1, S11)");
        }
    }

private:
    void slip() {
        const bool friction = scene_.shear && scene_.shear->friction;
        const bool zero = std::ranges::all_of(
            file_.table.rows, [](const ResultRow& row) { return row.surface[1].value_or(0) == 0; });
        if ((zero && !friction) || !usable(1, "slip")) {
            return; // programs write zeros for a contact without friction
        }
        if (!friction) {
            not_compared("slip", "the scene has no friction");
            return;
        }
        keep(compare(1, "slip", scene::Quantity::slip_displacement));
    }
    void sxx() {
        const auto of_A = compare(2, "sxx", scene::Quantity::sxx);
        if (!of_A || !scene_.shear) {
            keep(of_A);
            return;
        }
        const auto of_B = compare(2, "sxx", scene::Quantity::sxx, scene::Body::B);
        const bool B = of_B && of_B->peak < of_A->peak;
        keep(B ? of_B : of_A);
        file_.data.findings.push_back(fmt::format(
            "sxx is compared with that of body {}, which agrees better", B ? "B" : "A"));
    }

    /// True if the data have the quantity, and each cell of its column is a number or empty.
    bool usable(std::size_t k, const char* name) {
        const auto& rows = file_.table.rows;
        if (std::ranges::none_of(
                rows, [k](const ResultRow& row) { return row.surface[k].has_value(); })) {
            return false;
        }
        any_column_ = true;
        const auto bad = std::ranges::find_if(
            rows, [k](const ResultRow& row) { return std::isnan(row.surface[k].value_or(0)); });
        if (bad != rows.end()) {
            not_compared(name, fmt::format("its cell in line {} is no number; leave the cell empty "
                                           "if there is no value",
                                           bad->line));
        }
        return bad == rows.end();
    }
    /// A quantity that has a tolerance fails if it is not compared.
    void not_compared(const std::string& name, const std::string& why) {
        (tolerances_.surface ? file_.failures : file_.data.findings)
            .push_back(name + " is not compared: " + why);
    }
    void keep(const std::optional<SurfaceErrors>& found) {
        if (!found) {
            return;
        }
        file_.surface.push_back(*found);
        if (tolerances_.surface && !(found->peak <= *tolerances_.surface)) {
            const Node& node = file_.data.nodes[found->worst];
            file_.failures.push_back(fmt::format(
                "the error of {}, {:.3g} % {}, is more than {:.3g} %: line {}, x = {:.6g}, {} = "
                "{:.6g}, exact {:.6g}",
                found->name, 100 * found->peak, found->reference, 100 * *tolerances_.surface,
                node.line, node.x, found->name, found->data, found->exact));
        }
    }

    struct Pair {
        std::size_t node;
        double data;
        double exact;
    };

    /// The largest error, of slip for the better one of its directions; nothing, with the reason,
    /// if too few nodes have a value.
    std::optional<SurfaceErrors> compare(std::size_t k, const char* name, scene::Quantity quantity,
                                         scene::Body body = scene::Body::A) {
        const bool gap = quantity == scene::Quantity::gap;
        const bool of_slip = quantity == scene::Quantity::slip_displacement;
        const bool of_sxx = quantity == scene::Quantity::sxx;
        std::unique_ptr<scene::SceneValues> values;
        std::string route;
        std::string why;
        /// Nothing where the scene has no value: on an edge, or without a closed form.
        const auto exact = [&](double x) -> std::optional<double> {
            check_interruption();
            scene::AskedValue asked = asked_at(quantity, Real(x));
            if (of_sxx) {
                asked.place.reset();
                asked.in_body = {
                    formula::Exact(formula::Expr::number(exact_rational(x))), {}, body};
            }
            try {
                if (!values) {
                    values = std::make_unique<scene::SceneValues>(
                        scene_, std::vector{asked},
                        scene::Digits{surface_digits, Rounding::nearest, false});
                }
                const scene::BoundedValue value = values->value(asked);
                route = value.how();
                return value.value.midpoint().convert_to<double>();
            } catch (const Error& error) {
                why = error.what();
                return {};
            }
        };
        std::vector<Pair> pairs;
        double largest = 0;
        std::size_t given = 0; // nodes whose value shows whether the quantity is right
        std::size_t unknown = 0;
        for (std::size_t i = 0; i < file_.data.nodes.size(); ++i) {
            const Node& node = file_.data.nodes[i];
            const auto& data = file_.table.rows[i].surface[k];
            const bool inside = node.place.inside();
            if (!data || !is_counted(node, tolerances_.zone, file_.contact) ||
                (of_slip && !inside)) {
                continue;
            }
            const bool closed = gap && inside;
            constexpr double on_an_edge = 1e-9; // no value is necessary there
            if (const auto value = closed ? std::optional(0.0) : exact(node.x)) {
                pairs.push_back({i, *data, *value});
                largest = std::max(largest, std::abs(*value));
                given += closed ? 0 : 1;
            } else if (std::abs(node.place.u()) > on_an_edge * exact_.length()) {
                ++unknown;
            }
        }
        if (unknown > 0) {
            not_compared(fmt::format("{} at {}", name,
                                     unknown == 1 ? "1 node" : fmt::format("{} nodes", unknown)),
                         why);
        }
        if (given < fewest_inside) {
            not_compared(name, fmt::format("{} of the nodes {}the edge zones {} it; at least {} "
                                           "are necessary",
                                           given, gap ? "outside the contact and " : "outside ",
                                           given == 1 ? "has" : "have", fewest_inside));
            return {};
        }
        if (!(largest > 0)) {
            if (std::ranges::any_of(pairs, [](const Pair& pair) { return pair.data != 0; })) {
                not_compared(name, "the exact one is 0 at all nodes");
            }
            return {};
        }
        SurfaceErrors found{name,
                            of_sxx ? exact_.scale().mean ? "of the mean pressure" : "of the peak"
                                   : fmt::format("of the largest exact {} at these nodes", name),
                            route,
                            of_sxx ? exact_.scale().value : largest,
                            pairs.size(),
                            INFINITY};
        for (const double sign : {1.0, of_slip ? -1.0 : 1.0}) {
            SurfaceErrors one = found;
            one.peak = -1;
            for (const Pair& p : pairs) {
                const double error = std::abs(sign * p.data - p.exact) / found.scale;
                if (!(error <= one.peak)) {
                    one.peak = error;
                    one.worst = p.node;
                    one.data = sign * p.data;
                    one.exact = p.exact;
                }
            }
            found = one.peak < found.peak ? one : found;
        }
        return found;
    }

    FileComparison& file_;
    const scene::Scene& scene_;
    const ExactContact& exact_;
    const Tolerances& tolerances_;
    bool any_column_ = false; ///< the data have gap, slip or sxx
};

} // namespace

void compare_surface(FileComparison& file, const scene::Scene& scene, const ExactContact& exact,
                     const Tolerances& tolerances) {
    SurfaceComparison(file, scene, exact, tolerances).compare_all();
}

} // namespace edgeproof::comparison
