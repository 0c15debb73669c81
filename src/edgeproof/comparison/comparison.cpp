// SPDX-License-Identifier: GPL-3.0-or-later
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

constexpr std::array both_edges{contact::Edge::right, contact::Edge::left};

std::string percent(double x) { return fmt::format("{:.3g} %", 100 * x); }

double in_norm(const Errors& errors, Norm norm) {
    return norm == Norm::peak ? errors.peak : norm == Norm::local ? errors.local : errors.l2;
}

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
        for (const contact::Edge at : both_edges) {
            if (tolerances_.edges && file_.data.has(at)) {
                edge(at);
            }
        }
        if (tolerances_.force) {
            force();
        }
        for (const contact::Edge at : both_edges) {
            if (tolerances_.c0 && file_.data.has(at)) {
                coefficient(at);
            }
        }
    }

private:
    void fail(std::string why) { file_.failures.push_back(std::move(why)); }

    /// A quantity that the nodes do not determine fails.
    void coverage() {
        for (const Undetermined& missing : file_.undetermined) {
            const bool compared =
                missing.quantity == Determined::force
                    ? tolerances_.force.has_value()
                    : missing.quantity != Determined::largest && tolerances_.edges.has_value();
            if (!tolerances_.partial || compared) {
                fail(missing.why + (tolerances_.partial
                                        ? ""
                                        : "; give all of the contact, or --partial to compare p at "
                                          "these nodes alone"));
            }
        }
    }
    /// p or q, and what it is compared with.
    struct Judged {
        const char* symbol;
        const Errors& errors;
        double tolerance;
        double scale;
        std::string of_scale;
        TractionOf of;
        double ResultRow::*rounding;
    };
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
        hold({"p", errors, tolerances_.pressure, exact_.scale().value,
              exact_.scale().mean ? "of the mean pressure" : "of the peak", p_of,
              &ResultRow::p_rounding});
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
        hold({"q", *file_.shear, tolerances_.q.value_or(tolerances_.pressure),
              exact_.shear()->scale, "of " + exact_.shear()->scale_text, q_of,
              &ResultRow::q_rounding});
    }
    void hold(const Judged& judged) {
        // Written digits may explain errors up to the tolerance, or the usual one: larger errors
        // would be hidden completely.
        double hidden = 0;
        for (std::size_t i = 0; i < file_.data.nodes.size(); ++i) {
            const Node& node = file_.data.nodes[i];
            const Traction* const t = judged.of(node);
            if (t != nullptr && t->exact && is_counted(node, tolerances_.zone, file_.contact)) {
                const double rounding = file_.table.rows[i].*judged.rounding;
                hidden = std::max(hidden, std::min(std::abs(t->error), rounding) / judged.scale);
            }
        }
        if (!(hidden <= std::max(judged.tolerance, Tolerances::usual))) {
            fail(fmt::format("{} is written with too few digits: they hide errors of {} {}",
                             judged.symbol, percent(hidden), judged.of_scale));
        }
        const double error = in_norm(judged.errors, tolerances_.of);
        if (error <= judged.tolerance) {
            return;
        }
        const auto worst =
            tolerances_.of == Norm::local ? judged.errors.worst_local : judged.errors.worst;
        std::string relative_to = judged.of_scale;
        std::string where;
        if (tolerances_.of == Norm::l2) {
            relative_to = "in the L2 norm";
        } else if (worst) {
            const Node& node = file_.data.nodes[*worst];
            where = fmt::format(": line {}, x = {:.6g}, {} = {:.6g}, exact {:.6g}", node.line,
                                node.x, judged.symbol, judged.of(node)->data,
                                judged.of(node)->exact.value_or(0));
            if (tolerances_.of == Norm::local && node.place.inside()) {
                relative_to = fmt::format("of {} itself", judged.symbol);
            }
        }
        fail(fmt::format("the error of {}, {} {}, is more than {}{}", judged.symbol, percent(error),
                         relative_to, percent(judged.tolerance), where));
    }
    /// The difference between a value of the data and the result of the same rule for the exact
    /// pressure, relative to the exact value.
    static double off(double data, double of_exact, double exact) {
        return std::abs((data - of_exact) / exact);
    }
    void hold_value(const std::string& data_text, double data, double of_exact, double exact,
                    double tolerance) {
        const double error = off(data, of_exact, exact);
        if (!(error <= tolerance)) {
            fail(fmt::format("{} is off by {} of the exact {:.6g}, more than {} (of the exact "
                             "pressure at these nodes: {:.6g})",
                             data_text, percent(error), exact, percent(tolerance), of_exact));
        }
    }
    void edge(contact::Edge at) {
        const char* const name = at == contact::Edge::right ? "a" : "b";
        const auto& data = file_.contact.at(at);
        const double exact = exact_.edge(at);
        if (!data) {
            fail(fmt::format("{} is not known: no pressure of the data is greater than 0", name));
            return;
        }
        hold_value(fmt::format("{} = {:.6g} by the data", name, *data), *data,
                   file_.of_exact.at(at).value_or(exact), exact, *tolerances_.edges);
    }
    void force() {
        const auto missing = [this](contact::Edge at) {
            return file_.data.has(at) && !file_.contact.reaches[index_of(at)];
        };
        if (std::ranges::any_of(both_edges, missing)) {
            fail("P is not known: the data end inside the contact");
            return;
        }
        const double P = *file_.contact.force;
        hold_value(fmt::format("P = {:.6g} by the data", P), P, *file_.of_exact.force,
                   exact_.force().value, *tolerances_.force);
    }
    void coefficient(contact::Edge edge) {
        const auto& fit = file_.fits[index_of(edge)];
        const double exact = exact_.c(edge, 0).value;
        const std::string name = "c_0 at the " + scene::edge_name(edge) + " edge";
        if (!fit) {
            fail(name + " is not known: too few nodes within the reach of the expansion");
            return;
        }
        const double of_exact = fit->own_edge ? exact : fit->c0.of_exact;
        if (!fit->own_edge && !(off(of_exact, exact, exact) <= most_of_rule)) {
            fail(fmt::format("{} is not determined: the same fit of the exact pressure at these "
                             "nodes gives {:.6g}, but the exact value is {:.6g}",
                             name, of_exact, exact));
        }
        hold_value(
            fmt::format("{} by the data, {:.6g} +- {:.2g},", name, fit->c0.value, fit->c0.spread),
            fit->c0.value, of_exact, exact, *tolerances_.c0);
    }

    FileComparison& file_;
    const ExactContact& exact_;
    const Tolerances& tolerances_;
};

