// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/cost/cost_tables.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/report/text/program_line.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace edgeproof::report {
namespace {

using ColumnKind = Column::Kind;

std::string whole(double x) { return fmt::format("{:.0f}", x); }
/// Correct digits, rounded down: "50" only for at least 50.
std::string digits_text(double digits) { return whole(std::floor(digits)); }
std::string seconds_text(double seconds) { return fmt::format("{:.4g}", seconds); }

/// Adds the cells of the columns below to the first ones of a row.
std::vector<std::string> reading_row(std::vector<std::string> row, const cost::CostCell& c) {
    row.insert(row.end(), {std::to_string(c.digits), std::to_string(c.points.size())});
    if (c.failed() == c.points.size()) {
        row.insert(row.end(), {"none", "", "", "", "", "", "", ""});
        return row;
    }
    const cost::Quartiles right = c.right();
    const cost::Quartiles seconds = c.seconds();
    const auto evaluations = c.evaluations();
    row.insert(row.end(), {digits_text(right.least) + (c.failed() > 0 ? "*" : ""),
                           digits_text(right.median), evaluations ? whole(evaluations->median) : "",
                           evaluations ? whole(evaluations->most) : "", time_text(seconds.median),
                           time_text(seconds.low) + " - " + time_text(seconds.high),
                           time_text(seconds.most), fmt::format("{:.0f} %", 100 * c.spread())});
    return row;
}

void add_reading_columns(Table& t) {
    for (const char* name : {"digits", "points", "right", "median", "evaluations", "most",
                             "time a value", "middle half", "slowest", "repeats"}) {
        t.columns.push_back({name, ColumnKind::number});
    }
}

std::vector<std::string> reading_notes(const CostReport& report) {
    const bool failed = std::any_of(report.cells.begin(), report.cells.end(),
                                    [](const cost::CostCell& c) { return c.failed() > 0; });
    std::vector<std::string> notes{
        "digits: requested; right: digits that are right at the "
        "worst point, by an enclosure; median: at the median point",
        "evaluations of the integrand: median and most; times are the processor's: median over "
        "the points, their middle half, the slowest point",
        "repeats: how far repeats of one point lie apart (middle half over median)"};
    if (failed) {
        notes.emplace_back("*: some points have no value");
    }
    return notes;
}

Table table(std::string title, std::vector<Column> columns) {
    Table t;
    t.title = std::move(title);
    t.columns = std::move(columns);
    return t;
}

using Json = nlohmann::ordered_json;

template <class List, class One> Json list_of(const List& list, const One& one) {
    Json all = Json::array();
    for (const auto& item : list) {
        all.push_back(one(item));
    }
    return all;
}

Json json_of(const Table& t) {
    return list_of(t.rows, [&](const std::vector<std::string>& row) {
        Json one;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const bool number = t.columns[i].kind != ColumnKind::text;
            one[t.columns[i].name] = row[i].empty() ? Json(nullptr)
                                     : number       ? Json::parse(row[i])
                                                    : Json(row[i]);
        }
        return one;
    });
}

} // namespace

unsigned CostReport::usual_digits() const {
    const bool fifty = std::find(digits.begin(), digits.end(), 50U) != digits.end();
    return fifty || digits.empty() ? 50 : digits[digits.size() / 2];
}

const cost::CostCase& CostReport::case_named(const std::string& name) const {
    const auto found = std::ranges::find(cases, name, &cost::CostCase::name);
    if (found == cases.end()) {
        throw Error("no case is called " + name);
    }
    return *found;
}

std::string time_text(double seconds) {
    const auto three = [](double x, const char* unit) {
        return fmt::format("{:.{}f} {}", x, x < 10 ? 2 : x < 100 ? 1 : 0, unit);
    };
    return seconds < 0.9995e-3 ? three(1e6 * seconds, "us")
           : seconds < 0.9995  ? three(1e3 * seconds, "ms")
                               : three(seconds, "s");
}

Table cost_table(const CostReport& report, const std::string& scene) {
    Table t = table("What a value costs: " + scene,
                    {{"route", ColumnKind::text}, {"in", ColumnKind::text}});
    t.notes = reading_notes(report);
    add_reading_columns(t);
    for (const cost::CostCell& c : report.cells) {
        if (c.scene == scene) {
            t.rows.push_back(reading_row({c.route, c.arithmetic}, c));
        }
    }
    return t;
}

