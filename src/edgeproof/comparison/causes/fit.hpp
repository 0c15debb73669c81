// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/causes/causes.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace edgeproof::comparison {

inline constexpr double usual_errors = 3; ///< standard errors of the scale of a cause
inline constexpr double most_errors = 5;  ///< of one that is not excluded

/// Values of the data that are diagnosed.
struct Observed {
    UsedNodes nodes;
    std::vector<double> values;
    double element = 0;          ///< the widest at an edge
    std::vector<double> corners; ///< where p is infinite

    /// False at nodes within two elements, or a fiftieth of the suspect's contact, of one of its
    /// edges or of a corner.
    [[nodiscard]] bool counts(const Suspect& suspect, std::size_t i) const;
};

/// The agreement of data with a suspect, and their local noise.
struct Fit {
    double left = 0;        ///< rms of data minus suspect, relative to its largest value
    double noise = 0;       ///< rms scatter of that difference from node to node
    double sign = 1;        ///< of the data: a mistake may make the pressure mainly tensile
    double scale = 1;       ///< the factor of the suspect's values that fits the data best
    double scale_error = 0; ///< its standard error from the local scatter
    double freedom = 0;     ///< degrees of freedom of the scatter
    std::size_t nodes = 0;
    bool largest_counted = false; ///< the largest of all errors is at a node that counts

    /// True if the data agree with the suspect to within their own scatter and the allowance.
    [[nodiscard]] bool is_scatter(double allowance, double standard_errors = usual_errors,
                                  double scatters = 1.6) const;
};

/// Returns nothing if fewer than eight nodes lie inside the suspect's contact.
[[nodiscard]] std::optional<Fit> fit_of(const Observed& data, const Suspect& suspect);

/// True if the data exclude a suspect in favour of another one: the error that the first leaves
/// contains the difference of the two, by more than five standard errors of the noise. Without
/// this, noise of some percent in a few large pressures makes a wrong cause fit better.
[[nodiscard]] bool is_excluded(const Observed& data, const Suspect& suspect, const Suspect& other);

/// The median of data over exact values.
[[nodiscard]] double median_ratio(const Observed& data, const std::vector<double>& right);

/// True if a mistake explains the data: their error without it is `unexplained`.
[[nodiscard]] bool explains(const Fit& fit, double allowance, double unexplained);

/// Recognises data that alternate from node to node, as those at the corners and in the middles of
/// the sides of quadratic elements do. Two conditions must hold: every second node is right, or the
/// means over neighbours are; and the part of the error that changes its sign from node to node
/// (its second difference) has the same sign at nine tenths of the nodes (if every second one is
/// reversed). That part of noise has no constant sign, and that of a wave k elements long changes
/// it after k/(k - 2) nodes.
[[nodiscard]] std::optional<Cause> alternation(const Observed& data, const Suspect& right,
                                               double allowance, double unexplained);

} // namespace edgeproof::comparison
