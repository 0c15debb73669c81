// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/enclosure/exact_contact.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace edgeproof::scene {

/// A scene's values in exact arithmetic, if they have an exact form (exact_contact.hpp); otherwise
/// unknown. Keeps a reference to the scene.
class ExactValues {
public:
    /// The profile is the scene's, or that with a tilt known to be zero. The balls enclose the
    /// edges. `terms`: the number of coefficients to compute at once.
    ExactValues(const Scene& scene, const contact::Profile& profile, const Ball& a, const Ball& b,
                std::size_t terms);

    [[nodiscard]] const Scene& scene() const { return scene_; }
    [[nodiscard]] const formula::ExactNumber& a() const { return contact_.a(); }
    [[nodiscard]] const formula::ExactNumber& b() const { return contact_.b(); }
    [[nodiscard]] formula::ExactNumber length() const { return contact_.length(); }
    [[nodiscard]] formula::ExactNumber force() const { return contact_.force(); }
    [[nodiscard]] formula::ExactNumber moment() const { return contact_.moment(); }
    [[nodiscard]] formula::ExactNumber u(const Distance& distance) const {
        return distance.exactly(a(), b());
    }
    /// The greatest pressure, if it is known to be at the origin.
    [[nodiscard]] formula::ExactNumber peak() const;
    [[nodiscard]] formula::ExactNumber x(contact::Edge edge, const formula::ExactNumber& u) const;
    [[nodiscard]] formula::ExactNumber p(contact::Edge edge, const formula::ExactNumber& u) const;
    [[nodiscard]] formula::ExactNumber q(contact::Edge edge, const formula::ExactNumber& u) const;
    /// At least `terms` coefficients of p, or of q.
    [[nodiscard]] const std::vector<formula::ExactNumber>& c(contact::Edge edge, std::size_t terms);
    [[nodiscard]] const std::vector<formula::ExactNumber>& s(contact::Edge edge, std::size_t terms);
    [[nodiscard]] formula::ExactNumber c_k(contact::Edge edge, std::size_t k) {
        return c(edge, std::max(k + 1, terms_)).at(k);
    }
    [[nodiscard]] formula::ExactNumber s_k(contact::Edge edge, std::size_t k) {
        return s(edge, std::max(k + 1, terms_)).at(k);
    }
    /// The sum of n terms of p, or of q.
    [[nodiscard]] formula::ExactNumber sum(contact::Edge edge, const formula::ExactNumber& u,
                                           std::size_t n, bool shear);
    /// 1 - sum/value, with its sign.
    [[nodiscard]] formula::ExactNumber error(contact::Edge edge, const formula::ExactNumber& u,
                                             std::size_t n, bool shear);

private:
    [[nodiscard]] bool together() const {
        return scene_.shear->path == contact::LoadingPath::together;
    }

    const Scene& scene_;
    contact::ExactContact contact_;
    std::size_t terms_;
    std::map<contact::Edge, std::vector<formula::ExactNumber>> c_;
    std::map<contact::Edge, std::vector<formula::ExactNumber>> s_;
};

} // namespace edgeproof::scene
