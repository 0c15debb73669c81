// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/theory/sampled_statement.hpp"

#include "edgeproof/audit/enclosure/enclosed_sample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace edgeproof::certificate {
namespace {

// The precision of the enclosures from which the stated numbers are chosen.
constexpr unsigned digits_of_enclosures = 25;

} // namespace

std::optional<Gap> gap_at(const formula::Expr& first, const formula::Expr& second,
                          const audit::Sample& sample) {
    const auto x = audit::enclosed(first, sample, digits_of_enclosures);
    const auto y = audit::enclosed(second, sample, digits_of_enclosures);
    if (!x.ball || !y.ball) {
        return std::nullopt;
    }
    const Ball difference = abs(*x.ball - *y.ball);
    const double size = std::max(std::abs(static_cast<double>(x.ball->midpoint())),
                                 std::abs(static_cast<double>(y.ball->midpoint())));
    const auto least = static_cast<double>(difference.lower());
    return Gap{least, size > 0 ? least / size : 0};
}

std::optional<double> excess(const formula::Expr& first, const audit::Sample& at,
                             const formula::Expr& second, const audit::Sample& other) {
    const auto x = audit::enclosed(first, at, digits_of_enclosures);
    const auto y = audit::enclosed(second, other, digits_of_enclosures);
    if (!x.ball || !y.ball) {
        return std::nullopt;
    }
    const auto least = static_cast<double>((*x.ball - *y.ball).lower());
    return least > 0 ? std::optional(least) : std::nullopt;
}

std::string fraction_below(double gap) {
    const double lowered = gap * (1 - 1e-6);
    const int places = std::max(0, 2 - static_cast<int>(std::floor(std::log10(lowered))));
    const double count = std::floor(lowered * std::pow(10.0, places));
    return places == 0 ? fmt::format("{:.0f}", count)
                       : fmt::format("{:.0f} / 10 ^ {}", count, places);
}

std::string constants(const std::vector<Constant>& all) {
    std::string text;
    std::string names;
    for (const Constant& c : all) {
        text += fmt::format("Definition {} : {} := {}.\n", c.name, c.type, c.value);
        // A definition that uses others is unfolded before them.
        names = names.empty() ? c.name : c.name + ", " + names;
    }
    return text + fmt::format("Ltac constants := unfold {} in *.\n"
                              "Ltac positive := constants; repeat split; lra.\n\n",
                              names);
}

std::string assumptions(const std::vector<std::string>& theorems) {
    std::string all;
    for (const std::string& name : theorems) {
        all += (all.empty() ? "" : ", ") + name;
    }
    return fmt::format("Definition all_theorems := ({}).\nPrint Assumptions all_theorems.\n", all);
}

std::string bare_theorem(const std::string& name, const std::string& statement,
                         const std::string& proof) {
    return fmt::format("Theorem {} : {}.\nProof.\n{}Qed.\n", name, statement, proof);
}

std::string theorem_text(const std::string& name, const std::string& statement,
                         const std::string& proof) {
    return bare_theorem(name, statement, proof) + fmt::format("Print Assumptions {}.\n\n", name);
}

} // namespace edgeproof::certificate