Table cost_table_at(const CostReport& report, unsigned digits) {
    Table t = table(
        "Other contacts, at " + std::to_string(digits) + " digits",
        {{"contact", ColumnKind::text}, {"route", ColumnKind::text}, {"in", ColumnKind::text}});
    add_reading_columns(t);
    std::string last;
    for (const cost::CostCell& c : report.cells) {
        if (c.scene == report.cases.front().name || c.digits != digits) {
            continue;
        }
        t.rows.push_back(reading_row({c.scene == last ? "" : c.scene, c.route, c.arithmetic}, c));
        last = c.scene;
    }
    return t;
}

Table growth_table(const CostReport& report) {
    Table t = table("Growth with the digits", {{"contact", ColumnKind::text},
                                               {"route", ColumnKind::text},
                                               {"in", ColumnKind::text},
                                               {"time ~ digits^", ColumnKind::number},
                                               {"evaluations ~ digits^", ColumnKind::number},
                                               {"ten digits more, at 50", ColumnKind::number}});
    t.notes = {"exponents by least squares in the logarithms, over all digits that were timed"};
    for (const cost::Growth& g : growths(report.cells)) {
        t.rows.push_back({g.scene, g.route, g.arithmetic, fmt::format("{:.2f}", g.time.exponent),
                          g.evaluations ? fmt::format("{:.2f}", g.evaluations->exponent) : "",
                          fmt::format("+{:.0f} %", 100 * (g.ten_more() - 1))});
    }
    return t;
}

Table bound_table(const CostReport& report) {
    Table t = table("What a proof costs", {{"contact", ColumnKind::text},
                                           {"digits", ColumnKind::count},
                                           {"fastest bare route", ColumnKind::text},
                                           {"bare", ColumnKind::number},
                                           {"enclosure", ColumnKind::number},
                                           {"ratio", ColumnKind::number},
                                           {"rounded", ColumnKind::number},
                                           {"ratio to bare", ColumnKind::number}});
    t.notes = {"bare: a value without a bound, by the fastest route in MPFR that has all its "
               "digits at every point; enclosure: the same value as a ball; rounded: enclosed, and "
               "correctly rounded to the digits requested"};
    for (const cost::BoundCost& b : bound_costs(report.cells)) {
        t.rows.push_back({b.scene, std::to_string(b.digits), b.bare, time_text(b.bare_seconds),
                          time_text(b.enclosure_seconds),
                          fmt::format("{:.2f}", b.enclosure_seconds / b.bare_seconds),
                          b.rounded_seconds > 0 ? time_text(b.rounded_seconds) : "",
                          b.rounded_seconds > 0
                              ? fmt::format("{:.2f}", b.rounded_seconds / b.bare_seconds)
                              : ""});
    }
    return t;
}

Table effect_table(const CostReport& report) {
    Table t = table("What an effect of a scene adds, at " + std::to_string(report.effect_digits()) +
                        " digits",
                    {{"effect", ColumnKind::text},
                     {"compared with", ColumnKind::text},
                     {"time", ColumnKind::number},
                     {"ratio", ColumnKind::number},
                     {"closed forms", ColumnKind::count},
                     {"solved", ColumnKind::count},
                     {"expansions", ColumnKind::count},
                     {"shear points", ColumnKind::count},
                     {"stresses", ColumnKind::count},
                     {"displacements", ColumnKind::count},
                     {"extents", ColumnKind::count}});
    t.notes = {"a scene of ten points as the commands run it, every value proved; solved: "
               "edges, loads and tilts"};
    for (const cost::EffectCost& e : report.effects) {
        const scene::Counts& c = e.work.counts;
        t.rows.push_back({e.effect, e.base, time_text(e.seconds),
                          e.base.empty() ? "" : fmt::format("{:.2f}", e.ratio),
                          std::to_string(c.closed_forms),
                          std::to_string(c.consistency + c.load_inversions + c.tilts),
                          std::to_string(c.expansions + c.shear_expansions),
                          std::to_string(c.shear_points), std::to_string(c.stresses),
                          std::to_string(c.displacements), std::to_string(c.extents)});
    }
    return t;
}

