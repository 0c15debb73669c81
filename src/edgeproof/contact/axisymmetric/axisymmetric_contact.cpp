// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/axisymmetric/axisymmetric_contact.hpp"

#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/enclosure/isolate_zero.hpp"
#include "edgeproof/contact/law/edge_expansion.hpp"
#include "edgeproof/formula/evaluation/complex_taylor.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace edgeproof::contact {
namespace {

constexpr const char* radius_sought = "the radius of the contact";

class AxisymmetricZones : public ZoneSolver {
public:
    explicit AxisymmetricZones(const AxisymmetricContact& contact)
        : ZoneSolver(contact), contact_(contact) {}
    [[nodiscard]] ZoneValues values(const BallZone& zone) const override {
        return {contact_.with_radius(zone.a).force(), Ball(0, bits())};
    }
    [[nodiscard]] ZoneRates rates(const BallZone& zone) const override {
        const Ball rate = contact_.with_radius(zone.a).force_rate();
        return {rate, rate};
    }
    [[nodiscard]] Ball pressure(const BallZone& zone, Edge edge, const Ball& u,
                                const std::optional<Exact>& x) const override {
        const AxisymmetricContact part = contact_.with_radius(zone.a);
        return x ? part.pressure(edge, u, *x) : part.pressure(edge, u);
    }
    [[nodiscard]] BallZone zone(const Ball& force, const Ball& /*tilt*/,
                                const BallZone& near) const override {
        const Ball a = contact_.radius_for(force, near.a);
        return {a, a};
    }
    [[nodiscard]] std::vector<Ball> force_rates(const Ball& a, std::size_t terms) const override {
        return contact_.with_radius(a).force_rates(terms);
    }
    [[nodiscard]] BallZone core() const override {
        return {contact_.minimum_end(), contact_.minimum_end()};
    }
    [[nodiscard]] std::size_t cost() const override { return contact_.cost(); }

private:
    AxisymmetricContact contact_;
};

} // namespace

std::optional<Exact> AxisymmetricContact::not_analytic_at(const Profile& profile) {
    constexpr long bits = 128;
    const auto finite = [&](std::size_t piece, const Ball& v) {
        const Ball apart = up_to(power_of_two(-100, bits));
        const Box near(v + apart, apart);
        AcbPolyValue taylor;
        formula::complex_taylor(taylor, profile.pieces()[piece].slope, near.get(), 2, bits);
        Box curvature(bits);
        acb_poly_get_coeff_acb(curvature.get(), taylor, 1);
        return curvature.is_finite();
    };
    for (std::size_t i = profile.origin(); i < profile.knots().size(); ++i) {
        const Ball v = formula::ball_of(profile.knots()[i], bits);
        if (!finite(i + 1, v) || (i > profile.origin() && !finite(i, v))) {
            return profile.knots()[i];
        }
    }
    return {};
}

AxisymmetricContact::AxisymmetricContact(const Profile& profile, const Exact& contact_modulus,
                                         const Load& load, long bits)
    : ProvedContact(profile, enclosed_constant(contact_modulus, bits), bits),
      linear_(profile.piecewise_linear()) {
    for (std::size_t i = slope_.origin; i < slope_.knots.size(); ++i) {
        const bool first = i == slope_.origin;
        const Ball& v = slope_.knots[i];
        Ball jump(0, bits);
        Ball rate(0, bits);
        if (linear_) {
            jump = first ? slope_.pieces[i + 1].at_origin : slope_.jump(i);
            rate = first ? slope_.rate(i + 1) : -slope_.rate_drop(i);
            if (Field<Ball>::vanishes(jump) && Field<Ball>::vanishes(rate)) {
                continue; // a flat begins at the origin without a bend
            }
        } else if (profile.has_corner(i)) {
            jump = value(i, Box(v), Integrand::slope).real();
            if (!first) {
                jump -= value(i - 1, Box(v), Integrand::slope).real();
            }
        }
        rings_.push_back({v, std::move(jump), std::move(rate), i});
    }
    find_radius(load);
}

void AxisymmetricContact::find_radius(const Load& load) {
    const Ball given = enclosed_constant(load.value, bits_);
    if (load.kind == Load::Kind::right_edge) {
        known_a_ = load.value;
        a_ = given;
        find_knots_on_edges();
    } else if (load.kind == Load::Kind::force) {
        a_ = radius_for(given, Ball(1, bits_));
    } else {
        a_ = isolate_zero([&](const Ball& s) { return given - approach_at(s); },
                          [&](const Ball& s) { return -approach_rate_at(s); }, Ball(1, bits_),
                          radius_sought);
    }
    b_ = a_;
}

Ball AxisymmetricContact::radius_for(const Ball& P, const Ball& start) const {
    return isolate_zero([&](const Ball& s) { return P - force_at(s); },
                        [&](const Ball& s) { return -(modulus_ * s * approach_rate_at(s) * 2); },
                        start, radius_sought);
}

AxisymmetricContact AxisymmetricContact::with_radius(const Ball& a) const {
    AxisymmetricContact c(*this);
    c.move_edges(a, a);
    return c;
}

bool AxisymmetricContact::inside(std::size_t knot) const {
    return !on_edge_[knot] && !certainly_less(a_, abs(slope_.knots[knot]));
}

bool AxisymmetricContact::begins_flat(const Ring& ring) const {
    const SlopePiece& piece = profile_.pieces()[ring.knot + 1];
    return piece.linear && certainly_zero(piece.linear->rate) && !profile_.has_corner(ring.knot);
}

Ball AxisymmetricContact::minimum_end() const {
    const auto rises = std::find_if(rings_.begin(), rings_.end(),
                                    [&](const Ring& ring) { return !begins_flat(ring); });
    return rises == rings_.end() ? Ball(0, bits_) : rises->v;
}

std::unique_ptr<ZoneSolver> axisymmetric_zones(const AxisymmetricContact& contact) {
    return std::make_unique<AxisymmetricZones>(contact);
}

} // namespace edgeproof::contact