/// Most of the nodes inside the contact must remain.
std::optional<SuggestedZone> suggested_zone(const FileComparison& file, const ExactContact& exact,
                                            const Tolerances& tolerances) {
    constexpr int most_elements = 10;
    for (int elements = 1; elements <= most_elements; ++elements) {
        const EdgeZone zone{static_cast<double>(elements), {}};
        const auto left = std::ranges::count_if(file.data.nodes, [&](const Node& node) {
            return node.place.inside() && is_counted(node, zone, file.contact);
        });
        const double error = in_norm(measure(file.data, exact, file.contact, zone), tolerances.of);
        if (2 * left < static_cast<std::ptrdiff_t>(file.inside)) {
            break;
        }
        if (error <= tolerances.pressure) {
            return SuggestedZone{
                elements,
                {elements * file.contact.element[0], elements * file.contact.element[1]},
                error};
        }
    }
    return {};
}

void count_nodes(FileComparison& file) {
    for (const Node& node : file.data.nodes) {
        const bool inside = node.place.inside();
        file.inside += inside ? 1 : 0;
        file.outside += inside ? 0 : 1;
        file.pressing_outside +=
            !inside && std::abs(node.p.data) > pressing_fraction * file.contact.largest ? 1 : 0;
    }
}

/// Integrates Q by trapezoids, for the data and for the exact q at the same nodes.
void sum_shear(FileComparison& file, const ExactContact& contact) {
    const auto exact = [](const Node& node) {
        return node.q ? node.q->exact : std::optional<double>();
    };
    if (!file.data.half && std::ranges::any_of(file.data.nodes, [&](const Node& node) {
            return exact(node).has_value();
        })) {
        file.Q = force_of(file.data, contact, [&](const Node& node) {
            return exact(node) ? std::optional(node.q->data) : std::nullopt;
        });
        file.Q_of_exact = force_of(file.data, contact, exact);
    }
}

