// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/parts/enclosed_loads.hpp"

namespace edgeproof::audit {

EnclosedLoads::EnclosedLoads(const SceneSpec& scene, std::string first, std::string second,
                             long bits)
    : sample_(Sample{scene, std::nullopt, contact::Edge::right, {}}, bits),
      first_(std::move(first)), second_(std::move(second)),
      first_value_(ball_of(scene.parameter(first_), bits)),
      second_value_(scene.parameter(second_).sign() == 0
                        ? Ball(1, bits)
                        : ball_of(scene.parameter(second_), bits)) {}

Ball EnclosedLoads::with(const Ball& first, const Ball& second, const formula::Expr& e) {
    sample_.set(first_, first);
    sample_.set(second_, second);
    return sample_.evaluate(e);
}

Ball EnclosedLoads::of_first(const formula::Expr& e) {
    return with(first_value_, Ball(0, sample_.bits()), e);
}

Ball EnclosedLoads::of_second(const formula::Expr& e) {
    return with(Ball(0, sample_.bits()), second_value_, e);
}

Ball EnclosedLoads::second_for_zero(const formula::Expr& e) {
    return -(second_value_ * of_first(e) / of_second(e));
}

Ball EnclosedLoads::with_second(const formula::Expr& e, const Ball& second) {
    return with(first_value_, second, e);
}

} // namespace edgeproof::audit
