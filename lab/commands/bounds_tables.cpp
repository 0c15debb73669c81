// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/commands/bounds_tables.hpp"

#include "edgeproof/precision/rounding/digits_right.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace edgeproof::cli {
namespace {

using Kind = report::Column::Kind;

std::string capped(unsigned digits) {
    return digits >= most_digits_right ? "exact" : std::to_string(digits);
}

void add_plain_columns(std::vector<report::Column>& columns, const std::string& prefix) {
    for (const std::string_view name : validation::plain_arithmetics) {
        columns.push_back({prefix + std::string(name), Kind::count});
    }
}

std::vector<std::string> count_cells(const validation::CountCell& c) {
    return {std::to_string(c.values), std::to_string(c.excluded), std::to_string(c.wrong),
            std::to_string(c.wide), std::to_string(c.undecided)};
}

} // namespace

report::Table case_table(const std::vector<validation::HardCase>& cases,
                         const std::vector<validation::CaseOutcome>& outcomes, unsigned digits) {
    report::Table t;
    t.title = "Hard cases at " + std::to_string(digits) + " digits";
    t.notes = {"double ... MPFR 50: digits right of the textbook formula in that arithmetic",
               "proved: digits of the enclosure; route_1, route_2: digits in which two routes in "
               "Real agree with it, as far as it goes",
               "fault: empty where the enclosure determines every digit and both routes agree"};
    t.columns = {{"case", Kind::text},
                 {"class", Kind::text},
                 {"quantity", Kind::text},
                 {"value", Kind::number},
                 {"bound", Kind::number}};
    add_plain_columns(t.columns, "");
    for (const char* name : {"proved", "route_1", "route_2"}) {
        t.columns.push_back({name, Kind::number});
    }
    t.columns.push_back({"fault", Kind::text});
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const validation::CaseOutcome& o = outcomes[i];
        std::vector<std::string> row{cases[i].name, cases[i].family, text_of(cases[i].asked),
                                     o.value, o.bound};
        for (const unsigned d : o.plain) {
            row.push_back(std::to_string(d));
        }
        row.push_back(o.proved ? capped(o.digits) : "");
        for (std::size_t k = 0; k < 2; ++k) {
            row.push_back(k < o.second_routes.size() ? capped(o.second_routes[k].digits) : "");
        }
        row.push_back(o.fault);
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
                          const validation::CountResult& result) {
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
    t.columns = {{"profile", Kind::text},   {"regime", Kind::text}, {"values", Kind::count},
                 {"excluded", Kind::count}, {"wrong", Kind::count}, {"wide", Kind::count},
                 {"undecided", Kind::count}};
    const auto add = [&](std::string_view profile, std::string_view regime,
                         const validation::CountCell& c) {
        std::vector<std::string> row{std::string(profile), std::string(regime)};
        for (std::string& cell : count_cells(c)) {
            row.push_back(std::move(cell));
        }
        t.rows.push_back(std::move(row));
    };
    for (std::size_t p = 0; p < validation::sampled_profiles.size(); ++p) {
        for (std::size_t r = 0; r < validation::sampled_regimes.size(); ++r) {
            if (result.cells.at(p).at(r).values > 0) {
                add(validation::sampled_profiles.at(p), validation::sampled_regimes.at(r),
                    result.cells.at(p).at(r));
            }
        }
    }
    add("all", "all", result.total);
    return t;
}

report::Table binary64_table(const validation::Binary64Count& count) {
    report::Table t;
    t.title = "Values in double words, in " + std::to_string(count.contacts) + " contacts";
    t.notes = {"undecided: left to balls, as the rounding is open",
               "wrong: not the binary64 that an enclosure of 320 bits or more rounds to"};
    t.columns = {{"value", Kind::text},
                 {"place", Kind::text},
                 {"values", Kind::count},
                 {"undecided", Kind::count},
                 {"wrong", Kind::count}};
    const auto add = [&](std::string_view form, std::string_view place,
                         const validation::Binary64Cell& c) {
        t.rows.push_back({std::string(form), std::string(place), std::to_string(c.values),
                          std::to_string(c.undecided), std::to_string(c.wrong)});
    };
    for (std::size_t f = 0; f < validation::drawn_forms.size(); ++f) {
        for (std::size_t p = 0; p < validation::drawn_places.size(); ++p) {
            add(validation::drawn_forms.at(f), validation::drawn_places.at(p),
                count.cells.at(f).at(p));
        }
    }
    add("all", "all", count.total);
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
