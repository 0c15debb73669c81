// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/commands/bounds_tables.hpp"

#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace edgeproof::cli {
namespace {

using Kind = report::Column::Kind;

std::string capped(unsigned digits) {
    return digits >= most_digits_right ? "exact" : std::to_string(digits);
}

using Counts = std::vector<std::pair<const char*, std::size_t validation::CountCell::*>>;

/// Adds two columns that name a cell, and one for each of the counts; a row for each cell with
/// values, or for all cells if the kind has them all; and a row for the total.
void add_counts(report::Table& t, const validation::CountKind& kind,
                const std::array<const char*, 2>& names, const Counts& counts,
                const validation::CountCells& cells, const validation::CountCell& total) {
    t.columns = {{names[0], Kind::text}, {names[1], Kind::text}};
    for (const auto& [name, member] : counts) {
        t.columns.push_back({name, Kind::count});
    }
    const auto add = [&](std::string_view row, std::string_view column,
                         const validation::CountCell& c) {
        t.rows.push_back({std::string(row), std::string(column)});
        for (const auto& [name, member] : counts) {
            t.rows.back().push_back(std::to_string(c.*member));
        }
    };
    for (const auto& [number, c] : cells) {
        if (c.values > 0 || kind.all_cells) {
            add(kind.rows.at(number / kind.columns.size()),
                kind.columns.at(number % kind.columns.size()), c);
        }
    }
    add("all", "all", total);
}

} // namespace

report::Table case_table(const std::vector<validation::HardCase>& cases,
                         const std::vector<validation::CaseOutcome>& outcomes, unsigned digits,
                         bool brief) {
    report::Table t;
    t.title = "Hard cases at " + std::to_string(digits) + " digits";
    t.notes = {"double ... MPFR 50: digits right of the textbook formula in that arithmetic",
               "proved: digits of the enclosure; route_1, route_2: digits in which two routes in "
               "Real agree with it, as far as it goes",
               "fault: empty where the enclosure determines every digit and both routes agree"};
    t.columns = {{"case", Kind::text}, {"class", Kind::text}, {"quantity", Kind::text}};
    if (!brief) {
        t.columns.insert(t.columns.end(), {{"value"}, {"bound"}});
    }
    for (const std::string_view name : validation::plain_arithmetics) {
        t.columns.push_back({std::string(name), Kind::count});
    }
    t.columns.insert(t.columns.end(), {{"proved"}, {"route_1"}, {"route_2"}});
    if (!brief) {
        t.columns.push_back({"fault", Kind::text});
    }
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const validation::CaseOutcome& o = outcomes[i];
        std::vector<std::string> row{cases[i].name, cases[i].family, text_of(cases[i].asked)};
        if (!brief) {
            row.insert(row.end(), {o.value, o.bound});
        }
        for (const unsigned d : o.plain) {
            row.push_back(std::to_string(d));
        }
        row.push_back(o.proved ? capped(o.digits) : "");
        for (std::size_t k = 0; k < 2; ++k) {
            row.push_back(k < o.second_routes.size() ? capped(o.second_routes[k].digits) : "");
        }
        if (!brief) {
            row.push_back(o.fault);
        }
        t.rows.push_back(std::move(row));
    }
    return t;
}

report::Table family_table(const std::vector<validation::HardCase>& cases,
                           const std::vector<validation::CaseOutcome>& outcomes, unsigned digits) {
    report::Table t;
    t.title = "Hard cases, class by class, at " + std::to_string(digits) + " digits";
    t.notes = {"digits right of the textbook formula in each arithmetic, and of ours as proved: "
               "worst / median of the class",
               "agree: cases in which the enclosure determines every digit and two routes in Real "
               "have them too"};
    t.columns = {{"class", Kind::text}, {"cases", Kind::count}, {"agree", Kind::count}};
    for (const std::string_view name : validation::plain_arithmetics) {
        t.columns.push_back({std::string(name), Kind::number});
    }
    t.columns.push_back({"ours", Kind::number});
    for (const validation::FamilySummary& s : summary(cases, outcomes)) {
        std::vector<std::string> row{s.family, std::to_string(s.cases), std::to_string(s.agree)};
        for (std::size_t j = 0; j < s.worst.size(); ++j) {
            row.push_back(std::to_string(s.worst[j]) + " / " + std::to_string(s.median[j]));
        }
        row.push_back(capped(s.worst_proved) + " / " + capped(s.median_proved));
        t.rows.push_back(std::move(row));
    }
    return t;
}

