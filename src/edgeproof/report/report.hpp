// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
/// Reports for the user.
///   verdict_writers.hpp   an audit as a terminal table, JSON, CSV, Markdown, LaTeX; comparison
///                         with recorded verdicts
///   table.hpp             any table as CSV, JSON, Markdown, LaTeX
///   reference_table.hpp   a recipe's answers, or its questions, as a table; comparison of tables
///   agreement_report.hpp  other programs' answers and the references, as text and as JUnit
///   html.hpp              an audit as a page, with the paper's figures recomputed
///   figures.hpp           a figure as data, drawn as SVG
///   program_line.hpp      version, commit and libraries, included in every file
///   escape.hpp            text of other authors in each format
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/report/figures/figures.hpp"
#include "edgeproof/report/page/html.hpp"
#include "edgeproof/report/tables/agreement_report.hpp"
#include "edgeproof/report/tables/reference_table.hpp"
#include "edgeproof/report/tables/table.hpp"
#include "edgeproof/report/text/program_line.hpp"
#include "edgeproof/report/verdicts/verdict_writers.hpp"
