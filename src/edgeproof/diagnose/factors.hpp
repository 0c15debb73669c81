// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/real.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::diagnose {

/// A factor of values with a cause: 2, pi, units of other systems, -1, ...
struct NamedFactor {
    Real value;
    std::string words; ///< "2 times ", "sqrt(2 pi) times ", "minus "
    const char* hint;
    const char* name;
    bool common; ///< more likely than a mistake in the data of a scene
};
[[nodiscard]] std::vector<NamedFactor> named_factors();
/// True if a quantity ("p", "c_k", ...) may be wrong by the factor of this name.
[[nodiscard]] inline bool is_possible(std::string_view factor, std::string_view quantity) {
    return factor != "mean-for-peak" || quantity == "p" || quantity == "c_k";
}

struct NearFactor {
    NamedFactor factor;
    double rest; ///< the greatest relative error that it leaves
};
/// Returns the named factors k near numbers of `least` to `most` times the right ones: the rest,
/// which has another cause, is at most a tenth, and a quarter of the error |k - 1| or |1/k - 1|,
/// and k is not further from the interval than this is wide (unless they are a constant). If the
/// nearest is just within these limits, those that are nearly as near are added, too: the numbers
/// do not distinguish them.
[[nodiscard]] std::vector<NearFactor> near_factors(double least, double most);

} // namespace edgeproof::diagnose