report::Table count_table(const validation::CountOptions& options,
                          const validation::CountResult<validation::CountFinding>& result) {
    using Cell = validation::CountCell;
    report::Table t;
    t.title = std::to_string(result.total.values) + " values at " + std::to_string(options.digits) +
              " digits, seed " + std::to_string(options.seed);
    t.notes = {
        "excluded: the enclosure leaves out the value that the routes in Real give at twice "
        "the digits",
        "wrong: a printed digit is not that of a second enclosure at twice the digits, or of "
        "the value in Real",
        "wide: the enclosure is wider than 10 units of the last digit asked",
        "undecided: no enclosure, or no second value, within the budgets"};
    add_counts(t, validation::enclosure_count(), {"profile", "regime"},
               {{"values", &Cell::values},
                {"excluded", &Cell::excluded},
                {"wrong", &Cell::wrong},
                {"wide", &Cell::wide},
                {"undecided", &Cell::undecided}},
               result.cells, result.total);
    return t;
}

report::Table binary64_table(const validation::CountResult<std::string>& count) {
    using Cell = validation::CountCell;
    report::Table t;
    t.title = "Values in double words, in " + std::to_string(count.contacts) + " contacts";
    t.notes = {"undecided: left to balls, as the rounding is open",
               "wrong: not the binary64 that an enclosure of 320 bits or more rounds to"};
    add_counts(
        t, validation::binary64_count(), {"value", "place"},
        {{"values", &Cell::values}, {"undecided", &Cell::undecided}, {"wrong", &Cell::wrong}},
        count.cells, count.total);
    return t;
}

report::Table honesty_table(const std::vector<validation::HonestyRow>& rows, unsigned digits) {
    report::Table t;
    t.title = "Claimed error against true error, at " + std::to_string(digits) + " digits";
    t.notes = {
        "none: no value, and none is claimed; understated: the true error is larger than claimed",
        "worst ratio: log10 of the largest true/claimed error; below 0 the claim holds",
        "claimed, right: digits of that value, as claimed and as they are; lost: the "
        "difference"};
    t.columns = {{"route", Kind::text},         {"profile", Kind::text},
                 {"regime", Kind::text},        {"points", Kind::count},
                 {"none", Kind::count},         {"understated", Kind::count},
                 {"worst ratio", Kind::number}, {"claimed", Kind::number},
                 {"right", Kind::number},       {"lost", Kind::number}};
    for (const validation::HonestyRow& r : rows) {
        std::vector<std::string> row{r.route,
                                     r.profile,
                                     r.regime,
                                     std::to_string(r.points),
                                     std::to_string(r.none),
                                     std::to_string(r.understated)};
        if (r.none < r.points) {
            const bool all = r.least_claimed >= most_digits_right && r.least_right == 0;
            const unsigned lost =
                r.least_claimed > r.least_right ? r.least_claimed - r.least_right : 0;
            const long tenths = std::lround(10 * r.worst_ratio);
            row.push_back(all ? "infinite"
                              : std::string(tenths < 0 ? "-" : "") +
                                    std::to_string(std::labs(tenths) / 10) + "." +
                                    std::to_string(std::labs(tenths) % 10));
            row.push_back(capped(r.least_claimed));
            row.push_back(capped(r.least_right));
            row.push_back(all ? "all" : std::to_string(lost));
        } else {
            row.insert(row.end(), 4, "");
        }
        t.rows.push_back(std::move(row));
    }
    return t;
}

std::string finding_text(const validation::CountFinding& f) {
    return std::string(f.failed ? "FAILED" : "undecided") + ": " + f.asked + " (contact " +
           std::to_string(f.contact) + ", value " + std::to_string(f.value) + "): " + f.what +
           "\n  printed " + f.text + "\n  second  " + f.second + "\n" + f.scene;
}

std::string aligned_text(const report::Table& table) {
    std::string text = table.title + "\n";
    for (const std::string& note : table.notes) {
        text += "  " + note + "\n";
    }
    return text + "\n" + report::aligned_lines(table, 0, true);
}

} // namespace edgeproof::cli
