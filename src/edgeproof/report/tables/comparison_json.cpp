// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/tables/comparison_report.hpp"

#include "edgeproof/precision/message.hpp"
#include "edgeproof/report/text/program_line.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <initializer_list>
#include <map>
#include <utility>

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

template <class List, class One> ordered_json list_json(const List& list, const One& one) {
    ordered_json all = ordered_json::array();
    for (const auto& item : list) {
        all.push_back(one(item));
    }
    return all;
}

ordered_json causes_json(const std::optional<comparison::Diagnosis>& diagnosis) {
    return list_json(diagnosis ? diagnosis->causes : std::vector<comparison::Cause>{},
                     [](const comparison::Cause& cause) {
                         return ordered_json{{"name", cause.name},
                                             {"what", cause.what},
                                             {"factor", cause.factor},
                                             {"scatter", cause.scatter},
                                             {"equally_likely", cause.equally_likely}};
                     });
}

ordered_json file_json(const ComparisonReport& report, const comparison::FileComparison& file) {
    const comparison::ExactContact& exact = *report.exact;
    std::map<std::string, comparison::ComparedQuantity> compared;
    for (comparison::ComparedQuantity& q : compared_quantities(file, exact)) {
        compared.emplace(q.name, std::move(q));
    }
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
    j["findings"] = list_json(file.findings(), printable);
    for (const char* name : {"a", "b", "P"}) {
        const comparison::ComparedQuantity& q = compared.at(name);
        j[name] = {{"data", number_json(q.data)},
                   {"of_exact_pressure", number_json(q.of_exact)},
                   {"exact", q.exact}};
    }
    j["p_max"] = {
        {"data", file.contact.largest},
        {"exact", exact.scale().mean ? ordered_json() : ordered_json(exact.scale().value)}};
    using Names = std::initializer_list<std::pair<const char*, const char*>>;
    for (const auto& [key, name] :
         Names{{"c0", "c_0"}, {"c0_left", "c_0 left"}, {"c1", "c_1"}, {"c1_left", "c_1 left"}}) {
        const comparison::ComparedQuantity& q = compared.at(name);
        j[key] = {{"data", number_json(q.data)},
                  {"spread", number_json(q.data ? std::optional(q.spread) : std::nullopt)},
                  {"of_exact_pressure", number_json(q.of_exact)},
                  {"exact", q.exact}};
    }
    if (file.Q) {
        j["Q"] = {{"data", number_json(file.Q)},
                  {"of_exact_traction", number_json(file.Q_of_exact)},
                  {"exact", exact.shear()->force}};
        j["shear_sign"] = file.data.shear_sign < 0 ? -1 : 1;
        j["shear_scale"] = exact.shear()->scale;
    }
    if (file.shear) {
        j["errors_of_q"] = errors_json(*file.shear);
    }
    for (const comparison::SurfaceErrors& e : file.surface) {
        j["errors_of_" + e.name] = {{"nodes", e.nodes}, {"peak", e.peak},
                                    {"scale", e.scale}, {"x", file.data.nodes[e.worst].x},
                                    {"data", e.data},   {"exact", e.exact},
                                    {"route", e.route}};
    }
    j["element"] = {{"right", file.contact.element[0]},
                    {"left", file.contact.element[1]},
                    {"mean", file.contact.mean_element}};
    j["errors"] = errors_json(file.errors);
    j["errors_of_all_nodes"] = errors_json(file.all);
    j["distances"] = list_json(file.distances, [](const comparison::DistanceErrors& d) {
        ordered_json row = errors_json(d.errors);
        row.update({{"edge", scene::edge_name(d.edge)}, {"from", d.from}, {"to", d.to}});
        return row;
    });
    j["knots"] = list_json(file.knots, [](const comparison::KnotErrors& k) {
        ordered_json row = errors_json(k.errors);
        row.update({{"x", k.knot.x}, {"corner", k.knot.corner}});
        return row;
    });
    j["causes"] = causes_json(file.diagnosis);
    if (file.diagnosis && file.diagnosis->factor) {
        j[file.diagnosis->factor->of_x ? "common_factor_of_x" : "common_factor"] = {
            {"value", file.diagnosis->factor->value}, {"error", file.diagnosis->factor->error}};
    }
    if (file.shear) {
        j["causes_of_q"] = causes_json(file.shear_diagnosis);
    }
    j["failures"] = list_json(file.failures, printable);
    return j;
}

} // namespace

std::string comparison_json(const ComparisonReport& report) {
    const comparison::Comparison& c = report.comparison;
    ordered_json j;
    j["scene"] = printable(report.scene);
    j["program"] = program_line();
    j["passes"] = c.passes();
    j["tolerance"] = tolerance_text(c.tolerances);
    j["units"] = report.units ? ordered_json(report.units->text()) : ordered_json();
    j["routes"] = {{"a", report.exact->a().route},
                   {"b", report.exact->b().route},
                   {"P", report.exact->force().route},
                   {"c0", report.exact->c(contact::Edge::right, 0).route},
                   {"p", report.exact->pressure_route()}};
    j["files"] = list_json(
        c.files, [&](const comparison::FileComparison& file) { return file_json(report, file); });
    j["orders"] = ordered_json::object();
    for (const comparison::Convergence& one : c.convergence) {
        j["orders"][one.quantity] = number_json(one.order);
    }
    return j.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

} // namespace edgeproof::report
