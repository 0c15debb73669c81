// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/comparison/comparison.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/real.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/scene/run_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace edgeproof::comparison {
namespace {

constexpr unsigned surface_digits = 12;
constexpr double on_an_edge = 1e-9; ///< relative to a + b: no value is necessary there

using scene::Quantity;

/// A quantity along the surface; the index is that of surface_roles.
struct SurfaceQuantity {
    const char* name;
    Quantity quantity;
    const char* where; ///< its nodes
};
constexpr SurfaceQuantity quantities[] = {{"gap", Quantity::gap, "outside the contact and "},
                                          {"slip", Quantity::slip_displacement, "outside "},
                                          {"sxx", Quantity::sxx, "outside "}};

/// A node, and the value of the data and of the scene there.
struct Pair {
    std::size_t node;
    double data;
    double exact;
};

/// The largest error of the pairs; `found` has the rest.
SurfaceErrors with_errors(SurfaceErrors found, const std::vector<Pair>& pairs, double sign) {
    found.peak = -1;
    for (const Pair& p : pairs) {
        const double error = std::abs(sign * p.data - p.exact) / found.scale;
        if (!(error <= found.peak)) {
            found.peak = error;
            found.worst = p.node;
            found.data = sign * p.data;
            found.exact = p.exact;
        }
    }
    return found;
}

class SurfaceComparison {
public:
    SurfaceComparison(FileComparison& file, const scene::Scene& scene, const ExactContact& exact,
                      const Tolerances& tolerances)
        : file_(file), scene_(scene), exact_(exact), tolerances_(tolerances) {}

    void compare_all() {
        for (std::size_t k = 0; k < std::size(quantities); ++k) {
            if (usable(k)) {
                keep(compared(k));
            }
        }
        if (tolerances_.surface && !any_column_) {
            file_.failures.emplace_back("neither gap nor slip nor sxx is compared: the data have "
                                        "no values of them (COPEN, CSLIP1, S11)");
        }
    }

private:
    /// True if the data have the quantity, and each cell of its column is a number or empty.
    bool usable(std::size_t k) {
        const std::string name = quantities[k].name;
        const auto& rows = file_.table.rows;
        const bool slip = quantities[k].quantity == Quantity::slip_displacement;
        const bool friction = scene_.shear && scene_.shear->friction;
        // Programs write zeros for a contact without friction.
        const bool none = std::ranges::all_of(rows, [&](const ResultRow& row) {
            return slip && !friction ? row.surface[k].value_or(0) == 0 : !row.surface[k];
        });
        if (none) {
            return false;
        }
        any_column_ = true;
        const auto bad = std::ranges::find_if(
            rows, [k](const ResultRow& row) { return std::isnan(row.surface[k].value_or(0)); });
        if (bad != rows.end()) {
            not_compared(name, fmt::format("its cell in line {} is no number; leave the cell empty "
                                           "if there is no value",
                                           bad->line));
        } else if (slip && !friction) {
            not_compared(name, "the scene has no friction");
        }
        return bad == rows.end() && (!slip || friction);
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

    /// The errors for the direction of the slip, and for the body with sxx, that agree better.
    std::optional<SurfaceErrors> compared(std::size_t k) {
        const auto of_A = compared(k, scene::Body::A);
        if (quantities[k].quantity != Quantity::sxx || !of_A || !scene_.shear) {
            return of_A;
        }
        const auto of_B = compared(k, scene::Body::B);
        const bool B = of_B && of_B->peak < of_A->peak;
        file_.data.findings.push_back(fmt::format(
            "sxx is compared with that of body {}, which agrees better", B ? "B" : "A"));
        return B ? of_B : of_A;
    }
    /// Returns nothing, with the reason, if too few nodes have a value.
    std::optional<SurfaceErrors> compared(std::size_t k, scene::Body body) {
        const auto& [name, quantity, where] = quantities[k];
        const bool gap = quantity == Quantity::gap;
        const bool of_slip = quantity == Quantity::slip_displacement;
        std::vector<Pair> pairs;
        double largest = 0;
        std::size_t given = 0; // nodes whose value shows whether the quantity is right
        std::size_t unknown = 0;
        values_.reset();
        for (std::size_t i = 0; i < file_.data.nodes.size(); ++i) {
            const Node& node = file_.data.nodes[i];
            const auto& data = file_.table.rows[i].surface[k];
            const bool inside = node.place.inside();
            if (!data || !is_counted(node, tolerances_.zone, file_.contact) ||
                (of_slip && !inside)) {
                continue;
            }
            const bool closed = gap && inside;
            const auto value = closed ? std::optional(0.0) : exact(quantity, body, node.x);
            if (value) {
                pairs.push_back({i, *data, *value});
                largest = std::max(largest, std::abs(*value));
                given += closed ? 0 : 1;
            } else if (std::abs(node.place.u()) > on_an_edge * exact_.length()) {
                ++unknown;
            }
        }
        if (unknown > 0) {
            not_compared(fmt::format("{} at {} node{}", name, unknown, unknown == 1 ? "" : "s"),
                         why_);
        }
        if (given < fewest_inside) {
            not_compared(name,
                         fmt::format("{} of the nodes {}the edge zones {} it; at least {} "
                                     "are necessary",
                                     given, where, given == 1 ? "has" : "have", fewest_inside));
            return {};
        }
        if (!(largest > 0)) {
            if (std::ranges::any_of(pairs, [](const Pair& pair) { return pair.data != 0; })) {
                not_compared(name, "the exact one is 0 at all nodes");
            }
            return {};
        }
        const bool of_sxx = quantity == Quantity::sxx;
        const SurfaceErrors found{name,
                                  of_sxx
                                      ? exact_.scale().mean ? "of the mean pressure" : "of the peak"
                                      : fmt::format("of the largest exact {} at these nodes", name),
                                  route_, of_sxx ? exact_.scale().value : largest, pairs.size()};
        const SurfaceErrors right = with_errors(found, pairs, 1);
        const SurfaceErrors left = with_errors(found, pairs, -1);
        return of_slip && left.peak < right.peak ? left : right;
    }
    /// Nothing where the scene has no value: on an edge, or without a closed form.
    std::optional<double> exact(Quantity quantity, scene::Body body, double x) {
        check_interruption();
        scene::AskedValue asked = asked_at(quantity, Real(x));
        if (quantity == Quantity::sxx) {
            asked.place.reset();
            asked.in_body = {formula::Exact(formula::Expr::number(exact_rational(x))), {}, body};
        }
        try {
            if (!values_) {
                values_.emplace(scene_, std::vector{asked},
                                scene::Digits{surface_digits, Rounding::nearest, false});
            }
            const scene::BoundedValue value = values_->value(asked);
            route_ = value.how();
            return value.value.midpoint().convert_to<double>();
        } catch (const Error& error) {
            why_ = error.what();
            return {};
        }
    }

    FileComparison& file_;
    const scene::Scene& scene_;
    const ExactContact& exact_;
    const Tolerances& tolerances_;
    bool any_column_ = false;                  ///< the data have gap, slip or sxx
    std::optional<scene::SceneValues> values_; ///< of the present quantity
    std::string route_;
    std::string why_; ///< there is no value
};

} // namespace

void compare_surface(FileComparison& file, const scene::Scene& scene, const ExactContact& exact,
                     const Tolerances& tolerances) {
    SurfaceComparison(file, scene, exact, tolerances).compare_all();
}

} // namespace edgeproof::comparison
