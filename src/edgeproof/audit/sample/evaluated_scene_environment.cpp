// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/sample/evaluated_scene_environment.hpp"
#include "edgeproof/audit/sample/body_fields.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"

namespace edgeproof::audit {

Real EvaluatedSceneEnvironment::symbol(std::string_view name) const {
    if (const auto it = variables_.find(name); it != variables_.end()) {
        return at_working_precision(it->second);
    }
    const auto& parameters = state_.here().parameters;
    if (const auto it = parameters.find(name); it != parameters.end()) {
        return it->second;
    }
    if (name == "u" || name == "x") {
        if (place_ == nullptr) {
            throw Error("'" + std::string(name) + "' has no value: no place is given");
        }
        return at_working_precision(name == "u" ? place_->u : place_->x);
    }
    if (const auto value = state_.derived_symbol(name)) {
        return *value;
    }
    throw Error("'" + std::string(name) + "' has no value in a scene of family " +
                state_.spec.family);
}

std::vector<Real> EvaluatedSceneEnvironment::places(const Real& lo, const Real& hi) const {
    const contact::Extent<Real>& extent = state_.top().extent;
    std::vector<Real> all{Real(0), lo, hi, extent.a, extent.b};
    if (place_ != nullptr) {
        all.push_back(place_->x);
    }
    std::vector<Real> outside;
    for (const Real& p : all) {
        for (const Real& q : {p, Real(-p)}) {
            if (q < std::min(lo, hi) || q > std::max(lo, hi)) {
                outside.push_back(q);
            }
        }
    }
    return outside;
}

void EvaluatedSceneEnvironment::add_preimage(const std::function<Real(const Real&)>& argument,
                                             const Real& critical, const Real& lo, const Real& hi,
                                             std::vector<Real>& cuts) {
    const Real length = hi - lo;
    const Real at_lo = argument(Real(lo + length / 3)) - critical;
    const Real at_hi = argument(Real(lo + length / 2)) - critical;
    if (at_lo == at_hi) {
        return;
    }
    // Linear arguments (the usual case in formulas of a contact) are solved exactly.
    const Real slope = (at_hi - at_lo) / (length / 6);
    const Real third = argument(Real(lo + length * 2 / 3)) - critical;
    const Real predicted = at_hi + slope * (length / 6);
    const Real scale = abs(at_lo) + abs(at_hi) + abs(third);
    if (abs(third - predicted) < scale * pow(Real(10), -static_cast<int>(working_digits() / 2))) {
        cuts.push_back(Real(lo + length / 3 - at_lo / slope));
        return;
    }
    // For other arguments, find a sign change between the ends by bisection.
    Real x = lo + length * pow(Real(10), -20);
    Real y = hi - length * pow(Real(10), -20);
    const bool rising = argument(y) > critical;
    if ((argument(x) > critical) == rising) {
        return;
    }
    for (unsigned k = 0; k < 4 * working_digits(); ++k) {
        const Real middle = (x + y) / 2;
        ((argument(middle) > critical) == rising ? y : x) = middle;
    }
    cuts.push_back(y);
}

void EvaluatedSceneEnvironment::collect_cuts(const Expr& f, const std::string& variable,
                                             const Real& lo, const Real& hi, const At& at,
                                             std::vector<Real>& cuts) const {
    if (f.is_binder()) {
        return; // the variable of an inner integral is different inside
    }
    for (const Expr& part : f.args()) {
        collect_cuts(part, variable, lo, hi, at, cuts);
    }
    const auto add = [&](const Expr& argument, const std::vector<Real>& criticals) {
        if (!holds_symbol(argument, variable)) {
            return;
        }
        try {
            for (const Real& critical : criticals) {
                add_preimage([&](const Real& s) { return at(argument, s); }, critical, lo, hi,
                             cuts);
            }
        } catch (const DomainError&) {
            // Undefined between the ends: the evaluation of the integrand will throw.
            return;
        }
    };
    if (f.kind() == Expr::Kind::call && f.builtin() == formula::Builtin::none) {
        const bool local = f.name() == "right_local" || f.name() == "left_local";
        if (!local) {
            add(f.arg(0), state_.critical_arguments(f.name()));
        }
    } else if (f.builtin() == formula::Builtin::abs || f.builtin() == formula::Builtin::sgn ||
               f.builtin() == formula::Builtin::step) {
        add(f.arg(0), {Real(0)});
    } else if ((f.builtin() == formula::Builtin::max || f.builtin() == formula::Builtin::min) &&
               f.args().size() == 2) {
        add(f.arg(0) - f.arg(1), {Real(0)});
    }
}

Real EvaluatedSceneState::of_fields(const std::function<Ball(const BodyFields&)>& quantity) {
    if (enclosed_fields.empty() && spec.slips()) {
        require_partial_slip(spec);
    }
    const long needed = formula::bits_for(precision.integrand());
    std::optional<Ball> best;
    for (long bits = 2 * needed; bits <= 16 * needed; bits *= 2) {
        const auto [it, fresh] = enclosed_fields.try_emplace(bits);
        try {
            if (fresh) {
                const auto number = [&](const char* name) {
                    return formula::ball_of(spec.parameter(name), bits);
                };
                const bool sheared =
                    spec.parameters.contains("Q") || spec.parameters.contains("sig0");
                it->second = std::make_unique<BodyFields>(
                    spec,
                    sheared ? std::optional(contact::ShearLoad<Ball>{number("Q"), number("sig0")})
                            : std::nullopt,
                    spec.slips() ? std::optional(number("friction")) : std::nullopt, bits);
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
                          " bits do not enclose the stress or the slip");
    }
    return at_working_precision(best->midpoint());
}

Real EvaluatedSceneState::of_body(const std::string& function, std::span<const Real> args,
                                  const Place* place) {
    if (function != "slip" && args[1] < 0) {
        throw DomainError("a stress at a negative depth");
    }
    return of_fields([&](const BodyFields& f) {
        const long bits = f.contact().bits();
        Ball x(args[0], bits);
        if (place != nullptr && at_working_precision(place->x) == args[0]) {
            const Ball u(place->u, bits);
            x = place->edge == Edge::right ? f.contact().a() - u : u - f.contact().b();
        }
        return function == "slip" ? f.slip(x) : f.stress(function, x, Ball(args[1], bits));
    });
}

Real EvaluatedSceneState::gap(const Real& x) const {
    if (!contact::BallContact::has_closed_form(profile)) {
        throw Error("'gap' of a curved slope has no enclosure");
    }
    const long bits = 2 * formula::bits_for(precision.integrand());
    const contact::BallContact enclosed(profile, spec.parameter("Es"),
                                        contact::Load::right_edge(spec.parameter("a")), bits);
    return at_working_precision(gap_at(enclosed, spec.axisymmetric, Ball(x, bits)).midpoint());
}

Real EvaluatedSceneState::traction(const Place& at) {
    if (!spec.slips()) {
        return full_stick_traction(point_at(top().extent, at.edge, at.u), shear_load());
    }
    return of_slip([&](const contact::ProvedSlip& s) {
        return s.traction(at.edge, Ball(at.u, s.slip().zones().bits()));
    });
}

} // namespace edgeproof::audit
