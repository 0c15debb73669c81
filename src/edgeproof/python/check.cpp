// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/answers/answers.hpp"
#include "edgeproof/conformance/questions/recipe.hpp"
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
    py::dict d;
    d["id"] = question.id;
    d["quantity"] = scene::symbol_of(question);
    d["regime"] = conformance::regime_name(held.regime);
    d["value"] = answer.text;
    d["state"] = states.at(static_cast<std::size_t>(answer.state));
    d["reference"] = text_or_none(held.reference);
    d["digits"] = held.digits;
    d["ulps"] = held.ulps;
    d["relative"] = held.relative;
    d["passed"] = !c.failed(i);
    d["explained"] = held.explained;
    d["no_reference"] = text_or_none(held.no_reference);
    return d;
}

py::dict result_of(const report::Conformance& c) {
    py::dict d;
    d["passed"] = c.pass();
    d["text"] = report::conformance_text(c, most_errors_shown);
    d["faults"] = c.answers.faults;
    py::list cases;
    for (std::size_t i = 0; i < c.agreements.cases.size(); ++i) {
        cases.append(case_of(c, i));
    }
    d["cases"] = cases;
    py::list conventions;
    for (const conformance::Convention& k : c.conventions) {
        py::dict one;
        one["of"] = k.of;
        one["relation"] = k.relation;
        one["digits"] = k.digits;
        one["rows"] = k.rows;
        one["failing"] = k.failing;
        one["hint"] = k.hint;
        one["also"] = k.also;
        conventions.append(one);
    }
    d["conventions"] = conventions;
    d["estimates"] = c.agreements.estimates;
    return d;
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
    module.def("questions", &questions, py::arg("recipe"));
    module.def("check", &check, py::arg("answers"), py::arg("name"), py::arg("recipe"),
               py::arg("command"), py::arg("seconds"), py::arg("digits"), py::arg("ulps"),
               py::arg("conditioned"), py::arg("threads"), py::arg("progress"));
}

} // namespace edgeproof::python
