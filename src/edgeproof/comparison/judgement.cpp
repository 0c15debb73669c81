// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/comparison/comparison.hpp"
#include "edgeproof/precision/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace edgeproof::comparison {
namespace {

constexpr double most_of_rule = 0.1; ///< the largest error allowed for a fit of the exact pressure

std::string percent(double x) { return fmt::format("{:.3g} %", 100 * x); }

class Judge {
public:
    Judge(FileComparison& file, const ExactContact& exact, const Tolerances& tolerances)
        : file_(file), exact_(exact), tolerances_(tolerances) {}

    void judge() {
        if (file_.inside < fewest_inside) {
            fail(fmt::format("{} of {} nodes lie inside the contact -{:.6g} < x < {:.6g}: other "
                             "units (--scale), another origin (--origin), or another contact",
                             file_.inside, file_.data.nodes.size(), exact_.b().value,
                             exact_.a().value));
        }
        coverage();
        pressure();
        shear();
        for (const ComparedQuantity& q : compared_quantities(file_, exact_)) {
            const auto tolerance = tolerance_of(q.name);
            if (tolerance && (!q.edge || file_.data.has(*q.edge))) {
                hold(q, *tolerance);
            }
        }
    }

private:
    void fail(std::string why) { file_.failures.push_back(std::move(why)); }
    /// The tolerance for a, b, P or c_0.
    [[nodiscard]] std::optional<double> tolerance_of(std::string_view quantity) const {
        return quantity.starts_with("c_0")          ? tolerances_.c0
               : quantity == "P"                    ? tolerances_.force
               : quantity == "a" || quantity == "b" ? tolerances_.edges
                                                    : std::nullopt;
    }

    /// A quantity that the nodes do not determine fails.
    void coverage() {
        for (const Undetermined& missing : file_.undetermined) {
            if (!tolerances_.partial || tolerance_of(missing.quantity)) {
                fail(missing.why + (tolerances_.partial
                                        ? ""
                                        : "; give all of the contact, or --partial to compare p at "
                                          "these nodes alone"));
            }
        }
    }
    void pressure() {
        const Errors& errors = file_.errors;
        if (errors.nodes == 0) {
            fail("all nodes lie in the edge zones");
            return;
        }
        if (errors.inside < fewest_inside && file_.inside >= fewest_inside) {
            fail(fmt::format("{} of {} nodes inside the contact lie outside the edge zones: too "
                             "few for a comparison",
                             errors.inside, file_.inside));
        }
        hold("p", p_of, errors, tolerances_.pressure);
    }
    void shear() {
        if (!file_.shear) {
            if (tolerances_.q) {
                fail(exact_.shear() == nullptr
                         ? "q is not compared: the scene has no [shear]"
                         : "q is not compared: the data have no q (CSHEAR1, or --columns q=3)");
            }
            return;
        }
        if (file_.shear->inside < fewest_inside) {
            fail(fmt::format("q is compared at {} of {} nodes inside the contact, too few: the "
                             "others lie in the zones at the edges of the contact and of its stick "
                             "zone, or q is infinite there",
                             file_.shear->inside, file_.inside));
            return;
        }
        hold("q", q_of, *file_.shear, tolerances_.q.value_or(tolerances_.pressure));
    }
    /// Compares the errors of p or q with its tolerance.
    void hold(const char* symbol, TractionOf of, const Errors& errors, double tolerance) {
        const bool is_p = of == p_of;
        const double scale = is_p ? exact_.scale().value : exact_.shear()->scale;
        const std::string of_scale = !is_p                 ? "of " + exact_.shear()->scale_text
                                     : exact_.scale().mean ? "of the mean pressure"
                                                           : "of the peak";
        // Written digits may explain errors up to the tolerance, or the usual one: larger errors
        // would be hidden completely.
        double hidden = 0;
        for (std::size_t i = 0; i < file_.data.nodes.size(); ++i) {
            const Node& node = file_.data.nodes[i];
            const ResultRow& row = file_.table.rows[i];
            const Traction* const t = of(node);
            if (t != nullptr && t->exact && is_counted(node, tolerances_.zone, file_.contact)) {
                const double rounding = is_p ? row.p_rounding : row.q_rounding;
                hidden = std::max(hidden, std::min(std::abs(t->error), rounding) / scale);
            }
        }
        if (!(hidden <= std::max(tolerance, Tolerances::usual))) {
            fail(fmt::format("{} is written with too few digits: they hide errors of {} {}", symbol,
                             percent(hidden), of_scale));
        }
        const double error = in_norm(errors, tolerances_.of);
        if (error <= tolerance) {
            return;
        }
        const bool local = tolerances_.of == Norm::local;
        const auto worst = local ? errors.worst_local : errors.worst;
        std::string relative_to = of_scale;
        std::string where;
        if (tolerances_.of == Norm::l2) {
            relative_to = "in the L2 norm";
        } else if (worst) {
            const Node& node = file_.data.nodes[*worst];
            where = fmt::format(": line {}, x = {:.6g}, {} = {:.6g}, exact {:.6g}", node.line,
                                node.x, symbol, of(node)->data, of(node)->exact.value_or(0));
            relative_to =
                local && node.place.inside() ? fmt::format("of {} itself", symbol) : of_scale;
        }
        fail(fmt::format("the error of {}, {} {}, is more than {}{}", symbol, percent(error),
                         relative_to, percent(tolerance), where));
    }
    /// The difference between a value of the data and the result of the same rule for the exact
    /// pressure, relative to the exact value.
    static double off(double data, double of_exact, double exact) {
        return std::abs((data - of_exact) / exact);
    }
    /// Compares an edge, P or c_0 with its tolerance.
    void hold(const ComparedQuantity& q, double tolerance) {
        const bool c0 = q.name.starts_with("c_0");
        const std::string name = c0 ? "c_0 at the " + scene::edge_name(*q.edge) + " edge" : q.name;
        const auto ends_inside = [this](contact::Edge at) {
            return file_.data.has(at) && !file_.contact.reaches[index_of(at)];
        };
        if (q.name == "P" && std::ranges::any_of(both_edges, ends_inside)) {
            fail("P is not known: the data end inside the contact");
            return;
        }
        if (!q.data) {
            fail(name + " is not known: " +
                 (c0 ? "too few nodes within the reach of the expansion"
                     : "no pressure of the data is greater than 0"));
            return;
        }
        const double of_exact = q.of_exact.value_or(q.exact);
        if (c0 && !(off(of_exact, q.exact, q.exact) <= most_of_rule)) {
            fail(fmt::format("{} is not determined: the same fit of the exact pressure at these "
                             "nodes gives {:.6g}, but the exact value is {:.6g}",
                             name, of_exact, q.exact));
        }
        const double error = off(*q.data, of_exact, q.exact);
        if (!(error <= tolerance)) {
            const std::string data =
                c0 ? fmt::format("{} by the data, {:.6g} +- {:.2g},", name, *q.data, q.spread)
                   : fmt::format("{} = {:.6g} by the data", name, *q.data);
            fail(fmt::format("{} is off by {} of the exact {:.6g}, more than {} (of the exact "
                             "pressure at these nodes: {:.6g})",
                             data, percent(error), q.exact, percent(tolerance), of_exact));
        }
    }

