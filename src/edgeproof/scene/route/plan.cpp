// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/scene/route/plan.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>

namespace edgeproof::scene {
namespace {

constexpr std::size_t most_slip_terms = 60; ///< the work grows as their fourth power

[[noreturn]] void reject(const Scene& scene, const std::string& problem,
                         const std::string& instead) {
    throw InputError(problem, instead)
        .at(scene.file, scene.ask_line != 0 ? scene.ask_line : scene.profile_line);
}

/// Refuses a request for which the scene lacks the data.
void check(const Scene& scene) {
    const Ask& ask = scene.ask;
    const auto for_each = [&](const auto& check_group) {
        for (const GroupRow& row : group_rows()) {
            if (ask.wants(row.group)) {
                check_group(row);
            }
        }
    };
    for_each([&](const GroupRow& row) {
        if (row.points && ask.u.empty()) {
            reject(scene, "the scene asks for no points",
                   "add u = [\"1e-3\", \"0.1\"] (distances from the edge) to [ask]");
        }
    });
    for_each([&](const GroupRow& row) {
        if (const auto lack = lack_of(scene, row)) {
            reject(scene, lack->problem, lack->instead);
        }
    });
    if (ask.wants(QuantityGroup::slip) && ask.most_terms() > most_slip_terms) {
        reject(scene, "slip zones of " + std::to_string(ask.most_terms()) + " terms are asked for",
               "give " + std::to_string(most_slip_terms) + " terms at most");
    }
    for_each([&](const GroupRow& row) {
        if ((row.terms && ask.terms.empty()) || (row.tolerance && !ask.tolerance)) {
            reject(scene, std::string(row.incomplete), std::string(row.instead));
        }
    });
}

/// Returns at least `bits`, such that with the guard bits of the elementary functions whole words
/// are used: one bit more would need another word.
long whole_words(long bits) {
    constexpr long word = 64;
    constexpr long guard = 24;
    return (bits + guard + word - 1) / word * word - guard;
}

} // namespace

Plan make_plan(const Scene& scene) {
    check(scene);
    const Ask& ask = scene.ask;
    Plan plan;
    const long bits = formula::bits_for(ask.digits.count);
    plan.bits = bits + 96;
    plan.narrow_bits = scene.closed() ? std::min(whole_words(bits + 40), plan.bits)
                                      : plan.bits; // an integral costs more than fewer bits save
    const bool shear = ask.wants(QuantityGroup::shear);
    plan.partial_slip =
        scene.slips() &&
        (shear || ask.wants(QuantityGroup::slip) || ask.wants(QuantityGroup::stress) ||
         ask.wants(QuantityGroup::displacement) || ask.wants(QuantityGroup::surface));
    plan.points = shear || ask.wants(QuantityGroup::pressure) ? ask.u.size() : 0;
    const bool coefficients = ask.wants(QuantityGroup::coefficients);
    const bool approximations = plan.points > 0 && !ask.terms.empty();
    plan.terms = coefficients || approximations ? ask.most_terms() : 0;
    // The expansions of q are those of full stick, or of p.
    plan.expand_shear = scene.shear && (!scene.round || scene.proportional()) && !scene.history &&
                        (coefficients || (approximations && shear && !plan.partial_slip));
    return plan;
}

bool peaks_in_the_middle(const Scene& scene) {
    if (!scene.profile || scene.profile->kind() != Profile::Kind::power_law) {
        return false;
    }
    const Exact& m = scene.profile->parameters().at("m");
    return m.sign() > 0 && Exact(m.expr() - Expr::number(Rational(1))).sign() <= 0;
}

void refuse_infinite_peak(const Real& x) {
    throw DomainError("there is no greatest pressure: it is infinite at the corner x = " +
                      x.str(8));
}

} // namespace edgeproof::scene
