// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/route/exact_values.hpp"

#include "edgeproof/contact/law/shear.hpp"
#include "edgeproof/scene/route/plan.hpp"

namespace edgeproof::scene {

ExactValues::ExactValues(const Scene& scene, const contact::Profile& profile, const Ball& a,
                         const Ball& b, std::size_t terms)
    : scene_(scene), contact_(profile, scene.contact_modulus, scene.load, a, b), terms_(terms) {}

formula::ExactNumber ExactValues::x(contact::Edge edge, const formula::ExactNumber& u) const {
    return edge == contact::Edge::right ? a() - u : u - b();
}

formula::ExactNumber ExactValues::p(contact::Edge edge, const formula::ExactNumber& u) const {
    return contact_.pressure(edge, u);
}

formula::ExactNumber ExactValues::peak() const {
    return peaks_in_the_middle(scene_) ? p(contact::Edge::right, a())
                                       : formula::ExactNumber::unknown();
}

formula::ExactNumber ExactValues::q(contact::Edge edge, const formula::ExactNumber& u) const {
    const formula::ExactNumber Q = formula::ExactNumber::of(scene_.shear->Q.expr());
    if (scene_.slips()) {
        return formula::ExactNumber::unknown();
    }
    if (together()) {
        return Q / force() * p(edge, u);
    }
    const formula::ExactNumber tension =
        formula::ExactNumber::of(scene_.shear->bulk_tension.expr());
    const formula::ExactNumber other = length() - u;
    const formula::ExactNumber across = edge == contact::Edge::right ? other - u : u - other;
    return (Q / formula::ExactNumber::pi() + tension * across / 8) / sqrt(u * other);
}

const std::vector<formula::ExactNumber>& ExactValues::c(contact::Edge edge, std::size_t terms) {
    auto& c = c_[edge];
    if (c.size() < terms) {
        c = contact_.expansion(edge, terms);
    }
    return c;
}

const std::vector<formula::ExactNumber>& ExactValues::s(contact::Edge edge, std::size_t terms) {
    auto& s = s_[edge];
    if (s.size() >= terms) {
        return s;
    }
    s.clear();
    const formula::ExactNumber Q = formula::ExactNumber::of(scene_.shear->Q.expr());
    if (together()) {
        const formula::ExactNumber ratio = Q / force();
        for (const formula::ExactNumber& x : c(edge, terms)) {
            s.push_back(ratio * x);
        }
        return s;
    }
    if (!length().known()) {
        s.assign(terms, formula::ExactNumber::unknown());
        return s;
    }
    s = full_stick_expansion(length(),
                             contact::ShearLoad<formula::ExactNumber>{
                                 Q, formula::ExactNumber::of(scene_.shear->bulk_tension.expr())},
                             edge, terms);
    return s;
}

formula::ExactNumber ExactValues::sum(contact::Edge edge, const formula::ExactNumber& u,
                                      std::size_t n, bool shear) {
    const std::vector<formula::ExactNumber>& terms = shear ? s(edge, n) : c(edge, n);
    formula::ExactNumber total = terms[n - 1];
    for (std::size_t k = n - 1; k-- > 0;) {
        total = total * u + terms[k];
    }
    return shear && !together() ? total / sqrt(u) : total * sqrt(u);
}

formula::ExactNumber ExactValues::error(contact::Edge edge, const formula::ExactNumber& u,
                                        std::size_t n, bool shear) {
    return formula::ExactNumber(1) - sum(edge, u, n, shear) / (shear ? q(edge, u) : p(edge, u));
}

} // namespace edgeproof::scene
