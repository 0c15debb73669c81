// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/exact_contact.hpp"
#include "edgeproof/scene/scene_file.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace edgeproof {

/// A scene's values in exact arithmetic, as far as they have an exact form (exact_contact.hpp);
/// unknown ones otherwise. Keeps a reference to the scene.
class ExactValues {
public:
    /// The profile is the scene's, or that of a tilt which is known to be zero. The balls enclose
    /// the edges.
    ExactValues(const Scene& scene, const Profile& profile, const Ball& a, const Ball& b);

    [[nodiscard]] const ExactNumber& a() const { return contact_.a(); }
    [[nodiscard]] const ExactNumber& b() const { return contact_.b(); }
    [[nodiscard]] ExactNumber length() const { return contact_.length(); }
    [[nodiscard]] ExactNumber force() const { return contact_.force(); }
    [[nodiscard]] ExactNumber moment() const { return contact_.moment(); }
    [[nodiscard]] ExactNumber x(Edge edge, const ExactNumber& u) const;
    [[nodiscard]] ExactNumber p(Edge edge, const ExactNumber& u) const;
    [[nodiscard]] ExactNumber q(Edge edge, const ExactNumber& u) const;
    /// So many coefficients of p, or of q, at least.
    [[nodiscard]] const std::vector<ExactNumber>& c(Edge edge, std::size_t terms);
    [[nodiscard]] const std::vector<ExactNumber>& s(Edge edge, std::size_t terms);
    /// The sum of n terms of p, or of q.
    [[nodiscard]] ExactNumber sum(Edge edge, const ExactNumber& u, std::size_t n, bool shear);
    /// 1 - sum/value, with its sign.
    [[nodiscard]] ExactNumber error(Edge edge, const ExactNumber& u, std::size_t n, bool shear);

private:
    [[nodiscard]] bool together() const { return scene_.shear->path == LoadingPath::together; }

    const Scene& scene_;
    ExactContact contact_;
    std::map<Edge, std::vector<ExactNumber>> c_;
    std::map<Edge, std::vector<ExactNumber>> s_;
};

} // namespace edgeproof
