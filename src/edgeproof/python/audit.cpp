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
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;
using namespace py::literals;

namespace edgeproof::python {
namespace {

constexpr long least_digits = 10;
constexpr long most_digits_of_claims = 10'000;
constexpr long most_threads = 1024;

struct Verified {
    std::string source;
    std::string json;
    std::string counts;
    std::optional<std::vector<std::string>> differences; ///< nothing if none are recorded
};

Verified verified(const std::string& file, const audit::AuditOptions& options) {
    const audit::Ledger ledger = audit::read_ledger(file);
    audit::AuditResult result = audit::run_audit(ledger, options);
    certificate::attach_certificates(
        result, ledger, std::filesystem::path(file).parent_path() / "certificates", "certificates");
    Verified v{result.source, report::verdicts_json(result), report::counts_line(result), {}};
    const std::filesystem::path golden = report::golden_file(file);
    if (report::has_golden_file(file)) {
        v.differences = report::golden_differences(result, golden, options.only);
    }
    return v;
}

py::dict verify(const std::string& ledger, long digits, const std::string& only, long threads,
                py::object callback) {
    require(digits >= least_digits && digits <= most_digits_of_claims,
            "digits = " + std::to_string(digits) + " is out of range",
            "give a number from " + std::to_string(least_digits) + " to " +
                std::to_string(most_digits_of_claims));
    require(threads >= 0 && threads <= most_threads,
            "threads = " + std::to_string(threads) + " is out of range",
            "give a number from 0 (as many as the machine has) to " + std::to_string(most_threads));
    audit::AuditOptions options;
    options.digits = static_cast<unsigned>(digits);
    options.threads = static_cast<int>(threads);
    options.only = only;
    const Verified v = with_progress(std::move(callback), [&](Progress& progress) {
        options.progress = std::ref(progress);
        return verified(ledger, options);
    });
    return py::dict("source"_a = v.source, "json"_a = v.json, "counts"_a = v.counts,
                    "differences"_a = v.differences);
}

} // namespace

void bind_audit(py::module_& module) {
    module.def("verify", &verify, "ledger"_a, "digits"_a, "only"_a, "threads"_a, "progress"_a);
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
    module.def("relations", &relations, "quantities"_a, "degree"_a, "symmetric"_a, "given"_a,
               "free"_a);
}

} // namespace edgeproof::python
