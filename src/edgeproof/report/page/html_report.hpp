// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/run.hpp"

#include <filesystem>
#include <string>

namespace edgeproof::report {

/// Writes folder/report.html, folder/errata.tex, and folder/figures/*.csv and *.svg (the paper's
/// figures made anew, the residual fits, a plot for each refuted coefficient), each file whole or
/// not at all. Figures are computed and drawn in `threads` threads (0: as many as the machine has);
/// what is written does not depend on it. `command` is what the page says it was made by; the date
/// is that of SOURCE_DATE_EPOCH where this is set. Without gnuplot there are no SVGs, and the page
/// says so. `home` is the folder that the files will be in, if not `folder`: the page's links to
/// certificates start there. Throws InputError where nothing can be written.
void write_html_report(const audit::AuditResult& result, const audit::Ledger& ledger,
                       const std::filesystem::path& folder, int threads = 0,
                       const std::string& command = "", const std::filesystem::path& home = {});

} // namespace edgeproof::report
