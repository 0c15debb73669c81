// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/report/figures/figures.hpp"
#include "edgeproof/report/tables/agreement_report.hpp"
#include "edgeproof/scene/design/design_file.hpp"

/// The option --figure of `check` and `design`.
namespace edgeproof::report {

/// The correct digits of p and q against u, with the digits that the rounding of the inputs to
/// double precision allows. Columns: u, p, q (if there is any), inputs. Throws InputError without a
/// point to draw.
[[nodiscard]] Plot agreement_plot(const Conformance& result);

/// The reach against the one parameter, with marks at the best and at the printed value. The line
/// is broken where the reach jumps. Columns: the parameter, reach, best, printed.
[[nodiscard]] Plot design_plot(const scene::DesignScene& design, const scene::DesignResult& result);

} // namespace edgeproof::report
