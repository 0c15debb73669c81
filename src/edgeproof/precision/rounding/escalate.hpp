// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <string>

namespace edgeproof {

/// A budget counted in bits, never in seconds, and so the same on every machine.
struct BitBudget {
    long first = 128;
    long last = 1L << 20;
};

/// Calls look(bits) with doubled precision until it returns true. Returns an empty text then, or
/// the reason why it did not: an Error that more bits do not remove ends the search.
template <class Look>
[[nodiscard]] std::string look_closer(const Look& look, const BitBudget& budget) {
    std::string problem = "the enclosures are too wide to decide";
    for (long bits = budget.first; bits <= budget.last; bits *= 2) {
        check_interruption();
        try {
            if (look(bits)) {
                return {};
            }
        } catch (const BudgetError& error) {
            problem = error.what();
        } catch (const InputError&) {
            throw;
        } catch (const Error& error) {
            return error.what();
        }
    }
    return problem;
}

/// Calls f(bits) -> Ball with doubled precision until `enough(ball)` is true. Throws BudgetError
/// with the accuracy reached if the budget does not suffice.
template <class F, class Enough>
[[nodiscard]] Ball escalate(const F& f, const Enough& enough, const BitBudget& budget = {}) {
    for (long bits = budget.first;; bits *= 2) {
        check_interruption();
        Ball value = f(bits);
        if (enough(value)) {
            return value;
        }
        if (bits > budget.last / 2) {
            throw BudgetError("the enclosure is still too wide at " + std::to_string(bits) +
                              " bits: " + std::to_string(value.relative_accuracy_bits()) +
                              " bits are certain");
        }
    }
}

} // namespace edgeproof
