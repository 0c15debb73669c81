// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/sample/evaluated_scene_state.hpp"
#include "edgeproof/formula/exact/exact_ball.hpp"
#include "edgeproof/precision/error.hpp"

/// The quantities of partial slip in an EvaluatedScene.
namespace edgeproof::audit {

Real EvaluatedSceneState::of_slip(const std::function<Ball(const contact::ProvedSlip&)>& quantity) {
    if (slips.empty()) {
        require_partial_slip(spec);
    }
    const long needed = formula::bits_for(precision.integrand());
    std::optional<Ball> best;
    for (long bits = 2 * needed; bits <= 16 * needed; bits *= 2) {
        const auto [it, fresh] = slips.try_emplace(bits);
        try {
            if (fresh) {
                it->second = std::make_unique<contact::ProvedSlip>(spec.partial_slip(bits));
            }
            if (it->second == nullptr) {
                continue;
            }
            const Ball value = quantity(*it->second);
            if (!value.is_finite()) {
                continue;
            }
            best = value;
            if (value.relative_accuracy_bits() >= needed) {
                break;
            }
        } catch (const BudgetError&) {
            continue; // try again with more bits
        } catch (const DomainError&) {
            continue;
        }
    }
    if (!best) {
        throw BudgetError("balls of " + std::to_string(16 * needed) +
                          " bits do not enclose the partial slip");
    }
    return at_working_precision(best->midpoint());
}

Real EvaluatedSceneState::traction(const Place& at) {
    if (!spec.slips()) {
        return full_stick_traction(point_at(top().extent, at.edge, at.u), shear_load());
    }
    return of_slip([&](const contact::ProvedSlip& s) {
        return s.traction(at.edge, Ball(at.u, s.slip().zones().bits()));
    });
}

std::optional<Real> EvaluatedSceneState::slip_symbol(std::string_view name) {
    if (!spec.slips()) {
        return std::nullopt;
    }
    if (name == "right_d" || name == "left_d") {
        const contact::Edge edge = name == "right_d" ? contact::Edge::right : contact::Edge::left;
        return of_slip([edge](const contact::ProvedSlip& s) { return s.slip().size(edge); });
    }
    if (name == "stick_a" || name == "stick_b") {
        const contact::Edge edge = name == "stick_a" ? contact::Edge::right : contact::Edge::left;
        return of_slip([edge](const contact::ProvedSlip& s) { return s.slip().stick().at(edge); });
    }
    return std::nullopt;
}

} // namespace edgeproof::audit