void find_more(FileComparison& file, const ExactContact& exact) {
    auto& findings = file.data.findings;
    const bool has_q = std::ranges::any_of(
        file.table.rows, [](const ResultRow& row) { return row.q && *row.q != 0; });
    if (exact.shear() == nullptr && has_q) {
        findings.emplace_back("q is not compared: the scene has no [shear]");
    }
    if (exact.shear() != nullptr && !file.table.rows.front().q) {
        findings.emplace_back("the scene has shear, and the data have no q (CSHEAR1, or "
                              "--columns q=3)");
    }
    if (file.outside > 0) {
        findings.push_back(fmt::format(
            "{} of {} nodes lie outside the exact contact{}", file.outside, file.data.nodes.size(),
            file.pressing_outside > 0
                ? fmt::format("; {} of them have a pressure", file.pressing_outside)
                : ", where p is 0"));
    }
    if (file.contact.gaps > 0) {
        findings.push_back(fmt::format(
            "the pressure of the data falls to zero at {} inside",
            file.contact.gaps == 1 ? "1 place" : fmt::format("{} places", file.contact.gaps)));
    }
    const auto corners = std::ranges::count_if(
        file.data.nodes, [](const Node& node) { return !node.p.exact.has_value(); });
    if (exact.scale().mean) {
        findings.push_back(
            "the exact pressure is infinite at a corner of the profile: errors of the "
            "peak are relative to the mean pressure " +
            std::string(exact.axisymmetric() ? "P/(pi a^2)" : "P/(a + b)") +
            (corners > 0
                 ? fmt::format(", and {} on it {} left out",
                               corners == 1 ? "the node" : "the nodes", corners == 1 ? "is" : "are")
                 : std::string()));
    }
    for (const contact::Edge edge : both_edges) {
        if (!file.contact.reaches[index_of(edge)] && file.data.has(edge)) {
            findings.push_back("the data end inside the contact, before its " +
                               scene::edge_name(edge) + " edge");
        }
    }
}

/// Throws InputError, with the file, if fewer than three nodes lie inside the exact contact, or if
/// the edge zones leave none of these: such data cannot be compared. The advice depends on the
/// loaded part of the data and its width: a finer mesh if fewer than three nodes are loaded,
/// another origin if the width is half to twice the contact's, otherwise another unit.
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

} // namespace

Norm norm_named(std::string_view name) {
    if (name == "peak" || name == "local") {
        return name == "peak" ? Norm::peak : Norm::local;
    }
    require(name == "L2" || name == "l2",
            "--of " + std::string(name) + " is no measure of an error", "write peak, local or L2");
    return Norm::l2;
}

std::vector<std::string> FileComparison::findings() const {
    std::vector<std::string> both = table.findings;
    both.insert(both.end(), data.findings.begin(), data.findings.end());
    return both;
}

bool Comparison::passes() const { return std::ranges::all_of(files, &FileComparison::passes); }

