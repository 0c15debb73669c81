// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/run.hpp"
#include "edgeproof/certificate/certificate.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/python/bindings.hpp"
#include "edgeproof/python/without_gil.hpp"
#include "edgeproof/report/tables/design_table.hpp"
#include "edgeproof/report/verdicts/verdict_writers.hpp"

#include <pybind11/stl.h>

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace edgeproof::python {
namespace {

constexpr long least_digits = 10;
constexpr long most_digits_of_claims = 10'000;
constexpr long most_threads = 1024;

struct Verified {
    std::string source;
    std::string json;
    std::string counts;
    std::vector<std::string> differences;
    bool recorded = false;
};

Verified verified(const std::string& file, const audit::AuditOptions& options) {
    const audit::Ledger ledger = audit::read_ledger(file);
    audit::AuditResult result = audit::run_audit(ledger, options);
    certificate::attach_certificates(
        result, ledger, std::filesystem::path(file).parent_path() / "certificates", "certificates");
    Verified v{result.source, report::verdicts_json(result), report::counts_line(result), {}};
    const std::filesystem::path golden = report::golden_file(file);
    if (report::has_golden_file(file)) {
        v.recorded = true;
        v.differences = report::golden_differences(result, golden, options.only);
    }
    return v;
}

py::dict verify(const std::string& ledger, long digits, const std::string& only, long threads,
                py::object callback) {
    if (digits < least_digits || digits > most_digits_of_claims) {
        throw InputError("digits = " + std::to_string(digits) + " is out of range",
                         "give a number from " + std::to_string(least_digits) + " to " +
                             std::to_string(most_digits_of_claims));
    }
    if (threads < 0 || threads > most_threads) {
        throw InputError("threads = " + std::to_string(threads) + " is out of range",
                         "give a number from 0 (as many as the machine has) to " +
                             std::to_string(most_threads));
    }
    audit::AuditOptions options;
    options.digits = static_cast<unsigned>(digits);
    options.threads = static_cast<int>(threads);
    options.only = only;
    const Verified v = with_progress(std::move(callback), [&](Progress& progress) {
        options.progress = std::ref(progress);
        return verified(ledger, options);
    });
    py::dict d;
    d["source"] = v.source;
    d["json"] = v.json;
    d["counts"] = v.counts;
    d["differences"] = v.recorded ? py::cast(v.differences) : py::object(py::none());
    return d;
}

} // namespace

void bind_audit(py::module_& module) {
    module.def("verify", &verify, py::arg("ledger"), py::arg("digits"), py::arg("only"),
               py::arg("threads"), py::arg("progress"));
}

namespace {

/// Returns the JSON of `edgeproof relations`.
std::string relations(std::vector<std::string> quantities, long degree, bool symmetric,
                      std::vector<std::pair<std::string, std::string>> given,
                      std::vector<std::string> free) {
    const audit::RelationQuestion question{std::move(quantities), degree, symmetric,
                                           std::move(given), std::move(free)};
    return without_gil([&] {
        return write_table(report::relations_table(question, asked_relations(question)),
                           report::TableFormat::json);
    });
}

} // namespace

void bind_relations(py::module_& module) {
    module.def("relations", &relations, py::arg("quantities"), py::arg("degree"),
               py::arg("symmetric"), py::arg("given"), py::arg("free"));
}

} // namespace edgeproof::python
