// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/routes/partial_slip.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/scene/route/plan.hpp"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::scene {

/// Digits of a tilt beyond those requested.
inline constexpr unsigned tilt_digits = 20;
/// The number of guard digits of a NormalContact that its coefficients and edges keep.
inline constexpr unsigned kept_digits = 8;

/// A scene's contact in Real at one number of digits: the scene's own, or more if a difference is
/// small. Every value has its estimated error and the name of its route.
class RealLevel {
public:
    /// Keeps references to the scene and the plan. `alpha`: the tilt, if it was solved for.
    RealLevel(const Profile& profile, const std::optional<Exact>& alpha, const Scene& scene,
              const Plan& plan, unsigned digits, Work* work);
    RealLevel(const RealLevel&) = delete; // shear_ refers to contact_
    RealLevel& operator=(const RealLevel&) = delete;

    [[nodiscard]] const contact::NormalContact& contact() const { return contact_; }
    [[nodiscard]] long bits() const { return formula::bits_for(contact_.a().precision()); }

    /// A value that has lost no more than the guard digits.
    [[nodiscard]] BoundedValue sound(const Real& x, const char* route) const;
    [[nodiscard]] BoundedValue a() const;
    [[nodiscard]] BoundedValue b() const;
    /// The distance of an edge from the origin, as it was solved for.
    [[nodiscard]] BoundedValue distance(Edge edge) const;
    [[nodiscard]] BoundedValue force() const;
    [[nodiscard]] BoundedValue approach() const { return given(*scene_.round->approach); }
    /// Only for power laws, whose a is a given number.
    [[nodiscard]] BoundedValue stiffness() const {
        return given(Exact(Expr::number(Rational(2)) * scene_.contact_modulus.expr() *
                           scene_.load.value.expr()));
    }
    [[nodiscard]] BoundedValue moment() const;
    [[nodiscard]] BoundedValue alpha() const;
    [[nodiscard]] BoundedValue p(Edge edge, const Exact& u);
    [[nodiscard]] BoundedValue q(Edge edge, const Exact& u);
    /// The greatest pressure, an estimate: the highest of many places is refined. Throws
    /// DomainError if a corner inside the contact makes the pressure infinite.
    [[nodiscard]] BoundedValue peak();
    /// Throws InputError, with its line, if the contact slides or slips against Q.
    [[nodiscard]] const contact::PartialSlip& slip();
    /// |Q|/(f P).
    [[nodiscard]] BoundedValue load_ratio();
    [[nodiscard]] BoundedValue slip_size(Edge edge);
    template <Edge edge> [[nodiscard]] BoundedValue stick_edge() { return stick_edge(edge); }
    [[nodiscard]] BoundedValue cycle_energy();
    [[nodiscard]] const std::vector<BoundedValue>& c(Edge edge);
    [[nodiscard]] const std::vector<BoundedValue>& s(Edge edge);
    [[nodiscard]] static const Exact& place(const AskedValue& asked) { return *asked.u; }
    /// The sum of n terms of p, or of q.
    [[nodiscard]] BoundedValue sum(Edge edge, const Exact& u, std::size_t n, bool shear);
    /// 1 - sum/value, with its sign.
    [[nodiscard]] BoundedValue relative_error(Edge edge, const Exact& u, std::size_t n, bool shear);

private:
    /// The values at the last two points, kept for other quantities and approximations there: a
    /// place that depends on the edges is evaluated at both ends of its error interval.
    struct Last {
        Edge edge;
        Exact u;
        std::optional<contact::Estimated> p = {};
        std::optional<contact::EstimatedTraction> q = {};
    };
    [[nodiscard]] Last& at(Edge edge, const Exact& u);
    [[nodiscard]] const contact::Estimated& pressure(Edge edge, const Exact& u);
    [[nodiscard]] BoundedValue stick_edge(Edge edge);
    /// A value that the scene gives.
    [[nodiscard]] BoundedValue given(const Exact& x) const;
    [[nodiscard]] Route route() const;
    [[nodiscard]] Real unit() const;
    [[nodiscard]] std::string series_name() const;

    const Scene& scene_;
    const Plan& plan_;
    unsigned digits_;
    std::optional<Exact> alpha_;
    contact::NormalContact contact_;
    std::optional<contact::ShearTraction> shear_;
    std::optional<contact::NormalContact> uncounted_; ///< its work is not counted here
    std::optional<contact::PartialSlip> slip_;
    std::array<std::optional<Last>, 2> last_; ///< the latest first
    std::map<Edge, std::vector<Real>> raw_c_;
    std::map<Edge, std::vector<BoundedValue>> c_;
    std::map<Edge, std::vector<BoundedValue>> s_;
};

} // namespace edgeproof::scene