FileComparison compare_file(ResultTable table, const ExactContact& exact,
                            const Tolerances& tolerances, const std::optional<Rational>& origin,
                            SuspectContacts* suspects) {
    FileComparison file;
    file.table = std::move(table);
    file.data = align(file.table, exact, origin);
    file.contact = contact_of(file.data, exact);
    AlignedResult of_exact = file.data;
    for (Node& node : of_exact.nodes) {
        node.p.data = node.p.exact.value_or(node.p.data);
    }
    file.of_exact = contact_of(of_exact, exact);
    if (const auto elements = sampled_elements(file.table)) {
        file.contact.element = elements->at_edge;
        file.contact.mean_element = elements->mean;
        file.data.findings.push_back(
            fmt::format("p is linear between places that are about {:.4g} apart: the rows are "
                        "samples of a line through elements of this width",
                        elements->mean));
    }
    file.undetermined = undetermined(file.data, file.of_exact, exact);
    count_nodes(file);
    find_more(file, exact);
    file.errors = measure(file.data, exact, file.contact, tolerances.zone);
    file.all = measure(file.data, exact, file.contact, {});
    file.shear = measure_shear(file.data, exact, file.contact, tolerances.zone);
    sum_shear(file, exact);
    file.distances = by_distance(file.data, exact);
    file.knots = errors_near_knots(file.data, exact, file.contact);
    for (const contact::Edge edge : both_edges) {
        constexpr double elements_smeared = 2;
        const double smeared = elements_smeared * file.contact.element[index_of(edge)];
        const double leave_out = std::max(tolerances.zone.at(edge, file.contact), smeared);
        // A contact of another size has its own edges, and its own c_0 there.
        const auto& by_data = file.contact.at(edge);
        const double outwards = by_data.value_or(0) - exact.edge(edge);
        const bool elsewhere = by_data && std::abs(outwards) > smeared;
        file.fits[index_of(edge)] = fit_edge(file.data, exact, edge, leave_out,
                                             elsewhere ? std::optional(outwards) : std::nullopt);
    }
    Judge(file, exact, tolerances).judge();
    // Data within the tolerance are diagnosed if their error exceeds that of a mesh. If data fail
    // only for lack of nodes, there is nothing to explain.
    constexpr double worth_a_word = 0.003;
    constexpr double roundoff = 1e-9;
    const double least = file.passes() ? worth_a_word : roundoff;
    const double own_error = expected_mesh_error(
        file.contact.mean_element > 0 ? exact.length() / file.contact.mean_element : 1,
        exact.scale().mean);
    if (suspects != nullptr && file.all.peak > least) {
        file.diagnosis =
            diagnose_pressure(file.table, file.data, file.contact, *suspects, exact, own_error);
    }
    if (file.passes() && file.diagnosis && file.diagnosis->too_few &&
        file.diagnosis->causes.empty()) {
        file.diagnosis.reset(); // there is no error that these nodes show
    }
    const bool right = !file.diagnosis || file.diagnosis->at_edges_only;
    if (!file.passes() && file.diagnosis && file.diagnosis->at_edges_only &&
        !(in_norm(file.errors, tolerances.of) <= tolerances.pressure)) {
        file.suggested_zone = suggested_zone(file, exact, tolerances);
    }
    if (suspects != nullptr && right && file.shear && file.shear->peak > least) {
        file.shear_diagnosis = diagnose_shear(file.data, file.contact, *suspects, exact, own_error);
    }
    return file;
}

std::vector<Convergence> convergence_of(const std::vector<FileComparison>& files,
                                        const ExactContact& exact) {
    std::vector<Convergence> list;
    /// `exact_value`: 0 for a quantity that is an error itself.
    const auto add = [&](const char* name, double exact_value, const auto& of) {
        std::vector<MeshValue> errors;
        for (const FileComparison& file : files) {
            const std::optional<double> value = of(file);
            if (!value || !(file.contact.mean_element > 0)) {
                return;
            }
            constexpr double roundoff = 1e-8; // of printed digits: such an error has no order
            const double error = *value - exact_value;
            errors.push_back({file.contact.mean_element,
                              std::abs(error) < roundoff * std::abs(exact_value) ? 0 : error});
        }
        if (errors.size() >= 2) {
            list.push_back({name, order_of(std::move(errors))});
        }
    };
    add("a", exact.a().value, [](const auto& f) { return f.contact.a; });
    add("b", exact.b().value, [](const auto& f) { return f.contact.b; });
    add("P", exact.force().value, [](const auto& f) { return f.contact.force; });
    for (const contact::Edge edge : both_edges) {
        add(edge == contact::Edge::right ? "c0" : "c0_left", exact.c(edge, 0).value,
            [edge](const auto& f) {
                const auto& fit = f.fits[index_of(edge)];
                return fit ? std::optional(fit->c0.value) : std::nullopt;
            });
    }
    if (!exact.scale().mean) {
        add("p_max", exact.scale().value, [](const auto& f) { return f.contact.largest; });
    }
    add("peak", 0, [](const auto& f) { return f.errors.peak; });
    add("local", 0, [](const auto& f) { return f.errors.local; });
    add("l2", 0, [](const auto& f) { return f.errors.l2; });
    return list;
}

Comparison compare_tables(std::vector<ResultTable> tables, const scene::Scene& scene,
                          const ExactContact& exact, const Tolerances& tolerances,
                          const std::optional<Rational>& origin,
                          const std::function<void(std::size_t, std::size_t)>& progress) {
    Comparison all{tolerances, {}, {}};
    SuspectContacts suspects(scene);
    for (ResultTable& table : tables) {
        progress(all.files.size(), tables.size());
        all.files.push_back(compare_file(std::move(table), exact, tolerances, origin, &suspects));
        compare_surface(all.files.back(), scene, exact, tolerances);
        require_nodes_inside(all.files.back(), exact, tolerances.zone);
    }
    progress(tables.size(), tables.size());
    if (all.files.size() > 1) {
        all.convergence = convergence_of(all.files, exact);
    }
    return all;
}

} // namespace edgeproof::comparison
