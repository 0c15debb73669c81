// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// Reports for the user, and what a program needs to make them: the command line includes this
/// header and edgeproof.hpp.
///   verdict_writers.hpp   an audit as a terminal table, JSON, CSV, Markdown, LaTeX; comparison
///                         with recorded verdicts
///   table.hpp             any table as CSV, JSON, Markdown, LaTeX
///   reference_table.hpp   a recipe's answers, or its questions, as a table; comparison of tables
///   agreement_report.hpp  other programs' answers and the references, as text and as JUnit
///   comparison_report.hpp results of meshes and the exact contact, as text and as JSON
///   html.hpp              an audit as a page, with the paper's figures recomputed
///   figures.hpp           a figure as data, drawn as SVG
///   program_line.hpp      version, commit and libraries, included in every file
///   escape.hpp            text of other authors in each format
#include "edgeproof/certificate/certificate.hpp"
#include "edgeproof/conformance/answers/answers.hpp"
#include "edgeproof/conformance/questions/question.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/io/foreign_text.hpp"
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/io/process.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/io/toml/toml_text.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/report/figures/figures.hpp"
#include "edgeproof/report/figures/scene_figure.hpp"
#include "edgeproof/report/page/html.hpp"
#include "edgeproof/report/tables/agreement_report.hpp"
#include "edgeproof/report/tables/comparison_report.hpp"
#include "edgeproof/report/tables/design_table.hpp"
#include "edgeproof/report/tables/reference_table.hpp"
#include "edgeproof/report/tables/table.hpp"
#include "edgeproof/report/text/percent.hpp"
#include "edgeproof/report/text/program_line.hpp"
#include "edgeproof/report/verdicts/verdict_writers.hpp"
#include "edgeproof/scene/input/readers.hpp"
#include "edgeproof/scene/input/scene_words.hpp"
#include "edgeproof/scene/scene.hpp"
