// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/axisymmetric/axisymmetric_contact.hpp"
#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/contact/curved/proved_slip.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/interval_maximum.hpp"
#include "edgeproof/contact/law/shear.hpp"
#include "edgeproof/contact/stress/axisymmetric_stress.hpp"
#include "edgeproof/contact/stress/cauchy_integral.hpp"
#include "edgeproof/contact/stress/dissipation.hpp"
#include "edgeproof/contact/stress/plane_stress.hpp"
#include "edgeproof/contact/tilt/tilt_solver.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/ball/magnitude.hpp"
#include "edgeproof/scene/route/plan.hpp"
#include "edgeproof/scene/route/rows.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace edgeproof::scene {

using contact::BallContact;
using contact::BallSlip;
using contact::ProvedContact;

/// A power series in u whose coefficients are enclosed, with |c_k| <= most/radius^k for all k.
struct BoundedSeries {
    std::function<std::vector<Ball>(std::size_t)> coefficients; ///< the first n coefficients
    Ball most;
    Ball radius;
};

/// Returns the sum of c_k u^k over all k >= n, without a difference of nearly equal numbers: enough
/// terms for the bits of u, and a bound of the others. The result is not finite unless u is less
/// than a 16th of the radius.
[[nodiscard]] inline Ball omitted_terms(const BoundedSeries& series, std::size_t n, const Ball& u) {
    const long bits = u.bits();
    const Ball part = u / series.radius;
    const Ball limit(Rational(1, 16), bits);
    if (!series.most.is_finite() || !part.is_finite() || !certainly_less(abs(part), limit)) {
        return contact::unknown_ball(bits);
    }
    // Each term is at most a 16th of the term before.
    const std::size_t smallness = static_cast<std::size_t>(
        std::max<slong>(4, -arf_abs_bound_lt_2exp_si(arb_midref(part.data()))));
    const std::size_t count = n + static_cast<std::size_t>(bits) / smallness + 2;
    const std::vector<Ball> c = series.coefficients(count);
    Ball sum =
        Magnitude(series.most * pow_int(part, static_cast<long>(count)) / (1 - part)).ball(bits);
    for (std::size_t k = count; k-- > n;) {
        sum += c[k] * pow_int(u, static_cast<long>(k));
    }
    return sum;
}

/// The shear load on a body under full stick; nothing in a scene without one.
[[nodiscard]] inline std::optional<contact::ShearLoad<Ball>> full_stick_load(const Scene& scene,
                                                                             Body body, long bits) {
    if (!scene.shear || scene.slips() || scene.proportional() ||
        (scene.shear->Q.sign() == 0 && scene.shear->bulk_tension.sign() == 0)) {
        return {};
    }
    const Ball side(body == Body::A ? 1 : -1, bits); // B carries -q
    return contact::ShearLoad<Ball>{side * ball_of(scene.shear->Q, bits),
                                    side * ball_of(scene.shear->bulk_tension, bits)};
}

/// A scene's contact at one number of bits; the route in balls uses levels of more and more bits.
class BallLevel {
public:
    /// `terms`: the length of expansions; `edges`: both edges, if they are known already.
    BallLevel(const Scene& scene, long bits, std::size_t terms = 0,
              const std::optional<contact::ExactEdges>& edges = {})
        : scene_(scene), bits_(bits), terms_(terms) {
        if (scene.punch) {
            tilt_ = enclose_tilt(*scene.punch, scene.contact_modulus, scene.load.value,
                                 *scene.moment, bits);
            contact_ =
                tilt_->exactly_zero
                    ? std::make_shared<const BallContact>(tilt_->near, scene.contact_modulus,
                                                          scene.load, bits)
                    : std::make_shared<const BallContact>(tilt_->near, tilt_->alpha,
                                                          scene.contact_modulus, scene.load, bits);
        } else if (edges && scene.profile->has_closed_form()) {
            contact_ = std::make_shared<const BallContact>(*scene.profile, scene.contact_modulus,
                                                           *edges, bits);
        } else {
            contact_ =
                contact::proved_contact(*scene.profile, scene.contact_modulus, scene.load, bits);
        }
    }