Table cost_cells(const CostReport& report) {
    Table t = table("Cost by route and digits", {{"contact", ColumnKind::text},
                                                 {"route", ColumnKind::text},
                                                 {"arithmetic", ColumnKind::text}});
    for (const char* name : {"digits", "points", "failed", "right_least", "right_median",
                             "evaluations_least", "evaluations_median", "evaluations_most",
                             "evaluations_total", "seconds_least", "seconds_low", "seconds_median",
                             "seconds_high", "seconds_most", "repeats_spread", "contact_seconds"}) {
        t.columns.push_back({name, ColumnKind::number});
    }
    for (const auto& [name, value] : report.machine) {
        t.facts.push_back({name, value});
    }
    t.notes = {"seconds of the processor a value; low, high: quartiles over the points; "
               "repeats_spread: of the repeats at one point, interquartile range over median; "
               "contact_seconds: once a contact; right: -log10 of the true relative error"};
    for (const cost::CostCell& c : report.cells) {
        const cost::Quartiles right = c.right();
        const cost::Quartiles s = c.seconds();
        const auto e = c.evaluations();
        t.rows.push_back({c.scene, c.route, c.arithmetic, std::to_string(c.digits),
                          std::to_string(c.points.size()), std::to_string(c.failed()),
                          fmt::format("{:.2f}", right.least), fmt::format("{:.2f}", right.median),
                          e ? whole(e->least) : "", e ? fmt::format("{:.1f}", e->median) : "",
                          e ? whole(e->most) : "", e ? std::to_string(c.total_evaluations()) : "",
                          seconds_text(s.least), seconds_text(s.low), seconds_text(s.median),
                          seconds_text(s.high), seconds_text(s.most),
                          fmt::format("{:.3f}", c.spread()), seconds_text(c.contact_seconds)});
    }
    return t;
}

Table cost_points(const CostReport& report) {
    Table t = table("Cost point by point", {{"contact", ColumnKind::text},
                                            {"route", ColumnKind::text},
                                            {"arithmetic", ColumnKind::text},
                                            {"digits", ColumnKind::number},
                                            {"u", ColumnKind::text},
                                            {"right", ColumnKind::number},
                                            {"evaluations", ColumnKind::number},
                                            {"seconds", ColumnKind::number},
                                            {"repeats_spread", ColumnKind::number},
                                            {"failure", ColumnKind::text}});
    for (const cost::CostCell& c : report.cells) {
        const cost::CostCase& which = report.case_named(c.scene);
        for (const cost::PointCost& p : c.points) {
            const bool good = p.failure.empty();
            t.rows.push_back({c.scene, c.route, c.arithmetic, std::to_string(c.digits),
                              which.u[p.point].text(), good ? fmt::format("{:.2f}", p.right) : "",
                              p.evaluations ? std::to_string(*p.evaluations) : "",
                              good ? seconds_text(p.seconds) : "",
                              good ? fmt::format("{:.3f}", p.spread) : "", p.failure});
        }
    }
    return t;
}

std::string cost_json(const CostReport& report) {
    Json json;
    json["program"] = program_line();
    for (const auto& [name, value] : report.machine) {
        json["machine"][name] = value;
    }
    json["cells"] = json_of(cost_cells(report));
    json["points"] = json_of(cost_points(report));
    json["growth"] = list_of(growths(report.cells), [](const cost::Growth& g) {
        return Json{{"contact", g.scene},
                    {"route", g.route},
                    {"arithmetic", g.arithmetic},
                    {"time_exponent", g.time.exponent},
                    {"evaluations_exponent",
                     g.evaluations ? Json(g.evaluations->exponent) : Json(nullptr)}};
    });
    json["bounds"] = list_of(bound_costs(report.cells), [](const cost::BoundCost& b) {
        return Json{{"contact", b.scene},
                    {"digits", b.digits},
                    {"bare_route", b.bare},
                    {"bare_seconds", b.bare_seconds},
                    {"enclosure_seconds", b.enclosure_seconds},
                    {"rounded_seconds", b.rounded_seconds}};
    });
    json["effects"] = list_of(report.effects, [](const cost::EffectCost& e) {
        return Json{
            {"effect", e.effect}, {"base", e.base}, {"seconds", e.seconds}, {"ratio", e.ratio}};
    });
    return json.dump(1) + "\n";
}

} // namespace edgeproof::report
