// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/ledger/verdict.hpp"

namespace edgeproof::audit {

std::string_view name_of(Verdict verdict) {
    switch (verdict) {
    case Verdict::proved:
        return "proved";
    case Verdict::confirmed:
        return "confirmed";
    case Verdict::imprecise:
        return "imprecise";
    case Verdict::refuted:
        return "refuted";
    case Verdict::underspecified:
        return "underspecified";
    case Verdict::undecided:
        return "undecided";
    case Verdict::definition:
        break;
    }
    return "definition";
}

std::optional<Verdict> find_verdict(std::string_view name) {
    for (const Verdict verdict : all_verdicts) {
        if (name_of(verdict) == name) {
            return verdict;
        }
    }
    return std::nullopt;
}

} // namespace edgeproof::audit