    [[nodiscard]] long bits() const { return bits_; }
    [[nodiscard]] const ProvedContact& contact() const { return *contact_; }
    [[nodiscard]] const Ball& a() const { return contact_->a(); }
    [[nodiscard]] const Ball& b() const { return contact_->b(); }
    /// The tilt of a scene in which it is solved for.
    [[nodiscard]] const contact::EnclosedTilt& tilt() const { return *tilt_; }
    [[nodiscard]] Ball length() const { return a() + b(); }
    [[nodiscard]] Ball force() const { return contact_->force(); }
    /// P as it is printed: of an axisymmetric contact the total force.
    [[nodiscard]] Ball whole_force() const {
        return scene_.round && scene_.round->force ? ball_of(*scene_.round->force, bits_) : force();
    }
    /// delta of an axisymmetric contact.
    [[nodiscard]] Ball approach() const {
        return scene_.round->approach ? ball_of(*scene_.round->approach, bits_)
                                      : of_revolution().approach();
    }
    /// dP/d delta of an axisymmetric contact (docs/axisymmetric.md, "Contact stiffness").
    [[nodiscard]] Ball stiffness() const { return contact_->modulus() * a() * 2; }
    [[nodiscard]] Ball moment() const { return contact_->moment(); }
    /// Keeps the last value if it is used more than once.
    [[nodiscard]] Ball p(Edge edge, const Distance& u) {
        if (terms_ == 0 && !scene_.shear) {
            return pressure(edge, u);
        }
        if (!last_ || last_->edge != edge || !(last_->u == u)) {
            last_ = Last{edge, u, pressure(edge, u)};
        }
        return last_->p;
    }
    [[nodiscard]] Ball q(Edge edge, const Distance& u) {
        if (scene_.slips()) {
            const BallSlip* s = slip();
            return s != nullptr ? s->traction(edge, distance(u), p(edge, u), known_x(edge, u))
                                : not_known();
        }
        return scene_.proportional() ? shear_ratio() * p(edge, u)
                                     : full_stick_traction(length(), load(), edge, distance(u));
    }
    [[nodiscard]] static Distance place(const AskedValue& asked) { return asked.distance(); }
    [[nodiscard]] Ball distance(const Distance& u) const { return u.enclosure(a(), b(), bits_); }
    /// The coordinate x of a point.
    [[nodiscard]] Ball x(Edge edge, const Distance& u) const {
        if (!u.number()) {
            return u.x_enclosure(a(), b(), bits_);
        }
        return edge == Edge::right ? a() - distance(u) : distance(u) - b();
    }
    /// The coordinate x of a point, if it is known exactly.
    [[nodiscard]] std::optional<Exact> known_x(Edge edge, const Distance& u) const;
    /// Throws DomainError if a corner inside the contact makes the pressure infinite.
    [[nodiscard]] Ball peak() const {
        for (const Ball& corner : contact().corners(Edge::right)) {
            refuse_infinite_peak(Ball(a() - corner).midpoint());
        }
        if (peaks_in_the_middle(scene_)) {
            const BallContact* const closed = contact_->closed_form();
            if (closed->piecewise_linear()) { // m = 1
                return closed->pressure(Edge::right, a());
            }
            return closed->pressure_factor() / ball_of(scene_.profile->parameters().at("m"), bits_);
        }
        const bool middle =
            !scene_.closed() && scene_.symmetric() && greatest_in_the_middle(*scene_.profile, a());
        require(middle || !scene_.curved_body() || greater_off_axis(),
                "the greatest pressure of a curved slope of revolution is proved only where p "
                "increases from the axis, or where g'' does not increase too fast",
                "ask for pressures at points");
        try {
            return middle ? contact_->pressure(Edge::right, a(), Exact())
                          : enclosed_peak(contact(), scene_.symmetric());
        } catch (const BudgetError&) {
            return not_known();
        }
    }
    [[nodiscard]] const std::vector<Ball>& c(Edge edge) {
        auto& c = c_[edge];
        if (c.empty()) {
            c = contact_->expansion(edge, terms_);
        }
        return c;
    }
    [[nodiscard]] const std::vector<Ball>& s(Edge edge) {
        auto& s = s_[edge];
        if (s.empty() && scene_.proportional()) {
            for (const Ball& x : c(edge)) {
                s.push_back(shear_ratio() * x);
            }
        } else if (s.empty()) {
            s = full_stick_expansion(length(), load(), edge, terms_);
        }
        return s;
    }
    /// Null if these bits do not isolate the stick zone.
    [[nodiscard]] const BallSlip* slip() {
        if (!std::exchange(slip_tried_, true)) {
            make_slip({});
            if (!slip_) {
                if (const auto stick = exact_stick()) {
                    make_slip(stick);
                }
            }
        }
        return slip_ ? &*slip_ : nullptr;
    }
    [[nodiscard]] Ball slip_size(Edge edge) {
        return of_slip([&](const BallSlip& slip) { return slip.size(edge); });
    }
    /// A value of the slip; not finite if these bits do not suffice.
    template <class F> [[nodiscard]] Ball of_slip(const F& f) {
        try {
            return slip() != nullptr ? Ball(f(*slip())) : not_known();
        } catch (const BudgetError&) {
            return not_known();
        }
    }
    /// The bulk tension with which the stick zone reaches an edge of the contact: the edge towards
    /// which Q acts, if `ahead` is the right one, or the other one.
    [[nodiscard]] Ball tension_limit(const BallSlip& slip, Edge ahead) const {
        return slip.tension_limit(scene_.shear->Q.sign() > 0 ? ahead : opposite(ahead));
    }
    /// Only for scenes whose tilt is given.
    [[nodiscard]] Ball cycle_energy(const BallSlip& slip) const;
    /// The energy of the last step of a load history.
    [[nodiscard]] Ball step_energy() const { return energy_of(scene_.history->step); }
    /// kappa_1, ..., at an edge; balls that are not finite if there is no slip zone.
    [[nodiscard]] const std::vector<Ball>& slip_series(Edge edge, std::size_t terms);
    [[nodiscard]] Ball not_known() const { return contact::unknown_ball(bits_); }
    /// 1 - (the sum of n terms)/p, or the same for q. If that cancels completely, the error is
    /// computed from the omitted terms.
    [[nodiscard]] Ball relative_error(Edge edge, const Distance& u, std::size_t n, bool shear);
    // Values at a point of a body, and at a place x of the surface (ball_fields.cpp).
    /// Keeps the last value.
    [[nodiscard]] const contact::StressState& stress(const AskedValue& at);
    [[nodiscard]] Ball poisson(const AskedValue& at) const {
        return ball_of(*scene_.poisson(at.in_body->body), bits_);
    }
    /// The load on a body, for shear that is not under full stick. Nothing if these bits do not
    /// isolate the stick zone.
    [[nodiscard]] std::optional<contact::StressField> stress_field(Body body);
    /// The stresses of an axisymmetric scene without shear. It refers to this level.
    [[nodiscard]] contact::AxisymmetricStress axisymmetric_stress(Body body) const;
    /// Throws DomainError inside the contact.
    [[nodiscard]] Ball gap(const AskedValue& at);
    // Values at a place of the surface of a body (ball_fields.cpp).
    [[nodiscard]] Ball ux(const AskedValue& at);
    [[nodiscard]] Ball uz(const AskedValue& at);
    [[nodiscard]] Ball surface_slope(const AskedValue& at);
    /// Throws DomainError outside the contact.
    [[nodiscard]] Ball dissipation(const AskedValue& at);
    /// u_A - u_B since the place came into contact. Throws DomainError outside the contact.
    [[nodiscard]] Ball slip_displacement(const AskedValue& at);
    /// The sum of n terms of p, or of q.
    [[nodiscard]] Ball sum(Edge edge, const Distance& u, std::size_t n, bool shear) {
        return sum_of_terms(shear ? s(edge) : c(edge), n, distance(u), singular(shear));
    }

private:
    /// True if p is found to be greater at a place than on the axis. (A search for its maximum
    /// would not end at the axis, where p has no series.)
    [[nodiscard]] bool greater_off_axis() const;
    /// The gap at the distance `beyond` > 0 outwards from an edge; x: the same place.
    [[nodiscard]] Ball gap_beyond(const Ball& x, Edge edge, const Ball& beyond) const;
    /// E*/E_t of an axisymmetric scene with a Poisson's ratio.
    [[nodiscard]] Ball tangential_ratio() const;
    /// The slip at the radius r in the contact of an axisymmetric scene with friction.
    [[nodiscard]] Ball round_slip(const Ball& r);
    /// The exponent in L ~ D^power of the contacts of a wedge or a power law under all forces L;
    /// nothing for other profiles.
    [[nodiscard]] std::optional<Ball> power_of_growth() const;
    /// The integral over the contacts of the scene's profile up to `widest`, for energies. It
    /// refers to `widest`.
    [[nodiscard]] contact::GrowthIntegral growth(const ProvedContact& widest) const;
    /// The energy of phases of a load history.
    [[nodiscard]] Ball energy_of(const std::vector<LoadHistory::Phase>& phases) const;
    [[nodiscard]] Ball bulk_stress(Body body) const;
    /// The potentials of p and of q on a body at a place, less those at the reference.
    struct Potentials {
        contact::SurfacePotential p;
        contact::SurfacePotential q;
        Ball distance; ///< of the place from the reference (length)
    };
    [[nodiscard]] Potentials potentials(const AskedValue& at);
    /// The Cauchy integral of q on body A at `zeta`, or the potential of q at x; `p` is that of p,
    /// `known` is x if it is known exactly.
    [[nodiscard]] contact::CauchyIntegral
    of_shear(const contact::CauchyIntegral& p, const std::optional<Exact>& known, const Box& zeta);
    [[nodiscard]] contact::SurfacePotential
    of_shear(const contact::SurfacePotential& p, const std::optional<Exact>& known, const Ball& x);
    /// The same from that of full stick and that of the parts of q.
    template <class T, class FullStick, class Parts>
    [[nodiscard]] T of_shear_by(const T& p, const T& none, const FullStick& stick,
                                const Parts& of_parts) {
        if (!scene_.shear) {
            return none;
        }
        if (scene_.proportional()) {
            return p * shear_ratio();
        }
        if (!scene_.slips()) {
            return stick(contact::Extent<Ball>{a(), b()}, load());
        }
        const contact::TractionParts* const parts = traction_parts();
        return parts == nullptr ? p * not_known() : of_parts(*parts);
    }
    /// The parts of q; null if these bits do not isolate them, or if the contact slides.
    [[nodiscard]] const contact::TractionParts* traction_parts();
    /// The slip of the places inside a zone, and outside that of the entry before, since they came
    /// into contact: the sum of the ratios times the gaps of the contacts. Without parts it is not
    /// computed.
    struct SlipSince {
        contact::BallZone zone;
        std::optional<std::vector<contact::TractionParts::Part>> parts;
    };
    /// The entries of a load history; null if these bits do not isolate their zones.
    [[nodiscard]] const std::vector<SlipSince>* slip_since_contact();
    /// The slip displacement after a load history at the place x in the contact.
    [[nodiscard]] Ball slip_after_history(const Ball& x);
    /// The series of p/sqrt(u) at an edge.
    [[nodiscard]] BoundedSeries p_series(Edge edge) const;
    /// The series of q sqrt(u) under full stick, or of q/sqrt(u) if q is proportional to p. In the
    /// first case q = (Q/pi +- sigma_0 (L - 2u)/8)/sqrt(u (L - u)), and the coefficients of (1 -
    /// u/L)^(-1/2) lie between 0 and 1.
    [[nodiscard]] BoundedSeries q_series(Edge edge);
    [[nodiscard]] const contact::PlaneContact& plane() const {
        return dynamic_cast<const contact::PlaneContact&>(*contact_);
    }
    /// The contact of an axisymmetric scene whose profile is no power law.
    [[nodiscard]] const contact::AxisymmetricContact& of_revolution() const {
        return dynamic_cast<const contact::AxisymmetricContact&>(*contact_);
    }
    void make_slip(const std::optional<contact::BallZone>& stick);
    /// The contact under P - |Q|/f, if that is an exact number: then edges on corners can be
    /// proved, which no number of bits decides.
    [[nodiscard]] std::optional<contact::BallZone> exact_stick() const;
    [[nodiscard]] Ball pressure(Edge edge, const Distance& u) const;
    struct Last {
        Edge edge;
        Distance u;
        Ball p;
    };
    /// True if the first term of the expansion of p, or of q, is infinite at the edge.
    [[nodiscard]] bool singular(bool shear) const { return shear && !scene_.proportional(); }
    [[nodiscard]] contact::ShearLoad<Ball> load() const {
        return {ball_of(scene_.shear->Q, bits_), ball_of(scene_.shear->bulk_tension, bits_)};
    }
    [[nodiscard]] const Ball& shear_ratio() {
        if (!ratio_) {
            ratio_ = scene_.shear->ratio([&](const Exact& x) { return ball_of(x, bits_); },
                                         [&] { return force(); });
        }
        return *ratio_;
    }

    const Scene& scene_;
    long bits_;
    std::size_t terms_;
    std::optional<contact::EnclosedTilt> tilt_;
    std::shared_ptr<const ProvedContact> contact_;
    bool slip_tried_ = false;
    std::unique_ptr<contact::ZoneSolver> zones_;
    std::optional<BallSlip> slip_;
    std::optional<contact::SlipSeries> slip_series_;
    std::optional<Last> last_;
    std::optional<std::pair<BodyPoint, contact::StressState>> last_stress_;
    std::optional<contact::TractionParts> traction_parts_;
    std::optional<std::vector<SlipSince>> slip_since_;
    std::optional<Ball> ratio_;
    std::map<Edge, std::vector<Ball>> c_;
    std::map<Edge, std::vector<Ball>> s_;
};

} // namespace edgeproof::scene
