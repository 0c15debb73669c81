// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/sample/linear_loads.hpp"

#include "edgeproof/precision/error.hpp"

namespace edgeproof::audit {
namespace {

SceneSpec without(SceneSpec scene, const std::string& load) {
    scene.parameters.insert_or_assign(load, formula::Exact());
    return scene;
}

/// Returns the scene with a second load that is not zero.
SceneSpec loaded(SceneSpec scene, const std::string& first, const std::string& second) {
    static_cast<void>(scene.parameter(first));
    if (scene.parameter(second).sign() == 0) {
        scene.parameters.insert_or_assign(second, formula::Exact::of(Rational(1)));
    }
    return scene;
}

} // namespace

LinearLoads::LinearLoads(const SceneSpec& scene, unsigned digits, const std::string& first,
                         const std::string& second)
    : digits_(digits), second_(second), both_(loaded(scene, first, second), digits),
      only_first_(without(both_.spec(), second), digits),
      only_second_(without(both_.spec(), first), digits), second_value_(both_.parameter(second)) {}

LinearLoads::Parts LinearLoads::parts(const formula::Expr& e) const {
    const Parts p{only_first_.evaluate(e).value, only_second_.evaluate(e).value};
    const Real whole = both_.evaluate(e).value;
    const PrecisionScope scope(digits_ + 20);
    const Real off = abs(Real(whole - p.first - p.second));
    if (off > (abs(p.first) + abs(p.second)) * pow(Real(10), -static_cast<int>(digits_))) {
        throw DomainError(to_text(e) + " is not the sum of its values under each load alone");
    }
    return p;
}

Real LinearLoads::second_for_zero(const formula::Expr& e) const {
    const Parts p = parts(e);
    if (p.second == 0) {
        throw DomainError(second_ + " has no effect on " + to_text(e));
    }
    const PrecisionScope scope(digits_ + 20);
    return Real(-second_value_ * p.first / p.second);
}

Real LinearLoads::evaluate(const formula::Expr& e, const Real& second) const {
    return both_.evaluate(e, nullptr, {{second_, second}}).value;
}

} // namespace edgeproof::audit
