// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/comparison/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace edgeproof::comparison {
namespace {

void count_nodes(FileComparison& file) {
    const auto& nodes = file.data.nodes;
    const auto count = [&](const auto& counts) {
        return static_cast<std::size_t>(std::ranges::count_if(nodes, counts));
    };
    file.inside = count([](const Node& node) { return node.place.inside(); });
    file.outside = nodes.size() - file.inside;
    file.pressing_outside = count([&](const Node& node) {
        return !node.place.inside() &&
               std::abs(node.p.data) > pressing_fraction * file.contact.largest;
    });
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

} // namespace

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
    judge(file, exact, tolerances);
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
    if (suspects != nullptr && right && file.shear && file.shear->peak > least) {
        file.shear_diagnosis = diagnose_shear(file.data, file.contact, *suspects, exact, own_error);
    }
    return file;
}

std::vector<ComparedQuantity> compared_quantities(const FileComparison& file,
                                                  const ExactContact& exact) {
    const DataContact& data = file.contact;
    const DataContact& rule = file.of_exact;
    std::vector<ComparedQuantity> list{{"a", contact::Edge::right, data.a, rule.a, exact.a().value},
                                       {"b", contact::Edge::left, data.b, rule.b, exact.b().value},
                                       {"P", {}, data.force, rule.force, exact.force().value}};
    if (!exact.scale().mean) {
        list.push_back({"largest p", {}, data.largest, rule.largest, exact.scale().value});
    }
    if (file.Q) {
        list.push_back({"Q", {}, file.Q, file.Q_of_exact, exact.shear()->force});
    }
    for (const contact::Edge edge : both_edges) {
        const auto& fit = file.fits[index_of(edge)];
        for (const std::size_t k : {0U, 1U}) {
            ComparedQuantity& q = list.emplace_back(ComparedQuantity{
                fmt::format("c_{}{}", k, edge == contact::Edge::right ? "" : " left"), edge});
            q.exact = exact.c(edge, k).value;
            if (!fit) {
                q.note = "(too few nodes)";
                continue;
            }
            const FittedCoefficient& c = k == 0 ? fit->c0 : fit->c1;
            q.data = c.value;
            q.spread = c.spread;
            q.of_exact = fit->own_edge ? std::nullopt : std::optional(c.of_exact);
            q.note = k == 0 ? fmt::format("({} nodes, u{} from {:.3g} to {:.3g}, {} terms)",
                                          fit->nodes, fit->own_edge ? " from the data's edge," : "",
                                          fit->from, fit->to, fit->terms)
                            : "";
        }
    }
    return list;
}

std::vector<Convergence> convergence_of(const std::vector<FileComparison>& files,
                                        const ExactContact& exact) {
    std::vector<Convergence> list;
    /// `error_of`: that of a file, and the exact value; nothing if the file has none.
    const auto add = [&](const char* name, const auto& error_of) {
        std::vector<MeshValue> errors;
        for (const FileComparison& file : files) {
            const std::optional<std::pair<double, double>> of_file = error_of(file);
            if (!of_file || !(file.contact.mean_element > 0)) {
                return;
            }
            constexpr double roundoff = 1e-8; // of printed digits: such an error has no order
            const auto& [error, size] = *of_file;
            errors.push_back({file.contact.mean_element,
                              std::abs(error) < roundoff * std::abs(size) ? 0 : error});
        }
        if (errors.size() >= 2) {
            list.push_back({name, order_of(std::move(errors))});
        }
    };
    using Names = std::pair<const char*, const char*>;
    for (const auto& [name, quantity] :
         {Names{"a", "a"}, Names{"b", "b"}, Names{"P", "P"}, Names{"c0", "c_0"},
          Names{"c0_left", "c_0 left"}, Names{"p_max", "largest p"}}) {
        add(name, [&, quantity = quantity](const FileComparison& file) {
            const auto all = compared_quantities(file, exact);
            const auto q = std::ranges::find(all, quantity, &ComparedQuantity::name);
            return q == all.end() || !q->data
                       ? std::nullopt
                       : std::optional(std::pair(*q->data - q->exact, q->exact));
        });
    }
    for (const auto& [name, error] :
         {std::pair{"peak", &Errors::peak}, {"local", &Errors::local}, {"l2", &Errors::l2}}) {
        add(name, [error = error](const FileComparison& file) {
            return std::optional(std::pair(file.errors.*error, 0.0));
        });
    }
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
