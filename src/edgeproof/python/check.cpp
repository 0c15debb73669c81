// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/answers/answers.hpp"
#include "edgeproof/conformance/questions/question.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/python/bindings.hpp"
#include "edgeproof/python/without_gil.hpp"
#include "edgeproof/report/tables/agreement_report.hpp"
#include "edgeproof/report/tables/reference_table.hpp"

#include <pybind11/stl.h>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <utility>

namespace py = pybind11;
using namespace py::literals;

namespace edgeproof::python {
namespace {

constexpr std::size_t most_errors_shown = 20;

conformance::Recipe asked_in_binary64(const std::string& file) {
    conformance::Recipe recipe = conformance::read_recipe(file);
    recipe.questions = conformance::rounded_to_binary64(recipe.questions);
    return recipe;
}

report::Table table_of(const std::string& file) {
    const conformance::Recipe recipe = asked_in_binary64(file);
    return report::question_table(recipe.questions, recipe.title);
}

py::list questions(const std::string& recipe) {
    const report::Table table = without_gil([&] { return table_of(recipe); });
    py::list list;
    for (const auto& row : table.rows) {
        py::dict question;
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (!row[i].empty()) {
                question[py::str(table.columns.at(i).name)] = row[i];
            }
        }
        list.append(question);
    }
    return list;
}

conformance::Answers program_answers(const std::string& recipe_file, const std::string& command,
                                     double seconds, Progress& progress) {
    const conformance::Recipe recipe = asked_in_binary64(recipe_file);
    conformance::ProgramDriverOptions options;
    options.command = command;
    options.seconds = seconds;
    options.progress = std::ref(progress);
    options.write_csv = [&](const conformance::Questions& part) {
        return write_table(report::question_table(part, recipe.title), report::TableFormat::csv,
                           {.notes = false});
    };
    return ask_program_in_batches(recipe.questions, options);
}

py::dict case_of(const report::Conformance& c, std::size_t i) {
    const conformance::Question& question = c.answers.questions.list[i];
    const conformance::Answer& answer = c.answers.given[i];
    const conformance::CaseAgreement& held = c.agreements.cases[i];
    using State = conformance::Answer::State;
    static constexpr std::array states{"number", "missing", "nan", "infinite", "garbage", "died"};
    static_assert(states.size() == static_cast<std::size_t>(State::died) + 1);
    return py::dict("id"_a = question.id, "quantity"_a = scene::symbol_of(question),
                    "regime"_a = conformance::regime_name(held.regime), "value"_a = answer.text,
                    "state"_a = states.at(static_cast<std::size_t>(answer.state)),
                    "reference"_a = text_or_none(held.reference), "digits"_a = held.digits,
                    "ulps"_a = held.ulps, "relative"_a = held.relative, "passed"_a = !c.failed(i),
                    "explained"_a = held.explained,
                    "no_reference"_a = text_or_none(held.no_reference));
}

py::dict result_of(const report::Conformance& c) {
    py::list cases;
    for (std::size_t i = 0; i < c.agreements.cases.size(); ++i) {
        cases.append(case_of(c, i));
    }
    py::list conventions;
    for (const conformance::Convention& k : c.conventions) {
        conventions.append(py::dict("of"_a = k.of, "relation"_a = k.relation, "digits"_a = k.digits,
                                    "rows"_a = k.rows, "failing"_a = k.failing, "hint"_a = k.hint,
                                    "also"_a = k.also));
    }
    return py::dict("passed"_a = c.pass(),
                    "text"_a = report::conformance_text(c, most_errors_shown),
                    "faults"_a = c.answers.faults, "cases"_a = cases, "conventions"_a = conventions,
                    "estimates"_a = c.agreements.estimates);
}

/// Checks the text `answers`, called `name` (with or without a recipe), or the program `command`,
/// which answers `recipe`.
py::dict check(const std::optional<std::string>& answers, const std::string& name,
               const std::optional<std::string>& recipe, const std::optional<std::string>& command,
               double seconds, std::optional<double> digits, std::optional<double> ulps,
               bool conditioned, unsigned threads, py::object callback) {
    return result_of(with_progress(std::move(callback), [&](Progress& progress) {
        report::Conformance result;
        result.target = {digits, ulps, conditioned};
        conformance::ReferenceOptions options;
        options.threads = threads;
        options.progress = std::ref(progress);
        if (command) {
            result.answers = program_answers(*recipe, *command, seconds, progress);
        } else {
            const io::Csv csv = io::parse_csv(*answers, name, {.keep_faults = true});
            result.answers =
                recipe ? conformance::answers_to(asked_in_binary64(*recipe).questions, csv)
                       : conformance::echoed_answers(csv);
        }
        result.agreements = compare(result.answers, result.target, options);
        result.conventions = infer_conventions(result.answers, result.agreements, options);
        return result;
    }));
}

} // namespace

void bind_check(py::module_& module) {
    module.def("questions", &questions, "recipe"_a);
    module.def("check", &check, "answers"_a, "name"_a, "recipe"_a, "command"_a, "seconds"_a,
               "digits"_a, "ulps"_a, "conditioned"_a, "threads"_a, "progress"_a);
}

} // namespace edgeproof::python
