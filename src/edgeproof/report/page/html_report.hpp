// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/run.hpp"

#include <filesystem>
#include <string>

namespace edgeproof::report {

/// Writes folder/report.html, folder/errata.tex, and folder/figures/*.csv and *.svg (the recomputed
/// figures of the paper, the residual fits, a plot for each refuted coefficient); each file is
/// either complete or absent. Figures are computed and drawn in `threads` threads (0: as many as
/// the machine has) with the same result. `command` is the command named on the page; the date is
/// that of SOURCE_DATE_EPOCH if this is set. Without gnuplot there are no SVGs, and the page
/// reports this. `home` is the final folder of the files if it is not `folder`: the page's links to
/// certificates start there. Throws InputError if the folder is not writable.
void write_html_report(const audit::AuditResult& result, const audit::Ledger& ledger,
                       const std::filesystem::path& folder, int threads = 0,
                       const std::string& command = "", const std::filesystem::path& home = {});

} // namespace edgeproof::report
