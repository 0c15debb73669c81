// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/exact_values.hpp"

#include "edgeproof/contact/shear.hpp"

namespace edgeproof {

ExactValues::ExactValues(const Scene& scene, const Profile& profile, const Ball& a, const Ball& b)
    : scene_(scene), contact_(profile, scene.contact_modulus, scene.load, a, b) {}

ExactNumber ExactValues::x(Edge edge, const ExactNumber& u) const {
    return edge == Edge::right ? a() - u : u - b();
}

ExactNumber ExactValues::p(Edge edge, const ExactNumber& u) const {
    return contact_.pressure(edge, u);
}

ExactNumber ExactValues::q(Edge edge, const ExactNumber& u) const {
    const ExactNumber Q = ExactNumber::of(scene_.shear->Q.expr());
    if (together()) {
        return Q / force() * p(edge, u);
    }
    const ExactNumber tension = ExactNumber::of(scene_.shear->bulk_tension.expr());
    const ExactNumber other = length() - u;
    const ExactNumber across = edge == Edge::right ? other - u : u - other;
    return (Q / ExactNumber::pi() + tension * across / 8) / sqrt(u * other);
}

const std::vector<ExactNumber>& ExactValues::c(Edge edge, std::size_t terms) {
    auto& c = c_[edge];
    if (c.size() < terms) {
        c = contact_.expansion(edge, terms);
    }
    return c;
}

const std::vector<ExactNumber>& ExactValues::s(Edge edge, std::size_t terms) {
    auto& s = s_[edge];
    if (s.size() >= terms) {
        return s;
    }
    s.clear();
    const ExactNumber Q = ExactNumber::of(scene_.shear->Q.expr());
    if (together()) {
        const ExactNumber ratio = Q / force();
        for (const ExactNumber& x : c(edge, terms)) {
            s.push_back(ratio * x);
        }
        return s;
    }
    if (!length().known()) {
        s.assign(terms, ExactNumber::unknown());
        return s;
    }
    s = full_stick_brackets<ExactNumber>(Q / ExactNumber::pi(),
                                         ExactNumber::of(scene_.shear->bulk_tension.expr()),
                                         length(), edge, terms);
    const ExactNumber root = sqrt(length());
    for (ExactNumber& x : s) {
        x /= root;
    }
    return s;
}

ExactNumber ExactValues::sum(Edge edge, const ExactNumber& u, std::size_t n, bool shear) {
    const std::vector<ExactNumber>& terms = shear ? s(edge, n) : c(edge, n);
    ExactNumber total = terms[n - 1];
    for (std::size_t k = n - 1; k-- > 0;) {
        total = total * u + terms[k];
    }
    return shear && !together() ? total / sqrt(u) : total * sqrt(u);
}

ExactNumber ExactValues::error(Edge edge, const ExactNumber& u, std::size_t n, bool shear) {
    return ExactNumber(1) - sum(edge, u, n, shear) / (shear ? q(edge, u) : p(edge, u));
}

} // namespace edgeproof
