// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/enclosure/exact_contact.hpp"
#include "edgeproof/contact/law/shear.hpp"
#include "edgeproof/scene/input/scene_file.hpp"
#include "edgeproof/scene/route/plan.hpp"
#include "edgeproof/scene/route/rows.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

namespace edgeproof::scene {

/// A scene's values in exact algebra. Members throw NoExactForm, or an Error of the algebra, where
/// a value has no exact form (exact_contact.hpp). Keeps a reference to the scene.
class ExactValues {
public:
    using Number = Form;

    /// The profile is the scene's, or that with a tilt known to be zero. The balls enclose the
    /// edges. `terms`: the number of coefficients to compute at once.
    ExactValues(const Scene& scene, const Profile& profile, const Ball& a, const Ball& b,
                std::size_t terms)
        : scene_(scene), contact_(profile, scene.contact_modulus, scene.load, a, b), terms_(terms) {
    }

    [[nodiscard]] const Number& a() const { return contact_.a(); }
    [[nodiscard]] const Number& b() const { return contact_.b(); }
    [[nodiscard]] Number length() const { return contact_.length(); }
    [[nodiscard]] Number force() const { return contact_.force(); }
    [[nodiscard]] Number whole_force() const {
        return scene_.round ? contact::exact_form(scene_.round->force->expr()) : force();
    }
    [[nodiscard]] Number approach() const {
        return contact::exact_form(scene_.round->approach->expr());
    }
    [[nodiscard]] Number stiffness() const {
        return contact::exact_form(scene_.contact_modulus.expr()) * a() * Number(2);
    }
    [[nodiscard]] Number moment() const { return contact_.moment(); }
    /// The distance of a place from its edge.
    [[nodiscard]] Number place(const AskedValue& asked) const {
        return asked.distance().exactly(
            [&](std::string_view edge) { return edge == "a" ? a() : b(); });
    }
    /// The greatest pressure, if it is known to be at the origin.
    [[nodiscard]] Number peak() const {
        return peaks_in_the_middle(scene_) ? p(Edge::right, a()) : throw contact::NoExactForm();
    }
    [[nodiscard]] Number x(Edge edge, const Number& u) const {
        return edge == Edge::right ? a() - u : u - b();
    }
    [[nodiscard]] Number p(Edge edge, const Number& u) const { return contact_.pressure(edge, u); }
    [[nodiscard]] Number q(Edge edge, const Number& u) const {
        return scene_.slips()          ? throw contact::NoExactForm()
               : scene_.proportional() ? ratio() * p(edge, u)
                                       : full_stick_traction(length(), load(), edge, u);
    }
    /// c_k of p, or s_k of q.
    [[nodiscard]] Number coefficient(Edge edge, std::size_t k, bool shear) {
        return terms(edge, std::max(k + 1, terms_), shear).at(k);
    }
    /// The sum of n terms of p, or of q.
    [[nodiscard]] Number sum(Edge edge, const Number& u, std::size_t n, bool shear) {
        return sum_of_terms(terms(edge, n, shear), n, u, shear && !scene_.proportional());
    }
    /// 1 - sum/value, with its sign.
    [[nodiscard]] Number relative_error(Edge edge, const Number& u, std::size_t n, bool shear) {
        return Number(1) - sum(edge, u, n, shear) / (shear ? q(edge, u) : p(edge, u));
    }

private:
    /// At least n coefficients of p, or of q.
    [[nodiscard]] const std::vector<Number>& terms(Edge edge, std::size_t n, bool shear) {
        std::vector<Number>& known = known_terms_[{edge, shear}];
        if (known.size() >= n) {
            return known;
        }
        if (!shear) {
            known = contact_.expansion(edge, n);
        } else if (scene_.proportional()) {
            known = terms(edge, n, false);
            const Number factor = ratio();
            for (Number& x : known) {
                x = factor * x;
            }
        } else {
            known = full_stick_expansion(length(), load(), edge, n);
        }
        return known;
    }
    [[nodiscard]] Number ratio() const {
        return scene_.shear->ratio([](const Exact& x) { return contact::exact_form(x.expr()); },
                                   [&] { return force(); });
    }
    [[nodiscard]] contact::ShearLoad<Number> load() const {
        return {contact::exact_form(scene_.shear->Q.expr()),
                contact::exact_form(scene_.shear->bulk_tension.expr())};
    }

    const Scene& scene_;
    contact::AlgebraicContact contact_;
    std::size_t terms_;
    std::map<std::pair<Edge, bool>, std::vector<Number>> known_terms_;
};

} // namespace edgeproof::scene
