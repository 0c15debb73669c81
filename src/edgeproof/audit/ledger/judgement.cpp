// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/ledger/judgement.hpp"

namespace edgeproof::audit {

std::optional<Difference> Difference::of(const Ball& claimed, const Ball& found) {
    if (!claimed.is_finite() || !found.is_finite() || !disjoint(claimed, found)) {
        return std::nullopt;
    }
    return Difference();
}

std::optional<Difference> Difference::of(const Real& claimed, const Real& found,
                                         const Real& error) {
    if (!isfinite(claimed) || !isfinite(found) || !isfinite(error) ||
        !(abs(claimed - found) > error)) {
        return std::nullopt;
    }
    return Difference();
}

std::optional<Difference> Difference::not_above(const Real& bound, const Real& found) {
    if (!isfinite(bound) || !isfinite(found) || found > bound) {
        return std::nullopt;
    }
    return Difference();
}

std::optional<Difference> Difference::not_above(const Float128& bound, const Float128& found) {
    if (bound - bound != 0 || found - found != 0 || found > bound) {
        return std::nullopt;
    }
    return Difference();
}

Judgement::Judgement(NotRefuted verdict) {
    switch (verdict) {
    case NotRefuted::proved:
        verdict_ = Verdict::proved;
        break;
    case NotRefuted::confirmed:
        verdict_ = Verdict::confirmed;
        break;
    case NotRefuted::imprecise:
        verdict_ = Verdict::imprecise;
        break;
    case NotRefuted::underspecified:
        verdict_ = Verdict::underspecified;
        break;
    case NotRefuted::undecided:
        verdict_ = Verdict::undecided;
        break;
    case NotRefuted::definition:
        verdict_ = Verdict::definition;
        break;
    }
}

} // namespace edgeproof::audit
