// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/figures/agreement_figure.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/report/figures/figures_gnuplot.hpp"

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
    bool shear = false;
    for (const conformance::Question& q : c.answers.questions.list) {
        shear = shear || q.quantity == scene::Quantity::q;
    }
    Plot plot;
    plot.id = "agreement";
    plot.title = "Digits right";
    plot.description = "Digits right of each answer against the distance u from the edge, compared "
                       "with those that remain after rounding the inputs to binary64";
    plot.x = {"distance u from the edge", true, {}};
    plot.y = {"digits right", false, {}};
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
        std::vector<std::optional<Real>> row(4);
        row[0] = q.u->to<Real>();
        row[q.quantity == scene::Quantity::p ? 1 : 2] =
            Real(shown(c.answers.given[i], held.digits));
        if (held.conditioning && held.conditioning->moved > 0) {
            row[3] = Real(std::max(0.0, -std::log10(held.conditioning->moved)));
        }
        plot.rows.push_back(std::move(row));
    }
    std::stable_sort(plot.rows.begin(), plot.rows.end(),
                     [](const auto& x, const auto& y) { return *x[0] < *y[0]; });
    return plot;
}

void write_agreement_figure(const Conformance& result, const std::filesystem::path& file) {
    const PrecisionScope scope(figure_digits + 10);
    const Plot plot = agreement_plot(result);
    if (plot.rows.empty()) {
        throw InputError("no answer is at a point, so that there is nothing to draw",
                         "ask for p or q, or leave "
                         "--figure out");
    }
    write_figure(plot, file);
}

} // namespace edgeproof::report
