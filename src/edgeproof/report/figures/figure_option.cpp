// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/figures/figure_option.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/report/text/percent.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace edgeproof::report {
namespace {

constexpr double digits_of_a_double = 17;

/// An exact value is shown with no more digits than were written.
double shown(const conformance::Answer& answer, double digits) {
    const auto written = std::count_if(answer.text.begin(), answer.text.end(), [](char c) {
        return std::isdigit(static_cast<unsigned char>(c)) != 0;
    });
    return std::min(digits, std::max(digits_of_a_double, static_cast<double>(written)));
}

} // namespace

Plot agreement_plot(const Conformance& c) {
    const PrecisionScope scope(figure_digits + 10);
    const bool shear =
        std::ranges::any_of(c.answers.questions.list, [](const conformance::Question& q) {
            return q.quantity == scene::Quantity::q;
        });
    Plot plot;
    plot.id = "agreement";
    plot.title = "Digits right";
    plot.description = "Digits right of each answer against the distance u from the edge, compared "
                       "with those that remain after rounding the inputs to binary64";
    plot.x = {"distance u from the edge", true};
    plot.y = {"digits right"};
    plot.columns = {"u", "p", "q", "inputs"};
    plot.curves.push_back(
        {"inputs", "left by the rounding of the inputs", {Pen::Colour::sky_blue, 0, 1, 2}});
    plot.curves.push_back({"p", "p", {Pen::Colour::vermilion, 0, 7, 1}});
    if (shear) {
        plot.curves.push_back({"q", "q", {Pen::Colour::green, 0, 9, 1}});
    }
    for (std::size_t i = 0; i < c.agreements.cases.size(); ++i) {
        const conformance::Question& q = c.answers.questions.list[i];
        const conformance::CaseAgreement& held = c.agreements.cases[i];
        const bool drawn = q.quantity == scene::Quantity::p || q.quantity == scene::Quantity::q;
        if (!drawn || !held.no_reference.empty() ||
            c.answers.given[i].state != conformance::Answer::State::number) {
            continue;
        }
        auto& row = plot.add_row(q.u->to<Real>());
        row[q.quantity == scene::Quantity::p ? 1 : 2] =
            Real(shown(c.answers.given[i], held.digits));
        if (held.conditioning && held.conditioning->moved > 0) {
            row[3] = Real(std::max(0.0, -std::log10(held.conditioning->moved)));
        }
    }
    if (plot.rows.empty()) {
        throw InputError("no answer is at a point, so that there is nothing to draw",
                         "ask for p or q, or leave "
                         "--figure out");
    }
    plot.sort_rows();
    return plot;
}

namespace {

/// A step between neighbours of more than this share of the highest reach is drawn as a gap in the
/// line (run_design.cpp adds points where the curve is only steep).
constexpr double share_of_a_jump = 0.02;
constexpr unsigned digits_of_a_mark = 6;

} // namespace

Plot design_plot(const scene::DesignScene& design, const scene::DesignResult& result) {
    const PrecisionScope scope(figure_digits + 10);
    const std::string& name = design.parameter;
    const bool measure = design.objective == scene::DesignObjective::measure;
    const std::string reach = measure ? "measure" : "reach";
    Plot plot;
    plot.id = "design";
    plot.title = design.title.empty() ? "Reach of the approximation" : design.title;
    plot.description = "The " + reach + " of " + std::to_string(design.terms) +
                       " term(s) against " + name + ", its best value marked";
    plot.x = {name};
    plot.y = {reach + (design.unit == contact::ReachUnit::fraction ? ", fraction of a + b"
                                                                   : ", distance from the edge")};
    plot.columns = {name, "reach", "best", "printed"};
    plot.curves.push_back(
        {"reach", "within " + in_percent(design.tolerance), {Pen::Colour::blue, 1}});
    const auto mark = [](const Ball& x) { return to_decimal(x.midpoint(), digits_of_a_mark); };
    plot.curves.push_back({"best",
                           "best: " + name + " = " + mark(result.best.value),
                           {Pen::Colour::vermilion, 0, 7, 1}});
    double highest = 0;
    for (const auto& [x, y] : result.curve) {
        highest = std::isnan(y) ? highest : std::max(highest, y);
    }
    std::optional<double> before;
    for (const auto& [x, y] : result.curve) {
        if (before && (std::isnan(y) || std::fabs(y - *before) > share_of_a_jump * highest)) {
            plot.add_row(Real(x));
        }
        before = std::isnan(y) ? std::nullopt : std::optional(y);
        auto& row = plot.add_row(Real(x));
        row[1] = before ? std::optional(Real(y)) : std::nullopt;
    }
    plot.add_row(result.best.value.midpoint())[2] = result.best.reach.midpoint();
    if (result.printed_reach) {
        const Rational& printed = *design.printed;
        plot.add_row(from_rational<Real>(printed))[3] = result.printed_reach->midpoint();
        plot.curves.push_back({"printed",
                               "printed: " + name + " = " + exact_text(printed),
                               {Pen::Colour::black, 0, 9, 1}});
    }
    return plot;
}

} // namespace edgeproof::report
