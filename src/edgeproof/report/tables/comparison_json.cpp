// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/tables/comparison_report.hpp"

#include "edgeproof/precision/message.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace edgeproof::report {
namespace {

using nlohmann::ordered_json;

/// JSON has no infinity, which becomes null.
ordered_json number_json(const std::optional<double>& x) {
    return x && std::isfinite(*x) ? ordered_json(*x) : ordered_json(nullptr);
}

ordered_json errors_json(const comparison::Errors& e) {
    return {{"nodes", e.nodes},
            {"peak", e.peak},
            {"local", e.local},
            {"l2", e.l2},
            {"median_local", e.median_local},
            {"digits", e.digits()}};
}

ordered_json coefficient_json(const comparison::ExactContact& exact, contact::Edge edge,
                              std::size_t k, const std::optional<comparison::EdgeFit>& fit) {
    std::optional<double> data;
    std::optional<double> spread;
    std::optional<double> of_exact;
    if (fit && !fit->own_edge) {
        of_exact = (k == 0 ? fit->c0 : fit->c1).of_exact;
    }
    if (fit) {
        data = (k == 0 ? fit->c0 : fit->c1).value;
        spread = (k == 0 ? fit->c0 : fit->c1).spread;
    }
    return {{"data", number_json(data)},
            {"spread", number_json(spread)},
            {"of_exact_pressure", number_json(of_exact)},
            {"exact", exact.c(edge, k).value}};
}

ordered_json causes_json(const std::optional<comparison::Diagnosis>& diagnosis) {
    ordered_json list = ordered_json::array();
    for (const comparison::Cause& cause :
         diagnosis ? diagnosis->causes : std::vector<comparison::Cause>{}) {
        list.push_back({{"name", cause.name},
                        {"what", cause.what},
                        {"factor", cause.factor},
                        {"scatter", cause.scatter},
                        {"equally_likely", cause.equally_likely}});
    }
    return list;
}

ordered_json file_json(const ComparisonReport& report, const comparison::FileComparison& file) {
    const comparison::ExactContact& exact = *report.exact;
    const auto held = [](const std::optional<double>& data, const std::optional<double>& of_exact,
                         double value) {
        return ordered_json{{"data", number_json(data)},
                            {"of_exact_pressure", number_json(of_exact)},
                            {"exact", value}};
    };
    ordered_json j;
    j["file"] = printable(file.table.file);
    j["passes"] = file.passes();
    j["nodes"] = file.data.nodes.size();
    j["inside"] = file.inside;
    j["outside"] = file.outside;
    j["sign"] = file.data.sign < 0 ? -1 : 1;
    j["origin"] = file.data.origin;
    j["origin_found"] = file.data.origin_found;
    j["half"] = file.data.half ? ordered_json(scene::edge_name(*file.data.half)) : ordered_json();
    j["findings"] = ordered_json::array();
    for (const std::string& finding : file.findings()) {
        j["findings"].push_back(printable(finding));
    }
    j["a"] = held(file.contact.a, file.of_exact.a, exact.a().value);
    j["b"] = held(file.contact.b, file.of_exact.b, exact.b().value);
    j["P"] = held(file.contact.force, file.of_exact.force, exact.force().value);
    j["p_max"] = {
        {"data", file.contact.largest},
        {"exact", exact.scale().mean ? ordered_json() : ordered_json(exact.scale().value)}};
    for (const std::size_t k : {0U, 1U}) {
        const std::string name = "c" + std::to_string(k);
        for (const contact::Edge edge : {contact::Edge::right, contact::Edge::left}) {
            j[name + (edge == contact::Edge::right ? "" : "_left")] =
                coefficient_json(exact, edge, k, file.fits[index_of(edge)]);
        }
    }
    if (file.Q) {
        j["Q"] = {{"data", number_json(file.Q)},
                  {"of_exact_traction", number_json(file.Q_of_exact)},
                  {"exact", exact.shear()->force()}};
        j["shear_sign"] = file.data.shear_sign < 0 ? -1 : 1;
        j["shear_scale"] = exact.shear()->scale();
    }
    if (file.shear) {
        j["errors_of_q"] = errors_json(*file.shear);
    }
    j["element"] = {{"right", file.contact.element[0]},
                    {"left", file.contact.element[1]},
                    {"mean", file.contact.mean_element}};
    j["errors"] = errors_json(file.errors);
    j["errors_of_all_nodes"] = errors_json(file.all);
    j["distances"] = ordered_json::array();
    for (const comparison::DistanceErrors& d : file.distances) {
        ordered_json row = errors_json(d.errors);
        row["edge"] = scene::edge_name(d.edge);
        row["from"] = d.from;
        row["to"] = d.to;
        j["distances"].push_back(std::move(row));
    }
    j["knots"] = ordered_json::array();
    for (const comparison::KnotErrors& k : file.knots) {
        ordered_json row = errors_json(k.errors);
        row["x"] = k.knot.x;
        row["corner"] = k.knot.corner;
        j["knots"].push_back(std::move(row));
    }
    j["causes"] = causes_json(file.diagnosis);
    if (file.diagnosis && file.diagnosis->factor) {
        j["common_factor"] = {{"value", file.diagnosis->factor->value},
                              {"error", file.diagnosis->factor->error}};
    }
    if (file.shear) {
        j["causes_of_q"] = causes_json(file.shear_diagnosis);
    }
    j["failures"] = ordered_json::array();
    for (const std::string& failure : file.failures) {
        j["failures"].push_back(printable(failure));
    }
    return j;
}

} // namespace

std::string comparison_json(const ComparisonReport& report) {
    const comparison::Comparison& c = report.comparison;
    ordered_json j;
    j["scene"] = printable(report.scene);
    j["passes"] = c.passes();
    j["tolerance"] = tolerance_text(c.tolerances);
    j["units"] = report.units ? ordered_json(report.units->text()) : ordered_json();
    j["routes"] = {{"a", report.exact->a().route},
                   {"b", report.exact->b().route},
                   {"P", report.exact->force().route},
                   {"c0", report.exact->c(contact::Edge::right, 0).route},
                   {"p", "batch (estimate)"}};
    j["files"] = ordered_json::array();
    for (const comparison::FileComparison& file : c.files) {
        j["files"].push_back(file_json(report, file));
    }
    j["orders"] = ordered_json::object();
    j["limits"] = ordered_json::object();
    for (const comparison::Convergence& one : c.convergence) {
        j["orders"][one.quantity] = number_json(one.order);
        if (one.exact != 0) {
            j["limits"][one.quantity] = {
                {"own_order", number_json(one.own_order)},
                {"value", number_json(one.extrapolated)},
                {"error", one.extrapolated ? number_json(one.extrapolation_error) : ordered_json()},
                {"exact", one.exact},
                {"trusted", one.trusted},
                {"why_not", one.why_not},
                {"agrees", one.agrees ? ordered_json(*one.agrees) : ordered_json()}};
        }
    }
    return j.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

} // namespace edgeproof::report
