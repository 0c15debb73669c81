// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"
#include "edgeproof/certificate/theory/theory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <tuple>

namespace edgeproof::certificate {

void Statement::need(const Fact& fact, const std::string& what) {
    if (fact.statement.empty()) {
        throw NotStated(fmt::format("the Coq files have nothing about {}", what));
    }
    const auto same = [&](const Fact& f) { return f.statement == fact.statement; };
    if (std::ranges::none_of(facts_, same)) {
        facts_.push_back(fact);
    }
}

std::string Statement::integral(const Expr& e, CoqNames names) {
    const std::string written = to_text(e);
    for (const auto& [lemma, is, proof] : theory_.integrals) {
        if (lemma == written) {
            const std::string& variable = e.arg(1).name();
            std::string ends =
                fmt::format("({}) ({})", coq_text(e.arg(2), names), coq_text(e.arg(3), names));
            if (e.kind() == Expr::Kind::pv) {
                ends += fmt::format(" ({})", coq_text(e.arg(4), names)); // the pole
            }
            names.insert_or_assign(variable, variable);
            const auto traction = [&](const Expr& part) {
                const bool is_q = part.kind() == Expr::Kind::call && part.name() == "q";
                if (!is_q || theory_.traction.empty()) {
                    throw NotStated(fmt::format("{} is not stated in Coq", to_text(part)));
                }
                return fmt::format("({} {})", theory_.traction, coq_text(part.arg(0), names));
            };
            need({{"l0"},
                  fmt::format("{} (fun {} => {}) {} l0", is, variable,
                              coq_text(e.arg(0), names, traction), ends),
                  proof},
                 "the integral");
            return "l0";
        }
    }
    throw NotStated(fmt::format("there is no lemma for {}", written));
}

std::string Statement::call(const Expr& e, const CoqNames& names) {
    if (e.kind() == Expr::Kind::integral || e.kind() == Expr::Kind::pv) {
        return integral(e, names);
    }
    if (e.kind() == Expr::Kind::call && e.name() == "p" && e.arg(0) == Expr::symbol("x")) {
        need(theory_.pressure, "the pressure");
        return theory_.pressure.unknowns.at(0);
    }
    if (e.kind() == Expr::Kind::call && e.name() == "right_local" &&
        e.arg(1) == Expr::symbol("x")) {
        return local_sum(e);
    }
    throw NotStated(fmt::format("{} is not stated in Coq", to_text(e)));
}

std::string Statement::local_sum(const Expr& e) {
    const Rational* const terms = e.arg(0).rational();
    if (terms == nullptr || *terms < 1 || *terms > 3) {
        throw NotStated(fmt::format("the number of terms of {} is not 1, 2 or 3", to_text(e)));
    }
    need(theory_.right, "the right edge");
    std::string sum;
    for (std::size_t k = 0; Rational(k) < *terms; ++k) {
        sum += fmt::format("{}{} * ((a - x) ^ {} * sqrt (a - x))", k == 0 ? "" : " + ",
                           theory_.right.unknowns.at(k), k);
    }
    return "(" + sum + ")";
}

std::string Statement::operator()(const Expr& e) {
    CoqNames names = theory_.names;
    const std::array<std::tuple<std::string_view, const Fact*, std::string_view>, 4> series{
        {{"right_c", &theory_.right, "the right edge"},
         {"left_c", &theory_.left, "the left edge"},
         {"right_s", &theory_.right_shear, "shear at the right edge"},
         {"left_s", &theory_.left_shear, "shear at the left edge"}}};
    for (const std::string& name : free_symbols(e)) {
        for (const auto& [prefix, fact, what] : series) {
            for (std::size_t k = 0; k < 3; ++k) {
                if (name == fmt::format("{}{}", prefix, k)) {
                    need(*fact, std::string(what));
                    names.insert_or_assign(name, fact->unknowns.at(k));
                }
            }
        }
        if (name == "b" && !theory_.left_position.statement.empty()) {
            need(theory_.left_position, "the left edge");
        }
        if (name == "P") {
            need(theory_.load, "the load");
            names.insert_or_assign(name, theory_.load.unknowns.at(0));
        }
    }
    return coq_text(e, names, [&](const Expr& part) { return call(part, names); });
}

std::string Statement::text(const std::string& conclusion) const {
    if (facts_.empty() && !theory_.assumes_contact) {
        throw NotStated("the formulas contain no quantity that the mechanics defines");
    }
    std::string unknowns;
    std::string all;
    for (const Fact& fact : facts_) {
        for (const std::string& unknown : fact.unknowns) {
            unknowns += " " + unknown;
        }
        all += "  " + fact.statement + " /\\\n";
    }
    const std::string begin =
        unknowns.empty() ? (all.empty() ? "" : "\n") : "exists" + unknowns + ",\n";
    return begin + all + (all.empty() ? "" : "  ") + conclusion;
}

std::string Statement::proof(const std::string& last) const {
    std::string text;
    for (const Fact& fact : facts_) {
        for (std::size_t i = 0; i < fact.unknowns.size(); ++i) {
            text += "eexists. ";
        }
    }
    if (!text.empty()) {
        text = "  " + text + "\n";
    }
    for (const Fact& fact : facts_) {
        text += "  split. { " + fact.proof + ". }\n";
    }
    return text + "  " + last + ".\n";
}

namespace {

// The precision of the enclosures from which the stated numbers are chosen.
constexpr unsigned digits_of_enclosures = 25;

} // namespace

std::optional<Gap> gap_at(const Expr& first, const Expr& second, const Sample& sample) {
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

std::optional<double> excess(const Expr& first, const Sample& at, const Expr& second,
                             const Sample& other) {
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
    return text + fmt::format("Ltac constants := {}.\n"
                              "Ltac positive := constants; repeat split; lra.\n\n",
                              names.empty() ? "idtac" : fmt::format("unfold {} in *", names));
}

std::string theorem_text(const std::string& name, const std::string& statement,
                         const std::string& proof) {
    return fmt::format("Theorem {} : {}.\nProof.\n{}Qed.\n\n", name, statement, proof);
}

} // namespace edgeproof::certificate
