// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/ball_shear.hpp"
#include "edgeproof/contact/tilt/ball_tilt.hpp"
#include "edgeproof/formula/exact/exact_ball.hpp"
#include "edgeproof/scene/plan.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace edgeproof::scene {

/// A scene's contact at one number of bits: what the route in balls goes up from level to level.
class BallLevel {
public:
    /// `edges`: both, where they are known already.
    BallLevel(const Scene& scene, const Plan& plan, const std::optional<contact::ExactEdges>& edges,
              long bits)
        : scene_(scene), plan_(plan), bits_(bits) {
        if (scene.punch) {
            tilt_ = enclose_tilt(*scene.punch, scene.contact_modulus, scene.load.value,
                                 *scene.moment, bits);
            if (tilt_->exactly_zero) {
                closed_.emplace(tilt_->near, scene.contact_modulus, scene.load, bits);
            } else {
                closed_.emplace(tilt_->near, tilt_->alpha, scene.contact_modulus, scene.load, bits);
            }
        } else if (edges && contact::BallContact::has_closed_form(*scene.profile)) {
            closed_.emplace(*scene.profile, scene.contact_modulus, *edges, bits);
        } else if (contact::BallContact::has_closed_form(*scene.profile)) {
            closed_.emplace(*scene.profile, scene.contact_modulus, scene.load, bits);
        } else {
            curved_.emplace(*scene.profile, scene.contact_modulus, scene.load, bits);
        }
    }

    [[nodiscard]] long bits() const { return bits_; }
    [[nodiscard]] const Ball& a() const { return closed_ ? closed_->a() : curved_->a(); }
    [[nodiscard]] const Ball& b() const { return closed_ ? closed_->b() : curved_->b(); }
    [[nodiscard]] const contact::ProvedPressure& proved_pressure() const {
        return closed_ ? static_cast<const contact::ProvedPressure&>(*closed_) : *curved_;
    }
    [[nodiscard]] bool edge_may_be_on_knot() const {
        return closed_ ? closed_->edge_may_be_on_knot() : curved_->edge_may_be_on_knot();
    }
    /// Where it was solved for.
    [[nodiscard]] const contact::EnclosedTilt& tilt() const { return *tilt_; }
    [[nodiscard]] Ball length() const { return a() + b(); }
    /// Where an edge is, if that is given or proved by exact algebra.
    [[nodiscard]] std::optional<formula::Exact> known(contact::Edge edge) const {
        return closed_ ? closed_->known(edge) : curved_->known(edge);
    }
    [[nodiscard]] Ball force() const { return closed_ ? closed_->force() : curved_->force(); }
    [[nodiscard]] Ball moment() const { return closed_ ? closed_->moment() : curved_->moment(); }
    /// The last one asked for is kept where it has several uses.
    [[nodiscard]] const Ball& p(contact::Edge edge, const formula::Exact& u) {
        if (plan_.terms == 0 && !scene_.shear) {
            used_once_ = closed_ ? closed_->pressure(edge, u) : curved_->pressure(edge, u);
            return used_once_;
        }
        if (!last_ || last_->edge != edge || !(last_->u == u)) {
            last_ =
                Last{edge, u, closed_ ? closed_->pressure(edge, u) : curved_->pressure(edge, u)};
        }
        return last_->p;
    }
    [[nodiscard]] Ball q(contact::Edge edge, const formula::Exact& u) {
        return together() ? shear_ratio() * p(edge, u)
                          : full_stick_traction(length(), load(), edge, ball_of(u, bits_));
    }
    [[nodiscard]] const std::vector<Ball>& c(contact::Edge edge) {
        auto& c = c_[edge];
        if (c.empty()) {
            c = closed_ ? closed_->expansion(edge, plan_.terms)
                        : curved_->expansion(edge, plan_.terms);
        }
        return c;
    }
    [[nodiscard]] const std::vector<Ball>& s(contact::Edge edge) {
        auto& s = s_[edge];
        if (s.empty() && together()) {
            for (const Ball& x : c(edge)) {
                s.push_back(shear_ratio() * x);
            }
        } else if (s.empty()) {
            s = full_stick_expansion(length(), load(), edge, plan_.terms);
        }
        return s;
    }
    /// The sum of n terms of p, or of q.
    [[nodiscard]] Ball sum(contact::Edge edge, const formula::Exact& u, std::size_t n, bool shear) {
        const std::vector<Ball>& terms = shear ? s(edge) : c(edge);
        const Ball at = ball_of(u, bits_);
        Ball total = terms[n - 1];
        for (std::size_t k = n - 1; k-- > 0;) {
            total = total * at + terms[k];
        }
        return shear && !together() ? total / sqrt(at) : total * sqrt(at);
    }

private:
    struct Last {
        contact::Edge edge;
        formula::Exact u;
        Ball p;
    };
    [[nodiscard]] bool together() const {
        return scene_.shear->path == contact::LoadingPath::together;
    }
    [[nodiscard]] contact::BallShearLoad load() const {
        return {ball_of(scene_.shear->Q, bits_), ball_of(scene_.shear->bulk_tension, bits_)};
    }
    [[nodiscard]] const Ball& shear_ratio() {
        if (!ratio_) {
            ratio_ = ball_of(scene_.shear->Q, bits_) / force();
        }
        return *ratio_;
    }

    const Scene& scene_;
    const Plan& plan_;
    long bits_;
    std::optional<contact::EnclosedTilt> tilt_;
    std::optional<contact::BallContact> closed_;
    std::optional<contact::IntegratedContact> curved_; ///< of g' that has no closed form
    std::optional<Last> last_;
    Ball used_once_;
    std::optional<Ball> ratio_;
    std::map<contact::Edge, std::vector<Ball>> c_;
    std::map<contact::Edge, std::vector<Ball>> s_;
};

} // namespace edgeproof::scene