    FileComparison& file_;
    const ExactContact& exact_;
    const Tolerances& tolerances_;
};

} // namespace

double in_norm(const Errors& errors, Norm norm) {
    return norm == Norm::peak ? errors.peak : norm == Norm::local ? errors.local : errors.l2;
}

Norm norm_named(std::string_view name) {
    if (name == "peak" || name == "local") {
        return name == "peak" ? Norm::peak : Norm::local;
    }
    require(name == "L2" || name == "l2",
            "--of " + std::string(name) + " is no measure of an error", "write peak, local or L2");
    return Norm::l2;
}

void judge(FileComparison& file, const ExactContact& exact, const Tolerances& tolerances) {
    Judge(file, exact, tolerances).judge();
}

void require_nodes_inside(const FileComparison& file, const ExactContact& exact,
                          const EdgeZone& zone) {
    constexpr double loaded_share = 0.02; // of the largest pressure
    constexpr double like_width = 2;      // the largest ratio of two widths of one contact
    const auto reject = [&](const std::string& problem, const std::string& instead) {
        throw InputError(problem, instead).at(file.table.file, 0);
    };
    if (file.inside >= fewest_inside) {
        const bool any = std::ranges::any_of(file.data.nodes, [&](const Node& node) {
            return node.place.inside() && is_counted(node, zone, file.contact);
        });
        if (!any) {
            reject(
                fmt::format("all {} nodes inside the contact lie in the edge zones", file.inside),
                "write a narrower --edge-zone, or give a finer mesh");
        }
        return;
    }
    const auto& nodes = file.data.nodes;
    const double a = exact.a().value;
    const double b = exact.b().value;
    double most = 0;
    for (const Node& node : nodes) {
        most = std::max(most, std::abs(node.p.data));
    }
    const auto pressing = [&](const Node& node) {
        return std::abs(node.p.data) > loaded_share * most;
    };
    const auto first = std::ranges::find_if(nodes, pressing);
    const std::string none =
        fmt::format("{} of the {} nodes {} inside the contact, {:.6g} < x < {:.6g}",
                    file.inside == 0 ? "none" : fmt::format("{}", file.inside), nodes.size(),
                    file.inside == 2 ? "lie" : "lies", -b + file.data.origin, a + file.data.origin);
    if (file.inside > 0 &&
        static_cast<std::size_t>(std::ranges::count_if(nodes, pressing)) < fewest_inside) {
        reject(none + ": too few for a comparison",
               "give a finer mesh: three nodes or more inside");
    }
    if (first == nodes.end()) {
        reject(none + ", and every pressure is zero",
               "give the nodes of the contact, with their pressures");
    }
    const auto last = std::find_if(nodes.rbegin(), nodes.rend(), pressing).base() - 1;
    const double from = first->x + file.data.origin;
    const double to = last->x + file.data.origin;
    const double steps = static_cast<double>(last - first);
    // The contact ends half an element beyond the loaded nodes.
    const double width = to - from + (steps > 0 ? (to - from) / steps : 0);
    const double ratio = exact.length() / width;
    const std::string instead =
        ratio > 1 / like_width && ratio < like_width
            ? fmt::format("write --origin {:.4g}, the x of the data at the scene's origin, or "
                          "--origin auto",
                          0.5 * (from + to) - 0.5 * (a - b))
            : fmt::format("write --scale x=..., about {:.2g}, if x is in another unit than the "
                          "scene's, --origin if it is measured from another place",
                          ratio);
    reject(fmt::format("{}: the pressures of the data extend from x = {:.6g} to {:.6g}", none, from,
                       to),
           instead);
}

} // namespace edgeproof::comparison
