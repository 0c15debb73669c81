// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/axisymmetric/axisymmetric_contact.hpp"
#include "edgeproof/contact/curved/curved_slope.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/stress/cauchy_integral.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/route/ball_level.hpp"

#include <cstddef>
#include <utility>

namespace edgeproof::scene {

namespace {

/// The compliances of a body in plane strain (1/stress).
struct Compliances {
    Ball along;  ///< (1 - nu^2)/E
    Ball across; ///< (1 + nu)(1 - 2 nu)/E
};

Compliances compliances_of(const Scene& scene, Body body, long bits) {
    const Ball nu = ball_of(*scene.poisson(body), bits);
    const Ball along =
        scene.bodies ? (1 - nu) * (1 + nu) /
                           ball_of(body == Body::A ? scene.bodies->E1 : scene.bodies->E2, bits)
                     : 1 / (ball_of(scene.contact_modulus, bits) * 2); // equal bodies
    return {along, along * (1 - nu * 2) / (1 - nu)};
}

} // namespace

const contact::TractionParts* BallLevel::traction_parts() {
    if (!traction_parts_ && slip() != nullptr && slip()->admissible()) {
        traction_parts_.emplace(*slip(), plane(), tilt_ ? tilt_->near : *scene_.profile,
                                scene_.contact_modulus, scene_.shear->bulk_tension.sign() != 0);
    }
    return traction_parts_ ? &*traction_parts_ : nullptr;
}

// docs/stress.md, "The Cauchy integrals of q"
contact::CauchyIntegral BallLevel::of_shear(const contact::CauchyIntegral& p,
                                            const std::optional<Exact>& known, const Box& zeta) {
    return of_shear_by(
        p, {Box(bits_), Box(bits_)},
        [&](const auto& e, const auto& load) { return cauchy_integral(e, load, zeta); },
        [&](const auto& parts) { return parts.integral(p, zeta, known); });
}

contact::SurfacePotential BallLevel::of_shear(const contact::SurfacePotential& p,
                                              const std::optional<Exact>& known, const Ball& x) {
    return of_shear_by(
        p, p * Ball(0, bits_),
        [&](const auto& e, const auto& load) { return surface_potential(e, load, x); },
        [&](const auto& parts) { return parts.potential(p, x, known); });
}

Ball BallLevel::bulk_stress(Body body) const {
    Ball bulk(0, bits_);
    if (scene_.shear) {
        bulk = ball_of(scene_.shear->bulk_A, bits_);
        if (body == Body::B) {
            bulk += ball_of(scene_.shear->bulk_tension, bits_);
        }
    }
    return bulk;
}

std::optional<contact::StressField> BallLevel::stress_field(Body body) {
    contact::StressField field{
        .parts = {{std::dynamic_pointer_cast<const contact::PlaneContact>(contact_), Ball(1, bits_),
                   Ball(0, bits_)}},
        .bulk = bulk_stress(body)};
    field.mirrored = scene_.symmetric();
    if (!scene_.slips() && !scene_.proportional()) {
        return field;
    }
    field.mirrored = false;
    const bool no_tension = scene_.shear->bulk_tension.sign() == 0;
    const bool no_bulk = no_tension && scene_.shear->bulk_A.sign() == 0;
    field.surface_mirrored = scene_.symmetric() && no_bulk;
    field.untilted =
        no_bulk && (!scene_.history || scene_.history->layers.front().ratio.sign() == 0);
    const Ball side(body == Body::A ? 1 : -1, bits_); // B carries -q
    if (!scene_.slips()) {
        field.parts.front().shear = shear_ratio() * side;
        return field;
    }
    const contact::TractionParts* const parts = traction_parts();
    if (parts == nullptr) {
        return {};
    }
    field.parts.front().shear = parts->whole_ratio * side;
    for (const auto& [zone, ratio] : parts->parts) {
        field.parts.push_back({zone, Ball(0, bits_), ratio * side});
    }
    return field;
}

const contact::StressState& BallLevel::stress(const AskedValue& at) {
    const BodyPoint& point = *at.in_body;
    if (last_stress_ && last_stress_->first == point) {
        return last_stress_->second;
    }
    const Ball x = point.x.enclosure(a(), b(), bits_);
    const Ball z = point.z.enclosure(a(), b(), bits_);
    require(!certainly_negative(z), "the depth z = " + point.z.text() + " is negative",
            "give z >= 0, the depth into the body");
    if (scene_.round) {
        const contact::AxisymmetricStress field = axisymmetric_stress(point.body);
        const bool left = certainly_negative(x);
        const Ball r = abs(x);
        const std::optional<Exact>& there = point.x.number();
        contact::StressState state =
            point.x.is_zero() ? field.on_axis(z)
            : point.z.is_zero()
                ? field.on_surface(r, left && there ? std::optional(Exact(-there->expr())) : there)
                : field.inside(r, z);
        if (left) {
            state.sxz = -state.sxz;
        }
        last_stress_.emplace(point, std::move(state));
        return last_stress_->second;
    }
    const Box zeta(x, z);
    contact::CauchyIntegral p = plane().cauchy_integral(zeta, point.x.number());
    contact::CauchyIntegral q = of_shear(p, point.x.number(), zeta);
    const bool tension = scene_.shear && scene_.shear->bulk_tension.sign() != 0;
    if (point.x.is_zero() && scene_.symmetric() && !tension) {
        // P(-conj(zeta)) = -conj(P(zeta)), and the same for T: exact zeros on the axis of symmetry
        for (contact::CauchyIntegral* const f : {&p, &q}) {
            f->value = Box(Ball(0, bits_), f->value.imaginary());
            f->derivative = Box(f->derivative.real(), Ball(0, bits_));
        }
    }
    if (point.body == Body::B) { // it carries -q
        q = q * Ball(-1, bits_);
    }
    last_stress_.emplace(point, stress_of(p, q, zeta, bulk_stress(point.body)));
    return last_stress_->second;
}

contact::AxisymmetricStress BallLevel::axisymmetric_stress(Body body) const {
    return {*contact_, whole_force(), ball_of(*scene_.poisson(body), bits_)};
}

Ball BallLevel::gap(const AskedValue& at) {
    const Ball x = at.place->x_enclosure(a(), b(), bits_);
    const Ball right = x - a();
    const Ball left = -x - b();
    if (certainly_negative(right) && certainly_negative(left)) {
        throw DomainError("the place lies inside the contact");
    }
    const Edge edge = certainly_negative(right) ? Edge::left : Edge::right;
    const Ball& off = edge == Edge::right ? right : left;
    if (contains_zero(off)) { // the gap is 0 at the edge and grows from there
        return Ball::hull(Ball(0, bits_), gap_beyond(x, edge, Ball(off.upper(), bits_)));
    }
    return gap_beyond(x, edge, off);
}

Ball BallLevel::gap_beyond(const Ball& x, Edge edge, const Ball& beyond) const {
    const Ball right = scene_.round ? abs(x) : max(x, a());
    const Ball left = scene_.round ? abs(x) : max(-x, b());
    require(scene_.closed() || monotonicity_of_slope(*scene_.profile, right, left).kind ==
                                   contact::SlopeMonotonicity::Kind::rises,
            "g' is not proved not to decrease up to the place, so that the gap is not computed",
            "give a place nearer to the contact");
    if (!scene_.round) {
        return plane().gap_beyond(edge, beyond);
    }
    const BallContact* const form = contact_->closed_form();
    return form != nullptr ? axisymmetric_gap(*form, beyond) : of_revolution().gap_beyond(beyond);
}

const std::vector<BallLevel::SlipSince>* BallLevel::slip_since_contact() {
    if (!slip_since_ && slip() != nullptr) {
        const auto zone_of = [this](const Exact& force) {
            return zones_->zone(ball_of(force, bits_), Ball(0, bits_), {a(), b()});
        };
        std::vector<SlipSince> list;
        try {
            for (const LoadHistory::Entry& entry : scene_.history->entries) {
                list.push_back({zone_of(entry.force), {}});
                if (!entry.change) {
                    continue;
                }
                auto& parts = list.back().parts.emplace();
                for (std::size_t j = 0; j + 1 < entry.change->size(); ++j) {
                    const LoadHistory::Layer& layer = (*entry.change)[j];
                    const contact::BallZone zone = zone_of(layer.force);
                    parts.push_back({plane().zone(zone.a, zone.b),
                                     ball_of(layer.ratio, bits_) -
                                         ball_of((*entry.change)[j + 1].ratio, bits_)});
                }
            }
        } catch (const BudgetError&) {
            return nullptr;
        }
        slip_since_ = std::move(list);
    }
    return slip_since_ ? &*slip_since_ : nullptr;
}

// docs/histories.md, "The slip"
Ball BallLevel::slip_after_history(const Ball& x) {
    const auto* const entries = slip_since_contact();
    for (std::size_t i = 0; entries != nullptr && i < entries->size(); ++i) {
        const auto& [zone, parts] = (*entries)[i];
        const Ball right = x - zone.a;
        const Ball left = -x - zone.b;
        const bool last = i + 1 == entries->size();
        if (last || (certainly_negative(right) && certainly_negative(left))) {
            if (!parts) {
                throw InputError("the place came into contact while the edges slipped, so that its "
                                 "slip since then is not computed",
                                 "ask for places that were in contact before P and Q grew");
            }
            Ball sum(0, bits_);
            for (const auto& [contact, ratio] : *parts) {
                sum += ratio * contact->gap_at(x);
            }
            return sum;
        }
        if (!certainly_positive(right) && !certainly_positive(left)) {
            break; // too few bits to decide when the place came into contact
        }
    }
    return not_known();
}

// docs/stress.md, "The slip": -f times the gap of the corrective contact, in the direction of Q.
Ball BallLevel::slip_displacement(const AskedValue& at) {
    const Ball x = at.place->x_enclosure(a(), b(), bits_);
    if (certainly_positive(x - a()) || certainly_positive(-x - b())) {
        throw DomainError("the place lies outside the contact");
    }
    require(!scene_.slides(), "the whole contact slides, so that its slip is not bounded",
            "give places outside the contact, or a reference, for ux and uz");
    if (!scene_.slips()) {
        return {0, bits_};
    }
    if (scene_.round) {
        return round_slip(abs(x));
    }
    if (scene_.history) {
        return slip_after_history(x);
    }
    const contact::TractionParts* const parts = traction_parts();
    return parts == nullptr ? not_known()
                            : parts->parts.front().ratio * parts->parts.front().zone->gap_at(x);
}

// docs/axisymmetric.md, "The slip"
Ball BallLevel::round_slip(const Ball& r) {
    if (!scene_.poisson(Body::A) || scene_.history) {
        throw InputError(scene_.history
                             ? "the slip displacement of an axisymmetric contact after a "
                               "load history is not computed"
                             : "the slip displacement of an axisymmetric contact needs "
                               "Poisson's ratio",
                         std::string(scene_.history ? "" : "add nu to [load], or ") +
                             "give places outside the contact, |x| > a");
    }
    if (slip() == nullptr || !slip()->admissible()) {
        return not_known();
    }
    const contact::ShearPart& part = slip()->parts().front();
    const Ball beyond = r - part.zone.a;
    if (certainly_negative(beyond)) {
        return {0, bits_};
    }
    const BallContact* const form = contact_->closed_form();
    return part.ratio * tangential_ratio() *
           (form != nullptr
                ? axisymmetric_gap(form->between(part.zone.a, part.zone.b),
                                   contact::clamped(beyond))
                : of_revolution().with_radius(part.zone.a).gap_beyond(contact::clamped(beyond)));
}

std::optional<Ball> BallLevel::power_of_growth() const {
    using Kind = Profile::Kind;
    const Kind kind = scene_.profile->kind();
    if (kind == Kind::tilted_wedge) {
        return Ball(1, bits_);
    }
    return kind == Kind::power_law
               ? std::optional(ball_of(scene_.profile->parameters().at("m"), bits_) + 1)
               : std::nullopt;
}

// docs/histories.md, "The energy"
contact::GrowthIntegral BallLevel::growth(const ProvedContact& widest) const {
    if (const auto power = power_of_growth()) {
        return contact::similar_growth(*power);
    }
    if (const BallContact* const form = widest.closed_form()) {
        return growth_of(*form);
    }
    // Only its integrals of g' are used, and not its radius.
    const auto body = std::make_shared<const contact::AxisymmetricContact>(
        *scene_.profile, scene_.contact_modulus, Load::right_edge(Exact::of(1)), bits_);
    return [body](const contact::PhaseWeight& weight, const contact::SlipPhase::Cut& from,
                  const contact::SlipPhase::Cut& to) {
        return body->over_plane_widths(from.zone.a, to.zone.a,
                                       [&](const Box& L) { return weight(L); });
    };
}

Ball BallLevel::energy_of(const std::vector<LoadHistory::Phase>& phases) const {
    const Ball friction = ball_of(*scene_.shear->friction, bits_);
    std::optional<Exact> most; // of the forces: P may have been greater
    for (const LoadHistory::Phase& phase : phases) {
        const Exact& force = phase.cuts.back();
        most = most && Exact(force.expr() - most->expr()).sign() <= 0 ? most : force;
    }
    if (!most) {
        return {0, bits_};
    }
    // The energies of a power law or a wedge need no zones.
    std::unique_ptr<ProvedContact> widest;
    std::unique_ptr<contact::ZoneSolver> zones;
    if (!power_of_growth()) {
        widest = contact::proved_contact(*scene_.profile, scene_.contact_modulus,
                                         Load::force(*most), bits_);
        zones = zone_solver(*widest, *scene_.profile, scene_.contact_modulus, false);
    }
    std::vector<contact::SlipPhase> list;
    for (const LoadHistory::Phase& phase : phases) {
        const auto number = [&](const Exact& x) { return ball_of(x, bits_); };
        list.push_back({number(phase.inner_from),
                        number(phase.inner_to),
                        number(phase.force_from),
                        number(phase.force_to),
                        number(phase.change),
                        {}});
        for (const Exact& cut : phase.cuts) {
            const Ball force = number(cut);
            list.back().cuts.push_back(
                {force, zones ? zones->zone(force, Ball(0, bits_), {widest->a(), widest->b()})
                              : contact::BallZone{a(), b()}});
        }
    }
    return dissipated_energy(contact_->modulus(), friction, list,
                             growth(widest ? *widest : *contact_));
}

// docs/axisymmetric.md, "The energy of a cycle"
Ball BallLevel::tangential_ratio() const {
    const auto number = [&](const Exact& x) { return ball_of(x, bits_); };
    if (scene_.bodies) {
        const auto compliance = [&](const Exact& E, const Exact& nu) {
            return (2 - number(nu)) * (1 + number(nu)) / (number(E) * 2);
        };
        const Bodies& bodies = *scene_.bodies;
        return (compliance(bodies.E1, bodies.nu1) + compliance(bodies.E2, bodies.nu2)) *
               contact_->modulus();
    }
    const Ball nu = number(*scene_.nu);
    return (2 - nu) / ((1 - nu) * 2);
}

Ball BallLevel::cycle_energy(const BallSlip& slip) const {
    if (!scene_.round) {
        return scene_.history ? energy_of(*scene_.history->pass)
                              : contact::cycle_energy(slip, growth(*contact_));
    }
    const Ball factor = slip.friction() * slip.friction() * tangential_ratio() * 8;
    if (!scene_.round->law) {
        return factor * of_revolution().loop_integral(slip.stick().a, slip.load_ratio());
    }
    const Ball m = ball_of(Exact(scene_.round->law->m), bits_);
    const Ball power = (m + 2) / (m + 1); // P is proportional to delta^power
    const Ball tau = slip.load_ratio();
    const Ball left = pow(1 - tau, 1 / power);
    return factor * whole_force() * approach() *
           ((1 - tau / 2) * (1 - left) - (1 - (1 - tau) * left) / (power + 1));
}

// docs/stress.md, "The displacements"
BallLevel::Potentials BallLevel::potentials(const AskedValue& at) {
    const auto place = [&](const Distance& distance) {
        return distance.x_enclosure(a(), b(), bits_);
    };
    const Ball x = place(*at.place);
    const Ball from = place(*at.reference);
    const auto known = known_x(Edge::right, *at.place);
    const auto known_from = known_x(Edge::right, *at.reference);
    const contact::SurfacePotential p = plane().surface_potential(x, known);
    const contact::SurfacePotential p_from = plane().surface_potential(from, known_from);
    const Ball side(at.in_body->body == Body::A ? 1 : -1, bits_); // B carries -q
    return {p - p_from, (of_shear(p, known, x) - of_shear(p_from, known_from, from)) * side,
            x - from};
}

// johnson1985, eqs. 2.25a and 2.25b, integrated; the bulk stress strains the surface evenly.
Ball BallLevel::ux(const AskedValue& at) {
    const Potentials of = potentials(at);
    const Compliances body = compliances_of(scene_, at.in_body->body, bits_);
    return body.across * of.p.carried - body.along * of.q.lift * 2 / Ball::pi(bits_) +
           body.along * bulk_stress(at.in_body->body) * of.distance;
}

Ball BallLevel::uz(const AskedValue& at) {
    const Potentials of = potentials(at);
    const Compliances body = compliances_of(scene_, at.in_body->body, bits_);
    return -(body.along * of.p.lift * 2 / Ball::pi(bits_)) - body.across * of.q.carried;
}

Ball BallLevel::surface_slope(const AskedValue& at) {
    const Box zeta(at.place->x_enclosure(a(), b(), bits_), Ball(0, bits_));
    const std::optional<Exact> x = known_x(Edge::right, *at.place);
    const contact::CauchyIntegral p = plane().cauchy_integral(zeta, x);
    const contact::CauchyIntegral q = of_shear(p, x, zeta);
    const Compliances body = compliances_of(scene_, at.in_body->body, bits_);
    const Ball side(at.in_body->body == Body::A ? 1 : -1, bits_);
    return -(body.along * p.value.real() * 2 + side * body.across * q.value.imaginary()) /
           Ball::pi(bits_);
}

// docs/partial-slip.md, "The energy of a cycle": 4 f p times the slip.
Ball BallLevel::dissipation(const AskedValue& at) {
    const Ball slipped = abs(slip_displacement(at));
    const Box zeta(at.place->x_enclosure(a(), b(), bits_), Ball(0, bits_));
    const contact::CauchyIntegral p =
        plane().cauchy_integral(zeta, known_x(Edge::right, *at.place));
    return -(ball_of(*scene_.shear->friction, bits_) * p.value.imaginary() * slipped) * 4 /
           Ball::pi(bits_);
}

} // namespace edgeproof::scene
